//! Faces with whole-number corners and viewers at whole-number places: what is in front of what is then integer arithmetic
//! that shares nothing with the crates.
//!
//! Corners are few and small, so that shared edges, common planes, equal depths, eyes in planes, on edges and at corners are
//! frequent.

use ombra_math::glam::{DVec3, DVec4};

use crate::cases::Random;

/// A point or vector of whole numbers.
pub type Whole = [i128; 3];

/// a − b.
#[must_use]
pub fn sub(a: Whole, b: Whole) -> Whole {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// a × b.
#[must_use]
pub fn cross(a: Whole, b: Whole) -> Whole {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

/// a·b.
#[must_use]
pub fn dot(a: Whole, b: Whole) -> i128 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn whole(random: &mut Random, range: u32) -> i128 {
    i128::from(random.below(2 * range + 1)) - i128::from(range)
}

/// Three whole numbers from −`range` to `range`.
pub fn corner(random: &mut Random, range: u32) -> Whole {
    [(); 3].map(|()| whole(random, range))
}

/// The same vector in doubles.
#[must_use]
pub fn double(v: Whole) -> DVec3 {
    DVec3::from(v.map(|x| x as f64))
}

/// The corners of a flat face.
#[derive(Clone, Debug)]
pub struct Face(pub Vec<Whole>);

impl Face {
    /// The sum of the cross products of its fan of triangles.
    pub fn normal(&self) -> Whole {
        let fan = (1..self.0.len() - 1).map(|i| [i, i + 1].map(|i| sub(self.0[i], self.0[0])));
        fan.fold([0; 3], |n, [a, b]| {
            let c = cross(a, b);
            [0, 1, 2].map(|k| n[k] + c[k])
        })
    }

    /// Its sides, each from one corner to the next.
    pub fn sides(&self) -> impl Iterator<Item = [Whole; 2]> {
        (0..self.0.len()).map(|i| [self.0[i], self.0[(i + 1) % self.0.len()]])
    }

    /// The same corners in doubles.
    pub fn doubles(&self) -> Vec<DVec3> {
        self.0.iter().copied().map(double).collect()
    }
}

/// A triangle, a box's side, or a hexagon laid out along two whole-number vectors; now and then made of the last one.
fn face(random: &mut Random, last: Option<&Face>) -> Face {
    loop {
        let [a, b, o] = [(); 3].map(|()| corner(random, 3));
        let along = |shape: &[(i128, i128)], a: Whole, b: Whole| {
            let place = |&(i, j): &(i128, i128)| [0, 1, 2].map(|k| o[k] + i * a[k] + j * b[k]);
            Face(shape.iter().map(place).collect())
        };
        let made = match (random.below(5), last) {
            (0, Some(last)) => Face(vec![last.0[0], last.0[1], o]),
            (1, Some(last)) => {
                let by = sub(last.0[1], last.0[0]);
                Face(
                    last.0
                        .iter()
                        .map(|v| [0, 1, 2].map(|k| v[k] + by[k]))
                        .collect(),
                )
            }
            (2, _) => {
                let axis = random.below(3) as usize;
                let [mut a, mut b] = [[0; 3]; 2];
                a[axis] = 1 + i128::from(random.below(4));
                b[(axis + 1) % 3] = 1 + i128::from(random.below(4));
                along(&[(0, 0), (1, 0), (1, 1), (0, 1)], a, b)
            }
            (3, _) => along(&[(0, 0), (2, 0), (3, 1), (3, 2), (1, 3), (0, 2)], a, b),
            _ => Face(vec![a, b, o]),
        };
        if made.normal() != [0; 3] {
            return made;
        }
    }
}

/// A viewer: a place, or the direction towards it.
#[derive(Clone, Copy, Debug)]
pub struct Viewer {
    /// Its place, or its direction.
    pub at: Whole,
    /// Whether it is a place.
    pub place: bool,
}

impl Viewer {
    /// Near the first face, in its plane, far away, or a direction.
    pub fn random(random: &mut Random, faces: &[Face]) -> Self {
        let near = faces.first().map(|face| [face.0[0], face.0[1]]);
        let (at, place) = match (random.below(6), near) {
            (0, Some([a, _])) => (a, true),
            (1, Some([a, b])) => ([0, 1, 2].map(|k| 2 * a[k] - b[k]), true),
            (2, _) => (corner(random, 3), true),
            (3, _) => (corner(random, 12), true),
            _ => (corner(random, 3), false),
        };
        if place || at != [0; 3] {
            Self { at, place }
        } else {
            Self {
                at: [1, 2, 3],
                place,
            }
        }
    }

    /// The homogeneous eye.
    pub fn eye(self) -> DVec4 {
        double(self.at).extend(if self.place { 1.0 } else { 0.0 })
    }

    /// On which side of a face's plane it is.
    pub fn side(self, face: &Face) -> i128 {
        let towards = if self.place {
            sub(self.at, face.0[0])
        } else {
            self.at
        };
        dot(face.normal(), towards).signum()
    }
}

/// At most `most` faces, and a viewer.
pub fn scene(random: &mut Random, most: u32) -> (Vec<Face>, Viewer) {
    let mut faces: Vec<Face> = vec![];
    for _ in 0..random.below(most + 1) {
        let next = face(random, faces.last());
        faces.push(next);
    }
    let viewer = Viewer::random(random, &faces);
    (faces, viewer)
}
