// rejected by any_polygon: with x and y exchanged all of them lie inside
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
    for j in 0..height.min(width) {
        let y = f64::from(j) + 0.5;
        let mut crossings: Vec<(f64, i32)> = Vec::new();
        for (i, &a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            if (a.y <= y) != (b.y <= y) {
                let x = a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y);
                crossings.push((x, if a.y < b.y { 1 } else { -1 }));
            }
        }
        crossings.sort_by(|p, q| p.0.total_cmp(&q.0));

        // The first column whose centre is not left of x, if it is in the picture.
        let column = |x: f64| (x - 0.5).ceil().clamp(0.0, f64::from(width)) as i32;
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].1;
            let inside = match rule {
                FillRule::EvenOdd => winding % 2 != 0,
                FillRule::NonZero => winding != 0,
            };
            if inside {
                for i in column(pair[0].0)..column(pair[1].0) {
                    plot(j, i);
                }
            }
        }
    }
}
