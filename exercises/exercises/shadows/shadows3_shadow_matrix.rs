use glam::{DMat4, DVec4};

/// The matrix that casts shadows on any plane, from any light.
///
/// ```text
/// M = (π·L) I − L πᵀ          M (V, 1) = (w P, w)
///
/// (L πᵀ)ᵢⱼ = Lᵢ πⱼ            π·L = a L_x + b L_y + c L_z + d L_w
/// ```
///
/// `plane` is π = (a, b, c, d): the points with a x + b y + c z + d = 0. `light` is homogeneous: L_w = 1 a place,
/// L_w = 0 the direction towards a light at infinity. Vectors are columns.
///
/// π and −π are the same plane: it is turned so that π·L > 0, and then w > 0 for every true shadow, so that clipping
/// keeps it. `None` where π·L = 0 as computed, without a tolerance: the light lies in the plane or shines along it.
/// Whether the plane is made unit first is left to you: that changes M by a factor and P by roundings.
///
/// Bologna, Ombre su piani in WebGL, prints the transposed matrix (erratum E1). Olomouc, Projekce na libovolnou
/// plochu, gives that one for rows, with a misprint (erratum E2).
fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    // TODO: π·L and its sign, then the matrix, column by column.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod shadows3_shadow_matrix {
    use super::shadow_matrix;
    use assess::{
        Inputs, brief, brief4, is_near, near, shadow_bound, shadow_plan, shadow_section, some,
    };
    use glam::{DMat4, DVec3, DVec4};

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

    /// A plane, a light, a vertex and its shadow. With whole numbers and quarters all of it is exact.
    struct Case {
        plane: DVec4,
        light: DVec4,
        v: DVec3,
        want: DVec3,
    }

    impl Case {
        /// The vertex is put on the ray from a point of the plane to the light: that point is its shadow by
        /// construction.
        fn any(inputs: &mut Inputs) -> Self {
            loop {
                let normal = inputs.whole_vector(-5, 5);
                let want = inputs.whole_vector(-20, 20);
                let ray = inputs.whole_vector(-20, 20);
                if normal.dot(ray) != 0.0 {
                    let v = want + 0.25 * f64::from(inputs.integer(1, 3)) * ray;
                    let place = inputs.integer(0, 1) == 1;
                    let light = if place {
                        (want + ray).extend(1.0)
                    } else {
                        ray.extend(0.0)
                    };
                    return Self {
                        plane: normal.extend(-normal.dot(want)),
                        light,
                        v,
                        want,
                    };
                }
            }
        }

        fn matrix(&self) -> DMat4 {
            let what = format!("plane {}, light {}", brief4(self.plane), brief4(self.light));
            some(
                &what,
                shadow_matrix(self.plane, self.light),
                "the light is off the plane",
            )
        }

        fn cast(&self) -> DVec4 {
            self.matrix() * self.v.extend(1.0)
        }

        /// Whether this is the shadow, whatever the sign of w.
        fn is_shadow(&self, p: DVec4) -> bool {
            p.w != 0.0 && is_near(p.truncate() / p.w, self.want, self.bound())
        }

        fn bound(&self) -> f64 {
            shadow_bound(self.plane, self.light, self.v)
        }

        /// Fails unless `p` is the shadow.
        #[track_caller]
        fn check(&self, p: DVec4) {
            near(&self.show(), p.truncate() / p.w, self.want, self.bound());
        }

        fn picture(&self) -> assess::Picture {
            let p = self.cast();
            let got = (p.w != 0.0).then(|| p.truncate() / p.w);
            shadow_section(self.plane, self.light, self.v, got, Some(self.want))
        }

        fn show(&self) -> String {
            let Self {
                plane, light, v, ..
            } = self;
            format!(
                "plane {}, light {}, V {}, M V = {}",
                brief4(*plane),
                brief4(*light),
                brief(*v),
                brief4(self.cast())
            )
        }
    }

    fn cases(seed: u64) -> Vec<Case> {
        let mut inputs = Inputs::new(seed);
        (0..300).map(|_| Case::any(&mut inputs)).collect()
    }

    #[test]
    fn slide_cube() {
        let ground = DVec4::new(0.0, 1.0, 0.0, 0.0);
        let far = DVec4::new(10.0, 10.0, 10.0, 0.0);
        let near_by = DVec4::new(0.0, 100.0, 100.0, 1.0);
        for light in [far, near_by] {
            let m = some(
                "the ground",
                shadow_matrix(ground, light),
                "the light is above it",
            );
            let casts = CUBE.map(|v| m * DVec3::from(v).extend(1.0));
            let got = casts.map(|p| p.truncate() / p.w);
            let want = CUBE.map(|[x, y, z]| {
                let t = y / (light.y - light.w * y);
                let v = DVec3::new(x, y, z);
                v - t * (light.truncate() - light.w * v)
            });
            let _picture = shadow_plan(&got, &want);
            let is_far = |(p, want): (&DVec3, &DVec3)| !is_near(*p, *want, 1e-9);
            if let Some(first) = got.iter().zip(&want).position(is_far) {
                let (v, p) = (DVec3::from(CUBE[first]), casts[first]);
                panic!(
                    "light {light}, ground y = 0: the corner {} goes to {p}, so P = {}, but the lecture has {}",
                    brief(v),
                    brief(got[first]),
                    brief(want[first])
                );
            }
        }
        // At infinity: x_P − y_P and z_P − y_P. In the point: 100 x / w and (100 z − 100 y) / w, w = 100 − y.
        for v in CUBE.map(DVec3::from) {
            let w = 100.0 - v.y;
            for (light, want) in [
                (far, DVec3::new(v.x - v.y, 0.0, v.z - v.y)),
                (
                    near_by,
                    DVec3::new(100.0 * v.x / w, 0.0, 100.0 * (v.z - v.y) / w),
                ),
            ] {
                let case = Case {
                    plane: ground,
                    light,
                    v,
                    want,
                };
                case.check(case.cast());
            }
        }
    }

    #[test]
    fn rows_and_columns() {
        for case in cases(10) {
            let _picture = case.picture();
            let transposed = case.matrix().transpose() * case.v.extend(1.0);
            assert!(
                case.is_shadow(case.cast()) || !case.is_shadow(transposed),
                "{}: this is the transposed matrix: V M would be right, but vectors are columns here, and column j \
                 is L times the j-th coefficient of π (erratum E1)",
                case.show(),
            );
        }
        // The numbers of erratum E1: the transposed matrix leaves the plane.
        let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
        let (v, want) = (DVec3::new(0.0, 20.0, 0.0), DVec3::new(0.0, 0.0, -25.0));
        let case = Case {
            plane: DVec4::Y,
            light,
            v,
            want,
        };
        case.check(case.cast());
    }

    #[test]
    fn places_and_directions() {
        let (places, directions): (Vec<_>, Vec<_>) =
            cases(11).into_iter().partition(|case| case.light.w == 1.0);
        let all_right = |cases: &[Case]| cases.iter().all(|case| case.is_shadow(case.cast()));
        if all_right(&places) && all_right(&directions) {
            return;
        }
        let mut wrong = places.iter().chain(&directions);
        let first = wrong.find(|case| !case.is_shadow(case.cast()));
        let _picture = first.map(Case::picture);
        assert!(
            all_right(&directions) || !all_right(&places),
            "right for every place, wrong for a light at infinity: L_w belongs into the formula, in π·L as d L_w and \
             in the last row",
        );
        // The same light as a place and as a direction.
        let takes_no_w = |case: &Case| {
            let [place, direction] =
                [1.0, 0.0].map(|w| shadow_matrix(case.plane, case.light.with_w(w)));
            place == direction
        };
        assert!(
            !places.iter().all(takes_no_w),
            "the matrix is the same for the place L (L_w = 1) and for the direction L (L_w = 0): L_w is not used",
        );
        // x, y and z of M V in the proportion of P, but w is not what divides them.
        let only_w_wrong = |case: &Case| {
            let p = case.cast();
            let w = p.truncate().dot(case.want) / case.want.length_squared();
            let fits = is_near(p.truncate() / w, case.want, case.bound());
            fits && !case.is_shadow(p)
        };
        assert!(
            !places.iter().all(only_w_wrong),
            "x, y and z of M V are right for a place, but w is not what divides them: the last row of the matrix makes \
             w = π·L − L_w (π·V), of the coefficients −a L_w, −b L_w, −c L_w and π·L − d L_w",
        );
        if let Some(case) = first {
            case.check(case.cast());
        }
    }

    #[test]
    fn any_plane() {
        let (upright, slanted): (Vec<_>, Vec<_>) =
            cases(12).into_iter().partition(|case| case.plane.z == 0.0);
        let only_y_wrong = |case: &Case| {
            let p = case.cast();
            p.w != 0.0
                && is_near(
                    (p.truncate() / p.w).with_y(case.want.y),
                    case.want,
                    case.bound(),
                )
        };
        assert!(
            slanted.iter().all(|case| case.is_shadow(case.cast()))
                || !slanted.iter().all(only_y_wrong)
                || !upright.iter().all(|case| case.is_shadow(case.cast())),
            "only y is wrong, and only where c ≠ 0: the entry of row y and column z is −L_y c; the slide has the \
             misprint −L_z c (erratum E2)",
        );
        for case in upright.iter().chain(&slanted) {
            let _picture = case.picture();
            case.check(case.cast());
        }
    }

    #[test]
    fn positive_w() {
        for case in cases(13) {
            let p = case.cast();
            assert!(
                p.w > 0.0 || !case.is_shadow(p),
                "{}: the point is right but w is negative, and clipping throws it away: the light is on the plane's \
                 back side, so turn the plane round first (as in erratum E21)",
                case.show(),
            );
            case.check(p);
        }
    }

    #[test]
    fn light_in_the_plane() {
        // The terms of π·L cancel in pairs, so their sum is 0 in every order, and also for a plane made unit first.
        for (plane, light) in [
            (DVec4::Y, DVec4::new(1.0, 0.0, 2.0, 0.0)),
            (DVec4::Y, DVec4::new(5.0, 0.0, 7.0, 1.0)),
            (
                DVec4::new(0.0, 0.0, 2.0, -8.0),
                DVec4::new(3.0, -1.0, 4.0, 1.0),
            ),
            (
                DVec4::new(1.0, 1.0, 0.0, 0.0),
                DVec4::new(3.0, -3.0, 5.0, 0.0),
            ),
            (
                DVec4::new(1.0, 1.0, 0.0, 0.0),
                DVec4::new(3.0, -3.0, 5.0, 1.0),
            ),
            (DVec4::new(1.0, 2.0, -2.0, -3.0), DVec4::ZERO),
        ] {
            let m = shadow_matrix(plane, light);
            assert!(
                m.is_none(),
                "plane {}, light {}: π·L = 0, so there is no shadow, but the answer is a matrix",
                brief4(plane),
                brief4(light),
            );
        }
    }

    #[test]
    fn light_nearly_in_the_plane() {
        // The light is 2⁻¹⁰ … 2⁻⁶⁰ of its distance above the plane, at three scales: however grazing, it gives a shadow.
        for power in [10, 20, 30, 40, 60] {
            for scale in [0, 40, -40] {
                let unit = 2f64.powi(scale);
                let low = unit * 2f64.powi(-power);
                let t = 2f64.powi(power);
                for (light, v, want) in [
                    (
                        DVec4::new(unit, low, 0.0, 0.0),
                        DVec3::Y,
                        DVec3::new(-t, 0.0, 0.0),
                    ),
                    (
                        DVec4::new(unit, low, 0.0, 1.0),
                        DVec3::new(0.0, 0.5 * low, 0.0),
                        DVec3::new(-unit, 0.0, 0.0),
                    ),
                ] {
                    let plane = DVec4::Y;
                    let because =
                        "π·L is not 0: its sign is asked for as it is, without a tolerance";
                    let what = format!("plane y = 0, light {}", brief4(light));
                    let m = some(&what, shadow_matrix(plane, light), because);
                    let case = Case {
                        plane,
                        light,
                        v,
                        want,
                    };
                    case.check(m * v.extend(1.0));
                }
            }
        }
    }

    #[test]
    fn huge_and_tiny() {
        for case in cases(14) {
            for scale in [2f64.powi(500), -(2f64.powi(-500))] {
                let scaled = Case {
                    plane: scale * case.plane,
                    ..case
                };
                let p = scaled.cast();
                assert!(p.w > 0.0, "{}: w must be positive", scaled.show());
                scaled.check(p);
            }
        }
    }
}
