use super::*;
use crate::oracle::{self, Exact, r};
use crate::sutherland_hodgman::counted;
use ombra_math::work::Work;
use ombra_oracle::interval::between;
use ombra_oracle::vector::exact;
use proptest::prelude::*;

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Twice the area of a polygon with z = 0.
fn area(polygon: &[DVec3]) -> Exact {
    let flat: Vec<_> = polygon.iter().map(|p| p.truncate()).collect();
    oracle::area(&flat)
}

fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
    p.map(DVec2::from).to_vec()
}

#[test]
fn the_lectures_triangle_against_one_line_then_four() {
    let line = |normal, offset| HalfPlane { normal, offset };
    let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
    let one = clip_against_line(&triangle, line(-DVec2::X, -10.0));
    assert_eq!(
        one,
        points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 15.0)])
    );
    let mut four = one;
    for side in [
        line(DVec2::X, 0.0),
        line(DVec2::Y, 0.0),
        line(-DVec2::Y, -10.0),
    ] {
        four = clip_against_line(&four, side);
    }
    four.rotate_left(1);
    assert_eq!(
        four,
        points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)])
    );
}

#[test]
fn counts_its_work() {
    let square = points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    let count = |x: f64, y: f64, offset| {
        let half = HalfPlane {
            normal: DVec2::new(x, y),
            offset,
        };
        let mut work = Work::default();
        let answer = counted::clip_against_line(&square, half, &mut work);
        assert_eq!(answer, clip_against_line(&square, half));
        [
            work.vertices,
            work.comparisons,
            work.multiplications,
            work.divisions,
        ]
    };
    assert_eq!(count(1.0, 0.0, 1.0), [4, 4, 8, 2]);
    assert_eq!(count(1.0, 0.0, 0.0), [4, 4, 8, 0]);
    assert_eq!(count(1.0, 0.0, 5.0), [4, 4, 8, 0]);
    // Through two corners.
    assert_eq!(count(1.0, -1.0, 0.0), [4, 4, 8, 0]);
}

#[test]
fn counts_its_work_in_space() {
    let square = [
        v(0.0, 0.0, 1.0),
        v(4.0, 0.0, 1.0),
        v(4.0, 4.0, 1.0),
        v(0.0, 4.0, 1.0),
    ];
    let numbers = |work: Work| {
        [
            work.vertices,
            work.comparisons,
            work.multiplications,
            work.divisions,
        ]
    };
    let count = |x: f64, y: f64, z: f64, d| {
        let plane = Plane {
            normal: v(x, y, z),
            d,
        };
        let [mut places, mut homogeneous] = [Work::default(); 2];
        let answer = counted::clip_against_plane(&square, &plane, &mut places);
        assert_eq!(answer, clip_against_plane(&square, &plane));
        let lifted = square.map(point);
        let p = plane.coefficients();
        let answer = counted::clip_homogeneous(&lifted, p, &mut homogeneous);
        assert_eq!(answer, clip_homogeneous(&lifted, p));
        [places, homogeneous].map(numbers)
    };
    // Four vertices, one sign for each, three products and four. Across two sides of the square; along one; beyond it.
    let none = [[4, 4, 12, 0], [4, 4, 16, 0]];
    assert_eq!(count(1.0, 0.0, 0.0, -1.0), [[4, 4, 12, 2], [4, 4, 16, 2]]);
    assert_eq!(count(1.0, 0.0, 0.0, 0.0), none);
    assert_eq!(count(0.0, 0.0, 1.0, -2.0), none);
    // Through two corners; through one, and across a side.
    assert_eq!(count(1.0, -1.0, 0.0, 0.0), none);
    assert_eq!(count(2.0, -1.0, 0.0, 0.0), [[4, 4, 12, 1], [4, 4, 16, 1]]);
    assert_eq!(count(0.0, 0.0, 0.0, -1.0), none);
    let mut work = Work::default();
    assert_eq!(
        counted::clip_against_plane(&[], &Plane::GROUND, &mut work),
        []
    );
    assert_eq!(numbers(work), [0; 4]);
}

