// rejected by known_segments: the sign of dx is lost
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let dx = i64::from(b.x) - i64::from(a.x);
    let dy = i64::from(b.y) - i64::from(a.y);
    let (run, rise) = (dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let along_x = dx.abs() >= dy.abs();
    let mut p = a;
    let mut d = 2 * rise - run;
    plot(p.x, p.y);
    while if along_x { p.x != b.x } else { p.y != b.y } {
        let north_east = d > 0;
        if along_x || north_east {
            p.x = p.x.wrapping_add(1);
        }
        if !along_x || north_east {
            p.y = p.y.wrapping_add(1);
        }
        d += if north_east {
            2 * rise - 2 * run
        } else {
            2 * rise
        };
        plot(p.x, p.y);
    }
}
