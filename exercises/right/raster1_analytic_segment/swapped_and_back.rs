// right: one loop, the axes swapped before it and back in `plot`
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let wide = |v: IVec2| (i64::from(v.x), i64::from(v.y));
    let ((ax, ay), (bx, by)) = (wide(a), wide(b));
    let steep = (by - ay).abs() > (bx - ax).abs();
    let (a0, a1, b0, b1) = if steep {
        (ay, ax, by, bx)
    } else {
        (ax, ay, bx, by)
    };
    let m = if a0 == b0 {
        0.0
    } else {
        (b1 - a1) as f64 / (b0 - a0) as f64
    };
    let mut at = a0;
    loop {
        let rise = m * (at - a0) as f64;
        let across = a1
            + if rise < 0.0 {
                (rise + 0.5).floor() as i64
            } else {
                (rise - 0.5).ceil() as i64
            };
        let (x, y) = if steep { (across, at) } else { (at, across) };
        plot(x as i32, y as i32);
        if at == b0 {
            break;
        }
        at += if b0 > a0 { 1 } else { -1 };
    }
}
