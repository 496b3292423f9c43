use super::*;
use crate::oracle::{self, Exact, beside, is_nearest, number, r};
use ombra_math::glam::DVec3;
use ombra_math::view::frustum;
use ombra_math::work::Work;
use proptest::prelude::*;

/// Both forms, which must agree.
fn clip_polygon<const N: usize>(polygon: &[Vertex<N>]) -> Vec<Vertex<N>> {
    clip_polygon_to(polygon, &ViewPlane::ALL)
}

fn clip_polygon_to<const N: usize>(polygon: &[Vertex<N>], planes: &[ViewPlane]) -> Vec<Vertex<N>> {
    let fast = super::clip_polygon_to(polygon, planes);
    let plain = clip_polygon_to_plain(polygon, planes, &mut ());
    let bits = |polygon: &[Vertex<N>]| -> Vec<_> {
        let bits = |v: &Vertex<N>| {
            (
                v.position.to_array().map(f64::to_bits),
                v.attributes.map(f64::to_bits),
            )
        };
        polygon.iter().map(bits).collect()
    };
    assert_eq!(bits(&fast), bits(&plain), "{polygon:?} {planes:?}");
    if planes == ViewPlane::ALL {
        assert_eq!(bits(&super::clip_polygon(polygon)), bits(&plain));
    }
    fast
}

fn v(x: f64, y: f64, z: f64, w: f64) -> DVec4 {
    DVec4::new(x, y, z, w)
}

#[test]
fn a_segment_that_passes_the_eye() {
    // Seen by an eye at the origin: from 10 in front, 5 above the axis, to 10 behind. Near plane at 1, far at 100.
    let view = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 100.0).unwrap();
    let ends = [DVec3::new(0.0, 5.0, -10.0), DVec3::new(0.0, -5.0, 10.0)];
    let [a, b] = ends.map(|p| view * p.extend(1.0));
    assert!(a.w > 0.0 && b.w < 0.0);
    let [c, d] = clip_segment([a, b]).unwrap();
    assert_eq!(c, a);
    assert_eq!(d.z, -d.w);
    // Through the eye itself, all of it projects to one point of the picture.
    assert!((d.y / d.w - a.y / a.w).abs() <= 4.0 * f64::EPSILON);
    // The vertex infinitely far away, (0, 0, −D, 0), in a projection to infinity is on the far plane, not beyond.
    let view = ombra_math::view::frustum_infinite(-1.0, 1.0, -1.0, 1.0, 1.0).unwrap();
    let infinite = view * v(0.0, 0.0, -3.0, 0.0);
    assert!(contains(infinite) && infinite.z == infinite.w);
}

#[test]
fn degenerate() {
    let (o, huge) = (v(0.0, 0.0, 0.0, 1.0), f64::MAX);
    let corner = v(1.0, 1.0, 1.0, 1.0);
    let cases = [
        ([o, o], Some([o, o])),
        ([corner, corner], Some([corner, corner])),
        ([-o, -o], None),
        ([DVec4::ZERO, o], None),
        // From a place to its opposite: all one place.
        ([o, -o], Some([o, o])),
        ([v(3.0, 0.0, 0.0, 1.0), v(-3.0, 0.0, 0.0, -1.0)], None),
        // To a point at infinity, from one at infinity.
        ([o, v(1.0, 0.0, 0.0, 0.0)], Some([o, v(0.5, 0.0, 0.0, 0.5)])),
        ([v(1.0, 0.0, 0.0, 0.0), v(-1.0, 0.0, 0.0, 0.0)], None),
        // Through an edge of the volume; past it by one double.
        (
            [v(0.0, 2.0, 0.0, 1.0), v(2.0, 0.0, 0.0, 1.0)],
            Some([v(1.0, 1.0, 0.0, 1.0); 2]),
        ),
        (
            [v(0.0, 2.0, 0.0, 1.0), v(2.0, f64::EPSILON, 0.0, 1.0)],
            None,
        ),
        (
            [v(-huge, 0.0, 0.0, 1.0), v(huge, 0.0, 0.0, 1.0)],
            Some([v(-1.0, 0.0, 0.0, 1.0), v(1.0, 0.0, 0.0, 1.0)]),
        ),
    ];
    for (s, expected) in cases {
        assert_eq!(clip_segment(s), expected, "{s:?}");
    }
    let with = |position| Vertex {
        position,
        attributes: [],
    };
    let triangle = [
        v(0.0, 0.0, 0.0, 1.0),
        v(1.0, 0.0, 0.0, 1.0),
        v(0.0, 1.0, 0.0, 1.0),
    ]
    .map(with);
    assert_eq!(clip_polygon(&triangle), triangle);
    assert_eq!(clip_polygon(&triangle[..2]), []);
    assert_eq!(clip_polygon::<3>(&[]), []);
    // It touches the volume along an edge.
    let beside = [
        v(1.0, 0.0, 0.0, 1.0),
        v(2.0, 0.0, 0.0, 1.0),
        v(1.0, 1.0, 0.0, 1.0),
    ]
    .map(with);
    assert_eq!(clip_polygon(&beside), []);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(clip_segment([o, v(0.0, 0.0, 0.0, bad)]), None);
        assert_eq!(clip_segment([v(bad, 0.0, 0.0, 1.0), o]), None);
        assert!(!contains(v(bad, 0.0, 0.0, 1.0)));
        assert_eq!(
            clip_polygon(&[triangle[0], triangle[1], with(v(bad, 0.0, 0.0, 1.0))]),
            []
        );
    }
    assert_eq!(
        clip_polygon(&[triangle[0], triangle[1], with(DVec4::ZERO)]),
        []
    );
    assert!(contains(o) && !contains(DVec4::ZERO) && !contains(-o));
}

