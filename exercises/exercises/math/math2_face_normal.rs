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
/// `None` where there is no mean direction: a vertex normal is (0, 0, 0), or the sum of the three unit normals is.
/// A short sum still has a direction, but few digits of it: n is right to 32 ε / ‖n̂₁ + n̂₂ + n̂₃‖ in each coordinate,
/// ε being `f64::EPSILON`. Vertex normals may be from 10⁻¹⁵⁰ to 10¹⁵⁰ long.
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
    use assess::{Inputs, brief, brief_number, is_near, parallel};
    use glam::DVec3;
    use std::f64::consts::TAU;

    const NAMES: [&str; 3] = ["n₁", "n₂", "n₃"];

    fn show(normals: [DVec3; 3]) -> String {
        [0, 1, 2]
            .map(|i| format!("{} {}", NAMES[i], brief(normals[i])))
            .join(", ")
    }

    /// `want` is the mean direction, and the sum of the unit normals is `sum` long.
    fn examine(normals: [DVec3; 3], want: DVec3, sum: f64) {
        let what = show(normals);
        let bound = 32.0 * f64::EPSILON / sum;
        let Some(n) = face_normal(normals) else {
            panic!(
                "{what}: got None, but these have the mean direction {}",
                brief(want)
            );
        };
        let what = format!("{what}: got {}", brief(n));
        assert!(
            !n.is_nan(),
            "{what}, but these have the mean direction {}",
            brief(want)
        );
        assert!(
            n != DVec3::ZERO,
            "{what}, but these have the mean direction {}",
            brief(want)
        );

        let with = |i: usize, other: DVec3| {
            let mut normals = normals;
            normals[i] = other;
            face_normal(normals)
        };
        let left_out: Vec<usize> = (0..3)
            .filter(|&i| {
                // Turned round and turned aside: one of them changes any sum that it is a part of.
                [-normals[i], normals[i].any_orthogonal_vector()]
                    .into_iter()
                    .all(|other| with(i, other) == Some(n))
            })
            .collect();
        assert!(
            left_out.len() < 3,
            "{what}, and the same when any of the three is turned: n is made of them"
        );
        if let Some(&i) = left_out.first() {
            let name = NAMES[i];
            panic!(
                "{what}, and the same when {name} is turned: {name} does not count, but the sum is of all three"
            );
        }
        for i in 0..3 {
            assert!(
                with(i, 4.0 * normals[i]).is_some_and(|longer| parallel(n, longer, bound)),
                "{what}, and another direction when {} is made four times as long: a longer vertex normal must not \
                 count more, so make each of them unit first (erratum E14)",
                NAMES[i],
            );
        }
        let [first, second, third] = normals;
        assert!(
            face_normal([third, first, second]).is_some_and(|other| parallel(n, other, bound)),
            "{what}, and another direction when they are given in the order n₃, n₁, n₂: each counts the same, so add all \
             three first and make the sum unit then",
        );
        assert!(
            !parallel(-n, want, bound),
            "{what}, which is opposite to the mean direction {}",
            brief(want),
        );
        assert!(
            !parallel(n, want, bound) || (n.length() - 1.0).abs() <= bound,
            "{what}: the direction is right, but the length is {}: make the sum unit at the end",
            brief_number(n.length()),
        );
        assert!(
            is_near(n, want, bound),
            "{what}, but the mean direction is {} (off by {:.1e}, allowed is {bound:.1e})",
            brief(want),
            (n - want).abs().max_element(),
        );
    }

    /// What holds of the simplest case is asked first in each test.
    fn examine_first() {
        let [x, y, z] = DVec3::AXES;
        examine([2.0 * x, y, 3.0 * z], (x + y + z).normalize(), 3f64.sqrt());
    }

    #[test]
    fn slide_triangle() {
        // Made unit they are (1, 0, 0), (1, 2, 0)/√5, (0, 1, 0): the sum is (√5 + 1, √5 + 2, 0)/√5. In decimals n is
        // (0.6071, 0.7947, 0).
        let root = 5f64.sqrt();
        let sum = DVec3::new(root + 1.0, root + 2.0, 0.0) / root;
        examine(
            [
                DVec3::new(1.0, 0.0, 0.0),
                DVec3::new(0.5, 1.0, 0.0),
                DVec3::new(0.0, 0.5, 0.0),
            ],
            sum.normalize(),
            sum.length(),
        );
    }

    #[test]
    fn any_triangle() {
        let [x, y, z] = DVec3::AXES;
        examine_first();
        examine([x, x, y], (2.0 * x + y).normalize(), 5f64.sqrt());
        // Two that are opposite leave the third.
        examine([x, DVec3::new(-2.0, 0.0, 0.0), 3.0 * y], y, 1.0);
        examine([x, z, DVec3::new(-1.0, 0.0, 0.0)], z, 1.0);

        let mut inputs = Inputs::new(2);
        for _ in 0..200 {
            // Three normals of any length, at equal angles around an axis: the axis is their mean direction.
            let axis = inputs.direction();
            let (u, v) = axis.any_orthonormal_pair();
            let (tilt, turn) = (inputs.real(0.1, 1.4), inputs.real(0.0, TAU));
            let normals = [0.0, 1.0, 2.0].map(|third| {
                let (sin, cos) = (turn + third * TAU / 3.0).sin_cos();
                inputs.real(0.1, 10.0) * (tilt.cos() * axis + tilt.sin() * (cos * u + sin * v))
            });
            examine(normals, axis, 3.0 * tilt.cos());
        }
    }

    #[test]
    fn no_direction() {
        examine_first();
        let (x, y, zero) = (DVec3::X, DVec3::Y, DVec3::ZERO);
        for normals in [
            [zero, zero, zero],
            [zero, y, y],
            [y, zero, y],
            [y, y, zero],
            [zero, x, y],
            [x, -x, zero],
        ] {
            let Some(n) = face_normal(normals) else {
                continue;
            };
            assert!(
                !n.is_nan(),
                "{}: got Some(NaN): a vertex normal of length 0 cannot be made unit, so the answer is None",
                show(normals),
            );
            panic!(
                "{}: a vertex normal of length 0 has no direction, so the answer is None, got {}",
                show(normals),
                brief(n)
            );
        }
    }

    #[test]
    fn sum_is_zero() {
        examine_first();
        // Unit normals at 120° in the plane x + y + z = 0. Each coordinate sums r, −r and 0, so it is 0 in every
        // order, whatever 1/√2 is rounded to; and other lengths that are powers of two do not change that.
        let cyclic = [
            DVec3::new(1.0, -1.0, 0.0),
            DVec3::new(0.0, 1.0, -1.0),
            DVec3::new(-1.0, 0.0, 1.0),
        ];
        let [first, second, third] = cyclic;
        for normals in [
            cyclic,
            [third, second, first],
            [2.0 * first, 0.5 * second, 4.0 * third],
        ] {
            let Some(n) = face_normal(normals) else {
                continue;
            };
            assert!(
                !n.is_nan(),
                "{}: got Some(NaN): made unit, these three add up to (0, 0, 0), a sum that cannot be made unit, so \
                 the answer is None",
                show(normals),
            );
            panic!(
                "{}: made unit, these three add up to (0, 0, 0), so there is no mean direction and the answer is \
                 None, got {}",
                show(normals),
                brief(n)
            );
        }
        // The third one a little aside: with s = 1/√(1 + δ²/2) the sum is (1 − s, δs, s − 1)/√2.
        for aside in [1e-3_f64, 1e-6, 1e-9] {
            let s = 1.0 / (1.0 + aside * aside / 2.0).sqrt();
            let rest = aside * aside / 2.0 * s * s / (1.0 + s);
            let sum = DVec3::new(rest, aside * s, -rest) / 2f64.sqrt();
            let normals = [first, second, DVec3::new(-1.0, aside, 1.0)];
            assert!(
                face_normal(normals).is_some(),
                "{}: got None, but the sum is {} long, which is short, but not 0: it has a direction",
                show(normals),
                brief_number(sum.length()),
            );
            examine(normals, sum.normalize(), sum.length());
        }
    }

    #[test]
    fn huge_and_tiny() {
        examine_first();
        let (y, z) = (DVec3::Y, DVec3::Z);
        let even = DVec3::ONE.normalize();
        for length in [1.0, 1e3, 1e6, 1e9, 1e149, 1e-3, 1e-6, 1e-9, 1e-150] {
            let normals = [length * DVec3::X, y, z];
            assert!(
                face_normal(normals).is_some(),
                "{}: got None, but the length of n₁, {length:e}, is not 0, so it has a direction",
                show(normals),
            );
            examine(normals, even, 3f64.sqrt());
        }
    }
}
