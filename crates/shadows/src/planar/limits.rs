//! What a shadow on a plane must not show: false shadows, and shadow beside its receiver.
//!
//! The line through light and vertex meets the plane wherever the vertex is, so the formula finds a point also where no shadow
//! can be. Two signs tell a true shadow from a false one; a polygon is clipped by them before it is cast, and by its
//! receiver after.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/false-shadow.svg"))]

mod vertices;

use core::cmp::Ordering;

use ombra_clip::sutherland_hodgman::{clip_against_plane, clip_by, clip_homogeneous};
use ombra_math::exact::dot;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;

use self::vertices::{direction_from_light, heights_below_light, homogeneous_shadow};
use super::any_plane::cast;
use super::placement::towards_place;

pub use super::placement::{Placement, classify};

/// The shadow of a polygon on `plane`, as homogeneous points; empty where nothing casts.
///
/// # Formula
///
/// ```text
/// the part of the polygon with   n·V + d ≥ 0     (on the light's side)
///                         and   s − L_w t ≥ 0   (below the light),
/// each vertex cast:  (P, 1), or (L_w V − L, 0), a direction, where it is level with the light
/// ```
///
/// # Properties
///
/// - No false shadow: what is behind the plane or beyond the light is cut off before it is cast.
/// - w = 1 for places. w = 0 for directions: there the shadow runs to infinity, and two such points in a row are the
///   two sides of an unbounded shadow. 0 < w < 1 only for places whose coordinates no double holds.
/// - Each kept vertex casts as by [`cast`](super::cast()).
/// - Empty for fewer than three vertices, a polygon that only touches, a light along the plane, input not finite.
/// - Error: kept vertices none; crossings at most 4 ε of their edge's larger end.
///
/// # Pitfalls
///
/// Clip to the view, or to the receiver with [`cast_onto`], before dividing by w. For a concave polygon that the
/// plane or the light's height cuts into pieces, see
/// [`clip_by`]. A polygon seen edge-on from the light casts a line: its
/// vertices come back, with no area between them.
///
/// # Examples
///
/// A triangle that stands half below the ground, and reaches above the lamp:
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::cast_polygon;
///
/// let triangle = [DVec3::new(0.0, -1.0, 0.0), DVec3::new(2.0, -1.0, 0.0), DVec3::new(1.0, 3.0, 0.0)];
/// let lamp = DVec4::new(1.0, 2.0, 4.0, 1.0);
/// let shadow = cast_polygon(Plane::GROUND, lamp, &triangle);
/// assert_eq!(
///     shadow,
///     [
///         DVec4::new(-0.25, 0.0, -4.0, 0.0),
///         DVec4::new(0.25, 0.0, 0.0, 1.0), // where the triangle enters the ground
///         DVec4::new(1.75, 0.0, 0.0, 1.0),
///         DVec4::new(0.25, 0.0, -4.0, 0.0), // from here the two edges run to infinity
///     ]
/// );
/// ```
///
/// # References
///
/// Olomouc, «Projekční metody», limits (false shadows); Croatian 8.4, projected shadows (object behind the plane,
/// object behind the light).
#[must_use]
pub fn cast_polygon(plane: Plane, light: DVec4, polygon: &[DVec3]) -> Vec<DVec4> {
    if plane.normal == DVec3::ZERO {
        return Vec::new();
    }
    let light = towards_place(light);
    let plane = match dot(plane.coefficients(), light).0.partial_cmp(&0.0) {
        Some(Ordering::Greater) => plane,
        Some(Ordering::Less) => plane.turned(),
        _ => return Vec::new(),
    };
    // A vertex with its height below the light; crossings get the height 0, whatever their rounding.
    let lit = clip_against_plane(polygon, &plane);
    let heights = heights_below_light(plane, light, &lit);
    let lit: Vec<(DVec3, f64)> = lit.into_iter().zip(heights).collect();
    let below = clip_by(
        &lit,
        |(_, height)| height,
        |(a, ha), (b, hb), _, _| {
            let (wa, wb) = (-hb / (ha - hb), ha / (ha - hb));
            (a * wa + b * wb, 0.0)
        },
    );
    if below.iter().all(|&(_, height)| height == 0.0) {
        return Vec::new();
    }
    let shadow = |(v, height): (DVec3, f64)| {
        if height == 0.0 {
            direction_from_light(light, v).extend(0.0)
        } else {
            match cast(plane, light, v) {
                Some(p) => point(p),
                None => homogeneous_shadow(plane, light, v),
            }
        }
    };
    below.into_iter().map(shadow).collect()
}

