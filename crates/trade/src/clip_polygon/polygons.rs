//! Polygons that cross a window's border often, and the exact area that they have in it.

use core::f64::consts::TAU;

use ombra_clip::Window;
use ombra_math::glam::{DVec2, Vec2};
use ombra_oracle::Exact;
use ombra_oracle::vector::{doubled_area, exact};

use crate::clipping::{WINDOW, middle, size};
use crate::deviation::{Deviation, Verdict};
use crate::random::Random;

/// Where quotients are cut off.
const BITS: u32 = 300;

/// A window and polygons that turn counter-clockwise (y up).
pub struct WindowAndPolygons {
    pub window: Window,
    pub polygons: Vec<Vec<DVec2>>,
    polygons_f32: Vec<Vec<Vec2>>,
    /// Each polygon's area in the window; `None` if a number is not finite.
    areas: Vec<Option<Exact>>,
}

impl WindowAndPolygons {
    /// `number` polygons of `vertices` each round the middle of the window.
    pub fn stars(vertices: usize, number: usize) -> Self {
        let mut random = Random::new(1974);
        let middle = middle();
        let star = |_| {
            let corner = |i: usize| {
                let angle = TAU * (i as f64 + random.between(0.0, 0.3)) / vertices as f64;
                let radius = random.between(1.0, 9.0);
                middle + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
            };
            (0..vertices).map(corner).collect()
        };
        Self::new((0..number).map(star).collect())
    }

    /// Stars with every other vertex up to `distance` times the window's size away.
    pub fn far_stars(distance: f64, vertices: usize, number: usize) -> Self {
        let mut random = Random::new(1984);
        let middle = middle();
        let size = size();
        let star = |_| {
            let corner = |i: usize| {
                let angle = TAU * (i as f64 + random.between(0.0, 0.3)) / vertices as f64;
                let radius = match i % 2 {
                    0 => random.between(1.0, 4.0),
                    _ => random.between(0.5, 1.0) * distance * size,
                };
                middle + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
            };
            (0..vertices).map(corner).collect()
        };
        Self::new((0..number).map(star).collect())
    }

    /// `number` combs of `vertices` each, four a tooth.
    pub fn combs(vertices: usize, number: usize) -> Self {
        let mut random = Random::new(1977);
        let size = WINDOW.max - WINDOW.min;
        let teeth = vertices / 4;
        // In shares of the window: a tenth of its width more on either side, and a back one height below it.
        let width = 1.2 / teeth as f64;
        let comb = |_| {
            let tooth = |i: usize| {
                // From the right to the left, with the inside on the left of who walks.
                let left = 1.1 - width * (i + 1) as f64;
                let mut at = |low: f64, high: f64| left + width * random.between(low, high);
                let (right, left) = ([at(0.7, 0.9), at(0.7, 0.9)], [at(0.1, 0.3), at(0.1, 0.3)]);
                let mut valley = || random.between(-0.5, -0.1);
                let base = [
                    if i == 0 { -1.0 } else { valley() },
                    if i + 1 == teeth { -1.0 } else { valley() },
                ];
                let mut top = || random.between(0.2, 1.3);
                [
                    DVec2::new(right[0], base[0]),
                    DVec2::new(right[1], top()),
                    DVec2::new(left[1], top()),
                    DVec2::new(left[0], base[1]),
                ]
            };
            (0..teeth)
                .flat_map(tooth)
                .map(|share| WINDOW.min + size * share)
                .collect()
        };
        Self::new((0..number).map(comb).collect())
    }

    fn new(polygons: Vec<Vec<DVec2>>) -> Self {
        let rounded = |polygon: &Vec<DVec2>| polygon.iter().map(|p| p.as_vec2()).collect();
        Self {
            window: WINDOW,
            polygons_f32: polygons.iter().map(rounded).collect(),
            areas: polygons
                .iter()
                .map(|polygon| area_inside(&WINDOW, polygon))
                .collect(),
            polygons,
        }
    }

    /// One answer a polygon.
    pub fn each<A>(&self, mut clip: impl FnMut(&[DVec2]) -> A) -> Vec<A> {
        self.polygons.iter().map(|polygon| clip(polygon)).collect()
    }

    /// One answer a polygon in f32.
    pub fn each_f32<A>(&self, mut clip: impl FnMut(&[Vec2]) -> A) -> Vec<A> {
        self.polygons_f32
            .iter()
            .map(|polygon| clip(polygon))
            .collect()
    }

