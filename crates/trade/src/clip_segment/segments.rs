//! Segments around a window, and what is exactly left of them.

use ombra_clip::{Segment, Window};
use ombra_math::glam::DVec2;
use ombra_oracle::Exact;
use ombra_oracle::interval::{between, not_negative};
use ombra_oracle::vector::{exact, minus};

use crate::clipping::{WINDOW, middle, size};
use crate::deviation::Deviation;
use crate::random::Random;

/// What a technique leaves of each segment.
pub type Clipped = Vec<Option<Segment>>;

/// A window, segments, and their exact parts inside.
pub struct WindowAndSegments {
    pub window: Window,
    pub corners: [DVec2; 4],
    pub segments: Vec<Segment>,
    truths: Vec<Option<ExactSegment>>,
}

/// A* and B*.
struct ExactSegment {
    ends: [[Exact; 2]; 2],
}

impl WindowAndSegments {
    /// Ends in a square of three times the window's size, with the window in its middle; that share of the segments has
    /// nothing in the window.
    pub fn outside(share: f64, number: usize) -> Self {
        let outside = (share * number as f64).round() as usize;
        let size = WINDOW.max - WINDOW.min;
        let (low, high) = (WINDOW.min - size, WINDOW.max + size);
        let mut random = Random::new(1967);
        let mut end = || DVec2::new(random.between(low.x, high.x), random.between(low.y, high.y));
        let mut scene = Self::empty();
        let mut wanted = [outside, number - outside.min(number)];
        // About a third of the segments crosses the window: both kinds come up soon.
        for _ in 0..100 * number {
            let segment = Segment::new(end(), end());
            let truth = ExactSegment::of(&WINDOW, segment);
            let [out, inside] = &mut wanted;
            let left = if truth.is_none() { out } else { inside };
            if *left > 0 {
                *left -= 1;
                scene.segments.push(segment);
                scene.truths.push(truth);
            }
            if wanted == [0, 0] {
                break;
            }
        }
        scene
    }

    /// Segments through the window or close to it, in any direction, with ends up to `distance` times its size away.
    pub fn far_ends(distance: f64, number: usize) -> Self {
        let size = size();
        let middle = middle();
        let mut random = Random::new(1984);
        let mut scene = Self::empty();
        for _ in 0..number {
            let near =
                middle + size * DVec2::new(random.between(-0.6, 0.6), random.between(-0.6, 0.6));
            let angle = random.between(-core::f64::consts::PI, core::f64::consts::PI);
            let direction = DVec2::new(libm::cos(angle), libm::sin(angle));
            let mut along = |sign: f64| sign * random.between(0.5, 1.0) * distance * size;
            let segment = Segment::new(
                near + along(-1.0) * direction,
                near + along(1.0) * direction,
            );
            scene.segments.push(segment);
            scene.truths.push(ExactSegment::of(&WINDOW, segment));
        }
        scene
    }

    fn empty() -> Self {
        Self {
            window: WINDOW,
            corners: WINDOW.corners(),
            segments: Vec::new(),
            truths: Vec::new(),
        }
    }

    /// One answer a segment.
    pub fn each(&self, clip: impl FnMut(Segment) -> Option<Segment>) -> Clipped {
        self.segments.iter().copied().map(clip).collect()
    }

    /// The errors of answers, in window sizes.
    pub fn deviation(&self, clipped: &Clipped) -> Deviation {
        let size = Exact::new(size());
        let answers = clipped.iter().map(Some).chain(core::iter::repeat(None));
        Deviation::of(self.truths.iter().zip(answers).map(|(truth, answer)| {
            match (truth, *answer?) {
                (None, None) => Some(0.0),
                (Some(truth), Some(answer)) => truth.distance(answer, size.as_ref()?),
                _ => None,
            }
        }))
    }
}

impl ExactSegment {
    /// What is left of `segment`: the parameters that all four inequalities allow.
    fn of(window: &Window, segment: Segment) -> Option<Self> {
        let [a, b] = [exact(segment.a)?, exact(segment.b)?];
        let [low, high] = [exact(window.min)?, exact(window.max)?];
        let inside = |p| minus(p, &low).into_iter().chain(minus(&high, p));
        let sides: Vec<_> = inside(&a).zip(inside(&b)).map(Into::into).collect();
        let at = |t: Exact| [0, 1].map(|k| between(&t, &a[k], &b[k]));
        Some(Self {
            ends: not_negative(&sides)?.map(at),
        })
    }

