//! Clipped polygons and attributes a second time, from the documentation alone.
//!
//! Areas come from an integral of the boundary, its x clamped to the window, which knows of no clipping; the pieces of
//! outlines along a grid, from flooding its cells; cracks between clipped triangles are found by an attribute that is 0 on
//! the shared edge alone. All in fractions.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_rational::BigRational;
use ombra_clip::homogeneous::{Vertex, clip_polygon, contains};
use ombra_clip::{Window, pieces, sutherland_hodgman};
use ombra_math::glam::{DVec2, DVec4};
use ombra_raster::attributes::{linear, perspective, weights};
use ombra_raster::triangle::snap;
use ombra_tests::cases::Random;

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn zero() -> BigRational {
    exact(0.0)
}

fn size(x: BigRational) -> BigRational {
    if x < zero() { -x } else { x }
}

fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    polygon
        .iter()
        .copied()
        .zip(polygon.iter().copied().cycle().skip(1))
}

/// Each point of the window counted as often as the polygon runs round it: the sum over the edges, from bottom to top of
/// the window, of ∫ (x(y) clamped to the window − x_min) dy.
fn wound_area(window: &Window, polygon: &[DVec2]) -> BigRational {
    let [left, right, low, high] =
        [window.min.x, window.max.x, window.min.y, window.max.y].map(exact);
    let mut sum = zero();
    for (a, b) in edges(polygon).filter(|(a, b)| a.y != b.y) {
        let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(exact);
        let x = |y: &BigRational| &ax + (&bx - &ax) * (y - &ay) / (&by - &ay);
        let mut heights = vec![
            ay.clone().clamp(low.clone(), high.clone()),
            by.clone().clamp(low.clone(), high.clone()),
        ];
        let (bottom, top) = (
            heights[0].clone().min(heights[1].clone()),
            heights[0].clone().max(heights[1].clone()),
        );
        if ax != bx {
            for side in [&left, &right] {
                let y = &ay + (side - &ax) * (&by - &ay) / (&bx - &ax);
                if bottom < y && y < top {
                    heights.push(y);
                }
            }
        }
        heights.sort();
        for (from, to) in heights.iter().zip(heights.iter().skip(1)) {
            // Linear between these heights, or constant: the middle is the mean.
            let middle = x(&((from + to) * exact(0.5))).clamp(left.clone(), right.clone());
            let strip = (middle - &left) * (to - from);
            if b.y > a.y {
                sum += strip
            } else {
                sum -= strip
            }
        }
    }
    sum
}

fn area(polygon: &[DVec2]) -> BigRational {
    let doubled = edges(polygon).fold(zero(), |sum, (a, b)| {
        sum + exact(a.x) * exact(b.y) - exact(a.y) * exact(b.x)
    });
    doubled * exact(0.5)
}

/// Any closed chain, crossing itself or not, on the window's grid, next to it or anywhere near: outline and pieces have
/// the area that the boundary has by its integral. New vertices move by half an ulp of a number below 8, 2⁻⁵¹, along a
/// side no longer than 8; two for each edge.
#[test]
fn areas_by_the_clamped_boundary() {
    let mut random = Random::new(311);
    let windows = [
        (0.0, 0.0, 8.0, 8.0),
        (-0.0, 3.0, 5.0, 3.5),
        (1.0 / 3.0, 0.1, 7.7, 6.0),
    ]
    .map(|(a, b, c, d)| Window::new(DVec2::new(a, b), DVec2::new(c, d)).unwrap());
    let mut several = 0;
    for case in 0..1500 {
        let window = &windows[case % 3];
        let kind = random.below(4);
        let mut one = || {
            let grid = f64::from(random.below(17)) - 4.0;
            match kind {
                0 => grid,
                1 => grid * 0.5 + 2.0,
                2 => grid + grid * random.exponential(-52, -41),
                _ => random.between(-4.0, 12.0),
            }
        };
        let polygon: Vec<DVec2> = (0..2 + case % 11)
            .map(|_| DVec2::new(one(), one()))
            .collect();
        let expected = wound_area(window, &polygon);
        let bound = exact(f64::EPSILON * 2.0 * 8.0 * 2.0 * polygon.len() as f64);
        let outline = sutherland_hodgman::clip_polygon(window, &polygon);
        let parts = pieces::clip_polygon(window, &polygon);
        several += usize::from(parts.len() > 1);
        let together = parts.iter().fold(zero(), |sum, part| sum + area(part));
        for found in [area(&outline), together] {
            assert!(size(found - &expected) <= bound, "{window:?} {polygon:?}");
        }
    }
    assert!(several > 200, "{several}");
}

