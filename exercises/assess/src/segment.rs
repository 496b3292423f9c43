//! What is asked of the pixels of a segment, checked in whole numbers pixel by pixel.

use glam::{DVec2, IVec2};

use crate::{Ink, Inputs, Panel, Picture, calls_within, first_calls, watched};

/// A segment between two pixels.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// The first pixel.
    pub a: IVec2,
    /// The last pixel.
    pub b: IVec2,
}

impl Segment {
    /// The segment from `a` to `b`.
    #[must_use]
    pub fn new(a: IVec2, b: IVec2) -> Self {
        Self { a, b }
    }

    /// A segment in any of the eight octants, |dx| or |dy| being `run` and the other one smaller or equal.
    pub fn any(inputs: &mut Inputs, run: i32) -> Self {
        let a = IVec2::from([(); 2].map(|()| inputs.integer(-100, 100)));
        let mut way = IVec2::new(run, inputs.integer(0, run));
        if inputs.integer(0, 1) == 1 {
            way = IVec2::new(way.y, way.x);
        }
        let signs = [(); 2].map(|()| 2 * inputs.integer(0, 1) - 1);
        Self::new(a, a + way * IVec2::from(signs))
    }

    /// The pixels that `draw` plots, at most twice as many as there should be.
    ///
    /// # Panics
    ///
    /// When it plots more: the loop does not end.
    #[track_caller]
    pub fn drawn_by(
        self,
        draw: impl FnOnce(IVec2, IVec2, &mut dyn FnMut(i32, i32)) + Send + 'static,
    ) -> Vec<(i32, i32)> {
        let (dx, dy) = self.way();
        let limit = 2 * (dx.abs().max(dy.abs()) as usize + 1);
        watched(&self.show(), move || {
            calls_within(&self.show(), limit, |take| {
                draw(self.a, self.b, &mut |x, y| take((x, y)));
            })
        })
    }

    /// The first `limit` pixels that `draw` plots; `Err` where a number overflows.
    pub fn begun_by(
        self,
        limit: usize,
        draw: impl FnOnce(IVec2, IVec2, &mut dyn FnMut(i32, i32)) + Send + 'static,
    ) -> Result<Vec<(i32, i32)>, String> {
        watched(&self.show(), move || {
            first_calls(limit, |take| {
                draw(self.a, self.b, &mut |x, y| take((x, y)));
            })
        })
    }

    /// b − a.
    fn way(self) -> (i64, i64) {
        let minus = |b: i32, a: i32| i64::from(b) - i64::from(a);
        (minus(self.b.x, self.a.x), minus(self.b.y, self.a.y))
    }

    /// The end points and the way between them, for a message.
    #[must_use]
    pub fn show(self) -> String {
        let Self { a, b } = self;
        let (dx, dy) = self.way();
        format!(
            "({}, {}) to ({}, {}) (dx {dx}, dy {dy})",
            a.x, a.y, b.x, b.y
        )
    }

    /// Fails unless `pixels` is the segment: from `a` to `b`, one pixel a column where |dx| ≥ |dy|, else one a
    /// row, each the nearest to the line, and of two equally near the one nearer the start.
    ///
    /// # Panics
    ///
    /// When it is not, with the first pixel that breaks a rule, and the rule.
    #[track_caller]
    pub fn assert_pixels(self, pixels: &[(i32, i32)]) {
        let (dx, dy) = self.way();
        let what = self.show();
        let _picture = self.picture(pixels);
        let (count, want) = (
            pixels.len() as u64,
            dx.abs().max(dy.abs()).unsigned_abs() + 1,
        );
        assert!(count > 0, "{what}: no pixel is plotted");
        if self.a != self.b {
            let turned: Vec<_> = pixels.iter().rev().copied().collect();
            assert!(
                count != want || !self.nearest(&turned),
                "{what}: the pixels run from b to a: the first one must be a",
            );
            assert!(
                count != want - 1 || !self.nearest(pixels),
                "{what}: the last pixel is missing: plot is called {count}×, but the segment includes b, {want} pixels",
            );
            let with_a: Vec<_> = [self.a.into()].iter().chain(pixels).copied().collect();
            assert!(
                count != want - 1 || !self.nearest(&with_a),
                "{what}: the first pixel is missing: plot is called {count}×, but the segment includes a, {want} pixels",
            );
        }
        assert!(
            count <= want,
            "{what}: plot is called {count}×, but max(|dx|, |dy|) steps lead from a to b, with both ends {want} pixels"
        );
        self.check_beginning(pixels);
        assert!(
            count == want,
            "{what}: plot is called {count}×, but max(|dx|, |dy|) steps lead from a to b, with both ends {want} pixels"
        );
    }

