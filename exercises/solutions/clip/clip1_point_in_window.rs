use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// Whether the point lies in the window.
///
/// ```text
/// x_min ≤ x ≤ x_max      y_min ≤ y ≤ y_max
/// ```
///
/// The border is inside, however small the step beyond it is outside. A point with a coordinate that is NaN lies
/// nowhere, so not in a window; nothing lies in a window with such a corner.
///
/// Grafica 3, Clipping.
fn contains(window: Window, p: DVec2) -> bool {
    window.min.x <= p.x && p.x <= window.max.x && window.min.y <= p.y && p.y <= window.max.y
}

fn main() {}