type Cell = (i32, i32);

const AROUND: [Cell; 8] = [
    (1, 0),
    (1, 1),
    (0, 1),
    (-1, 1),
    (-1, 0),
    (-1, -1),
    (0, -1),
    (1, -1),
];

/// Cells that hang together, grown one by one where the new cell meets the others in one run of its eight neighbours: no
/// hole appears, and no two cells meet in a corner alone.
fn grown(random: &mut Random, side: i32, cells: usize) -> BTreeSet<Cell> {
    let mut shape = BTreeSet::from([(side / 2, side / 2)]);
    for _ in 0..40 * cells {
        if shape.len() == cells {
            break;
        }
        let &(x, y) = shape
            .iter()
            .nth(random.below(shape.len() as u32) as usize)
            .unwrap();
        let (dx, dy) = AROUND[2 * random.below(4) as usize];
        let (x, y) = (x + dx, y + dy);
        let near = AROUND.map(|(dx, dy)| shape.contains(&(x + dx, y + dy)));
        let runs = (0..8).filter(|&k| near[k] && !near[(k + 1) % 8]).count();
        // Few neighbours: thin arms, which windows cut into many pieces.
        let thin = near.iter().filter(|&&taken| taken).count() <= 3;
        let free = (0..side).contains(&x) && (0..side).contains(&y) && !shape.contains(&(x, y));
        if free && runs == 1 && (thin || random.below(8) == 0) {
            shape.insert((x, y));
        }
    }
    shape
}

/// The outline of such a shape, counter-clockwise, its straight runs in unit steps.
fn outline_of(shape: &BTreeSet<Cell>) -> Vec<DVec2> {
    let mut next = BTreeMap::new();
    for &(x, y) in shape {
        let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
        for (k, (dx, dy)) in [(0, -1), (1, 0), (0, 1), (-1, 0)].into_iter().enumerate() {
            if !shape.contains(&(x + dx, y + dy)) {
                assert_eq!(next.insert(corners[k], corners[(k + 1) % 4]), None);
            }
        }
    }
    let (&start, _) = next.first_key_value().unwrap();
    let mut at = start;
    let mut outline = Vec::new();
    while let Some(to) = next.remove(&at) {
        outline.push(DVec2::new(at.0.into(), at.1.into()));
        at = to;
    }
    assert!(next.is_empty() && at == start);
    outline
}

/// The parts of a shape in the cells from `min` to below `max`, each all that hangs together by sides.
fn flooded(shape: &BTreeSet<Cell>) -> BTreeSet<Vec<Cell>> {
    let mut left = shape.clone();
    let mut parts = BTreeSet::new();
    while let Some(first) = left.pop_first() {
        let (mut part, mut to_visit) = (vec![first], vec![first]);
        while let Some((x, y)) = to_visit.pop() {
            for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
                if let Some(cell) = left.take(&(x + dx, y + dy)) {
                    part.push(cell);
                    to_visit.push(cell);
                }
            }
        }
        part.sort_unstable();
        parts.insert(part);
    }
    parts
}

