//! Windows of the plane: points beside them, segments of which it is known by construction what a window leaves, and
//! their pictures.

mod polygons;

use std::fmt;

use glam::{DVec2, Vec2Swizzles};

use crate::{Ink, Inputs, Panel, Picture, brief_number, show_number};

pub use polygons::PolygonCase;

/// The two ends of a segment.
type Ends = (DVec2, DVec2);

/// The sides in the order of the bits of a code.
pub const SIDES: [&str; 4] = ["upper", "lower", "right", "left"];

/// A point of the plane in at most six digits a coordinate.
#[must_use]
pub fn short_point(p: DVec2) -> String {
    let [x, y] = p.to_array().map(brief_number);
    format!("({x}, {y})")
}

/// Two points one after the other.
fn short_ends((p, q): Ends) -> String {
    format!("{} to {}", short_point(p), short_point(q))
}

/// A point of a window, its name on the left what the student says of it, on the right what is right.
#[track_caller]
pub fn point_beside(min: DVec2, max: DVec2, p: DVec2, yours: &str, right: &str) -> Picture {
    let panel = |name, ink| {
        let mut panel = Panel::plane();
        panel.window(min, max);
        panel.point(p, name, ink);
        panel
    };
    Picture::beside(panel(yours, Ink::Ideal), panel(right, Ink::Right))
}

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

impl WindowCase {
    /// A segment and what lies of it in the window 0…10.
    #[must_use]
    pub fn known(a: (f64, f64), b: (f64, f64), inside: Option<[(f64, f64); 2]>) -> Self {
        Self {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
            a: a.into(),
            b: b.into(),
            inside: inside.map(|[p, q]| (p.into(), q.into())),
        }
    }

    /// Many of them, those with the smaller numbers first.
    pub fn many(count: usize, inputs: &mut Inputs, one: fn(&mut Inputs) -> Self) -> Vec<Self> {
        let mut all: Vec<Self> = (0..count).map(|_| one(inputs)).collect();
        all.sort_by(|p, q| p.largest().total_cmp(&q.largest()));
        all
    }

    fn largest(&self) -> f64 {
        [self.min, self.max, self.a, self.b]
            .into_iter()
            .fold(0.0, |most: f64, p| most.max(p.abs().max_element()))
    }

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

