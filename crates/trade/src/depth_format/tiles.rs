//! Pairs of surfaces that lie almost on one another, a tile of the picture each.

use core::cmp::Ordering;

use ombra_hsr::picture::NOTHING;
use ombra_hsr::z_buffer::precision::depth_step;
use ombra_hsr::z_buffer::{Cull, DepthFormat};
use ombra_math::camera::Camera;
use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::Mesh;
use ombra_math::view::{Viewport, frustum};
use ombra_math::work::Count;
use ombra_oracle::Exact;
use ombra_oracle::vector::exact;
use ombra_raster::buffers::image::Luma;

use crate::deviation::{Deviation, Verdict};
use crate::hidden::{self, Answer};
use crate::random::Random;

/// Pixels along a tile.
const TILE: u32 = 8;
/// Gaps a decade.
const GAPS: u32 = 8;
/// The smallest gap over the distance is 10 to this power.
const SMALLEST: i32 = -8;
/// The greatest.
const GREATEST: i32 = 1;
/// Distances at the right side of a tile over those at the left.
const INCLINED: f64 = 1.05;
/// The far plane.
const FAR: f64 = 1000.0;

/// How the two surfaces of a tile lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Together {
    /// The second behind the first.
    Behind,
    /// The first is in front in the left half, the second in the right half.
    Crossing,
}

/// The distances of a surface at the left and the right side of its tile.
type Surface = [f64; 2];

/// What is seen at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pixel {
    /// The nearer surface, 0 or 1.
    nearer: u32,
    /// Distance of the nearer one.
    distance: f64,
    /// How far the other one is behind it.
    gap: f64,
}

/// All tiles, and what is seen of them.
pub struct Tiles {
    near: f64,
    camera: Camera,
    mesh: Mesh,
    /// 0 or 1 for each triangle.
    numbers: Vec<Luma<u32>>,
    /// `None` where both are equally far.
    truth: Vec<Option<Pixel>>,
    pairs: usize,
}

impl Tiles {
    /// `columns` distances from the near plane to the far one, at near / far = `ratio`.
    pub fn new(ratio: f64, columns: u32, together: Together) -> Self {
        let near = FAR * ratio;
        let rows = GAPS * (GREATEST - SMALLEST) as u32 + 1;
        let size = DVec2::new(f64::from(columns), f64::from(rows));
        let viewport = Viewport {
            width: columns * TILE,
            height: rows * TILE,
        };
        // With these planes there is a matrix.
        let projection = frustum(-near, near, -near, near, near, FAR).unwrap_or_default();
        let mut tiles = Self {
            near,
            camera: Camera {
                view_projection: projection,
                viewport,
            },
            mesh: Mesh::default(),
            numbers: Vec::new(),
            truth: Vec::new(),
            pairs: 0,
        };
        let mut random = Random::new(1974);
        for row in 0..rows {
            let gap = libm::exp10(f64::from(SMALLEST) + f64::from(row) / f64::from(GAPS));
            let mut across = Vec::new();
            for column in 0..columns {
                // All of it between the near and the far plane.
                let first = near
                    * if together == Together::Crossing {
                        1.0 + gap
                    } else {
                        1.0
                    };
                let last = FAR / (INCLINED * (1.0 + gap));
                let share = (f64::from(column) + random.unit()) / f64::from(columns);
                let distance = first * libm::pow(last / first, share);
                let pair = surfaces(distance, gap, together);
                if first < last {
                    let corner = DVec2::new(f64::from(column), f64::from(row));
                    let ndc = [corner, corner + 1.0]
                        .map(|p| (2.0 * p / size - 1.0) * DVec2::new(1.0, -1.0));
                    tiles.add(ndc, pair);
                }
                across.extend((0..TILE).map(|i| seen(pair, i).filter(|_| first < last)));
            }
            tiles.truth.extend(across.repeat(TILE as usize));
        }
        tiles
    }

    /// How many pairs of surfaces there are.
    pub fn number(&self) -> usize {
        self.pairs
    }

    /// How many pixels the picture has.
    pub fn pixels(&self) -> usize {
        self.truth.len()
    }

