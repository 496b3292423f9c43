//! The techniques, each over all vertices of a scene. The matrix forms, which `ombra-shadows` leaves to a pipeline, count
//! where they multiply.

use ombra_math::glam::{DVec3, Vec3};
use ombra_math::work::{Count, Counter};
use ombra_shadows::planar::{counted, textbook};

use super::casts::Casts;

/// M V, divided by w where w > 0.
pub fn matrix_f64(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    let m = scene.matrix;
    scene.each(|v| {
        let p = m.x_axis * v.x + m.y_axis * v.y + m.z_axis * v.z + m.w_axis;
        count_product(work, 4);
        let q = (p.w > 0.0).then(|| {
            work.add(Counter::Divisions, 3);
            p.truncate() / p.w
        });
        q.filter(|q| q.is_finite())
    })
}

/// M V in f32, divided by w where w > 0.
pub fn matrix_f32(scene: &Casts, work: &mut impl Count) -> Vec<Option<Vec3>> {
    let m = scene.matrix_f32;
    let vertices = scene.vertices_f32.iter();
    let shadow = |v: &Vec3| {
        let p = m.x_axis * v.x + m.y_axis * v.y + m.z_axis * v.z + m.w_axis;
        count_product(work, 4);
        let q = (p.w > 0.0).then(|| {
            work.add(Counter::Divisions, 3);
            p.truncate() / p.w
        });
        q.filter(|q| q.is_finite())
    };
    vertices.map(shadow).collect()
}

/// The affine matrix of the light's direction: w is 1, and nothing is divided.
pub fn directional_f64(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    let [x, y, z, w] = scene.directional;
    scene.each(|v| {
        let p = x * v.x + y * v.y + z * v.z + w;
        count_product(work, 3);
        Some(p).filter(|p| p.is_finite())
    })
}

/// (s V − t L) / (s − L_w t).
pub fn quotient_f64(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    scene.each(|v| textbook::by_quotient(scene.plane, scene.light, v, work))
}

/// L + k (V − L), or V − k L for a light at infinity.
pub fn parameter_f64(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    scene.each(|v| textbook::by_parameter(scene.plane, scene.light, v, work))
}

/// Decided exactly, rounded once.
pub fn cast(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    scene.each(|v| counted::cast(scene.plane, scene.light, v, work))
}

/// The quotient form with the origin in the middle of the scene, where the shadows stay.
pub fn moved_origin(scene: &Casts, work: &mut impl Count) -> Vec<Option<DVec3>> {
    scene.each(|v| {
        work.add(Counter::Additions, 3);
        textbook::by_quotient(scene.local_plane, scene.local_light, v - scene.middle, work)
    })
}

/// A vertex (x, y, z, 1) times a matrix of that many rows.
fn count_product(work: &mut impl Count, rows: u64) {
    work.add(Counter::Vertices, 1);
    work.add(Counter::Multiplications, 3 * rows);
    work.add(Counter::Additions, 3 * rows);
}
