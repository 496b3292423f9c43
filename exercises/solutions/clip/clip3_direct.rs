use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// What of the segment from `a` to `b` lies in the window, by its intersections with the four sides.
///
/// ```text
/// x = x_a + t (x_b − x_a)      y = y_a + t (y_b − y_a)      0 ≤ t ≤ 1
///
/// with the side x = x_min:   t = (x_min − x_a) / (x_b − x_a),   where y_min ≤ y ≤ y_max
/// ```
///
/// and likewise with the other three. First of all, is the segment parallel to the side? Then there is no t. An end
/// that lies in the window is an end of the answer, too. The answer goes the same way as a → b, and where the segment
/// touches the window in one point, both its ends are that point. An end on a side has the coordinate of the side
/// itself, not a rounded one; the other coordinate may be off by a few roundings. `None` where nothing lies inside,
/// however little beyond the window the segment passes; only where that is less than the rounding of its own coordinates
/// may it go either way. No coordinate is larger than 10¹⁵ times the window.
///
/// Grafica 3, Clipping di un segmento.
fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let d = b - a;
    let in_x = |p: DVec2| window.min.x <= p.x && p.x <= window.max.x;
    let in_y = |p: DVec2| window.min.y <= p.y && p.y <= window.max.y;

    // Each point with its t.
    let mut found: Vec<(f64, DVec2)> = Vec::new();
    for (t, p) in [(0.0, a), (1.0, b)] {
        if in_x(p) && in_y(p) {
            found.push((t, p));
        }
    }
    for x in [window.min.x, window.max.x] {
        if d.x != 0.0 {
            let t = (x - a.x) / d.x;
            let p = DVec2::new(x, a.y + t * d.y);
            if (0.0..=1.0).contains(&t) && in_y(p) {
                found.push((t, p));
            }
        }
    }
    for y in [window.min.y, window.max.y] {
        if d.y != 0.0 {
            let t = (y - a.y) / d.y;
            let p = DVec2::new(a.x + t * d.x, y);
            if (0.0..=1.0).contains(&t) && in_x(p) {
                found.push((t, p));
            }
        }
    }
    found.sort_by(|p, q| p.0.total_cmp(&q.0));
    Some((found.first()?.1, found.last()?.1))
}

fn main() {}
