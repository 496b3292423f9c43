use super::*;
use crate::plane::Plane;
use crate::solids;
use ombra_oracle::Exact;
use proptest::prelude::*;

const EPS: f64 = f64::EPSILON;

/// Exercise math3: the corner's normal under each weighting.
#[test]
fn the_slide_cubes_corners() {
    let cube = solids::slide_cube();
    assert_eq!(
        cube.vertex_normals(Weighting::Plain)[0],
        DVec3::new(-1.0, -2.0, -2.0) / 3.0
    );
    // All triangles are alike, so area changes nothing.
    let by_area = cube.vertex_normals(Weighting::Area);
    assert!((by_area[0] - DVec3::new(-1.0, -2.0, -2.0) / 3.0).length() <= 4.0 * EPS);
    let middle = DVec3::new(5.0, 25.0, 5.0);
    for (n, p) in cube
        .vertex_normals(Weighting::Angle)
        .into_iter()
        .zip(&cube.positions)
    {
        let corner = (p - middle).signum() / 3f64.sqrt();
        assert!((n - corner).length() <= 4.0 * EPS, "{p}: {n}");
    }
}

#[test]
fn weights_are_what_they_say() {
    // At the origin: a face with normal +z, area a, right angle; one with normal +x, area b, angle of 45°.
    let (long, s) = (7.0, 3.0);
    let mesh = Mesh {
        positions: vec![
            DVec3::ZERO,
            DVec3::X * s,
            DVec3::Y * long,
            DVec3::Y * 5.0,
            DVec3::new(0.0, 5.0, 5.0),
        ],
        triangles: vec![[0, 1, 2], [0, 3, 4]],
    };
    for (weighting, z, x) in [
        (Weighting::Plain, 1.0, 1.0),
        (Weighting::Area, s * long / 2.0, 12.5),
        (Weighting::Angle, 2.0, 1.0),
    ] {
        let expected = DVec3::new(x, 0.0, z).normalize();
        for scale in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            let mut scaled = mesh.clone();
            scaled.positions.iter_mut().for_each(|p| *p *= scale);
            let n = scaled.vertex_normals(weighting)[0];
            // Scaling rounds each coordinate once.
            assert!(
                (n - expected).length() <= 8.0 * EPS,
                "{weighting:?} {scale}: {n}"
            );
        }
    }
}

const ALL: [Weighting; 3] = [Weighting::Plain, Weighting::Area, Weighting::Angle];

/// Normals with 300 bits, from the exact vector products.
mod oracle {
    use super::*;
    use crate::to_300_bits::{angle, q, quotient, root, trim};
    use ombra_oracle::vector::{cross, dot, exact, minus};

    /// Σ w n at the vertex 0 and Σ w.
    pub fn sums(mesh: &Mesh, weighting: Weighting) -> ([Exact; 3], Exact) {
        let (mut sum, mut size) = ([(); 3].map(|()| Exact::ZERO), Exact::ZERO);
        // A power of two changes no direction, and numbers of ordinary size are sooner worked with.
        let largest = mesh
            .positions
            .iter()
            .fold(0.0f64, |m, p| m.max(p.abs().max_element()));
        let unit = q(largest).exponent().unwrap_or(0);
        for (i, triangle) in mesh.triangles.iter().enumerate() {
            let Some(k) = triangle.iter().position(|&v| v == 0) else {
                continue;
            };
            let corners = mesh
                .triangle(i)
                .unwrap()
                .map(|p| exact(p).unwrap().map(|x| x.scaled(-unit)));
            let [a, b, c] = [0, 1, 2].map(|j| &corners[(k + j) % 3]);
            let [u, v] = [b, c].map(|p| minus(p, a));
            let n = cross(&u, &v);
            let length = root(&dot(&n, &n));
            if length.is_zero() {
                continue;
            }
            let weight = match weighting {
                Weighting::Plain => Exact::from(1),
                Weighting::Area => length.clone(),
                Weighting::Angle => angle(&length, &dot(&u, &v)),
            };
            for (sum, n) in sum.iter_mut().zip(&n) {
                *sum += trim(&quotient(&(n * &weight), &length));
            }
            size += weight;
        }
        (sum, size)
    }

    /// How far `found` is from the unit vector of `sum`, and Σ w / |Σ w n|.
    pub fn error(found: DVec3, (sum, size): &([Exact; 3], Exact)) -> (f64, f64) {
        let length = root(&dot(sum, sum));
        let off = [0, 1, 2].map(|i| (q(found[i]) - quotient(&sum[i], &length)).nearest());
        (DVec3::from(off).length(), size.ratio(&length))
    }
}