/// The shadows of a polygon on `plane` under several lights, one a light in their order; empty where nothing casts.
///
/// # Properties
///
/// Lights do not change each other's shadows: each is that of [`cast_polygon`]. What two shadows have in common
/// lacks the light of both.
///
/// - Error: that of `cast_polygon`.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::cast_polygon_each;
///
/// let triangle = [DVec3::Y, DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, 1.0, 1.0)];
/// let lights = [DVec4::Y, DVec4::X, DVec4::new(1.0, 1.0, 0.0, 0.0)];
/// let shadows = cast_polygon_each(Plane::GROUND, &lights, &triangle);
/// assert_eq!(shadows.iter().map(Vec::len).collect::<Vec<_>>(), [3, 0, 3]); // the second is along the ground
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani»; Olomouc, «Ztmavení» (several lights).
#[must_use]
pub fn cast_polygon_each(plane: Plane, lights: &[DVec4], polygon: &[DVec3]) -> Vec<Vec<DVec4>> {
    lights
        .iter()
        .map(|&light| cast_polygon(plane, light, polygon))
        .collect()
}

/// The shadow of a polygon on a flat convex `receiver`, clipped to it; empty where none falls.
///
/// # Formula
///
/// ```text
/// the shadow on the receiver's plane, then against each of its edges AB:  (n × AB)·(X − A) ≥ 0
/// ```
///
/// # Properties
///
/// The receiver's vertices may run either way round. It is two-sided: the shadow falls on the side the light is on.
/// Infinite parts of the shadow are clipped like any others, before the division by w. Results lie inside the
/// receiver to within 2ε of the largest coordinate of the *unclipped* shadow: one that is 10⁶ times as large as the
/// receiver costs six digits. Empty if the receiver has no area, or the receiver or the light is not finite.
///
/// - Error: at most 2 ε of the largest coordinate of the unclipped shadow.
///
/// # Pitfalls
///
/// A receiver that is not convex or not flat gets the part inside all its edges' half-spaces. Without clipping, the
/// shadow of a table hangs in the air beside the floor's edge.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_shadows::planar::cast_onto;
///
/// let tile = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)].map(|(x, z)| DVec3::new(x, 0.0, z));
/// let sheet = tile.map(|p| p + DVec3::new(1.0, 5.0, 1.0));
/// let shadow = cast_onto(&tile, DVec4::Y, &sheet);
/// assert_eq!(shadow.len(), 4); // the quarter 1 ≤ x, z ≤ 2
/// assert!(shadow.iter().all(|p| p.x >= 1.0 && p.x <= 2.0 && p.z >= 1.0 && p.z <= 2.0));
/// ```
///
/// # References
///
/// Olomouc, «Projekční metody»: the shadow polygon may reach beyond its target and must be clipped; Croatian 8.4,
/// projected shadows.
#[doc(alias = "receiver")]
#[must_use]
pub fn cast_onto(receiver: &[DVec3], light: DVec4, polygon: &[DVec3]) -> Vec<DVec3> {
    if !receiver.iter().all(|p| p.is_finite()) {
        return Vec::new();
    }
    let Some(plane) = plane_of(receiver) else {
        return Vec::new();
    };
    let mut shadow = cast_polygon(plane, light, polygon);
    let ends = receiver.iter().skip(1).chain(receiver.first());
    for (&a, &b) in receiver.iter().zip(ends) {
        if let Some(inward) = inward_plane(plane, a, b) {
            shadow = clip_homogeneous(&shadow, inward.coefficients());
        }
    }
    shadow.into_iter().filter_map(project).collect()
}

/// The plane of a flat convex polygon: that of its largest triangle round the first vertex.
fn plane_of(polygon: &[DVec3]) -> Option<Plane> {
    let (&first, rest) = polygon.split_first()?;
    let triangles = rest.iter().zip(rest.iter().skip(1));
    triangles
        .filter_map(|(&b, &c)| {
            // Halved, so that the difference of two huge coordinates stays finite.
            let cross = (b / 2.0 - first / 2.0).cross(c / 2.0 - first / 2.0);
            Some((Plane::of_triangle(first, b, c)?, cross.length()))
        })
        .max_by(|(_, a), (_, b)| a.total_cmp(b))
        .map(|(plane, _)| plane)
}

/// The plane through the edge a b, upright on `plane`, its front inside; `None` for an edge without length.
fn inward_plane(plane: Plane, a: DVec3, b: DVec3) -> Option<Plane> {
    let normal = plane.normal / plane.normal.abs().max_element();
    let edge = b / 2.0 - a / 2.0;
    let inward = normal.cross(edge / edge.abs().max_element());
    Plane::through(a, inward)
}

#[cfg(test)]
mod tests;
