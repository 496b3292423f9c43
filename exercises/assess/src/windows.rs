//! Segments of which it is known by construction what a window leaves.

use std::fmt;

use glam::DVec2;

use crate::{Inputs, show_point};

/// A window, a segment, and what of it lies in the window.
#[derive(Clone, Copy, Debug)]
pub struct WindowCase {
    /// The corner of the window with the smaller coordinates.
    pub min: DVec2,
    /// The corner with the larger ones.
    pub max: DVec2,
    /// The start of the segment.
    pub a: DVec2,
    /// Its end.
    pub b: DVec2,
    /// What lies in the window, in the direction from `a` to `b`.
    pub inside: Option<(DVec2, DVec2)>,
}

/// For numbers up to 200: the share t is a few roundings off, and a second cut takes the first one's error along a
/// line that rises 20 times as fast at most.
const BOUND: f64 = 64.0 * f64::EPSILON * 200.0;

impl WindowCase {
    /// A segment that crosses the window, ends in it or stays in it; all coordinates are whole quarters.
    ///
    /// What lies inside is drawn first: two points, each on a side, off the corners, or in the window. From a side
    /// the segment goes on outwards.
    pub fn crossing(inputs: &mut Inputs) -> Self {
        let (min, max) = any_window(inputs);
        let mut places = [0, 0];
        while places[0] == places[1] && places[0] != 4 {
            places = places.map(|_| inputs.integer(0, 4));
        }
        let [p, mut q] = places.map(|place| {
            let x = f64::from(inputs.integer(min.x as i32 + 1, max.x as i32 - 1));
            let y = f64::from(inputs.integer(min.y as i32 + 1, max.y as i32 - 1));
            match place {
                0 => DVec2::new(x, max.y),
                1 => DVec2::new(x, min.y),
                2 => DVec2::new(max.x, y),
                3 => DVec2::new(min.x, y),
                _ => DVec2::new(x, y),
            }
        });
        // Some run along an axis.
        match places {
            [0 | 1, 0 | 1] if inputs.integer(0, 2) == 0 => q.x = p.x,
            [2 | 3, 2 | 3] if inputs.integer(0, 2) == 0 => q.y = p.y,
            _ => {}
        }
        let mut outwards = |place| match place {
            4 => 0.0,
            _ => 0.25 * f64::from(inputs.integer(0, 8)),
        };
        Self {
            min,
            max,
            a: p - outwards(places[0]) * (q - p),
            b: q + outwards(places[1]) * (q - p),
            inside: Some((p, q)),
        }
    }

    /// A segment that passes a corner of the window outside; all coordinates are whole numbers.
    ///
    /// A line through the corner has the window on one side, the segment on the other.
    pub fn passing(inputs: &mut Inputs) -> Self {
        let (min, max) = any_window(inputs);
        let mut side = || inputs.integer(0, 1) == 1;
        let (right, upper) = (side(), side());
        let corner = DVec2::new(
            if right { max.x } else { min.x },
            if upper { max.y } else { min.y },
        );
        let normal = DVec2::new(
            f64::from(inputs.integer(1, 9)) * if right { 1.0 } else { -1.0 },
            f64::from(inputs.integer(1, 9)) * if upper { 1.0 } else { -1.0 },
        );
        let mut beyond = || {
            loop {
                let v = inputs.whole_vector(-30, 30).truncate();
                if normal.dot(v) > 0.0 {
                    return corner + v;
                }
            }
        };
        Self {
            min,
            max,
            a: beyond(),
            b: beyond(),
            inside: None,
        }
    }

    /// Whether the segment is cut at the side: 0 the upper one, 1 the lower, 2 the right, 3 the left.
    #[must_use]
    pub fn is_cut_at(&self, side: usize) -> bool {
        let on_side = |p: DVec2| {
            let WindowCase { min, max, .. } = self;
            [p.y == max.y, p.y == min.y, p.x == max.x, p.x == min.x][side]
        };
        self.inside
            .is_some_and(|(p, q)| (p != self.a && on_side(p)) || (q != self.b && on_side(q)))
    }

