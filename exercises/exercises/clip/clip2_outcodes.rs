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
    use assess::{Inputs, show_point};
    use glam::DVec2;

    /// The nine regions as the slide shows them, y up.
    const REGIONS: [[u8; 3]; 3] = [
        [0b1001, 0b1000, 0b1010],
        [0b0001, 0b0000, 0b0010],
        [0b0101, 0b0100, 0b0110],
    ];

    #[test]
    fn nine_regions() {
        let window = Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        };
        for (y, row) in [15.0, 5.0, -5.0].into_iter().zip(REGIONS) {
            for (x, want) in [-5.0, 5.0, 15.0].into_iter().zip(row) {
                let got = outcode(window, DVec2::new(x, y));
                assert!(
                    got == want,
                    "({x}, {y}), window 0…10: expected {want:04b}, got {got:04b}"
                );
            }
        }
    }

    #[test]
    fn any_point() {
        let mut inputs = Inputs::new(33);
        let mut all = Vec::new();
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
            all.push((
                window,
                p,
                outcode(window, p),
                REGIONS[row as usize][column as usize],
            ));
        }
        let is = |other: fn(u8) -> u8| all.iter().all(|&(_, _, got, want)| got == other(want));
        assert!(
            !is(|code| code.reverse_bits() >> 4),
            "the bits are those of the slide from right to left: its first bit, above, is the leftmost, 1000",
        );
        assert!(
            !is(|code| code & 0b0011 | code >> 1 & 0b0100 | code << 1 & 0b1000),
            "above and below are exchanged: in a window y points up, and above is y > y_max",
        );
        assert!(
            !is(|code| code & 0b1100 | code >> 1 & 0b0001 | code << 1 & 0b0010),
            "right and left are exchanged: the 3rd digit is right, x > x_max, the 4th left",
        );
        let one_bit = all.iter().all(|(.., got, want)| {
            got & !want == 0 && got.count_ones() == want.count_ones().min(1)
        });
        assert!(
            !one_bit,
            "every code is right but for the corners, where one bit is set and the other one lost: a corner lies beyond \
             two sides, so four `if`, no `else`, and each adds its bit, `|=`",
        );
        for (window, p, got, want) in all {
            assert!(
                got == want,
                "{}, window {} to {}: expected {want:04b}, got {got:04b}",
                show_point(p),
                show_point(window.min),
                show_point(window.max),
            );
        }
    }

    #[test]
    fn on_the_border() {
        let window = Window {
            min: DVec2::new(-3.0, 2.0),
            max: DVec2::new(4.0, 7.0),
        };
        for p in [
            (-3.0, 2.0),
            (4.0, 7.0),
            (-3.0, 5.0),
            (4.0, 3.0),
            (0.0, 2.0),
            (1.0, 7.0),
        ]
        .map(DVec2::from)
        {
            let got = outcode(window, p);
            assert!(
                got == 0,
                "{} is on the border of the window (-3, 2) to (4, 7), so inside; beyond means > or <: got {got:04b}",
                show_point(p),
            );
        }
    }

    #[test]
    fn any_verdict() {
        let ands = [
            (0b1001, 0b1010, 0b1000),
            (0b0100, 0b0100, 0b0100),
            (0b0001, 0b0101, 0b0001),
        ];
        for (a, b, and) in ands {
            let got = verdict(a, b);
            assert!(
                got == Verdict::Outside,
                "{a:04b} ∧ {b:04b} = {and:04b}: outside, got {got:?}"
            );
        }
        // Region by region: column and row tell which sides an end is beyond.
        let regions = || (0..9).map(|region| (region % 3, region / 3));
        for (i, j) in regions() {
            for (k, l) in regions() {
                let (a, b) = (REGIONS[j][i], REGIONS[l][k]);
                let want = if [i, j, k, l] == [1; 4] {
                    Verdict::Inside
                } else if (i == k && i != 1) || (j == l && j != 1) {
                    Verdict::Outside
                } else {
                    Verdict::Cut
                };
                let got = verdict(a, b);
                assert!(
                    want != Verdict::Cut || got != Verdict::Outside,
                    "{a:04b} and {b:04b}: got {got:?}, but no side has both ends beyond it: outside is AND ≠ 0000, not \
                     OR ≠ 0000",
                );
                assert!(
                    got == want,
                    "{a:04b} and {b:04b}: expected {want:?}, got {got:?}"
                );
            }
        }
    }

    #[test]
    fn far_away() {
        let window = Window {
            min: DVec2::splat(-1e308),
            max: DVec2::splat(1e308),
        };
        for (p, want) in [
            ((f64::MAX, 0.0), 0b0010),
            ((f64::NEG_INFINITY, f64::INFINITY), 0b1001),
            ((0.0, -f64::MAX), 0b0100),
        ] {
            let got = outcode(window, p.into());
            assert!(
                got == want,
                "{p:?}, window ±1e308: expected {want:04b}, got {got:04b}"
            );
        }
    }
}
