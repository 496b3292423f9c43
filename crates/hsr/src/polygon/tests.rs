use super::*;
use core::f64::consts::TAU;
use ombra_math::glam::DQuat;
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact, minus};
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn ring(n: usize, step: usize, radius: f64) -> Vec<DVec3> {
    let angle = |i: usize| TAU * (i * step) as f64 / n as f64;
    let at = |t: f64| radius * DVec3::new(libm::cos(t), libm::sin(t), 0.0);
    (0..n).map(|i| at(angle(i))).collect()
}

#[test]
fn a_square_in_any_order_of_corners() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y].map(|v| 2.0 * v);
    let [a, b, c, d] = square;
    let good = Polygon::new(square.to_vec()).unwrap();
    assert_eq!(
        (good.area(), good.centroid()),
        (4.0, Some(DVec3::new(1.0, 1.0, 0.0)))
    );
    assert_eq!(good.plane().unwrap().normal.normalize(), DVec3::Z);
    let back = Polygon::new(vec![d, c, b, a]).unwrap();
    assert_eq!(back.plane().unwrap().normal.normalize(), -DVec3::Z);
    for crossed in [[a, c, b, d], [a, b, d, c], [a, c, d, b]] {
        let error = Polygon::new(crossed.to_vec()).unwrap_err();
        assert!(matches!(error, PolygonError::NotConvex { .. }), "{error}");
    }
}

#[test]
fn what_is_no_polygon() {
    let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    let cases: [(Vec<DVec3>, PolygonError, &str); 9] = [
        (
            vec![],
            PolygonError::TooFew { vertices: 0 },
            "a polygon needs three vertices at least, not 0",
        ),
        (
            vec![o, x],
            PolygonError::TooFew { vertices: 2 },
            "a polygon needs three vertices at least, not 2",
        ),
        (
            vec![o, x, DVec3::INFINITY],
            PolygonError::Position {
                vertex: 2,
                position: DVec3::INFINITY,
            },
            "vertex 2 is at [inf, inf, inf]; its coordinates must be finite numbers",
        ),
        (
            vec![o; 3],
            PolygonError::Collinear,
            "the vertices lie on one line; a polygon needs a plane",
        ),
        (
            vec![o, x, 2.0 * x, 3.0 * x],
            PolygonError::Collinear,
            "the vertices lie on one line; a polygon needs a plane",
        ),
        (
            vec![o, 4.0 * x, 4.0 * (x + y), 3.0 * y + 0.5 * z],
            PolygonError::NotPlanar {
                vertex: 3,
                distance: 0.5,
                allowed: 4.0 * Polygon::TOLERANCE,
            },
            "vertex 3 is 5e-1 away from the plane of the others; at most 3.637978807091713e-12 is allowed",
        ),
        // An arrow head, a spike, a spike along an edge.
        (
            vec![o, x, 0.25 * (x + y), y],
            PolygonError::NotConvex { vertex: 2 },
            "the polygon is not convex at vertex 2; cut it into convex ones",
        ),
        (
            vec![o, x, 2.0 * x, x, x + y, y],
            PolygonError::NotConvex { vertex: 3 },
            "the polygon is not convex at vertex 3; cut it into convex ones",
        ),
        (
            vec![o, 2.0 * x, x, x + y, y],
            PolygonError::NotConvex { vertex: 2 },
            "the polygon is not convex at vertex 2; cut it into convex ones",
        ),
    ];
    for (vertices, error, text) in cases {
        assert_eq!(Polygon::new(vertices.clone()), Err(error), "{vertices:?}");
        assert_eq!(error.to_string(), text);
    }
    // NaN is not equal to itself.
    let nan = Polygon::new(vec![o, DVec3::NAN, y]).unwrap_err();
    assert!(matches!(nan, PolygonError::Position { vertex: 1, .. }));
    for tolerance in [f64::NAN, -1.0] {
        let error = Polygon::with_tolerance(vec![o, x, y], tolerance).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("the tolerance must be 0 or more, not {tolerance}")
        );
    }
    let bent = vec![o, x, x + y, y + 0.5 * z];
    assert!(Polygon::with_tolerance(bent, 0.5).is_ok());
}

#[test]
fn turns_that_never_go_inwards() {
    for n in [4, 5, 6, 7, 30] {
        assert!(Polygon::new(ring(n, 1, 3.0)).is_ok(), "{n}");
        let twice = [ring(n, 1, 3.0), ring(n, 1, 3.0)].concat();
        assert!(
            matches!(Polygon::new(twice), Err(PolygonError::NotConvex { .. })),
            "{n} twice"
        );
    }
    for (n, step) in [(5, 2), (7, 2), (7, 3), (9, 4)] {
        let star = Polygon::new(ring(n, step, 3.0));
        assert!(
            matches!(star, Err(PolygonError::NotConvex { .. })),
            "{n}/{step}"
        );
    }
}

