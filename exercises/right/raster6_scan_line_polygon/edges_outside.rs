// right: edges outside, rows inside, into an array of the picture
use glam::DVec2;

#[derive(Clone, Copy, Debug, PartialEq)]
enum FillRule {
    EvenOdd,
    NonZero,
}

fn fill(
    polygon: &[DVec2],
    rule: FillRule,
    width: i32,
    height: i32,
    plot: &mut dyn FnMut(i32, i32),
) {
    let (w, h) = (width.max(0) as usize, height.max(0) as usize);
    // What is to be added to the winding number at each column.
    let mut change = vec![0; (w + 1) * h];
    let next = polygon.iter().cycle().skip(1);
    for (a, b) in polygon.iter().zip(next) {
        let (top, end, sign) = if a.y < b.y { (a, b, 1) } else { (b, a, -1) };
        for j in 0..h {
            let y = j as f64 + 0.5;
            if top.y <= y && y < end.y {
                let slope = (end.x - top.x) / (end.y - top.y);
                let x = top.x + slope * (y - top.y);
                let column = (x - 0.5).ceil().max(0.0).min(w as f64) as usize;
                change[j * (w + 1) + column] += sign;
            }
        }
    }
    for j in 0..h {
        let mut winding = 0;
        for i in 0..w {
            winding += change[j * (w + 1) + i];
            let inside = if rule == FillRule::NonZero {
                winding != 0
            } else {
                winding & 1 == 1
            };
            if inside {
                plot(i as i32, j as i32);
            }
        }
    }
}
