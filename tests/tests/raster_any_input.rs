//! Any doubles and any integers, NaN, the infinities and the ends of i32 among them: every public function of the
//! raster crate answers, and none panics.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod any_input;

use core::ops::Range;

use any_input::{finite, number, point2, point3};
use ombra_math::glam::{DVec2, IVec2};
use ombra_math::work::Work;
use ombra_raster::buffers::image::Luma;
use ombra_raster::buffers::{self, StencilBuffer, U24};
use ombra_raster::polygon::{
    self, Crossing, Edge, FillRule, active_edges, edge_table, spans_between,
};
use ombra_raster::span::Span;
use ombra_raster::triangle::{self, EdgeRule};
use ombra_raster::{analytic, attributes, bresenham, dda, rectangle};
use proptest::prelude::*;

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
