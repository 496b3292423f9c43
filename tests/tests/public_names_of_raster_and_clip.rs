//! The public names of rasterization and clipping, each called as someone outside would call it who has only the list of
//! names and shapes: types are written out, so that a changed shape does not compile, and each answer is one that can be
//! seen by hand.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fmt::{Debug, Display};
use std::ops::Range;

use ombra_clip::{
    Segment, Window, WindowError, box3, cohen_sutherland, cyrus_beck, direct, homogeneous,
    liang_barsky, pieces, sutherland_hodgman,
};
use ombra_math::glam::{DVec2, DVec3, DVec4, IVec2};
use ombra_math::plane::Plane;
use ombra_raster::span::Span;
use ombra_raster::{analytic, bresenham, dda, polygon, rectangle, triangle};

fn pixels(pixels: impl Iterator<Item = IVec2>) -> Vec<(i32, i32)> {
    pixels.map(|p| (p.x, p.y)).collect()
}

fn lit(spans: impl Iterator<Item = Span>) -> Vec<(u32, Range<u32>)> {
    spans.map(|Span { y, x }| (y, x)).collect()
}

/// What every error is.
fn is_an_error<E: core::error::Error + Display + Copy + PartialEq + Debug>(error: E) -> String {
    error.to_string()
}

#[test]
fn rasterization() {
    let (a, b) = (IVec2::new(0, 0), IVec2::new(2, 1));
    let nearest = [(0, 0), (1, 0), (2, 1)];
    assert_eq!(pixels(analytic::segment(a, b)), nearest);
    assert_eq!(pixels(dda::segment(a, b)), nearest);
    assert_eq!(pixels(dda::segment_f32(a, b)), nearest);
    assert_eq!(pixels(bresenham::segment(a, b)), nearest);
    assert_eq!(pixels(bresenham::clipped(a, b, b, b)), [(2, 1)]);
    let steps: Vec<bresenham::Step> = bresenham::trace(a, b).collect();
    let [first, second] = steps[..] else {
        panic!("{steps:?}")
    };
    let bresenham::Step {
        pixel,
        decision,
        choice,
    } = first;
    let decision: i64 = decision;
    // 2F = 2·1 − 2 = 0, a tie; then 2F + 2dy = 2.
    assert_eq!((pixel, decision, choice), (a, 0, bresenham::Choice::E));
    assert_eq!((second.decision, second.choice), (2, bresenham::Choice::NE));

    assert_eq!(pixels(rectangle::outline(a, b)).len(), 6);
    assert_eq!(pixels(rectangle::fill(a, b)).len(), 6);
    assert_eq!(pixels(polygon::outline(&[a])), [(0, 0)]);
    let contours: &[Vec<DVec2>] = &[vec![
        DVec2::ZERO,
        DVec2::new(2.0, 0.0),
        DVec2::new(0.0, 2.0),
    ]];
    let (width, height): (u32, u32) = (3, 3);
    for rule in [polygon::FillRule::EvenOdd, polygon::FillRule::NonZero] {
        // (1, 0) and (0, 1) have their centres on the slanted side, which is a right one.
        assert_eq!(
            lit(polygon::fill(contours, rule, width, height).unwrap()),
            [(0, 0..1)]
        );
    }
    let corners: [DVec2; 3] = [DVec2::ZERO, DVec2::new(2.0, 0.0), DVec2::new(0.0, 2.0)];
    assert_eq!(
        lit(triangle::cover(corners, width, height).unwrap()),
        [(0, 0..1)]
    );

    let bad = DVec2::new(1.0, f64::NAN);
    let error = polygon::fill(
        &[vec![DVec2::ZERO], vec![DVec2::X, bad]],
        polygon::FillRule::NonZero,
        1,
        1,
    );
    let sentence = is_an_error(error.err().unwrap());
    assert!(
        ["vertex 1", "contour 1", "(1, NaN)", "finite"]
            .iter()
            .all(|part| sentence.contains(part)),
        "{sentence}"
    );
    let sentence = is_an_error(
        triangle::cover([DVec2::ZERO, bad, bad], 1, 1)
            .err()
            .unwrap(),
    );
    assert!(
        ["vertex 1", "(1, NaN)", "finite"]
            .iter()
            .all(|part| sentence.contains(part)),
        "{sentence}"
    );
}

type ClipSegment = fn(&Window, Segment) -> Option<Segment>;

