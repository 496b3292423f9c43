//! Any doubles and any integers, NaN, the infinities and the ends of i32 among them: every public function of the
//! raster and the clip crate answers, and none panics.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use core::ops::Range;

use ombra_clip::box3::{self, Box3};
use ombra_clip::cohen_sutherland::{self, Outcode};
use ombra_clip::homogeneous::{self, Vertex, ViewPlane};
use ombra_clip::sutherland_hodgman::{
    self, HalfPlane, clip_against_line, clip_against_plane, clip_by, clip_homogeneous,
};
use ombra_clip::window::Side;
use ombra_clip::{Segment, Window, crossing, cyrus_beck, direct, liang_barsky, pieces};
use ombra_math::glam::{DVec2, DVec3, DVec4, IVec2};
use ombra_math::plane::Plane;
use ombra_math::work::Work;
use ombra_raster::buffers::image::Luma;
use ombra_raster::buffers::{self, StencilBuffer, U24};
use ombra_raster::polygon::{
    self, Crossing, Edge, FillRule, active_edges, edge_table, spans_between,
};
use ombra_raster::span::Span;
use ombra_raster::triangle::{self, EdgeRule};
use ombra_raster::{analytic, attributes, bresenham, dda, rectangle};
use proptest::num::f64::ANY;
use proptest::prelude::*;

/// Any double, with those that decide something more often than their bits would be hit.
fn number() -> impl Strategy<Value = f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        0.5,
        1.0,
        -1.0,
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        f64::MIN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ]);
    prop_oneof![4 => ANY, 2 => special, 4 => -20.0..20.0]
}

fn point2() -> impl Strategy<Value = DVec2> {
    (number(), number()).prop_map(DVec2::from)
}

fn point3() -> impl Strategy<Value = DVec3> {
    (number(), number(), number()).prop_map(DVec3::from)
}

fn point4() -> impl Strategy<Value = DVec4> {
    (number(), number(), number(), number()).prop_map(DVec4::from)
}

/// Written by hand: min above max and NaN included.
fn window() -> impl Strategy<Value = Window> {
    (point2(), point2()).prop_map(|(min, max)| Window { min, max })
}

fn integer() -> impl Strategy<Value = i32> {
    let special = prop::sample::select(vec![0, 1, -1, i32::MIN, i32::MAX, i32::MIN + 1]);
    prop_oneof![4 => any::<i32>(), 2 => special, 4 => -20..20]
}

fn pixel() -> impl Strategy<Value = IVec2> {
    (integer(), integer()).prop_map(IVec2::from)
}

fn rule() -> impl Strategy<Value = FillRule> {
    prop::sample::select(vec![FillRule::EvenOdd, FillRule::NonZero])
}

fn polygons() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    prop::collection::vec(prop::collection::vec(point2(), 0..7), 0..4)
}

/// Pixels looked at of a segment, which may have 2³².
const FEW: usize = 50;

/// Counts the first few pixels.
fn look(mut pixels: impl Iterator<Item = IVec2>) -> usize {
    let _ = pixels.size_hint();
    pixels.by_ref().take(FEW).count()
}

