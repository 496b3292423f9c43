// right: the octants apart, each with its own steps
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    );
    let east = match (dx >= 0, dy >= 0, dx.abs() >= dy.abs()) {
        (true, _, true) => (1, 0),
        (false, _, true) => (-1, 0),
        (_, true, false) => (0, 1),
        (_, false, false) => (0, -1),
    };
    let north_east = (if dx >= 0 { 1 } else { -1 }, if dy >= 0 { 1 } else { -1 });
    let (run, rise) = if dx.abs() >= dy.abs() {
        (dx.abs(), dy.abs())
    } else {
        (dy.abs(), dx.abs())
    };
    let (mut x, mut y, mut d) = (i64::from(a.x), i64::from(a.y), 2 * rise - run);
    plot(a.x, a.y);
    for _ in 0..run {
        let step = if d > 0 { north_east } else { east };
        d += 2 * rise - if d > 0 { 2 * run } else { 0 };
        x += step.0;
        y += step.1;
        plot(x as i32, y as i32);
    }
}
