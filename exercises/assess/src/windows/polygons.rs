//! Polygons against a line and in a window.

use std::fmt;

use glam::{DVec2, DVec3};

use super::{SIDES, short_point};
use crate::{Ink, Panel, Picture, brief_number};

/// A polygon and the lines that clip it, one after another: one line, or the four sides of a window.
#[derive(Clone, Debug)]
pub struct PolygonCase {
    polygon: Vec<DVec2>,
    lines: Vec<DVec3>,
    window: Option<(DVec2, DVec2)>,
}

/// At most so many vertices are told.
const MOST_POINTS: usize = 6;

fn side(line: DVec3, p: DVec2) -> f64 {
    line.dot(p.extend(1.0))
}

/// Each edge of a polygon, the one from the last vertex to the first at the end.
fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

fn area(polygon: &[DVec2]) -> f64 {
    edges(polygon).map(|(a, b)| a.perp_dot(b)).sum::<f64>() / 2.0
}

/// Whether a point is in the polygon by the even-odd rule; `None` on an edge.
fn contains(polygon: &[DVec2], p: DVec2) -> Option<bool> {
    let mut inside = false;
    for (a, b) in edges(polygon) {
        let side = (b - a).perp_dot(p - a);
        if side == 0.0 && (a - p).dot(b - p) <= 0.0 {
            return None;
        }
        inside ^= (a.y <= p.y) != (b.y <= p.y) && (side < 0.0) == (a.y < b.y);
    }
    Some(inside)
}

fn show_list(points: &[DVec2]) -> String {
    if points.is_empty() {
        return "nothing".to_owned();
    }
    let shown: Vec<String> = points
        .iter()
        .take(MOST_POINTS)
        .map(|&p| short_point(p))
        .collect();
    let more = match points.len() {
        count if count > MOST_POINTS => format!(" … ({count} vertices)"),
        _ => String::new(),
    };
    shown.join(" ") + &more
}

/// A line as `2 x − y + 3 ≥ 0`.
fn show_line(line: DVec3) -> String {
    let mut text = String::new();
    for (factor, name) in [(line.x, " x"), (line.y, " y"), (line.z, "")] {
        if factor == 0.0 {
            continue;
        }
        let sign = match (text.is_empty(), factor < 0.0) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        text += sign;
        if factor.abs() == 1.0 && !name.is_empty() {
            text += name.trim_start();
        } else {
            text += &brief_number(factor.abs());
            text += name;
        }
    }
    if text.is_empty() {
        text += "0";
    }
    text + " ≥ 0"
}

/// What an edge puts: the crossing, then its second vertex.
fn put(line: DVec3, (a, b): (DVec2, DVec2)) -> (Option<DVec2>, Option<DVec2>) {
    let (side_a, side_b) = (side(line, a), side(line, b));
    let crosses = (side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0);
    let crossing = crosses.then(|| a + (b - a) * (side_a / (side_a - side_b)));
    (crossing, (side_b >= 0.0).then_some(b))
}

fn twice(p: DVec2, got: &[DVec2]) -> String {
    format!(
        "{} is put twice in {}: each edge puts its end B alone, and a vertex on the line is its own crossing",
        short_point(p),
        show_list(got)
    )
}

impl PolygonCase {
    /// A polygon against the line `(a, b, c)`.
    #[must_use]
    pub fn against(polygon: &[DVec2], line: DVec3) -> Self {
        Self {
            polygon: polygon.to_vec(),
            lines: vec![line],
            window: None,
        }
    }

    /// A polygon in a window.
    #[must_use]
    pub fn in_window(polygon: &[DVec2], min: DVec2, max: DVec2) -> Self {
        Self {
            polygon: polygon.to_vec(),
            lines: vec![
                DVec3::new(1.0, 0.0, -min.x),
                DVec3::new(-1.0, 0.0, max.x),
                DVec3::new(0.0, 1.0, -min.y),
                DVec3::new(0.0, -1.0, max.y),
            ],
            window: Some((min, max)),
        }
    }

