//! Vertex normals.

use super::Mesh;
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
    /// Holds at every scale. Only the angle weighting is the same however a flat side is cut into triangles.
    ///
    /// # Pitfalls
    ///
    /// At (0, 20, 0) of the slide's cube two triangles of one side meet, and one of the other: the plain mean is
    /// (−1, −2, −2)/3, not (−1, −1, −1)/√3. Where faces nearly cancel, rounding picks the direction.
    ///
    /// # Errors
    ///
    /// A face without area or with a coordinate that is not finite counts for nothing. A vertex that has no other
    /// face, or whose faces cancel, gets `DVec3::ZERO`.
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
    #[must_use]
    pub fn vertex_normals(&self, weighting: Weighting) -> Vec<DVec3> {
        let faces = || {
            (0..self.triangles.len()).filter_map(|i| {
                let corners = self.triangle(i)?;
                let [a, b, c] = corners;
                let (n, exponent) = scaled_normal(a, b, c);
                Some((self.triangles[i], corners, n, exponent, unit(n)?))
            })
        };
        // Areas are summed relative to the largest at the vertex, so that none overflows or vanishes.
        let mut largest = vec![i32::MIN; self.positions.len()];
        if weighting == Weighting::Area {
            for (triangle, _, _, exponent, _) in faces() {
                for v in triangle {
                    let at_vertex = &mut largest[v as usize];
                    *at_vertex = exponent.max(*at_vertex);
                }
            }
        }
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (triangle, corners, n, exponent, unit_n) in faces() {
            for (k, v) in triangle.into_iter().enumerate() {
                let v = v as usize;
                sums[v] += match weighting {
                    Weighting::Plain => unit_n,
                    Weighting::Area => n * libm::scalbn(1.0, exponent - largest[v]),
                    Weighting::Angle => {
                        unit_n * angle(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3])
                    }
                };
            }
        }
        sums.into_iter()
            .map(|sum| unit(sum).unwrap_or(DVec3::ZERO))
            .collect()
    }
}

/// The angle at `a` of the triangle `a`, `b`, `c`.
fn angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    // Halves, where a difference itself is too long.
    let towards = |p: DVec3| {
        if (p - a).is_finite() {
            unit(p - a)
        } else {
            unit(p * 0.5 - a * 0.5)
        }
    };
    match (towards(b), towards(c)) {
        (Some(u), Some(v)) => libm::atan2(u.cross(v).length(), u.dot(v)),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solids;

    const EPS: f64 = f64::EPSILON;

    /// Exercise math3: the corner's normal under each weighting.
    #[test]
    fn the_slide_cubes_corners() {
        let cube = solids::slide_cube();
        assert_eq!(
            cube.vertex_normals(Weighting::Plain)[0],
            DVec3::new(-1.0, -2.0, -2.0) / 3.0
        );
        // All triangles are alike, so area changes nothing.
        let by_area = cube.vertex_normals(Weighting::Area);
        assert!((by_area[0] - DVec3::new(-1.0, -2.0, -2.0) / 3.0).length() <= 4.0 * EPS);
        let middle = DVec3::new(5.0, 25.0, 5.0);
        for (n, p) in cube
            .vertex_normals(Weighting::Angle)
            .into_iter()
            .zip(&cube.positions)
        {
            let corner = (p - middle).signum() / 3f64.sqrt();
            assert!((n - corner).length() <= 4.0 * EPS, "{p}: {n}");
        }
    }

    #[test]
    fn weights_are_what_they_say() {
        // At the origin: a face with normal +z, area a, right angle; one with normal +x, area b, angle of 45°.
        let (long, s) = (7.0, 3.0);
        let mesh = Mesh {
            positions: vec![
                DVec3::ZERO,
                DVec3::X * s,
                DVec3::Y * long,
                DVec3::Y * 5.0,
                DVec3::new(0.0, 5.0, 5.0),
            ],
            triangles: vec![[0, 1, 2], [0, 3, 4]],
        };
        for (weighting, z, x) in [
            (Weighting::Plain, 1.0, 1.0),
            (Weighting::Area, s * long / 2.0, 12.5),
            (Weighting::Angle, 2.0, 1.0),
        ] {
            let expected = DVec3::new(x, 0.0, z).normalize();
            for scale in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
                let mut scaled = mesh.clone();
                scaled.positions.iter_mut().for_each(|p| *p *= scale);
                let n = scaled.vertex_normals(weighting)[0];
                // Scaling rounds each coordinate once.
                assert!(
                    (n - expected).length() <= 8.0 * EPS,
                    "{weighting:?} {scale}: {n}"
                );
            }
        }
    }
}