    /// Draws the second surface, and over it the first: of equal stored depths the second stays.
    fn add(&mut self, [low, high]: [DVec2; 2], [first, second]: [Surface; 2]) {
        for (number, [left, right]) in [(1, second), (0, first)] {
            let start = self.mesh.positions.len() as u32;
            let corners = [
                (low.x, low.y),
                (high.x, low.y),
                (high.x, high.y),
                (low.x, high.y),
            ];
            let distances = [left, right, right, left];
            let place = |((x, y), d): ((f64, f64), f64)| DVec3::new(x, y, -1.0) * d;
            self.mesh
                .positions
                .extend(corners.into_iter().zip(distances).map(place));
            self.mesh
                .triangles
                .extend([[start, start + 1, start + 2], [start, start + 2, start + 3]]);
            self.numbers.extend([Luma([number]); 2]);
        }
        self.pairs += 1;
    }

    /// The picture, 0 and 1 for the two surfaces.
    pub fn draw<F: DepthFormat>(&self, work: &mut impl Count) -> Answer {
        hidden::draw::<F>(&self.mesh, &self.camera, &self.numbers, Cull::Nothing, work)
    }

    /// What is drawn against what is seen.
    pub fn verdict<F: DepthFormat>(&self, answer: &Answer) -> Verdict {
        let shown = answer.as_ref().map(|picture| picture.as_raw().as_slice());
        let mut beyond = 0;
        let errors: Vec<Option<f64>> = self
            .truth
            .iter()
            .enumerate()
            .filter_map(|(i, truth)| {
                let truth = (*truth)?;
                let shown = shown.and_then(|shown| shown.get(i));
                let error = shown.map(|&shown| {
                    let Some(gap) = truth.not_told_apart(shown) else {
                        return 0.0;
                    };
                    beyond += u64::from(gap > self.formula::<F>(truth.distance, gap));
                    gap / truth.distance
                });
                Some(error)
            })
            .collect();
        Verdict {
            deviation: Deviation::of(errors),
            faults: vec![("wrong beyond the formula", beyond)],
        }
    }

    /// The gap that is certainly told apart. The step changes from the one surface to the other: the greater counts.
    fn formula<F: DepthFormat>(&self, distance: f64, gap: f64) -> f64 {
        let ends = [distance, distance + gap];
        let steps = ends.map(|z| depth_step::<F>(self.near, FAR, z.clamp(self.near, FAR)));
        steps.into_iter().flatten().fold(0.0, f64::max)
    }
}

impl Pixel {
    /// How far what is shown instead lies behind the nearer surface: the other one, or the far plane where nothing is
    /// shown. `None` where the picture is right.
    fn not_told_apart(self, shown: u32) -> Option<f64> {
        match shown {
            right if right == self.nearer => None,
            NOTHING => Some(FAR - self.distance),
            _ => Some(self.gap),
        }
    }
}

/// The two surfaces of a tile.
fn surfaces(distance: f64, gap: f64, together: Together) -> [Surface; 2] {
    let [left, right] = [distance, distance * INCLINED];
    let second = match together {
        Together::Behind => [left * (1.0 + gap), right * (1.0 + gap)],
        // The gap at both sides, in distance at the left.
        Together::Crossing => [left * (1.0 + gap), right / (1.0 + gap)],
    };
    [[left, right], second]
}

