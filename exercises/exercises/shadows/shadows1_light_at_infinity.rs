use glam::{DMat4, DVec3};

/// The matrix that casts the shadow of any point P on the ground y = 0, from a light at infinity.
///
/// ```text
/// S = P − t L     t = y_P / y_L     so that y_S = 0
///
///     ⎡ 1   −x_L/y_L   0   0 ⎤
/// M = ⎢ 0       0      0   0 ⎥        M (x_P, y_P, z_P, 1) = (x_S, 0, z_S, 1)
///     ⎢ 0   −z_L/y_L   1   0 ⎥
///     ⎣ 0       0      0   1 ⎦
/// ```
///
/// `light` is the direction L *towards* the light, of any length, from above (y_L > 0). The shadow of a point is a
/// point, w = 1; the slide's worked example prints w = 0 (erratum E4). `None` where y_L = 0: a horizontal light
/// casts no shadow on the ground. Vectors are columns; `DMat4::from_cols` takes the columns of M one by one.
///
/// Olomouc, Zdroj v nekonečnu.
fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    // TODO: the horizontal light first, then the matrix, column by column.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod shadows1_light_at_infinity {
    use super::shadow_matrix;
    use assess::{Inputs, brief, brief4, is_near, near, shadow_plan, shadow_section, some};
    use glam::{DMat4, DVec3, DVec4};

    fn matrix(light: DVec3) -> DMat4 {
        let what = format!("light {}", brief(light));
        some(
            &what,
            shadow_matrix(light),
            "it shines from above, so there is a shadow",
        )
    }

    /// The cube of the deck, in its order.
    const CUBE: [[f64; 3]; 8] = [
        [0.0, 20.0, 0.0],
        [10.0, 20.0, 0.0],
        [10.0, 20.0, 10.0],
        [0.0, 20.0, 10.0],
        [0.0, 30.0, 0.0],
        [10.0, 30.0, 0.0],
        [10.0, 30.0, 10.0],
        [0.0, 30.0, 10.0],
    ];

    /// A light from above, a point S of the ground and a point P on the ray from S to the light, all whole numbers:
    /// S is the shadow of P by construction.
    fn ray(inputs: &mut Inputs) -> (DVec3, DVec3, DVec3) {
        let mut light = inputs.whole_vector(-9, 9);
        light.y = inputs.integer(1, 9).into();
        let s = DVec3::new(
            inputs.integer(-50, 50).into(),
            0.0,
            inputs.integer(-50, 50).into(),
        );
        (light, s, s + f64::from(inputs.integer(1, 9)) * light)
    }

    /// Rounded once in the matrix, once in the product and once in the sum, of numbers up to 200.
    const BOUND: f64 = 4.0 * f64::EPSILON * 200.0;

    #[test]
    fn slide_cube() {
        let m = matrix(DVec3::new(10.0, 10.0, 10.0));
        // t = y_P / 10, so x_S = x_P − y_P and z_S = z_P − y_P.
        let x = [-20.0, -10.0, -10.0, -20.0, -30.0, -20.0, -20.0, -30.0];
        let z = [-20.0, -20.0, -10.0, -10.0, -30.0, -30.0, -20.0, -20.0];
        let got = CUBE.map(|corner| (m * DVec3::from(corner).extend(1.0)).truncate());
        let want: Vec<DVec3> = x
            .iter()
            .zip(z)
            .map(|(&x, z)| DVec3::new(x, 0.0, z))
            .collect();
        let _picture = shadow_plan(&got, &want);
        for ((corner, x), z) in CUBE.map(DVec3::from).into_iter().zip(x).zip(z) {
            let s = m * corner.extend(1.0);
            near(
                &format!("the shadow of {}", brief(corner)),
                s.truncate(),
                DVec3::new(x, 0.0, z),
                0.0,
            );
            assert!(
                s.w == 1.0,
                "the shadow of {} has w = {}, not 1",
                brief(corner),
                s.w
            );
        }
    }

    #[test]
    fn any_light() {
        let mut inputs = Inputs::new(6);
        for _ in 0..200 {
            let (light, want, p) = ray(&mut inputs);
            let m = matrix(light);
            let s = m * p.extend(1.0);
            let what = format!(
                "light {}, P {}, M P = {}",
                brief(light),
                brief(p),
                brief4(s)
            );
            let got = (s.w != 0.0).then(|| s.truncate() / s.w);
            let _picture = shadow_section(DVec4::Y, light.extend(0.0), p, got, Some(want));
            let is_shadow = |s: DVec4| is_near(s.truncate(), want, BOUND) && s.w == 1.0;
            assert!(
                is_shadow(s) || !is_shadow(m.transpose() * p.extend(1.0)),
                "{what}: this is the transposed matrix: P M is right, M P is not. `from_cols` takes columns, and the \
                 formula's rows were given (the same trap as erratum E1)",
            );
            assert!(
                s.w != 0.0,
                "{what}: w = 0 is a direction, but the shadow of a point is a point: the last row is 0 0 0 1 \
                 (erratum E4)",
            );
            // Twice the way from S back to the foot of P leads to where the ray points up.
            let foot = DVec3::new(p.x, 0.0, p.z);
            assert!(
                light.x == 0.0 && light.z == 0.0
                    || !is_near(s.truncate(), 2.0 * foot - want, BOUND),
                "{what}: the shadow falls on the light's side: L points towards the light, and the ray goes on the \
                 other way, S = P − t L",
            );
            near(&what, s.truncate(), want, BOUND);
            assert!(s.w == 1.0, "{what}: w must be 1");
        }
    }

    #[test]
    fn horizontal_light() {
        for y in [0.0, -0.0] {
            let light = DVec3::new(3.0, y, -4.0);
            let m = shadow_matrix(light);
            assert!(
                m.is_none(),
                "light {}: a horizontal light never meets the ground, so the answer is None; its matrix would be \
                 divided by zero",
                brief(light),
            );
        }
    }

    #[test]
    fn grazing_and_huge_light() {
        // 2⁻³⁰ high: the shadow lies 2³⁰ heights away, exactly.
        let grazing = matrix(DVec3::new(1.0, 1.0 / f64::from(1 << 30), 0.0));
        let s = grazing * DVec4::new(5.0, 3.0, 7.0, 1.0);
        near(
            "a grazing light",
            s.truncate(),
            DVec3::new(5.0 - 3.0 * f64::from(1 << 30), 0.0, 7.0),
            0.0,
        );
        // Only the direction counts, and a power of two changes no digit.
        let light = DVec3::new(2.0, 5.0, -3.0);
        for scale in [2f64.powi(900), 2f64.powi(-900)] {
            assert!(
                matrix(light) == matrix(scale * light),
                "a light {scale:e} times as long has the same direction and the same shadows",
            );
        }
    }
}
