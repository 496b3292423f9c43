use proptest::prelude::*;

use super::*;

/// The triangles, twice their areas, and twice the area of the contour.
fn cut(places: &[DVec2]) -> (Vec<[usize; 3]>, Vec<f64>, f64) {
    let triangles = ears::cut(places, &mut 0);
    let twice = |&[a, b, c]: &[usize; 3]| {
        let [a, b, c] = [a, b, c].map(|i| places[i]);
        (b - a).perp_dot(c - a)
    };
    let areas = triangles.iter().map(twice).collect();
    let next = places.iter().cycle().skip(1);
    let whole = places.iter().zip(next).map(|(p, q)| p.perp_dot(*q)).sum();
    (triangles, areas, whole)
}

/// Nothing is covered twice: no triangle turns right, and their areas are the contour's. All corners are there.
fn is_kept(places: &[DVec2]) {
    let (triangles, areas, whole) = cut(places);
    assert_eq!(triangles.len(), places.len() - 2, "{places:?}");
    let size = places.iter().map(|p| p.abs().max_element());
    let size = size.fold(0.0, f64::max);
    let rounding = 16.0 * f64::EPSILON * size * size * places.len() as f64;
    let negative = areas.iter().copied().fold(0.0, f64::min);
    assert!(negative >= -rounding, "{negative} in {places:?}");
    let sum: f64 = areas.iter().sum();
    assert!((sum - whole).abs() <= rounding, "{sum}, not {whole}");
    has_its_border(places.len(), &triangles);
}

/// Each side of the contour is a side of one triangle; every other side is there both ways.
fn has_its_border(n: usize, triangles: &[[usize; 3]]) {
    let mut balance = std::collections::BTreeMap::new();
    for &[a, b, c] in triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            *balance.entry((p, q)).or_insert(0) += 1;
            *balance.entry((q, p)).or_insert(0) -= 1;
        }
    }
    for i in 0..n {
        *balance.entry((i, (i + 1) % n)).or_insert(0) -= 1;
        *balance.entry(((i + 1) % n, i)).or_insert(0) += 1;
    }
    assert!(balance.values().all(|&count| count == 0));
}

fn places(of: &[(f64, f64)]) -> Vec<DVec2> {
    of.iter().map(|&p| p.into()).collect()
}

#[test]
fn a_square_is_cut_from_its_first_corner() {
    let square = places(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    assert_eq!(cut(&square).0, [[0, 1, 2], [0, 2, 3]]);
    // An arrow: only one of its diagonals lies in it.
    let arrow = places(&[(0.0, 0.0), (4.0, 4.0), (0.0, 1.0), (-4.0, 4.0)]);
    is_kept(&arrow);
    is_kept(&[1, 2, 3, 0].map(|i| arrow[i]));
}

#[test]
fn slits_touching_holes_spikes_and_corners_in_line() {
    // Two holes, the second on a slit from the first; and both from one corner.
    let outer = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
    let hole = |x: f64, y: f64| {
        [
            (x, y),
            (x, y + 2.0),
            (x + 2.0, y + 2.0),
            (x + 2.0, y),
            (x, y),
        ]
    };
    let from_one_corner = [&outer[..], &hole(1.0, 2.0), &outer[..1], &hole(5.0, 1.0)].concat();
    is_kept(&places(&from_one_corner));
    let [a, b, c, d, _] = hole(1.0, 1.0);
    let chained = [&outer[..], &[a, b, c], &hole(5.0, 5.0), &[c, d, a]].concat();
    is_kept(&places(&chained));
    // A hole that touches the border in the middle of a side, and in a corner without a slit of its own.
    let touching = [
        (0.0, 0.0),
        (3.0, 0.0),
        (2.0, 2.0),
        (4.0, 2.0),
        (3.0, 0.0),
        (6.0, 0.0),
        (6.0, 6.0),
        (0.0, 6.0),
    ];
    is_kept(&places(&touching));
    // Corners in the middle of sides: all are kept.
    let in_line = [
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 0.0),
        (3.0, 0.0),
        (3.0, 3.0),
        (1.5, 1.5),
    ];
    is_kept(&places(&in_line));
    // Spikes, out of it and into it.
    let spikes = [
        (0.0, 0.0),
        (4.0, 0.0),
        (9.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (2.0, 2.0),
        (4.0, 4.0),
        (0.0, 4.0),
    ];
    is_kept(&places(&spikes));
    // Without area, crossing itself, in one point, not a number: no panic, all corners.
    for strange in [
        &[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)][..],
        &[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)],
        &[(1.0, 1.0); 6],
        &[
            (f64::NAN, 0.0),
            (1.0, f64::INFINITY),
            (0.0, 0.0),
            (0.0, 1.0),
            (2.0, f64::MAX),
        ],
    ] {
        let (triangles, ..) = cut(&places(strange));
        has_its_border(strange.len(), &triangles);
    }
}

