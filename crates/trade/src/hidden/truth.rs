//! What is seen at each pixel, in integers.
//!
//! A ray from the eye through the centre of every pixel, against the triangles about it; it shares nothing with any
//! method but the definition. Vertices are multiples of 2⁻¹⁶ below 2⁵, so integers below 2²¹; the eye is the origin,
//! and directions are integers up to the side of the picture, 2¹⁰ at most. No product reaches 2¹²⁷.

use core::ops::Range;

use ombra_hsr::picture::{IdBuffer, NOTHING};
use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;

use super::UNITS;
use crate::deviation::Deviation;

/// The number of the triangle seen at each pixel, or [`NOTHING`]; `None` where a centre is on an edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Truth {
    pixels: Vec<Option<u32>>,
}

/// A vector of integers.
type Vector = [i128; 3];

fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> i128 {
    ax * bx + ay * by + az * bz
}

/// Where a ray meets a triangle: t = top / bottom, with bottom > 0.
#[derive(Clone, Copy)]
struct Hit {
    top: i128,
    bottom: i128,
}

/// A ray against a triangle.
enum Meeting {
    Miss,
    Edge,
    Inside(Hit),
}

/// A triangle as the eye sees it.
struct Triangle {
    /// At right angles to the planes through the eye and each side: A × B, B × C, C × A.
    sides: [Vector; 3],
    /// n·A, with n = AB × AC, the sum of the three.
    level: i128,
}

impl Triangle {
    fn new(corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners.map(|p| [p.x, p.y, p.z].map(|x| (x * UNITS) as i128));
        let sides = [cross(a, b), cross(b, c), cross(c, a)];
        let normal = [0, 1, 2].map(|k| sides.iter().filter_map(|side| side.get(k)).sum());
        Self {
            sides,
            level: dot(normal, a),
        }
    }

    /// t D on the plane: t = n·A / n·D. The three products of D with the sides add up to n·D.
    fn meet(&self, direction: Vector) -> Meeting {
        let turns = self.sides.map(|side| dot(side, direction));
        let (low, high) = (turns.iter().min(), turns.iter().max());
        let (Some(&low), Some(&high)) = (low, high) else {
            return Meeting::Miss;
        };
        if low < 0 && high > 0 {
            return Meeting::Miss;
        }
        if turns.contains(&0) {
            return Meeting::Edge;
        }
        let sum: i128 = turns.iter().sum();
        Meeting::Inside(Hit {
            top: self.level * sum.signum(),
            bottom: sum.abs(),
        })
    }
}

/// The direction, times the side of the picture, of the ray through a pixel's centre.
fn direction(x: u32, y: u32, side: u32) -> Vector {
    let [x, y, side] = [x, y, side].map(i128::from);
    [2 * x + 1 - side, side - 2 * y - 1, -side]
}

impl Truth {
    /// Of a mesh in front of the eye.
    pub fn new(mesh: &Mesh, side: u32) -> Self {
        Self::cast(mesh, side, about)
    }

    /// Each triangle against the rays of the columns and rows that `reach` says.
    fn cast(mesh: &Mesh, side: u32, reach: fn([DVec3; 3], u32) -> [Range<u32>; 2]) -> Self {
        let mut nearest: Vec<(Option<u32>, Option<Hit>)> =
            vec![(Some(NOTHING), None); side as usize * side as usize];
        for (i, number) in (0..mesh.triangles.len()).zip(0..) {
            let Some(corners) = mesh.triangle(i) else {
                continue;
            };
            let triangle = Triangle::new(corners);
            let [columns, rows] = reach(corners, side);
            for y in rows {
                for x in columns.clone() {
                    let pixel = nearest.get_mut(y as usize * side as usize + x as usize);
                    let (Some(pixel), meeting) = (pixel, triangle.meet(direction(x, y, side)))
                    else {
                        continue;
                    };
                    match meeting {
                        Meeting::Miss => {}
                        Meeting::Edge => pixel.0 = None,
                        Meeting::Inside(hit) => {
                            // Both denominators are positive.
                            let is_nearer =
                                |best: Hit| hit.top * best.bottom < best.top * hit.bottom;
                            if pixel.1.is_none_or(is_nearer) {
                                *pixel = (pixel.0.map(|_| number), Some(hit));
                            }
                        }
                    }
                }
            }
        }
        let pixels = nearest.into_iter().map(|(number, _)| number).collect();
        Self { pixels }
    }

