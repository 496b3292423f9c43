//! The slide's octant, 0 ≤ m ≤ 1, and the turn that brings any segment into it.

use ombra_math::glam::IVec2;

/// A segment seen in the first octant: it starts at (0, 0) and ends at (`run`, `rise`), 0 ≤ `rise` ≤ `run`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Octant {
    /// The pixel that (0, 0) stands for.
    pub start: IVec2,
    /// The larger of |dx| and |dy|: the number of moves.
    pub run: u32,
    /// The smaller of |dx| and |dy|.
    pub rise: u32,
    /// The move E: one along the longer axis.
    pub east: IVec2,
    /// The move N: one along the shorter axis. NE is both.
    pub north: IVec2,
}

impl Octant {
    #[inline]
    pub(crate) fn of(a: IVec2, b: IVec2) -> Self {
        let (dx, dy) = (a.x.abs_diff(b.x), a.y.abs_diff(b.y));
        let along_x = IVec2::new(if a.x <= b.x { 1 } else { -1 }, 0);
        let along_y = IVec2::new(0, if a.y <= b.y { 1 } else { -1 });
        let (run, rise, east, north) = if dx >= dy {
            (dx, dy, along_x, along_y)
        } else {
            (dy, dx, along_y, along_x)
        };
        Self {
            start: a,
            run,
            rise,
            east,
            north,
        }
    }

    /// The pixel that (x, y) of the first octant stands for. A coordinate that leaves i32 stays at its end; none
    /// does while x ≤ `run` and y ≤ `rise`.
    #[inline]
    pub(crate) fn pixel(&self, x: u32, y: u32) -> IVec2 {
        if self.east.y == 0 {
            IVec2::new(
                walk(self.start.x, self.east.x, x),
                walk(self.start.y, self.north.y, y),
            )
        } else {
            IVec2::new(
                walk(self.start.x, self.north.x, y),
                walk(self.start.y, self.east.y, x),
            )
        }
    }
}

/// `from`, moved by `steps` towards the sign of `direction`.
#[inline]
fn walk(from: i32, direction: i32, steps: u32) -> i32 {
    if direction > 0 {
        from.saturating_add_unsigned(steps)
    } else {
        from.saturating_sub_unsigned(steps)
    }
}
