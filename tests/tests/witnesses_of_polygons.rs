//! Other crates as witnesses of polygons: hands that wrote the same answers independently of ours. Where a witness
//! differs, exact numbers say who is right, and what the witness gets wrong stands beside it.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use i_overlay::core::fill_rule::FillRule as OverlayFill;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use ombra_clip::{Window, pieces, sutherland_hodgman};
use ombra_math::glam::DVec2;
use ombra_oracle::Exact;
use ombra_raster::polygon::{FillRule, fill};
use ombra_tests::cases::Random;
use ombra_tests::clipping::doubled_area;

type Contour = Vec<[f64; 2]>;

fn contour(polygon: &[DVec2]) -> Contour {
    polygon.iter().map(|p| p.to_array()).collect()
}

fn overlay(
    a: &[Contour],
    b: &[Contour],
    rule: OverlayRule,
    fill: OverlayFill,
) -> Vec<Vec<Contour>> {
    a.to_vec().overlay_as::<i64>(&b.to_vec(), rule, fill)
}

/// The area of shapes with holes, each contour turning as it must, summed without rounding.
fn area(shapes: &[Vec<Contour>]) -> f64 {
    let contours: Vec<Vec<DVec2>> = (shapes.iter().flatten())
        .map(|contour| contour.iter().copied().map(DVec2::from).collect())
        .collect();
    signed_area(&contours).abs()
}

fn signed_area(polygons: &[Vec<DVec2>]) -> f64 {
    let doubled: Exact = polygons.iter().map(|p| doubled_area(p).unwrap()).sum();
    doubled.scaled(-1).nearest()
}

/// By how much two areas may differ: i_overlay puts vertices, given and new, on a grid of 2⁻⁶⁰ of the extent, and hands
/// them out as doubles, as ours are: some 2ε of the largest coordinate each, at most, along the whole boundary.
fn tolerance(polygon: &[DVec2]) -> f64 {
    let closed = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let perimeter: f64 = closed.map(|(p, q)| p.distance(*q)).sum();
    let largest = polygon
        .iter()
        .map(|p| p.abs().max_element())
        .fold(10.0, f64::max);
    // The window's own 40 of border may be boundary too.
    2.0 * f64::EPSILON * largest * (perimeter + 40.0)
}

/// A polygon that does not cross itself: corners in order of their angle about `centre`.
fn star_shaped(random: &mut Random, centre: DVec2, corners: u32, radius: f64) -> Vec<DVec2> {
    (0..corners)
        .map(|k| {
            let angle = std::f64::consts::TAU * (f64::from(k) + random.between(0.05, 0.95))
                / f64::from(corners);
            centre + DVec2::from_angle(angle) * radius * random.between(0.05, 1.0)
        })
        .collect()
}

/// Polygons that do not cross themselves: the area of the outline and of the pieces, and as many pieces as i_overlay
/// finds shapes.
#[test]
fn clipped_polygons_against_i_overlay() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let frame = [contour(&window.corners())];
    let mut random = Random::new(45);
    let (mut several, mut left) = (0, 0);
    for _ in 0..3000 {
        // Seen from a centre inside the window, nothing falls apart.
        let centre = DVec2::new(random.between(-8.0, 18.0), random.between(-8.0, 18.0));
        let corners = 3 + random.below(30);
        let mut polygon = star_shaped(&mut random, centre, corners, 18.0);
        let turn = if random.below(2) == 0 { 1.0 } else { -1.0 };
        if turn < 0.0 {
            polygon.reverse();
        }
        // Three corners may leave the centre outside and turn the other way.
        let turn = turn
            * if signed_area(&[polygon.clone()]) * turn < 0.0 {
                -1.0
            } else {
                1.0
            };
        let theirs = overlay(
            &[contour(&polygon)],
            &frame,
            OverlayRule::Intersect,
            OverlayFill::EvenOdd,
        );
        let bound = tolerance(&polygon);
        let parts = pieces::clip_polygon(&window, &polygon);
        let outline = sutherland_hodgman::clip_polygon(&window, &polygon);
        for ours in [&parts, &vec![outline]] {
            let off = (turn * signed_area(ours) - area(&theirs)).abs();
            assert!(off <= bound, "{polygon:?}: off {off:e}, bound {bound:e}");
        }
        assert_eq!(parts.len(), theirs.len(), "{polygon:?}");
        several += usize::from(parts.len() > 1);
        left += usize::from(!parts.is_empty());
    }
    assert!(several > 300 && left > 2500, "{several} {left}");
}