#[test]
fn clipping_in_the_plane() {
    let window: Result<Window, WindowError> = Window::new(DVec2::ZERO, DVec2::splat(4.0));
    let window = window.unwrap();
    assert_eq!(
        window,
        Window {
            min: DVec2::ZERO,
            max: DVec2::splat(4.0)
        }
    );
    assert!(window.contains(DVec2::new(0.0, 4.0)) && !window.contains(DVec2::NAN));
    let sentence = is_an_error(Window::new(DVec2::X, DVec2::ZERO).unwrap_err());
    assert!(
        sentence.contains("[1, 0]") && sentence.contains("[0, 0]"),
        "{sentence}"
    );

    let across = Segment {
        a: DVec2::new(6.0, 1.0),
        b: DVec2::new(-2.0, 1.0),
    };
    let inside = Segment {
        a: DVec2::new(4.0, 1.0),
        b: DVec2::new(0.0, 1.0),
    };
    let methods: [ClipSegment; 3] = [
        direct::clip_segment,
        cohen_sutherland::clip_segment,
        liang_barsky::clip_segment,
    ];
    for clip in methods {
        assert_eq!(clip(&window, across), Some(inside));
        let endless = Segment {
            a: DVec2::new(f64::INFINITY, 1.0),
            b: DVec2::ONE,
        };
        assert_eq!(clip(&window, endless), None);
    }
    let convex: &[DVec2] = &[
        DVec2::ZERO,
        DVec2::new(4.0, 0.0),
        DVec2::new(4.0, 4.0),
        DVec2::new(0.0, 4.0),
    ];
    assert_eq!(cyrus_beck::clip_segment(convex, across), Some(inside));

    let code: cohen_sutherland::Outcode = cohen_sutherland::outcode(&window, DVec2::new(-1.0, 5.0));
    assert_eq!(code.to_string(), "1001");
    let steps: Vec<cohen_sutherland::Step> = cohen_sutherland::trace(&window, across);
    // 0010 and 0001: the first bit that differs is the right side's; then the left one's; then nothing is outside.
    assert_eq!(steps.len(), 3);

    let square: &[DVec2] = &[
        DVec2::ONE,
        DVec2::new(3.0, 1.0),
        DVec2::new(3.0, 6.0),
        DVec2::new(1.0, 6.0),
    ];
    let cut = [(1.0, 4.0), (1.0, 1.0), (3.0, 1.0), (3.0, 4.0)].map(DVec2::from);
    let half = sutherland_hodgman::HalfPlane {
        normal: -DVec2::Y,
        offset: -4.0,
    };
    let results: [Vec<DVec2>; 2] = [
        sutherland_hodgman::clip_against_line(square, half),
        sutherland_hodgman::clip_polygon(&window, square),
    ];
    let parts: Vec<Vec<DVec2>> = pieces::clip_polygon(&window, square);
    assert_eq!(parts.len(), 1);
    for outline in results.iter().chain(&parts) {
        let start = outline.iter().position(|&p| p == cut[0]).unwrap();
        let mut turned = outline.clone();
        turned.rotate_left(start);
        assert_eq!(turned, cut);
    }
}

#[test]
fn clipping_in_space() {
    let upright = [DVec3::new(1.0, -1.0, 1.0), DVec3::new(1.0, 3.0, 1.0)];
    let above: Option<[DVec3; 2]> = cyrus_beck::clip_segment_3d(&[Plane::GROUND], upright);
    assert_eq!(above, Some([DVec3::new(1.0, 0.0, 1.0), upright[1]]));
    let cube = box3::Box3::new(DVec3::ZERO, DVec3::splat(2.0)).unwrap();
    assert_eq!(
        box3::clip_segment(&cube, upright),
        Some([DVec3::new(1.0, 0.0, 1.0), DVec3::new(1.0, 2.0, 1.0)])
    );
    let code: box3::Outcode = box3::outcode(&cube, DVec3::new(-1.0, 3.0, -1.0));
    assert_eq!(code.to_string(), "100101");

    let (eye_side, behind) = (DVec4::W, DVec4::new(0.0, 0.0, -4.0, 1.0));
    let near = DVec4::new(0.0, 0.0, -1.0, 1.0);
    assert_eq!(
        homogeneous::clip_segment([eye_side, behind]),
        Some([eye_side, near])
    );
    let corner = |x: f64, z: f64, shade: f64| homogeneous::Vertex {
        position: DVec4::new(x, 0.0, z, 1.0),
        attributes: [shade],
    };
    let triangle = [
        corner(0.0, 0.0, 0.0),
        corner(0.5, 0.0, 0.0),
        corner(0.0, -4.0, 8.0),
    ];
    let front: Vec<homogeneous::Vertex<1>> = homogeneous::clip_polygon(&triangle);
    // A quarter of the way to shade 8, twice.
    let mut shades: Vec<f64> = front.iter().map(|v| v.attributes[0]).collect();
    shades.sort_by(f64::total_cmp);
    assert_eq!(shades, [0.0, 0.0, 2.0, 2.0]);
}
