//! Any scene.

use core::cmp::Ordering;

use proptest::prelude::*;

use super::checks::{check_pieces, check_sight, hides, is_back_to_front, some_order};
use super::scenes::{self, point_of, polygon, scene};
use super::*;
use crate::painter::extent::View;
use crate::painter::fast::DepthSort;
use crate::pair::convex;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn an_order_is_found_where_there_is_one(scene in scene(6), eye in scenes::eye()) {
        let pairs = hiding_pairs(&scene, eye);
        let found = order(&scene, eye);
        prop_assert_eq!(found.is_ok(), some_order(&mut Vec::new(), scene.len(), &pairs));
        match found {
            Ok(found) => {
                let mut sorted = found.clone();
                sorted.sort_unstable();
                prop_assert!(sorted.into_iter().eq(0..scene.len()));
                prop_assert!(is_back_to_front(&found, &pairs));
                // The lecture's sort, wherever that is an order.
                let distance = |i: usize| {
                    let of = |v: &DVec3| {
                        if eye.w == 0.0 { -eye.truncate().dot(*v) } else { (*v - eye.truncate()).length() }
                    };
                    scene[i].vertices.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
                };
                let mut by_distance: Vec<_> = (0..scene.len()).collect();
                by_distance.sort_by(|&a, &b| distance(b).total_cmp(&distance(a)));
                let unclear = by_distance.windows(2).any(|w| (distance(w[0]) - distance(w[1])).abs() < 1e-9);
                if !unclear && is_back_to_front(&by_distance, &pairs) {
                    prop_assert_eq!(found, by_distance);
                }
            }
            Err(cycle) => {
                let ring = cycle.primitives;
                for (i, &a) in ring.iter().enumerate() {
                    for (j, &b) in ring.iter().enumerate() {
                        if i != j {
                            let next = j == (i + 1) % ring.len();
                            prop_assert_eq!(hides(&scene, a, b, eye), next, "{:?}", ring);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn both_forms_agree(scene in prop_oneof![scene(8), scene(40)], eye in scenes::eye()) {
        let found = order(&scene, eye);
        prop_assert_eq!(&found, &order_plain(&scene, eye, &mut ()));
        // The same place by another w.
        if eye.w == 1.0 {
            prop_assert_eq!(&found, &order(&scene, eye * -2.0));
        }
    }

    /// Primitives whose extents say that they need no comparison do not hide each other: near and far, large and small,
    /// of any size.
    #[test]
    fn extents_leave_out_nothing(scene in scene(8), eye in scenes::eye(), exponent in -300..300) {
        let size = libm::scalbn(1.0, exponent);
        let grown = |p: &Polygon| Polygon { vertices: p.vertices.iter().map(|&v| v * size).collect() };
        let scene: Vec<_> = scene.iter().map(grown).collect();
        let eye = if eye.w == 1.0 { (eye.truncate() * size).extend(1.0) } else { eye };
        let view = View::of(eye);
        let extents: Vec<_> = scene.iter().map(|p| view.extent(p)).collect();
        for [front, back] in hiding_pairs(&scene, eye) {
            let (front, back) = (extents[front].unwrap(), extents[back].unwrap());
            prop_assert!(front.overlaps(&back), "{front:?} {back:?}");
            prop_assert!(back.farthest >= front.nearest, "{front:?} {back:?}");
        }
    }

    #[test]
    fn what_is_painted_last_is_nearest(
        scene in scene(12),
        eye in scenes::eye(),
        sights in prop::collection::vec((any::<prop::sample::Index>(), prop::array::uniform4(0.01..1.0)), 40),
    ) {
        let pieces = order_by_cutting(&scene, eye);
        check_pieces(&scene, &pieces)?;
        // By planes as soon as there is a ring.
        let divided = DepthSort::new(&scene, eye, &mut ()).by_cutting(0);
        check_pieces(&scene, &divided)?;
        // What was cut turns one way at every corner, to the last bit.
        for (i, piece) in pieces.iter().chain(&divided).filter(|(i, piece)| *piece != scene[*i]) {
            let turns = |way| convex(piece.vertices.clone(), eye, way) == piece.vertices;
            prop_assert!(turns(Ordering::Less) || turns(Ordering::Greater), "{i}: {piece:?}");
        }
        let whole = order(&scene, eye);
        if let Ok(found) = &whole {
            // Nothing is cut without a ring.
            prop_assert_eq!(&numbers(&pieces), found);
        } else {
            prop_assert!(pieces.len() > scene.len());
        }
        if whole.is_ok() {
            prop_assert_eq!(&divided, &pieces);
        }
        // k − 1 lines cut a convex polygon into 1 + (k − 1) + (k − 1)(k − 2)/2 parts at most.
        let k = scene.len();
        for i in 0..k {
            for pieces in [&pieces, &divided] {
                let parts = pieces.iter().filter(|(source, _)| *source == i).count();
                prop_assert!(parts <= (k * k - k + 2) / 2, "{i}: {parts}");
            }
        }
        for (index, weights) in sights {
            if let Some(primitive) = (k > 0).then(|| index.get(&scene)) {
                check_sight(&scene, &pieces, eye, point_of(primitive, weights))?;
                check_sight(&scene, &divided, eye, point_of(primitive, weights))?;
            }
        }
    }

    #[test]
    fn never_panics(
        numbers in prop::collection::vec(prop::array::uniform3(proptest::num::f64::ANY), 0..24),
        sizes in prop::collection::vec(0usize..6, 0..6),
        eye in prop::array::uniform4(proptest::num::f64::ANY),
    ) {
        let mut rest = numbers.as_slice();
        let mut scene = Vec::new();
        for n in sizes {
            let (vertices, after) = rest.split_at(n.min(rest.len()));
            scene.push(polygon(vertices));
            rest = after;
        }
        for eye in [DVec4::from_array(eye), DVec4::Z, DVec4::W] {
            let found = order(&scene, eye);
            prop_assert_eq!(&found, &order_plain(&scene, eye, &mut ()));
            let pieces = order_by_cutting(&scene, eye);
            prop_assert!(pieces.len() >= scene.len());
        }
    }
}
