//! From a mesh to triangles of the picture: transformed, clipped where need be, snapped to sub-pixels.

use fearless_simd::{Level, dispatch};
use ombra_clip::homogeneous::{Vertex, clip_polygon};
use ombra_math::camera::Camera;
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::view::Viewport;
use ombra_math::work::{Count, Counter};
use ombra_raster::depth_format::DepthFormat;
use ombra_raster::triangle_setup::Corner;

use super::error::{DrawError, MAX_SIDE};

/// Corners lie at most 2¹⁶ pixels from the middle of the picture.
const GUARD_LOG: u32 = 16;

/// Where each corner of a piece of a triangle is in the triangle: the shares of its three corners.
pub(super) type Weights = [[f64; 3]; 3];
/// The weights of a triangle in one piece.
const WHOLE: Weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The planes that a vertex is outside of; CUT where its triangles must be clipped.
pub(super) type Outcode = u8;
const PLANES: Outcode = 0b0011_1111;
const CUT: Outcode = 0b0100_0000;

/// The way from clip space to the picture.
#[derive(Clone, Copy, Debug)]
struct Screen {
    /// How far beyond the picture corners may lie without being clipped, in half widths and half heights: a power of
    /// two, so that scaling by it is exact.
    guard: DVec2,
    width: f64,
    height: f64,
}

impl Screen {
    fn new(viewport: Viewport) -> Self {
        let guard = |side: u32| {
            let log = side.clamp(1, MAX_SIDE).next_power_of_two().trailing_zeros();
            f64::from(1u32 << (GUARD_LOG + 1 - log))
        };
        Self {
            guard: DVec2::new(guard(viewport.width), guard(viewport.height)),
            width: f64::from(viewport.width),
            height: f64::from(viewport.height),
        }
    }

    /// Whether all came out finite. Inlined where it is compiled for the processor's vector instructions.
    #[inline(always)]
    fn transform(
        &self,
        matrix: DMat4,
        depth_row: DVec4,
        positions: &[DVec3],
        corners: &mut [Corner],
        codes: &mut [Outcode],
    ) -> bool {
        let mut all_finite = true;
        for (&position, (corner, code)) in positions.iter().zip(corners.iter_mut().zip(codes)) {
            let p_clip = matrix * position.extend(1.0);
            all_finite &= p_clip.is_finite();
            *code = self.outcode(p_clip);
            *corner = self.corner(p_clip, along(depth_row, position));
        }
        all_finite
    }

    /// Which planes of the view volume `p` is outside of, and whether what it belongs to must be clipped.
    #[inline(always)]
    fn outcode(&self, p: DVec4) -> Outcode {
        let DVec4 { x, y, z, w } = p;
        let [gx, gy] = [self.guard.x * w, self.guard.y * w];
        let inside = (z >= -w) & (z <= w) & (x.abs() <= gx) & (y.abs() <= gy) & (w > 0.0);
        u8::from(x < -w)
            | u8::from(x > w) << 1
            | u8::from(y < -w) << 2
            | u8::from(y > w) << 3
            | u8::from(z < -w) << 4
            | u8::from(z > w) << 5
            | u8::from(!inside) << 6
    }

    /// Where a point with w > 0 inside the guard band comes out, of which `depth` is w times the depth; any other gets
    /// some place.
    #[inline(always)]
    fn corner(&self, p: DVec4, depth: f64) -> Corner {
        let [x, y] = [p.x / p.w, p.y / p.w];
        let x = 0.5 * (x + 1.0) * self.width;
        let y = 0.5 * (1.0 - y) * self.height;
        // In the view volume, but rounded otherwise than the clip coordinates.
        let value = if depth > 0.0 { depth / p.w } else { 0.0 };
        Corner::snapped(DVec2::new(x, y), value, p.w)
    }
}

/// The row of coefficients that gives w times the depth, as the format wants it.
///
/// ```text
/// w d = (w + z) / 2 = ½ (m₄ + m₃)·P          mᵢ: row i of the matrix
/// reversed: ½ (m₄ − m₃)·P
/// ```
///
/// w − z from clip coordinates, both rounded, would leave nothing far away, where it is small beside them. Most of it is
/// known before: in a perspective view m₄ − m₃ is all but a constant, and the depth all but a multiple of 1 / w.
fn depth_row<F: DepthFormat>(matrix: DMat4) -> DVec4 {
    let (z, w) = (0.5 * matrix.row(2), 0.5 * matrix.row(3));
    if F::REVERSED { w - z } else { w + z }
}

/// A row of the matrix times a position.
#[inline(always)]
fn along(row: DVec4, p: DVec3) -> f64 {
    row.x * p.x + row.y * p.y + row.z * p.z + row.w
}