    /// The errors of areas, of one outline a polygon.
    pub fn verdict(&self, outlines: &[Vec<DVec2>]) -> Verdict {
        let outside = |p: &&DVec2| !WINDOW.contains(**p);
        verdict(
            self.errors(outlines.iter().map(|outline| area(outline))),
            outlines.iter().flatten().filter(outside).count(),
        )
    }

    /// The errors of areas, of one outline in f32 a polygon.
    pub fn verdict_f32(&self, outlines: &[Vec<Vec2>]) -> Verdict {
        // Its window is in f32 too.
        let (min, max) = (WINDOW.min.as_vec2(), WINDOW.max.as_vec2());
        let outside = |p: &&Vec2| p.clamp(min, max) != **p;
        let in_f64 = |outline: &Vec<Vec2>| outline.iter().map(|p| p.as_dvec2()).collect::<Vec<_>>();
        verdict(
            self.errors(outlines.iter().map(|outline| area(&in_f64(outline)))),
            outlines.iter().flatten().filter(outside).count(),
        )
    }

    /// The errors of areas, of several outlines a polygon.
    pub fn verdict_of_pieces(&self, pieces: &[Vec<Vec<DVec2>>]) -> Verdict {
        let areas = pieces.iter().map(|pieces| {
            let areas: Option<Vec<Exact>> = pieces.iter().map(|piece| area(piece)).collect();
            Some(areas?.iter().sum())
        });
        let outside = |p: &&DVec2| !WINDOW.contains(**p);
        verdict(
            self.errors(areas),
            pieces.iter().flatten().flatten().filter(outside).count(),
        )
    }

    /// |area − A*| / A* of every polygon.
    fn errors(&self, areas: impl Iterator<Item = Option<Exact>>) -> Deviation {
        let answers = areas.chain(core::iter::repeat(None));
        Deviation::of(self.areas.iter().zip(answers).map(|(truth, answer)| {
            let truth = truth.as_ref()?;
            Some((answer? - truth).abs().ratio(truth))
        }))
    }
}

fn verdict(deviation: Deviation, outside: usize) -> Verdict {
    Verdict {
        deviation,
        faults: vec![("vertices outside", outside as u64)],
    }
}

/// The area of a polygon, counter-clockwise positive.
fn area(polygon: &[DVec2]) -> Option<Exact> {
    let polygon: Option<Vec<_>> = polygon.iter().map(|&p| exact(p)).collect();
    Some(doubled_area(&polygon?).scaled(-1))
}

/// The area that a polygon has in a window: below each edge, counted backwards.
fn area_inside(window: &Window, polygon: &[DVec2]) -> Option<Exact> {
    let next = polygon.iter().skip(1).chain(polygon.first());
    polygon
        .iter()
        .zip(next)
        .map(|(a, b)| {
            let forwards = a.x <= b.x;
            let (left, right) = if forwards { (a, b) } else { (b, a) };
            let below = area_below(window, *left, *right)?;
            Some(if forwards { -below } else { below })
        })
        .try_fold(Exact::ZERO, |sum, area| Some(sum + area?))
}