    /// The pixels beside the right ones, round the first that is wrong.
    #[track_caller]
    pub fn picture(self, pixels: &[(i32, i32)]) -> Picture {
        const SHOWN: i64 = 24;
        let (run, rise, steep) = self.octant();
        let wanted: Vec<(i32, i32)> = (0..=run.min(1 << 16))
            .map(|i| {
                // The nearest whole number, a tie towards 0.
                let across = if run == 0 {
                    0
                } else {
                    (2 * i * rise + run - 1) / (2 * run)
                };
                self.at(i, across, steep)
            })
            .collect();
        let differs = |i: &usize| pixels.get(*i) != wanted.get(*i);
        let first = (0..wanted.len()).find(differs).unwrap_or(0) as i64;
        let from = (first - SHOWN / 3).max(0) as usize;
        let window = from..from + SHOWN as usize;
        let near: Vec<_> = window.clone().filter_map(|i| wanted.get(i)).collect();
        let (Some(low), Some(high)) = (
            near.iter()
                .map(|&&(x, y)| (x.min(x), y))
                .reduce(|a, b| (a.0.min(b.0), a.1.min(b.1))),
            near.iter()
                .map(|&&p| p)
                .reduce(|a, b| (a.0.max(b.0), a.1.max(b.1))),
        ) else {
            return Picture::beside(Panel::pixels(), Panel::pixels());
        };
        // What is drawn far from there is not shown, or the cells would be too small to see.
        let is_near = |&(x, y): &(i32, i32)| {
            let within = |v: i32, low: i32, high: i32| {
                (i64::from(low) - 4..=i64::from(high) + 4).contains(&i64::from(v))
            };
            within(x, low.0, high.0) && within(y, low.1, high.1)
        };
        let (mut yours, mut right) = (Panel::pixels(), Panel::pixels());
        for &&(x, y) in &near {
            right.pixel(x, y, Ink::Right);
            let is_drawn = pixels.contains(&(x, y));
            yours.pixel(x, y, if is_drawn { Ink::Right } else { Ink::Missing });
        }
        let mut extra: Vec<_> = pixels.iter().filter(|p| is_near(p)).collect();
        extra.retain(|p| !wanted.contains(p));
        extra
            .into_iter()
            .take(200)
            .for_each(|&(x, y)| yours.pixel(x, y, Ink::Extra));
        // The line itself, between the ends of what is shown.
        let ends = [window.start as i128, (window.end as i128 - 1).min(run)].map(|i| {
            let along = i as f64;
            let across = if run == 0 {
                0.0
            } else {
                along * rise as f64 / run as f64
            };
            let (dx, dy) = self.way();
            let (x, y) = if steep {
                (across, along)
            } else {
                (along, across)
            };
            let sign = |d: i64| if d < 0 { -1.0 } else { 1.0 };
            DVec2::new(
                f64::from(self.a.x) + sign(dx) * x + 0.5,
                f64::from(self.a.y) + sign(dy) * y + 0.5,
            )
        });
        for panel in [&mut yours, &mut right] {
            panel.segment(ends[0], ends[1], Ink::Ideal);
        }
        Picture::beside(yours, right)
    }

    /// The pixel so far along the longer axis and across it.
    fn at(self, along: i128, across: i128, steep: bool) -> (i32, i32) {
        let (dx, dy) = self.way();
        let (x, y) = if steep {
            (across, along)
        } else {
            (along, across)
        };
        let (x, y) = (x * i128::from(dx.signum()), y * i128::from(dy.signum()));
        // Between a and b, so within i32.
        (
            (i128::from(self.a.x) + x) as i32,
            (i128::from(self.a.y) + y) as i32,
        )
    }

    /// Fails unless the segment begins with `pixels`.
    ///
    /// # Panics
    ///
    /// As [`Segment::assert_pixels`].
    #[track_caller]
    pub fn assert_begins_with(self, pixels: &[(i32, i32)]) {
        let _picture = self.picture(pixels);
        self.check_beginning(pixels);
    }

