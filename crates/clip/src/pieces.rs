//! A polygon against a window, in separate pieces.
//!
//! A concave polygon may fall into several parts. Its boundary enters and leaves the window; between leaving and the
//! next entry along the window's border runs the border of a piece. Joining each way out with the right way in gives
//! every piece for itself, without the edges back and forth that one outline for all needs.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/polygon-cases.svg"))]

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::Outcode;
use crate::crossing::compare_exactly;
use crate::outline::{Outline, edges, is_finite, length_of_run};
use crate::segment::Segment;
use crate::window::{Line, Window};

use ends::{Border, End, strict_code};

mod ends;

/// The parts of a polygon in `window`, each a polygon of its own.
///
/// # Formula
///
/// ```text
/// chain: a part of the polygon's boundary strictly inside the window, from an entry E to an exit X on its border
/// counter-clockwise polygon: from X along the border, counter-clockwise, to the next E; clockwise: the other way
/// ```
///
/// # Properties
///
/// - Every point strictly inside the window and off the boundary has in the pieces together the winding number it has
///   in the polygon, whatever the input: 1 (or −1, clockwise) in one piece and 0 elsewhere for a simple polygon.
/// - Vertices inside are returned unchanged; new ones are the nearest doubles to the crossings, or corners of the
///   window. All lie in the window exactly, and a piece clipped again comes back unchanged.
/// - What is entry, exit, order along the border is decided exactly. Pieces come in the order in which the
///   polygon enters them, each turns the way the polygon does, and no vertex follows itself.
/// - A polygon inside the window is returned as it is. One around it gives the window.
/// - None for what has no area in the window: a polygon beside it or touching it, fewer than three vertices, a
///   window that is a segment or a point; none if a coordinate is not finite.
/// - Self-intersecting input: pieces may overlap, and where the polygon winds round the window k times there are k
///   outlines. A piece may touch itself where the polygon does.
///
/// # Pitfalls
///
/// Comparing rounded positions along the border joins the wrong ends where two edges leave through nearly one point.
///
/// # Examples
///
/// The letter U, of which the window cuts off the bottom:
///
/// ```
/// use ombra_clip::{Window, pieces};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let u = [(1.0, -5.0), (9.0, -5.0), (9.0, 5.0), (7.0, 5.0), (7.0, -3.0), (3.0, -3.0), (3.0, 5.0), (1.0, 5.0)];
/// let arms = pieces::clip_polygon(&window, &u.map(DVec2::from));
/// assert_eq!(arms.len(), 2);
/// assert_eq!(arms[0], [(9.0, 0.0), (9.0, 5.0), (7.0, 5.0), (7.0, 0.0)].map(DVec2::from));
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono», case B. K. Weiler, P. Atherton, «Hidden surface removal using polygon area
/// sorting», 1977, from whom the walk along the other polygon's border is.
#[must_use]
pub fn clip_polygon(window: &Window, polygon: &[DVec2]) -> Vec<Vec<DVec2>> {
    clip_polygon_counted(window, polygon, &mut ())
}

