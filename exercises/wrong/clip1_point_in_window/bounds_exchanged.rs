// rejected by known_points: inside when min and max are exchanged
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    max.x <= p.x && p.x <= min.x && max.y <= p.y && p.y <= min.y
}
