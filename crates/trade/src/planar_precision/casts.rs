//! Planes, lights and vertices that lose digits on purpose, and their exact shadows.

use ombra_math::glam::{DMat4, DVec3, DVec4, Mat4, Vec3};
use ombra_math::homogeneous::{incidence, point};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::vector::{dot, exact, mix};
use ombra_shadows::planar::shadow_matrix;

use crate::deviation::Deviation;
use crate::random::Random;

/// Length 1 to four digits, along no axis.
const NORMAL: DVec3 = DVec3::new(0.36, 0.88, -0.31);
/// Along the plane to four digits, of length 1 to four digits.
const ALONG: DVec3 = DVec3::new(0.81, -0.145, 0.568);
/// Where the shadows of a scene at the origin fall, near the plane: far enough from the origin that no shadow lies
/// there, where a relative error would mean nothing.
const CENTRE: DVec3 = DVec3::new(1.0, -5.5, 2.0);
/// From the centre of the shadows to the light.
const DISTANCE: f64 = 10.0;

/// A plane, a light, vertices that all cast a shadow, and everything that is made of them before the clock runs.
pub struct Casts {
    pub plane: Plane,
    pub light: DVec4,
    pub vertices: Vec<DVec3>,
    /// The middle of the scene.
    pub middle: DVec3,
    /// The shadow matrix; zero if there is none.
    pub matrix: DMat4,
    /// The same, rounded.
    pub matrix_f32: Mat4,
    /// The vertices, rounded.
    pub vertices_f32: Vec<Vec3>,
    /// The matrix of the light taken as a direction, with its last row made (0, 0, 0, 1).
    pub directional: [DVec3; 4],
    /// The plane as seen from the middle.
    pub local_plane: Plane,
    /// The light as seen from the middle.
    pub local_light: DVec4,
    shadows: Vec<ExactShadow>,
}

/// P* = numerator / w, with w > 0.
struct ExactShadow {
    numerator: [Exact; 3],
    w: Exact,
}

impl Casts {
    /// A light at `height` times its distance over the plane, and vertices below it.
    pub fn towards_plane(height: f64, vertices: usize) -> Self {
        let away = (1.0 - height * height).sqrt() * ALONG + height * NORMAL;
        let place = point(CENTRE + DISTANCE * away);
        // d is chosen last, so that the light's height is right but for the rounding of d.
        let plane = plane_at(place, DISTANCE * height);
        Self::new(plane, place, DVec3::ZERO, 0.9 * DISTANCE * height, vertices)
    }

    /// A light (D, `w`), and vertices near the plane.
    pub fn to_infinity(w: f64, vertices: usize) -> Self {
        let towards = CENTRE + DISTANCE * (0.6 * ALONG + 0.8 * NORMAL);
        let plane = plane_at(point(CENTRE), 0.0);
        Self::new(
            plane,
            towards.extend(w),
            DVec3::ZERO,
            0.2 * DISTANCE,
            vertices,
        )
    }

    /// A scene whose middle lies at `offset` times its size from the origin.
    pub fn far_from_origin(offset: f64, vertices: usize) -> Self {
        let middle = offset * DISTANCE * DVec3::new(0.64, -0.48, 0.6);
        let place = point(middle + (CENTRE + DISTANCE * (0.6 * ALONG + 0.8 * NORMAL)));
        let plane = plane_at(point(middle + CENTRE), 0.0);
        Self::new(plane, place, middle, 0.2 * DISTANCE, vertices)
    }

