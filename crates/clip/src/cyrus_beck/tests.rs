use super::*;
use crate::oracle::{self, Exact, beside, is_nearest, r, window_and_segment};
use crate::{Window, liang_barsky};
use ombra_math::double_double::DoubleDouble;
use proptest::prelude::*;

fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::new(a.into(), b.into())
}

#[test]
fn the_lectures_segments() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))
        .unwrap()
        .corners();
    let mut clockwise = window;
    clockwise.reverse();
    for corners in [window, clockwise] {
        let clip = |s| clip_segment(&corners, s);
        assert_eq!(
            clip(segment((2.0, 14.0), (8.0, -4.0))),
            Some(segment((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)))
        );
        assert_eq!(clip(segment((4.0, 14.0), (14.0, 8.0))), None);
    }
}

#[test]
fn degenerate() {
    let triangle = [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(DVec2::from);
    let cases = [
        // Along a side, through a corner, touching a corner, a point.
        (
            segment((-5.0, 14.0), (14.0, -5.0)),
            Some(segment((0.0, 9.0), (9.0, 0.0))),
        ),
        (
            segment((-3.0, -3.0), (9.0, 9.0)),
            Some(segment((0.0, 0.0), (4.5, 4.5))),
        ),
        (
            segment((0.0, 18.0), (0.0, 9.0)),
            Some(segment((0.0, 9.0), (0.0, 9.0))),
        ),
        (
            segment((-9.0, 0.0), (9.0, 18.0)),
            Some(segment((0.0, 9.0), (0.0, 9.0))),
        ),
        (segment((-9.0, 0.0), (9.0, 18.0_f64.next_up())), None),
        (
            segment((3.0, 3.0), (3.0, 3.0)),
            Some(segment((3.0, 3.0), (3.0, 3.0))),
        ),
        (segment((5.0, 5.0), (5.0, 5.0)), None),
        (
            segment((-f64::MAX, 3.0), (f64::MAX, 3.0)),
            Some(segment((0.0, 3.0), (6.0, 3.0))),
        ),
    ];
    for (s, expected) in cases {
        assert_eq!(clip_segment(&triangle, s), expected, "{s:?}");
        let in_range = s.a.x.abs() < f64::MAX;
        assert!(
            !in_range || clip_segment_plain(&triangle, s, &mut ()) == expected,
            "{s:?}"
        );
    }
    let s = segment((1.0, 1.0), (2.0, 1.0));
    for flat in [
        &triangle[..0],
        &triangle[..1],
        &triangle[..2],
        &[DVec2::ONE; 5],
    ] {
        assert_eq!(clip_segment(flat, s), None);
        assert_eq!(clip_segment_plain(flat, s, &mut ()), None);
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let spoilt = [triangle[0], triangle[1], DVec2::new(0.0, bad)];
        assert_eq!(clip_segment(&spoilt, s), None);
        assert_eq!(clip_segment_plain(&spoilt, s, &mut ()), None);
        assert_eq!(
            clip_segment(&triangle, segment((bad, 1.0), (2.0, 1.0))),
            None
        );
        let spoilt = Plane {
            normal: DVec3::Y,
            d: bad,
        };
        assert_eq!(clip_segment_3d(&[spoilt], [DVec3::ZERO, DVec3::Y]), None);
        assert_eq!(clip_segment_3d(&[], [DVec3::splat(bad), DVec3::Y]), None);
    }
    assert_eq!(
        clip_segment_3d(&[], [DVec3::ZERO, DVec3::Y]),
        Some([DVec3::ZERO, DVec3::Y])
    );
    // A wedge of no thickness, met along its edge.
    let (ground, below) = (Plane::GROUND, Plane::GROUND.turned());
    let upright = [-DVec3::Y, DVec3::Y];
    assert_eq!(
        clip_segment_3d(&[ground, below], upright),
        Some([DVec3::ZERO; 2])
    );
}

#[test]
fn counts_intersections() {
    let mut work = ombra_math::work::Work::default();
    let triangle = [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(DVec2::from);
    let _ = counted::clip_segment(&triangle, segment((-1.0, 3.0), (10.0, 3.0)), &mut work);
    assert_eq!(work.divisions, 2);
}

/// The convex hull of some grid points, counter-clockwise.
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    points.dedup();
    let mut hull: Vec<DVec2> = Vec::new();
    for pass in 0..2 {
        let from = hull.len();
        for &p in &points {
            while hull.len() >= from + 2 && {
                let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                (b - a).perp_dot(p - b) <= 0.0
            } {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        if pass == 0 {
            points.reverse();
        }
    }
    hull
}

fn plane() -> impl Strategy<Value = Plane> {
    (-3i32..4, -3i32..4, -3i32..4, -6i32..7).prop_map(|(x, y, z, d)| Plane {
        normal: DVec3::new(x.into(), y.into(), z.into()),
        d: d.into(),
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn agrees_with_a_window((w, s) in window_and_segment()) {
        prop_assume!(w.min.x < w.max.x && w.min.y < w.max.y);
        prop_assert_eq!(clip_segment(&w.corners(), s), liang_barsky::clip_segment(&w, s));
    }

    #[test]
    fn convex_polygons(polygon in oracle::grid_polygon(), a in oracle::point(), k in 0usize..20, t in 0.0..3.0f64, i in -2i64..3) {
        let polygon = hull(polygon);
        prop_assume!(polygon.len() > 2);
        // Through a corner, or nearly.
        let corner = polygon[k % polygon.len()];
        let b = corner + (corner - a) * t;
        let b = if b.is_finite() { DVec2::new(beside(b.x, i), b.y) } else { corner };
        let s = Segment::new(a, b);
        let sides: Vec<[Exact; 2]> = edges(&polygon).map(|(p, q)| [a, b].map(|x| {
            (r(q.x) - r(p.x)) * (r(x.y) - r(p.y)) - (r(q.y) - r(p.y)) * (r(x.x) - r(p.x))
        })).collect();
        let expected = oracle::not_negative(&sides);
        let clipped = clip_segment(&polygon, s);
        let in_range = [a.x, a.y, b.x, b.y].into_iter().all(DoubleDouble::in_range);
        prop_assert!(!in_range || clip_segment_plain(&polygon, s, &mut ()) == clipped);
        prop_assert_eq!(clipped.is_some(), expected.is_some());
        if let (Some(clipped), Some(t)) = (clipped, expected) {
            for (p, t) in [clipped.a, clipped.b].iter().zip(&t) {
                prop_assert!(is_nearest(p.x, &oracle::at(t, a.x, b.x)));
                prop_assert!(is_nearest(p.y, &oracle::at(t, a.y, b.y)));
            }
            prop_assert!(t[0] > 0 || clipped.a == a);
            prop_assert!(t[1] < 1 || clipped.b == b);
        }
        let mut clockwise = polygon.clone();
        clockwise.reverse();
        prop_assert_eq!(clip_segment(&clockwise, s), clipped);
        prop_assert_eq!(clip_segment(&polygon, s.reversed()), clipped.map(Segment::reversed));
    }

    #[test]
    fn polyhedra(planes in prop::collection::vec(plane(), 1..7), x in prop::array::uniform6(-9i32..10), ulps in prop::array::uniform6(-2i64..3)) {
        // Small integers meet many edges and corners exactly; a few ulps off they do not.
        let y: Vec<f64> = x.iter().zip(ulps).map(|(&x, i)| beside(x.into(), i)).collect();
        let (a, b) = (DVec3::new(y[0], y[1], y[2]), DVec3::new(y[3], y[4], y[5]));
        let side = |p: &Plane, x: DVec3| {
            r(p.normal.x) * r(x.x) + r(p.normal.y) * r(x.y) + r(p.normal.z) * r(x.z) + r(p.d)
        };
        let sides: Vec<[Exact; 2]> = planes.iter().map(|p| [side(p, a), side(p, b)]).collect();
        let expected = oracle::not_negative(&sides);
        let clipped = clip_segment_3d(&planes, [a, b]);
        prop_assert_eq!(clipped.is_some(), expected.is_some());
        if let (Some(clipped), Some(t)) = (clipped, expected) {
            for (p, t) in clipped.iter().zip(&t) {
                for k in 0..3 {
                    prop_assert!(is_nearest(p[k], &oracle::at(t, a[k], b[k])));
                }
            }
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 16), n in 0usize..7) {
        let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
        let _ = clip_segment(&p[..n], Segment::new(p[6], p[7]));
        let _ = clip_segment_plain(&p[..n], Segment::new(p[6], p[7]), &mut ());
        let v: Vec<DVec3> = x.chunks_exact(3).map(DVec3::from_slice).collect();
        let planes = [Plane { normal: v[0], d: x[15] }, Plane { normal: v[1], d: x[0] }, Plane { normal: v[2], d: x[1] }];
        let _ = clip_segment_3d(&planes, [v[3], v[4]]);
    }
}