#[test]
fn repeated_vertices_and_straight_corners() {
    let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
    for vertices in [
        vec![o, o, x, x, y, y, o],
        vec![o, 0.25 * x, 0.5 * x, x, y],
        vec![o, x, 0.5 * (x + y), y, 0.3 * y],
    ] {
        let polygon = Polygon::new(vertices).unwrap();
        assert_eq!(polygon.area(), 0.5);
        assert_eq!(polygon.plane().unwrap().normal.normalize(), DVec3::Z);
        // Four additions and products of numbers up to 1.
        let off = polygon.centroid().unwrap() - (x + y) / 3.0;
        assert!(off.length() <= 4.0 * f64::EPSILON, "{off}");
    }
}

/// A right triangle with sides of 2ᵉ has half their square, whatever e: products of coordinates leave the range first.
#[test]
fn area_and_centre_at_every_exponent() {
    for exponent in [-1070, -500, -272, 0, 266, 500, 1020] {
        let side = libm::scalbn(1.0, exponent);
        let corners = [DVec3::ZERO, side * DVec3::X, side * DVec3::Y];
        let triangle = Polygon::new(corners.to_vec()).unwrap();
        assert_eq!(
            triangle.area(),
            libm::scalbn(0.5, 2 * exponent),
            "2^{exponent}"
        );
        let centre = triangle.centroid().unwrap();
        // A third, rounded twice; at the end of the range, to a multiple of the smallest double.
        let off = (centre - side / 3.0 * (DVec3::X + DVec3::Y))
            .abs()
            .max_element();
        assert!(
            off <= 2.0 * f64::EPSILON * side + f64::from_bits(1),
            "2^{exponent}: {centre}"
        );
    }
}

#[test]
fn every_size() {
    for e in [-1070, -700, -30, 0, 30, 700, 1021] {
        let s = libm::scalbn(1.0, e);
        let vertices = [(1, 1), (5, 2), (6, 5), (2, 4)]
            .map(|(i, j)| s * DVec3::new(f64::from(i), f64::from(j), 1.0));
        let polygon = Polygon::new(vertices.to_vec()).unwrap();
        let plane = polygon.plane().unwrap();
        assert!(plane.normal.z > 0.0 && plane.normal.x == 0.0, "{e}");
        let dart = [
            vertices[0],
            vertices[1],
            s * DVec3::new(2.0, 2.0, 1.0),
            vertices[3],
        ];
        assert_eq!(
            Polygon::new(dart.to_vec()),
            Err(PolygonError::NotConvex { vertex: 2 }),
            "{e}"
        );
    }
}

proptest! {
    /// Convex polygons stay accepted wherever they are moved and turned: their corners are then rounded.
    #[test]
    fn rounding_is_allowed_for(
        n in 3usize..12, axis in prop::array::uniform3(-1.0..1.0), angle in 0.0..6.0,
        shift in prop::array::uniform3(-1e6..1e6), radius in 1e-3..1e3, straight in any::<bool>(),
    ) {
        let axis = DVec3::from(axis).try_normalize().unwrap_or(DVec3::X);
        let turn = DQuat::from_axis_angle(axis, angle);
        let mut flat = ring(n, 1, radius);
        if straight {
            flat.insert(1, flat[0].lerp(flat[1], 0.3));
        }
        let vertices: Vec<_> = flat.iter().map(|&v| turn * v + DVec3::from(shift)).collect();
        let polygon = Polygon::new(vertices);
        prop_assert!(polygon.is_ok(), "{polygon:?}");
        let polygon = polygon.unwrap();
        let scale = polygon.scale();
        let expected = 0.5 * n as f64 * radius * radius * libm::sin(TAU / n as f64);
        // Each corner is off by an ulp of the coordinates, as far as the polygon is wide.
        let tolerance = 16.0 * n as f64 * f64::EPSILON * scale * radius;
        prop_assert!((polygon.area() - expected).abs() <= tolerance);
        let front = polygon.plane().unwrap().normal.normalize();
        prop_assert!((front - turn * DVec3::Z).length() <= 64.0 * f64::EPSILON * scale / radius * n as f64);
    }

    #[test]
    fn never_panics(v in prop::collection::vec(prop::array::uniform3(ANY), 0..7), tolerance in ANY) {
        let vertices: Vec<_> = v.into_iter().map(DVec3::from).collect();
        let polygon = Polygon { vertices: vertices.clone() };
        let _ = (polygon.area(), polygon.centroid(), polygon.plane(), polygon.span());
        if let Ok(checked) = Polygon::with_tolerance(vertices, tolerance) {
            prop_assert!(checked.plane().is_some());
        }
    }
}