#[test]
fn degenerate_lines() {
    let square = points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    let line = |x, y, offset| HalfPlane {
        normal: DVec2::new(x, y),
        offset,
    };
    let huge = f64::MAX;
    let cases = [
        // No normal: all or nothing.
        (line(0.0, 0.0, 0.0), square.clone()),
        (line(0.0, 0.0, 1.0), vec![]),
        // Along a side, through a corner only, through two corners.
        (line(1.0, 0.0, 0.0), square.clone()),
        (line(1.0, 0.0, 4.0), vec![]),
        (line(-1.0, -1.0, 0.0), vec![]),
        (line(1.0, -1.0, 0.0), square[..3].to_vec()),
        (
            line(huge, huge, huge),
            points([(0.0, 1.0), (1.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]),
        ),
        (
            line(5e-324, 0.0, 1e-323),
            points([(2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 4.0)]),
        ),
    ];
    for (half, expected) in cases {
        assert_eq!(clip_against_line(&square, half), expected, "{half:?}");
    }
    for bad in [f64::NAN, f64::INFINITY] {
        for half in [
            line(bad, 0.0, 0.0),
            line(0.0, bad, 0.0),
            line(1.0, 0.0, bad),
        ] {
            assert_eq!(clip_against_line(&square, half), []);
        }
        assert!(!line(1.0, 0.0, 0.0).contains(DVec2::new(bad, 0.0)));
    }
}

#[test]
fn inside_outside_and_across() {
    let square = [
        v(0.0, 0.0, 0.0),
        v(4.0, 0.0, 0.0),
        v(4.0, 4.0, 0.0),
        v(0.0, 4.0, 0.0),
    ];
    let at = |x: f64| Plane {
        normal: DVec3::X,
        d: -x,
    };
    assert_eq!(clip_against_plane(&square, &at(-1.0)), square);
    assert_eq!(clip_against_plane(&square, &at(0.0)), square);
    assert_eq!(clip_against_plane(&square, &at(5.0)), []);
    assert_eq!(
        clip_against_plane(&square, &at(4.0)),
        [],
        "an edge alone is no polygon"
    );
    let half = clip_against_plane(&square, &at(2.0));
    assert_eq!(
        half,
        [
            v(2.0, 0.0, 0.0),
            v(4.0, 0.0, 0.0),
            v(4.0, 4.0, 0.0),
            v(2.0, 4.0, 0.0)
        ]
    );
    assert_eq!(
        clip_against_plane(&half, &at(2.0)),
        half,
        "clipping twice changes nothing"
    );
}

#[test]
fn what_only_touches_is_no_polygon() {
    let touching = [
        v(0.0, 0.0, 0.0),
        v(1.0, 0.0, 0.0),
        v(2.0, 0.0, 0.0),
        v(1.0, -1.0, 0.0),
    ];
    assert_eq!(clip_against_plane(&touching, &Plane::GROUND), []);
    assert_eq!(
        clip_against_plane(&touching[..3], &Plane::GROUND),
        touching[..3]
    );
}

#[test]
fn huge_coordinates_stay_finite() {
    let far = [DVec3::splat(f64::MAX), -DVec3::ONE, v(0.0, -1.0, -1.0)];
    let slanted = Plane {
        normal: DVec3::ONE,
        d: 0.0,
    };
    let cut = clip_against_plane(&far, &slanted);
    assert!(
        cut.len() == 3 && cut.iter().all(|p| p.is_finite()),
        "{cut:?}"
    );
    let wide = [
        v(-1.0, f64::MAX, 0.0),
        v(1.0, f64::MAX, 0.0),
        v(1.0, -f64::MAX, 0.0),
    ]
    .map(point);
    let cut = clip_homogeneous(&wide, DVec4::X);
    assert!(
        cut.len() == 4 && cut.iter().all(|p| p.is_finite()),
        "{cut:?}"
    );
}

#[test]
fn a_diagonal_through_two_vertices_puts_no_crossing() {
    let square = [
        v(0.0, 0.0, 0.0),
        v(4.0, 0.0, 0.0),
        v(4.0, 4.0, 0.0),
        v(0.0, 4.0, 0.0),
    ];
    let plane = Plane {
        normal: v(1.0, -1.0, 0.0),
        d: 0.0,
    };
    assert_eq!(clip_against_plane(&square, &plane), square[..3]);
}

#[test]
fn degenerate() {
    let triangle = [v(0.0, -1.0, 0.0), v(1.0, 1.0, 0.0), v(-1.0, 1.0, 0.0)];
    let ground = Plane::GROUND;
    assert_eq!(clip_against_plane(&[], &ground), []);
    assert_eq!(clip_against_plane(&triangle[..1], &ground), []);
    assert_eq!(clip_against_plane(&triangle[..2], &ground), []);
    assert_eq!(clip_against_plane(&[DVec3::Y; 5], &ground), []);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(
            clip_against_plane(&[triangle[0], triangle[1], v(bad, 1.0, 0.0)], &ground),
            []
        );
        assert_eq!(
            clip_against_plane(
                &triangle,
                &Plane {
                    normal: DVec3::Y,
                    d: bad
                }
            ),
            []
        );
        assert_eq!(clip_homogeneous(&[DVec4::splat(bad); 3], DVec4::Y), []);
    }
    // n·X + d = d everywhere: all or nothing, as `clip_against_line` and `cyrus_beck` have it.
    let no_plane = |d: f64| Plane {
        normal: DVec3::ZERO,
        d,
    };
    for d in [1.0, 0.0, -0.0, 5e-324] {
        assert_eq!(clip_against_plane(&triangle, &no_plane(d)), triangle);
    }
    for d in [-1.0, -5e-324, f64::NAN, f64::INFINITY] {
        assert_eq!(clip_against_plane(&triangle, &no_plane(d)), []);
    }
    let huge = f64::MAX;
    let cut = clip_against_plane(
        &[v(0.0, -huge, 0.0), v(huge, huge, 0.0), v(-huge, huge, 0.0)],
        &ground,
    );
    assert_eq!(cut.len(), 4);
    assert!(cut.iter().all(|p| p.is_finite() && p.y >= 0.0));
    // The crossings at ± half the smallest double both round to 0.
    let tiny = clip_against_plane(&triangle.map(|p| p * 5e-324), &ground);
    assert_eq!(
        tiny,
        [DVec3::ZERO, triangle[1] * 5e-324, triangle[2] * 5e-324]
    );
}

