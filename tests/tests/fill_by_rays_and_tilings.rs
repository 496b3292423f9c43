//! Filled polygons by a ray upwards, where the crate looks to the left, and triangles by tilings of the whole picture.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};

use ombra_math::glam::DVec2;
use ombra_oracle::{Exact, vector};
use ombra_raster::polygon::{Edge, FillRule, fill};
use ombra_raster::span::Span;
use ombra_raster::triangle::cover;
use ombra_tests::cases::{Random, point_near_grid};
use ombra_tests::clipping::edges;
use ombra_tests::halfway::is_nearest;

/// (b − a) × (p − a).
fn turn(a: DVec2, b: DVec2, p: DVec2) -> Exact {
    let [a, b, p] = [a, b, p].map(|p| vector::exact(p).unwrap());
    vector::turn(&a, &b, &p)
}

/// How often the contours run round `p`, moved to (x + δ, y + δ²): by the edges that a ray towards smaller y crosses,
/// with the sign that an edge running down gives to its right.
fn winding(contours: &[Vec<DVec2>], p: DVec2) -> i64 {
    let mut sum = 0;
    for (a, b) in contours.iter().flat_map(|c| edges(c)) {
        let rightwards = b.x > p.x;
        if (a.x > p.x) == rightwards {
            continue;
        }
        // Moving p adds −(b.y − a.y) δ + (b.x − a.x) δ² to the turn.
        let side = match (turn(a, b, p).sign() as i32, a.y.total_cmp(&b.y) as i32) {
            (0, 0) => {
                if rightwards {
                    1
                } else {
                    -1
                }
            }
            (0, falls) => falls,
            (side, _) => side,
        };
        if rightwards && side > 0 {
            sum -= 1;
        } else if !rightwards && side < 0 {
            sum += 1;
        }
    }
    sum
}

fn centre(x: u32, y: u32) -> DVec2 {
    DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)
}

fn raster(spans: impl Iterator<Item = Span>) -> BTreeSet<(u32, u32)> {
    spans
        .flat_map(|s| s.pixels().map(|p| (p.x, p.y)).collect::<Vec<_>>())
        .collect()
}

/// Fill by both rules: the pixels whose centres the contours run round, edges through centres, shared edges, spikes and
/// vertices of any size among them. Edges by themselves: the crossing is the nearest double, its column the first centre
/// not left of it.
#[test]
fn filled_pixels_by_a_ray_upwards() {
    let mut random = Random::new(301);
    let mut inside = 0;
    for _ in 0..1200 {
        let kind = random.below(5);
        let mut contours: Vec<Vec<DVec2>> = (0..1 + random.below(2))
            .map(|_| {
                (0..random.below(8))
                    .map(|_| point_near_grid(&mut random, kind))
                    .collect()
            })
            .collect();
        // Back along an edge, and a second contour on the other side of it.
        if let Some(&[a, b, ..]) = contours.first().map(Vec::as_slice) {
            match random.below(4) {
                0 => contours[0].extend([a, b]),
                1 => contours.push(vec![b, a, point_near_grid(&mut random, kind)]),
                _ => {}
            }
        }
        let wound: BTreeMap<(u32, u32), i64> = (0..9)
            .flat_map(|y| (0..10).map(move |x| (x, y)))
            .map(|(x, y)| ((x, y), winding(&contours, centre(x, y))))
            .collect();
        for (rule, is_in) in [
            (FillRule::EvenOdd, (|w| w % 2 != 0) as fn(i64) -> bool),
            (FillRule::NonZero, |w| w != 0),
        ] {
            let expected: BTreeSet<(u32, u32)> = wound
                .iter()
                .filter(|(_, w)| is_in(**w))
                .map(|(p, _)| *p)
                .collect();
            let got = raster(fill(&contours, rule, 10, 9).unwrap());
            assert_eq!(got, expected, "{rule:?} {contours:?}");
            inside += got.len();
        }
        for (a, b) in contours.iter().flat_map(|c| edges(c)) {
            let Some(edge) = Edge::new(a, b, 9) else {
                continue;
            };
            let row = edge.rows.start;
            let [y, tx, ty, bx, by] = [
                centre(0, row).y,
                edge.top.x,
                edge.top.y,
                edge.bottom.x,
                edge.bottom.y,
            ]
            .map(|x| Exact::new(x).unwrap());
            let n = tx * (&by - &y) + bx * (&y - &ty);
            let crossing = n.over(&(by - ty)).unwrap();
            assert!(is_nearest(edge.x(row), &crossing), "{edge:?}");
            let first = (0..10).find(|&x| crossing <= centre(x, 0).x).unwrap_or(10);
            assert_eq!(edge.column(row, 10), first, "{edge:?}");
        }
    }
    assert!(inside > 10_000, "{inside}");
}

/// A plane cut into triangles at random points, whose edges often run through centres: each pixel has one owner.
#[test]
fn triangles_that_tile_own_each_pixel_once() {
    let mut random = Random::new(302);
    for case in 0..150 {
        // A grid of points, the inner ones moved by less than a quarter of its step: no triangle turns over.
        let step = [4.0, 3.0, 2.5][random.below(3) as usize];
        let mut grid = [[DVec2::ZERO; 6]; 6];
        for (j, row) in grid.iter_mut().enumerate() {
            for (i, p) in row.iter_mut().enumerate() {
                let mut moved = || match case % 3 {
                    0 => 0.0,
                    1 => 0.5 * (f64::from(random.below(3)) - 1.0),
                    _ => random.between(-0.6, 0.6),
                };
                *p = DVec2::new(i as f64 * step + moved(), j as f64 * step + moved());
            }
        }
        let far = [
            DVec2::splat(-1e9),
            DVec2::new(1e9, -1e9),
            DVec2::splat(1e9),
            DVec2::new(-1e9, 1e9),
        ];
        let mut owners: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut own = |a, b, c| {
            let turned = if random.below(2) == 0 {
                [a, b, c]
            } else {
                [c, b, a]
            };
            for p in raster(cover(turned, 16, 16).unwrap()) {
                *owners.entry(p).or_default() += 1;
            }
        };
        for (j, i) in (0..5).flat_map(|j| (0..5).map(move |i| (j, i))) {
            let [a, b, c, d] = [
                grid[j][i],
                grid[j][i + 1],
                grid[j + 1][i + 1],
                grid[j + 1][i],
            ];
            own(a, b, c);
            own(a, c, d);
        }
        // Around the grid out to far corners: the rest of the picture.
        let border: Vec<DVec2> = (0..5)
            .map(|i| grid[0][i])
            .chain((0..5).map(|j| grid[j][5]))
            .chain((0..5).map(|i| grid[5][5 - i]))
            .chain((0..5).map(|j| grid[5 - j][0]))
            .collect();
        for (k, (a, b)) in edges(&border).enumerate() {
            own(a, b, far[k / 5]);
            if k % 5 == 4 {
                own(b, far[k / 5], far[(k / 5 + 1) % 4]);
            }
        }
        assert!(
            owners.len() == 256 && owners.values().all(|&n| n == 1),
            "{grid:?} {owners:?}"
        );
    }
}
