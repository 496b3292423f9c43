use std::collections::HashSet;

use proptest::prelude::*;

use super::*;
use ombra_math::work::Work;

fn grid(pixels: impl Iterator<Item = IVec2>, width: usize, height: usize) -> Vec<String> {
    let mut rows = vec![vec!['.'; width]; height];
    for p in pixels {
        let cell = &mut rows[p.y as usize][p.x as usize];
        assert_eq!(*cell, '.', "{p} twice");
        *cell = '#';
    }
    rows.into_iter()
        .map(|row| row.into_iter().collect())
        .collect()
}

#[test]
fn the_outline_has_14_pixels_and_the_inside_20() {
    let (min, max) = (IVec2::new(2, 1), IVec2::new(6, 4));
    assert_eq!(outline(min, max).count(), 14);
    assert_eq!(fill(min, max).count(), 20);
    assert_eq!(
        grid(outline(min, max), 8, 6),
        [
            "........", "..#####.", "..#...#.", "..#...#.", "..#####.", "........"
        ]
    );
    assert_eq!(
        grid(fill(min, max), 8, 6),
        [
            "........", "..#####.", "..#####.", "..#####.", "..#####.", "........"
        ]
    );
}

#[test]
fn the_outline_goes_round_from_min() {
    let round: Vec<_> = outline(IVec2::ZERO, IVec2::new(2, 2))
        .map(|p| (p.x, p.y))
        .collect();
    let expected = [
        (0, 0),
        (1, 0),
        (2, 0),
        (2, 1),
        (2, 2),
        (1, 2),
        (0, 2),
        (0, 1),
    ];
    assert_eq!(round, expected);
}

#[test]
fn a_pixel_is_a_position_and_has_no_size() {
    let p = IVec2::new(-3, 7);
    assert_eq!(fill(p, p).collect::<Vec<_>>(), [p]);
    assert_eq!(outline(p, p).collect::<Vec<_>>(), [p]);
}

#[test]
fn every_small_rectangle_has_its_pixels_once() {
    for (x0, y0, x1, y1) in (0..5 * 5 * 5 * 5).map(|i| (i % 5, i / 5 % 5, i / 25 % 5, i / 125)) {
        let (min, max) = (IVec2::new(x0, y0), IVec2::new(x1, y1));
        let inside = |p: IVec2| x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1;
        let on_side = |p: IVec2| inside(p) && (p.x == x0 || p.x == x1 || p.y == y0 || p.y == y1);
        let all = (0..25).map(|i| IVec2::new(i % 5, i / 5));
        let filled: Vec<_> = fill(min, max).collect();
        assert_eq!(
            filled,
            all.clone().filter(|&p| inside(p)).collect::<Vec<_>>()
        );
        let sides: Vec<_> = outline(min, max).collect();
        assert_eq!(
            sides.iter().copied().collect::<HashSet<_>>().len(),
            sides.len()
        );
        assert_eq!(
            sides.iter().copied().collect::<HashSet<_>>(),
            all.filter(|&p| on_side(p)).collect(),
            "{min} {max}"
        );
        assert_eq!(
            outline(min, max).size_hint(),
            (sides.len(), Some(sides.len()))
        );
        let (mut plain, mut work) = (vec![], Work::default());
        outline_plain(min, max, &mut work, |p| plain.push(p));
        assert_eq!(plain, sides);
        plain.clear();
        fill_plain(min, max, &mut work, |p| plain.push(p));
        assert_eq!((plain.len() as u64, plain), (work.fragments, filled));
    }
}