/// Numbers of which four times the product stays in range.
fn modest() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-8i32..9).prop_map(f64::from),
        -8.0..8.0f64,
        (-1.0..1.0f64, -100..100i32).prop_map(|(m, e)| libm::scalbn(m, e)),
    ]
}

fn polygon() -> impl Strategy<Value = Vec<DVec3>> {
    prop::collection::vec((-8i32..8, -8i32..8), 3..8).prop_map(|points| {
        points
            .into_iter()
            .map(|(x, y)| v(x.into(), y.into(), 0.0))
            .collect()
    })
}

proptest! {
    /// Area is additive whatever the shape: bridges have none. Exact up to the crossings' rounding.
    #[test]
    fn both_sides_together_are_the_whole(polygon in polygon(), n in (-5i32..6, -5i32..6), d in -9i32..9) {
        prop_assume!(n != (0, 0));
        let plane = Plane { normal: v(n.0.into(), n.1.into(), 0.0), d: d.into() };
        let (front, back) =
            (clip_against_plane(&polygon, &plane), clip_against_plane(&polygon, &plane.turned()));
        let rest = area(&polygon) - area(&front) - area(&back);
        // At most 16 crossings, each off by 4ε · 8, times the polygon's size of 16.
        prop_assert!(rest.abs() <= 16.0 * 4.0 * f64::EPSILON * 8.0 * 16.0);
        for p in front {
            let slack = 4.0 * f64::EPSILON * 8.0;
            prop_assert!(plane.signed_distance(p) >= -slack);
        }
    }

    #[test]
    fn crossings_keep_their_bounds(x in prop::collection::vec(modest(), 12), n in prop::array::uniform4(modest())) {
        let polygon: Vec<DVec4> = x.chunks_exact(4).map(DVec4::from_slice).collect();
        let n = DVec4::from(n);
        let side = |p: DVec4| (0..4).map(|k| r(n[k]) * r(p[k])).sum::<Exact>();
        let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        // Those that cross, inner end first.
        let crossing = |lifted: fn(DVec4) -> DVec4| -> Vec<[DVec4; 2]> {
            let sides = edges.clone().map(|(&a, &b)| [lifted(a), lifted(b)]);
            let inwards = sides.map(|[a, b]| if side(a) > 0 { [a, b] } else { [b, a] });
            inwards.filter(|&[a, b]| side(a) > 0 && side(b) < 0).collect()
        };

        // 3ε (|s_A B| + |s_B A|), the whole times some power of two.
        let edges_of_it = crossing(|p| p);
        for p in clip_homogeneous(&polygon, n) {
            let near = |&[a, b]: &[DVec4; 2]| {
                let (sa, sb) = (side(a), side(b));
                let top = incidence(n, a).max(-incidence(n, b));
                let scale = r(libm::scalbn(1.0, -libm::ilogb(top) - 2));
                (0..4).all(|k| {
                    let (of_b, of_a) = (&scale * &sa * r(b[k]), &scale * &sb * r(a[k]));
                    let bound = r(3.0 * f64::EPSILON) * (of_b.abs() + of_a.abs());
                    (r(p[k]) - (of_b - of_a)).abs() <= bound
                })
            };
            prop_assert!(polygon.contains(&p) || edges_of_it.iter().any(near), "{}", p);
        }

        // 4ε of the larger coordinate.
        let places: Vec<DVec3> = polygon.iter().map(|p| p.truncate()).collect();
        let edges_of_it = crossing(|p| point(p.truncate()));
        for p in clip_against_plane(&places, &Plane { normal: n.truncate(), d: n.w }) {
            let near = |&[a, b]: &[DVec4; 2]| {
                let (sa, sb) = (side(a), side(b));
                let t = sa.over(&(&sa - &sb)).unwrap();
                (0..3).all(|k| {
                    let exact = oracle::at(&t, a[k], b[k]);
                    (r(p[k]) - exact).abs() <= r(4.0 * f64::EPSILON * a[k].abs().max(b[k].abs()))
                })
            };
            prop_assert!(places.contains(&p) || edges_of_it.iter().any(near), "{}", p);
        }
    }

    #[test]
    fn crossings_with_a_line_are_nearest_doubles(polygon in oracle::polygon(), n in (-5i32..6, -5i32..6), at in 0usize..14, i in -2i64..3) {
        use crate::oracle::{beside, is_nearest};
        prop_assume!(n != (0, 0));
        let normal = DVec2::new(n.0.into(), n.1.into());
        // Through one of the vertices, or next to it.
        let through = polygon[at % polygon.len()];
        prop_assume!(through.length() < 1e300);
        let half = HalfPlane { normal, offset: beside(normal.dot(through), i) };
        let side = |p: DVec2| r(normal.x) * r(p.x) + r(normal.y) * r(p.y) - r(half.offset);
        let clipped = clip_against_line(&polygon, half);
        // What the plain method keeps, without rounding.
        let mut expected = Vec::new();
        for (k, &a) in polygon.iter().enumerate() {
            let b = polygon[(k + 1) % polygon.len()];
            let (s, t) = (side(a), side(b));
            let (a, b) = (exact(a).unwrap(), exact(b).unwrap());
            if s >= 0 {
                expected.push(a.clone());
            }
            if &s * &t < 0 {
                let share = s.over(&(&s - &t)).unwrap();
                expected.push([0, 1].map(|k| between(&share, &a[k], &b[k])));
            }
        }
        let near = |p: &DVec2, e: &[Exact; 2]| is_nearest(p.x, &e[0]) && is_nearest(p.y, &e[1]);
        prop_assert!(clipped.iter().all(|p| expected.iter().any(|e| near(p, e))));
        prop_assert!(clipped.is_empty() || expected.iter().all(|e| clipped.iter().any(|p| near(p, e))));
        if clipped.is_empty() {
            // Nothing but at most two different points, or points of the line.
            let off_the_line = polygon.iter().any(|&p| side(p) > 0);
            let close = |x: &Exact, y: &Exact| {
                let size = r(1e-12) * (x.squared() + y.squared() + r(1.0));
                (x - y).squared() <= size * r(1e-12)
            };
            let mut different: Vec<[Exact; 2]> = Vec::new();
            for e in expected {
                if !different.iter().any(|f| close(&e[0], &f[0]) && close(&e[1], &f[1])) {
                    different.push(e);
                }
            }
            prop_assert!(!off_the_line || different.len() < 3, "{different:?}");
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 16), n in 0usize..4) {
        let p4: Vec<_> = x.chunks_exact(4).map(DVec4::from_slice).collect();
        let p3: Vec<_> = p4.iter().map(|p| p.truncate()).collect();
        let plane = Plane { normal: p3[n], d: x[n] };
        prop_assert!(clip_against_plane(&p3, &plane).iter().all(|p| !p.is_nan()));
        let _ = clip_homogeneous(&p4, p4[n]);
        let p2: Vec<_> = p4.iter().map(|p| p.truncate().truncate()).collect();
        let half = HalfPlane { normal: p2[n], offset: x[n] };
        prop_assert!(clip_against_line(&p2, half).iter().all(|p| !p.is_nan()));
    }

    #[test]
    fn homogeneous_agrees_with_places(polygon in polygon(), n in (-5i32..6, -5i32..6), d in -9i32..9, k in 1i32..9) {
        prop_assume!(n != (0, 0));
        let plane = Plane { normal: v(n.0.into(), n.1.into(), 0.0), d: d.into() };
        let places = clip_against_plane(&polygon, &plane);
        let scaled: Vec<_> = polygon.iter().map(|&p| point(p) * f64::from(k)).collect();
        let homogeneous = clip_homogeneous(&scaled, plane.coefficients());
        let homogeneous: Vec<_> = homogeneous.iter().map(|p| p.truncate() / p.w).collect();
        // Where a polygon without area comes back along itself, one form may see two crossings and the other
        // one; the area is the same.
        let difference = area(&places) - area(&homogeneous);
        prop_assert!(difference.abs() <= 16.0 * 4.0 * f64::EPSILON * 8.0 * 16.0);
    }
}
