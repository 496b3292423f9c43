// rejected by on_the_border: the border is inside
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    window.min.x < p.x && p.x < window.max.x && window.min.y < p.y && p.y < window.max.y
}
