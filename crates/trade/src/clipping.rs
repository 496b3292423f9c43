//! What the studies of clipping are put to: a window.

use ombra_clip::Window;
use ombra_math::glam::DVec2;

/// Of no round size, so that nothing is exact by chance.
pub const WINDOW: Window = Window {
    min: DVec2::new(0.1, 0.3),
    max: DVec2::new(10.3, 10.1),
};

/// The middle of the window.
pub fn middle() -> DVec2 {
    0.5 * (WINDOW.min + WINDOW.max)
}

/// The longer of the window's sides.
pub fn size() -> f64 {
    (WINDOW.max - WINDOW.min).max_element()
}