    /// The pixels of a picture against these; all are missing where there is no picture.
    pub fn deviation(&self, picture: Option<&IdBuffer>) -> Deviation {
        let shown = picture.map(|picture| picture.as_raw().as_slice());
        let error = |(i, truth): (usize, &Option<u32>)| {
            let truth = (*truth)?;
            let shown = shown.and_then(|shown| shown.get(i));
            Some(shown.map(|&shown| f64::from(u8::from(shown != truth))))
        };
        Deviation::of(self.pixels.iter().enumerate().filter_map(error))
    }
}

/// The pixels whose centres a triangle may hold, and one more on each side.
fn about(corners: [DVec3; 3], side: u32) -> [Range<u32>; 2] {
    let half = f64::from(side) / 2.0;
    // `as` takes what is beyond the picture to its rim.
    let range = |along: fn(DVec3) -> f64| {
        let places = corners.map(|p| half * (1.0 + along(p)));
        let low = places.into_iter().fold(f64::INFINITY, f64::min);
        let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max);
        (low - 1.5) as u32..((high + 1.5) as u32).min(side)
    };
    [range(|p| -p.x / p.z), range(|p| p.y / p.z)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hidden::TrianglesInView;
    use crate::random::Random;
    use ombra_hsr::image_space::cast_plain;

    fn mesh(triangles: &[[DVec3; 3]]) -> Mesh {
        let corners = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        Mesh::new(triangles.concat(), corners.collect()).unwrap()
    }

    #[test]
    fn two_triangles_in_a_picture_of_four_pixels() {
        // The nearer one holds the upper left half of the picture, the farther one all of it. The diagonal runs through
        // two centres; the other two are decided.
        let far = [(-9.0, -9.0), (30.0, -9.0), (-9.0, 30.0)].map(|(x, y)| DVec3::new(x, y, -8.0));
        let near = [(-4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)].map(|(x, y)| DVec3::new(x, y, -4.0));
        let truth = Truth::new(&mesh(&[near, far]), 2);
        assert_eq!(truth.pixels, [Some(0), None, None, Some(1)]);
        // The order of submission is none of depth.
        let truth = Truth::new(&mesh(&[far, near]), 2);
        assert_eq!(truth.pixels, [Some(1), None, None, Some(0)]);
        let truth = Truth::new(&mesh(&[near]), 2);
        assert_eq!(truth.pixels, [Some(0), None, None, Some(NOTHING)]);
    }

    fn random_mesh(seed: u64, count: usize) -> Mesh {
        let mut random = Random::new(seed);
        let mut corner = || {
            let distance = random.between(3.0, 15.0);
            let [x, y] = [(); 2].map(|()| distance * random.between(-1.2, 1.2));
            DVec3::new(x, y, -distance)
        };
        let triangles: Vec<_> = (0..count).map(|_| [corner(), corner(), corner()]).collect();
        mesh(&triangles)
    }

    #[test]
    fn triangles_reach_no_farther_than_their_boxes() {
        for seed in 0..8 {
            let mesh = random_mesh(seed, 12);
            let everywhere = |_, side| [0..side, 0..side];
            assert_eq!(Truth::new(&mesh, 48), Truth::cast(&mesh, 48, everywhere));
        }
    }

    #[test]
    fn agrees_with_the_other_exact_rays() {
        for seed in 8..12 {
            let scene = TrianglesInView::new(random_mesh(seed, 12), 48);
            let picture = cast_plain(&scene.polygons, &scene.camera, &mut ()).unwrap();
            let deviation = scene.truth.deviation(Some(&picture));
            assert_eq!((deviation.asked, deviation.wrong), (48 * 48, 0), "{seed}");
        }
    }

    #[test]
    fn pixels_are_counted_as_wrong_or_missing() {
        let truth = Truth {
            pixels: vec![Some(1), None, Some(NOTHING), Some(2)],
        };
        let picture = IdBuffer::from_raw(2, 2, vec![1, 7, 1, 2]);
        let deviation = truth.deviation(picture.as_ref());
        assert_eq!(
            (deviation.asked, deviation.missing, deviation.wrong),
            (3, 0, 1)
        );
        let deviation = truth.deviation(None);
        assert_eq!((deviation.asked, deviation.missing), (3, 3));
    }
}