    /// What the lines leave, for the picture and for one line.
    fn want(&self) -> Vec<DVec2> {
        let mut polygon = self.polygon.clone();
        for &line in &self.lines {
            polygon = edges(&polygon)
                .map(|edge| put(line, edge))
                .flat_map(|(crossing, b)| [crossing, b].into_iter().flatten())
                .collect();
        }
        if polygon.len() < 3 {
            polygon.clear();
        }
        polygon
    }

    fn largest(&self) -> f64 {
        let largest = |most: f64, p: &DVec2| most.max(p.abs().max_element());
        self.polygon.iter().fold(0.0, largest)
    }

    /// Some roundings of the largest coordinate, at a crossing that may be flat by 1 : 240.
    fn is_near(&self, p: DVec2, q: DVec2) -> bool {
        (p - q).abs().max_element() <= 2048.0 * f64::EPSILON * self.largest()
    }

    /// Whether both lists name the same polygon, from whichever vertex on.
    fn is_same(&self, got: &[DVec2], want: &[DVec2]) -> bool {
        let near = |(&p, &q): (&DVec2, &DVec2)| self.is_near(p, q);
        got.len() == want.len()
            && (got.is_empty()
                || (0..got.len()).any(|start| got.iter().cycle().skip(start).zip(want).all(near)))
    }

    /// What the student kept, beside what is right.
    #[track_caller]
    pub fn picture(&self, got: &[DVec2]) -> Picture {
        let want = self.want();
        let has = |points: &[DVec2], p| points.iter().any(|&q| self.is_near(p, q));
        let panel = |kept: &[DVec2], ink| {
            let mut panel = Panel::plane();
            panel.polygon(&self.polygon, Ink::Faint);
            panel.polygon(kept, ink);
            for &p in kept {
                let is_right = has(&want, p);
                panel.point(p, "", if is_right { Ink::Right } else { Ink::Extra });
            }
            for &p in want.iter().filter(|&&p| !has(kept, p)) {
                panel.point(p, "?", Ink::Missing);
            }
            match self.window {
                Some((min, max)) => panel.window(min, max),
                None => self.draw_line(&mut panel),
            }
            panel
        };
        let ink = if self.is_same(got, &want) {
            Ink::Right
        } else {
            Ink::Extra
        };
        Picture::beside(panel(got, ink), panel(&want, Ink::Right))
    }

    /// The part of the line that passes the polygon.
    fn draw_line(&self, panel: &mut Panel) {
        let low = self.polygon.iter().copied().reduce(DVec2::min);
        let high = self.polygon.iter().copied().reduce(DVec2::max);
        let (Some(low), Some(high)) = (low, high) else {
            return;
        };
        for &line in &self.lines {
            let normal = line.truncate();
            let Some(along) = normal.perp().try_normalize() else {
                continue;
            };
            let centre = low + (high - low) / 2.0;
            let foot = centre - normal * (side(line, centre) / normal.length_squared());
            let reach = 0.6 * (high - low).length();
            if foot.distance(centre) <= 2.0 * reach {
                panel.segment(foot - reach * along, foot + reach * along, Ink::Ideal);
            }
        }
    }

    /// Fails unless `clip` gives what is right, and leaves a picture.
    ///
    /// # Panics
    ///
    /// When it does not, with what can be said of it: the plainest first.
    #[track_caller]
    pub fn check(&self, clip: &dyn Fn(&[DVec2]) -> Vec<DVec2>) {
        let got = clip(&self.polygon);
        let _picture = self.picture(&got);
        if !self.is_right(&got) {
            assert!(
                !self.forgets_an_edge(&got, clip),
                "{self}: got {}, and what is right when the first vertex stands at the end of the list again: the edge from \
                 the last vertex to the first belongs to the polygon",
                show_list(&got)
            );
        }
        let wrong = match (self.window, &self.lines[..]) {
            (None, &[line]) => self.wrong_at(line, &got),
            (window, _) => window.and_then(|(min, max)| self.wrong_in(min, max, &got)),
        };
        if let Some(wrong) = wrong {
            panic!("{self}: {wrong}");
        }
    }

