use glam::DVec2;

/// Which winding numbers are inside.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FillRule {
    /// The odd ones.
    EvenOdd,
    /// All but 0.
    NonZero,
}

/// The pixels of a picture whose centres lie in a polygon, row by row (scan line by scan line).
///
/// ```text
/// pixel (i, j) has its centre in (i + ½, j + ½),  0 ≤ i < width,  0 ≤ j < height
///
/// the edge A → B crosses y = j + ½ where  A_y ≤ y < B_y  (it runs down: +1)  or  B_y ≤ y < A_y  (it runs up: −1)
///
///                       B_x − A_x
/// X = A_x + (y − A_y) ─────────────          winding number at x: the sum over all crossings X ≤ x
///                       B_y − A_y
/// ```
///
/// The last vertex is joined to the first one. With ≤ on one side and < on the other, a vertex on the row counts
/// once where two edges run on through it, and a centre exactly on an edge belongs to what lies right of the edge
/// (below it, if it is horizontal): two polygons with a common edge share no pixel and miss none.
///
/// `plot(i, j)` lights a pixel, each once, in any order; y points down. Coordinates are finite and below 10¹⁰⁰.
///
/// Grafica 3, Rasterizzazione di Poligoni, which shows convex, concave and self-intersecting polygons and goes no
/// further.
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
                    plot(i, j);
                }
            }
        }
    }
}

fn main() {}
