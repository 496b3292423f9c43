// rejected by all_of_i32: i32 does not hold dx, dy and 2F
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let (run, rise) = (dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let mut p = a;
    let mut d = 2 * rise - run;
    for _ in 0..run {
        plot(p.x, p.y);
        let north_east = d > 0;
        if dx.abs() >= dy.abs() || north_east {
            p.x += dx.signum();
        }
        if dx.abs() < dy.abs() || north_east {
            p.y += dy.signum();
        }
        d += 2 * rise;
        if north_east {
            d -= 2 * run;
        }
    }
    plot(b.x, b.y);
}
