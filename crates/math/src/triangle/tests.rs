use super::*;
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact, minus};
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn number(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn exact_cross(a: DVec3, b: DVec3, c: DVec3) -> [Exact; 3] {
    let [a, b, c] = [a, b, c].map(|p| exact(p).unwrap());
    cross(&minus(&b, &a), &minus(&c, &a))
}

/// |x − exact| ≤ bound.
fn within(x: f64, exact: &Exact, bound: &Exact) -> bool {
    (number(x) - exact).abs() <= *bound
}

/// Coordinates whose products reach from below the smallest subnormal almost to the largest double.
fn coordinate() -> impl Strategy<Value = f64> {
    (-1.0f64..1.0, -560i32..500).prop_map(|(m, e)| libm::scalbn(m, e))
}

fn point() -> impl Strategy<Value = DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array)
}

fn near(scale: f64) -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(move |p| DVec3::from_array(p) * scale)
}

/// A third of the triangles are collinear up to 10⁻¹² or exactly.
fn triangle() -> impl Strategy<Value = [DVec3; 3]> {
    prop_oneof![
        [point(), point(), point()],
        [near(1.0), near(1.0), near(1.0)],
        (
            near(1.0),
            near(1.0),
            -2.0..2.0,
            prop_oneof![Just(0.0), Just(1e-12), Just(1e-16)],
            near(1.0)
        )
            .prop_map(|(a, d, t, off, by)| [a, a + d, a + d * t + by * off]),
    ]
}

const A: DVec3 = DVec3::ZERO;
const B: DVec3 = DVec3::new(10.0, 0.0, 5.0);
const C: DVec3 = DVec3::new(3.0, 2.0, 5.0);

#[test]
fn the_lectures_normal() {
    assert_eq!(normal(A, B, C), DVec3::new(-10.0, -35.0, 20.0));
    assert_eq!(normal(B, C, A), DVec3::new(-10.0, -35.0, 20.0));
    assert_eq!(normal(A, C, B), DVec3::new(10.0, 35.0, -20.0));
    // 10² + 35² + 20² = 1725; one rounding each in root and scaling.
    assert!((area(A, B, C) - 1725f64.sqrt() / 2.0).abs() <= 2.0 * f64::EPSILON * 21.0);
}

/// Errata E14: (cos 0 + cos t, sin t + 1) with tan t = 2, so (1 + 1/√5, 2/√5 + 1), made unit.
#[test]
fn the_lectures_face_normal() {
    let given = [
        DVec3::X,
        DVec3::new(0.5, 1.0, 0.0),
        DVec3::new(0.0, 0.5, 0.0),
    ];
    let root = 5f64.sqrt();
    let right = DVec3::new(1.0 + 1.0 / root, 2.0 / root + 1.0, 0.0).normalize();
    let slide = DVec3::new(0.5, 0.5, 0.0).normalize();
    let n = face_normal(given).unwrap();
    assert!((n - right).length() <= 4.0 * f64::EPSILON);
    assert!((n - slide).length() > 0.12);
}

#[test]
fn huge_and_tiny() {
    // A right angle with legs 3s and 4s.
    for s in [1e-300, 1e-150, 1.0, 1e150, 1e300] {
        let [a, b, c] = [
            DVec3::splat(s),
            DVec3::splat(s) + DVec3::X * (3.0 * s),
            DVec3::splat(s) + DVec3::Y * (4.0 * s),
        ];
        let p = (a + b + c) / 3.0;
        let middle = barycentric(p, a, b, c).unwrap();
        // p is rounded at the scale s.
        assert!(
            (middle - DVec3::splat(1.0 / 3.0)).length() <= 8.0 * f64::EPSILON,
            "{s}: {middle}"
        );
        let n = face_normal([b - a, b - a, c - a]).unwrap();
        // (1, 1/2) made unit of 3s and 4s: twice X, once Y.
        assert!((n - DVec3::new(2.0, 1.0, 0.0).normalize()).length() <= 4.0 * f64::EPSILON);
    }
    assert!(
        (area(DVec3::ZERO, DVec3::X * 3e150, DVec3::Y * 4e150) / 6e300 - 1.0).abs()
            <= 4.0 * f64::EPSILON
    );
    assert_eq!(
        area(DVec3::ZERO, DVec3::X * 1e300, DVec3::Y * 1e300),
        f64::INFINITY
    );
    assert_eq!(
        normal(DVec3::ZERO, DVec3::X * 1e300, DVec3::Y * 1e300),
        DVec3::new(0.0, 0.0, f64::INFINITY)
    );
}