    /// How far the farther end of an answer lies from where it should, over `size`.
    fn distance(&self, answer: Segment, size: &Exact) -> Option<f64> {
        let mut worst = 0.0_f64;
        for (truth, p) in self.ends.iter().zip([answer.a, answer.b]) {
            for off in minus(&exact(p)?, truth) {
                worst = worst.max(off.abs().ratio(size));
            }
        }
        Some(worst)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lecture() -> Window {
        Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
    }

    fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
        Segment::new(a.into(), b.into())
    }

    #[test]
    fn the_lectures_segments() {
        let left = |a, b| {
            let truth = ExactSegment::of(&lecture(), segment(a, b))?;
            Some(truth.ends.map(|[x, y]| (x.nearest(), y.nearest())))
        };
        assert_eq!(
            left((2.0, 14.0), (8.0, -4.0)),
            Some([(10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)])
        );
        assert_eq!(
            left((8.0, -4.0), (2.0, 14.0)),
            Some([(20.0 / 3.0, 0.0), (10.0 / 3.0, 10.0)])
        );
        assert_eq!(left((4.0, 14.0), (14.0, 8.0)), None);
        assert_eq!(
            left((-5.0, 5.0), (15.0, 5.0)),
            Some([(0.0, 5.0), (10.0, 5.0)])
        );
        assert_eq!(left((-5.0, 15.0), (15.0, 15.0)), None);
        assert_eq!(left((1.0, 2.0), (3.0, 4.0)), Some([(1.0, 2.0), (3.0, 4.0)]));
        // A corner touched is a point, a corner missed by the least is nothing.
        assert_eq!(left((0.0, 20.0), (20.0, 0.0)), Some([(10.0, 10.0); 2]));
        assert_eq!(left((0.0, 20.0f64.next_up()), (20.0, 0.0)), None);
        assert_eq!(left((5.0, 5.0), (5.0, 5.0)), Some([(5.0, 5.0); 2]));
        assert_eq!(left((5.0, 11.0), (5.0, 11.0)), None);
    }

    #[test]
    fn judging() {
        let mut scene = WindowAndSegments::empty();
        let inside = segment((1.0, 1.0), (4.0, 2.0));
        let beside = segment((1.0, 20.0), (4.0, 30.0));
        for s in [inside, beside] {
            scene.segments.push(s);
            scene.truths.push(ExactSegment::of(&WINDOW, s));
        }
        let of = |answers: [Option<Segment>; 2]| scene.deviation(&answers.to_vec());
        let right = of([Some(inside), None]);
        assert_eq!((right.asked, right.missing, right.max), (2, 0, 0.0));
        // A unit away, in windows of 10.2.
        let off = of([Some(segment((1.0, 1.0), (4.0, 3.0))), None]);
        assert!((off.max - 1.0 / 10.2).abs() <= f64::EPSILON, "{off:?}");
        // Turned round it is another segment.
        assert!(of([Some(inside.reversed()), None]).max > 0.2);
        // Kept or dropped wrongly.
        assert_eq!(of([None, None]).missing, 1);
        assert_eq!(of([Some(inside), Some(beside)]).missing, 1);
        assert_eq!(scene.deviation(&vec![Some(inside)]).missing, 1);
    }

    #[test]
    fn shares_are_as_asked() {
        for share in [0.0, 0.3, 1.0] {
            let scene = WindowAndSegments::outside(share, 50);
            let outside = scene.truths.iter().filter(|truth| truth.is_none()).count();
            assert_eq!(
                (scene.segments.len(), outside),
                (50, (50.0 * share) as usize)
            );
        }
        let scene = WindowAndSegments::far_ends(1e6, 100);
        let inside = scene.truths.iter().flatten().count();
        assert!(inside > 50 && inside < 100, "{inside}");
        assert!(scene.segments.iter().all(|s| s.a.abs().max_element() > 1e6));
    }
}
