use super::*;
use crate::extremes::lecture;
use crate::oracle::{beside, polygon, small_window};
use crate::sutherland_hodgman::clip_polygon_plain;
use crate::sutherland_hodgman::fast::clip_at;
use crate::window::Window;
use fearless_simd::{Fallback, Level, dispatch};
use ombra_math::work::Work;
use proptest::prelude::*;

type Answer = (Vec<[u64; 2]>, Work);

fn bits(points: &[DVec2]) -> Vec<[u64; 2]> {
    points
        .iter()
        .map(|p| p.to_array().map(f64::to_bits))
        .collect()
}

/// The fast form, through blocks or not.
#[inline(always)]
fn clip<S: Simd>(window: &Window, polygon: &[DVec2], blocks: Option<S>) -> Answer {
    let mut work = Work::default();
    let clipped = clip_at(blocks, window, polygon, &mut work);
    (bits(&clipped), work)
}

/// All ways, which must agree: points bit for bit, and counts.
fn agree(window: &Window, polygon: &[DVec2]) -> Vec<[u64; 2]> {
    let (expected, work) = clip(window, polygon, None::<Fallback>);
    let best = dispatch!(Level::new(), simd => clip(window, polygon, Some(simd)));
    let plain = clip_polygon_plain(window, polygon, &mut ());
    assert_eq!(bits(&plain), expected, "{polygon:?}");
    assert_eq!(best, (expected.clone(), work), "{polygon:?}");
    let fallback = clip(window, polygon, Some(Fallback::new()));
    assert_eq!(fallback, (expected.clone(), work), "{polygon:?}");
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(simd) = Level::new().as_sse4_2() {
        let answer = simd.vectorize(
            #[inline(always)]
            || clip(window, polygon, Some(simd)),
        );
        assert_eq!(answer, (expected.clone(), work), "{polygon:?}");
    }
    expected
}

/// Whether the edges between these vertices are done at once, in a polygon that comes from the middle of the window.
fn at_once(window: &Window, vertices: &Vertices) -> bool {
    let of = |p: DVec2| outcode(window, p);
    let middle = (window.min + window.max) / 2.0;
    let codes = [of(vertices[0]), of(vertices[EDGES])];
    let mut pipeline = Pipeline::new(window, EDGES);
    pipeline.start(middle, of(middle));
    pipeline.one_by_one(of(middle), &[middle, vertices[0]], &mut ());
    let lines = Lines::new(Fallback::new(), window);
    let regions = lines.regions(vertices, codes[0]);
    let mut room = [DVec2::ZERO; 2 * EDGES];
    assert!(regions.finite);
    pipeline.block(&lines, vertices, regions, codes, &mut room, &mut ())
}

/// Vertices of a block, by turns.
fn by_turns<const N: usize>(points: [(f64, f64); N]) -> Vertices {
    core::array::from_fn(|i| points[i % N].into())
}

#[test]
fn what_is_done_at_once() {
    let w = lecture();
    let done = |vertices: &Vertices| at_once(&w, vertices) && !agree(&w, vertices).is_empty();
    // All inside; in and out through a side, and through either side of a corner.
    assert!(done(&by_turns([(1.0, 1.0), (3.0, 1.0), (2.0, 3.0)])));
    for (x, y) in [
        (15.0, 5.0),
        (-5.0, 5.0),
        (5.0, 15.0),
        (5.0, -5.0),
        (15.0, 11.0),
        (11.0, 15.0),
        (-1.0, -5.0),
        (-5.0, -1.0),
        (15.0, -1.0),
        (-1.0, 15.0),
    ] {
        let turns = [(4.0, 6.0), (x, y), (5.0, 4.0), (x, y + 0.5)];
        assert!(done(&by_turns(turns)), "{x} {y}");
        // It begins outside, and stays there for an edge.
        let turns = [(x, y), (4.0, 6.0), (x, y + 0.25), (x, y + 0.5)];
        assert!(done(&by_turns(turns)), "{x} {y}");
    }
    // On the border, but not of the side that is crossed.
    assert!(done(&by_turns([(0.0, 4.0), (5.0, 15.0), (3.0, 3.0)])));
}

#[test]
fn what_wants_a_closer_look() {
    let w = lecture();
    let outside = |turns: &[(f64, f64)]| {
        let vertices: Vertices = core::array::from_fn(|i| turns[i % turns.len()].into());
        let _ = agree(&w, &vertices);
        !at_once(&w, &vertices)
    };
    // From outside through the window and beyond; outside, from region to region.
    assert!(outside(&[(-5.0, 5.0), (15.0, 5.0), (5.0, 5.0)]));
    assert!(outside(&[(5.0, 5.0), (5.0, 15.0), (15.0, 15.0)]));
    // Through a corner; next to it by one double.
    assert!(outside(&[(5.0, 5.0), (15.0, 15.0), (4.0, 5.0)]));
    assert!(outside(&[
        (5.0, 5.0),
        (15.0, 15.0_f64.next_up()),
        (4.0, 5.0)
    ]));
    // Out above the corner, in to the right of it.
    assert!(outside(&[(5.0, 5.0), (11.0, 15.0), (9.0, 1.0), (5.0, 4.0)]));
    // An end on the side that is crossed.
    assert!(outside(&[(10.0, 5.0), (15.0, 5.0), (5.0, 6.0)]));
    assert!(outside(&[(5.0, 5.0), (5.0, 15.0), (5.0, 10.0)]));
    // Halfway between two doubles.
    assert!(outside(&[
        (9.0, 1.0),
        (11.0, 1.0_f64.next_up()),
        (9.0, 2.0)
    ]));
    // Too large, too small.
    assert!(outside(&[
        (5.0, 5.0),
        (f64::MAX, f64::MAX / 2.0),
        (5.0, 6.0)
    ]));
    assert!(outside(&[(5.0, 0.0), (15.0, 1e-70), (5.0, 6.0)]));
}

