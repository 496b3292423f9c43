//! Primitives that cross.

use core::slice::from_ref;

use super::*;
use crate::pair::compare;

#[test]
fn crossing_primitives_are_cut_at_their_line() {
    // Roofs z = x and z = −x over the same square: the higher half of each.
    let rise = |s: f64| {
        polygon([
            [-1.0, -1.0, -s],
            [1.0, -1.0, s],
            [1.0, 1.0, s],
            [-1.0, 1.0, -s],
        ])
    };
    let scene = [rise(1.0), rise(-1.0)];
    let parts = visible_parts(&scene, DVec4::Z);
    let half = |s: f64| {
        polygon([
            [0.0, -1.0, 0.0],
            [s, -1.0, 1.0],
            [s, 1.0, 1.0],
            [0.0, 1.0, 0.0],
        ])
    };
    assert_eq!(parts.len(), 2);
    for (part, s) in parts.iter().zip([1.0, -1.0]) {
        let mut corners = part.1.vertices.clone();
        for v in half(s).vertices {
            corners.retain(|c| *c != v);
        }
        assert!(corners.is_empty() && part.1.vertices.len() == 4, "{part:?}");
    }
    // Three planes through one line, 60° apart: of six half squares the two highest are seen from above.
    let turned = |angle: f64| {
        let turn = DQuat::from_axis_angle(DVec3::Y, angle);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        Polygon {
            vertices: corners.map(|[x, y]| turn * DVec3::new(x, y, 0.0)).to_vec(),
        }
    };
    let star = [-PI / 3.0, 0.0, PI / 3.0].map(turned);
    let parts = visible_parts(&star, DVec4::Z);
    // Both lean 60°; outside x = ½ they end, and the level one shows.
    close(areas(&parts, 0), 2.0, 4.0);
    close(areas(&parts, 1), 2.0, 4.0);
    close(areas(&parts, 2), 2.0, 4.0);
}

/// Two planes that cross at 10⁻¹³: what is left of both near their line differs in depth by less than the tolerance.
#[test]
fn crossing_at_no_angle() {
    let tilt = |s: f64| {
        polygon([
            [-1.0, -1.0, -s],
            [1.0, -1.0, s],
            [1.0, 1.0, s],
            [-1.0, 1.0, -s],
        ])
    };
    let covers = [
        square(-2.0, -1.5, 1.0, 1.95),
        square(0.05, -1.5, 1.0, 1.95),
        square(-1.5, 0.25, 1.0, 3.0),
    ];
    let [rising, falling] = [1e-13, -1e-13].map(tilt);
    assert_eq!(compare(&rising, &falling, DVec4::Z), Pair::Crossing);
    let first = [&covers[..], &[rising.clone(), falling.clone()]].concat();
    let between = [from_ref(&rising), &covers[..], from_ref(&falling)].concat();
    for scene in [first, between] {
        let parts = visible_parts(&scene, DVec4::Z);
        // x from −0.05 to 0.05, y from −1 to 0.25: a half each, the line in which they cross between them.
        for half in [&rising, &falling] {
            let source = scene.iter().position(|p| p == half).unwrap();
            close(areas(&parts, source), 0.0625, 4.0);
        }
    }
}