    #[track_caller]
    fn check_beginning(self, pixels: &[(i32, i32)]) {
        let what = self.show();
        let (run, rise, steep) = self.octant();
        let all = |rule: &dyn Fn(i64, (i64, i64)) -> bool| {
            (0..)
                .zip(pixels)
                .all(|(i, &pixel)| rule(i, self.offset(pixel)))
        };
        let nearest = self.nearest(pixels);
        assert!(!pixels.is_empty(), "{what}: no pixel is plotted");
        assert!(
            pixels.first() == Some(&self.a.into()) || pixels.len() < 2,
            "{what}: the first pixel is {:?}, not a",
            pixels[0],
        );
        // The same pixels on the other side of a, in x, in y or in both.
        for (sx, sy, names) in [(-1, 1, "x"), (1, -1, "y"), (-1, -1, "x and y")] {
            let mirror = |&(x, y): &(i32, i32)| {
                let (x, y) = Self::new(self.a, IVec2::new(x, y)).way();
                let at = |a: i32, d: i64| i32::try_from(i64::from(a) + d).ok();
                Some((at(self.a.x, sx * x)?, at(self.a.y, sy * y)?))
            };
            let mirrored: Option<Vec<_>> = pixels.iter().map(mirror).collect();
            assert!(
                nearest || pixels.len() < 5 || !mirrored.is_some_and(|m| self.nearest(&m)),
                "{what}: {names} goes away from b: the sign of {} is lost",
                names.replace('x', "dx").replace('y', "dy"),
            );
        }
        // Fewer pixels do not tell.
        let exchanged = pixels.len() >= 5
            && all(&|i, (along, across)| across == i && self.doubled_distance(i, along) <= run);
        assert!(
            nearest || !exchanged,
            "{what}: these are the pixels of the segment with dx and dy exchanged: what was swapped to come into the \
             octant of the slide must be swapped back before it is plotted",
        );
        let by_columns = pixels.len() >= 2 && all(&|i, (_, across)| across == i);
        assert!(
            nearest || !steep || !by_columns,
            "{what}: one pixel a column leaves gaps here: where |m| > 1 there is one a row",
        );
        let line = if steep { "row" } else { "column" };
        for (i, &pixel) in (0..).zip(pixels) {
            let (along, across) = self.offset(pixel);
            assert!(
                along == i && i128::from(along) <= run,
                "{what}: pixel {i} is {pixel:?}, but from a to b there is one pixel in each {line}",
            );
            let distance = self.doubled_distance(i, across);
            let exact = i128::from(i) * rise;
            assert!(
                distance <= run,
                "{what}: {pixel:?} is not the pixel of its {line} nearest to the line, which passes {} from a, not \
                 {across}",
                fraction(exact, run),
            );
            assert!(
                run == 0 || distance < run || i128::from(across) * run < exact,
                "{what}: at {pixel:?} the line passes halfway between two pixels of the {line}: the one nearer the \
                 start is asked for",
            );
        }
    }

    /// Whether there is one pixel a column, or a row, and each is one of those nearest to the line.
    #[must_use]
    pub fn nearest(self, pixels: &[(i32, i32)]) -> bool {
        let (run, ..) = self.octant();
        self.all_within(run, pixels)
    }

    /// Whether there is one pixel a column, or a row, and each is at most 1 from the line.
    #[must_use]
    pub fn within_one(self, pixels: &[(i32, i32)]) -> bool {
        let (run, ..) = self.octant();
        self.all_within(2 * run, pixels)
    }

    fn all_within(self, doubled_distance: i128, pixels: &[(i32, i32)]) -> bool {
        (0..).zip(pixels).all(|(i, &pixel)| {
            let (along, across) = self.offset(pixel);
            along == i && self.doubled_distance(along, across) <= doubled_distance
        })
    }

    /// The larger and the smaller of |dx| and |dy|, and whether |dy| is the larger one.
    fn octant(self) -> (i128, i128, bool) {
        let (dx, dy) = self.way();
        let (dx, dy) = (i128::from(dx.abs()), i128::from(dy.abs()));
        (dx.max(dy), dx.min(dy), dx < dy)
    }

    /// How far a pixel lies from a: along the longer axis, and across it.
    fn offset(self, pixel: (i32, i32)) -> (i64, i64) {
        let (dx, dy) = self.way();
        let (x, y) = Self::new(self.a, pixel.into()).way();
        let x = if dx < 0 { -x } else { x };
        let y = if dy < 0 { -y } else { y };
        if dx.abs() < dy.abs() { (y, x) } else { (x, y) }
    }

    /// Twice the distance between the line and a pixel, in the pixel's column or row, times run.
    fn doubled_distance(self, along: i64, across: i64) -> i128 {
        let (run, rise, _) = self.octant();
        (2 * (i128::from(along) * rise - i128::from(across) * run)).abs()
    }
}