    /// `vertices` of them up to `highest` over the plane.
    fn new(plane: Plane, light: DVec4, middle: DVec3, highest: f64, vertices: usize) -> Self {
        let mut random = Random::new(1988);
        let (mut chosen, mut shadows) = (Vec::new(), Vec::new());
        // Where heights are hardly larger than the rounding of coordinates, some vertices fall behind the plane or beyond
        // the light and are drawn again. The bound is for scenes that have no room for any.
        for _ in 0..10 * vertices {
            if chosen.len() == vertices {
                break;
            }
            let x = middle.x + CENTRE.x + random.between(-4.0, 4.0);
            let z = middle.z + CENTRE.z + random.between(-4.0, 4.0);
            let height = random.between(0.0, highest);
            let n = plane.normal;
            let v = DVec3::new(x, (height - plane.d - n.x * x - n.z * z) / n.y, z);
            if let Some(shadow) = ExactShadow::of(plane, light, v) {
                chosen.push(v);
                shadows.push(shadow);
            }
        }
        let matrix = shadow_matrix(plane, light).unwrap_or(DMat4::ZERO);
        let direction = light.truncate().extend(0.0);
        let directional = shadow_matrix(plane, direction).unwrap_or(DMat4::ZERO);
        Self {
            plane,
            light,
            middle,
            matrix,
            matrix_f32: matrix.as_mat4(),
            vertices_f32: chosen.iter().map(|v| v.as_vec3()).collect(),
            vertices: chosen,
            // The last row is (0, 0, 0, s).
            directional: [
                directional.x_axis,
                directional.y_axis,
                directional.z_axis,
                directional.w_axis,
            ]
            .map(|column| column.truncate() / directional.w_axis.w),
            local_plane: Plane {
                normal: plane.normal,
                d: incidence(plane.coefficients(), point(middle)),
            },
            local_light: (light.truncate() - light.w * middle).extend(light.w),
            shadows,
        }
    }

    /// One answer a vertex.
    pub fn each(&self, shadow: impl FnMut(DVec3) -> Option<DVec3>) -> Vec<Option<DVec3>> {
        self.vertices.iter().copied().map(shadow).collect()
    }

    /// The errors of shadows.
    pub fn deviation(&self, shadows: &[Option<DVec3>]) -> Deviation {
        self.errors(shadows, DVec3::ZERO)
    }

    /// The errors of shadows in f32.
    pub fn deviation_f32(&self, shadows: &[Option<Vec3>]) -> Deviation {
        let in_f64: Vec<_> = shadows.iter().map(|p| p.map(|p| p.as_dvec3())).collect();
        self.deviation(&in_f64)
    }

    /// The errors of shadows that are given relative to the middle of the scene.
    pub fn deviation_from_middle(&self, shadows: &[Option<DVec3>]) -> Deviation {
        self.errors(shadows, self.middle)
    }

    /// ‖O' + P − P*‖∞ / ‖P* − O‖∞ of every vertex, O' being the `origin` that the answers are relative to.
    fn errors(&self, shadows: &[Option<DVec3>], origin: DVec3) -> Deviation {
        let answers = shadows.iter().copied().chain(core::iter::repeat(None));
        Deviation::of(self.shadows.iter().zip(answers).map(|(truth, answer)| {
            let (answer, origin, middle) = (exact(answer?)?, exact(origin)?, exact(self.middle)?);
            // All multiplied by w, so that nothing is divided before it is compared.
            let (mut off, mut size) = (Exact::ZERO, Exact::ZERO);
            for (((n, p), o), m) in truth
                .numerator
                .iter()
                .zip(&answer)
                .zip(&origin)
                .zip(&middle)
            {
                off = off.max(((p + o) * &truth.w - n).abs());
                size = size.max((n - m * &truth.w).abs());
            }
            Some(off.ratio(&size))
        }))
    }
}

/// The plane with the study's normal from which `p` has that height, to the rounding of d.
fn plane_at(p: DVec4, height: f64) -> Plane {
    let without_d = Plane {
        normal: NORMAL,
        d: 0.0,
    };
    Plane {
        normal: NORMAL,
        d: height - incidence(without_d.coefficients(), p),
    }
}

