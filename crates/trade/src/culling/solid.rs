//! A closed solid before the eye, and its faces that look towards it.

use ombra_hsr::back_face::visible;
use ombra_hsr::z_buffer::Cull;
use ombra_math::glam::{DAffine3, DQuat, DVec3};
use ombra_math::mesh::Mesh;
use ombra_math::solids;
use ombra_math::work::Count;
use ombra_raster::buffers::image::Luma;

use crate::deviation::Verdict;
use crate::hidden::{Answer, EYE, TrianglesInView};

/// The middle of the solid. Beside the axis, so that no edge runs through a column of centres.
const MIDDLE: DVec3 = DVec3::new(0.37, -0.29, -6.0);
/// Its radius.
const RADIUS: f64 = 3.0;

/// A solid, and its pictures without culling.
pub struct Solid {
    pub scene: TrianglesInView,
    by_z_buffer: Answer,
    /// `None` where pairs are too many.
    by_object_space: Answer,
}

impl Solid {
    /// With pairs of faces compared, or not.
    pub fn new(mesh: Mesh, side: u32, pairs: bool) -> Self {
        let scene = TrianglesInView::new(mesh, side);
        Self {
            by_z_buffer: scene.z_buffer(Cull::Nothing, &mut ()),
            by_object_space: pairs.then(|| scene.object_space(&mut ())).flatten(),
            scene,
        }
    }

    /// The z-buffer of the faces that look towards the eye, with the vertices that they have.
    pub fn left_out_before(&self, work: &mut impl Count) -> Answer {
        let kept = visible(&self.scene.mesh, EYE);
        let part = part(&self.scene.mesh, &kept);
        let numbers: Vec<_> = kept.iter().map(|&i| Luma([i as u32])).collect();
        self.scene.z_buffered(&part, &numbers, Cull::Nothing, work)
    }

    /// Object space among the faces that look towards the eye.
    pub fn culled_object_space(&self, work: &mut impl Count) -> Answer {
        self.scene
            .object_space_of(&visible(&self.scene.mesh, EYE), work)
    }

    /// Of a z-buffer's picture.
    pub fn verdict(&self, answer: &Answer) -> Verdict {
        self.against(&self.by_z_buffer, answer)
    }

    /// Of a picture by object space.
    pub fn verdict_of_object_space(&self, answer: &Answer) -> Verdict {
        self.against(&self.by_object_space, answer)
    }

    /// Wrong pixels, and pixels that are unlike those of the picture without culling.
    fn against(&self, plain: &Answer, answer: &Answer) -> Verdict {
        let pixels = |picture: &Answer| {
            picture
                .as_ref()
                .map_or_else(Vec::new, |p| p.as_raw().clone())
        };
        let (shown, plain) = (pixels(answer), pixels(plain));
        let unlike = shown.iter().zip(&plain).filter(|(a, b)| a != b).count();
        Verdict {
            deviation: self.scene.deviation(answer),
            faults: vec![("unlike without culling", unlike as u64)],
        }
    }
}

/// The triangles `kept` of a mesh, with the vertices that they name and no others.
fn part(mesh: &Mesh, kept: &[usize]) -> Mesh {
    const UNUSED: u32 = u32::MAX;
    let mut renamed = vec![UNUSED; mesh.positions.len()];
    let mut positions = Vec::with_capacity(mesh.positions.len());
    let mut rename = |vertex: u32| {
        let name = renamed.get_mut(vertex as usize)?;
        if *name == UNUSED {
            *name = positions.len() as u32;
            positions.push(*mesh.positions.get(vertex as usize)?);
        }
        Some(*name)
    };
    let triangles = kept
        .iter()
        .filter_map(|&i| {
            let &[a, b, c] = mesh.triangles.get(i)?;
            Some([rename(a)?, rename(b)?, rename(c)?])
        })
        .collect();
    Mesh {
        positions,
        triangles,
    }
}

/// A sphere of `parts` stacks and as many slices, turned so that its poles are in sight and out of it.
pub fn sphere(parts: u32) -> Mesh {
    before_the_eye(solids::sphere(RADIUS, parts, parts).unwrap_or_default())
}

/// A torus of `parts` parts around and across, seen from the side, so that it hides parts of itself.
pub fn torus(parts: u32) -> Mesh {
    before_the_eye(solids::torus(0.7 * RADIUS, 0.3 * RADIUS, parts, parts).unwrap_or_default())
}

fn before_the_eye(mut mesh: Mesh) -> Mesh {
    let turn = DQuat::from_xyzw(0.25, 0.2, 0.15, 0.94).normalize();
    let place = DAffine3::from_rotation_translation(turn, MIDDLE);
    for position in &mut mesh.positions {
        *position = place.transform_point3(*position);
    }
    mesh
}