/// What is seen in column `i` of a tile: 1 / z is linear in the picture, so at share s = (2i + 1) / 2·8 from the left
///
/// ```text
/// 1 / z = (1 − s) / left + s / right
/// ```
fn seen([first, second]: [Surface; 2], i: u32) -> Option<Pixel> {
    let to_right = 2 * i + 1;
    let to_left = 2 * TILE - to_right;
    let inverse = |[left, right]: Surface| {
        let [l, r] = exact([left, right])?;
        let sum = Exact::from(to_left) * &r + Exact::from(to_right) * &l;
        Some((sum, l * r))
    };
    let ((a, p), (b, q)) = (inverse(first)?, inverse(second)?);
    let nearer = match (&a * &q).cmp(&(&b * &p)) {
        Ordering::Greater => 0,
        Ordering::Less => 1,
        Ordering::Equal => return None,
    };
    // z₁ = 16 p / a and z₂ = 16 q / b, and their difference, rounded once each.
    let whole = Exact::from(2 * TILE);
    let [z, y] = [(&p, &a), (&q, &b)].map(|(top, bottom)| (&whole * top).ratio(bottom));
    let difference = &p * &b - &q * &a;
    let gap = (&whole * difference).ratio(&(&a * &b)).abs();
    Some(Pixel {
        nearer,
        distance: z.min(y),
        gap,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_hsr::z_buffer::{Depth16, Depth24, Depth32F, ReversedDepth32F};

    #[test]
    fn what_is_seen_of_a_tile() {
        // Parallel to the picture: the nearer one is seen everywhere, the gap is everywhere the same.
        for i in 0..TILE {
            let pixel = seen([[2.0, 2.0], [3.0, 3.0]], i);
            let all = Pixel {
                nearer: 0,
                distance: 2.0,
                gap: 1.0,
            };
            assert_eq!(pixel, Some(all));
        }
        // From 2 to 4 and from 4 to 2: 1/z is linear, so they cross in the middle of the tile, at 8/3.
        let crossing = [[2.0, 4.0], [4.0, 2.0]];
        let nearer: Vec<_> = (0..TILE)
            .filter_map(|i| seen(crossing, i))
            .map(|p| p.nearer)
            .collect();
        assert_eq!(nearer, [0, 0, 0, 0, 1, 1, 1, 1]);
        // At share 1/16: 1/z = 15/32 + 1/64 = 31/64, and 15/64 + 1/32 = 17/64.
        let first = seen(crossing, 0).unwrap();
        assert_eq!(
            (first.distance, first.gap),
            (64.0 / 31.0, 64.0 / 17.0 - 64.0 / 31.0)
        );
        // Equally far everywhere, and in one column.
        assert_eq!(seen([[2.0, 4.0], [2.0, 4.0]], 3), None);
        let level = [[8.0, 8.0], [16.0 / 3.0, 16.0]];
        assert_eq!(
            (
                seen(level, 3).map(|p| p.nearer),
                seen(level, 4).map(|p| p.nearer)
            ),
            (Some(1), Some(0))
        );
    }

    #[test]
    fn what_is_shown_instead() {
        let pixel = Pixel {
            nearer: 1,
            distance: 400.0,
            gap: 0.5,
        };
        let gaps = [1, 0, NOTHING].map(|shown| pixel.not_told_apart(shown));
        assert_eq!(gaps, [None, Some(0.5), Some(600.0)]);
    }

    /// The greatest gap that was not told apart, over what the formula says at that place.
    fn greatest<F: DepthFormat>(ratio: f64, together: Together) -> f64 {
        let tiles = Tiles::new(ratio, 12, together);
        let picture = tiles.draw::<F>(&mut ()).unwrap();
        let shown = picture.as_raw().iter().zip(&tiles.truth);
        let ratios = shown.filter_map(|(&shown, truth)| {
            let truth = (*truth)?;
            let gap = truth.not_told_apart(shown)?;
            Some(gap / tiles.formula::<F>(truth.distance, gap))
        });
        ratios.fold(0.0, f64::max)
    }

    #[test]
    fn the_formula_is_the_border_between_told_apart_and_not() {
        for together in [Together::Behind, Together::Crossing] {
            for k in 1..=6 {
                let ratio = libm::exp10(f64::from(-k));
                let all = [
                    greatest::<Depth16>(ratio, together),
                    greatest::<Depth24>(ratio, together),
                    greatest::<Depth32F>(ratio, together),
                    greatest::<ReversedDepth32F>(ratio, together),
                ];
                // A step apart, two depths never round to one stored value; nearly a step apart, some of thousands of
                // pixels do, in all phases of rounding. Eight gaps a decade, so of one in 1.33 there is one.
                for greatest in all {
                    assert!(
                        (0.5..=1.0).contains(&greatest),
                        "{together:?} {ratio}: {all:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn every_pixel_but_those_beyond_the_far_plane_is_asked() {
        let tiles = Tiles::new(1e-3, 12, Together::Behind);
        let asked = tiles.truth.iter().flatten().count();
        assert_eq!(asked, tiles.number() * (TILE * TILE) as usize);
        let within = |pixel: &Pixel| {
            (1.0..=FAR).contains(&pixel.distance)
                && pixel.distance + pixel.gap <= FAR * (1.0 + f64::EPSILON)
        };
        assert!(tiles.truth.iter().flatten().all(within));
        assert!(tiles.truth.iter().flatten().all(|pixel| pixel.nearer == 0));
    }
}