#[test]
fn round_the_window_from_block_to_block() {
    // Out through the left side, round above, and in through the right one: two corners between.
    let mut polygon: Vec<DVec2> = (0..EDGES - 2)
        .map(|i| (5.0, 1.0 + i as f64 / 4.0).into())
        .collect();
    polygon.extend([(-15.0, 11.0), (5.0, 15.0)].map(DVec2::from));
    polygon.extend(by_turns([
        (25.0, 11.0),
        (5.0, 5.0),
        (25.0, 12.0),
        (4.0, 5.0),
    ]));
    let clipped = agree(&lecture(), &polygon);
    for corner in [[0.0, 10.0], [10.0, 10.0]] {
        assert!(clipped.contains(&corner.map(f64::to_bits)), "{corner:?}");
    }
}

#[test]
fn repeated_vertices_and_crossings() {
    let w = lecture();
    let inside = by_turns([(1.0, 1.0), (1.0, 1.0), (3.0, 1.0), (2.0, 3.0)]);
    assert!(at_once(&w, &inside));
    // 17 vertices; the second of each pair goes, and so does the last, which equals the first.
    assert_eq!(agree(&w, &inside).len(), 12);
    // Out and back along one line: the way out and the way in cross at the same point.
    let spikes = by_turns([(5.0, 5.0), (15.0, 6.0), (5.0, 5.0), (4.0, 4.0)]);
    assert!(at_once(&w, &spikes));
    // Of each four vertices, (5, 5), the crossing, (5, 5), (4, 4).
    assert_eq!(agree(&w, &spikes).len(), 16);
    // The same from block to block: the first ends outside.
    let mut long: Vec<DVec2> = (0..EDGES)
        .map(|i| DVec2::new(5.0, 1.0 + i as f64 / 8.0))
        .collect();
    long.extend([(15.0, 6.0), (5.0, 2.875)].map(DVec2::from));
    long.extend((0..EDGES).map(|i| DVec2::new(4.0, 2.875 - i as f64 / 8.0)));
    assert_eq!(agree(&w, &long).len(), 2 * EDGES + 2);
}

#[test]
fn degenerate() {
    let w = lecture();
    let star = by_turns([(5.0, 5.0), (15.0, 6.0), (4.0, 5.0), (5.0, -5.0)]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for at in 1..=EDGES {
            for p in [DVec2::new(bad, 5.0), DVec2::new(5.0, bad)] {
                let mut star = star;
                star[at] = p;
                let mut pipeline = Pipeline::new(&w, EDGES);
                let code = outcode(&w, star[0]);
                pipeline.start(star[0], code);
                assert!(
                    pipeline
                        .blocks(Fallback::new(), code, &star, &mut ())
                        .is_none()
                );
                assert_eq!(agree(&w, &star), [[0; 2]; 0], "{at} {p}");
            }
        }
    }
    let dot = by_turns([(5.0, 5.0)]);
    assert_eq!(agree(&w, &dot).len(), 0);
    let huge = f64::MAX;
    let wide = by_turns([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
    // Four times round, and back to the first corner.
    assert_eq!(agree(&w, &wide).len(), 16);
}

/// Polygons of a few blocks.
fn long_polygon() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec(polygon(), 3..9).prop_map(|parts| parts.concat())
}

/// In and out of `small_window`, many times through one side, with some corners moved to a grid or next to it.
fn comb() -> impl Strategy<Value = Vec<DVec2>> {
    let tooth = (0.0..6.0f64, 0.0..5.0f64, 0.0..1.0f64, 0u8..40, -2i64..3);
    (0usize..4, prop::collection::vec(tooth, 12..60)).prop_map(|(side, teeth)| {
        let outer = [(6.0, 0.0), (-6.0, 0.0), (0.0, 5.0), (0.0, -5.0)][side];
        let mut polygon: Vec<DVec2> = Vec::new();
        for (x, y, far, kind, ulps) in teeth {
            let inner = DVec2::new(x, y);
            let beyond = inner + DVec2::from(outer) * (1.0 + far);
            match kind {
                0 => polygon.extend([inner.round(), beyond]),
                1 => polygon.extend([inner, beyond.round()]),
                2 => polygon.extend([inner, beyond, inner]),
                3 => polygon.push(DVec2::new(beside(x.round(), ulps), beside(y.round(), ulps))),
                4..8 => polygon.push(inner),
                8..12 => polygon.extend([beyond, beyond + DVec2::splat(0.125)]),
                _ => polygon.extend([inner, beyond]),
            }
        }
        polygon
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn blocks_give_what_single_edges_do(polygon in prop_oneof![long_polygon(), comb()]) {
        let _ = agree(&small_window(), &polygon);
    }
}
