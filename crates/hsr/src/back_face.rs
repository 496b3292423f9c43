//! Faces turned away from the viewer, left out before anything else.
//!
//! Of a closed solid whose faces look outward, those that look away from the viewer are hidden by the others. One sign
//! a face tells them. Over all directions of view a face looks away from half of them, so on average half of the
//! primitives are left: half of the work where they are taken one by one, a quarter where they are taken in pairs.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/back-face.svg"))]
#![doc(alias = "culling")]
#![doc(alias = "back-face culling")]

use core::cmp::Ordering;

use ombra_math::camera::Camera;
use ombra_math::exact::dot;
use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::homogeneous::direction;
use ombra_math::mesh::Mesh;
use ombra_math::predicates::{orient_2d, orient_3d};

use crate::pair::Eye;

/// Whether a face with this normal may be seen.
///
/// # Formula
///
/// ```text
/// n·v ≥ 0          n: the normal, out of the solid     v: from the face towards the viewer
/// ```
///
/// # Properties
///
/// The sign is exact, for vectors of any length. Neither needs to be unit. True where one is zero, false where a
/// coordinate is not finite.
///
/// # Pitfalls
///
/// - v is the direction *towards the viewer*. The first slide's sentence says «direction of view», in which the viewer
///   looks: that keeps the faces at the back and leaves out those in front (errata [E13](crate#e13)).
/// - In perspective v is another for every face. The sign of the normal's z in eye coordinates is not the test (errata
///   [E31](crate#e31)): it is that of a parallel view along z. See [`is_front_facing_in_clip_space`].
/// - The normal of a transformed solid is not the transformed normal where the transformation scales unevenly.
///
/// # Examples
///
/// Eye at the origin, looking along −z; a face on the right that leans a little towards +z, and is seen from behind:
///
/// ```
/// use ombra_hsr::back_face::is_front_facing;
/// use ombra_math::glam::DVec3;
///
/// let (eye, place) = (DVec3::ZERO, DVec3::new(10.0, 0.0, -5.0));
/// let normal = DVec3::new(1.0, 0.0, 0.5);
/// assert!(normal.z > 0.0);
/// assert_eq!(normal.dot(eye - place), -7.5);
/// assert!(!is_front_facing(normal, eye - place));
/// ```
///
/// # References
///
/// Grafica 3, «Back Face Culling», «Ottimizzazione: Back-face Culling».
#[doc(alias = "front face")]
#[must_use]
pub fn is_front_facing(normal: DVec3, towards_viewer: DVec3) -> bool {
    dot(direction(normal), direction(towards_viewer)).0 >= 0.0
}

/// The triangles that may be seen from `eye`: all but those turned away.
///
/// # Formula
///
/// ```text
/// eye at a place (w ≠ 0):          (AB × AC)·AE ≥ 0
/// parallel view (w = 0):           (AB × AC)·v ≥ 0        eye = (v, 0), towards the viewer
/// ```
///
/// # Properties
///
/// Exact, from the vertices themselves; the only rounding is that of an eye with w other than 1, once a coordinate.
/// Faces seen edge-on are kept, as n·v = 0 is, and so are triangles without area: neither covers a pixel. Left out are
/// also triangles with a missing vertex or a coordinate that is not finite; all of them for an eye that is none:
/// (0, 0, 0, 0), not finite, or a place beyond the largest double.
///
/// # Pitfalls
///
/// Only what is closed and seen from outside may be culled: of a sheet, or with the eye in the solid, the backs are
/// what is seen.
///
/// # Examples
///
/// The cube of the lectures from (30, 40, 50) shows three faces, six of its twelve triangles:
///
/// ```
/// use ombra_hsr::back_face::visible;
/// use ombra_math::glam::DVec3;
/// use ombra_math::homogeneous::point;
/// use ombra_math::solids::slide_cube;
///
/// let cube = slide_cube();
/// let kept = visible(&cube, point(DVec3::new(30.0, 40.0, 50.0)));
/// assert_eq!(kept.len(), 6);
/// // All of them on x = 10, y = 30 or z = 10.
/// let at = |i: usize, axis: usize| cube.triangle(i).unwrap().map(|p| p[axis]);
/// assert!(kept.iter().all(|&i| at(i, 0) == [10.0; 3] || at(i, 1) == [30.0; 3] || at(i, 2) == [10.0; 3]));
/// ```
///
/// # References
///
/// As [`is_front_facing`].
#[must_use]
pub fn visible(mesh: &Mesh, eye: DVec4) -> Vec<usize> {
    let eye = Eye::new(eye);
    // The sign of (AB × AC)·AE, or of (AB × AC)·v.
    kept(mesh, |[a, b, c]| eye?.turn(a, b, c))
}