/// A mesh as a camera sees it.
pub(super) struct Projected<'a> {
    pub(super) triangles: &'a [[u32; 3]],
    positions: &'a [DVec3],
    matrix: DMat4,
    depth_row: DVec4,
    screen: Screen,
    /// The vector instructions to draw with; they make no difference to the picture.
    pub(super) level: Level,
    corners: Vec<Corner>,
    codes: Vec<Outcode>,
}

impl<'a> Projected<'a> {
    /// Checks the input and transforms every vertex once.
    pub(super) fn new<F: DepthFormat>(
        mesh: &'a Mesh,
        camera: &Camera,
        work: &mut impl Count,
    ) -> Result<Self, DrawError> {
        Self::at_level::<F>(mesh, camera, Level::new(), work)
    }

    /// [`Self::new`] with a choice of vector instructions.
    pub(super) fn at_level<F: DepthFormat>(
        mesh: &'a Mesh,
        camera: &Camera,
        level: Level,
        work: &mut impl Count,
    ) -> Result<Self, DrawError> {
        check_indices(mesh)?;
        let matrix = camera.view_projection;
        for (i, &value) in matrix.to_cols_array().iter().enumerate() {
            if !value.is_finite() {
                let (row, column) = (i % 4, i / 4);
                return Err(DrawError::Matrix { row, column, value });
            }
        }
        let vertices = mesh.positions.len();
        let mut projected = Self {
            triangles: &mesh.triangles,
            positions: &mesh.positions,
            matrix,
            depth_row: depth_row::<F>(matrix),
            screen: Screen::new(camera.viewport),
            level,
            corners: vec![Corner::default(); vertices],
            codes: vec![0; vertices],
        };
        projected.transform()?;
        work.add(Counter::Vertices, vertices as u64);
        Ok(projected)
    }

    fn transform(&mut self) -> Result<(), DrawError> {
        let (rows, screen, level) = ((self.matrix, self.depth_row), self.screen, self.level);
        let part = |positions: &[DVec3], corners: &mut [Corner], codes: &mut [Outcode]| {
            let (matrix, row) = rows;
            dispatch!(level, _ => screen.transform(matrix, row, positions, corners, codes))
        };
        let all_finite = transform_all(self.positions, &mut self.corners, &mut self.codes, part);
        if all_finite {
            return Ok(());
        }
        for (vertex, &position) in self.positions.iter().enumerate() {
            if !position.is_finite() {
                return Err(DrawError::Position { vertex, position });
            }
            if !(self.matrix * position.extend(1.0)).is_finite() {
                return Err(DrawError::Overflow { vertex, position });
            }
        }
        Ok(())
    }

    /// Where vertex `i` comes out, if it is not clipped.
    #[cfg(test)]
    pub(super) fn corner(&self, i: usize) -> Option<Corner> {
        self.corners.get(i).copied()
    }

    #[inline(always)]
    fn code(&self, vertex: u32) -> Outcode {
        let code = self.codes.get(vertex as usize);
        code.copied().unwrap_or(PLANES)
    }

