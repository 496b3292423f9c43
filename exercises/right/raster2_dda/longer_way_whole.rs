// right: the longer way in whole numbers, m for the other alone
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let steep = dy.abs() > dx.abs();
    let (long, short) = if steep { (dy, dx) } else { (dx, dy) };
    let m = if long == 0 {
        0.0
    } else {
        short as f64 / long.abs() as f64
    };
    let mut offset = 0.0_f64;
    let mut along = 0;
    loop {
        // Rounded half towards 0.
        let near = offset.abs();
        let near = (near + 0.5).floor() - if near.fract() == 0.5 { 1.0 } else { 0.0 };
        let across = near.copysign(offset) as i32;
        if steep {
            plot(a.x + across, a.y + along as i32);
        } else {
            plot(a.x + along as i32, a.y + across);
        }
        if along == long {
            return;
        }
        along += long.signum();
        offset = add(offset, m);
    }
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0_f32, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
