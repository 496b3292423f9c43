// rejected by not_a_number_and_infinite: every comparison with NaN is false
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let outside =
        p.x < window.min.x || p.x > window.max.x || p.y < window.min.y || p.y > window.max.y;
    !outside
}
