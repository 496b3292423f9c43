//! Segments of one length, and their exact pixels.

use ombra_math::glam::IVec2;

use crate::deviation::Deviation;
use crate::random::Random;

/// Segments that all have the same number of moves.
pub struct Segments {
    pub ends: Vec<(IVec2, IVec2)>,
    /// Moves from end to end.
    pub length: u32,
}

/// The pixels of all segments, as a number for each way in which two drawings could differ: how many, which, and in
/// which order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Drawn {
    pixels: u64,
    sum: u64,
    sum_of_sums: u64,
}

impl Drawn {
    fn put(&mut self, p: IVec2) {
        self.pixels += 1;
        let both = u64::from(p.x.cast_unsigned()) << 32 | u64::from(p.y.cast_unsigned());
        self.sum = self.sum.wrapping_add(both);
        self.sum_of_sums = self.sum_of_sums.wrapping_add(self.sum);
    }

    /// Takes in one pixel after another.
    pub fn all(&mut self, pixels: impl Iterator<Item = IVec2>) {
        *self = pixels.fold(*self, |mut drawn, p| {
            drawn.put(p);
            drawn
        });
    }
}

impl Segments {
    /// `number` of them with `length` moves, of any slope and in any octant.
    pub fn new(length: u32, number: u32) -> Self {
        let mut random = Random::new(1965);
        let long = i32::try_from(length).unwrap_or(i32::MAX);
        let ends = (0..number).map(|_| {
            let a = IVec2::new(
                random.between(-1e6, 1e6) as i32,
                random.between(-1e6, 1e6) as i32,
            );
            let short = random.between(0.0, f64::from(long) + 1.0) as i32;
            let bits = random.bits();
            let sign = |bit: u64| if bits & bit == 0 { 1 } else { -1 };
            let (x, y) = if bits & 4 == 0 {
                (long, short)
            } else {
                (short, long)
            };
            (a, a.saturating_add(IVec2::new(sign(1) * x, sign(2) * y)))
        });
        Self {
            ends: ends.collect(),
            length,
        }
    }

    /// All pixels.
    pub fn pixels(&self) -> usize {
        self.ends.len() * (self.length as usize + 1)
    }

    /// The pixels that `technique` puts into a drawing, a segment at a time.
    pub fn draw(&self, mut technique: impl FnMut(IVec2, IVec2, &mut Drawn)) -> Drawn {
        let mut drawn = Drawn::default();
        for &(a, b) in &self.ends {
            technique(a, b, &mut drawn);
        }
        drawn
    }

    /// The errors of a technique's pixels; all are missing if they are not the ones that were drawn.
    pub fn deviation<P: Iterator<Item = IVec2>>(
        &self,
        drawn: &Drawn,
        technique: impl Fn(IVec2, IVec2) -> P,
    ) -> Deviation {
        let mut again = Drawn::default();
        let errors = self.ends.iter().flat_map(|&(a, b)| {
            let line = ExactLine::new(a, b);
            let pixels = technique(a, b).map(Some).chain(core::iter::repeat(None));
            (0..=line.dx).zip(pixels).map(move |(i, p)| (line, i, p))
        });
        let deviation = Deviation::of(errors.map(|(line, i, p)| {
            again.put(p?);
            line.error(i, p?)
        }));
        if again == *drawn {
            deviation
        } else {
            Deviation::of(core::iter::repeat_n(None, self.pixels()))
        }
    }
}

/// The line through two pixels, i·dy/dx beside the first after i moves; for up to 2·10⁹ moves nothing overflows.
#[derive(Clone, Copy, Debug)]
struct ExactLine {
    a: IVec2,
    b: IVec2,
    dx: i64,
    dy: i64,
}

impl ExactLine {
    fn new(a: IVec2, b: IVec2) -> Self {
        let d = (b.as_i64vec2() - a.as_i64vec2()).abs();
        Self {
            a,
            b,
            dx: d.max_element(),
            dy: d.min_element(),
        }
    }

