//! Meshes of rings of vertices: how spheres, tori and the teapot are put together.

use glam::DVec3;

use crate::mesh::Mesh;

/// A mesh that grows ring by ring; a ring of one vertex is a pole.
///
/// Each ring runs counter-clockwise as seen from the rings before it, so that the faces between look outwards.
#[derive(Default)]
pub(super) struct Rings {
    pub(super) mesh: Mesh,
    /// First vertex of the last ring, and how many it has.
    last: Option<(u32, u32)>,
}

impl Rings {
    pub(super) fn push(&mut self, ring: impl IntoIterator<Item = DVec3>) {
        let first = self.mesh.positions.len() as u32;
        self.mesh.positions.extend(ring);
        let ring = (first, self.mesh.positions.len() as u32 - first);
        if let Some(last) = self.last.replace(ring) {
            self.join(last, ring);
        }
    }

    /// Joins the last ring to the first, which must be as long.
    pub(super) fn close(&mut self) {
        if let Some(last) = self.last {
            self.join(last, (0, last.1));
        }
    }

    /// Begins another piece.
    pub(super) fn cut(&mut self) {
        self.last = None;
    }

    fn join(&mut self, (above, count_above): (u32, u32), (below, count_below): (u32, u32)) {
        let count = count_above.max(count_below);
        for i in 0..count {
            let next = (i + 1) % count;
            if count_below > 1 {
                let top = if count_above > 1 { above + i } else { above };
                self.mesh.triangles.push([top, below + i, below + next]);
            }
            if count_above > 1 {
                let bottom = if count_below > 1 { below + next } else { below };
                self.mesh.triangles.push([above + i, bottom, above + next]);
            }
        }
    }
}
