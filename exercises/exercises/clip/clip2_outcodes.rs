use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// What the codes of two ends say about a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    /// It lies in the window.
    Inside,
    /// It lies beyond one of the sides.
    Outside,
    /// The codes do not tell: it must be cut.
    Cut,
}

/// The code of the region in which a point lies: four binary digits, read from left to right.
///
/// ```text
/// 1001 │ 1000 │ 1010          1st  1000   above the upper side    y > y_max
/// ─────┼──────┼─────          2nd  0100   below the lower side    y < y_min
/// 0001 │ 0000 │ 0010          3rd  0010   right of the right side x > x_max
/// ─────┼──────┼─────          4th  0001   left of the left side   x < x_min
/// 0101 │ 0100 │ 0110
/// ```
///
/// In a window y points up. The border is inside. Coordinates are not NaN.
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn outcode(window: Window, p: DVec2) -> u8 {
    // TODO: a bit for each side that the point lies beyond.
    todo!()
}

/// What the codes of its two ends say about a segment.
///
/// ```text
/// OR of the codes = 0000     inside: no end lies beyond any side
/// AND of the codes ≠ 0000    outside: both ends lie beyond the same side
/// else                       cut
/// ```
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn verdict(a: u8, b: u8) -> Verdict {
    // TODO: OR, then AND.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod clip2_outcodes {
    use super::{Verdict, Window, outcode, verdict};
    use assess::{Inputs, SIDES, point_beside, short_point, show_point};
    use glam::DVec2;

    /// The nine regions as the slide shows them, y up.
    const REGIONS: [[u8; 3]; 3] = [
        [0b1001, 0b1000, 0b1010],
        [0b0001, 0b0000, 0b0010],
        [0b0101, 0b0100, 0b0110],
    ];

    /// The condition of each digit.
    const CONDITIONS: [&str; 4] = ["y > y_max", "y < y_min", "x > x_max", "x < x_min"];

    #[track_caller]
    fn check(window: Window, p: DVec2, want: u8, why: &str) {
        let got = outcode(window, p);
        let (yours, right) = (format!("{got:04b}"), format!("{want:04b}"));
        let _picture = point_beside(window.min, window.max, p, &yours, &right);
        assert!(
            got == want,
            "{}, window {} to {}: expected {right}, got {yours}{why}",
            show_point(p),
            short_point(window.min),
            short_point(window.max),
        );
    }

    fn slide() -> Window {
        Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        }
    }

    /// What the codes of the nine regions have in common, when they are wrong.
    #[track_caller]
    fn plain() {
        let window = slide();
        let codes = |window: Window| -> Vec<(u8, u8)> {
            let rows = [15.0, 5.0, -5.0].into_iter().zip(REGIONS);
            rows.flat_map(|(y, row)| {
                let columns = [-5.0, 5.0, 15.0].into_iter().zip(row);
                columns.map(move |(x, want)| (outcode(window, DVec2::new(x, y)), want))
            })
            .collect()
        };
        let all = codes(window);
        if let Some((got, want)) = all.iter().find(|(got, _)| *got > 0b1111) {
            panic!(
                "the window 0…10 has a region with the code {want:04b}, got {got:b}, more than four binary digits: the \
                 slide's 1000 is 0b1000 in Rust"
            );
        }
        let turned = Window {
            min: window.max,
            max: window.min,
        };
        assert!(
            all.iter().all(|(got, want)| got == want)
                || codes(turned).iter().any(|(got, want)| got != want),
            "the nine codes are right when min and max are exchanged: above is y > y_max, below y < y_min"
        );
        let is = |other: fn(u8) -> u8| all.iter().all(|&(got, want)| got == other(want));
        assert!(
            !is(|_| 0),
            "0000 for each of the nine regions: no bit is ever set"
        );
        assert!(
            !is(|code| code.reverse_bits() >> 4),
            "the bits are those of the slide from right to left: its first bit, above, is the leftmost, 1000",
        );
        assert!(
            !is(|code| code ^ 0b1111),
            "each bit is 1 where it should be 0: a bit is 1 if the point lies beyond the side",
        );
        let exchange =
            |code: u8, bit: u8| code & !(bit | bit << 1) | code >> 1 & bit | (code & bit) << 1;
        assert!(
            !all.iter()
                .all(|&(got, want)| got == exchange(exchange(want, 1), 4)),
            "above and below, and right and left, are both exchanged: above is y > y_max, right is x > x_max",
        );
        assert!(
            !all.iter().all(|&(got, want)| got == exchange(want, 4)),
            "above and below are exchanged: in a window y points up, and above is y > y_max",
        );
        assert!(
            !all.iter().all(|&(got, want)| got == exchange(want, 1)),
            "right and left are exchanged: the 3rd digit is right, x > x_max, the 4th left",
        );
        assert!(
            !is(|code| code >> 2 | (code & 0b0011) << 2),
            "x and y are exchanged: the first two digits, above and below, belong to y",
        );
        let one_bit = all
            .iter()
            .all(|(got, want)| got & !want == 0 && got.count_ones() == want.count_ones().min(1));
        assert!(
            !one_bit,
            "every code is right but for the corners, where one bit is set and the other one lost: a corner lies beyond \
             two sides, so four `if`, no `else`, and each adds its bit, `|=`",
        );
        for (i, name) in SIDES.into_iter().enumerate() {
            let bit = 0b1000 >> i;
            let rest = all.iter().all(|(got, want)| got & !bit == want & !bit);
            let never = all.iter().all(|(got, _)| got & bit == 0);
            assert!(
                !rest || !never,
                "the digit of the {name} side, {bit:04b}, is never set, all others are right: it is 1 where {}",
                CONDITIONS[i],
            );
        }
    }

    #[test]
    fn nine_regions() {
        plain();
        for (y, row) in [5.0, 15.0, -5.0]
            .into_iter()
            .zip([1, 0, 2].map(|row| REGIONS[row]))
        {
            for (x, want) in [-5.0, 5.0, 15.0].into_iter().zip(row) {
                check(slide(), DVec2::new(x, y), want, "");
            }
        }
    }

    #[test]
    fn any_point() {
        plain();
        let mut inputs = Inputs::new(33);
        for _ in 0..400 {
            let mut any = |low, high| {
                DVec2::new(
                    inputs.integer(low, high).into(),
                    inputs.integer(low, high).into(),
                )
            };
            let (min, size, share) = (any(-20, 20), any(1, 20), any(1, 7) / 8.0);
            let window = Window {
                min,
                max: min + size,
            };
            // Column 0, 1 or 2 of the slide's table: left of the window, in it, right of it; rows from the top.
            let (column, row) = (inputs.integer(0, 2), inputs.integer(0, 2));
            let cell = DVec2::new(f64::from(column - 1), f64::from(1 - row));
            let p = min + (cell + share) * size;
            check(window, p, REGIONS[row as usize][column as usize], "");
        }
    }

    #[test]
    fn on_the_border() {
        plain();
        let window = Window {
            min: DVec2::new(-3.0, 2.0),
            max: DVec2::new(4.0, 7.0),
        };
        for p in [(0.0, 6.5), (0.0, 2.5), (3.5, 3.0), (-2.5, 3.0)].map(DVec2::from) {
            check(window, p, 0, ": it lies within all four sides");
        }
        for p in [
            (1.0, 7.0),
            (0.0, 2.0),
            (4.0, 3.0),
            (-3.0, 5.0),
            (-3.0, 2.0),
            (4.0, 7.0),
        ]
        .map(DVec2::from)
        {
            check(
                window,
                p,
                0,
                ": it is on the border, so inside; beyond means > or <",
            );
        }
    }

    #[test]
    fn a_hair_outside() {
        plain();
        for (scale, origin) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 1e6)] {
            let window = Window {
                min: DVec2::splat(origin + scale),
                max: DVec2::splat(origin + 11.0 * scale),
            };
            let middle = origin + 5.0 * scale;
            for (i, name) in SIDES.into_iter().enumerate() {
                let (border, out) = match i % 2 {
                    0 => (window.max.x, 1.0),
                    _ => (window.min.x, -1.0),
                };
                let place = |across| {
                    if i < 2 {
                        DVec2::new(middle, across)
                    } else {
                        DVec2::new(across, middle)
                    }
                };
                let bit = 0b1000 >> i;
                check(window, place(border - out * 0.3 * scale), 0, "");
                check(window, place(border + out * 0.3 * scale), bit, "");
                check(window, place(border), 0, ": it is on the border, so inside");
                for hair in [1e-3, 1e-6, 1e-9] {
                    let p = place(border + out * hair * scale);
                    let why = format!(
                        ": it lies {:e} beyond the {name} side: compare with the side itself, without a tolerance",
                        hair * scale
                    );
                    check(window, p, bit, &why);
                }
                let next = if out > 0.0 {
                    border.next_up()
                } else {
                    border.next_down()
                };
                let why = format!(
                    ": it lies beyond the {name} side by the least there is: compare with the side itself, with nothing that \
                     is computed from it"
                );
                check(window, place(next), bit, &why);
            }
        }
    }

    #[test]
    fn any_verdict() {
        let region = |i: usize| REGIONS[i / 3][i % 3];
        let pairs = || (0..9).flat_map(|i| (0..9).map(move |j| (i, j)));
        for other in [Verdict::Inside, Verdict::Outside, Verdict::Cut] {
            assert!(
                pairs().any(|(i, j)| verdict(region(i), region(j)) != other),
                "{other:?} for any two codes"
            );
        }
        let ands = [
            (0b1001, 0b1010, 0b1000),
            (0b0100, 0b0100, 0b0100),
            (0b0001, 0b0101, 0b0001),
        ];
        for (a, b, and) in ands {
            let got = verdict(a, b);
            assert!(
                got == Verdict::Outside,
                "{a:04b} ∧ {b:04b} = {and:04b}: both ends lie beyond one side, so Outside, but got {got:?}"
            );
        }
        // Column and row of a region tell which sides an end is beyond.
        for (i, j) in pairs() {
            let (a, b) = (region(i), region(j));
            let same = |p: usize, q: usize| p == q && p != 1;
            let want = if i == 4 && j == 4 {
                Verdict::Inside
            } else if same(i % 3, j % 3) || same(i / 3, j / 3) {
                Verdict::Outside
            } else {
                Verdict::Cut
            };
            let got = verdict(a, b);
            let why = match (want, got) {
                (Verdict::Inside, _) => "both ends are inside, OR = 0000",
                (Verdict::Outside, Verdict::Inside) => "OR is not 0000, and AND is not 0000 either",
                (Verdict::Outside, _) => "both ends lie beyond one side, AND ≠ 0000",
                (Verdict::Cut, Verdict::Outside) => {
                    "no side has both ends beyond it, AND = 0000, so it is not outside"
                }
                (Verdict::Cut, _) => {
                    "one end at least lies outside, so it is not inside: that is OR = 0000"
                }
            };
            assert!(
                got == want,
                "{a:04b} and {b:04b}: expected {want:?}, got {got:?}: {why}"
            );
        }
    }

    #[test]
    fn far_away() {
        plain();
        let window = Window {
            min: DVec2::splat(-1e308),
            max: DVec2::splat(1e308),
        };
        for (p, want) in [
            ((f64::MAX, 0.0), 0b0010),
            ((f64::NEG_INFINITY, f64::INFINITY), 0b1001),
            ((0.0, -f64::MAX), 0b0100),
        ] {
            check(window, p.into(), want, "");
        }
    }
}
