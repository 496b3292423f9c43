//! Any doubles, NaN and the infinities among them: every public function of the
//! clip crate answers, and none panics.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod any_input;

use any_input::{finite, number, point2, point3};
use ombra_clip::box3::{self, Box3};
use ombra_clip::cohen_sutherland::{self, Outcode};
use ombra_clip::homogeneous::{self, Vertex, ViewPlane};
use ombra_clip::sutherland_hodgman::{
    self, HalfPlane, clip_against_line, clip_against_plane, clip_by, clip_homogeneous,
};
use ombra_clip::window::Side;
use ombra_clip::{Segment, Window, crossing, cyrus_beck, direct, liang_barsky, pieces};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::work::Work;
use proptest::prelude::*;

fn point4() -> impl Strategy<Value = DVec4> {
    (number(), number(), number(), number()).prop_map(DVec4::from)
}

/// Written by hand: min above max and NaN included.
fn window() -> impl Strategy<Value = Window> {
    (point2(), point2()).prop_map(|(min, max)| Window { min, max })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2048, ..ProptestConfig::default() })]

    #[test]
    fn segments_against_windows(w in window(), a in point2(), b in point2(), x in number()) {
        let s = Segment::new(a, b);
        let mut work = Work::default();
        let answer = direct::clip_segment(&w, s);
        prop_assert!(answer.is_none_or(|s| w.contains(s.a) && w.contains(s.b)), "{:?}", answer);
        prop_assert!(answer.is_none() || (s.is_finite() && !w.is_empty()));
        prop_assert_eq!(direct::counted::clip_segment(&w, s, &mut work), answer);
        prop_assert_eq!(cohen_sutherland::clip_segment(&w, s), answer);
        prop_assert_eq!(cohen_sutherland::counted::clip_segment(&w, s, &mut work), answer);
        prop_assert_eq!(cohen_sutherland::clip_segment_plain(&w, s, &mut work), answer);
        prop_assert_eq!(liang_barsky::clip_segment(&w, s), answer);
        prop_assert_eq!(liang_barsky::counted::clip_segment(&w, s, &mut work), answer);
        prop_assert_eq!(cohen_sutherland::trace(&w, s).is_empty(), !s.is_finite() || w.is_empty());
        prop_assert_eq!(cohen_sutherland::outcode(&w, a).is_inside(), w.contains(a));
        let code = cohen_sutherland::outcode(&w, a);
        for side in Side::ALL {
            prop_assert_eq!(code.has(side), (code & Outcode::of(side)) != Outcode::INSIDE);
        }
        prop_assert!(code.bits() < 16 && code.to_string().len() == 4);
        if let Err(why) = Window::new(w.min, w.max) {
            prop_assert!(!why.to_string().is_empty());
        }
        prop_assert_eq!(s.reversed().reversed().a.to_array().map(f64::to_bits), a.to_array().map(f64::to_bits));
        for crossed in [crossing::at_x(s, x), crossing::at_y(s, x)] {
            prop_assert!(crossed.is_none_or(f64::is_finite));
        }
        let _ = w.corners();
    }

    #[test]
    fn segments_against_convex(polygon in prop::collection::vec(point2(), 0..7), a in point2(), b in point2(),
                               planes in prop::collection::vec((point3(), number()), 0..6),
                               p in point3(), q in point3(), min in point3(), max in point3()) {
        let s = Segment::new(a, b);
        let mut work = Work::default();
        let answer = cyrus_beck::clip_segment(&polygon, s);
        prop_assert!(answer.is_none_or(Segment::is_finite));
        prop_assert_eq!(cyrus_beck::counted::clip_segment(&polygon, s, &mut work), answer);
        let planes: Vec<Plane> = planes.into_iter().map(|(normal, d)| Plane { normal, d }).collect();
        let answer = cyrus_beck::clip_segment_3d(&planes, [p, q]);
        prop_assert!(answer.is_none_or(|s| s.iter().all(|p| p.is_finite())));
        prop_assert_eq!(cyrus_beck::counted::clip_segment_3d(&planes, [p, q], &mut work), answer);

        let bounds = Box3 { min, max };
        let answer = box3::clip_segment(&bounds, [p, q]);
        prop_assert!(answer.is_none_or(|s| s.iter().all(|&p| bounds.contains(p))), "{:?}", answer);
        prop_assert_eq!(box3::counted::clip_segment(&bounds, [p, q], &mut work), answer);
        let code = box3::outcode(&bounds, p);
        prop_assert_eq!(code.is_inside(), bounds.contains(p));
        prop_assert!(code.bits() < 64 && code.to_string().len() == 6);
        if let Err(why) = Box3::new(min, max) {
            prop_assert!(!why.to_string().is_empty());
        }
    }

    #[test]
    fn polygons_against_windows(w in window(), polygon in prop::collection::vec(point2(), 0..9), normal in point2(),
                                offset in number()) {
        let mut work = Work::default();
        let outline = sutherland_hodgman::clip_polygon(&w, &polygon);
        prop_assert!(outline.iter().all(|&p| w.contains(p)), "{:?}", outline);
        prop_assert_eq!(&sutherland_hodgman::counted::clip_polygon(&w, &polygon, &mut work), &outline);
        prop_assert_eq!(&sutherland_hodgman::clip_polygon_plain(&w, &polygon, &mut work), &outline);
        let parts = pieces::clip_polygon(&w, &polygon);
        prop_assert!(parts.iter().flatten().all(|&p| w.contains(p)), "{:?}", parts);
        prop_assert_eq!(&pieces::counted::clip_polygon(&w, &polygon, &mut work), &parts);
        for result in parts.iter().chain([&outline]) {
            let repeated = result.iter().zip(result.iter().cycle().skip(1)).any(|(p, q)| p == q);
            prop_assert!((result.is_empty() || result.len() >= 3) && !repeated, "{:?}", result);
        }
        let half = HalfPlane { normal, offset };
        prop_assert!(finite(&clip_against_line(&polygon, half)));
        prop_assert!(polygon.iter().all(|&p| p.is_finite() || !half.contains(p)));
        // What `side` says need not even be of one mind with itself.
        let kept = clip_by(&polygon, |p| p.x * p.y - offset, |p, q, _, _| p.midpoint(q));
        prop_assert!(kept.is_empty() || kept.len() >= 3);
    }

    #[test]
    fn polygons_in_space(polygon in prop::collection::vec((point4(), number()), 0..7), plane in point4(),
                         planes in prop::sample::subsequence(ViewPlane::ALL.to_vec(), 0..=6)) {
        let vertices: Vec<Vertex<1>> = polygon
            .iter()
            .map(|&(position, attribute)| Vertex { position, attributes: [attribute] })
            .collect();
        let clipped = homogeneous::clip_polygon(&vertices);
        prop_assert!(clipped.iter().all(|v| homogeneous::contains(v.position) && v.position.w > 0.0), "{:?}", clipped);
        let mut work = Work::default();
        let counted = homogeneous::counted::clip_polygon_to(&vertices, &planes, &mut work);
        let bits = |polygon: &[Vertex<1>]| -> Vec<_> {
            polygon.iter().map(|v| (v.position.to_array().map(f64::to_bits), v.attributes[0].to_bits())).collect()
        };
        prop_assert_eq!(bits(&counted), bits(&homogeneous::clip_polygon_to(&vertices, &planes)));
        if let [(a, _), (b, _), ..] = polygon[..] {
            let answer = homogeneous::clip_segment([a, b]);
            prop_assert!(answer.is_none_or(|s| s.iter().all(|&p| homogeneous::contains(p))), "{:?}", answer);
            prop_assert_eq!(homogeneous::counted::clip_segment([a, b], &mut work), answer);
            for plane in ViewPlane::ALL {
                let _ = plane.terms(a);
            }
        }
        let homogeneous: Vec<DVec4> = polygon.iter().map(|v| v.0).collect();
        let _ = clip_homogeneous(&homogeneous, plane);
        let places: Vec<DVec3> = homogeneous.iter().map(|p| p.truncate()).collect();
        let normal = plane.truncate();
        let cut = clip_against_plane(&places, &Plane { normal, d: plane.w });
        prop_assert!(cut.iter().all(|p| p.is_finite()), "{:?}", cut);
    }
}

// Distances here run from 4 to beyond the doubles, where a quotient of two of them would be NaN.
#[test]
fn distances_from_a_plane_may_overflow() {
    let plane = Plane {
        normal: DVec3::new(-16.0, -7.0, 0.0),
        d: 4.0,
    };
    let triangle = [
        DVec3::new(f64::MAX, f64::MAX, 0.0),
        DVec3::ZERO,
        DVec3::new(-1.0, 0.0, 0.0),
    ];
    let cut = clip_against_plane(&triangle, &plane);
    assert!(
        cut.len() == 4 && cut.iter().all(|p| p.is_finite()),
        "{cut:?}"
    );
}