    /// A segment with no whole numbers, so that something is rounded; a part of it lies inside.
    pub fn rounded(inputs: &mut Inputs) -> Self {
        loop {
            let mut any = |low, high| DVec2::new(inputs.real(low, high), inputs.real(low, high));
            let min = any(-10.0, 0.0);
            let (max, a, b) = (min + any(5.0, 15.0), any(-30.0, 30.0), any(-30.0, 30.0));
            let d = b - a;
            // Steeper ones would make the roundings larger.
            if d.abs().min_element() < 0.1 {
                continue;
            }
            let mut ends = [(0.0, a), (1.0, b)];
            for axis in 0..2 {
                for side in [min[axis], max[axis]] {
                    let t = (side - a[axis]) / d[axis];
                    let mut p = a + t * d;
                    p[axis] = side;
                    let enters = (side == min[axis]) == (d[axis] > 0.0);
                    if enters && t > ends[0].0 {
                        ends[0] = (t, p);
                    } else if !enters && t < ends[1].0 {
                        ends[1] = (t, p);
                    }
                }
            }
            if ends[1].0 - ends[0].0 > 1e-3 {
                let inside = Some((ends[0].1, ends[1].1));
                return Self {
                    min,
                    max,
                    a,
                    b,
                    inside,
                };
            }
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

    /// What rounding may do to a coordinate: that of a share t, and of a second cut that takes the first one's error
    /// along a line that rises 20 times as fast. Along an axis the other coordinate stays.
    fn slack(&self) -> DVec2 {
        let largest = self.largest();
        let axis = |i: usize| {
            if self.a[i] == self.b[i] {
                4.0 * f64::EPSILON * self.a[i].abs()
            } else {
                512.0 * f64::EPSILON * largest
            }
        };
        DVec2::new(axis(0), axis(1))
    }

    fn is_near(&self, p: DVec2, q: DVec2) -> bool {
        p == q || (p - q).abs().cmple(self.slack()).all()
    }

    /// A point in six digits, and in full where they would put it on a side.
    fn point(&self, p: DVec2) -> String {
        let coordinate = |i: usize| {
            let text = brief_number(p[i]);
            let hidden =
                [self.min, self.max].map(|side| p[i] != side[i] && text == brief_number(side[i]));
            if hidden.contains(&true) {
                show_number(p[i])
            } else {
                text
            }
        };
        format!("({}, {})", coordinate(0), coordinate(1))
    }

    /// On which sides, or the lines that go on from them, a point lies.
    fn sides_of(&self, p: DVec2) -> [bool; 4] {
        let WindowCase { min, max, .. } = self;
        [p.y == max.y, p.y == min.y, p.x == max.x, p.x == min.x]
    }

    /// The side beside which `got` lies by a rounding, where `want` lies on it.
    fn beside(&self, got: DVec2, want: DVec2) -> Option<&'static str> {
        if self.is_near(want, self.a) || self.is_near(want, self.b) {
            return None;
        }
        let (on, sides) = (self.sides_of(got), self.sides_of(want));
        let exact = (0..4).any(|i| on[i] && sides[i]);
        let side = (0..4).find(|&i| sides[i])?;
        (!exact).then_some(SIDES[side])
    }

    /// Whether `got` is what lies inside: on the sides exactly, else up to rounding.
    #[must_use]
    pub fn is_right(&self, got: Option<Ends>) -> bool {
        match (got, self.inside) {
            (Some(got), Some(want)) => {
                self.is_near(got.0, want.0)
                    && self.is_near(got.1, want.1)
                    && self.beside(got.0, want.0).is_none()
                    && self.beside(got.1, want.1).is_none()
            }
            (got, want) => got.is_none() && want.is_none(),
        }
    }

    /// What the student kept, beside what is right.
    #[track_caller]
    pub fn picture(&self, got: Option<Ends>) -> Picture {
        let is_end = |p: DVec2| {
            self.inside
                .is_some_and(|(q, r)| self.is_near(p, q) || self.is_near(p, r))
        };
        let panel = |kept: Option<Ends>, ink| {
            let mut panel = Panel::plane();
            panel.window(self.min, self.max);
            panel.segment(self.a, self.b, Ink::Faint);
            panel.point(self.a, "a", Ink::Ideal);
            panel.point(self.b, "b", Ink::Ideal);
            if let Some((p, q)) = kept {
                if p != q {
                    panel.segment(p, q, ink);
                }
                for p in [p, q] {
                    panel.point(p, "", if is_end(p) { Ink::Right } else { Ink::Extra });
                }
            }
            panel
        };
        let ink = if self.is_right(got) {
            Ink::Right
        } else {
            Ink::Extra
        };
        let mut yours = panel(got, ink);
        for p in self.inside.into_iter().flat_map(|(p, q)| [p, q]) {
            if got.is_none_or(|(q, r)| !self.is_near(p, q) && !self.is_near(p, r)) {
                yours.point(p, "?", Ink::Missing);
            }
        }
        Picture::beside(yours, panel(self.inside, Ink::Right))
    }

    /// Fails unless `got` is what lies inside, and leaves a picture.
    ///
    /// # Panics
    ///
    /// When it is not.
    #[track_caller]
    pub fn check(&self, got: Option<Ends>) {
        let _picture = self.picture(got);
        self.assert_right(got);
    }

    /// Fails unless `got` is what lies inside.
    ///
    /// # Panics
    ///
    /// When it is not, with what can be said of it: the plainest first.
    #[track_caller]
    pub fn assert_right(&self, got: Option<Ends>) {
        if let Some(wrong) = self.wrong(got) {
            panic!("{self}: {wrong}");
        }
    }

    fn wrong(&self, got: Option<Ends>) -> Option<String> {
        if self.is_right(got) {
            return None;
        }
        let Some(ends @ (p, q)) = got else {
            let inside = self.inside.map(short_ends).unwrap_or_default();
            return Some(format!("{inside} lies inside, but got None"));
        };
        let got = short_ends(ends);
        if p.is_nan() || q.is_nan() {
            return Some(format!(
                "got {got}: not a number, as 0/0 or ∞ − ∞ give it: a segment parallel to a side has no t there"
            ));
        }
        if let Some(want @ (want_p, want_q)) = self.inside {
            let turned = |swap: fn(Ends) -> Ends| self.is_right(Some(swap(ends)));
            if turned(|(p, q)| (q, p)) {
                return Some(format!(
                    "got {got}: a clipped segment keeps its direction, from a to b"
                ));
            }
            if turned(|(p, q)| (p.yx(), q.yx())) {
                return Some(format!("got {got}: x and y are exchanged"));
            }
            if p == q && !self.is_near(want_p, want_q) {
                return Some(format!(
                    "got {got}, twice the same point: the part inside is {}",
                    short_ends(want)
                ));
            }
        }
        for (p, name) in [(p, "start"), (q, "end")] {
            if let Some(wrong) = self.stray(p) {
                return Some(format!(
                    "the {name} {} of the answer {wrong}",
                    short_point(p)
                ));
            }
        }
        let Some(want) = self.inside else {
            return Some(format!("nothing of it is inside, but got {got}"));
        };
        // Far away ends round by more than the window is wide.
        let size = (self.max - self.min).max_element();
        for (p, want) in [(p, want.0), (q, want.1)] {
            if let Some(side) = self
                .beside(p, want)
                .filter(|_| (p - want).abs().max_element() <= 1e-6 * size)
            {
                return Some(format!(
                    "the end {} lies beside the {side} side by a rounding: take the coordinate of the side itself, and \
                     only the other one from t",
                    short_point(p),
                ));
            }
        }
        Some(format!("expected {}, got {got}", short_ends(want)))
    }

    /// Why a point can be no end of a part inside.
    fn stray(&self, p: DVec2) -> Option<String> {
        let Self { min, max, a, b, .. } = *self;
        let slack = self.slack();
        let within =
            |low: DVec2, high: DVec2| p.cmpge(low - slack).all() && p.cmple(high + slack).all();
        let far_off_line = {
            let d = (b - a).try_normalize();
            d.is_some_and(|d| d.perp_dot(p - a).abs() > 4.0 * slack.max_element())
        };
        if far_off_line {
            return Some("does not lie on the line through a and b".to_owned());
        }
        if !within(a.min(b), a.max(b)) {
            return Some(
                "lies on the line, but not between a and b: t must be within 0…1".to_owned(),
            );
        }
        if within(min, max) {
            return None;
        }
        if p == a || p == b {
            let beyond = [p.y > max.y, p.y < min.y, p.x > max.x, p.x < min.x];
            let side = SIDES[beyond.into_iter().position(|beyond| beyond)?];
            return Some(format!("lies beyond the {side} side: it is not inside"));
        }
        let on = self.sides_of(p).into_iter().position(|on| on);
        Some(on.map_or_else(
            || "is not in the window".to_owned(),
            |side| {
                let (across, other) = if side < 2 { ("y", "x") } else { ("x", "y") };
                let bound = if side % 2 == 0 { "max" } else { "min" };
                format!(
                    "lies on the line of the {} side, but beyond the side: where {across} = {across}_{bound}, {other} \
                     must be within {other}_min…{other}_max",
                    SIDES[side]
                )
            },
        ))
    }

    /// Segments a hair outside a window, at several scales and far from the origin, with the hair in words; each comes
    /// with the same at three tenths of the window, where nothing is doubtful.
    fn hairs() -> Vec<(Self, Self, String)> {
        let mut all = Vec::new();
        let tiny = 2f64.powi(-20);
        for (scale, origin) in [
            (1.0, 0.0),
            (tiny, 0.0),
            (1.0 / tiny, 0.0),
            (1.0, 1.0 / tiny),
        ] {
            for hair in [1e-3, 1e-6, 1e-9, 1e-12] {
                // The numbers must hold the hair, and what a few roundings leave of it.
                if hair * 10.0 * scale < 1e-13 * (10.0 * scale + origin) {
                    continue;
                }
                for (side, name) in SIDES.into_iter().enumerate() {
                    for kind in 0..5 {
                        let [plain, fine] = [0.3, hair]
                            .map(|hair| Self::beyond(kind, side, 10.0 * hair, scale, origin));
                        let by = brief_number(10.0 * hair * scale);
                        all.push((plain, fine, format!("by {by} beyond the {name} side")));
                    }
                }
            }
        }
        all
    }

    /// A segment `hair` beyond a side of the window 0…10, scaled and moved.
    fn beyond(kind: usize, side: usize, hair: f64, scale: f64, origin: f64) -> Self {
        // At the upper side.
        let (a, b, inside) = match kind {
            // Along it, up to it, away from it, past its end, and from a hair outside into the window.
            0 => ((-5.0, 10.0 + hair), (15.0, 10.0 + hair), None),
            1 => ((5.0, 20.0), (5.0, 10.0 + hair), None),
            2 => ((5.0, 10.0 + hair), (5.0, 20.0), None),
            3 => ((5.0, 15.0 + hair), (15.0 + hair, 5.0), None),
            _ => (
                (5.0, 10.0 + hair),
                (5.0, 5.0),
                Some([(5.0, 10.0), (5.0, 5.0)]),
            ),
        };
        let case = Self::known(a, b, inside);
        // To the other sides, then to its size and place.
        let place = |p: DVec2| {
            let p = match side {
                0 => p,
                1 => DVec2::new(p.x, 10.0 - p.y),
                2 => p.yx(),
                _ => DVec2::new(10.0 - p.y, p.x),
            };
            scale * p + origin
        };
        let max = case.max * scale + origin;
        Self {
            min: DVec2::splat(origin),
            max,
            a: place(case.a),
            b: place(case.b),
            inside: case.inside.map(|(p, q)| (place(p), place(q))),
        }
    }

    /// Fails unless `clip` decides at the side itself: a hair beyond it as well as far beyond it, at any scale.
    ///
    /// # Panics
    ///
    /// When it does not.
    #[track_caller]
    pub fn check_hairs(mut clip: impl FnMut(&Self) -> Option<Ends>) {
        for (plain, fine, by) in Self::hairs() {
            plain.check(clip(&plain));
            let got = clip(&fine);
            let _picture = fine.picture(got);
            if fine.inside.is_some() && got.is_some_and(|(p, _)| p != fine.a) {
                fine.assert_right(got);
            }
            let is = fine
                .inside
                .map_or("the segment lies outside", |_| "a lies outside");
            let got_ends = got.map_or("None".to_owned(), short_ends);
            assert!(
                fine.is_right(got),
                "{fine}: {is} {by}, and got {got_ends}; three tenths of the window beyond, the answer is right: compare with \
                 the side itself, without a tolerance",
            );
        }
        // The next double beyond the side; halfway along the segment nothing is rounded.
        for (side, side_name) in SIDES.into_iter().enumerate() {
            let border = if side % 2 == 0 { 11.0_f64 } else { 1.0 };
            let next = if side % 2 == 0 {
                border.next_up()
            } else {
                border.next_down()
            };
            for (at, is_inside) in [(border, true), (next, false)] {
                let place = |along: f64| if side < 2 { (along, at) } else { (at, along) };
                let inside = is_inside.then(|| [place(1.0), place(11.0)]);
                let case = Self {
                    min: DVec2::ONE,
                    max: DVec2::splat(11.0),
                    ..Self::known(place(-9.0), place(11.0), inside)
                };
                let got = clip(&case);
                let _picture = case.picture(got);
                let name = if side < 2 { "y" } else { "x" };
                if is_inside {
                    case.assert_right(got);
                }
                assert!(
                    case.is_right(got),
                    "window 1…11, segment with {name} = {at:?}, the next number beyond the {side_name} side: nothing is inside, \
                     but got {}: compare with the side itself, without a tolerance",
                    got.map_or("None".to_owned(), short_ends),
                );
            }
        }
    }

    /// Fails with what the wrong answers have in common and the right ones have not, if there is such a thing.
    ///
    /// # Panics
    ///
    /// When there is.
    #[track_caller]
    pub fn assert_no_pattern(all: &[(Self, Option<Ends>)]) {
        let ends_inside = |case: &Self| {
            let inside = |p: DVec2| p.cmpge(case.min).all() && p.cmple(case.max).all();
            usize::from(inside(case.a)) + usize::from(inside(case.b))
        };
        assert!(
            all.iter().any(|(_, got)| got.is_some()),
            "None for each of {} segments, though a part of each lies inside",
            all.len()
        );
        let mostly = |pattern: &dyn Fn(&Self) -> bool| {
            let of = |yes| all.iter().filter(move |(case, _)| pattern(case) == yes);
            of(true).next().is_some()
                && of(false).all(|(case, got)| case.is_right(*got))
                && !of(true).any(|(case, got)| case.is_right(*got))
        };
        for (side, name) in SIDES.into_iter().enumerate() {
            assert!(
                !mostly(&|case| case.is_cut_at(side)),
                "right wherever the {name} side is not crossed, wrong wherever it is: is it one of your four?",
            );
        }
        assert!(
            !mostly(&|case| case.a.x == case.b.x),
            "right but for the segments with x_a = x_b: they are parallel to the right and the left side and have no t \
             there, but the upper and the lower side cut them",
        );
        assert!(
            !mostly(&|case| case.a.y == case.b.y),
            "right but for the segments with y_a = y_b: they are parallel to the upper and the lower side and have no t \
             there, but the right and the left side cut them",
        );
        assert!(
            !mostly(&|case| case.a.x == case.b.x || case.a.y == case.b.y),
            "right but for the segments parallel to a side: they have no t there, but the two other sides cut them",
        );
        assert!(
            !mostly(&|case| case.a.x > case.b.x),
            "right where x_a ≤ x_b, wrong wherever x_a > x_b: the answer goes the same way as a → b",
        );
        assert!(
            !mostly(&|case| case.a.y > case.b.y),
            "right where y_a ≤ y_b, wrong wherever y_a > y_b: the answer goes the same way as a → b",
        );
        for (pattern, count) in [
            (
                &(|case: &Self| ends_inside(case) > 0) as &dyn Fn(&Self) -> bool,
                "an end",
            ),
            (&|case: &Self| ends_inside(case) == 2, "both ends"),
            (&|case: &Self| ends_inside(case) == 1, "one end"),
        ] {
            assert!(
                !mostly(pattern),
                "right but for the segments with {count} in the window: an end that lies in the window is an end of the \
                 answer, too",
            );
        }
    }
}

impl fmt::Display for WindowCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [min, max] = [self.min, self.max].map(short_point);
        let [a, b] = [self.a, self.b].map(|p| self.point(p));
        write!(f, "window {min} to {max}, segment {a} to {b}")
    }
}