    /// Fails unless the decisions are made at the line itself: a hair beyond it as well as far beyond it, at any scale.
    ///
    /// # Panics
    ///
    /// When they are not.
    #[track_caller]
    pub fn check_hairs(
        clip: fn(&[DVec2], DVec3) -> Vec<DVec2>,
        in_window: impl Fn(DVec2, DVec2, &[DVec2]) -> Vec<DVec2>,
    ) {
        for scale in [1.0, 2f64.powi(-20), 2f64.powi(20)] {
            for hair in [1e-3, 1e-6, 1e-9] {
                for (side, name) in SIDES.into_iter().enumerate() {
                    for fine in [false, true] {
                        let by = if fine { hair } else { 0.3 };
                        let window = (DVec2::splat(scale), DVec2::splat(11.0 * scale));
                        // The border of a window 1…11, and the three vertices of a thin triangle beyond it.
                        let border = if side % 2 == 0 { 11.0 } else { 1.0 };
                        let out = if side % 2 == 0 { 1.0 } else { -1.0 };
                        let place = |along: f64, beyond: f64| {
                            let across = border + out * beyond;
                            let p = if side < 2 {
                                DVec2::new(along, across)
                            } else {
                                DVec2::new(across, along)
                            };
                            scale * p
                        };
                        let polygon = [place(3.0, by), place(6.0, 2.0 * by), place(9.0, by)];
                        let along = if side < 2 { DVec2::Y } else { DVec2::X };
                        let line = (-out * along).extend(out * border * scale);
                        let cases = [
                            (Self::against(&polygon, line), clip(&polygon, line)),
                            (
                                Self::in_window(&polygon, window.0, window.1),
                                in_window(window.0, window.1, &polygon),
                            ),
                        ];
                        for (case, got) in cases {
                            let _picture = case.picture(&got);
                            assert!(
                                fine || got.is_empty(),
                                "{case}: the polygon lies outside, beyond the line of the {name} side, but got {}",
                                show_list(&got)
                            );
                            assert!(
                                got.is_empty(),
                                "{case}: every vertex lies outside, by {} beyond the {name} side and more, but got {}; three \
                                 tenths beyond, nothing is kept: compare s with 0 itself, without a tolerance",
                                brief_number(by * scale),
                                show_list(&got)
                            );
                        }
                    }
                }
            }
        }
        // The next number below 1; nothing is rounded.
        let x = 1.0_f64.next_down();
        let line = DVec3::new(1.0, 0.0, -1.0);
        let polygon = [(x, 1.0), (x, 2.0), (x, 3.0), (-1.0, 2.0)].map(DVec2::from);
        let got = clip(&polygon, line);
        assert!(
            got.is_empty(),
            "vertices with x = {x} and smaller against x − 1 ≥ 0: all lie outside, but got {}: compare s with 0 itself, \
             without a tolerance",
            show_list(&got)
        );
    }

    /// Whether the answer is right once the edge from the last vertex to the first is made one of the others, wherever
    /// the list begins.
    fn forgets_an_edge(&self, got: &[DVec2], clip: &dyn Fn(&[DVec2]) -> Vec<DVec2>) -> bool {
        let without = |points: &[DVec2], twice: Option<DVec2>| {
            let mut points = points.to_vec();
            points.dedup_by(|p, q| p == q && twice.is_none_or(|twice| *p == twice));
            while points.len() > 1
                && points.first() == points.last()
                && twice.is_none_or(|twice| points[0] == twice)
            {
                points.pop();
            }
            points
        };
        if self.polygon.len() < 3 || self.is_right(&without(got, None)) {
            return false;
        }
        (0..self.polygon.len()).all(|start| {
            let mut closed = self.polygon.clone();
            closed.rotate_left(start);
            closed.push(closed[0]);
            let kept = without(&clip(&closed), Some(closed[0]));
            kept.len() >= 3 && self.is_right(&kept)
        })
    }