/// Polygons that cross themselves: by either rule, i_overlay finds no area between the outline, the pieces, and what
/// itself keeps of the polygon.
#[test]
fn self_crossing_polygons_against_i_overlay() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let frame = [contour(&window.corners())];
    let mut random = Random::new(46);
    let mut largest = 0.0_f64;
    for _ in 0..1000 {
        let corners = 4 + random.below(12);
        let polygon: Vec<DVec2> = (0..corners)
            .map(|_| DVec2::new(random.between(-8.0, 18.0), random.between(-8.0, 18.0)))
            .collect();
        // Crossings of the polygon with itself are rounded too, a handful of times at most.
        let bound = 4.0 * tolerance(&polygon);
        let parts = pieces::clip_polygon(&window, &polygon);
        let outline = sutherland_hodgman::clip_polygon(&window, &polygon);
        for rule in [OverlayFill::EvenOdd, OverlayFill::NonZero] {
            let theirs = overlay(&[contour(&polygon)], &frame, OverlayRule::Intersect, rule);
            let theirs: Vec<Contour> = theirs.into_iter().flatten().collect();
            for ours in [&parts, &vec![outline.clone()]] {
                let ours: Vec<Contour> = ours.iter().map(|p| contour(p)).collect();
                let between = area(&overlay(&ours, &theirs, OverlayRule::Xor, rule));
                assert!(
                    between <= bound,
                    "{rule:?} {polygon:?}: {between:e}, bound {bound:e}"
                );
                largest = largest.max(between);
            }
        }
    }
    // Rounding is there to be seen: the test does not compare a thing with itself.
    assert!(largest > 0.0);
}

/// What `i_overlay` gets wrong: its grid swallows what is thin against the extent of all that it is given.
#[test]
fn i_overlay_drops_slivers() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(1e9)).unwrap();
    let sliver = [(1.0, 1.0), (2.0, 1.0), (2.0, 1.0 + 1e-9)].map(DVec2::from);
    let theirs = overlay(
        &[contour(&sliver)],
        &[contour(&window.corners())],
        OverlayRule::Intersect,
        OverlayFill::EvenOdd,
    );
    assert!(area(&theirs) < 1e-10, "{theirs:?}");
    assert_eq!(sutherland_hodgman::clip_polygon(&window, &sliver), sliver);
    assert_eq!(pieces::clip_polygon(&window, &sliver), [sliver]);
}

/// `line-clipping`'s Sutherland–Hodgman as a second witness of outlines: the same signed area.
#[test]
fn outlines_against_line_clipping() {
    use line_clipping::{Point, Polygon, Window as Rectangle, sutherland_hodgman::clip_polygon};
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let mut random = Random::new(47);
    for _ in 0..3000 {
        let corners = 3 + random.below(20);
        let polygon: Vec<DVec2> = (0..corners)
            .map(|_| DVec2::new(random.between(-8.0, 18.0), random.between(-8.0, 18.0)))
            .collect();
        let given: Vec<Point> = polygon.iter().map(|p| Point::new(p.x, p.y)).collect();
        let theirs = clip_polygon(&Polygon::new(&given), Rectangle::new(0.0, 10.0, 0.0, 10.0));
        let theirs: Vec<DVec2> = theirs
            .vertices
            .iter()
            .map(|p| DVec2::new(p.x, p.y))
            .collect();
        let ours = sutherland_hodgman::clip_polygon(&window, &polygon);
        let off = (signed_area(&[ours]) - signed_area(&[theirs])).abs();
        // Up to four cuts of some roundings each, where ours have one.
        let bound = 8.0 * tolerance(&polygon);
        assert!(off <= bound, "{polygon:?}: off {off:e}, bound {bound:e}");
    }
}

/// Filled pixels count an area: i_overlay's, short of what the boundary's own pixels can add or take. Of those, an edge
/// passes through |dx| + |dy| + 3 at most, and centres fall on either side of it alike: what remains of n such pixels
/// grows with √n, and 2√n is over three times the largest that these polygons show.
#[test]
fn filled_pixels_against_i_overlay() {
    let size = 1024;
    let side = f64::from(size);
    let frame = [contour(
        &[(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(DVec2::from),
    )];
    let mut random = Random::new(48);
    let mut largest = 0.0_f64;
    for _ in 0..60 {
        let corners = 5 + random.below(8);
        let polygon: Vec<DVec2> = (0..corners)
            .map(|_| DVec2::new(random.between(-0.3, 1.3), random.between(-0.3, 1.3)) * side)
            .collect();
        let hole = star_shaped(&mut random, DVec2::splat(0.5 * side), 9, 0.4 * side);
        let contours = [polygon, hole];
        let boundary: f64 = contours
            .iter()
            .flat_map(|c| c.iter().zip(c.iter().cycle().skip(1)))
            .map(|(p, q)| (p - q).abs().element_sum() + 3.0)
            .sum();
        let subject: Vec<Contour> = contours.iter().map(|c| contour(c)).collect();
        for (ours, theirs) in [
            (FillRule::EvenOdd, OverlayFill::EvenOdd),
            (FillRule::NonZero, OverlayFill::NonZero),
        ] {
            let spans = fill(&contours, ours, size, size).unwrap();
            let count: f64 = spans.map(|span| f64::from(span.len())).sum();
            let area = area(&overlay(&subject, &frame, OverlayRule::Intersect, theirs));
            let off = (count - area).abs() / boundary.sqrt();
            assert!(
                off <= 2.0,
                "{ours:?} {contours:?}: {count} pixels, area {area}"
            );
            largest = largest.max(off);
        }
    }
    // Pixels are no area: the test does not compare a thing with itself.
    assert!(largest > 0.1, "{largest}");
}
