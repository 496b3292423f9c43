//! Where labels go: beside their thing, on the first of eight sides that is free.
//!
//! A place is free when the label's box stays on the canvas and meets no other box. Among free places the nearest in
//! the wanted direction wins that covers no drawn line; if every free place covers some, the one that covers least.
//! A label without a free place gets none: nothing is ever put over other text.

mod board;

use ombra_math::glam::DVec2;

use self::board::{Board, STARTS};
use crate::drawing::HALO;
use crate::path::{Rect, round};
use crate::text::Line;

/// A label that wants a place.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// What it says.
    pub line: Line,
    /// What it stands beside.
    pub anchor: DVec2,
    /// How far the thing reaches around its anchor.
    pub reach: f64,
    /// The side it would rather have.
    pub towards: DVec2,
    /// Whether it may stand so far away that a line must lead to it, although it has a place beside its thing.
    pub may_lead: bool,
    /// Whether it may be left out where there is no place for it.
    pub optional: bool,
    /// Where it may be.
    pub frame: Rect,
}

/// A drawn line that labels should not cover.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// One end.
    pub a: DVec2,
    /// The other end.
    pub b: DVec2,
    /// What a length of it counts; less for what may sooner be covered.
    pub weight: f64,
}

/// A place found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Start of the baseline.
    pub at: DVec2,
    /// The box, rim included.
    pub bounds: Rect,
    /// The line that leads to it, where it is so far that it needs one.
    pub leader: Option<(DVec2, DVec2)>,
    /// Whether it covers a piece of a full line or of a mark.
    pub crosses: bool,
}

impl Place {
    fn is_free_of(&self, other: &Place) -> bool {
        let crosses = |leader: Option<(DVec2, DVec2)>, bounds: &Rect| {
            leader.is_some_and(|(a, b)| bounds.length_within(a, b) > 0.0)
        };
        let leaders_cross = match (self.leader, other.leader) {
            (Some((a, b)), Some((c, d))) => cross(a, b, c, d),
            _ => false,
        };
        // Two labels on one height must not read as one line.
        let aside = DVec2::new(APART, 0.0);
        let spaced = Rect::new(self.bounds.min - aside, self.bounds.max + aside);
        !leaders_cross
            && !spaced.meets(&other.bounds)
            && !crosses(self.leader, &other.bounds)
            && !crosses(other.leader, &self.bounds)
    }
}

/// The eight sides, counted clockwise on the canvas from the right.
const SIDES: [DVec2; 8] = [
    DVec2::new(1.0, 0.0),
    DVec2::new(
        core::f64::consts::FRAC_1_SQRT_2,
        core::f64::consts::FRAC_1_SQRT_2,
    ),
    DVec2::new(0.0, 1.0),
    DVec2::new(
        -core::f64::consts::FRAC_1_SQRT_2,
        core::f64::consts::FRAC_1_SQRT_2,
    ),
    DVec2::new(-1.0, 0.0),
    DVec2::new(
        -core::f64::consts::FRAC_1_SQRT_2,
        -core::f64::consts::FRAC_1_SQRT_2,
    ),
    DVec2::new(0.0, -1.0),
    DVec2::new(
        core::f64::consts::FRAC_1_SQRT_2,
        -core::f64::consts::FRAC_1_SQRT_2,
    ),
];
/// Distances tried, beyond the thing's own reach; from the fourth on a line leads to the label.
const GAPS: [f64; 8] = [4.0, 11.0, 20.0, 40.0, 60.0, 80.0, 105.0, 135.0];
const FAR: usize = 3;
/// Free space to the left and right of a label, beyond its rim.
const APART: f64 = 24.0;
/// What a farther distance and a less wanted side count against a line covered, as lengths.
const PER_GAP: f64 = 8.0;
const PER_SIDE: f64 = 7.0;
/// Full lines and marks have at least this weight.
const FULL: f64 = 2.0;
/// What a leading line counts in itself, and for each line it crosses.
const LEADER: f64 = 110.0;
const CROSSING: f64 = 25.0;
/// What a leading line counts besides for a label that should have none.
const RELUCTANT: f64 = 1000.0;
/// What it counts that a label without a leading line lies nearer to another's thing than to its own.
const AMBIGUOUS: f64 = 300.0;

