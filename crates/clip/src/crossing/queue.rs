//! Crossings that are needed later, computed two at a time.

use ombra_math::glam::DVec2;

use super::fast::{at_carefully, several_at};
use crate::segment::Segment;
use crate::window::Line;

/// How many crossings wait at most: few enough to stay in the processor's nearest cache.
pub(crate) const LENGTH: usize = 16;

/// Crossings of edges with lines, and where in a list of points each belongs.
#[derive(Default)]
pub(crate) struct Queue {
    length: usize,
    /// For each the coordinate across its line, and those of the edge's ends across and along it.
    c: [f64; LENGTH],
    across: [[f64; LENGTH]; 2],
    along: [[f64; LENGTH]; 2],
    upright: [bool; LENGTH],
    place: [usize; LENGTH],
}

impl Queue {
    #[inline]
    pub(crate) fn is_full(&self) -> bool {
        self.length >= LENGTH
    }

    /// Adds a crossing, unless the queue is full.
    #[inline]
    pub(crate) fn push(&mut self, Segment { a, b }: Segment, line: Line, place: usize) {
        let i = self.length;
        if i >= LENGTH {
            return;
        }
        self.c[i] = line.place();
        let [across, along] = line.turn(a, b);
        [self.across[0][i], self.across[1][i]] = across;
        [self.along[0][i], self.along[1][i]] = along;
        self.upright[i] = line.is_vertical();
        self.place[i] = place;
        self.length = i + 1;
    }

    /// Computes all that wait, and puts them in their places in `points`.
    pub(crate) fn fill(&mut self, points: &mut [DVec2]) {
        for first in (0..self.length).step_by(2) {
            let lanes = |x: &[f64; LENGTH]| DVec2::new(x[first], x[first | 1]);
            let (found, certain) = several_at(
                lanes(&self.c),
                [lanes(&self.across[0]), lanes(&self.across[1])],
                [lanes(&self.along[0]), lanes(&self.along[1])],
            );
            for (lane, found, certain) in [(0, found.x, certain[0]), (1, found.y, certain[1])] {
                let i = first | lane;
                let found = if certain != 0 || i >= self.length {
                    found
                } else {
                    let ends = |x: &[[f64; LENGTH]; 2]| [x[0][i], x[1][i]];
                    at_carefully(self.c[i], ends(&self.across), ends(&self.along))
                };
                let point = if self.upright[i] {
                    DVec2::new(self.c[i], found)
                } else {
                    DVec2::new(found, self.c[i])
                };
                if i < self.length
                    && let Some(place) = points.get_mut(self.place[i])
                {
                    *place = point;
                }
            }
        }
        self.length = 0;
    }
}