    /// Triangle `i` in the picture: no piece if it is outside the view volume, one if it need not be clipped. What
    /// clipping makes is put into `cut`.
    #[inline(always)]
    pub(super) fn pieces<'b>(
        &'b self,
        i: usize,
        cut: &'b mut Pieces,
        work: &mut impl Count,
    ) -> PiecesRef<'b> {
        let nothing = PiecesRef {
            corners: &[],
            triangles: &[],
            weights: &[],
        };
        let Some(triangle @ &[a, b, c]) = self.triangles.get(i) else {
            return nothing;
        };
        let [a, b, c] = [self.code(a), self.code(b), self.code(c)];
        if a & b & c & PLANES != 0 {
            return nothing;
        }
        if (a | b | c) & CUT == 0 {
            return PiecesRef {
                corners: &self.corners,
                triangles: core::slice::from_ref(triangle),
                weights: &[WHOLE],
            };
        }
        self.clip(*triangle, cut, work);
        PiecesRef {
            corners: &cut.corners,
            triangles: &cut.triangles,
            weights: &cut.weights,
        }
    }

    /// The rows that triangle `i` may have pixels in; all where it must be clipped.
    #[cfg(feature = "parallel")]
    pub(super) fn rows(&self, &[a, b, c]: &[u32; 3], height: u32) -> core::ops::Range<u32> {
        use ombra_raster::triangle_setup::centres;
        let codes = [self.code(a), self.code(b), self.code(c)];
        let y = |i: u32| self.corners.get(i as usize).map_or(0, |corner| corner.y);
        let [a, b, c] = [y(a), y(b), y(c)];
        match codes
            .iter()
            .fold((PLANES, 0), |(all, any), code| (all & code, any | code))
        {
            (0, any) if any & CUT == 0 => centres(a.min(b).min(c), a.max(b).max(c), height),
            (0, _) => 0..height,
            _ => 0..0,
        }
    }

    /// The pieces of a triangle that the near plane, the far plane or the guard band cut: a fan.
    #[cold]
    fn clip(&self, triangle: [u32; 3], cut: &mut Pieces, work: &mut impl Count) {
        let scale = DVec4::new(self.screen.guard.x, self.screen.guard.y, 1.0, 1.0);
        let mut polygon = [Vertex {
            position: DVec4::ZERO,
            attributes: [0.0; 4],
        }; 3];
        for ((vertex, index), [a, b, c]) in polygon.iter_mut().zip(triangle).zip(WHOLE) {
            let position = self
                .positions
                .get(index as usize)
                .copied()
                .unwrap_or_default();
            *vertex = Vertex {
                position: self.matrix * position.extend(1.0) / scale,
                attributes: [a, b, c, along(self.depth_row, position)],
            };
        }
        let clipped = clip_polygon(&polygon);
        let new = clipped.iter().filter(|v| !polygon.contains(v)).count();
        work.add(Counter::Vertices, new as u64);
        let corner_of = |v: &Vertex<4>| {
            let [.., depth] = v.attributes;
            self.screen.corner(v.position * scale, depth)
        };
        cut.corners.clear();
        cut.corners.extend(clipped.iter().map(corner_of));
        cut.triangles.clear();
        cut.weights.clear();
        let fan = (1u32..).zip(clipped.iter().skip(1).zip(clipped.iter().skip(2)));
        for ((i, (second, third)), first) in fan.zip(clipped.first().into_iter().cycle()) {
            cut.triangles.push([0, i, i + 1]);
            cut.weights.push([first, second, third].map(|v| {
                let [a, b, c, _] = v.attributes;
                [a, b, c]
            }));
        }
    }
}

fn check_indices(mesh: &Mesh) -> Result<(), DrawError> {
    let vertices = mesh.positions.len();
    let greatest = mesh
        .triangles
        .iter()
        .fold(0, |greatest, &[a, b, c]| greatest.max(a).max(b).max(c));
    if mesh.triangles.is_empty() || (greatest as usize) < vertices {
        return Ok(());
    }
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
            return Err(DrawError::Index {
                triangle,
                index,
                vertices,
            });
        }
    }
    Ok(())
}

/// How many threads to use for so many vertices or triangles: a few are done by one.
#[cfg(feature = "parallel")]
pub(super) fn threads_for(items: usize) -> usize {
    const WORTH_IT: usize = 1024;
    if items < WORTH_IT {
        1
    } else {
        rayon::current_num_threads()
    }
}

/// Calls `part` for all vertices, in parts on several threads; whether it always answered yes.
fn transform_all(
    positions: &[DVec3],
    corners: &mut [Corner],
    codes: &mut [Outcode],
    part: impl Fn(&[DVec3], &mut [Corner], &mut [Outcode]) -> bool + Sync,
) -> bool {
    #[cfg(feature = "parallel")]
    if threads_for(positions.len()) > 1 {
        use rayon::prelude::*;
        const CHUNK: usize = 4096;
        let out = corners
            .par_chunks_mut(CHUNK)
            .zip(codes.par_chunks_mut(CHUNK));
        let parts = positions.par_chunks(CHUNK).zip(out);
        return parts
            .map(|(positions, (corners, codes))| part(positions, corners, codes))
            .reduce(|| true, |a, b| a && b);
    }
    part(positions, corners, codes)
}

/// The pieces of a triangle.
#[derive(Debug, Default)]
pub(super) struct Pieces {
    corners: Vec<Corner>,
    triangles: Vec<[u32; 3]>,
    weights: Vec<Weights>,
}

/// The pieces of a triangle, wherever they are kept.
#[derive(Clone, Copy)]
pub(super) struct PiecesRef<'a> {
    corners: &'a [Corner],
    triangles: &'a [[u32; 3]],
    weights: &'a [Weights],
}

impl<'a> PiecesRef<'a> {
    /// The corners of each piece, and their weights.
    #[inline(always)]
    pub(super) fn iter(self) -> impl Iterator<Item = ([&'a Corner; 3], &'a Weights)> {
        let corners = self.corners;
        self.triangles
            .iter()
            .zip(self.weights)
            .filter_map(move |(&[a, b, c], weights)| {
                let at = |i: u32| corners.get(i as usize);
                Some(([at(a)?, at(b)?, at(c)?], weights))
            })
    }
}
