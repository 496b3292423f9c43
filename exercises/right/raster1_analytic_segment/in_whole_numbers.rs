// right: the formula in whole numbers, rounded by a division
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    );
    let run = dx.abs().max(dy.abs());
    let part = |i: i64, d: i64| {
        if run == 0 {
            return 0;
        }
        d.signum() * ((2 * i * d.abs() + run - 1) / (2 * run))
    };
    for i in 0..=run {
        plot(
            (i64::from(a.x) + part(i, dx)) as i32,
            (i64::from(a.y) + part(i, dy)) as i32,
        );
    }
}
