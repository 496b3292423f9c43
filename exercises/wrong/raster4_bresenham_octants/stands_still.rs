// rejected by any_segment: still at it after 5 s
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    );
    let (mut x, mut y) = (i64::from(a.x), i64::from(a.y));
    let mut d = 2 * dy.abs() - dx.abs();
    plot(a.x, a.y);
    // Only NE moves and plots: where d ≤ 0 nothing happens, for ever.
    while x != i64::from(b.x) {
        if d > 0 {
            x += dx.signum();
            y += dy.signum();
            d -= 2 * dx.abs() - 2 * dy.abs();
            plot(x as i32, y as i32);
        }
        std::hint::black_box(&mut d);
    }
}
