//! Vertex normals.

mod cancelled;

use super::Mesh;
use crate::scaling::normalised;
use crate::triangle::{scaled_normal, unit};
use glam::DVec3;

/// How much each face counts in a vertex normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Weighting {
    /// All faces alike.
    Plain,
    /// Large faces more: by area.
    Area,
    /// Wide corners more: by the face's angle at the vertex.
    Angle,
}

impl Mesh {
    /// Unit normal of each vertex, averaged from the faces around it.
    ///
    /// # Formula
    ///
    /// ```text
    /// n = Σ wᵢ nᵢ, made unit     nᵢ the unit normals of the faces at the vertex
    /// wᵢ = 1 (plain), the face's area, or its angle at the vertex
    /// ```
    ///
    /// # Properties
    ///
    /// Holds at every scale, needles included, and depends neither on the order of the faces nor on the corners they
    /// begin with, but for rounding. Only the angle weighting is the same however a flat side is cut into triangles.
    ///
    /// With κ = Σ wᵢ / |Σ wᵢ nᵢ|, which tells how much of the faces cancels, the normal is off in direction and length by
    ///
    /// - Error: at most 4 ε + 2⁻³⁸ κ; for κ > 2¹¹ at most 4 ε + 2⁻⁹⁰ κ, by area 4 ε.
    ///
    /// # Pitfalls
    ///
    /// At (0, 20, 0) of the slide's cube two triangles of one side meet, and one of the other: the plain mean is
    /// (−1, −2, −2)/3, not (−1, −1, −1)/√3.
    ///
    /// # Errors
    ///
    /// A face without area or with a coordinate that is not finite counts for nothing. A vertex that has no other
    /// face, or whose faces cancel, gets `DVec3::ZERO`: by area where Σ wᵢ nᵢ is exactly 0, else where it is 0 to
    /// 2⁻⁹⁰ Σ wᵢ.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::mesh::Weighting;
    /// use ombra_math::solids::slide_cube;
    ///
    /// let cube = slide_cube();
    /// assert_eq!(cube.vertex_normals(Weighting::Plain)[0], DVec3::new(-1.0, -2.0, -2.0) / 3.0);
    /// let corner = DVec3::splat(-1.0).normalize();
    /// assert!((cube.vertex_normals(Weighting::Angle)[0] - corner).length() < 1e-15);
    /// ```
    ///
    /// # References
    ///
    /// Olomouc, «Gouraud shading». G. Thürmer and C. Wüthrich, «Computing Vertex Normals from Polygonal
    /// Facets», 1998: the angle weighting.
    #[doc(alias = "smooth normals")]
    #[must_use]
    pub fn vertex_normals(&self, weighting: Weighting) -> Vec<DVec3> {
        let mut sums = vec![Weighted::default(); self.positions.len()];
        for (triangle, corners) in self.faces() {
            // The face's normal n · 2ᵉ, and made unit; a face without area has none.
            let [a, b, c] = corners;
            let (n, exponent) = scaled_normal(a, b, c);
            let Some(unit_n) = unit(n) else { continue };
            // At each corner, w times the unit normal.
            for (k, v) in triangle.into_iter().enumerate() {
                sums[v as usize].add(match weighting {
                    Weighting::Plain => (unit_n, 0),
                    Weighting::Area => (n, exponent),
                    Weighting::Angle => {
                        let (w, e) = angle(from_corner(corners, k), n.length(), exponent);
                        (unit_n * w, e)
                    }
                });
            }
        }
        let mut normals: Vec<_> = sums
            .iter()
            .map(|sum| unit(sum.sum).unwrap_or(DVec3::ZERO))
            .collect();
        self.mend_cancelled(weighting, &sums, &mut normals);
        normals
    }

    /// The faces that are there, with their corners.
    fn faces(&self) -> impl Iterator<Item = ([u32; 3], [DVec3; 3])> {
        let triangles = self.triangles.iter().enumerate();
        triangles.filter_map(|(i, &triangle)| Some((triangle, self.triangle(i)?)))
    }

    /// Sums once more, with twice the digits or exactly, where rounding might have picked the direction.
    fn mend_cancelled(&self, weighting: Weighting, sums: &[Weighted], normals: &mut [DVec3]) {
        if !sums.iter().any(Weighted::is_in_doubt) {
            return;
        }
        let mut faces = Vec::new();
        for (triangle, corners) in self.faces() {
            for (k, v) in triangle.into_iter().enumerate() {
                if sums[v as usize].is_in_doubt() {
                    faces.push((v, from_corner(corners, k)));
                }
            }
        }
        faces.sort_by_key(|&(v, _)| v);
        for faces in faces.chunk_by(|a, b| a.0 == b.0) {
            if let Some(&(v, _)) = faces.first() {
                normals[v as usize] = cancelled::normal(weighting, faces.iter().map(|f| f.1));
            }
        }
    }
}

/// Σ wᵢ nᵢ at a vertex as sum · 2ᵉ, e that of the largest term: none overflows or vanishes.
#[derive(Clone, Copy)]
struct Weighted {
    sum: DVec3,
    /// The sum of the terms' sizes, in the same unit.
    size: f64,
    exponent: i32,
}

impl Default for Weighted {
    fn default() -> Self {
        Self {
            sum: DVec3::ZERO,
            size: 0.0,
            exponent: i32::MIN,
        }
    }
}

impl Weighted {
    fn add(&mut self, (term, exponent): (DVec3, i32)) {
        let mut term = term;
        if exponent > self.exponent {
            if self.size != 0.0 {
                let down = libm::scalbn(1.0, self.exponent.saturating_sub(exponent));
                self.sum *= down;
                self.size *= down;
            }
            self.exponent = exponent;
        } else if exponent < self.exponent {
            term *= libm::scalbn(1.0, exponent - self.exponent);
        }
        self.sum += term;
        self.size += term.abs().max_element();
    }

    /// Whether the terms cancelled but for 2⁻¹⁰ of them.
    fn is_in_doubt(&self) -> bool {
        self.sum.abs().max_element() < self.size / 1024.0
    }
}

/// The corners with the `k`-th first.
fn from_corner(mut corners: [DVec3; 3], k: usize) -> [DVec3; 3] {
    corners.rotate_left(k);
    corners
}

/// The angle at the first corner of a triangle whose normal AB × AC has the length n · 2ᵉ, as w · 2ᵏ.
///
/// # Formula
///
/// ```text
/// atan2(|AB × AC|, AB·AC)
/// ```
///
/// The product keeps its digits where the sides are almost parallel, and the angle with it.
fn angle([a, b, c]: [DVec3; 3], n: f64, exponent: i32) -> (f64, i32) {
    let towards = |p: DVec3| {
        let d = p - a;
        // Halves, where the difference itself is too long.
        let (d, halved) = if d.is_finite() {
            (d, 0)
        } else {
            (p * 0.5 - a * 0.5, 1)
        };
        let (d, exponent) = normalised(d.to_array());
        (DVec3::from(d), exponent + halved)
    };
    let ((u, u_exponent), (v, v_exponent)) = (towards(b), towards(c));
    let (dot, down) = (u.dot(v), exponent - u_exponent - v_exponent);
    if down < SINE_IS_ANGLE && dot > 0.0 {
        (n / dot, down)
    } else {
        (libm::atan2(libm::scalbn(n, down), dot), 0)
    }
}

/// Below this power of two, tangent and angle are the same to 100 bits.
const SINE_IS_ANGLE: i32 = -60;

#[cfg(test)]
mod tests;
