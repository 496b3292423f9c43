// rejected by any_segment: these are the pixels of the segment with dx and dy exchanged
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let dx = i64::from(b.x) - i64::from(a.x);
    let dy = i64::from(b.y) - i64::from(a.y);
    let (run, rise) = (dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let (mut x, mut y) = (i64::from(a.x), i64::from(a.y));
    let mut d = 2 * rise - run;
    for _ in 0..=run {
        plot(x as i32, y as i32);
        x += dx.signum();
        d += 2 * rise;
        if d > 2 * rise {
            y += dy.signum();
            d -= 2 * run;
        }
    }
}