/// A quotient as a mixed number: `3 + 1/2`.
fn fraction(numerator: i128, denominator: i128) -> String {
    let denominator = denominator.max(1);
    let (whole, rest) = (numerator / denominator, numerator % denominator);
    if rest == 0 {
        whole.to_string()
    } else {
        format!("{whole} + {rest}/{denominator}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RIGHT: [(i32, i32); 9] = [
        (0, 0),
        (1, 0),
        (2, 1),
        (3, 1),
        (4, 1),
        (5, 2),
        (6, 2),
        (7, 3),
        (8, 3),
    ];

    fn slide() -> Segment {
        Segment::new(IVec2::ZERO, IVec2::new(8, 3))
    }

    #[test]
    fn the_right_pixels_pass_in_all_octants() {
        for (signs, swap) in [(1, 1), (1, -1), (-1, 1), (-1, -1)]
            .into_iter()
            .flat_map(|signs| [(signs, false), (signs, true)])
        {
            let turn = |(x, y)| {
                let (x, y) = if swap { (y, x) } else { (x, y) };
                (signs.0 * x + 5, signs.1 * y - 7)
            };
            let segment = Segment::new(turn((0, 0)).into(), turn((8, 3)).into());
            segment.assert_pixels(&RIGHT.map(turn));
            segment.assert_begins_with(&RIGHT.map(turn)[..4]);
        }
        Segment::new(IVec2::ONE, IVec2::ONE).assert_pixels(&[(1, 1)]);
        Segment::new(IVec2::MIN, IVec2::MAX).assert_begins_with(&[(i32::MIN, i32::MIN)]);
    }

    #[test]
    #[should_panic(expected = "(0, 0) to (8, 3) (dx 8, dy 3): at (4, 2) the line passes halfway")]
    fn a_tie_to_the_far_side_is_named() {
        let mut pixels = RIGHT;
        pixels[4].1 = 2;
        slide().assert_pixels(&pixels);
    }

    #[test]
    #[should_panic(expected = "which passes 1 + 7/8 from a, not 1")]
    fn a_pixel_too_far_is_named() {
        let mut pixels = RIGHT;
        pixels[5].1 = 1;
        slide().assert_pixels(&pixels);
    }

    #[test]
    #[should_panic(
        expected = "the last pixel is missing: plot is called 8×, but the segment includes b, 9 pixels"
    )]
    fn a_missing_end_is_named() {
        slide().assert_pixels(&RIGHT[..8]);
    }

    #[test]
    #[should_panic(expected = "the first pixel is missing: plot is called 8×")]
    fn a_missing_start_is_named() {
        slide().assert_pixels(&RIGHT[1..]);
    }

    #[test]
    #[should_panic(expected = "y goes away from b: the sign of dy is lost")]
    fn a_lost_sign_is_named() {
        slide().assert_pixels(&RIGHT.map(|(x, y)| (x, -y)));
    }

    #[test]
    #[should_panic(expected = "the pixels run from b to a")]
    fn the_other_direction_is_named() {
        let mut pixels = RIGHT;
        pixels.reverse();
        slide().assert_pixels(&pixels);
    }

    #[test]
    #[should_panic(expected = "dx and dy exchanged")]
    fn swapped_axes_are_named() {
        slide().assert_pixels(&RIGHT.map(|(x, y)| (y, x)));
    }

    #[test]
    #[should_panic(expected = "one pixel a column leaves gaps")]
    fn gaps_are_named() {
        Segment::new(IVec2::ZERO, IVec2::new(2, 8)).assert_pixels(&[(0, 0), (1, 4), (2, 8)]);
    }

    #[test]
    fn any_segment_is_in_any_octant() {
        let mut inputs = Inputs::new(1);
        let ways = (0..100).map(|_| Segment::any(&mut inputs, 5).way());
        let octants: std::collections::BTreeSet<_> = ways
            .map(|(dx, dy)| {
                assert_eq!(dx.abs().max(dy.abs()), 5);
                (dx < 0, dy < 0, dx.abs() < dy.abs())
            })
            .collect();
        assert_eq!(octants.len(), 8);
    }

    #[test]
    #[should_panic(expected = "dy 0): 4 steps were enough and the loop still runs")]
    fn a_segment_without_an_end_is_stopped() {
        let endless = |a: IVec2, _, plot: &mut dyn FnMut(i32, i32)| loop {
            plot(a.x, a.y);
        };
        Segment::new(IVec2::ZERO, IVec2::X).drawn_by(endless);
    }

    #[test]
    #[should_panic(expected = "no pixel is plotted")]
    fn nothing_is_named() {
        slide().assert_pixels(&[]);
    }
}
