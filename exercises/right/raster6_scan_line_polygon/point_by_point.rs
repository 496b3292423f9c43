// right: each pixel asked for itself, by the sum over the crossings left of its centre
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
    for j in 0..height {
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

        for i in 0..width {
            let x = f64::from(i) + 0.5;
            let left = crossings.iter().take_while(|crossing| crossing.0 <= x);
            let winding: i32 = left.map(|crossing| crossing.1).sum();
            if winding != 0 && (rule == FillRule::NonZero || winding % 2 != 0) {
                plot(i, j);
            }
        }
    }
}
