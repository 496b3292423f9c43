//! Which pixels and which depths: against the exact cover, exact numbers and the readable form.

use ombra_oracle::Exact;
use ombra_oracle::vector::turn;
use proptest::prelude::*;

use super::*;
use crate::{attributes, triangle};

fn r(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// Places in a picture, some far beyond it, some equal, some on pixel centres.
fn place() -> impl Strategy<Value = [i32; 2]> {
    let side = prop_oneof![
        -2000..12_000,
        (-4..44).prop_map(|i| 128 * i),
        -(1 << 24)..(1 << 24)
    ];
    prop::array::uniform2(side)
}

fn corners() -> impl Strategy<Value = [Corner; 3]> {
    let value = prop_oneof![
        0.0..=1.0f64,
        (-1074..1).prop_map(|e| libm::scalbn(1.0, e)),
        Just(0.0)
    ];
    let w = 1.0;
    let corner = (place(), value).prop_map(move |([x, y], value)| Corner { x, y, value, w });
    prop::array::uniform3(corner)
}

fn in_pixels(corner: &Corner) -> DVec2 {
    DVec2::new(f64::from(corner.x), f64::from(corner.y)) / f64::from(SUBPIXELS)
}

proptest! {
    /// The pixels are those of the exact cover of the snapped corners, row after row.
    #[test]
    fn coverage_is_exact(corners in corners()) {
        let (width, height) = (40, 36);
        let points = corners.each_ref().map(in_pixels);
        let expected: Vec<_> = triangle::cover(points, width, height)
            .unwrap()
            .flat_map(|span| span.pixels())
            .map(|p| (p.x, p.y))
            .collect();
        let setup = Setup::new(corners.each_ref(), Cull::Nothing);
        let pixels = setup.iter().flat_map(|setup| setup.pixels(width, height));
        let found: Vec<_> = pixels.map(|(x, y, _)| (x, y)).collect();
        prop_assert_eq!(&found, &expected);
        // Nothing is left out by the bounds.
        let Some(setup) = setup else { return Ok(()) };
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let found: Vec<_> = all.filter(|&(x, y)| setup.edges_at(x, y).is_some()).collect();
        prop_assert_eq!(&found, &expected);
    }

    /// Stepped from any pixel, the edge functions are those of each pixel, and so is what is in.
    #[test]
    fn lines_step_exactly(corners in corners(), start in prop::array::uniform2(0..40u32)) {
        let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else { return Ok(()) };
        let [x, y] = start;
        let lines = setup.lines(x, y);
        for (i, j) in [(0, 0), (1, 0), (0, 1), (17, 5), (400, 900)] {
            let edges = lines.map(|l| l.first + l.across * f64::from(i) + l.down * f64::from(j));
            let inside = edges.iter().zip(&lines).all(|(&e, line)| e >= line.least);
            prop_assert_eq!(setup.edges_at(x + i, y + j), inside.then_some(edges));
        }
    }

    /// The depth of the plane through the corners, within 5 roundings relative to it, however thin the triangle.
    #[test]
    fn depth_is_within_five_roundings(corners in corners(), near in any::<bool>()) {
        // Half of the triangles are small: all their pixels are in the picture.
        let corners = if near {
            corners.map(|c| Corner { x: c.x.rem_euclid(40 * 256), y: c.y.rem_euclid(36 * 256), ..c })
        } else {
            corners
        };
        let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else { return Ok(()) };
        for y in (0..36).step_by(5) {
            for x in 0..40 {
                let Some(edges) = setup.edges_at(x, y) else { continue };
                let value = setup.value(edges);
                // Cramer's rule on the corners as given.
                let [a, b, c] = corners;
                let point = |c: &Corner| [c.x, c.y].map(Exact::from);
                let p = [x * 256 + 128, y * 256 + 128].map(Exact::from);
                let [pa, pb, pc] = [&a, &b, &c].map(point);
                let sum = turn(&p, &pb, &pc) * r(a.value)
                    + turn(&pa, &p, &pc) * r(b.value)
                    + turn(&pa, &pb, &p) * r(c.value);
                let exact = sum.over(&turn(&pa, &pb, &pc)).unwrap();
                let error = (r(value) - &exact).abs();
                // 5 · 2⁻⁵³; below the range of doubles the dᵢ / E have an error of 2⁻¹⁰⁷⁵, times Eᵢ < 2⁵².
                let bound = exact * r(5.01 * f64::EPSILON / 2.0) + r(libm::scalbn(1.0, -1021));
                prop_assert!(error <= bound, "{} {}: {}", x, y, value);
                prop_assert!((setup.least..=setup.greatest).contains(&value));
            }
        }
    }

    /// `attributes` says the same: weights within 67ε there, 2½ε here.
    #[test]
    fn attributes_are_the_readable_form(corners in corners()) {
        let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else { return Ok(()) };
        let points = corners.each_ref().map(in_pixels);
        for (x, y, edges) in setup.pixels(40, 36).step_by(7) {
            let centre = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
            let weights = attributes::weights(points, centre).unwrap();
            let readable = attributes::linear(weights, corners.map(|corner| corner.value));
            let bound = 70.0 * f64::EPSILON * readable + libm::scalbn(1.0, -1020);
            let found = setup.value(edges);
            prop_assert!((found - readable).abs() <= bound, "{} {}: {} {}", x, y, found, readable);
        }
    }

    /// Snapping is that of `triangle`.
    #[test]
    fn corners_are_snapped(x in -65536.0..65536.0f64, half in -1_000_000..1_000_000i32) {
        for x in [x, (f64::from(half) + 0.5) / 256.0] {
            let p = DVec2::new(x, -x);
            let corner = Corner::snapped(p, 0.25, 3.0);
            prop_assert_eq!(in_pixels(&corner), triangle::snap(p, SUBPIXEL_BITS));
            prop_assert_eq!((corner.value, corner.w), (0.25, 3.0));
        }
    }

    /// Whatever the corners, nothing panics.
    #[test]
    fn never_panics(coordinates in prop::array::uniform6(any::<i32>()), x in any::<u32>(), y in any::<u32>()) {
        let ends = [i32::MIN, i32::MAX];
        let [ax, ay, bx, by, cx, cy] = coordinates;
        for [ax, by] in [[ax, by], [ends[0], ends[1]], [ends[1], ends[0]]] {
            let corner = |x, y| Corner { x, y, value: f64::NAN, w: f64::INFINITY };
            let corners = [corner(ax, ay), corner(bx, by), corner(cx, cy)];
            let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else { continue };
            let _ = (setup.bounds(x, y), setup.lines(x, y), setup.edges_at(x, y));
            prop_assert!(setup.pixels(3, 3).count() <= 9);
        }
    }
}

#[test]
fn culled_by_the_side_that_is_seen() {
    let corner = |x, y| Corner::snapped(DVec2::new(x, y), 0.0, 1.0);
    let [a, b, c] = [corner(0.0, 0.0), corner(4.0, 0.0), corner(0.0, 4.0)];
    let is_kept = |corners, cull| Setup::new(corners, cull).is_some();
    // In the picture a b c runs clockwise: seen from behind.
    for (corners, kept) in [
        ([&a, &b, &c], [true, false, true]),
        ([&a, &c, &b], [true, true, false]),
        ([&a, &b, &b], [false; 3]),
    ] {
        let found = [Cull::Nothing, Cull::Back, Cull::Front].map(|cull| is_kept(corners, cull));
        assert_eq!(found, kept);
    }
}
