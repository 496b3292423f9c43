//! Shadows of polygons, clipped so that none is false and none lies outside its receiver.

use core::cmp::Ordering;

use ombra_clip::sutherland_hodgman::{clip_against_plane, clip_by, clip_homogeneous};
use ombra_math::exact::dot;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;

use super::exact_cast::{
    cast, direction_from_light, heights_below_light, homogeneous_shadow, towards_place,
};

/// The shadow of a polygon on `plane`, as homogeneous points; empty where nothing casts.
///
/// # Formula
///
/// ```text
/// the part of the polygon with   n·V + d ≥ 0   (on the light's side)   and   s − L_w t ≥ 0   (below the light),
/// each vertex cast:   (P, 1),   or (L_w V − L, 0), a direction, for a vertex level with the light
/// ```
///
/// # Properties
///
/// - No false shadow: what is behind the plane or beyond the light is cut off before it is cast.
/// - w = 1 for places. w = 0 for directions: there the shadow runs to infinity, and two such points in a row are the
///   two sides of an unbounded shadow. 0 < w < 1 only for places whose coordinates no double holds.
/// - Each kept vertex casts as by [`cast`](super::cast()). Crossings are within 4ε of their edge's larger end.
/// - Empty for fewer than three vertices, a polygon that only touches, a light along the plane, input not finite.
///
/// # Pitfalls
///
/// Clip to the view, or to the receiver with [`cast_onto`], before dividing by w. For a concave polygon that the
/// plane or the light's height cuts into pieces, see
/// [`clip_by`](ombra_clip::sutherland_hodgman::clip_by). A polygon seen edge-on from the light casts a line: its
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
/// the shadow on the receiver's plane, then against each of its edges AB:   (n × AB)·(X − A) ≥ 0
/// ```
///
/// # Properties
///
/// The receiver's vertices may run either way round. It is two-sided: the shadow falls on the side the light is on.
/// Infinite parts of the shadow are clipped like any others, before the division by w. Results lie inside the
/// receiver to within 2ε of the largest coordinate of the *unclipped* shadow: one that is 10⁶ times as large as the
/// receiver costs six digits. Empty if the receiver has no area, or the receiver or the light is not finite.
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
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SUN: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);

    fn v(x: f64, y: f64, z: f64) -> DVec3 {
        DVec3::new(x, y, z)
    }

    #[test]
    fn a_face_of_the_slide_cube() {
        let bottom = [
            v(0.0, 20.0, 0.0),
            v(10.0, 20.0, 0.0),
            v(10.0, 20.0, 10.0),
            v(0.0, 20.0, 10.0),
        ];
        let expected = [(-20, -20), (-10, -20), (-10, -10), (-20, -10)];
        let expected = expected.map(|(x, z)| DVec4::new(x.into(), 0.0, z.into(), 1.0));
        assert_eq!(cast_polygon(Plane::GROUND, SUN, &bottom), expected);
        assert_eq!(cast_polygon(Plane::GROUND.turned(), SUN, &bottom), expected);
    }

    #[test]
    fn a_pillar_higher_than_the_lamp_runs_to_infinity() {
        let lamp = DVec4::new(0.0, 2.0, 0.0, 1.0);
        let wall = [
            v(1.0, 0.0, -1.0),
            v(1.0, 0.0, 1.0),
            v(1.0, 4.0, 1.0),
            v(1.0, 4.0, -1.0),
        ];
        let shadow = cast_polygon(Plane::GROUND, lamp, &wall);
        let at_infinity: Vec<_> = shadow.iter().filter(|p| p.w == 0.0).collect();
        assert_eq!(
            at_infinity,
            [
                &DVec4::new(1.0, 0.0, -1.0, 0.0),
                &DVec4::new(1.0, 0.0, 1.0, 0.0)
            ]
        );
        assert_eq!(shadow.len(), 4);
    }

    #[test]
    fn a_shadow_no_double_can_hold_keeps_its_direction() {
        let low = DVec4::new(1e300, 1e-300, 0.0, 0.0);
        let shadow = cast_polygon(
            Plane::GROUND,
            low,
            &[v(0.0, 1.0, 0.0), v(0.0, 1.0, 1.0), v(0.0, 2.0, 0.0)],
        );
        assert_eq!(shadow.len(), 3);
        for p in shadow {
            assert!(
                p.is_finite() && p.w >= 0.0 && p.w < 1e-300 && p.x < 0.0,
                "{p}"
            );
        }
    }

    #[test]
    fn receivers_of_any_winding_and_side() {
        let tile = [
            v(-1.0, 0.0, -1.0),
            v(-1.0, 0.0, 1.0),
            v(1.0, 0.0, 1.0),
            v(1.0, 0.0, -1.0),
        ];
        let mut turned = tile;
        turned.reverse();
        let sheet = tile.map(|p| p * 10.0 + DVec3::Y);
        for receiver in [tile, turned] {
            for light in [
                DVec4::Y,
                DVec4::new(0.3, 1.0, -0.4, 0.0),
                DVec4::new(0.0, 5.0, 1.0, 1.0),
            ] {
                let mut shadow = cast_onto(&receiver, light, &sheet);
                assert_eq!(shadow.len(), 4);
                shadow.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.z.total_cmp(&b.z)));
                for (p, q) in shadow.iter().zip([tile[0], tile[1], tile[3], tile[2]]) {
                    assert!(
                        (*p - q).abs().max_element() <= 8.0 * f64::EPSILON * 10.0,
                        "{p} {q}"
                    );
                }
                assert_eq!(
                    cast_onto(&receiver, light, &sheet.map(|p| p - 2.0 * DVec3::Y)),
                    []
                );
            }
        }
    }

    #[test]
    fn the_error_is_that_of_the_unclipped_shadow() {
        let tile = [
            v(-1.0, 0.0, -1.0),
            v(-1.0, 0.0, 1.0),
            v(1.0, 0.0, 1.0),
            v(1.0, 0.0, -1.0),
        ];
        for k in [1e3, 1e6, 1e9] {
            for (x, z) in [(0.3, 0.7), (-0.9, 0.2), (0.55, -0.35)] {
                let sheet = [v(x, 1.0, -k), v(k, 1.0, z * k), v(-k, 1.0, 0.9 * k)];
                for p in cast_onto(&tile, DVec4::Y, &sheet) {
                    let outside = p.abs().max_element() - 1.0;
                    assert!(outside <= 2.0 * f64::EPSILON * k, "{k:e}: {outside:e}");
                }
            }
        }
    }

    #[test]
    fn a_lamp_below_a_ceiling() {
        let ceiling = [
            v(-9.0, 3.0, -9.0),
            v(9.0, 3.0, -9.0),
            v(9.0, 3.0, 9.0),
            v(-9.0, 3.0, 9.0),
        ];
        let plate = [v(0.0, 2.0, 0.0), v(1.0, 2.0, 0.0), v(1.0, 2.0, 1.0)];
        let shadow = cast_onto(&ceiling, DVec4::new(0.0, 1.0, 0.0, 1.0), &plate);
        assert_eq!(
            shadow,
            [v(0.0, 3.0, 0.0), v(2.0, 3.0, 0.0), v(2.0, 3.0, 2.0)]
        );
    }

    #[test]
    fn degenerate() {
        let triangle = [v(0.0, 1.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 1.0)];
        let ground = Plane::GROUND;
        let bad_plane = Plane {
            normal: DVec3::ZERO,
            d: 1.0,
        };
        for (plane, light, polygon) in [
            (ground, SUN, &triangle[..0]),
            (ground, SUN, &triangle[..2]),
            (ground, DVec4::ZERO, &triangle[..]),
            (ground, DVec4::X, &triangle[..]),
            (ground, -SUN, &triangle[..]),
            (ground, DVec4::new(0.0, 1.0, 0.0, 1.0), &triangle[..]),
            (ground, DVec4::new(0.0, 0.5, 0.0, 1.0), &triangle[..]),
            (ground, DVec4::NAN, &triangle[..]),
            (bad_plane, SUN, &triangle[..]),
            (ground, SUN, &[DVec3::Y, DVec3::NAN, DVec3::X][..]),
            (ground, SUN, &[DVec3::Y; 4][..]),
        ] {
            assert_eq!(
                cast_polygon(plane, light, polygon),
                [],
                "{plane:?} {light} {polygon:?}"
            );
        }
        for receiver in [
            &triangle[..0],
            &triangle[..2],
            &[DVec3::ZERO; 4][..],
            &[DVec3::NAN; 3][..],
        ] {
            assert_eq!(cast_onto(receiver, SUN, &triangle), []);
        }
        // A polygon on the plane is its own shadow.
        let flat = triangle.map(|p| p - DVec3::Y);
        assert_eq!(cast_polygon(ground, SUN, &flat), flat.map(point));
    }

    proptest! {
        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 26)) {
            let p: Vec<_> = x.chunks_exact(3).map(DVec3::from_slice).collect();
            let light = DVec4::from_slice(&x[20..24]);
            let plane = Plane { normal: p[6], d: x[25] };
            for q in cast_polygon(plane, light, &p[..4]) {
                prop_assert!(q.w >= 0.0 && q.w <= 1.0 && !q.is_nan());
            }
            prop_assert!(cast_onto(&p[4..8], light, &p[..4]).iter().all(|q| q.is_finite()));
        }
    }
}
