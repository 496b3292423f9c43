use glam::{DMat4, DVec3};

/// The matrix that casts the shadow of any vertex V on the ground y = 0, from a light in the point L.
///
/// ```text
///       L_y V_x − L_x V_y            L_y V_z − L_z V_y
/// P_x = ─────────────────      P_z = ─────────────────
///           L_y − V_y                    L_y − V_y
///
///     ⎡ L_y   −L_x    0     0  ⎤
/// M = ⎢  0      0     0     0  ⎥        M (V_x, V_y, V_z, 1) = (w P_x, 0, w P_z, w)     w = L_y − V_y
///     ⎢  0    −L_z   L_y    0  ⎥
///     ⎣  0     −1     0    L_y ⎦
/// ```
///
/// The signs are those of the Bologna deck: w > 0 for every true shadow, so that clipping keeps it. The Olomouc
/// matrix has all signs turned round, and its w is negative (erratum E21).
///
/// Bologna, Ombre su piani; Olomouc, Zdroj světla v bodě.
fn shadow_matrix(light: DVec3) -> DMat4 {
    // TODO: the matrix, column by column.
    todo!()
}

/// The shadow of the vertex V on the ground, from a light in the point L: M V divided by its w.
///
/// The vertex lies on or above the ground, the light above it. `None` where w ≤ 0: no ray goes down through a
/// vertex that is as high as the light or higher.
///
/// Olomouc, Zdroj světla v bodě; its worked example prints the shadow of a light at infinity (erratum E3).
fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    // TODO: the matrix times V, then its w.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod shadows2_point_light {
    use super::{shadow, shadow_matrix};
    use assess::{
        Inputs, Picture, brief, brief4, is_near, near, parallel, shadow_plan, shadow_section, some,
    };
    use glam::{DVec3, DVec4};

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

    /// A light, a point P of the ground, and the vertex at the share `s` of the way from P to the light. With whole
    /// numbers and quarters all of this is exact, and for 0 < s < 1 P is the shadow of the vertex by construction.
    fn ray(inputs: &mut Inputs, s: f64) -> (DVec3, DVec3, DVec3) {
        let mut light = inputs.whole_vector(-50, 50);
        light.y = inputs.integer(10, 90).into();
        let p = DVec3::new(
            inputs.integer(-50, 50).into(),
            0.0,
            inputs.integer(-50, 50).into(),
        );
        (light, p, p + s * (light - p))
    }

    fn picture(light: DVec3, v: DVec3, got: Option<DVec3>, want: Option<DVec3>) -> Picture {
        shadow_section(DVec4::Y, light.extend(1.0), v, got, want)
    }

    /// A few roundings of numbers up to 100, which w ≥ 2.5 does not enlarge: the numerators are exact.
    const BOUND: f64 = 8.0 * f64::EPSILON * 100.0;

    #[test]
    fn slide_cube() {
        let light = DVec3::new(0.0, 100.0, 100.0);
        // V_y = 20: w = 80, P_x = 100 V_x / 80, P_z = (100 V_z − 2000) / 80.
        // V_y = 30: w = 70, P_x = 100 V_x / 70, P_z = (100 V_z − 3000) / 70.
        let x = [
            0.0,
            25.0 / 2.0,
            25.0 / 2.0,
            0.0,
            0.0,
            100.0 / 7.0,
            100.0 / 7.0,
            0.0,
        ];
        let z = [
            -25.0,
            -25.0,
            -25.0 / 2.0,
            -25.0 / 2.0,
            -300.0 / 7.0,
            -300.0 / 7.0,
            -200.0 / 7.0,
            -200.0 / 7.0,
        ];
        let got = CUBE.map(|v| shadow(light, v.into()));
        let want: Vec<DVec3> = x
            .iter()
            .zip(z)
            .map(|(&x, z)| DVec3::new(x, 0.0, z))
            .collect();
        let got: Vec<DVec3> = got.into_iter().flatten().collect();
        let _picture = shadow_plan(&got, &want);
        for ((v, x), z) in CUBE.map(DVec3::from).into_iter().zip(x).zip(z) {
            let what = format!("the shadow of {}", brief(v));
            let p = some(&what, shadow(light, v), "the light is above the vertex");
            near(&what, p, DVec3::new(x, 0.0, z), BOUND);
        }
    }

    #[test]
    fn any_matrix() {
        let mut inputs = Inputs::new(7);
        for s in [0.25, 0.5, 0.75].into_iter().cycle().take(200) {
            let (light, p, v) = ray(&mut inputs, s);
            let m = shadow_matrix(light);
            let cast = m * v.extend(1.0);
            let what = format!(
                "light {}, V {}, M V = {}",
                brief(light),
                brief(v),
                brief4(cast)
            );
            let w = light.y - v.y;
            let got = (cast.w != 0.0).then(|| cast.truncate() / cast.w);
            let _picture = picture(light, v, got, Some(p));
            let is_shadow = |cast: DVec4| cast.w == w && is_near(cast.truncate() / w, p, BOUND);
            assert!(
                is_shadow(cast) || !is_shadow(m.transpose() * v.extend(1.0)),
                "{what}: this is the transposed matrix: `from_cols` takes columns (the same trap as erratum E1)",
            );
            assert!(
                is_shadow(cast) || !is_shadow(-cast),
                "{what}: w is negative, as with the slide's matrix, and clipping throws away w < 0: turn all signs \
                 round (erratum E21)",
            );
            assert!(cast.w == w, "{what}: w is {}, but L_y − V_y is {w}", cast.w);
            near(&what, cast.truncate() / w, p, BOUND);
        }
    }

    #[test]
    fn any_vertex() {
        let mut inputs = Inputs::new(8);
        for s in [0.25, 0.5, 0.75].into_iter().cycle().take(200) {
            let (light, want, v) = ray(&mut inputs, s);
            let what = format!("light {}, V {}", brief(light), brief(v));
            let got = shadow(light, v);
            let _picture = picture(light, v, got, Some(want));
            let p = some(&what, got, "the light is above the vertex");
            assert!(
                is_near(p, want, BOUND) || !is_near(p / (light.y - v.y), want, BOUND),
                "{what}: {} divided by w = L_y − V_y would be right: the division by w is missing",
                brief(p),
            );
            // A light at infinity in the direction L would cast along L; the point casts along V − L.
            assert!(
                is_near(p, want, BOUND)
                    || p.y != 0.0
                    || !parallel(v - p, light, 16.0 * f64::EPSILON),
                "{what}: {} lies on the ray from V along L, as from a light at infinity; here L is a place, and the \
                 rays spread from it (erratum E3)",
                brief(p),
            );
            near(&what, p, want, BOUND);
        }
    }

    #[test]
    fn above_the_light() {
        let mut inputs = Inputs::new(9);
        for s in [1.0, 1.25, 2.0, 3.0].into_iter().cycle().take(100) {
            let (light, _, v) = ray(&mut inputs, s);
            let got = shadow(light, v);
            let _picture = picture(light, v, got, None);
            if let Some(p) = got {
                panic!(
                    "light {}, V {}: the light is below the vertex: no shadow here, but got {} (w = {} is not positive)",
                    brief(light),
                    brief(v),
                    brief(p),
                    light.y - v.y,
                );
            }
        }
    }

    #[test]
    fn nearly_as_high_as_the_light() {
        // w = 2⁻³⁰: the shadow is 2³⁰ times 100 away, exactly.
        let height = 100.0 - 1.0 / f64::from(1 << 30);
        let p = shadow(DVec3::new(0.0, 100.0, 0.0), DVec3::new(1.0, height, -2.0));
        let p = some("V 2⁻³⁰ below the light", p, "the light is above the vertex");
        let far = 100.0 * f64::from(1 << 30);
        near(
            "V 2⁻³⁰ below the light",
            p,
            DVec3::new(far, 0.0, -2.0 * far),
            2.0 * f64::EPSILON * far,
        );
        // What stands on the ground is its own shadow.
        let foot = DVec3::new(3.0, 0.0, -8.0);
        let p = some(
            "V on the ground",
            shadow(DVec3::new(5.0, 60.0, 7.0), foot),
            "the light is above it",
        );
        near("V on the ground", p, foot, BOUND);
    }
}