fn check(mesh: &Mesh, weighting: Weighting) -> f64 {
    let sums = oracle::sums(mesh, weighting);
    let found = mesh.vertex_normals(weighting)[0];
    if sums.0.iter().all(Exact::is_zero) {
        assert_eq!(found, DVec3::ZERO);
        return 0.0;
    }
    let (off, condition) = oracle::error(found, &sums);
    let bound = if condition < 2048.0 {
        4.0 * EPS + condition * libm::scalbn(1.0, -38)
    } else {
        4.0 * EPS + condition * libm::scalbn(1.0, -90)
    };
    assert!(
        off <= bound,
        "{weighting:?} {found}: {off:e}, condition {condition:e}, {mesh:?}"
    );
    off
}

/// `faces` as a mesh whose vertex 0 is the first corner of each; face k begins with its corner k mod 3.
fn fan(faces: &[[DVec3; 3]]) -> Mesh {
    let mut mesh = Mesh {
        positions: vec![faces[0][0]],
        triangles: vec![],
    };
    for (k, &[_, b, c]) in faces.iter().enumerate() {
        let next = mesh.positions.len() as u32;
        mesh.positions.extend([b, c]);
        let mut triangle = [0, next, next + 1];
        triangle.rotate_left(k % 3);
        mesh.triangles.push(triangle);
    }
    mesh
}

fn near() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array)
}

/// A needle with its tip at the origin or its middle there: b along a direction, c beside it by 10⁻ᵘ.
fn needle() -> impl Strategy<Value = [DVec3; 3]> {
    let beside = prop_oneof![3.0..17.0f64, Just(400.0), 0.0..1.0f64];
    (near(), near(), 0.2..2.0f64, beside, any::<bool>()).prop_map(|(d, by, t, u, opposite)| {
        let t = if opposite { -t } else { t };
        [DVec3::ZERO, d, d * t + by * libm::exp10(-u)]
    })
}

proptest! {
    /// One to three needles of about the same angle, each turned its own way: their weights decide the direction.
    #[test]
    fn needles_keep_their_angles(faces in prop::collection::vec(needle(), 1..4), e in -1020i32..1000, away in 0u8..2) {
        let scale = |p: DVec3| DVec3::from(p.to_array().map(|x| libm::scalbn(x, e)));
        let shift = if away == 0 { DVec3::ZERO } else { scale(DVec3::new(0.7, -0.3, 0.4)) };
        let faces: Vec<_> = faces.into_iter().map(|f| f.map(|p| scale(p) + shift)).collect();
        for weighting in ALL {
            check(&fan(&faces), weighting);
        }
    }

    /// Any faces, and each of them turned over: in any order, begun at any corner.
    #[test]
    fn faces_that_cancel_give_nothing(points in prop::collection::vec(near(), 6), e in -1020i32..1000,
                                      faces in prop::collection::vec(([0u32..6, 0u32..6, 0u32..6], 0usize..3, 0u64..u64::MAX, 0u64..u64::MAX), 1..7)) {
        let positions = points.into_iter().map(|p| DVec3::from(p.to_array().map(|x| libm::scalbn(x, e)))).collect();
        let mut shuffled: Vec<(u64, [u32; 3])> = Vec::new();
        for (face, turn, i, j) in faces {
            let mut back = face;
            back.swap(0, 1);
            back.rotate_left(turn);
            shuffled.extend([(i, face), (j, back)]);
        }
        shuffled.sort();
        let mesh = Mesh { positions, triangles: shuffled.into_iter().map(|(_, t)| t).collect() };
        for weighting in ALL {
            for n in mesh.vertex_normals(weighting) {
                prop_assert_eq!(n, DVec3::ZERO, "{:?}", weighting);
            }
        }
    }

    /// Faces that nearly cancel: two that differ by little, turned to opposite sides, among others that cancel.
    #[test]
    fn what_is_left_of_faces_keeps_its_direction(face in [near(), near()], by in near(), u in 0.0..24.0f64, other in [near(), near()]) {
        let o = DVec3::ZERO;
        let [b, c] = face;
        let moved = c + by * libm::exp10(-u);
        let [x, y] = other;
        let mesh = fan(&[[o, b, c], [o, x, y], [o, moved, b], [o, y, x]]);
        for weighting in ALL {
            check(&mesh, weighting);
        }
    }
}

