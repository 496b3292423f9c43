// rejected by known_points: inside when y_min and y_max are exchanged
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    min.x <= p.x && p.x <= max.x && min.y >= p.y && p.y >= max.y
}