    /// Whether `got` is what lies inside, up to rounding.
    #[must_use]
    pub fn is_right(&self, got: Option<(DVec2, DVec2)>) -> bool {
        match (got, self.inside) {
            (Some(got), Some(want)) => is_near(got.0, want.0) && is_near(got.1, want.1),
            (got, want) => got.is_none() && want.is_none(),
        }
    }

    /// Fails unless `got` is what lies inside.
    ///
    /// # Panics
    ///
    /// When it is not, with both.
    #[track_caller]
    pub fn assert_right(&self, got: Option<(DVec2, DVec2)>) {
        let ends = match got {
            None => "nothing".to_owned(),
            Some((p, q)) => format!("{} to {}", show_point(p), show_point(q)),
        };
        match self.inside {
            None => assert!(
                got.is_none(),
                "{self}: nothing of it is inside, but got {ends}"
            ),
            Some((p, q)) => {
                assert!(
                    self.is_right(got) || !self.is_right(got.map(|(p, q)| (q, p))),
                    "{self}: got {ends}: a clipped segment keeps its direction",
                );
                assert!(
                    self.is_right(got),
                    "{self}: expected {} to {}, got {ends}",
                    show_point(p),
                    show_point(q),
                );
            }
        }
    }
}

impl fmt::Display for WindowCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [min, max, a, b] = [self.min, self.max, self.a, self.b].map(show_point);
        write!(f, "window {min} to {max}, segment {a} to {b}")
    }
}

fn any_window(inputs: &mut Inputs) -> (DVec2, DVec2) {
    let mut whole = |min, max| f64::from(inputs.integer(min, max));
    let min = DVec2::new(whole(-20, 10), whole(-20, 10));
    (min, min + DVec2::new(whole(4, 20), whole(4, 20)))
}

fn is_near(got: DVec2, want: DVec2) -> bool {
    crate::is_near(got.extend(0.0), want.extend(0.0), BOUND)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slide() -> WindowCase {
        WindowCase {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
            a: DVec2::new(-5.0, 5.0),
            b: DVec2::new(15.0, 5.0),
            inside: Some((DVec2::new(0.0, 5.0), DVec2::new(10.0, 5.0))),
        }
    }

    #[test]
    fn constructed_cases_are_what_they_say() {
        let mut inputs = Inputs::new(1);
        let mut cuts = [0; 4];
        for _ in 0..500 {
            let case = WindowCase::crossing(&mut inputs);
            let (p, q) = case.inside.unwrap();
            let contains = |p: DVec2| p.cmpge(case.min).all() && p.cmple(case.max).all();
            assert!(contains(p) && contains(q), "{case}");
            // p and q lie on the segment, and what lies beyond them is outside: all in whole quarters.
            let way = case.b - case.a;
            for (end, cut) in [(case.a, p), (case.b, q)] {
                assert_eq!(way.perp_dot(cut - case.a), 0.0, "{case}");
                assert!(
                    end == cut || !contains(cut + (end - cut) / 1024.0),
                    "{case}"
                );
            }
            for (side, cuts) in cuts.iter_mut().enumerate() {
                *cuts += usize::from(case.is_cut_at(side));
            }
            case.assert_right(case.inside);

            let case = WindowCase::passing(&mut inputs);
            for step in 0..=1024 {
                let p = case.a.lerp(case.b, f64::from(step) / 1024.0);
                assert!(
                    !(p.cmpge(case.min).all() && p.cmple(case.max).all()),
                    "{case}"
                );
            }
        }
        assert!(cuts.iter().all(|&cuts| cuts > 100), "{cuts:?}");
    }

    #[test]
    #[should_panic(
        expected = "window (0, 0) to (10, 10), segment (-5, 5) to (15, 5): expected (0, 5) to (10, 5), got nothing"
    )]
    fn a_missing_answer_is_named() {
        slide().assert_right(None);
    }

    #[test]
    #[should_panic(expected = "a clipped segment keeps its direction")]
    fn a_turned_answer_is_named() {
        slide().assert_right(slide().inside.map(|(p, q)| (q, p)));
    }

    #[test]
    #[should_panic(expected = "nothing of it is inside, but got (0, 5) to (10, 5)")]
    fn an_answer_too_many_is_named() {
        let case = WindowCase {
            inside: None,
            ..slide()
        };
        case.assert_right(slide().inside);
    }
}
