//! The decisions of a segment, one a move.

use core::fmt;
use core::iter::FusedIterator;

use ombra_math::glam::IVec2;

use super::{Pixels, segment};

/// The decisions on the way from `a` to `b`: one [`Step`] a move, so none for the last pixel.
///
/// # Formula
///
/// ```text
/// 2d = 2F(x_P + 1, y_P + ½)        2d ≤ 0: E,   2d > 0: NE
/// ```
///
/// # Properties
///
/// Max(|dx|, |dy|) steps; `nth`, `last` and `count` jump. The pixels are where they are; the choices are the slide's octant's, so that E moves along
/// the longer axis and NE along both, in whatever direction that is.
///
/// # Pitfalls
///
/// The decision at P chooses the pixel after P, not P.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::bresenham::{self, Choice::{E, NE}};
///
/// let steps: Vec<_> = bresenham::trace(IVec2::ZERO, IVec2::new(8, 3)).collect();
/// let decisions: Vec<i64> = steps.iter().map(|s| s.decision).collect();
/// let choices: Vec<_> = steps.iter().map(|s| s.choice).collect();
/// assert_eq!(decisions, [-2, 4, -6, 0, 6, -4, 2, -8]);
/// assert_eq!(choices, [E, NE, E, E, NE, E, NE, E]);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo di Bresenham».
pub fn trace(a: IVec2, b: IVec2) -> Trace {
    segment(a, b).trace()
}

/// A decision of [`trace`].
#[doc(alias = "decision variable")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    /// P, the pixel where the decision is taken.
    pub pixel: IVec2,
    /// 2d: twice F at the midpoint after P.
    pub decision: i64,
    /// The way on.
    pub choice: Choice,
}

/// One of the two ways on from a pixel, in the octant of the slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Choice {
    /// East: along the longer axis.
    E,
    /// North-east: along both axes.
    NE,
}

impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::E => "E",
            Self::NE => "NE",
        })
    }
}

/// The steps of [`trace`].
#[derive(Clone, Debug)]
pub struct Trace {
    pixels: Pixels,
}

impl Pixels {
    /// The decisions between these pixels; after [`clipped`](super::clipped), those inside the window.
    #[must_use]
    pub fn trace(self) -> Trace {
        Trace { pixels: self }
    }
}

impl Iterator for Trace {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        if self.pixels.left < 2 {
            return None;
        }
        let decision = self.pixels.decision();
        let choice = if decision > 0 { Choice::NE } else { Choice::E };
        self.pixels.next().map(|pixel| Step {
            pixel,
            decision,
            choice,
        })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let moves = self.pixels.left.saturating_sub(1);
        usize::try_from(moves).map_or((usize::MAX, None), |n| (n, Some(n)))
    }

    fn last(mut self) -> Option<Step> {
        self.pixels.skip_moves(self.pixels.left.saturating_sub(2));
        self.next()
    }

    fn count(self) -> usize {
        usize::try_from(self.pixels.left.saturating_sub(1)).unwrap_or(usize::MAX)
    }

    fn nth(&mut self, n: usize) -> Option<Step> {
        let moves = self.pixels.left.saturating_sub(1);
        self.pixels.skip_moves(moves.min(n as u64));
        self.next()
    }
}

impl FusedIterator for Trace {}

/// There are at most 2³² − 1 moves.
#[cfg(any(target_pointer_width = "32", target_pointer_width = "64"))]
impl ExactSizeIterator for Trace {}

#[cfg(test)]
mod tests {
    use super::Choice::{E, NE};
    use super::*;

    #[test]
    fn the_lectures_decisions() {
        let steps: Vec<_> = trace(IVec2::ZERO, IVec2::new(8, 3))
            .map(|s| (s.pixel.x, s.pixel.y, s.decision, s.choice))
            .collect();
        let expected = [
            (0, 0, -2, E),
            (1, 0, 4, NE),
            (2, 1, -6, E),
            (3, 1, 0, E),
            (4, 1, 6, NE),
            (5, 2, -4, E),
            (6, 2, 2, NE),
            (7, 3, -8, E),
        ];
        assert_eq!(steps, expected);
    }

    /// The decision is F of the definition at the midpoint, in the octant where the segment has its place.
    #[test]
    fn decisions_are_f_at_the_midpoint() {
        for (x, y) in (0..625_i32).map(|i| (i % 25 - 12, i / 25 - 12)) {
            let (dx, dy) = (
                i64::from(x.abs().max(y.abs())),
                i64::from(x.abs().min(y.abs())),
            );
            let mut moves = 0;
            for (i, step) in trace(IVec2::ZERO, IVec2::new(x, y)).enumerate() {
                let (p, q) = (i64::from(step.pixel.x.abs()), i64::from(step.pixel.y.abs()));
                let (x_p, y_p) = if x.abs() >= y.abs() { (p, q) } else { (q, p) };
                assert_eq!(x_p, i as i64);
                assert_eq!(step.decision, 2 * dy * (x_p + 1) - dx * (2 * y_p + 1));
                assert_eq!(step.choice == NE, step.decision > 0);
                moves += 1;
            }
            assert_eq!(moves, dx);
        }
    }

    #[test]
    fn a_point_decides_nothing() {
        assert_eq!(trace(IVec2::MAX, IVec2::MAX).next(), None);
        assert_eq!(trace(IVec2::MAX, IVec2::MAX).nth(1), None);
        assert_eq!(trace(IVec2::MAX, IVec2::MAX).len(), 0);
    }

    #[test]
    fn the_longest_segments_decisions() {
        let mut steps = trace(IVec2::MIN, IVec2::MAX);
        let run = i64::from(u32::MAX);
        assert_eq!(steps.clone().count() as u64, u64::from(u32::MAX));
        assert_eq!(
            steps.next().map(|s| (s.decision, s.choice)),
            Some((run, NE))
        );
        assert_eq!(
            steps.last(),
            Some(Step {
                pixel: IVec2::MAX - 1,
                decision: run,
                choice: NE
            })
        );
    }

    #[test]
    fn a_choice_reads_as_on_the_slide() {
        assert_eq!(format!("{E} {NE} {E:>2}"), "E NE  E");
    }
}
