// rejected by known_points: a point beyond one side is inside for you, whichever the side
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    (min.x <= p.x && p.x <= max.x) || (min.y <= p.y && p.y <= max.y)
}