/// Coordinates that often put a point on a plane, or next to one.
fn position() -> impl Strategy<Value = DVec4> {
    let w = prop_oneof![Just(1.0), Just(-1.0), Just(0.0), -4.0..4.0f64, number()];
    let of_w = prop::array::uniform3((0u8..6, number(), -2i64..3));
    (w, of_w).prop_map(|(w, of_w)| {
        let [x, y, z] = of_w.map(|(kind, x, i)| match kind {
            0 => beside(w, i),
            1 => -beside(w, i),
            2 => beside(2.0 * w, i),
            _ => x,
        });
        let p = DVec4::new(x, y, z, w);
        if p.is_finite() { p } else { DVec4::W }
    })
}

fn sides(a: DVec4, b: DVec4) -> Vec<[Exact; 2]> {
    let of = |p: DVec4| -> Vec<Exact> {
        let w = r(p.w);
        [p.x, p.y, p.z]
            .into_iter()
            .flat_map(|x| [&w - r(x), &w + r(x)])
            .collect()
    };
    of(a).into_iter().zip(of(b)).map(|(s, e)| [s, e]).collect()
}

fn vertex() -> impl Strategy<Value = Vertex<2>> {
    (prop::array::uniform4(-6i32..7), 0i32..9, 0i32..9).prop_map(|(p, s, t)| Vertex {
        position: DVec4::from(p.map(f64::from)),
        attributes: [s.into(), t.into()],
    })
}