impl ExactShadow {
    /// The shadow by the quotient form in integers; `None` where `v` is not between the light and the plane.
    fn of(plane: Plane, light: DVec4, v: DVec3) -> Option<Self> {
        let (pi, l, v) = (
            exact(plane.coefficients())?,
            exact(light)?,
            exact(v.extend(1.0))?,
        );
        let (s, t) = (dot(&pi, &l), dot(&pi, &v));
        let [x, y, z, w] = mix(&s, &v, &-&t, &l);
        let between = s > 0 && t >= 0 && w > 0;
        let numerator = [x, y, z];
        between.then_some(Self { numerator, w })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_oracle::vector::cross;

    #[test]
    fn the_lectures_shadow() {
        let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
        let shadow = ExactShadow::of(Plane::GROUND, light, DVec3::new(10.0, 30.0, 0.0)).unwrap();
        assert_eq!(
            shadow.numerator.map(|n| n.ratio(&shadow.w)),
            [100.0 / 7.0, 0.0, -300.0 / 7.0]
        );
        for no_shadow in [-1.0, 100.0, 130.0, f64::NAN] {
            assert!(
                ExactShadow::of(Plane::GROUND, light, DVec3::new(10.0, no_shadow, 0.0)).is_none()
            );
        }
    }

    #[test]
    fn shadows_lie_on_the_plane_and_on_the_ray_without_any_error() {
        for scene in [
            Casts::towards_plane(1e-15, 20),
            Casts::to_infinity(1e-9, 20),
            Casts::to_infinity(1.0, 20),
            Casts::far_from_origin(1e12, 20),
        ] {
            let pi = exact(scene.plane.coefficients()).unwrap();
            let light = exact(scene.light.truncate()).unwrap();
            let light_w = Exact::new(scene.light.w).unwrap();
            assert_eq!((scene.vertices.len(), scene.shadows.len()), (20, 20));
            for (v, ExactShadow { numerator, w }) in scene.vertices.iter().zip(&scene.shadows) {
                let [x, y, z] = numerator.clone();
                assert_eq!(dot(&pi, &[x, y, z, w.clone()]), 0);
                // P − V is a multiple of L − L_w V: their cross product is zero.
                let v = exact(*v).unwrap();
                let to_shadow = mix(&Exact::from(1), numerator, &-w, &v);
                let to_light = mix(&Exact::from(1), &light, &-&light_w, &v);
                assert!(cross(&to_shadow, &to_light).iter().all(Exact::is_zero));
            }
        }
    }

    #[test]
    fn the_light_is_as_high_as_asked() {
        for k in 0..=15 {
            let height = 10f64.powi(-k);
            let scene = Casts::towards_plane(height, 1);
            let found = incidence(scene.plane.coefficients(), scene.light) / DISTANCE;
            // n·L is below 8 and within ε of itself, d half an ulp more: 1.4·10⁻¹⁵, over the distance of 10.
            assert!((found - height).abs() <= 1.4e-16, "{height:e} {found:e}");
        }
    }

    #[test]
    fn errors_are_relative_to_the_middle_and_not_rounded_before() {
        let scene = Casts::far_from_origin(1.0, 2);
        let truth: Vec<_> = scene
            .shadows
            .iter()
            .map(|s| DVec3::from_array([0, 1, 2].map(|j| s.numerator[j].ratio(&s.w))))
            .collect();
        let size = (truth[0] - scene.middle).abs().max_element();
        // Off by 2⁻³⁰ in y, where only the rounding of the truth itself (½ ulp of 8) is beside it.
        let off = 2f64.powi(-30);
        let found = scene.deviation(&[Some(truth[0] + off * DVec3::Y), None]);
        assert!(
            (found.max - off / size).abs() <= 2.0 * f64::EPSILON * 8.0 / size,
            "{}",
            found.max
        );
        assert_eq!((found.asked, found.missing), (2, 1));
        let local = scene.deviation_from_middle(&[Some(truth[0] - scene.middle + off * DVec3::Y)]);
        assert!(
            (local.max - off / size).abs() <= 4.0 * f64::EPSILON * 8.0 / size,
            "{}",
            local.max
        );
        // Answers that are not there are missing.
        assert_eq!((local.asked, local.missing), (2, 1));
    }
}
