//! What the sort is made of: pieces and the sides they know, the tree.

use super::scenes::{polygon, square};
use super::*;
use crate::painter::extent::View;
use crate::painter::piece::{CutBy, Knife, Piece};
use crate::painter::tree::Tree;

/// As if the piece had been cut off from others by this plane.
fn cut_off(piece: &mut Piece, knife: &Knife) {
    let source = knife.source;
    let is_near = piece.side_of(knife).is_near;
    piece.cuts.push(CutBy { source, is_near });
    piece.cuts.sort_by_key(|cut| cut.source);
}

/// Sides known from cuts come before any comparison, whichever of the two they are known of, and about whatever plane.
#[test]
fn known_sides_come_first() {
    // Two that cross, z = x and z = −x; the first reaches higher, the second lower.
    let crossing = |slope: f64, [from, to]: [f64; 2]| {
        polygon(&[
            [from, -1.0, slope * from],
            [to, -1.0, slope * to],
            [to, 1.0, slope * to],
            [from, 1.0, slope * from],
        ])
    };
    let (rising, falling) = (crossing(1.0, [-1.0, 2.0]), crossing(-1.0, [-1.0, 2.0]));
    let level = |z: f64| square(0.0, 0.0, z, 5.0);
    let scene = [rising, falling, level(0.0), level(-9.0)];
    let view = View::of(ABOVE);
    let knife = |i: usize| Knife::new(i, &scene[i], ABOVE).unwrap();
    let piece = |i: usize, settled: &[usize]| {
        let mut piece = Piece::whole(i, &scene[i], &view);
        for &source in settled {
            cut_off(&mut piece, &knife(source));
        }
        piece
    };
    let compared = |first: &[usize], second: &[usize]| {
        let (first, second) = (piece(0, first), piece(1, second));
        let mut work = Work::default();
        let pair = first.compare(&second, ABOVE, &mut work);
        let swapped = second.compare(&first, ABOVE, &mut work);
        assert_eq!(swapped, pair.swapped());
        (pair, work.pairs)
    };
    assert_eq!(compared(&[], &[]), (Pair::Crossing, 2));
    // Up to 2 the first lies above the second's plane, and the second below the first's.
    assert_eq!(compared(&[1], &[]), (Pair::FirstNearer, 2));
    assert_eq!(compared(&[], &[0]), (Pair::FirstNearer, 2));
    assert_eq!(compared(&[2], &[2]), (Pair::FirstNearer, 2));
    // Known about one of them only, or both on one side: no news.
    assert_eq!(compared(&[2], &[]), (Pair::Crossing, 2));
    assert_eq!(compared(&[3], &[3]), (Pair::Crossing, 2));
    // The other way round, seen from below.
    let below = |first: &[usize], second: &[usize]| {
        let settled = |i: usize, of: &[usize]| {
            let mut piece = Piece::whole(i, &scene[i], &view);
            for &source in of {
                cut_off(
                    &mut piece,
                    &Knife::new(source, &scene[source], -ABOVE).unwrap(),
                );
            }
            piece
        };
        settled(0, first).compare(&settled(1, second), -ABOVE, &mut ())
    };
    assert_eq!(below(&[1], &[]), Pair::SecondNearer);
    assert_eq!(below(&[], &[0]), Pair::SecondNearer);
    assert_eq!(below(&[2], &[2]), Pair::SecondNearer);
    // In the plane of one submitted later: on the eye's side. And what is cut passes on what it knew.
    let twins = [scene[2].clone(), scene[2].clone(), scene[0].clone()];
    for (piece, plane) in [(0, 1), (1, 0)] {
        let settled = || {
            let mut settled = Piece::whole(piece, &twins[piece], &view);
            cut_off(
                &mut settled,
                &Knife::new(plane, &twins[plane], ABOVE).unwrap(),
            );
            settled
        };
        let other = Piece::whole(plane, &twins[plane], &view);
        let nearer = [Pair::FirstNearer, Pair::SecondNearer][piece];
        assert_eq!(settled().compare(&other, ABOVE, &mut ()), nearer);
        let [knife, own] = [2, piece].map(|i| Knife::new(i, &twins[i], ABOVE).unwrap());
        for half in settled().cut(&knife, &own, ABOVE, &view).unwrap() {
            assert_eq!(half.compare(&other, ABOVE, &mut ()), nearer);
            let cuts: Vec<_> = half.cuts.iter().map(|cut| cut.source).collect();
            assert_eq!(cuts, [plane, 2]);
            assert!(half.cut(&knife, &own, ABOVE, &view).is_none());
        }
    }
}

/// Nearer by one plane and farther by another, two pieces share no sight line: known without a comparison.
#[test]
fn on_two_sides_of_two_planes() {
    let at = |x: f64, z: f64| square(x, 0.0, z, 1.0);
    // Planes between them that lean to either side: the first is above one of them and below the other.
    let leaning = |slope: f64| {
        polygon(&[
            [-9.0, -9.0, -9.0 * slope],
            [9.0, -9.0, 9.0 * slope],
            [9.0, 9.0, 9.0 * slope],
            [-9.0, 9.0, -9.0 * slope],
        ])
    };
    let scene = [at(-3.0, 0.0), at(3.0, 0.0), leaning(1.0), leaning(-1.0)];
    let view = View::of(ABOVE);
    let piece = |i: usize, settled: &[usize]| {
        let mut piece = Piece::whole(i, &scene[i], &view);
        for &source in settled {
            cut_off(
                &mut piece,
                &Knife::new(source, &scene[source], ABOVE).unwrap(),
            );
        }
        piece
    };
    for (settled, compared) in [(&[][..], 1), (&[2], 1), (&[3], 1), (&[2, 3], 0)] {
        let mut work = Work::default();
        let pair = piece(0, settled).compare(&piece(1, settled), ABOVE, &mut work);
        assert_eq!((pair, work.pairs), (Pair::Apart, compared), "{settled:?}");
    }
}

/// What is put into the tree later is found, also beyond the box of what it is a piece of: rounding may put it there.
#[test]
fn the_tree_finds_what_was_put_in() {
    let view = View::of(ABOVE);
    let extent = |x: f64, z: f64| view.extent(&square(x, 0.0, z, 1.0)).unwrap();
    let extents: Vec<_> = (0..40)
        .map(|i| Some(extent(4.0 * f64::from(i), 0.0)))
        .collect();
    let mut tree = Tree::new(&extents);
    let found = |tree: &Tree, at: extent::Extent| {
        let mut found = tree.may_be_hidden(&at, &mut ());
        found.sort_unstable();
        found
    };
    assert_eq!(found(&tree, extent(40.0, 0.0)), [10]);
    // Beside all boxes, below all of them, and a piece of that piece.
    tree.insert(40, extent(-50.0, 0.0), 10);
    tree.insert(41, extent(40.0, -7.0), 10);
    tree.insert(42, extent(-90.0, 0.0), 40);
    assert_eq!(found(&tree, extent(-50.0, 0.0)), [40]);
    assert_eq!(found(&tree, extent(40.0, 0.0)), [10, 41]);
    assert_eq!(found(&tree, extent(40.0, -1.0)), [41]);
    assert_eq!(found(&tree, extent(-90.0, 0.0)), [42]);
    for i in [10, 40] {
        tree.remove(i);
    }
    assert_eq!(found(&tree, extent(-50.0, 0.0)), [0; 0]);
    assert_eq!(found(&tree, extent(40.0, 0.0)), [41]);
    assert_eq!(found(&tree, extent(-90.0, 0.0)), [42]);
}
