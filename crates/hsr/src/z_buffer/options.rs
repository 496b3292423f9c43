//! What is drawn with: colours, blending, culling.

use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_raster::triangle_setup::Cull;

use super::error::{DrawError, check_size};

/// Where the colour of a fragment comes from.
///
/// For a picture of triangle numbers, give each triangle its own: `Luma([i])`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colours<'a, P> {
    /// All triangles have this one.
    One(P),
    /// One for each triangle of the mesh.
    PerTriangle(&'a [P]),
    /// One for each vertex of the mesh, interpolated over the triangle in space, not in the picture. A number that is
    /// NaN or ∞ at a vertex is NaN or ∞ in its triangles.
    PerVertex(&'a [P]),
}

/// What a fragment nearer than the pixel's depth does to its colour. Its depth is stored in either case.
#[doc(alias = "alpha blending")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Blend {
    /// Takes its place.
    #[default]
    Replace,
    /// Is laid over it, as opaque as its alpha says: then the picture depends on the order of the triangles.
    Over,
}

/// How to draw; the default draws both sides of every triangle, opaque.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Options {
    /// Which triangles are left out.
    pub cull: Cull,
    /// What a fragment does to the colour.
    pub blend: Blend,
}

/// Whether both buffers have the viewport's size, and there are as many colours as there must be.
pub(super) fn check<P>(
    mesh: &Mesh,
    camera: &Camera,
    colours: &Colours<'_, P>,
    buffers: [(u32, u32); 2],
) -> Result<(), DrawError> {
    for size in buffers {
        check_size(camera, size)?;
    }
    let (found, expected, of) = match colours {
        Colours::One(_) => return Ok(()),
        Colours::PerTriangle(colours) => (colours.len(), mesh.triangles.len(), "triangles"),
        Colours::PerVertex(colours) => (colours.len(), mesh.positions.len(), "vertices"),
    };
    if found == expected {
        return Ok(());
    }
    Err(DrawError::Colours {
        found,
        expected,
        of,
    })
}