#[test]
fn counts_its_work() {
    let count = |a, b| {
        let mut work = Work::default();
        let answer = counted::clip_segment([a, b], &mut work);
        assert_eq!(answer, clip_segment([a, b]));
        [work.comparisons, work.multiplications, work.divisions]
    };
    let inside = v(0.0, 0.0, 0.0, 1.0);
    // Twelve signs; beyond the near plane, the first that is asked, two.
    assert_eq!(count(inside, inside), [12, 0, 0]);
    assert_eq!(
        count(v(0.0, 0.0, -2.0, 1.0), v(0.0, 0.0, -3.0, 1.0)),
        [2, 0, 0]
    );
    // Out to the right; in at the left and out to the right, whose parameters are compared.
    assert_eq!(count(inside, v(2.0, 0.0, 0.0, 1.0)), [12, 0, 1]);
    assert_eq!(
        count(v(-2.0, 0.0, 0.0, 1.0), v(2.0, 0.0, 0.0, 1.0)),
        [13, 2, 2]
    );
    // Past the edge x = y = w: the exit is before the entry, and nothing is computed.
    assert_eq!(
        count(v(0.0, 2.5, 0.0, 1.0), v(2.5, 0.0, 0.0, 1.0)),
        [13, 2, 0]
    );

    let corner = |x: f64, y: f64| Vertex {
        position: v(x, y, 0.0, 1.0),
        attributes: [x],
    };
    let triangle = [corner(0.0, 0.0), corner(2.0, 0.0), corner(0.0, 0.5)];
    let mut work = Work::default();
    assert_eq!(
        counted::clip_polygon(&triangle, &mut work),
        clip_polygon(&triangle)
    );
    // Three corners at near, far, left and right, four below and above. At the right the second is found outside, then all
    // are asked; two crossings.
    assert_eq!(
        (work.vertices, work.comparisons, work.divisions),
        (4 * 3 + 2 * 4, 20 + 2, 2)
    );
    let mut work = Work::default();
    let _ = counted::clip_polygon_to(&triangle, &[ViewPlane::Near], &mut work);
    assert_eq!((work.vertices, work.comparisons, work.divisions), (3, 3, 0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn corners_are_nearest_doubles(positions in prop::collection::vec(position(), 3..7), attributes in prop::array::uniform7(number())) {
        let polygon: Vec<Vertex<1>> = positions
            .iter()
            .zip(attributes)
            .map(|(&position, x)| Vertex { position, attributes: [x] })
            .collect();
        prop_assume!(positions.iter().all(|&p| p != DVec4::ZERO));
        for plane in ViewPlane::ALL {
            let side = |v: &Vertex<1>| {
                let [w, x] = plane.terms(v.position);
                r(w) + r(x)
            };
            let next = polygon.iter().cycle().skip(1);
            let is_crossing = |v: &Vertex<1>| polygon.iter().zip(next.clone()).any(|(a, b)| {
                let (sa, sb) = (side(a), side(b));
                if &sa * &sb >= 0 {
                    return false;
                }
                let t = sa.over(&(&sa - &sb)).unwrap();
                (0..4).all(|k| is_nearest(v.position[k], &oracle::at(&t, a.position[k], b.position[k])))
                    && is_nearest(v.attributes[0], &oracle::at(&t, a.attributes[0], b.attributes[0]))
            });
            for v in clip_polygon_to(&polygon, &[plane]) {
                prop_assert!(polygon.contains(&v) || is_crossing(&v), "{:?} {:?}", plane, v);
            }
        }
    }

    #[test]
    fn segments_are_nearest_doubles(a in position(), b in position(), through in prop::array::uniform3(-1i32..2), i in -2i64..3, kind in 0u8..3) {
        // Two times in three through a corner, an edge or a face of the volume, or next to that.
        let [x, y, z] = through.map(f64::from);
        let beyond = DVec4::new(x, y, z, 1.0) * 2.0 - a;
        let beyond = DVec4::new(beside(beyond.x, i), beyond.y, beyond.z, beyond.w);
        let b = if kind > 0 && beyond.is_finite() { beyond } else { b };
        let expected = oracle::not_negative(&sides(a, b));
        let clipped = clip_segment([a, b]);
        let Some(t) = expected else {
            prop_assert_eq!(clipped, None);
            return Ok(());
        };
        let ends = t.map(|t| [0, 1, 2, 3].map(|k| oracle::at(&t, a[k], b[k])));
        let zero = |p: &[Exact; 4]| p.iter().all(|x| *x == 0);
        let Some(clipped) = clipped else {
            // Only (0, 0, 0, 0) is left.
            prop_assert!((zero(&ends[0]) && zero(&ends[1])) || a == DVec4::ZERO || b == DVec4::ZERO);
            return Ok(());
        };
        for (p, end) in clipped.iter().zip(&ends) {
            prop_assert!(contains(*p));
            for k in 0..4 {
                prop_assert!(zero(end) || is_nearest(p[k], &end[k]), "{} {}", p[k], end[k]);
            }
        }
        prop_assert!(!contains(a) || clipped[0] == a);
        prop_assert!(!contains(b) || clipped[1] == b);
        prop_assert_eq!(clip_segment(clipped), Some(clipped));
        prop_assert_eq!(clip_segment([b, a]), Some([clipped[1], clipped[0]]));
    }

    #[test]
    fn polygons_lie_in_the_volume(polygon in prop::collection::vec(vertex(), 3..7)) {
        let clipped = clip_polygon(&polygon);
        prop_assert!(clipped.iter().all(|v| contains(v.position)));
        prop_assert_eq!(clip_polygon(&clipped), clipped);
    }

    /// Attributes that are linear in the position stay that function of it, and the picture is the same as that
    /// of the plane Sutherland–Hodgman where all is in front of the eye.
    #[test]
    fn attributes_are_carried_along(mut triangle in prop::array::uniform3(vertex())) {
        let linear = |p: DVec4| [p.x + 2.0 * p.y - p.z + 3.0 * p.w, p.w];
        for v in &mut triangle {
            v.attributes = linear(v.position);
        }
        for v in clip_polygon(&triangle) {
            let expected = linear(v.position);
            // Up to 6 crossings in a row, each coordinate off by half an ulp of 6, with factors 1, 2, 1, 3, and the
            // attribute by half an ulp of 42.
            let bound = 6.0 * (7.0 * 3.0 + 21.0) * f64::EPSILON;
            for (x, e) in v.attributes.iter().zip(expected) {
                prop_assert!((x - e).abs() <= bound, "{x} {e}");
            }
        }
    }

    #[test]
    fn the_picture_is_that_of_the_plane_method(triangle in prop::array::uniform3((-6i32..7, -6i32..7))) {
        let flat = triangle.map(|(x, y)| ombra_math::glam::DVec2::new(f64::from(x) / 2.0, f64::from(y) / 2.0));
        let lifted = flat.map(|p| Vertex { position: DVec4::new(p.x, p.y, 0.0, 1.0), attributes: [] });
        let one = ombra_math::glam::DVec2::ONE;
        let window = crate::Window { min: -one, max: one };
        let expected = oracle::area(&crate::sutherland_hodgman::clip_polygon(&window, &flat));
        let picture: Vec<_> = clip_polygon(&lifted).iter().map(|v| v.position.truncate().truncate() / v.position.w).collect();
        let error = (oracle::area(&picture) - expected).abs();
        // Nine corners at most, each off by two roundings of numbers up to 1, times twice the size 2.
        prop_assert!(error <= r(9.0 * 2.0 * f64::EPSILON * 4.0));
    }

    #[test]
    fn triangles_that_share_an_edge_share_its_crossings(a in vertex(), b in vertex(), c in vertex(), d in vertex()) {
        // On the edge itself, crossings are those of a b, whichever way it runs.
        for plane in ViewPlane::ALL {
            let of = |p: &[Vertex<2>]| clip_polygon_to(p, &[plane]);
            let (s, e) = (plane.side(a.position), plane.side(b.position));
            let (one, other) = (of(&[a, b, c]), of(&[b, a, d]));
            if s * e < 0.0 && one.len() > 2 && other.len() > 2 {
                let (front, back) = if s > 0.0 { (a, b) } else { (b, a) };
                let shared = cut(plane, front, back);
                // Between a place and its opposite lies (0, 0, 0, 0), which is dropped.
                let dropped = shared.position == DVec4::ZERO;
                prop_assert!(dropped || (one.contains(&shared) && other.contains(&shared)));
            }
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 24)) {
        let p: Vec<DVec4> = x.chunks_exact(4).map(DVec4::from_slice).collect();
        if let Some(clipped) = clip_segment([p[0], p[1]]) {
            prop_assert!(clipped.iter().all(|&p| contains(p)), "{clipped:?}");
        }
        let polygon: Vec<_> = p.iter().map(|&position| Vertex { position, attributes: [x[0], x[5]] }).collect();
        prop_assert!(clip_polygon(&polygon).iter().all(|v| contains(v.position)));
    }
}

#[test]
fn no_corner_stands_twice() {
    let corner = |x: f64, y: f64, shade: f64| Vertex {
        position: DVec4::new(x, y, 0.0, 1.0),
        attributes: [shade],
    };
    let (a, b, c) = (
        corner(0.0, 0.0, 0.0),
        corner(0.5, 0.0, 0.0),
        corner(0.0, 0.5, 0.0),
    );
    assert_eq!(clip_polygon(&[a, b, b, c, a]), [a, b, c]);
    assert_eq!(clip_polygon(&[a, b, a, b]), [a, b, a, b]);
    assert_eq!(clip_polygon(&[a, b, b, a]), []);
    let other = corner(0.5, 0.0, 1.0);
    assert_eq!(clip_polygon(&[a, b, other, c]), [a, b, other, c]);
    // Corners so small that a crossing is rounded to (0, 0, 0, 0), with equal ones on both sides of it.
    let small = |x: f64, y: f64, z: f64, w: f64| Vertex {
        position: DVec4::new(x, y, z, w) * f64::from_bits(1),
        attributes: [],
    };
    let kept = small(0.0, -1.0, 1.0, 1.0);
    for between in [small(0.0, 0.0, 1.0, 0.0), small(0.0, 0.0, -1.0, -1.0)] {
        let clipped = clip_polygon(&[
            kept,
            between,
            kept,
            small(0.0, 1.0, 1.0, 1.0),
            small(1.0, 0.0, 0.0, 1.0),
        ]);
        assert!(
            clipped.windows(2).all(|pair| pair[0] != pair[1]),
            "{clipped:?}"
        );
    }
}