fn any_window(inputs: &mut Inputs) -> (DVec2, DVec2) {
    let mut whole = |min, max| f64::from(inputs.integer(min, max));
    let min = DVec2::new(whole(-20, 10), whole(-20, 10));
    (min, min + DVec2::new(whole(4, 20), whole(4, 20)))
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
    fn points_stay_short() {
        assert_eq!(short_point(DVec2::new(1.0 / 3.0, -20.0)), "(0.333333, -20)");
        // In full where the window's side would be read otherwise.
        let case = WindowCase {
            a: DVec2::new(5.0, 10.00000001),
            ..slide()
        };
        let told = "window (0, 0) to (10, 10), segment (5, 10.00000001) to (15, 5)";
        assert_eq!(case.to_string(), told);
    }

    #[test]
    fn hairs_are_what_they_say() {
        let hairs = WindowCase::hairs();
        assert!(hairs.len() > 100);
        for (plain, fine, by) in hairs {
            for case in [plain, fine] {
                let contains = |p: DVec2| p.cmpge(case.min).all() && p.cmple(case.max).all();
                assert!(!contains(case.a), "{case}: {by}");
                if let Some((p, q)) = case.inside {
                    assert!(contains(p) && contains(q), "{case}: {by}");
                    continue;
                }
                assert!(!contains(case.b), "{case}: {by}");
                // The corner's line of a diagonal, x + y = const, leaves the window on one side.
                let d = case.b - case.a;
                let sides = [
                    case.min,
                    case.max,
                    DVec2::new(case.min.x, case.max.y),
                    DVec2::new(case.max.x, case.min.y),
                ]
                .map(|corner| d.perp_dot(corner - case.a) > 0.0);
                let beyond =
                    case.a.min(case.b).cmpgt(case.max) | case.a.max(case.b).cmplt(case.min);
                assert!(beyond.any() || sides == [sides[0]; 4], "{case}: {by}");
            }
        }
    }

    #[test]
    fn rounded_cases_are_right_up_to_rounding() {
        let mut inputs = Inputs::new(2);
        for case in WindowCase::many(200, &mut inputs, WindowCase::rounded) {
            let (p, q) = case.inside.unwrap();
            for p in [p, q] {
                let slack = DVec2::splat(1e-13);
                assert!(
                    p.cmpge(case.min - slack).all() && p.cmple(case.max + slack).all(),
                    "{case}"
                );
                assert!(
                    (case.b - case.a).perp_dot(p - case.a).abs() < 1e-10,
                    "{case}"
                );
            }
        }
    }

    #[test]
    #[should_panic(
        expected = "the start (0, 12) of the answer does not lie on the line through a and b"
    )]
    fn an_end_off_the_line_is_named() {
        slide().assert_right(Some((DVec2::new(0.0, 12.0), DVec2::new(10.0, 5.0))));
    }

    #[test]
    #[should_panic(expected = "beside the left side by a rounding")]
    fn a_rounded_side_is_named() {
        slide().assert_right(Some((DVec2::new(1e-15, 5.0), DVec2::new(10.0, 5.0))));
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
        expected = "window (0, 0) to (10, 10), segment (-5, 5) to (15, 5): (0, 5) to (10, 5) lies inside, but got None"
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