#[test]
fn a_needle_of_integers() {
    // AB × AC = 2²⁷ − 1 times 2²⁷ + 1, less 2⁵⁴: −1.
    let tip = [
        (0.0, 0.0),
        (134_217_729.0, 134_217_728.0),
        (134_217_728.0, 134_217_727.0),
    ];
    let tip = tip.map(|(x, y)| DVec3::new(x, y, 0.0));
    for e in [-1070, -400, 0, 400, 990] {
        let mesh = fan(&[tip.map(|p| DVec3::from(p.to_array().map(|x| libm::scalbn(x, e))))]);
        for weighting in ALL {
            assert_eq!(
                mesh.vertex_normals(weighting),
                [DVec3::NEG_Z; 3],
                "{weighting:?}"
            );
        }
    }
    // An angle of 10⁻⁶⁰⁰, whose sine no double holds.
    let thin = fan(&[[
        DVec3::ZERO,
        DVec3::X * 1e300,
        DVec3::new(1e300, 1e-300, 0.0),
    ]]);
    assert_eq!(thin.vertex_normals(Weighting::Angle), [DVec3::Z; 3]);
    // Two of those: the one of twice the angle counts twice.
    let pair = fan(&[
        [
            DVec3::ZERO,
            DVec3::X * 1e300,
            DVec3::new(1e300, 1e-300, 0.0),
        ],
        [
            DVec3::ZERO,
            DVec3::Z * 1e300,
            DVec3::new(0.0, 2e-300, 1e300),
        ],
    ]);
    let n = pair.vertex_normals(Weighting::Angle)[0];
    let expected = DVec3::new(-2.0, 0.0, 1.0).normalize();
    assert!((n - expected).length() <= 4.0 * EPS, "{n}");
}

#[test]
fn a_sheet_with_two_sides() {
    let positions = [(0.1, 0.2, 0.3), (1.3, -0.4, 0.7), (0.5, 1.1, -0.2)];
    let positions: Vec<_> = positions.map(DVec3::from).to_vec();
    for turn in 0..3 {
        let mut back = [1, 0, 2];
        back.rotate_left(turn);
        let mesh = Mesh {
            positions: positions.clone(),
            triangles: vec![[0, 1, 2], back],
        };
        for weighting in ALL {
            assert_eq!(mesh.vertex_normals(weighting), [DVec3::ZERO; 3]);
        }
    }
}

/// Faces whose normals add up to nothing though no two are opposite, and sides cut along different diagonals.
#[test]
fn more_than_pairs_cancel() {
    let v = DVec3::new;
    let o = DVec3::ZERO;
    // Normals (1, 2, 2), (1, −2, −2) and (−1, 0, 0), three, three and two of them.
    let mut faces = vec![];
    for k in [1.0, 3.0, 0.7] {
        faces.push([o, v(2.0, -1.0, 0.0) * k, v(0.0, 1.0, -1.0)]);
        faces.push([o, v(0.0, 1.0, -1.0), v(2.0, 1.0, 0.0) * k]);
    }
    faces.push([o, v(0.0, 0.0, 0.3), DVec3::Y]);
    faces.push([o, DVec3::Z, v(0.0, 7.0, 1.0)]);
    assert_eq!(fan(&faces).vertex_normals(Weighting::Plain)[0], DVec3::ZERO);
    // A quadrilateral from both sides; each diagonal cuts two of its angles.
    let quad = Mesh {
        positions: vec![o, v(4.0, 1.0, 2.0), v(2.0, 5.0, 8.0), v(-1.0, 2.0, 3.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3], [3, 1, 0], [3, 2, 1]],
    };
    let flat = Plane::of_triangle(quad.positions[0], quad.positions[1], quad.positions[2]).unwrap();
    assert_eq!(flat.signed_distance(quad.positions[3]), 0.0);
    assert_eq!(quad.vertex_normals(Weighting::Angle), [o; 4]);
}

/// A fin on a sheet with two sides: whatever cancels beside it, the fin's normal is left.
#[test]
fn a_fin_on_what_cancels() {
    let v = DVec3::new;
    let o = DVec3::ZERO;
    let [b, c] = [v(1.3, -0.4, 0.7), v(0.5, 1.1, -0.2)];
    let fin = [
        o,
        v(134_217_729.0, 134_217_728.0, 0.0),
        v(134_217_728.0, 134_217_727.0, 0.0),
    ];
    let mesh = fan(&[[o, b, c], fin, [o, c, b]]);
    let n = mesh.vertex_normals(Weighting::Angle)[0];
    assert!((n - DVec3::NEG_Z).length() <= 1e-9, "{n}");
    let small = [o, v(1e-150, 0.0, 0.0), v(0.0, 0.0, -1e-150)];
    let mesh = fan(&[[o, b, c], small, [o, c, b]]);
    assert_eq!(mesh.vertex_normals(Weighting::Area)[0], DVec3::Y);
}