/// Outlines along a grid, the window's sides on the grid, so that most of a piece's border is along them, or midway: the
/// pieces are the parts that flooding finds, each once, turning as the outline does, no vertex twice and no bit of an
/// edge twice: no bridges.
#[test]
fn pieces_by_flooding_cells() {
    let mut random = Random::new(312);
    let (mut several, mut most) = (0, 0);
    for _ in 0..1500 {
        let cells = 20 + random.below(60) as usize;
        let shape = grown(&mut random, 14, cells);
        let mut outline = outline_of(&shape);
        let clockwise = random.below(2) == 0;
        if clockwise {
            outline.reverse();
        }
        let start = random.below(outline.len() as u32) as usize;
        outline.rotate_left(start);

        // In halves of a cell; even ones are sides of cells.
        let coarse = 1 + random.below(2) as i32;
        let mut half = || coarse * (random.below(32 / coarse as u32) as i32) - 2;
        let [(x0, x1), (y0, y1)] = [0, 1].map(|_| {
            let (p, q) = (half(), half());
            (p.min(q), p.max(q) + coarse)
        });
        let corner = |x: i32, y: i32| DVec2::new(x.into(), y.into()) * 0.5;
        let window = Window::new(corner(x0, y0), corner(x1, y1)).unwrap();
        let inside: BTreeSet<Cell> = (x0..x1)
            .flat_map(|x| (y0..y1).map(move |y| (x, y)))
            .filter(|(x, y)| shape.contains(&(x.div_euclid(2), y.div_euclid(2))))
            .collect();
        let expected = flooded(&inside);

        let parts = pieces::clip_polygon(&window, &outline);
        let mut found = BTreeSet::new();
        for part in &parts {
            let mut steps = BTreeSet::new();
            let mut turns: BTreeMap<Cell, i32> = BTreeMap::new();
            for (a, b) in edges(part) {
                let [a, b] = [a, b].map(|p| (p * 2.0).as_ivec2());
                let d = (b - a).signum();
                assert!((d.x == 0) != (d.y == 0), "{window:?} {outline:?} {part:?}");
                for k in 0..(b - a).abs().max_element() {
                    let middle = 2 * (a + d * k) + d;
                    assert!(
                        steps.insert(middle.to_array()),
                        "{window:?} {outline:?} {part:?}"
                    );
                    // A ray to the left from each cell of this row, right of the step.
                    for x in (x0..x1).filter(|&x| d.y != 0 && x >= a.x) {
                        *turns.entry((x, middle.y.div_euclid(2))).or_default() += d.y;
                    }
                }
            }
            let distinct: BTreeSet<[i32; 2]> = part
                .iter()
                .map(|p| (*p * 2.0).as_ivec2().to_array())
                .collect();
            assert_eq!(
                distinct.len(),
                part.len(),
                "{window:?} {outline:?} {part:?}"
            );
            turns.retain(|_, &mut n| n != 0);
            // The outline's inside lies on its left: right of a step up, nothing; right of a step down, once.
            assert!(
                turns.values().all(|&n| n == if clockwise { 1 } else { -1 }),
                "{window:?} {outline:?}"
            );
            assert!(
                found.insert(turns.into_keys().collect::<Vec<_>>()),
                "{window:?} {outline:?}"
            );
        }
        assert_eq!(found, expected, "{window:?} {outline:?}");
        several += usize::from(parts.len() > 1);
        most = most.max(parts.len());
    }
    assert!(several > 200 && most > 4, "{several} {most}");
}

/// Two triangles on either side of an edge, in the view volume: an attribute that is 0 at the edge's ends and 1 at the
/// third corner is 0 at the vertices on what is left of the edge, and these are the same in both, bit for bit.
#[test]
fn no_cracks_along_a_shared_edge() {
    let mut random = Random::new(313);
    let mut seams = 0;
    for _ in 0..20_000 {
        let whole = random.below(2) == 0;
        let mut corner = || {
            let mut p = DVec4::from_array([0; 4].map(|_| random.between(-2.0, 2.0)));
            if whole {
                p = p.round();
            }
            p.w += 0.5;
            p
        };
        let [p, q, r, s] = [0; 4].map(|_| corner());
        let seam = |triangle: [(DVec4, f64); 3]| -> Option<BTreeSet<[u64; 4]>> {
            let triangle = triangle.map(|(position, off)| Vertex {
                position,
                attributes: [off],
            });
            let inside = clip_polygon(&triangle);
            assert!(
                inside
                    .iter()
                    .all(|v| contains(v.position) && v.position.w > 0.0),
                "{triangle:?}"
            );
            let on_edge = inside.iter().filter(|v| v.attributes == [0.0]);
            (!inside.is_empty()).then(|| {
                on_edge
                    .map(|v| v.position.to_array().map(f64::to_bits))
                    .collect()
            })
        };
        let one = seam([(p, 0.0), (q, 0.0), (r, 1.0)]);
        let other = seam([(q, 0.0), (p, 0.0), (s, 1.0)]);
        if let (Some(one), Some(other)) = (one, other) {
            assert_eq!(one, other, "{p} {q} {r} {s}");
            seams += usize::from(one.len() == 2);
        }
    }
    assert!(seams > 1000, "{seams}");
}