/// A step is lazy, so the whole of i32 × i32 can be begun.
#[test]
fn extremes() {
    let (lowest, highest) = (IVec2::MIN, IVec2::MAX);
    let mut all = fill(lowest, highest);
    assert_eq!(all.size_hint(), (usize::MAX, None));
    assert_eq!(all.next(), Some(lowest));
    if let Ok(left) = usize::try_from(u64::MAX) {
        assert_eq!(all.size_hint(), (left, Some(left)));
    }
    let round = outline(lowest, highest);
    assert_eq!(round.clone().next(), Some(lowest));
    if usize::BITS == 64 {
        let pixels = ((1 << 32) - 1) * 4;
        assert_eq!(round.size_hint(), (pixels, Some(pixels)));
    }
    assert_eq!(round.last(), Some(IVec2::new(i32::MIN, i32::MIN + 1)));
    assert_eq!(outline(highest, lowest).next(), None);
    assert_eq!(fill(highest, lowest).next(), None);
    assert_eq!(fill(highest, highest).collect::<Vec<_>>(), [highest]);
    assert_eq!(outline(highest, highest).collect::<Vec<_>>(), [highest]);
    if usize::BITS == 64 {
        // 2⁶⁴ pixels in rows of 2³²: pixel number n is column n mod 2³² of row n / 2³².
        let all = || fill(lowest, highest);
        let at = |x, y| Some(IVec2::new(x, y));
        assert_eq!(all().nth((1 << 32) - 1), at(i32::MAX, i32::MIN));
        assert_eq!(all().nth(1 << 32), at(i32::MIN, i32::MIN + 1));
        assert_eq!(all().nth(3 << 62), at(i32::MIN, 1 << 30));
        assert_eq!(all().nth(usize::MAX), at(i32::MAX, i32::MAX));
        assert_eq!((all().last(), all().count()), (Some(highest), usize::MAX));
        // From the middle of a row on, the numbers run past the end.
        let mut rest = all();
        assert_eq!(rest.nth(1 << 31), at(0, i32::MIN));
        assert_eq!(rest.size_hint().0, usize::MAX - (1 << 31));
        assert_eq!(
            (rest.clone().nth(usize::MAX), rest.count()),
            (None, usize::MAX - (1 << 31))
        );
        // One column, 2³² rows; one row, 2³² columns.
        let column = || fill(lowest, IVec2::new(i32::MIN, i32::MAX));
        assert_eq!(column().nth((1 << 32) - 1), at(i32::MIN, i32::MAX));
        assert_eq!((column().nth(1 << 32), column().count()), (None, 1 << 32));
        let row = || fill(IVec2::new(i32::MIN, i32::MAX), highest);
        assert_eq!(row().nth((1 << 32) - 1), Some(highest));
        assert_eq!((row().nth(1 << 32), row().count()), (None, 1 << 32));
    }
    let corner = IVec2::splat(i32::MAX - 1);
    for (min, max) in [(lowest, lowest + 1), (corner, highest)] {
        let mut plain = vec![];
        fill_plain(min, max, &mut (), |p| plain.push(p));
        outline_plain(min, max, &mut (), |p| plain.push(p));
        assert!(fill(min, max).chain(outline(min, max)).eq(plain));
    }
    let mut none = fill(highest, lowest);
    assert_eq!((none.nth(1), none.size_hint()), (None, (0, Some(0))));
    assert_eq!((none.clone().last(), none.count()), (None, 0));
    let last_row = fill(IVec2::new(i32::MAX - 2, i32::MAX), highest);
    assert_eq!(
        last_row.map(|p| p.x).collect::<Vec<_>>(),
        [i32::MAX - 2, i32::MAX - 1, i32::MAX]
    );
}

proptest! {
    /// One by one, all at once, and some of each.
    #[test]
    fn fold_and_size_agree_with_next(min in prop::array::uniform2(-9..9i32), size in prop::array::uniform2(0..9i32), taken in 0..100usize) {
        let min = IVec2::from(min);
        let max = min + IVec2::from(size);
        let mut pixels = fill(min, max);
        for _ in 0..taken {
            pixels.next();
        }
        let mut one_by_one = vec![];
        let mut rest = pixels.clone();
        for p in rest.by_ref() {
            one_by_one.push(p);
        }
        prop_assert_eq!(pixels.size_hint(), (one_by_one.len(), Some(one_by_one.len())));
        let at_once = pixels.fold(vec![], |mut all, p| { all.push(p); all });
        prop_assert_eq!(at_once, one_by_one);
    }

    /// A jump is as many steps, from anywhere, and so is the one after it.
    #[test]
    fn nth_agrees_with_next(
        corner in prop_oneof![Just(i32::MIN), Just(i32::MAX - 8), -9..9i32],
        size in prop::array::uniform2(0..9i32),
        taken in 0..30usize,
        jumps in prop::collection::vec(0..40usize, 1..4),
    ) {
        let min = IVec2::splat(corner);
        let mut jumping = fill(min, min + IVec2::from(size));
        for _ in 0..taken {
            jumping.next();
        }
        let mut stepping = jumping.clone();
        for n in jumps {
            for _ in 0..n {
                stepping.next();
            }
            prop_assert_eq!(jumping.nth(n), stepping.next());
            prop_assert_eq!(jumping.size_hint(), stepping.size_hint());
        }
        let mut last = None;
        let mut count = 0;
        for pixel in stepping {
            (last, count) = (Some(pixel), count + 1);
        }
        prop_assert_eq!((jumping.clone().last(), jumping.count()), (last, count));
    }
}