/// Finds a place for every label; none for those without.
///
/// `taken` is what labels must not meet, `drawn` the lines they should not cover. Each takes in turn the best place that
/// those before it left; then, as long as it makes the whole cheaper, a label takes a better place and those that it
/// drives out take others. Several labels get the chance to begin; the cheapest outcome is kept, and it depends on
/// nothing but the arguments.
pub fn place(wanted: &[Wanted], taken: &[Rect], drawn: &[Drawn]) -> Vec<Option<Place>> {
    let candidates: Vec<_> = wanted
        .iter()
        .map(|label| candidates(label, wanted, taken, drawn))
        .collect();
    let mut board = Board::start(candidates, 0);
    for first in 1..wanted.len().min(STARTS) {
        let other = Board::start(board.candidates.clone(), first);
        if other.total() < board.total() - 1e-6 {
            board = other;
        }
    }
    (0..wanted.len())
        .map(|label| board.place(label).map(|(_, place)| *place))
        .collect()
}

/// Every free place of one label with its cost, best first.
fn candidates(
    label: &Wanted,
    all: &[Wanted],
    taken: &[Rect],
    drawn: &[Drawn],
) -> Vec<(f64, Place)> {
    // Compares by dot product, so a wanted direction without length wants the right side.
    let first = (0..8)
        .max_by(|&a, &b| {
            let along = |side: usize| SIDES.get(side).map_or(0.0, |d| d.dot(label.towards));
            along(a).total_cmp(&along(b)).then(b.cmp(&a))
        })
        .unwrap_or(0);
    let half = DVec2::new(
        label.line.width * 0.5,
        (label.line.ascent + label.line.descent) * 0.5,
    ) + DVec2::splat(HALO);

    let mut found = Vec::new();
    for (distance, gap) in GAPS.into_iter().enumerate() {
        for turn in 0..8_usize {
            // The wanted side, then its neighbours on either hand, at last the opposite one.
            let by = turn.div_ceil(2);
            let side = if turn % 2 == 1 {
                first + by
            } else {
                first + 8 - by
            } % 8;
            let Some(&direction) = SIDES.get(side) else {
                continue;
            };
            let away = DVec2::new(sign(direction.x), sign(direction.y));
            let centre = label.anchor + direction * (label.reach + gap) + half * away;
            let at = round(label.line.centred(centre));
            let bounds = label.line.bounds(at).grown(HALO);
            if !label.frame.contains(&bounds) || taken.iter().any(|other| other.meets(&bounds)) {
                continue;
            }
            let (mut covered, mut crosses) = (0.0, false);
            for line in drawn {
                let length = bounds.length_within(line.a, line.b);
                covered += line.weight * length;
                crosses |= length > 0.0 && line.weight >= FULL;
            }
            let mut cost = covered + PER_GAP * distance as f64 + PER_SIDE * by as f64;
            let mut leader = None;
            if distance >= FAR {
                let start = label.anchor + direction * label.reach;
                let end = start.clamp(bounds.min, bounds.max);
                if taken
                    .iter()
                    .any(|other| other.length_within(start, end) > 0.0)
                {
                    continue;
                }
                let crossed: f64 = drawn
                    .iter()
                    .filter(|line| cross(start, end, line.a, line.b))
                    .map(|line| line.weight)
                    .sum();
                cost += LEADER + CROSSING * crossed;
                if !label.may_lead {
                    cost += RELUCTANT;
                }
                leader = Some((start, end));
            } else {
                let from = |anchor: DVec2| anchor.distance(anchor.clamp(bounds.min, bounds.max));
                let own = from(label.anchor);
                let nearer = |other: &&Wanted| {
                    other.anchor != label.anchor
                        && from(other.anchor) - other.reach < own - label.reach
                };
                cost += AMBIGUOUS * all.iter().filter(nearer).count() as f64;
            }
            let place = Place {
                at,
                bounds,
                leader,
                crosses,
            };
            found.push((cost, place));
        }
    }
    // Stable: equal costs keep the order of trying.
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

/// Whether the segments a–b and c–d cross.
fn cross(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    let side = |from: DVec2, to: DVec2, p: DVec2| (to - from).perp_dot(p - from);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

fn sign(x: f64) -> f64 {
    match x {
        x if x > 0.0 => 1.0,
        x if x < 0.0 => -1.0,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::LABEL;

    fn label(text: &str, x: f64, y: f64) -> Wanted {
        Wanted {
            line: Line::new(text, LABEL).unwrap(),
            anchor: DVec2::new(x, y),
            reach: 5.0,
            towards: DVec2::X,
            may_lead: true,
            optional: false,
            frame: FRAME,
        }
    }

    fn placed(wanted: &[Wanted], drawn: &[Drawn]) -> Vec<Place> {
        let places = place(wanted, &[], drawn);
        places.into_iter().map(Option::unwrap).collect()
    }

    const FRAME: Rect = Rect::new(DVec2::ZERO, DVec2::new(600.0, 300.0));

    #[test]
    fn the_wanted_side_is_taken_when_it_is_free() {
        let places = placed(&[label("a", 300.0, 150.0)], &[]);
        assert!(places[0].bounds.min.x > 300.0);
        assert!((places[0].bounds.centre().y - 150.0).abs() < 0.1);
    }

    #[test]
    fn two_labels_at_one_place_part() {
        let places = placed(
            &[label("first", 300.0, 150.0), label("second", 300.0, 150.0)],
            &[],
        );
        assert!(!places[0].bounds.meets(&places[1].bounds));
    }

    #[test]
    fn a_label_is_not_nearer_to_another_thing() {
        // Each would rather be on the other's side.
        let (mut left, mut right) = (label("l", 300.0, 150.0), label("r", 330.0, 150.0));
        left.towards = DVec2::X;
        right.towards = DVec2::NEG_X;
        let anchors = [left.anchor, right.anchor];
        let places = placed(&[left, right], &[]);
        for (i, place) in places.iter().enumerate() {
            let from = |p: DVec2| p.distance(p.clamp(place.bounds.min, place.bounds.max));
            assert!(from(anchors[i]) <= from(anchors[1 - i]), "{place:?}");
        }
    }

    #[test]
    fn a_label_at_the_edge_turns_inwards_and_a_line_is_avoided() {
        let places = placed(&[label("edge", 595.0, 150.0)], &[]);
        assert!(places[0].bounds.max.x < 595.0);
        let line = Drawn {
            a: DVec2::new(300.0, 150.0),
            b: DVec2::new(600.0, 150.0),
            weight: 1.0,
        };
        let places = placed(&[label("line", 300.0, 150.0)], &[line]);
        assert_eq!(places[0].bounds.length_within(line.a, line.b), 0.0);
    }

    #[test]
    fn an_optional_label_gives_way() {
        let tight = Rect::new(DVec2::ZERO, DVec2::splat(90.0));
        let long = Wanted {
            frame: tight,
            optional: true,
            ..label("much too long for this", 45.0, 45.0)
        };
        let places = place(&[long, label("a", 300.0, 150.0)], &[], &[]);
        assert!(places[0].is_none() && places[1].is_some());
    }

    #[test]
    fn where_there_is_no_room_there_is_no_place() {
        let tight = Rect::new(DVec2::ZERO, DVec2::splat(90.0));
        let long = Wanted {
            frame: tight,
            ..label("much too long for this", 45.0, 45.0)
        };
        assert_eq!(place(&[long], &[], &[]), [None]);
        // Of a crowd some are left out, and those that are not do not meet.
        let crowd: Vec<_> = (0..40).map(|_| label("crowd", 300.0, 150.0)).collect();
        let places: Vec<Place> = place(&crowd, &[], &[]).into_iter().flatten().collect();
        assert!((1..40).contains(&places.len()));
        for (i, place) in places.iter().enumerate() {
            assert!(
                places[..i]
                    .iter()
                    .all(|other| !other.bounds.meets(&place.bounds))
            );
        }
    }

    #[test]
    fn a_label_that_others_would_shut_out_goes_first() {
        // A strip one label high: the long one fits only to the right of the shared anchor, where the short one, first
        // in order, would rather be too.
        let (short, long) = (label("i", 40.0, 35.0), label("a long label", 40.0, 35.0));
        let least = 40.0 + long.reach + GAPS[0] + long.line.width + 2.0 * HALO;
        let frame = Rect::new(DVec2::ZERO, DVec2::new(least + 1.0, 70.0));
        let wanted = [short, long].map(|label| Wanted { frame, ..label });
        let places = place(&wanted, &[], &[]);
        assert!(places.iter().all(Option::is_some), "{places:?}");
    }

    #[test]
    fn nonsense_anchors_do_not_panic() {
        for x in [f64::NAN, f64::INFINITY, f64::MAX] {
            let line = Drawn {
                a: DVec2::splat(x),
                b: DVec2::ZERO,
                weight: 1.0,
            };
            assert_eq!(place(&[label("a", x, x)], &[], &[line]), [None]);
        }
    }
}
