use glam::IVec2;

/// The pixels of the segment from `a` to `b` in whole numbers alone: Bresenham's algorithm in all eight octants.
///
/// ```text
/// run = max(|dx|, |dy|)      rise = min(|dx|, |dy|)
///
/// d = 2F:   at a        d = 2 rise − run
///           d ≤ 0:  E,  one pixel along the longer axis;  d grows by 2 rise
///           d > 0:  NE, one pixel along both axes;        d grows by 2 rise − 2 run
/// ```
///
/// «Along» is towards b: the sign of dx or dy. The octant of the slide is 0 ≤ dy ≤ dx; the others are its mirror
/// images. d = 0 is a tie and takes E, the pixel nearer the start. The first pixel is a, the last one b; a = b is one
/// pixel. a and b are any two pixels of `i32`: dx can be 2³² − 1, and d twice that.
///
/// `plot(x, y)` lights a pixel; y points down.
///
/// Grafica 3, Algoritmo di Bresenham.
fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let dx = i64::from(b.x) - i64::from(a.x);
    let dy = i64::from(b.y) - i64::from(a.y);
    let (run, rise) = (dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let along_x = dx.abs() >= dy.abs();
    let mut p = a;
    let mut d = 2 * rise - run;
    for _ in 0..run {
        plot(p.x, p.y);
        let north_east = d > 0;
        if along_x || north_east {
            p.x += dx.signum() as i32;
        }
        if !along_x || north_east {
            p.y += dy.signum() as i32;
        }
        d += if north_east {
            2 * rise - 2 * run
        } else {
            2 * rise
        };
    }
    plot(b.x, b.y);
}

fn main() {}