    /// Against one line the vertices and their order are certain.
    fn wrong_at(&self, line: DVec3, got: &[DVec2]) -> Option<String> {
        let want = self.want();
        if self.is_same(got, &want) && !got.iter().any(|p| p.is_nan()) {
            return None;
        }
        if let Some(wrong) = self.wrong_anywhere(got, &want) {
            return Some(wrong);
        }
        let s = |p| side(line, p);
        let has = |points: &[DVec2], p| points.iter().any(|&q| self.is_near(p, q));
        // The other side.
        let is_beyond = |p: &DVec2| s(*p) < 0.0 && !has(&want, *p);
        if got.iter().any(is_beyond)
            && self
                .polygon
                .iter()
                .all(|&p| (s(p) < 0.0) == has(got, p) || s(p) == 0.0)
        {
            return Some(format!(
                "{} is kept, the part with s ≤ 0; inside is s ≥ 0",
                show_list(got)
            ));
        }
        for &p in got {
            if self.polygon.contains(&p) && s(p) < 0.0 && !has(&want, p) {
                return Some(format!(
                    "{} is put, but it lies outside: s = {} < 0",
                    short_point(p),
                    brief_number(s(p))
                ));
            }
        }
        // Crossings at a wrong place.
        let puts: Vec<_> = edges(&self.polygon)
            .map(|edge| (edge, put(line, edge)))
            .collect();
        let expected: Vec<DVec2> = puts
            .iter()
            .flat_map(|(_, (crossing, b))| [*crossing, *b].into_iter().flatten())
            .collect();
        if let Some(&stray) = got.iter().find(|&&p| !has(&expected, p)) {
            let on_edge = puts.iter().find(|((a, b), (crossing, _))| {
                let (way, to) = (*b - *a, stray - *a);
                crossing.is_some() && way.perp_dot(to).abs() <= 1e-12 * way.length_squared()
            });
            return Some(match on_edge {
                Some(&((a, b), (Some(crossing), _))) => format!(
                    "{} is on the edge {} → {}, but not on the line; the crossing is {}: A + (B − A) s_A / (s_A − s_B)",
                    short_point(stray),
                    short_point(a),
                    short_point(b),
                    short_point(crossing)
                ),
                _ => format!(
                    "{} is put, but it is neither a vertex of the polygon nor a crossing",
                    short_point(stray)
                ),
            });
        }
        if got.len() < 3 {
            return Some(format!(
                "got {}: fewer than three are no polygon, so the answer has none",
                show_list(got)
            ));
        }
        // What is not there.
        for &((a, b), (crossing, vertex)) in &puts {
            let missing = [(crossing, "the crossing"), (vertex, "B")];
            for (p, name) in missing {
                let Some(p) = p.filter(|&p| !has(got, p)) else {
                    continue;
                };
                let p_shown = short_point(p);
                let place = |p| match s(p) {
                    s if s > 0.0 => "inside",
                    0.0 => "on the line, so inside",
                    _ => "outside",
                };
                return Some(format!(
                    "A = {} is {}, B = {} is {}: put {name}, {p_shown}, which is missing",
                    short_point(a),
                    place(a),
                    short_point(b),
                    place(b),
                ));
            }
        }
        for &p in got {
            let times = |points: &[DVec2]| points.iter().filter(|&&q| self.is_near(p, q)).count();
            if times(got) > times(&want) {
                return Some(twice(p, got));
            }
        }
        for &(_, (crossing, vertex)) in &puts {
            let Some((crossing, vertex)) = crossing.zip(vertex) else {
                continue;
            };
            let turned =
                |(p, q): (DVec2, DVec2)| self.is_near(p, vertex) && self.is_near(q, crossing);
            if got.len() == want.len() && edges(got).any(turned) {
                return Some(format!(
                    "{} comes before {}: where an edge comes in, put the crossing, then B",
                    short_point(vertex),
                    short_point(crossing)
                ));
            }
        }
        Some(format!(
            "expected {}, got {}",
            show_list(&want),
            show_list(got)
        ))
    }

