// rejected by beyond_each_side: with nothing that is computed from it
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    let c = (min + max) / 2.0;
    let h = (max - min) / 2.0;
    (p - c).abs().cmple(h).all()
}
