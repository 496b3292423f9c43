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
/// A vertex on the plane is its own shadow. `plane` is π = (a, b, c, d), and (−a, −b, −c, −d) is the same plane.
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
    use assess::{Inputs, near, show, some};
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
                self.plane,
                self.light,
                show(self.v)
            )
        }
    }

    /// Numerators and w are exact in these whole numbers and quarters; a division rounds numbers up to 100.
    const BOUND: f64 = 8.0 * f64::EPSILON * 100.0;

    fn true_shadow(case: &Case, want: DVec3) {
        let p = some(
            &case.show(),
            case.shadow(),
            "light, vertex and plane follow in this order: a true shadow",
        );
        near(&case.show(), p, want, BOUND);
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
                let got = lower.shadow();
                assert!(
                    got.is_none(),
                    "{}: the corner is under the table, got {got:?}",
                    lower.show()
                );
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
        for s in [1.0, 1.25, 1.5, 3.0].into_iter().cycle().take(200) {
            let (case, _) = Case::any(&mut inputs, s, true);
            if let Some(p) = case.shadow() {
                panic!(
                    "{}: the light is below the vertex (it lies between the vertex and the plane): no shadow here, \
                     but got {}",
                    case.show(),
                    show(p),
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
                if let Some(p) = case.shadow() {
                    panic!(
                        "{}: the plane lies between the light and the vertex: the vertex is in the dark behind it and \
                         casts no shadow on it, but got {}",
                        case.show(),
                        show(p),
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
                assert!(
                    case.shadow().is_some() == turned.shadow().is_some(),
                    "{}: {:?}, but {:?} with the plane's normal turned round: it is the same plane, and a light may \
                     shine on it from either side, also from below the ground",
                    case.show(),
                    case.shadow(),
                    turned.shadow(),
                );
            }
        }
    }

    #[test]
    fn on_the_plane() {
        let mut inputs = Inputs::new(19);
        for place in [true, false].into_iter().cycle().take(100) {
            let (case, p) = Case::any(&mut inputs, 0.0, place);
            // The normal on the light's side, so that nothing but the contact is asked here.
            let case = Case {
                plane: case.plane * case.plane.dot(case.light).signum(),
                ..case
            };
            let because =
                "a vertex on the plane touches its own shadow there: the contact is a true shadow";
            near(
                &case.show(),
                some(&case.show(), case.shadow(), because),
                p,
                BOUND,
            );
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
            let got = Case {
                plane: ground,
                light,
                v,
            }
            .shadow();
            assert!(
                got.is_none(),
                "light {light} and the ground: π·L = 0, such a plane is unlit, got {got:?}"
            );
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
