// right: one error for both axes, as often seen on the web, its ties turned to the start
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    );
    let run = dx.abs().max(dy.abs());
    let (mut x, mut y) = (i64::from(a.x), i64::from(a.y));
    let (mut ex, mut ey) = (0, 0);
    for _ in 0..=run {
        plot(x as i32, y as i32);
        ex += 2 * dx.abs();
        ey += 2 * dy.abs();
        if ex > run {
            x += dx.signum();
            ex -= 2 * run;
        }
        if ey > run {
            y += dy.signum();
            ey -= 2 * run;
        }
    }
}