/// Whether a triangle of the picture may be seen, by its signed area: its corners in pixels, y down, run clockwise.
///
/// # Formula
///
/// ```text
/// (b.x − a.x)(c.y − a.y) − (b.y − a.y)(c.x − a.x) ≤ 0          y down
/// ```
///
/// # Properties
///
/// Exact for these corners. A triangle without area, a face seen edge-on, is kept. False where a coordinate is not
/// finite.
///
/// # Pitfalls
///
/// With y up the sign is the opposite one. A projection that mirrors the picture, say with left and right exchanged,
/// turns all faces round. And it takes three corners in front of the eye: one that was behind comes out on the wrong
/// side of the picture; [`is_front_facing_in_clip_space`] needs no division.
///
/// # References
///
/// Grafica 3, «Back Face Culling»: after projection, a check of one sign.
#[must_use]
pub fn is_front_facing_on_screen(pixels: [DVec2; 3]) -> bool {
    let [a, b, c] = pixels;
    matches!(orient_2d(a, b, c), Some(Ordering::Less | Ordering::Equal))
}

/// Whether a triangle in clip coordinates may be seen: the test on screen, without its divisions by w.
///
/// # Formula
///
/// ```text
/// | a.x  a.y  a.w |
/// | b.x  b.y  b.w |  ≥ 0          = 2 a.w b.w c.w · the signed area in NDC
/// | c.x  c.y  c.w |
/// ```
///
/// # Properties
///
/// Exact for these corners; also right for a triangle that reaches behind the eye, of whose visible part it
/// speaks. A zero is kept. False where a coordinate is not finite.
///
/// # Pitfalls
///
/// The slide's rule, positive z of the normal, holds for this sign only: that of the triangle's own normal *after*
/// projection, x to the right, y up, z to the viewer. In OpenGL's NDC z grows away from the viewer: there the outward
/// normal of a visible face, taken along as a plane is (π M⁻¹), has a negative z (errata [E31](crate#e31)).
///
/// # References
///
/// Grafica 3, «Back Face Culling». M. Olano, T. Greer, «Triangle scan conversion using 2D homogeneous coordinates»,
/// 1997.
#[must_use]
pub fn is_front_facing_in_clip_space(corners: [DVec4; 3]) -> bool {
    matches!(
        clip_space_side(corners),
        Some(Ordering::Greater | Ordering::Equal)
    )
}

/// The triangles of a mesh that may be seen, by [`is_front_facing_in_clip_space`].
///
/// # Properties
///
/// Agrees with [`visible`] for the camera's eye, save where a face is seen so nearly edge-on that the rounding of
/// its clip coordinates turns it, and where the matrix mirrors the picture: then all faces are turned round.
#[must_use]
pub fn visible_on_screen(mesh: &Mesh, camera: &Camera) -> Vec<usize> {
    kept(mesh, |corners| {
        clip_space_side(corners.map(|p_world| camera.to_clip(p_world)))
    })
}

/// det(a, b, c) of the x, y and w.
fn clip_space_side(corners: [DVec4; 3]) -> Option<Ordering> {
    let [a, b, c] = corners.map(|p| DVec3::new(p.x, p.y, p.w));
    orient_3d(a, b, c, DVec3::ZERO).map(Ordering::reverse)
}

fn kept(mesh: &Mesh, side: impl Fn([DVec3; 3]) -> Option<Ordering>) -> Vec<usize> {
    let is_kept = |&i: &usize| {
        let side = mesh.triangle(i).and_then(&side);
        matches!(side, Some(Ordering::Greater | Ordering::Equal))
    };
    (0..mesh.triangles.len()).filter(is_kept).collect()
}

#[cfg(test)]
mod tests;
