// right: held to the window it stays where it is
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    p.x.max(min.x).min(max.x) == p.x
        && p.y.max(min.y).min(max.y) == p.y
        && !min.is_nan()
        && !max.is_nan()
}
