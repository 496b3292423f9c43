// rejected by any_segment: one pixel a column leaves gaps
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let dx = i64::from(b.x) - i64::from(a.x);
    let dy = i64::from(b.y) - i64::from(a.y);
    let (run, rise) = (dx.abs(), dy.abs());
    let (mut x, mut y) = (i64::from(a.x), i64::from(a.y));
    let mut d = 2 * rise - run;
    for _ in 0..=run {
        plot(x as i32, y as i32);
        x += dx.signum();
        if d > 0 {
            y += dy.signum();
            d -= 2 * run;
        }
        d += 2 * rise;
    }
}