    /// How many pixels `p` is beside the one nearest to the line after `i` moves; `None` if it is not `i` moves along.
    fn error(self, i: i64, p: IVec2) -> Option<f64> {
        let (way, whole) = (
            p.as_i64vec2() - self.a.as_i64vec2(),
            self.b.as_i64vec2() - self.a.as_i64vec2(),
        );
        // Forwards is the way to b.
        let way = way * whole.signum();
        let (along, beside) = if whole.x.abs() >= whole.y.abs() {
            (way.x, way.y)
        } else {
            (way.y, way.x)
        };
        // ⌈t − ½⌉ = ⌊t + ½ − 1/(2dx)⌋ of a multiple t of 1/dx.
        let dx = self.dx.max(1);
        let nearest = (2 * i * self.dy + dx - 1).div_euclid(2 * dx);
        (along == i).then_some((beside - nearest).abs() as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draw<P: Iterator<Item = IVec2>>(
        segments: &Segments,
        technique: fn(IVec2, IVec2) -> P,
    ) -> Drawn {
        segments.draw(|a, b, drawn| drawn.all(technique(a, b)))
    }

    fn of(pixels: &'static [(i32, i32)]) -> impl Iterator<Item = IVec2> {
        pixels.iter().map(|&p| p.into())
    }

    fn one(b: (i32, i32)) -> Segments {
        let length = b.0.unsigned_abs().max(b.1.unsigned_abs());
        Segments {
            ends: vec![(IVec2::ZERO, b.into())],
            length,
        }
    }

    #[test]
    fn the_lectures_segment_and_its_tie() {
        let line = ExactLine::new(IVec2::ZERO, IVec2::new(8, 3));
        let y = [0, 0, 1, 1, 1, 2, 2, 3, 3];
        for (i, y) in y.into_iter().enumerate() {
            let error = |y| line.error(i as i64, IVec2::new(i as i32, y));
            assert_eq!(
                [error(y - 1), error(y), error(y + 3)],
                [1.0, 0.0, 3.0].map(Some)
            );
        }
        // Pixels of other columns.
        assert_eq!(line.error(2, IVec2::new(3, 1)), None);
        assert_eq!(line.error(2, IVec2::new(1, 1)), None);
    }

    #[test]
    fn other_octants_are_the_same_line_seen_from_elsewhere() {
        // At the tie after 4 of 8 moves the line is 1.5 beside the start.
        for (x, y) in [(8, 3), (-8, 3), (8, -3), (-8, -3)] {
            for swap in [false, true] {
                let at = |x: i32, y: i32| {
                    let p = IVec2::new(x, y);
                    IVec2::splat(7) + if swap { IVec2::new(p.y, p.x) } else { p }
                };
                let line = ExactLine::new(at(0, 0), at(x, y));
                let near = at(x / 2, y / 3);
                let far = at(x / 2, 2 * (y / 3));
                assert_eq!(
                    (line.error(4, near), line.error(4, far)),
                    (Some(0.0), Some(1.0))
                );
            }
        }
    }

    #[test]
    fn long_and_short() {
        let far = IVec2::splat(1_000_000_000);
        let line = ExactLine::new(-far, far - IVec2::Y);
        assert_eq!(line.error(line.dx, far - IVec2::Y), Some(0.0));
        let point = ExactLine::new(IVec2::ONE, IVec2::ONE);
        assert_eq!(point.error(0, IVec2::ONE), Some(0.0));
    }

    #[test]
    fn judging() {
        let segments = one((3, 1));
        let right = |_, _| of(&[(0, 0), (1, 0), (2, 1), (3, 1)]);
        let cut_off = |_, _| of(&[(0, 0), (1, 0), (2, 0), (3, 1)]);
        let short = |_, _| of(&[(0, 0), (1, 0), (2, 1)]);
        let long = |_, _| of(&[(0, 0), (1, 0), (2, 1), (3, 1), (4, 1)]);
        let deviation = segments.deviation(&draw(&segments, right), right);
        assert_eq!(
            (deviation.asked, deviation.wrong, deviation.missing),
            (4, 0, 0)
        );
        let deviation = segments.deviation(&draw(&segments, cut_off), cut_off);
        assert_eq!((deviation.wrong, deviation.max), (1, 1.0));
        assert_eq!(
            segments.deviation(&draw(&segments, short), short).missing,
            1
        );
        // Pixels beyond the end, or others than were timed, are no answer at all.
        assert_eq!(segments.deviation(&draw(&segments, long), long).missing, 4);
        assert_eq!(
            segments.deviation(&draw(&segments, cut_off), right).missing,
            4
        );
        // The same pixels in another order too.
        let back = |_, _| of(&[(0, 0), (2, 1), (1, 0), (3, 1)]);
        assert_eq!(segments.deviation(&draw(&segments, back), right).missing, 4);
    }

    #[test]
    fn all_octants_are_drawn() {
        let segments = Segments::new(100, 200);
        let octants: std::collections::BTreeSet<_> = segments
            .ends
            .iter()
            .map(|&(a, b)| {
                let d = b - a;
                assert_eq!(d.abs().max_element(), 100);
                (d.x < 0, d.y < 0, d.x.abs() < d.y.abs())
            })
            .collect();
        assert_eq!((octants.len(), segments.pixels()), (8, 200 * 101));
    }
}
