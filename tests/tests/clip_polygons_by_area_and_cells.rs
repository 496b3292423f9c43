//! Clipped polygons: their areas, from an integral of the boundary, its x clamped to the window, which knows of no clipping;
//! the pieces of outlines along a grid, from flooding its cells.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};

use ombra_clip::{Window, pieces, sutherland_hodgman};
use ombra_math::glam::DVec2;
use ombra_oracle::Exact;
use ombra_tests::cases::Random;
use ombra_tests::clipping::{doubled_area, edges};

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// Each point of the window counted as often as the polygon runs round it: the sum over the edges, from bottom to top of
/// the window, of ∫ (x(y) clamped to the window − x_min) dy.
fn wound_area(window: &Window, polygon: &[DVec2]) -> Exact {
    let [left, right, low, high] =
        [window.min.x, window.max.x, window.min.y, window.max.y].map(exact);
    let mut sum = Exact::ZERO;
    for (a, b) in edges(polygon).filter(|(a, b)| a.y != b.y) {
        let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(exact);
        let x = |y: &Exact| &ax + ((&bx - &ax) * (y - &ay)).over(&(&by - &ay)).unwrap();
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
                let y = &ay + ((side - &ax) * (&by - &ay)).over(&(&bx - &ax)).unwrap();
                if bottom < y && y < top {
                    heights.push(y);
                }
            }
        }
        heights.sort();
        for (from, to) in heights.iter().zip(heights.iter().skip(1)) {
            // Linear between these heights, or constant: the middle is the mean.
            let middle = x(&(from + to).scaled(-1)).clamp(left.clone(), right.clone());
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

fn area(polygon: &[DVec2]) -> Exact {
    doubled_area(polygon).unwrap().scaled(-1)
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
        let together = parts.iter().map(|part| area(part)).sum();
        for found in [area(&outline), together] {
            assert!((found - &expected).abs() <= bound, "{window:?} {polygon:?}");
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
