// right: axis by axis, early returns
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    for axis in 0..2 {
        if !(p[axis] >= min[axis]) || !(p[axis] <= max[axis]) {
            return false;
        }
    }
    true
}
