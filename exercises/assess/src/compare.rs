//! Compares of numbers and vectors within a stated bound.

use glam::{DVec2, DVec3};

/// Whether two vectors differ by at most `bound` in every coordinate. NaN is near nothing.
#[must_use]
pub fn is_near(got: DVec3, want: DVec3, bound: f64) -> bool {
    // An infinite coordinate equals itself, though ∞ − ∞ is NaN.
    (0..3).all(|i| got[i] == want[i] || (got[i] - want[i]).abs() <= bound)
}

/// Whether `a` and `b` lie on one line through the origin and point the same way; `bound` is the largest sine
/// allowed between them. The zero vector and NaN have no direction.
#[must_use]
pub fn parallel(a: DVec3, b: DVec3, bound: f64) -> bool {
    // Scaled by the largest coordinate first: squares of 10²⁰⁰ would overflow.
    let (Some(a), Some(b)) = (unit(a), unit(b)) else {
        return false;
    };
    a.dot(b) > 0.0 && a.cross(b).length() <= bound
}

fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    if v.is_finite() && largest > 0.0 {
        (v / largest).try_normalize()
    } else {
        None
    }
}

/// Fails unless `got` is `want` within `bound` in every coordinate.
///
/// # Panics
///
/// When it is not, with both vectors and the largest difference.
#[track_caller]
pub fn near(what: &str, got: DVec3, want: DVec3, bound: f64) {
    let both = brief_unless_equal([want, got], brief, show);
    assert!(
        is_near(got, want, bound),
        "{what}: expected {}, got {} ({})",
        both[0],
        both[1],
        difference((got - want).abs().max_element(), bound),
    );
}

/// Fails unless the number `got` is `want` within `bound`.
///
/// # Panics
///
/// When it is not, with both numbers and their difference.
#[track_caller]
pub fn near_number(what: &str, got: f64, want: f64, bound: f64) {
    let off = (got - want).abs();
    let both = brief_unless_equal([want, got], brief_number, show_number);
    assert!(
        got == want || off <= bound,
        "{what}: expected {}, got {} ({})",
        both[0],
        both[1],
        difference(off, bound),
    );
}

/// The value of an answer that must not be `None`.
///
/// # Panics
///
/// When it is `None`, with the reason why there is an answer.
#[track_caller]
pub fn some<T>(what: &str, got: Option<T>, because: &str) -> T {
    match got {
        Some(value) => value,
        None => panic!("{what}: got None, but {because}"),
    }
}

/// A vector as the lecture writes it: `(x, y, z)`.
#[must_use]
pub fn show(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(show_number);
    format!("({x}, {y}, {z})")
}

/// A point in the plane as the lecture writes it: `(x, y)`.
#[must_use]
pub fn show_point(p: DVec2) -> String {
    let [x, y] = p.to_array().map(show_number);
    format!("({x}, {y})")
}

/// The vertices of a polygon, one after another.
#[must_use]
pub fn show_points(polygon: &[DVec2]) -> String {
    if polygon.is_empty() {
        return "nothing".to_owned();
    }
    polygon
        .iter()
        .copied()
        .map(show_point)
        .collect::<Vec<_>>()
        .join(" ")
}

/// A number in full where it has few digits before or after the point, else with a power of ten.
#[must_use]
pub fn show_number(x: f64) -> String {
    if x == 0.0 || !x.is_finite() || (1e-4..1e12).contains(&x.abs()) {
        x.to_string()
    } else {
        format!("{x:e}")
    }
}

/// A vector in at most six digits a coordinate, for a message whose point is not the last digit.
#[must_use]
pub fn brief(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(brief_number);
    format!("({x}, {y}, {z})")
}

/// A number in at most six digits.
#[must_use]
pub fn brief_number(x: f64) -> String {
    // Six digits written and read back are the shortest form of a number that is near enough.
    show_number(format!("{x:.5e}").parse().unwrap_or(x))
}

/// Two values with few digits, or with all where the few do not tell them apart.
fn brief_unless_equal<T: Copy>(
    both: [T; 2],
    brief: fn(T) -> String,
    full: fn(T) -> String,
) -> [String; 2] {
    let [a, b] = both.map(brief);
    if a == b { both.map(full) } else { [a, b] }
}

fn difference(off: f64, bound: f64) -> String {
    if off.is_nan() {
        "not a number".to_owned()
    } else if bound == 0.0 {
        format!("off by {off:.3e}; this one must be exact")
    } else {
        format!("off by {off:.3e}, allowed is {bound:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_takes_the_bound_in_every_coordinate() {
        let want = DVec3::new(1.0, 2.0, 3.0);
        assert!(is_near(want, want, 0.0));
        for axis in DVec3::AXES {
            assert!(is_near(want + 0.25 * axis, want, 0.25));
            assert!(!is_near(want + 0.5 * axis, want, 0.25));
        }
        assert!(!is_near(DVec3::NAN, DVec3::NAN, 1.0));
        assert!(is_near(DVec3::INFINITY, DVec3::INFINITY, 0.0));
        assert!(!is_near(DVec3::INFINITY, DVec3::NEG_INFINITY, f64::MAX));
    }

    #[test]
    #[should_panic(
        expected = "the shadow: expected (1, 2, 3), got (1, 2, 4) (off by 1.000e0, allowed is 1e-9)"
    )]
    fn near_says_both_values_and_the_difference() {
        near(
            "the shadow",
            DVec3::new(1.0, 2.0, 4.0),
            DVec3::new(1.0, 2.0, 3.0),
            1e-9,
        );
    }

    #[test]
    #[should_panic(expected = "t: expected 1, got NaN (not a number)")]
    fn nan_is_never_near() {
        near_number("t", f64::NAN, 1.0, f64::INFINITY);
    }

    #[test]
    fn parallel_vectors_point_the_same_way_at_any_length() {
        let v = DVec3::new(1.0, -2.0, 0.5);
        assert!(parallel(v, 1e300 * v, 1e-15));
        assert!(parallel(v, 1e-300 * v, 1e-15));
        assert!(!parallel(v, -v, 1e-15));
        assert!(!parallel(v, DVec3::new(1.0, -2.0, 0.5001), 1e-6));
        assert!(!parallel(v, DVec3::ZERO, 1.0));
        assert!(!parallel(v, DVec3::NAN, 1.0));
    }

    #[test]
    fn numbers_stay_short() {
        let v = DVec3::new(-0.5, 1e-150, 2.5e12);
        assert_eq!(show(v), "(-0.5, 1e-150, 2.5e12)");
        assert_eq!(show_point(v.truncate()), "(-0.5, 1e-150)");
        assert_eq!(show_points(&[DVec2::X, DVec2::Y]), "(1, 0) (0, 1)");
        assert_eq!(show_points(&[]), "nothing");
        assert_eq!(
            show(DVec3::new(0.0, f64::NAN, f64::INFINITY)),
            "(0, NaN, inf)"
        );
    }

    #[test]
    fn brief_numbers_have_six_digits() {
        let v = DVec3::new(-2.0 / 3.0, 1e-150 / 3.0, 20.0 / 3.0);
        assert_eq!(brief(v), "(-0.666667, 3.33333e-151, 6.66667)");
        assert_eq!(
            [0.0, -1234.0, 1e150, f64::NAN, f64::INFINITY].map(brief_number),
            ["0", "-1234", "1e150", "NaN", "inf"]
        );
    }

    #[test]
    #[should_panic(expected = "the corner: got None, but the light is above it")]
    fn some_says_why_there_is_an_answer() {
        some::<DVec3>("the corner", None, "the light is above it");
    }
}