/// Weights, slivers among them: their signs and the bounds that are stated, 64ε of each; 67ε of Σ|λa| for the linear
/// attribute; 140ε of the largest |a| for the one in perspective.
#[test]
fn stated_errors_of_attributes() {
    let mut random = Random::new(314);
    let epsilon = |k: f64| exact(k * f64::EPSILON);
    let mut slivers = 0;
    for case in 0..3000 {
        let mut place = || DVec2::new(random.between(0.0, 20.0), random.between(0.0, 20.0));
        let [a, b, mut c] = [place(), place(), place()];
        if case % 3 == 0 {
            c = a + (b - a) * random.between(0.0, 1.0);
        }
        let share = random.between(0.0, 1.0);
        let p = match case % 4 {
            0 => a + (b - a) * share,
            1 => (a + b + c) / 3.0,
            _ => DVec2::new(
                f64::from(random.below(20)) + 0.5,
                f64::from(random.below(20)) + 0.5,
            ),
        };
        let doubled = |a: DVec2, b: DVec2, p: DVec2| {
            let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, p.x, p.y].map(exact);
            (bx - &ax) * (py - &ay) - (by - ay) * (px - ax)
        };
        let whole = doubled(a, b, c);
        let Some(found) = weights([a, b, c], p) else {
            assert_eq!(whole, zero(), "{a} {b} {c}");
            continue;
        };
        slivers += usize::from(size(whole.clone()) < exact(1e-12));
        let λ = [doubled(b, c, p), doubled(c, a, p), doubled(a, b, p)].map(|e| e / &whole);
        for (found, λ) in found.to_array().into_iter().zip(&λ) {
            assert!(
                size(exact(found) - λ) <= epsilon(64.0) * size(λ.clone()),
                "{a} {b} {c} {p}"
            );
        }
        let values = [0; 3].map(|_| random.exponential(-20, 20));
        let w = [0; 3].map(|_| random.exponential(-40, 40).abs());
        let terms: Vec<BigRational> = λ.iter().zip(values).map(|(λ, a)| λ * exact(a)).collect();
        let scale = terms
            .iter()
            .cloned()
            .fold(zero(), |sum, term| sum + size(term));
        let sum = terms.iter().fold(zero(), |sum, term| sum + term);
        assert!(
            size(exact(linear(found, values)) - sum) <= epsilon(67.0) * scale,
            "{a} {b} {c} {p}"
        );
        if λ.iter().all(|λ| *λ >= zero()) {
            let over_w = |terms: &[BigRational]| {
                terms
                    .iter()
                    .zip(w)
                    .fold(zero(), |sum, (term, w)| sum + term / exact(w))
            };
            let off =
                size(exact(perspective(found, values, w).unwrap()) - over_w(&terms) / over_w(&λ));
            let largest = values.into_iter().fold(0.0, |m: f64, a| m.max(a.abs()));
            assert!(
                off <= epsilon(140.0) * exact(largest),
                "{a} {b} {c} {p} {w:?}"
            );
        }
    }
    assert!(slivers > 300, "{slivers}");
}

/// ⌊x 2ᵇ + ½⌋ / 2ᵇ in fractions, where adding the ½ in doubles would round: just below a half, and from 2⁵² on.
#[test]
fn snapped_vertices() {
    let mut random = Random::new(315);
    for case in 0..4000 {
        let bits = [0, 1, 4, 8, 31, 52, 53, 64, 200][case % 9];
        let step = BigRational::new(BigInt::from(1), BigInt::from(1) << bits);
        let half = (f64::from(random.below(41)) - 20.0) * 0.5;
        let x = match case % 5 {
            0 => 0.5_f64.next_down(),
            1 => half * random.power_of_two(-60, 0),
            2 => (half * random.power_of_two(-8, 0)).next_up(),
            3 => random.exponential(50, 54).round(),
            _ => random.exponential(-220, 70),
        };
        let expected = (exact(x) / &step + exact(0.5)).floor() * &step;
        assert_eq!(
            exact(snap(DVec2::new(x, 0.0), bits).x),
            expected,
            "{x:e}, {bits} bits"
        );
    }
}