    /// In a window pieces may be joined in several ways: the area counts, and what is in it.
    fn wrong_in(&self, min: DVec2, max: DVec2, got: &[DVec2]) -> Option<String> {
        let want = self.want();
        if got.is_empty() && area(&want).abs() <= 1e-9 * self.largest().powi(2) {
            return None;
        }
        if let Some(wrong) = self.wrong_anywhere(got, &want) {
            return Some(wrong);
        }
        let inside = |p: &&DVec2| p.cmpge(min).all() && p.cmple(max).all();
        if self.polygon.iter().filter(inside).eq(got) && want.len() > got.len() {
            return Some(format!(
                "{} is kept, the vertices inside and nothing else: where an edge crosses a side, its crossing is put",
                show_list(got)
            ));
        }
        let slack = 2048.0 * f64::EPSILON * self.largest();
        for &p in got {
            let beyond = [
                p.y > max.y + slack,
                p.y < min.y - slack,
                p.x > max.x + slack,
                p.x < min.x - slack,
            ];
            if let Some(side) = beyond.into_iter().position(|beyond| beyond) {
                return Some(format!(
                    "{} is put, but it lies beyond the {} side",
                    short_point(p),
                    SIDES[side]
                ));
            }
        }
        // The middles of 24 × 24 cells, which are halves where the window is 0…24.
        let step = (self.largest() / 24.0).max(f64::MIN_POSITIVE);
        for p in (0..24 * 24).map(|i| DVec2::new((i % 24).into(), (i / 24).into())) {
            let p = (p + 0.5) * step;
            let (Some(given), Some(is_in)) = (contains(&self.polygon, p), contains(got, p)) else {
                continue;
            };
            let in_window = p.cmpge(min).all() && p.cmple(max).all();
            if is_in && !given {
                return Some(format!(
                    "{} is in the answer {}, but not in the polygon",
                    short_point(p),
                    show_list(got)
                ));
            }
            if !is_in && given && in_window {
                return Some(format!(
                    "{} is in the polygon and in the window, but not in the answer {}",
                    short_point(p),
                    show_list(got)
                ));
            }
        }
        let (want, got_area) = (area(&want), area(got));
        if (want + got_area).abs() < 0.5 * want.abs() {
            return Some(format!(
                "got {}: the vertices go round the other way; they keep their order",
                show_list(got)
            ));
        }
        if (want - got_area).abs() > 1e-9 * self.largest().powi(2) {
            return Some(format!(
                "the part in the window has the area {}, the answer {}: {}",
                brief_number(want.abs()),
                show_list(got),
                brief_number(got_area)
            ));
        }
        None
    }

    /// What is plain before one looks at any edge.
    fn wrong_anywhere(&self, got: &[DVec2], want: &[DVec2]) -> Option<String> {
        if got.is_empty() {
            return Some(format!(
                "nothing is kept, but {} is inside",
                show_list(want)
            ));
        }
        if let Some(p) = got.iter().find(|p| !p.is_finite()) {
            return Some(format!(
                "{} is put: a crossing is asked for only where s_A and s_B have different signs",
                short_point(*p)
            ));
        }
        let repeats = |points: &[DVec2]| edges(points).find(|(p, q)| p == q);
        let all = want
            .iter()
            .all(|&p| got.iter().any(|&q| self.is_near(p, q)));
        // Pieces and spikes of a window may meet themselves.
        let simple = self.window.is_none()
            || (self.polygon.len() == 3 && area(want).abs() > 1e-9 * self.largest().powi(2));
        if let (Some((p, _)), None, true) =
            (repeats(got), repeats(want), simple && all && got.len() > 1)
        {
            return Some(twice(p, got));
        }
        let turned: Vec<_> = got.iter().rev().copied().collect();
        if !self.is_same(got, want) && self.is_same(&turned, want) {
            let why = match want.len() {
                3 => {
                    "in the other order; vertices keep theirs, and where an edge comes in, the crossing is put before B"
                }
                _ => "the other way round; they keep their order",
            };
            return Some(format!("got {}: the right vertices {why}", show_list(got)));
        }
        None
    }

    fn is_right(&self, got: &[DVec2]) -> bool {
        match (self.window, &self.lines[..]) {
            (None, &[line]) => self.wrong_at(line, got).is_none(),
            (window, _) => window.is_none_or(|(min, max)| self.wrong_in(min, max, got).is_none()),
        }
    }

