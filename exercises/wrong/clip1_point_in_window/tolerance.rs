// rejected by beyond_each_side: without a tolerance
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let off = (window.min - p).max(p - window.max);
    off.x <= 1e-9 && off.y <= 1e-9 && !p.is_nan() && !window.min.is_nan() && !window.max.is_nan()
}