#[test]
fn a_needle_has_a_plane_however_thin_and_wherever_it_is() {
    // Four vertices, of which three are on one line and the last is beside it by one part in 10¹⁷ of the length.
    for d in [(10.0, 8.0), (11.0, 4.0), (11.0, 5.0)] {
        let (o, d) = (DVec3::new(1.0, 2.0, 0.0), DVec3::new(d.0, d.1, 0.0));
        let beside = o + 2.0 * d + DVec3::Z / f64::from(1u32 << 31) / f64::from(1u32 << 20);
        let needle = Polygon::new(vec![o, o + d, o + 3.0 * d, beside]).unwrap();
        assert_eq!(needle.span(), Some([o, o + 3.0 * d, beside]));
        assert!(needle.plane().is_some());
    }
    // Far away, thin and small: x for all four, and a width; 2⁻¹⁰⁷⁴ is the smallest there is.
    for (x, length, width) in [
        (180, 0, -180),
        (0, 0, -600),
        (1023, -1074, -1074),
        (1023, 1023, -1074),
        (-1074, -1074, -1074),
    ] {
        let [x, l, w] = [x, length, width].map(|e| libm::scalbn(1.0, e));
        let corner = |y: f64, z: f64| DVec3::new(x, y, z);
        let corners = [
            corner(0.0, 0.0),
            corner(l, 0.0),
            corner(l, w),
            corner(0.0, w),
        ];
        let rectangle = Polygon {
            vertices: corners.to_vec(),
        };
        let normal = rectangle.plane().unwrap().normal;
        assert!(
            normal.x > 0.0 && normal.y == 0.0 && normal.z == 0.0,
            "{x:e} {l:e} {w:e}: {normal}"
        );
        let flat = Polygon {
            vertices: [
                corner(0.0, 0.0),
                corner(l, 0.0),
                corner(0.0, 0.0),
                corner(l, 0.0),
            ]
            .to_vec(),
        };
        assert_eq!(flat.plane(), None, "{x:e} {l:e}");
    }
}

proptest! {
    /// Against exact numbers: n = 3 … 5, on any plane, also thin ones and ones far from the origin.
    #[test]
    fn area_and_centre_are_within_their_bounds(
        corner in prop::array::uniform3(-4.0..4.0),
        sides in prop::array::uniform2(prop::array::uniform3(-1.0..1.0)),
        thin in 0..30i32, away in 0..20, n in 3usize..6,
    ) {
        let thin = libm::scalbn(1.0, -thin);
        let first = DVec3::from(corner) * libm::scalbn(1.0, away);
        let [u, v] = sides.map(DVec3::from);
        let v = u + v * thin;
        // Corners of a convex outline, rounded: a fifth and a fourth of the plane, or nearly.
        let outline = [DVec3::ZERO, u, u + v, 0.5 * u + 1.5 * v, v];
        let order = [[0, 1, 4, 0, 0], [0, 1, 2, 4, 0], [0, 1, 2, 3, 4]][n - 3];
        let vertices: Vec<_> = order[..n].iter().map(|&i| first + outline[i]).collect();
        let polygon = Polygon { vertices };
        let m = polygon.scale();
        let at: Vec<_> = polygon.vertices.iter().map(|&v| exact(v).unwrap()).collect();
        let from_first = |i: usize| minus(&at[i], &at[0]);
        let crosses: Vec<_> = (1..n - 1).map(|i| cross(&from_first(i), &from_first(i + 1))).collect();
        let whole = [0, 1, 2].map(|k| crosses.iter().map(|c| &c[k]).sum::<Exact>());
        // 4 A² exactly; (A − bound)² ≤ A² ≤ (A + bound)².
        let square = dot(&whole, &whole);
        let bound = 8.0 * n as f64 * f64::EPSILON * m * m;
        let twice = |x: f64| Exact::new(2.0 * x).unwrap();
        let (low, high) = (twice((polygon.area() - bound).max(0.0)), twice(polygon.area() + bound));
        prop_assert!(low.squared() <= square && square <= high.squared());
        if square > 0 && let Some(centre) = polygon.centroid() {
            let area = square.nearest().sqrt() / 2.0;
            let bound = 16.0 * n as f64 * f64::EPSILON * m * m * m / area;
            let weight: Vec<_> = crosses.iter().map(|c| dot(c, &whole)).collect();
            let thrice = weight.iter().sum::<Exact>() * Exact::from(3);
            for k in 0..3 {
                let moment: Exact = weight.iter().enumerate().map(|(i, w)| {
                    w * (&from_first(i + 1)[k] + &from_first(i + 2)[k])
                }).sum();
                let exact = &at[0][k] + moment.over(&thrice).unwrap();
                let off = (Exact::new(centre[k]).unwrap() - exact).nearest();
                prop_assert!(off.abs() <= bound, "{off} {bound}");
            }
        }
    }
}