fn finite(polygon: &[DVec2]) -> bool {
    polygon.iter().all(|p| p.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2048, ..ProptestConfig::default() })]

    #[test]
    fn segments_of_pixels(a in pixel(), b in pixel(), min in pixel(), max in pixel(), n in any::<usize>()) {
        let mut work = Work::default();
        let moves = u64::from(a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)));
        let expected = (moves + 1).min(FEW as u64) as usize;
        prop_assert_eq!(look(analytic::segment(a, b)), expected);
        prop_assert_eq!(look(analytic::counted::segment(a, b, &mut work)), expected);
        prop_assert_eq!(look(dda::segment(a, b)), expected);
        prop_assert_eq!(look(dda::counted::segment(a, b, &mut work)), expected);
        prop_assert_eq!(look(dda::segment_f32(a, b)), expected);
        prop_assert_eq!(look(dda::counted::segment_f32(a, b, &mut work)), expected);
        prop_assert_eq!(look(bresenham::segment(a, b)), expected);
        prop_assert_eq!(look(bresenham::counted::segment(a, b, &mut work)), expected);
        prop_assert_eq!(bresenham::segment(a, b).next(), Some(a));
        prop_assert_eq!(bresenham::segment(a, b).last(), Some(b));
        prop_assert_eq!(bresenham::segment(a, b).nth(moves as usize), Some(b));
        prop_assert_eq!(analytic::segment(a, b).nth(moves as usize), Some(b));
        for jump in [n, n >> 32, n >> 40] {
            let beyond = jump as u64 > moves;
            prop_assert_eq!(bresenham::segment(a, b).nth(jump).is_none(), beyond);
            prop_assert_eq!(analytic::segment(a, b).nth(jump).is_none(), beyond);
        }
        prop_assert_eq!(bresenham::trace(a, b).take(FEW).count() as u64, moves.min(FEW as u64));

        let inside = |p: IVec2| min.cmple(p).all() && p.cmple(max).all();
        prop_assert!(bresenham::clipped(a, b, min, max).take(FEW).all(inside));
        prop_assert!(bresenham::clipped(a, b, min, max).last().is_none_or(inside));
        look(bresenham::counted::clipped(a, b, min, max, &mut work));
        let _ = bresenham::clipped(a, b, min, max).nth(n);
        let _ = bresenham::clipped(a, b, min, max).trace().take(FEW).count();
    }

    #[test]
    fn drawing(a in pixel(), b in pixel(), len in 0_usize..300, width in prop_oneof![0_usize..40, any::<usize>()]) {
        let mut picture = vec![0_u8; len];
        bresenham::draw(&mut picture, width, a, b, 1);
        if let (Some(height), true) = (len.checked_div(width), width > 0) {
            let inside = |p: IVec2| p.cmpge(IVec2::ZERO).all() && (p.x as usize) < width && (p.y as usize) < height;
            let window = IVec2::new(width.min(300) as i32 - 1, height as i32 - 1);
            if height > 0 {
                let expected: Vec<IVec2> = bresenham::clipped(a, b, IVec2::ZERO, window).collect();
                prop_assert!(expected.iter().all(|&p| inside(p)));
                prop_assert_eq!(picture.iter().filter(|&&v| v == 1).count(), expected.len());
            } else {
                prop_assert!(picture.iter().all(|&v| v == 0));
            }
        }
    }

    #[test]
    fn outlines(min in pixel(), max in pixel(), vertices in prop::collection::vec(pixel(), 0..6), n in 0_usize..1000) {
        look(rectangle::outline(min, max));
        look(rectangle::fill(min, max));
        let _ = rectangle::fill(min, max).nth(n);
        prop_assert_eq!(polygon::outline(&vertices).next().is_none(), vertices.is_empty());
        look(polygon::outline(&vertices));
    }

    #[test]
    fn fills(contours in polygons(), rule in rule(), width in any::<u32>(), size in (0_u32..40, 0_u32..40)) {
        let finite = contours.iter().all(|c| finite(c));
        let (w, h) = size;
        match polygon::fill(&contours, rule, w, h) {
            Ok(spans) => {
                prop_assert!(finite);
                let spans: Vec<Span> = spans.collect();
                prop_assert!(spans.iter().all(|s| s.y < h && s.x.start < s.x.end && s.x.end <= w), "{:?}", spans);
                let mut plain = Vec::new();
                polygon::fill_plain(&contours, rule, w, h, &mut (), |span| plain.push(span)).unwrap();
                prop_assert_eq!(&plain, &spans);
                let mut work = Work::default();
                let counted = polygon::counted::fill(&contours, rule, w, h, &mut work).map(|s| s.collect::<Vec<_>>());
                prop_assert_eq!(counted, Ok(spans));
            }
            Err(why) => prop_assert!(!finite && !why.to_string().is_empty()),
        }
        // Columns to the end of u32; rows as far as can be waited for, each costing its crossings.
        for (width, height) in [(width, h), (w, 1000), (u32::MAX, 1000)] {
            if let Ok(spans) = polygon::fill(&contours, rule, width, height) {
                prop_assert!(spans.take(FEW).all(|s| s.y < height && s.x.end <= width));
            }
        }
        for height in [h, width, u32::MAX] {
            prop_assert_eq!(polygon::fill(&contours, rule, u32::MAX, height).is_ok(), finite);
            prop_assert_eq!(edge_table(&contours, height).is_ok(), finite);
        }
    }

    #[test]
    fn edges(from in point2(), to in point2(), height in any::<u32>(), row in any::<u32>(), width in any::<u32>(),
             rule in rule(), edges in prop::collection::vec((point2(), point2()), 0..5),
             crossings in prop::collection::vec((any::<usize>(), number(), any::<u32>(), any::<i32>()), 0..5),
             winding in any::<i64>()) {
        if let Some(edge) = Edge::new(from, to, height) {
            prop_assert!(edge.rows.start < edge.rows.end && edge.rows.end <= height);
            prop_assert!(edge.column(edge.rows.start, width) <= width);
        }
        // Records written by hand too.
        let by_hand = |&(top, bottom): &(DVec2, DVec2)| Edge { top, bottom, winding: 1, rows: 0..u32::MAX };
        for edge in edges.iter().map(by_hand) {
            prop_assert!(edge.column(row, width) <= width);
            let _ = (edge.has_on_left(width, row), edge.x(row));
        }
        let mut table: Vec<Edge> = edges.iter().map(by_hand).collect();
        prop_assert!(active_edges(&table, row, width).iter().all(|c| c.column <= width));
        table.iter_mut().for_each(|edge| edge.rows = Range { start: row, end: height });
        let _ = active_edges(&table, row, width);
        let crossings: Vec<Crossing> = crossings
            .into_iter()
            .map(|(edge, x, column, winding)| Crossing { edge, x, column, winding })
            .collect();
        prop_assert!(spans_between(&crossings, rule, width).iter().all(|x| x.start < x.end && x.end <= width));
        let _ = rule.contains(winding);
    }

    #[test]
    fn triangles(t in prop::array::uniform3(point2()), p in point2(), width in any::<u32>(),
                 size in (0_u32..40, 0_u32..40), bits in any::<u32>()) {
        let finite = finite(&t);
        let (w, h) = size;
        let cover = triangle::cover(t, w, h).map(|spans| spans.collect::<Vec<_>>());
        prop_assert_eq!(cover.is_ok(), finite);
        match cover {
            Ok(spans) => {
                prop_assert!(spans.iter().all(|s| s.y < h && s.x.start < s.x.end && s.x.end <= w), "{:?}", spans);
                let mut plain = Vec::new();
                triangle::cover_plain(t, EdgeRule::TopLeft, w, h, &mut (), |p| plain.push(p)).unwrap();
                prop_assert!(spans.iter().flat_map(Span::pixels).eq(plain));
                for span in &spans {
                    if let Some(weights) = attributes::along(t, span) {
                        prop_assert_eq!(weights.count(), span.len() as usize);
                    }
                }
            }
            Err(why) => prop_assert!(!why.to_string().is_empty()),
        }
        for rule in [EdgeRule::TopLeft, EdgeRule::Closed, EdgeRule::Open] {
            prop_assert_eq!(triangle::cover_plain(t, rule, w, h, &mut (), drop).is_ok(), finite);
            prop_assert!(!triangle::contains(t, p, rule) || (finite && p.is_finite()));
        }
        for (width, height) in [(width, h), (w, 1000), (u32::MAX, 1000)] {
            if let Ok(spans) = triangle::cover(t, width, height) {
                prop_assert!(spans.take(FEW).all(|s| s.y < height && s.x.end <= width));
            }
        }
        let _ = (triangle::edge_function(t[0], t[1], p), triangle::is_top_left(t[0], t[1]));
        for bits in [bits, bits % 64] {
            let snapped = triangle::snap(p, bits);
            prop_assert!(!p.is_finite() || snapped.is_finite(), "{} {}", p, snapped);
        }
    }

    #[test]
    fn attributes_of_pixels(t in prop::array::uniform3(point2()), p in point2(), weights in point3(),
                            values in prop::array::uniform3(number()), w in prop::array::uniform3(number()),
                            y in any::<u32>(), x in (any::<u32>(), any::<u32>())) {
        if let Some(weights) = attributes::weights(t, p) {
            prop_assert!(weights.is_finite());
        }
        let span = Span { y, x: x.0..x.1 };
        prop_assert_eq!(span.len(), x.1.saturating_sub(x.0));
        prop_assert_eq!(span.is_empty(), x.1 <= x.0);
        prop_assert_eq!(span.pixels().take(FEW).count(), (span.len() as usize).min(FEW));
        if let Some(weights) = attributes::along(t, &span) {
            let _ = weights.take(FEW).count();
        }
        let _ = attributes::linear(weights, values);
        if let Some(weights) = attributes::perspective_weights(weights, w) {
            prop_assert!(w.iter().all(|&w| w > 0.0), "{:?} {}", w, weights);
        }
        let _ = attributes::perspective(weights, values, w);
    }

    #[test]
    fn pixel_buffers(small in (0_u32..40, 0_u32..40), huge in (1_u32 << 16..=u32::MAX, 1_u32 << 16..=u32::MAX),
                     y in any::<u32>(), x in (any::<u32>(), any::<u32>()), near in (0_u32..50, 0_u32..50, 0_u32..50)) {
        prop_assert!(buffers::new(huge.0, huge.1, Luma([0_u8])).is_err_and(|why| !why.to_string().is_empty()));
        let Ok(mut buffer): Result<StencilBuffer, _> = buffers::new(small.0, small.1, Luma([0])) else {
            return Err(TestCaseError::fail("a small buffer"));
        };
        for span in [Span { y, x: x.0..x.1 }, Span { y: near.0, x: near.1..near.2 }] {
            // One that runs backwards has no pixel and may be refused.
            let inside = span.y < small.1 && span.x.start <= span.x.end && span.x.end <= small.0;
            let painted = buffers::paint(&mut buffer, [span.clone()], Luma([1]));
            prop_assert!(painted.is_ok() || !inside, "{:?}", painted);
            prop_assert!(painted.is_err() || inside || span.is_empty(), "{:?}", span);
        }
        prop_assert_eq!(U24::new(y).map(U24::get), (y < 1 << 24).then_some(y));
    }

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

#[test]
fn a_wide_buffer_without_rows_has_no_span() {
    use ombra_raster::buffers::image::Rgba;
    let mut buffer = buffers::new(u32::MAX, 0, Rgba([0_u8; 4])).unwrap();
    let span = Span {
        y: u32::MAX,
        x: 0..1,
    };
    assert!(buffers::paint(&mut buffer, [span], Rgba([1; 4])).is_err());
}

#[test]
fn a_span_that_runs_backwards_is_empty() {
    let mut buffer: StencilBuffer = buffers::new(26, 24, Luma([0])).unwrap();
    let span = Span {
        y: 0,
        x: Range { start: 13, end: 0 },
    };
    assert!(span.is_empty() && buffers::paint(&mut buffer, [span], Luma([1])).is_ok());
}