/// [`clip_polygon`], counting the vertices and a division for each crossing.
#[must_use]
pub fn clip_polygon_counted(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<Vec<DVec2>> {
    if !(window.min.x < window.max.x && window.min.y < window.max.y) {
        return Vec::new();
    }
    if let Some((&first, after)) = polygon.split_first()
        && window.contains(first)
    {
        let run = length_of_run(window, first, Outcode::INSIDE, after);
        if after.iter().skip(run).all(|&p| window.contains(p)) {
            work.add(Counter::Vertices, polygon.len() as u64);
            let (run, rest) = polygon.split_at(run + 1);
            let mut outline = Outline::with_capacity(polygon.len());
            outline.extend(run);
            rest.iter().for_each(|&p| outline.put(p));
            return not_empty(outline.close(window)).into_iter().collect();
        }
    }
    if !is_finite(polygon) {
        return Vec::new();
    }
    let chains = Chains::of(window, polygon, work);
    let winding = winding_beside_first_corner(window, polygon);
    if chains.ends.is_empty() {
        return around(window, winding);
    }
    chains.join(Border { window, polygon }, winding)
}

fn not_empty(polygon: Vec<DVec2>) -> Option<Vec<DVec2>> {
    (!polygon.is_empty()).then_some(polygon)
}

/// The window itself, as often as `winding` says and in its direction.
fn around(window: &Window, winding: i64) -> Vec<Vec<DVec2>> {
    let mut corners = window.corners().to_vec();
    if winding < 0 {
        corners.reverse();
    }
    (0..winding.unsigned_abs())
        .map(|_| corners.clone())
        .collect()
}

/// The parts of the boundary strictly inside, with their ends on the border.
struct Chains {
    points: Vec<DVec2>,
    /// Where in `points` each chain ends.
    limits: Vec<usize>,
    ends: Vec<End>,
    /// The polygon's first vertex is strictly inside: the first chain continues the last.
    first_continues_last: bool,
}

impl Chains {
    fn of(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Self {
        let first_inside = polygon
            .first()
            .is_some_and(|&p| strict_code(window, p).is_inside());
        let mut chains = Self {
            points: Vec::with_capacity(polygon.len()),
            limits: Vec::new(),
            ends: Vec::new(),
            first_continues_last: first_inside,
        };
        work.add(Counter::Vertices, polygon.len() as u64);
        if first_inside {
            chains.points.extend(polygon.first());
        }
        let next = polygon.iter().skip(1).chain(polygon.first());
        let mut code = polygon
            .first()
            .map_or(Outcode::INSIDE, |&p| strict_code(window, p));
        let border = Border { window, polygon };
        for (edge, &b) in next.enumerate() {
            let code_a = code;
            code = strict_code(window, b);
            if (code_a | code).is_inside() {
                chains.points.push(b);
            } else if (code_a & code).is_inside() {
                let chain = chains.limits.len();
                let [enters, leaves] = [!code_a.is_inside(), !code.is_inside()];
                let end = |is_entry| border.end(edge, is_entry, chain);
                let entry = if enters { end(true) } else { None };
                let exit = if leaves { end(false) } else { None };
                if entry.is_some() != enters || exit.is_some() != leaves {
                    continue; // it only touches
                }
                work.add(Counter::Divisions, u64::from(enters) + u64::from(leaves));
                chains.points.extend(entry.map(|end| end.point));
                chains.points.push(exit.map_or(b, |end| end.point));
                chains.ends.extend(entry.into_iter().chain(exit));
                if leaves {
                    chains.limits.push(chains.points.len());
                }
            }
        }
        if first_inside && !chains.ends.is_empty() {
            // The last edge led to the first vertex, which is there already.
            chains.points.pop();
            chains.limits.push(chains.points.len());
        }
        chains
    }

    /// Joins each exit with the right entry; `winding` is that of the border's start.
    fn join(mut self, border: Border, winding: i64) -> Vec<Vec<DVec2>> {
        border.sort(&mut self.ends, false);
        // Past an exit of a counter-clockwise polygon the border runs inside it, past an entry outside.
        let step = |end: &End| if end.is_entry { -1 } else { 1 };
        let lowest = |ends: &[End]| running(winding, ends.iter().map(step)).min().unwrap_or(0);
        if lowest(&self.ends).min(winding) < 0 {
            // Clockwise: so that an edge out and back in meets itself here too.
            border.sort(&mut self.ends, true);
        }
        let least = lowest(&self.ends).min(winding);
        let most = running(winding, self.ends.iter().map(step))
            .max()
            .unwrap_or(0)
            .max(winding);
        // What winds round the whole border is the window itself, as often.
        let base = 0.clamp(least, most);
        let start = running(winding, self.ends.iter().map(step))
            .position(|w| w == base)
            .map_or(0, |i| i + 1);

        let mut next: Vec<Option<Link>> = vec![None; self.limits.len()];
        let mut open: Vec<(usize, End)> = Vec::new();
        let mut depth = 0;
        let ranked = self.ends.iter().copied().enumerate();
        for (rank, end) in ranked.clone().skip(start).chain(ranked.take(start)) {
            let opens = if end.is_entry { depth <= 0 } else { depth >= 0 };
            depth += step(&end);
            if opens {
                open.push((rank, end));
                continue;
            }
            let Some((earlier_rank, earlier)) = open.pop() else {
                continue;
            };
            let mut corners = (end.side + 4 - earlier.side) % 4;
            if corners == 0 && rank < earlier_rank {
                corners = 4;
            }
            let (exit, entry) = if end.is_entry {
                (earlier, end)
            } else {
                (end, earlier)
            };
            let link = Link {
                to: entry.chain,
                corners,
                side: exit.side,
                forwards: end.is_entry,
            };
            if let Some(slot) = next.get_mut(exit.chain) {
                *slot = Some(link);
            }
        }
        if self.first_continues_last
            && let Some(slot) = next.last_mut()
        {
            *slot = Some(Link {
                to: 0,
                corners: 0,
                side: 0,
                forwards: true,
            });
        }
        let mut pieces = self.follow(border.window, next);
        pieces.extend(around(border.window, base));
        pieces
    }

    /// The loops that the links make of the chains.
    fn follow(&self, window: &Window, mut next: Vec<Option<Link>>) -> Vec<Vec<DVec2>> {
        let corners = window.corners();
        let mut pieces = Vec::new();
        for first in 0..next.len() {
            let mut outline = Outline::default();
            let mut chain = first;
            while let Some(link) = next.get_mut(chain).and_then(Option::take) {
                let from = chain.checked_sub(1).and_then(|i| self.limits.get(i));
                let range =
                    from.copied().unwrap_or(0)..self.limits.get(chain).copied().unwrap_or(0);
                for &p in self.points.get(range).unwrap_or_default() {
                    outline.put(p);
                }
                for k in 0..link.corners {
                    let side = if link.forwards {
                        link.side + 1 + k
                    } else {
                        link.side + 4 - k
                    };
                    if let Some(&corner) = corners.get(usize::from(side % 4)) {
                        outline.put(corner);
                    }
                }
                chain = link.to;
            }
            pieces.extend(not_empty(outline.close(window)));
        }
        pieces
    }
}

/// What follows a chain: so many corners of the window, from the exit's side on, then another chain.
#[derive(Clone, Copy)]
struct Link {
    to: usize,
    corners: u8,
    side: u8,
    /// Counter-clockwise.
    forwards: bool,
}

/// The sums of `start` and the steps so far, after each step.
fn running(start: i64, steps: impl Iterator<Item = i64>) -> impl Iterator<Item = i64> {
    steps.scan(start, |w, step| {
        *w += step;
        Some(*w)
    })
}

/// The winding number of the polygon just inside the corner `min`: right of the left side by less than above the lower.
///
/// A ray to the left from there meets the edges from below or on y_min to above it, if they cross y_min left of the
/// corner, or at it and lean left or stand upright.
fn winding_beside_first_corner(window: &Window, polygon: &[DVec2]) -> i64 {
    let corner = window.min;
    let mut winding = 0;
    for (a, b) in edges(polygon) {
        let rises = b.y > corner.y;
        if (a.y > corner.y) == rises {
            continue;
        }
        let [low, high] = if rises { [a, b] } else { [b, a] };
        let left = match compare_exactly(
            Segment::new(low, high),
            Line::Horizontal(corner.y),
            corner.x,
        ) {
            Ordering::Less => true,
            Ordering::Equal => high.x <= low.x,
            Ordering::Greater => false,
        };
        if left {
            winding += if rises { -1 } else { 1 };
        }
    }
    winding
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{self, absolute, area, int, r, small_window, winding};
    use proptest::prelude::*;

    fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
        p.map(DVec2::from).to_vec()
    }

    fn lecture() -> Window {
        Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
    }

    #[test]
    fn the_lectures_cases() {
        let w = lecture();
        // A, convex.
        let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        let square = points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
        assert_eq!(clip_polygon(&w, &triangle), [square]);
        // B, concave: the letter U falls into two arms, both ways round.
        let mut u = points([
            (1.0, -5.0),
            (9.0, -5.0),
            (9.0, 5.0),
            (7.0, 5.0),
            (7.0, -3.0),
            (3.0, -3.0),
            (3.0, 5.0),
            (1.0, 5.0),
        ]);
        let arm = |x: f64| points([(x + 2.0, 0.0), (x + 2.0, 5.0), (x, 5.0), (x, 0.0)]);
        assert_eq!(clip_polygon(&w, &u), [arm(7.0), arm(1.0)]);
        u.reverse();
        let reversed = |x: f64| {
            let mut arm = arm(x);
            arm.reverse();
            arm
        };
        // It starts inside the left arm now, at (1, 5).
        let mut left = reversed(1.0);
        left.rotate_left(1);
        assert_eq!(clip_polygon(&w, &u), [left, reversed(7.0)]);
    }

    #[test]
    fn corners_inside_the_polygon() {
        let w = lecture();
        // From the right side round three corners of the window to its left side.
        let c = points([
            (12.0, 8.0),
            (12.0, -2.0),
            (-2.0, -2.0),
            (-2.0, 12.0),
            (12.0, 12.0),
            (12.0, 9.0),
            (5.0, 9.0),
            (5.0, 8.0),
        ]);
        let mut c = c;
        c.reverse();
        let pieces = clip_polygon(&w, &c);
        assert_eq!(pieces.len(), 1);
        assert_eq!(
            pieces[0],
            points([
                (5.0, 8.0),
                (5.0, 9.0),
                (10.0, 9.0),
                (10.0, 10.0),
                (0.0, 10.0),
                (0.0, 0.0),
                (10.0, 0.0),
                (10.0, 8.0)
            ])
        );
    }

    #[test]
    fn two_edges_through_one_double() {
        // Two lobes on stalks that all cross y = 0 within half an ulp u of (5, 0): at −3/8, −1/8, 3/32 and 7/32 u. By the
        // directions of the stalks alone the lobes would be taken for one.
        let w = lecture();
        let u = 8.0 * f64::EPSILON / 2.0;
        let x = |ulps: f64| 5.0 + ulps * u;
        let lobes = points([
            (x(-2.0), -15.0),
            (5.0, 1.0),
            (4.0, 4.0),
            (1.0, 4.0),
            (1.0, 1.5),
            (x(-1.0), 1.0),
            (x(9.0), -15.0),
            (x(-24.0), -15.5),
            (x(1.0), 0.5),
            (9.0, 0.6),
            (9.0, 4.0),
            (6.0, 4.0),
            (5.0, 0.5),
            (x(3.0), -15.5),
        ]);
        let mut one = lobes[1..6].to_vec();
        one.insert(0, DVec2::new(5.0, 0.0));
        let mut other = lobes[8..13].to_vec();
        other.insert(0, DVec2::new(5.0, 0.0));
        assert_eq!(clip_polygon(&w, &lobes), [one, other]);
    }

    #[test]
    fn touching_itself_and_the_border() {
        let w = lecture();
        // A slit from outside into the polygon has no width, and leaves no trace.
        let mut slit = points([
            (-5.0, -5.0),
            (15.0, -5.0),
            (15.0, 15.0),
            (-5.0, 15.0),
            (-5.0, 5.0),
            (5.0, 5.0),
            (-5.0, 5.0),
        ]);
        let mut corners = w.corners();
        assert_eq!(clip_polygon(&w, &slit), [corners]);
        slit.reverse();
        corners.reverse();
        assert_eq!(clip_polygon(&w, &slit), [corners]);
        // A reflex corner on the border parts two pieces that touch there.
        let m = points([(1.0, -5.0), (9.0, -5.0), (9.0, 5.0), (5.0, 0.0), (1.0, 5.0)]);
        let parts = clip_polygon(&w, &m);
        assert_eq!(parts.len(), 2, "{parts:?}");
        assert_eq!(parts[0], points([(9.0, 0.0), (9.0, 5.0), (5.0, 0.0)]));
        assert_eq!(parts[1], points([(5.0, 0.0), (1.0, 5.0), (1.0, 0.0)]));
    }

    #[test]
    fn degenerate() {
        let w = lecture();
        let huge = f64::MAX;
        let nothing: [Vec<DVec2>; 9] = [
            points([]),
            points([(5.0, 5.0)]),
            points([(5.0, 5.0), (6.0, 6.0)]),
            vec![DVec2::splat(5.0); 7],
            points([(11.0, 5.0), (15.0, 5.0), (11.0, 9.0)]),
            points([(10.0, 10.0), (15.0, 10.0), (10.0, 15.0)]),
            points([(10.0, 2.0), (15.0, 2.0), (15.0, 8.0), (10.0, 8.0)]),
            points([(0.0, 2.0), (0.0, 5.0), (0.0, 8.0)]),
            points([(-5.0, 9.0), (1.0, 15.0), (-5.0, 15.0)]),
        ];
        for polygon in nothing {
            assert!(clip_polygon(&w, &polygon).is_empty(), "{polygon:?}");
        }
        let corners = w.corners();
        assert_eq!(clip_polygon(&w, &corners), [corners]);
        let mut wide = points([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
        assert_eq!(clip_polygon(&w, &wide), [corners]);
        wide.reverse();
        assert_eq!(area(&clip_polygon(&w, &wide)[0]), int(-200));
        // Twice round the window.
        let twice = wide.repeat(2);
        assert_eq!(clip_polygon(&w, &twice).len(), 2);
        // A spike from the border and back.
        let spike = points([(-5.0, 5.0), (5.0, 5.0), (-5.0, 5.0), (-6.0, 9.0)]);
        assert!(clip_polygon(&w, &spike).is_empty());
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let polygon = [DVec2::ONE, DVec2::X, DVec2::new(5.0, bad), DVec2::Y];
            assert!(clip_polygon(&w, &polygon).is_empty());
        }
        let triangle = points([(-5.0, -5.0), (15.0, -5.0), (5.0, 15.0)]);
        let [p, q] = [DVec2::splat(5.0), DVec2::new(5.0, 9.0)];
        for thin in [
            Window { min: p, max: p },
            Window { min: p, max: q },
            Window {
                min: w.max,
                max: w.min,
            },
        ] {
            assert!(clip_polygon(&thin, &triangle).is_empty());
        }
    }

    fn check(w: &Window, polygon: &[DVec2]) -> Result<Vec<Vec<DVec2>>, TestCaseError> {
        let pieces = clip_polygon(w, polygon);
        for piece in &pieces {
            prop_assert!(piece.len() >= 3);
            prop_assert!(piece.iter().all(|&p| w.contains(p)));
            for (a, b) in edges(piece) {
                prop_assert_ne!(a, b);
            }
            prop_assert_eq!(&clip_polygon(w, piece), std::slice::from_ref(piece));
        }
        Ok(pieces)
    }

    /// A comb: columns two wide between a lower and an upper height, as a counter-clockwise outline.
    fn comb(columns: &[(i32, i32)]) -> Vec<DVec2> {
        let at = |x: usize, y: i32| DVec2::new(2.0 * x as f64 - 4.0, y.into());
        let mut outline = Outline::default();
        for (i, &(low, _)) in columns.iter().enumerate() {
            outline.put(at(i, low));
            outline.put(at(i + 1, low));
        }
        for (i, &(low, height)) in columns.iter().enumerate().rev() {
            outline.put(at(i + 1, low + height));
            outline.put(at(i, low + height));
        }
        outline.close(&Window {
            min: DVec2::NAN,
            max: DVec2::NAN,
        })
    }

    /// The parts of the cells that the columns cover inside the window, by flooding.
    fn parts(columns: &[(i32, i32)], width: i32, height: i32) -> (usize, usize) {
        let covered = |x: i32, y: i32| {
            let column = (x + 4) / 2;
            (0..width).contains(&x)
                && (0..height).contains(&y)
                && columns
                    .get(column as usize)
                    .is_some_and(|&(low, h)| low <= y && y < low + h)
        };
        let mut cells: std::collections::BTreeSet<(i32, i32)> = (0..width)
            .flat_map(|x| (0..height).map(move |y| (x, y)))
            .filter(|&(x, y)| covered(x, y))
            .collect();
        let (all, mut parts) = (cells.len(), 0);
        while let Some(cell) = cells.pop_first() {
            parts += 1;
            let mut flood = vec![cell];
            while let Some((x, y)) = flood.pop() {
                for next in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                    if cells.remove(&next) {
                        flood.push(next);
                    }
                }
            }
        }
        (parts, all)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn combs_fall_into_the_parts_that_flooding_finds(
            columns in prop::collection::vec((-5i32..7, 1i32..9), 1..9),
            clockwise: bool,
            turn in 0usize..30,
        ) {
            // Neighbours must share some height, or the comb falls apart by itself.
            let mut columns = columns;
            for i in 1..columns.len() {
                let (low, height) = columns[i - 1];
                let (l, h) = columns[i];
                let l = l.clamp(low - h + 1, low + height - 1);
                columns[i] = (l, h);
            }
            let w = small_window();
            let mut polygon = comb(&columns);
            if clockwise {
                polygon.reverse();
            }
            let n = polygon.len();
            polygon.rotate_left(turn % n);
            let pieces = check(&w, &polygon)?;
            let (parts, cells) = parts(&columns, 6, 5);
            prop_assert_eq!(pieces.len(), parts, "{:?}", &pieces);
            let sign = if clockwise { -1 } else { 1 };
            let mut sum = int(0);
            for piece in &pieces {
                prop_assert!(area(piece) * int(sign) > int(0));
                sum += area(piece);
            }
            prop_assert_eq!(sum, int(2 * sign * cells as i64));
        }

        #[test]
        fn points_keep_their_winding_number(polygon in oracle::grid_polygon()) {
            let w = small_window();
            let pieces = check(&w, &polygon)?;
            for p in oracle::samples() {
                let Some(expected) = winding(&polygon, p) else { continue };
                let sum: i64 = pieces.iter().map(|piece| winding(piece, p).unwrap()).sum();
                prop_assert_eq!(sum, expected, "{} {:?}", p, &pieces);
            }
        }

        #[test]
        fn the_area_is_that_of_one_outline(polygon in oracle::polygon()) {
            let w = small_window();
            let pieces = check(&w, &polygon)?;
            let one = area(&crate::sutherland_hodgman::clip_polygon(&w, &polygon));
            let sum: oracle::R = pieces.iter().map(|piece| area(piece)).sum();
            // Up to 4 crossings an edge, each off by half an ulp of 8 in x and y, times twice the window's size, twice.
            let bound = r(2.0 * 14.0 * 4.0 * f64::EPSILON * 4.0 * 2.0 * 12.0);
            prop_assert!(absolute(one - sum) <= bound);
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 24), n in 0usize..11) {
            let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
            let (polygon, corners) = p.split_at(n.min(10));
            for w in [
                Window { min: corners[0], max: corners[1] },
                Window { min: corners[0].min(corners[1]), max: corners[0].max(corners[1]) },
                lecture(),
            ] {
                for piece in clip_polygon(&w, polygon) {
                    prop_assert!(piece.iter().all(|&p| w.contains(p)));
                }
            }
        }
    }
}
