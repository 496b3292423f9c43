use glam::DVec3;

/// The normal of a triangle whose vertex normals are known: their mean direction, of unit length.
///
/// ```text
/// n = (n̂₁ + n̂₂ + n̂₃) / ‖n̂₁ + n̂₂ + n̂₃‖          n̂ᵢ = nᵢ / ‖nᵢ‖
/// ```
///
/// A normal tells a direction, so each vertex normal is made unit before the mean is taken; the deck's example
/// leaves that open and gives normals of other lengths (erratum E14).
///
/// `None` where there is no mean direction: a vertex normal is the zero vector, or the sum is.
///
/// Olomouc, Flat shading.
fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    // TODO: make each of them unit, add, make the sum unit. `try_normalize` answers `None` for the zero vector.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod math2_face_normal {
    use super::face_normal;
    use assess::{Inputs, near, near_number, parallel, show, some};
    use glam::DVec3;
    use std::f64::consts::TAU;

    /// Three normals of any length, at equal angles around `axis`: the axis is their mean direction.
    fn around(axis: DVec3, inputs: &mut Inputs) -> [DVec3; 3] {
        let (u, v) = axis.any_orthonormal_pair();
        let (tilt, turn) = (inputs.real(0.1, 1.4), inputs.real(0.0, TAU));
        [0.0, 1.0, 2.0].map(|third| {
            let (sin, cos) = (turn + third * TAU / 3.0).sin_cos();
            inputs.real(0.1, 10.0) * (tilt.cos() * axis + tilt.sin() * (cos * u + sin * v))
        })
    }

    #[test]
    fn slide_triangle() {
        let normals = [
            DVec3::new(1.0, 0.0, 0.0),
            DVec3::new(0.5, 1.0, 0.0),
            DVec3::new(0.0, 0.5, 0.0),
        ];
        let n = some(
            "the slide's normals",
            face_normal(normals),
            "they have a mean direction",
        );
        // Made unit they are (1, 0, 0), (1, 2, 0)/√5, (0, 1, 0): the sum is (√5 + 1, √5 + 2, 0)/√5, and
        // (√5 + 2)/(√5 + 1) = (3 + √5)/4. In decimals (0.6071, 0.7947, 0).
        near(
            "the slide's normals",
            n,
            DVec3::new(0.6071, 0.7947, 0.0),
            0.5e-4,
        );
        // A quotient of two coordinates, each a few roundings away.
        near_number(
            "n.y / n.x",
            n.y / n.x,
            (3.0 + 5f64.sqrt()) / 4.0,
            16.0 * f64::EPSILON,
        );
    }

    #[test]
    fn any_triangle() {
        let mut inputs = Inputs::new(2);
        for _ in 0..200 {
            let axis = inputs.direction();
            let normals = around(axis, &mut inputs);
            let what = format!(
                "n₁ {}, n₂ {}, n₃ {}",
                show(normals[0]),
                show(normals[1]),
                show(normals[2])
            );
            let n = some(&what, face_normal(normals), "these have a mean direction");

            let longer = [4.0 * normals[0], normals[1], normals[2]];
            let with_longer = some(&what, face_normal(longer), "these have a mean direction");
            // The sum is at least 3 cos 1.4 = 0.5 long, so its direction is known to some tens of roundings.
            assert!(
                parallel(n, with_longer, 64.0 * f64::EPSILON),
                "{what}: the answer changes when n₁ is made four times as long: a longer vertex normal must not \
                 count more, so make each of them unit first (erratum E14)",
            );
            assert!(
                !parallel(n, axis, 64.0 * f64::EPSILON)
                    || (n.length() - 1.0).abs() < 8.0 * f64::EPSILON,
                "{what}: the direction is right, but the length is {}: the mean of unit vectors is shorter than \
                 1, so it must be made unit at the end",
                n.length(),
            );
            near(&what, n, axis, 64.0 * f64::EPSILON);
        }
    }

    #[test]
    fn no_direction() {
        let (x, y) = (DVec3::X, DVec3::Y);
        for normals in [[x, -x, DVec3::ZERO], [DVec3::ZERO, y, y], [DVec3::ZERO; 3]] {
            if let Some(n) = face_normal(normals) {
                assert!(
                    !n.is_nan(),
                    "the answer is Some(NaN): a vector of length 0 cannot be made unit, and the answer is None",
                );
                panic!(
                    "a vertex normal of length 0 has no direction: the answer is None, got {}",
                    show(n)
                );
            }
        }
    }

    #[test]
    fn huge_and_tiny() {
        let normals = [1e150 * DVec3::X, 1e-150 * DVec3::Y, DVec3::Z];
        let n = some(
            "lengths 10¹⁵⁰, 10⁻¹⁵⁰ and 1",
            face_normal(normals),
            "their directions are X, Y, Z",
        );
        let third = 1.0 / 3f64.sqrt();
        near(
            "lengths 10¹⁵⁰, 10⁻¹⁵⁰ and 1",
            n,
            DVec3::splat(third),
            4.0 * f64::EPSILON,
        );
    }
}
