//! Any numbers.

use proptest::num::f64::ANY;
use proptest::prelude::*;

use super::*;

#[test]
fn every_size() {
    for e in [-1040, -1000, -530, 530, 1000, 1021] {
        let s = libm::scalbn(1.0, e);
        let scaled = |p: &Polygon| Polygon {
            vertices: p.vertices.iter().map(|&v| s * v).collect(),
        };
        // The largest reach from −4 s to 4 s, ± the largest double but for rounding up.
        let scene = [
            square(-4.0, -4.0, 0.0, 7.875),
            square(0.0, -4.0, 1.0, 3.875),
        ];
        let crossing = [
            scene[0].clone(),
            polygon([
                [0.0, -3.0, -1.0],
                [2.0, -3.0, 1.0],
                [2.0, 3.0, 1.0],
                [0.0, 3.0, -1.0],
            ]),
        ];
        for (scene, eye) in [
            (&scene, DVec4::Z),
            (&scene, place(0.0, 0.0, 3.0)),
            (&crossing, DVec4::Z),
        ] {
            let expected: Vec<_> = visible_parts(scene, eye)
                .iter()
                .map(|(i, part)| (*i, scaled(part)))
                .collect();
            let place = (if eye.w == 0.0 {
                eye.truncate()
            } else {
                s * eye.truncate()
            })
            .extend(eye.w);
            let parts = visible_parts(&scene.each_ref().map(scaled), place);
            assert_eq!(parts.len(), expected.len(), "{e} {eye}");
            for ((i, part), (j, other)) in parts.iter().zip(&expected) {
                assert_eq!(
                    (i, part.vertices.len()),
                    (j, other.vertices.len()),
                    "{e} {eye}"
                );
                for (v, w) in part.vertices.iter().zip(&other.vertices) {
                    // Below the normal doubles, a few of the smallest.
                    let off = (*v - *w).abs().max_element();
                    assert!(
                        off <= 4.0 * f64::EPSILON * 4.0 * s + 32.0 * f64::from_bits(1),
                        "{e} {eye}: {v} {w}"
                    );
                }
            }
        }
    }
}

proptest! {
    #[test]
    fn never_panics(
        scene in prop::collection::vec(prop::collection::vec(prop::array::uniform3(ANY), 0..6), 0..5),
        eye in prop::array::uniform4(ANY), w in 0usize..3,
    ) {
        let polygon = |v: Vec<[f64; 3]>| Polygon { vertices: v.into_iter().map(DVec3::from).collect() };
        let scene: Vec<_> = scene.into_iter().map(polygon).collect();
        let mut eye = DVec4::from(eye);
        eye.w = [eye.w, 0.0, 1.0][w];
        for (source, part) in visible_parts(&scene, eye) {
            prop_assert!(source < scene.len() && part.vertices.iter().all(|v| v.is_finite()));
        }
    }

    /// Not planar, not convex, thin, repeated corners: some answer, and finite.
    #[test]
    fn unchecked_polygons(
        scene in prop::collection::vec(prop::collection::vec(prop::array::uniform3(-2i32..3), 3..7), 0..6),
        eye in prop::array::uniform4(-3i32..4),
    ) {
        let vector = |v: [i32; 3]| DVec3::from(v.map(f64::from));
        let polygon = |v: Vec<[i32; 3]>| Polygon { vertices: v.into_iter().map(vector).collect() };
        let scene: Vec<_> = scene.into_iter().map(polygon).collect();
        for (source, part) in visible_parts(&scene, DVec4::from(eye.map(f64::from))) {
            prop_assert!(source < scene.len() && part.vertices.iter().all(|v| v.is_finite()));
        }
    }
}