    /// Fails if the answers are right where a side cuts nothing off, and wrong wherever it does.
    ///
    /// # Panics
    ///
    /// When that is so of one of the sides.
    #[track_caller]
    pub fn assert_no_pattern(all: &[(Self, Vec<DVec2>)]) {
        for (side, name) in SIDES.into_iter().enumerate() {
            let cuts = |case: &Self| {
                let (min, max) = case.window.unwrap_or_default();
                let beyond = |p: &DVec2| [p.y > max.y, p.y < min.y, p.x > max.x, p.x < min.x][side];
                !case.want().is_empty() && case.polygon.iter().any(beyond)
            };
            let of = |yes| all.iter().filter(move |(case, _)| cuts(case) == yes);
            let wrong = of(true).filter(|(case, got)| !case.is_right(got)).count();
            let rest = of(false).filter(|(case, _)| !case.want().is_empty());
            assert!(
                wrong == 0
                    || 2 * wrong < of(true).count()
                    || !rest.clone().all(|(case, got)| case.is_right(got)),
                "right wherever the polygon does not go beyond the {name} side, wrong in {wrong} of {} windows where it \
                 does: clip against all four",
                of(true).count()
            );
        }
    }
}

impl fmt::Display for PolygonCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let polygon = show_list(&self.polygon);
        match self.window {
            Some((min, max)) => write!(
                f,
                "{polygon} in the window {} to {}",
                short_point(min),
                short_point(max)
            ),
            None => {
                let lines: Vec<String> = self.lines.iter().map(|&line| show_line(line)).collect();
                write!(f, "{polygon} against {}", lines.join(", "))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Vec<DVec2> {
        [(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]
            .map(DVec2::from)
            .to_vec()
    }

    fn case() -> PolygonCase {
        PolygonCase::against(&triangle(), DVec3::new(-1.0, 0.0, 10.0))
    }

    fn told(case: &PolygonCase, got: &[(f64, f64)]) -> String {
        let got: Vec<DVec2> = got.iter().map(|&p| p.into()).collect();
        case.wrong_at(case.lines[0], &got).unwrap_or_default()
    }

    #[test]
    fn what_is_right_passes_from_any_vertex_on() {
        let want = [(10.0, 5.0), (10.0, 10.0), (5.0, 15.0), (5.0, 5.0)];
        assert_eq!(case().want(), want.map(DVec2::from));
        for start in 0..4 {
            let mut got = want;
            got.rotate_left(start);
            assert_eq!(told(&case(), &got), "");
        }
        let square = PolygonCase::in_window(&triangle(), DVec2::ZERO, DVec2::splat(10.0));
        assert!(square.is_right(&square.want()));
        assert_eq!(area(&square.want()), 25.0);
    }

    #[test]
    fn each_mistake_is_named() {
        for (got, why) in [
            (&[][..], "nothing is kept"),
            (
                &[(5.0, 5.0), (10.0, 5.0), (5.0, 15.0)],
                "put the crossing, (10, 10)",
            ),
            (
                &[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)],
                "it lies outside: s = -5 < 0",
            ),
            (
                &[(5.0, 15.0), (10.0, 10.0), (10.0, 5.0), (5.0, 5.0)],
                "the other way round",
            ),
            (
                &[(5.0, 5.0), (10.0, 5.0), (5.0, 15.0), (10.0, 10.0)],
                "(5, 15) comes before (10, 10)",
            ),
            (
                &[
                    (5.0, 5.0),
                    (5.0, 5.0),
                    (10.0, 5.0),
                    (10.0, 10.0),
                    (5.0, 15.0),
                ],
                "put twice",
            ),
            (
                &[(5.0, 5.0), (7.0, 5.0), (10.0, 10.0), (5.0, 15.0)],
                "but not on the line",
            ),
            (
                &[(15.0, 5.0), (10.0, 5.0), (10.0, 10.0)],
                "the part with s ≤ 0",
            ),
        ] {
            let told = told(&case(), got);
            assert!(told.contains(why), "{told}");
        }
    }

    #[test]
    fn lines_and_lists_are_short() {
        assert_eq!(show_line(DVec3::new(-1.0, 2.0, -3.5)), "−x + 2 y − 3.5 ≥ 0");
        assert_eq!(show_line(DVec3::ZERO), "0 ≥ 0");
        assert_eq!(
            show_list(&[DVec2::X; 8]).matches("(1, 0)").count(),
            MOST_POINTS
        );
    }
}
