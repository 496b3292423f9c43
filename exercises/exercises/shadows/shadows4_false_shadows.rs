use glam::{DVec3, DVec4};

/// The shadow of the vertex V on a plane, where there is one in truth.
///
/// ```text
/// P = ((π·L) V − (π·V) L) / w          w = π·L − L_w (π·V)
/// ```
///
/// With L = (L_x, L_y, L_z, L_w) and V = (V_x, V_y, V_z, 1) this is the point where the line through light and vertex
/// meets the plane. The formula flattens any vertex, wherever it is. A true shadow needs the order light, vertex,
/// plane on the ray; otherwise the point is a false shadow, and the answer is `None`:
///
/// - the light lies between the vertex and the plane, or as far from the plane as the vertex;
/// - the plane lies between the light and the vertex;
/// - the light lies in the plane or shines along it, π·L = 0: such a plane is unlit.
///
/// A vertex on the plane is its own shadow. All signs are taken as they are computed, without a tolerance; whether the
/// plane is made unit first is left to you, P then differs by roundings. `plane` is π = (a, b, c, d), and (−a, −b, −c, −d) is the same plane.
/// `light` is homogeneous: L_w = 1 a place, L_w = 0 the direction towards a light at infinity.
///
/// Olomouc, Nevýhody (projection methods).
fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    // TODO: on which side of the plane are the light and the vertex, and what is the sign of w?
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod shadows4_false_shadows {
    use super::shadow;
    use assess::{
        Inputs, Picture, brief, brief_number, brief4, is_near, near, shadow_bound, shadow_section,
        some,
    };
    use glam::{DVec3, DVec4};

    /// A plane, a light and a vertex. With whole numbers and quarters all of it is exact.
    struct Case {
        plane: DVec4,
        light: DVec4,
        v: DVec3,
    }

    impl Case {
        /// The vertex is put on the line from a point of the plane to the light, at the share `s` of the way: 0 on the
        /// plane, 1 at a light that is a place; a light at infinity is never reached. Also that point of the plane.
        fn any(inputs: &mut Inputs, s: f64, place: bool) -> (Self, DVec3) {
            loop {
                let normal = inputs.whole_vector(-5, 5);
                let p = inputs.whole_vector(-20, 20);
                let ray = inputs.whole_vector(-20, 20);
                if normal.dot(ray) != 0.0 {
                    let light = if place {
                        (p + ray).extend(1.0)
                    } else {
                        ray.extend(0.0)
                    };
                    let plane = normal.extend(-normal.dot(p));
                    return (
                        Self {
                            plane,
                            light,
                            v: p + s * ray,
                        },
                        p,
                    );
                }
            }
        }

        fn shadow(&self) -> Option<DVec3> {
            shadow(self.plane, self.light, self.v)
        }

        fn show(&self) -> String {
            format!(
                "plane {}, light {}, V {}",
                brief4(self.plane),
                brief4(self.light),
                brief(self.v)
            )
        }

        fn picture(&self, want: Option<DVec3>) -> Picture {
            shadow_section(self.plane, self.light, self.v, self.shadow(), want)
        }
    }

    fn true_shadow(case: &Case, want: DVec3) {
        let _picture = case.picture(Some(want));
        let p = some(
            &case.show(),
            case.shadow(),
            "light, vertex and plane follow in this order: a true shadow",
        );
        let bound = shadow_bound(case.plane, case.light, case.v);
        let w =
            (case.plane.dot(case.light) - case.light.w * case.plane.dot(case.v.extend(1.0))).abs();
        assert!(
            is_near(p, want, bound) || !is_near(p / w, want, bound),
            "{}: got {}, which divided by |w| = {} would be right: the division by w is missing",
            case.show(),
            brief(p),
            brief_number(w),
        );
        near(&case.show(), p, want, bound);
    }

    #[test]
    fn slide_cube_with_a_table() {
        // A table top at y = 25 parts the slide's cube: its lower corners (y = 20) are under the table.
        let table = DVec4::new(0.0, 1.0, 0.0, -25.0);
        for light in [
            DVec4::new(10.0, 10.0, 10.0, 0.0),
            DVec4::new(0.0, 100.0, 100.0, 1.0),
        ] {
            for (x, z) in [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)] {
                let [lower, upper] = [20.0, 30.0].map(|y| Case {
                    plane: table,
                    light,
                    v: DVec3::new(x, y, z),
                });
                if let Some(p) = lower.shadow() {
                    let _picture = lower.picture(None);
                    panic!(
                        "{}: the corner is under the table: no shadow on it, but got {}",
                        lower.show(),
                        brief(p),
                    );
                }
                // 5 down from y = 30: half of (10, 10, 10); or 5/70 of the way from L to V, once more.
                let far = light.truncate() * 5.0 / 10.0;
                let by = (light.truncate() - upper.v) * 5.0 / 70.0;
                true_shadow(&upper, upper.v - if light.w == 0.0 { far } else { by });
            }
        }
    }

    #[test]
    fn true_shadows() {
        let mut inputs = Inputs::new(15);
        for s in [0.25, 0.5, 0.75].into_iter().cycle().take(150) {
            for place in [true, false] {
                let (case, p) = Case::any(&mut inputs, s, place);
                true_shadow(&case, p);
            }
        }
    }

    #[test]
    fn above_the_light() {
        let mut inputs = Inputs::new(16);
        for s in [1.25, 1.5, 3.0, 1.0].into_iter().cycle().take(200) {
            let (case, _) = Case::any(&mut inputs, s, true);
            let _picture = case.picture(None);
            if let Some(p) = case.shadow() {
                let why = if s > 1.0 {
                    "the light is below the vertex (it lies between the vertex and the plane)"
                } else {
                    "the light is as far from the plane as the vertex, w = 0"
                };
                panic!(
                    "{}: {why}: no shadow here, but got {}",
                    case.show(),
                    brief(p)
                );
            }
        }
    }

    #[test]
    fn behind_the_plane() {
        let mut inputs = Inputs::new(17);
        for s in [-0.25, -1.0, -2.5].into_iter().cycle().take(150) {
            for place in [true, false] {
                let (case, _) = Case::any(&mut inputs, s, place);
                let _picture = case.picture(None);
                if let Some(p) = case.shadow() {
                    panic!(
                        "{}: the plane lies between the light and the vertex: the vertex is in the dark behind it and \
                         casts no shadow on it, but got {}",
                        case.show(),
                        brief(p),
                    );
                }
            }
        }
    }

    #[test]
    fn either_side() {
        let mut inputs = Inputs::new(18);
        for s in [0.5, -0.5, 1.5].into_iter().cycle().take(150) {
            for place in [true, false] {
                let (case, _) = Case::any(&mut inputs, s, place);
                let turned = Case {
                    plane: -case.plane,
                    ..case
                };
                let shown = |p: Option<DVec3>| p.map_or_else(|| "None".to_owned(), brief);
                assert!(
                    case.shadow().is_some() == turned.shadow().is_some(),
                    "{}: {}, but {} with the plane's normal turned round: it is the same plane, and a light may \
                     shine on it from either side, also from below the ground",
                    case.show(),
                    shown(case.shadow()),
                    shown(turned.shadow()),
                );
            }
        }
    }

    #[test]
    fn on_the_plane() {
        // π·V is 0 in every order of its terms, also for a plane made unit first. The normal points to the light, so
        // that nothing but the contact is asked here.
        let mut inputs = Inputs::new(19);
        for place in [1.0, 0.0].into_iter().cycle().take(100) {
            let [x, z] = [(); 2].map(|()| f64::from(inputs.integer(-20, 20)));
            let light = DVec4::new(x + 3.0, f64::from(inputs.integer(30, 60)), z, place);
            for (plane, v) in [
                (DVec4::Y, DVec3::new(x, 0.0, z)),
                (DVec4::new(0.0, 4.0, 0.0, 32.0), DVec3::new(x, -8.0, z)),
                (DVec4::new(1.0, 1.0, 0.0, 0.0), DVec3::new(x, -x, z)),
            ] {
                let case = Case { plane, light, v };
                let because = "a vertex on the plane touches its own shadow there: the contact is a true shadow";
                let _picture = case.picture(Some(v));
                let p = some(&case.show(), case.shadow(), because);
                near(&case.show(), p, v, shadow_bound(plane, light, v));
            }
        }
    }

    /// The vertex a hair off the light's height, or off the plane: from a quarter to 2⁻⁴⁵ of the height, at three scales,
    /// along each axis, with the plane's normal to either side. All of it is exact in every order of the terms.
    #[test]
    fn by_a_hair() {
        for (scale, power) in [0, 40, -40]
            .into_iter()
            .flat_map(|s| [2, 10, 20, 30, 45].map(|p| (s, p)))
        {
            let unit = 2f64.powi(scale);
            let hair = 2f64.powi(-power);
            // A quarter of the height is no hair yet.
            let exact = |what: &str| {
                if (power, scale) == (2, 0) {
                    String::new()
                } else {
                    format!(
                        ", by 2^−{power} of the light's height, and that is enough for {what}, without a tolerance"
                    )
                }
            };
            for axis in 0..3 {
                // The height becomes the coordinate `axis`.
                let turn = |p: DVec3| {
                    let [x, y, z] = p.to_array();
                    unit * DVec3::from([[y, x, z], [x, y, z], [x, z, y]][axis])
                };
                let light = turn(DVec3::new(0.0, 8.0, 2.0)).extend(1.0);
                let far = turn(DVec3::new(1.0, 8.0, 2.0)).extend(0.0);
                for side in [1.0, -1.0, 4.0] {
                    let plane = (side * DVec3::AXES[axis]).extend(0.0);
                    let case = |light: DVec4, height: f64| Case {
                        plane,
                        light,
                        v: turn(DVec3::new(1.0, height, 0.0)),
                    };
                    for (case, why) in [
                        (
                            case(light, 8.0 * (1.0 + hair)),
                            "the light is below the vertex",
                        ),
                        (case(light, -8.0 * hair), "the vertex is behind the plane"),
                        (case(far, -8.0 * hair), "the vertex is behind the plane"),
                    ] {
                        let _picture = case.picture(None);
                        if let Some(p) = case.shadow() {
                            panic!(
                                "{}: {why}{}: None, but got {}",
                                case.show(),
                                exact("no shadow"),
                                brief(p),
                            );
                        }
                    }
                    for (case, way) in [
                        (
                            case(light, 8.0 * (1.0 - hair)),
                            "the vertex is below the light",
                        ),
                        (case(light, 8.0 * hair), "the vertex is above the plane"),
                        (case(far, 8.0 * hair), "the vertex is above the plane"),
                    ] {
                        let because = format!("{way}{}", exact("a shadow"));
                        let p = some(&case.show(), case.shadow(), &because);
                        // Where the ray through V comes to height 0: V − t (L − L_w V).
                        let (l, v) = (case.light, case.v);
                        let ray = l.truncate() - l.w * v;
                        let want = v - v[axis] / ray[axis] * ray;
                        near(&case.show(), p, want, 2.0 * shadow_bound(plane, l, v));
                    }
                }
            }
        }
    }

    #[test]
    fn along_the_plane_and_far_away() {
        let ground = DVec4::Y;
        let v = DVec3::new(1.0, 2.0, 3.0);
        for light in [
            DVec4::new(4.0, 0.0, -1.0, 0.0),
            DVec4::new(7.0, 0.0, 7.0, 1.0),
        ] {
            let case = Case {
                plane: ground,
                light,
                v,
            };
            let _picture = case.picture(None);
            if let Some(p) = case.shadow() {
                panic!(
                    "{}: π·L = 0, such a plane is unlit: None, but got {}",
                    case.show(),
                    brief(p),
                );
            }
        }
        // A place 2⁵⁰ times (1, 2, 4) away is as good as that direction: the difference is 2⁻⁵⁰ of the shadow's way.
        let direction = DVec3::new(1.0, 2.0, 4.0);
        let place = (2f64.powi(50) * direction).extend(1.0);
        true_shadow(
            &Case {
                plane: ground,
                light: place,
                v,
            },
            DVec3::new(0.0, 0.0, -1.0),
        );
        true_shadow(
            &Case {
                plane: ground,
                light: direction.extend(0.0),
                v,
            },
            DVec3::new(0.0, 0.0, -1.0),
        );
    }
}
