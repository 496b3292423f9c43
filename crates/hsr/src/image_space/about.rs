//! Which pixels lie about a primitive: what need not be intersected, with every rounding in account.

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DVec2, DVec3, DVec4, UVec2};

/// Four products and three sums round seven times, by ε/2 each; the rest is room for the rounding of the bound, and of
/// the place itself.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// Where a homogeneous point comes out in the picture, at least and at most; `None` where it may lie behind the eye.
fn place(camera: &Camera, p: DVec4) -> Option<[DVec2; 2]> {
    let [x, y, w] = [0, 1, 3].map(|i| {
        let row = camera.view_projection.row(i);
        (row.dot(p), ROUNDINGS * row.abs().dot(p.abs()))
    });
    let least_w = w.0 - w.1;
    let inside = least_w > 0.0 && least_w.is_finite();
    let ndc = |(value, error): (f64, f64)| {
        let quotient = value / w.0;
        let error = (error + quotient.abs() * w.1) / least_w + f64::EPSILON * quotient.abs();
        [quotient - error, quotient + error]
    };
    let [[left, right], [bottom, top]] = [ndc(x), ndc(y)];
    let size = UVec2::new(camera.viewport.width, camera.viewport.height).as_dvec2();
    let low = 0.5 * DVec2::new(left + 1.0, 1.0 - top) * size;
    let high = 0.5 * DVec2::new(right + 1.0, 1.0 - bottom) * size;
    // The way to pixels rounds as well, of what is in the picture by far less than the pixel added in the end.
    (inside && low.is_finite() && high.is_finite()).then_some([low, high])
}

/// The pixels about a primitive's outline in the picture, one more on each side; all of them where it reaches behind
/// the eye: first column and row, last column and row.
pub(super) fn pixel_box(corners: &[DVec3], camera: &Camera) -> [UVec2; 2] {
    let last = UVec2::new(camera.viewport.width, camera.viewport.height);
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for corner in corners {
        let Some([least, greatest]) = place(camera, corner.extend(1.0)) else {
            return [UVec2::ZERO, last];
        };
        (low, high) = (low.min(least), high.max(greatest));
    }
    // `as` takes what is beyond the picture to its rim; a box wholly outside holds no pixel, or one at the rim.
    [(low - 1.0).as_uvec2(), (high + 1.0).as_uvec2()]
}

/// Whether a sight line stays within half a pixel of the centre it was made for, from its origin to its last place in
/// the view volume: then what it meets is seen within a pixel's box.
///
/// Projected, a line is straight, and its ends tell. Where it goes away from the eye, the far end is where it vanishes.
pub(super) fn is_true(line: SightLine, last: Option<f64>, pixel: UVec2, camera: &Camera) -> bool {
    let SightLine { origin, direction } = line;
    let end = place(camera, direction.extend(0.0))
        .or_else(|| place(camera, (origin + last? * direction).extend(1.0)));
    let start = place(camera, origin.extend(1.0));
    let centre = pixel.as_dvec2() + 0.5;
    let is_near = |at: Option<[DVec2; 2]>| {
        at.is_some_and(|at| at.iter().all(|p| (*p - centre).abs().max_element() <= 0.5))
    };
    is_near(start) && is_near(end)
}
