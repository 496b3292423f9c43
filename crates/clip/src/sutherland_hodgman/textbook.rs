//! The method with rounded parameters.

use core::ops::{Div, Sub};

use ombra_math::glam::{DVec2, Vec2};
use ombra_math::work::{Count, Counter};

use crate::window::Window;

/// [`clip_polygon`](super::clip_polygon) as a textbook has it, in plain doubles, counting its
/// [work](crate#counted-work).
///
/// # Formula
///
/// ```text
/// a + t (b − a),   t = s_a / (s_a − s_b) rounded
/// a, b: vertices of what the last side has left
/// ```
///
/// # Properties
///
/// - Error: unbounded: some ε of the edge's coordinates for one cut, for a second one the edge's slope times that.
/// - Any input has an answer. Vertices that are not finite make others so.
///
/// # Pitfalls
///
/// - New vertices lie beyond the side that they were cut at: of (2.1, 1), (11, 0), (2, 9) one is at
///   x = 10.000000000000002, outside the lecture's window. Clipping again then moves it.
/// - What only touches the window leaves vertices, and vertices follow themselves.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Window, sutherland_hodgman};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let triangle = [(2.1, 1.0), (11.0, 0.0), (2.0, 9.0)].map(DVec2::from);
/// let exact = sutherland_hodgman::clip_polygon(&window, &triangle);
/// assert!(exact.iter().all(|&p| window.contains(p)));
/// let rounded = sutherland_hodgman::textbook(&window, &triangle, &mut ());
/// assert_eq!(rounded[1].x, 10.000000000000002);
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono».
#[must_use]
pub fn textbook(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Vec<DVec2> {
    let Window { min, max } = *window;
    let at = |a, b, t: f64| a + t * (b - a);
    // What one side leaves is ready for the next.
    let left = pass(polygon, |p| p.x - min.x, at, work);
    let left = pass(&left, |p| max.x - p.x, at, work);
    let left = pass(&left, |p| p.y - min.y, at, work);
    pass(&left, |p| max.y - p.y, at, work)
}

/// [`textbook`] with vertices and window in f32: what is lost, 2²⁹ times earlier.
///
/// # Properties
///
/// - Error: unbounded, as for [`textbook`], with the ε of f32.
#[must_use]
pub fn textbook_f32(window: &Window, polygon: &[Vec2], work: &mut impl Count) -> Vec<Vec2> {
    let (min, max) = (window.min.as_vec2(), window.max.as_vec2());
    let at = |a, b, t: f32| a + t * (b - a);
    let left = pass(polygon, |p: Vec2| p.x - min.x, at, work);
    let left = pass(&left, |p| max.x - p.x, at, work);
    let left = pass(&left, |p| p.y - min.y, at, work);
    pass(&left, |p| max.y - p.y, at, work)
}

/// What lies where `side` is not negative; `at` is the point at parameter t of an edge.
fn pass<V: Copy, T: Copy + Default + PartialOrd + Sub<Output = T> + Div<Output = T>>(
    polygon: &[V],
    side: impl Fn(V) -> T,
    at: impl Fn(V, V, T) -> V,
    work: &mut impl Count,
) -> Vec<V> {
    let mut kept = Vec::with_capacity(polygon.len() + 4);
    let Some(&(mut a)) = polygon.last() else {
        return kept;
    };
    let (zero, mut a_side) = (T::default(), side(a));
    work.add(Counter::Vertices, polygon.len() as u64);
    work.add(Counter::Additions, polygon.len() as u64);
    work.add(Counter::Comparisons, polygon.len() as u64);
    for &b in polygon {
        let b_side = side(b);
        // From one side to the other: put the crossing.
        if (a_side < zero) != (b_side < zero) {
            work.add(Counter::Divisions, 1);
            work.add(Counter::Multiplications, 2);
            work.add(Counter::Additions, 5);
            kept.push(at(a, b, a_side / (a_side - b_side)));
        }
        // In: put B.
        if b_side >= zero {
            kept.push(b);
        }
        (a, a_side) = (b, b_side);
    }
    kept
}