/// ∫ (clamp(y, y_min, y_max) − y_min) dx along an edge from left to right, as far as it is in [x_min, x_max].
fn area_below(window: &Window, left: DVec2, right: DVec2) -> Option<Exact> {
    let ([x0, y0], [x1, y1]) = (exact(left)?, exact(right)?);
    let ([low_x, low], [high_x, high]) = (exact(window.min)?, exact(window.max)?);
    let (from, to) = (x0.clone().max(low_x), x1.clone().min(high_x));
    if from >= to {
        return Some(Exact::ZERO);
    }
    let (dx, dy) = (x1 - &x0, y1 - &y0);
    let height = high - &low;
    if dy.is_zero() {
        let above = (y0 - low).max(Exact::ZERO).min(height);
        return Some(above * (to - from));
    }
    // Heights times dx, so that those at `from` and `to` are whole.
    let above_low = |x: &Exact| (&y0 - &low) * &dx + &dy * (x - &x0);
    let height = height * &dx;
    // Twice the integral of the clamped height over the height: 0, h², then a slope of twice the greatest.
    let twice = |h: Exact| {
        if h <= 0 {
            Exact::ZERO
        } else if h <= height {
            h.squared()
        } else {
            &height * (h.scaled(1) - &height)
        }
    };
    let difference = twice(above_low(&to)) - twice(above_low(&from));
    Some(difference.over(&(dx * dy.scaled(1)))?.truncated(BITS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::cmp::Ordering;
    use ombra_math::predicates::orient_2d;

    fn points(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn areas_by_hand() {
        let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
        let inside = |polygon: &[(f64, f64)]| {
            let polygon = points(polygon);
            area_inside(&window, &polygon).unwrap().nearest()
        };
        // A square half in, around, inside; turned round; beside.
        assert_eq!(
            inside(&[(5.0, 5.0), (15.0, 5.0), (15.0, 15.0), (5.0, 15.0)]),
            25.0
        );
        assert_eq!(
            inside(&[(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)]),
            100.0
        );
        assert_eq!(
            inside(&[(1.0, 1.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0)]),
            2.0
        );
        assert_eq!(
            inside(&[(1.0, 2.0), (3.0, 2.0), (3.0, 1.0), (1.0, 1.0)]),
            -2.0
        );
        assert_eq!(inside(&[(11.0, 1.0), (13.0, 1.0), (13.0, 2.0)]), 0.0);
        assert_eq!(inside(&[(1.0, 11.0), (3.0, 11.0), (3.0, 12.0)]), 0.0);
        // A triangle with its corner cut off above: 10·20/2 − 5·10/2.
        assert_eq!(inside(&[(0.0, 0.0), (10.0, 0.0), (5.0, 20.0)]), 75.0);
        // A diamond that looks out on all four sides: each corner cuts off a triangle of 2 · 4.
        let diamond = [(5.0, -2.0), (12.0, 5.0), (5.0, 12.0), (-2.0, 5.0)];
        assert_eq!(inside(&diamond), 98.0 - 4.0 * 4.0);
        // Thirds: (0, 0) (3, 1) (0, 1) cut at x = 0 … 10 is whole; moved left by 1, a third of a unit less a bit.
        assert_eq!(inside(&[(-1.0, 0.0), (2.0, 1.0), (-1.0, 1.0)]), 2.0 / 3.0);
        assert_eq!(inside(&[]), 0.0);
        assert_eq!(
            area_inside(&window, &[DVec2::NAN, DVec2::ZERO, DVec2::ONE]),
            None
        );
    }

    #[test]
    fn judging() {
        let scene = WindowAndPolygons::new(vec![points(&[
            (1.0, 1.0),
            (3.0, 1.0),
            (3.0, 2.0),
            (1.0, 2.0),
        ])]);
        let right = &scene.polygons;
        assert_eq!(scene.verdict(right).deviation.max, 0.0);
        let larger = points(&[(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0)]);
        assert_eq!(scene.verdict(&[larger]).deviation.max, 1.0);
        assert_eq!(scene.verdict(&[vec![]]).deviation.max, 1.0);
        assert_eq!(scene.verdict(&[]).deviation.missing, 1);
        // One vertex on the border, one the least beyond it.
        let (x, y) = (WINDOW.max.x, WINDOW.min.y);
        let beyond = points(&[(1.0, y), (x, y), (x.next_up(), 2.0)]);
        assert_eq!(scene.verdict(&[beyond]).faults, [("vertices outside", 1)]);
        let half = points(&[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]);
        let other = points(&[(2.0, 1.0), (3.0, 1.0), (3.0, 2.0), (2.0, 2.0)]);
        assert_eq!(
            scene
                .verdict_of_pieces(&[vec![half.clone(), other]])
                .deviation
                .max,
            0.0
        );
        assert_eq!(scene.verdict_of_pieces(&[vec![half]]).deviation.max, 0.5);
    }

    /// No two edges that are not neighbours meet.
    fn is_simple(polygon: &[DVec2]) -> bool {
        let n = polygon.len();
        let edge = |i: usize| (polygon[i], polygon[(i + 1) % n]);
        let crosses = |(a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)| {
            let turn = |p, q, r| orient_2d(p, q, r).unwrap_or(Ordering::Equal);
            turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b)
        };
        (0..n).all(|i| {
            (i + 2..n)
                .filter(|&j| (j + 1) % n != i)
                .all(|j| !crosses(edge(i), edge(j)))
        })
    }

    #[test]
    fn polygons_are_simple_and_cross_the_border() {
        for vertices in [4, 16, 256] {
            let far = WindowAndPolygons::far_stars(1e6, vertices, 3);
            for scene in [
                WindowAndPolygons::stars(vertices, 3),
                WindowAndPolygons::combs(vertices, 3),
                far,
            ] {
                for (polygon, inside) in scene.polygons.iter().zip(&scene.areas) {
                    assert_eq!(polygon.len(), vertices);
                    assert!(is_simple(polygon));
                    let (whole, inside) = (area(polygon).unwrap(), inside.clone().unwrap());
                    assert!(inside > 1 && inside < whole);
                    assert!(polygon.iter().any(|&p| !WINDOW.contains(p)));
                }
            }
        }
    }
}
