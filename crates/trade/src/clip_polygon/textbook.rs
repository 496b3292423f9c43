//! Sutherland–Hodgman as textbooks write it: four passes, each crossing by a rounded parameter.

use core::ops::{Div, Sub};

use ombra_clip::Window;
use ombra_math::glam::{DVec2, Vec2};
use ombra_math::work::{Count, Counter};

/// In doubles.
pub fn in_f64(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Vec<DVec2> {
    let Window { min, max } = *window;
    let sides = (
        |p: DVec2| p.x - min.x,
        |p: DVec2| max.x - p.x,
        |p: DVec2| p.y - min.y,
        |p: DVec2| max.y - p.y,
    );
    in_four_passes(polygon, sides, |a, b, t| a + t * (b - a), work)
}

/// In f32.
pub fn in_f32(window: &Window, polygon: &[Vec2], work: &mut impl Count) -> Vec<Vec2> {
    let (min, max) = (window.min.as_vec2(), window.max.as_vec2());
    let sides = (
        |p: Vec2| p.x - min.x,
        |p: Vec2| max.x - p.x,
        |p: Vec2| p.y - min.y,
        |p: Vec2| max.y - p.y,
    );
    in_four_passes(polygon, sides, |a, b, t| a + t * (b - a), work)
}

/// Against one side after another; a side's function is not negative in the window.
fn in_four_passes<V: Copy, T: Copy + Default + PartialOrd + Sub<Output = T> + Div<Output = T>>(
    polygon: &[V],
    sides: (
        impl Fn(V) -> T,
        impl Fn(V) -> T,
        impl Fn(V) -> T,
        impl Fn(V) -> T,
    ),
    at: impl Fn(V, V, T) -> V,
    work: &mut impl Count,
) -> Vec<V> {
    let right_of_left = pass(polygon, sides.0, &at, work);
    let between = pass(&right_of_left, sides.1, &at, work);
    let above_bottom = pass(&between, sides.2, &at, work);
    pass(&above_bottom, sides.3, &at, work)
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
    let (zero, mut side_a) = (T::default(), side(a));
    for &b in polygon {
        let side_b = side(b);
        work.add(Counter::Vertices, 1);
        work.add(Counter::Additions, 1);
        work.add(Counter::Comparisons, 1);
        if (side_a < zero) != (side_b < zero) {
            work.add(Counter::Divisions, 1);
            work.add(Counter::Multiplications, 2);
            work.add(Counter::Additions, 5);
            kept.push(at(a, b, side_a / (side_a - side_b)));
        }
        if side_b >= zero {
            kept.push(b);
        }
        (a, side_a) = (b, side_b);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_math::work::Work;

    #[test]
    fn a_corner_of_a_square() {
        let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
        let square = [(5.0, 5.0), (15.0, 5.0), (15.0, 15.0), (5.0, 15.0)].map(DVec2::from);
        let corner = [(5.0, 10.0), (5.0, 5.0), (10.0, 5.0), (10.0, 10.0)].map(DVec2::from);
        let mut work = Work::default();
        assert_eq!(in_f64(&window, &square, &mut work), corner);
        // Two crossings on the right and two above; 4 vertices come to each pass.
        assert_eq!((work.divisions, work.vertices), (4, 16));
        let found = in_f32(&window, &square.map(|p| p.as_vec2()), &mut ());
        assert_eq!(found, corner.map(|p| p.as_vec2()));
        assert!(in_f64(&window, &square.map(|p| p + 20.0), &mut ()).is_empty());
        assert!(in_f64(&window, &[], &mut ()).is_empty());
    }
}