#[test]
fn degenerate() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    let collinear = [DVec3::splat(0.1), DVec3::splat(0.2), DVec3::splat(0.7)];
    let cases = [
        ("one place", [DVec3::ONE; 3], Some(0.0)),
        ("two places", [DVec3::ONE, DVec3::ONE, DVec3::X], Some(0.0)),
        ("collinear", collinear, Some(0.0)),
        (
            "the whole range",
            [DVec3::splat(-f64::MAX), DVec3::splat(f64::MAX), DVec3::ZERO],
            Some(0.0),
        ),
        (
            "subnormal",
            [DVec3::ZERO, DVec3::X * 5e-324, DVec3::Y * 5e-324],
            Some(0.0),
        ),
        ("infinite", [DVec3::ZERO, DVec3::X * inf, DVec3::Y], None),
        ("NaN", [DVec3::ZERO, DVec3::splat(nan), DVec3::Y], None),
    ];
    for (name, [a, b, c], expected) in cases {
        let size = area(a, b, c);
        assert!(
            expected.map_or(size.is_nan(), |e| size == e),
            "{name}: {size}"
        );
        if name == "subnormal" {
            // A triangle all the same, though no double holds its area.
            assert_eq!(barycentric(DVec3::ZERO, a, b, c), Some(DVec3::X), "{name}");
        } else {
            assert_eq!(barycentric(DVec3::ZERO, a, b, c), None, "{name}");
        }
    }
    assert_eq!(barycentric(DVec3::splat(nan), A, B, C), None);
    for normals in [
        [DVec3::X, DVec3::ZERO, DVec3::Y],
        [DVec3::splat(nan), DVec3::X, DVec3::X],
        [DVec3::X * inf, DVec3::X, DVec3::X],
    ] {
        assert_eq!(face_normal(normals), None);
    }
    let third = DVec3::new(-1.0, 0.0, 0.0);
    assert!(face_normal([DVec3::X, third, DVec3::Y]).is_some());
    assert_eq!(unit(DVec3::X + third), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn normal_is_near_the_exact_one([a, b, c] in triangle()) {
        let exact = exact_cross(a, b, c);
        for (x, exact) in normal(a, b, c).to_array().into_iter().zip(&exact) {
            // Half a subnormal step more, where the result is one.
            prop_assert!(within(x, exact, &(exact.abs().scaled(-41) + Exact::power_of_two(-1075))), "{x}");
        }
    }

    #[test]
    fn area_is_near_the_exact_one([a, b, c] in triangle()) {
        let n = exact_cross(a, b, c);
        let four_squared = dot(&n, &n);
        let squared = number(area(a, b, c)).squared().scaled(2);
        // Within 2⁻⁴⁰ of itself, squared within 2⁻³⁹ and a little.
        // And half a subnormal step of the area, where that is one.
        let step = number(area(a, b, c)).scaled(-1071) + Exact::power_of_two(-2140);
        let bound = four_squared.scaled(-38) + step;
        prop_assert!((squared - four_squared).abs() <= bound);
    }

    #[test]
    fn barycentric_gives_the_projection([a, b, c] in triangle(), p in near(1.0)) {
        let n = exact_cross(a, b, c);
        let n_n = dot(&n, &n);
        let Some(found) = barycentric(p, a, b, c) else {
            // Only a degenerate triangle or a coordinate that no double holds has none.
            let huge = [(p, b, c), (a, p, c), (a, b, p)].iter().any(|&(a, b, c)| {
                let w = exact_cross(a, b, c);
                dot(&w, &n).abs() >= n_n.scaled(1023)
            });
            prop_assert!(n_n == 0 || huge);
            return Ok(());
        };
        for (x, (a, b, c)) in found.to_array().into_iter().zip([(p, b, c), (a, p, c), (a, b, p)]) {
            let w = exact_cross(a, b, c);
            // (x − dot/n·n)² ≤ (2⁻³⁹ |w|/|n|)², the subnormal step aside.
            let error = number(x) - dot(&w, &n).over(&n_n).unwrap();
            let share = dot(&w, &w).over(&n_n).unwrap();
            prop_assert!(error.squared() <= share.scaled(-78) + Exact::power_of_two(-2146));
        }
    }

    #[test]
    fn mixing_the_corners_comes_back(weights in [0.0..1.0f64, 0.0..1.0, 0.0..1.0], h in -3.0..3.0) {
        let total: f64 = weights.iter().sum();
        prop_assume!(total > 0.1);
        let [s, t, u] = weights.map(|w| w / total);
        let n = normal(A, B, C).normalize();
        let found = barycentric(A * s + B * t + C * u + n * h, A, B, C).unwrap();
        // p and its height are rounded at size 12; |side|/|n| is below 0.3 here.
        prop_assert!((found - DVec3::new(s, t, u)).abs().max_element() <= 16.0 * f64::EPSILON);
    }

    #[test]
    fn never_panics(p in [ANY; 12]) {
        let [a, b, c, q] = [0, 3, 6, 9].map(|i| DVec3::from_slice(&p[i..]));
        let _ = (normal(a, b, c), area(a, b, c), scaled_cross(a, b, c));
        if let Some(n) = face_normal([a, b, c]) {
            prop_assert!((n.length() - 1.0).abs() <= 4.0 * f64::EPSILON);
        }
        if let Some(x) = barycentric(q, a, b, c) {
            prop_assert!(x.is_finite());
        }
    }
}
