//! From the latest entry to the earliest exit: what several sides leave of a segment.

use core::cmp::Ordering;

/// The side at which a segment enters last and the one at which it leaves first, of those met so far; none where the
/// end itself is inside.
pub(crate) struct Interval<S> {
    entry: Option<S>,
    exit: Option<S>,
}

impl<S: Copy> Interval<S> {
    /// The whole segment, 0 ≤ t ≤ 1.
    pub(crate) const WHOLE: Self = Self {
        entry: None,
        exit: None,
    };

    /// Takes off what lies beyond `side`; `beyond` says which ends do. `None` if both do: nothing is left.
    ///
    /// `order` says which of two sides is met first on the way.
    #[inline]
    pub(crate) fn cut(
        &mut self,
        side: S,
        beyond: [bool; 2],
        mut order: impl FnMut(S, S) -> Ordering,
    ) -> Option<()> {
        match (beyond, self.entry, self.exit) {
            ([true, true], ..) => return None,
            ([true, false], Some(latest), _) if order(side, latest).is_le() => {}
            ([true, false], ..) => self.entry = Some(side),
            ([false, true], _, Some(earliest)) if order(side, earliest).is_ge() => {}
            ([false, true], ..) => self.exit = Some(side),
            ([false, false], ..) => {}
        }
        Some(())
    }

    /// The ends of what is left of the segment a b, `crossing` giving the point on a side; `None` if it leaves before it
    /// has entered.
    #[inline]
    pub(crate) fn ends<P, W>(
        self,
        [a, b]: [P; 2],
        order: impl FnOnce(S, S, &mut W) -> Ordering,
        mut crossing: impl FnMut(S, &mut W) -> P,
        work: &mut W,
    ) -> Option<[P; 2]> {
        if let (Some(entry), Some(exit)) = (self.entry, self.exit)
            && order(entry, exit, work).is_gt()
        {
            return None;
        }
        let mut at = |side: Option<S>, end| side.map_or(end, |side| crossing(side, work));
        Some([at(self.entry, a), at(self.exit, b)])
    }
}