/// A random tree of cells of a grid, and the contour once round it: concave, with slits where cells meet again.
fn round_a_tree(choices: &[usize]) -> Vec<DVec2> {
    use std::collections::BTreeSet;
    let mut cells = BTreeSet::from([(0_i32, 0_i32)]);
    let mut sides: BTreeSet<[(i32, i32); 2]> = BTreeSet::new();
    let ring = |(x, y): (i32, i32)| [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
    let mut contour: Vec<(i32, i32)> = ring((0, 0)).to_vec();
    for &choice in choices {
        // A new cell outside one side of the contour.
        let n = contour.len();
        let i = choice % n;
        let (p, q) = (contour[i], contour[(i + 1) % n]);
        let (dx, dy) = (q.0 - p.0, q.1 - p.1);
        // On the right of the side.
        let cell = (
            p.0.min(q.0) - i32::from(dy < 0),
            p.1.min(q.1) - i32::from(dx > 0),
        );
        if !cells.insert(cell) {
            continue;
        }
        sides.insert([p, q]);
        let out = (dy, -dx);
        let beyond = |(x, y): (i32, i32)| (x + out.0, y + out.1);
        contour.splice(i + 1..i + 1, [beyond(p), beyond(q)]);
    }
    contour
        .into_iter()
        .map(|(x, y)| DVec2::new(x.into(), y.into()))
        .collect()
}

proptest! {
    #[test]
    fn contours_round_trees_of_cells_are_kept(choices in prop::collection::vec(0..1000_usize, 0..60), start in 0..9_usize) {
        let mut contour = round_a_tree(&choices);
        let n = contour.len();
        contour.rotate_left(start % n);
        is_kept(&contour);
    }

    /// Stars round the origin: their area is a sum of sines.
    #[test]
    fn stars_are_kept(radii in prop::collection::vec(0.01..1.0_f64, 3..80)) {
        let n = radii.len() as f64;
        let at = |(i, r): (usize, &f64)| DVec2::from_angle(i as f64 / n * core::f64::consts::TAU) * *r;
        is_kept(&radii.iter().enumerate().map(at).collect::<Vec<_>>());
    }

    #[test]
    fn never_panics(p in prop::collection::vec([prop::num::f64::ANY, prop::num::f64::ANY], 0..9), q in prop::collection::vec([0..4_i8, 0..4_i8], 3..12)) {
        let _ = ears::cut(&p.into_iter().map(DVec2::from).collect::<Vec<_>>(), &mut 0);
        let q: Vec<DVec2> = q.into_iter().map(|[x, y]| DVec2::new(x.into(), y.into())).collect();
        let triangles = ears::cut(&q, &mut 0);
        has_its_border(q.len(), &triangles);
    }
}

/// A face bent out of its plane is cut as it appears along its normal.
#[test]
fn a_bent_face_is_cut_in_its_best_plane() {
    // An arrow in the plane x + y + z = 0, its corners moved off it alternately. Of its two diagonals one lies in it.
    let (u, v) = (DVec3::new(1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, -2.0));
    let arrow = [(0.0, 0.0), (4.0, 4.0), (0.0, 1.0), (-4.0, 4.0)];
    for lift in [0.0, 0.1, 1.0] {
        let corner = |(i, &(x, y)): (usize, &(f64, f64))| {
            let off = if i % 2 == 0 { lift } else { -lift };
            u * x + v * y + DVec3::splat(off)
        };
        let corners: Vec<DVec3> = arrow.iter().enumerate().map(corner).collect();
        let cut = triangles(&[0, 1, 2, 3], &corners, &mut 0);
        let mut diagonals = cut.iter().map(|t| t.contains(&0) && t.contains(&2));
        assert!(diagonals.all(|both| both), "{lift}: {cut:?}");
    }
}
