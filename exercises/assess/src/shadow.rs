//! Shadows on a plane: how far rounding may move them, and pictures of them.

use glam::{DVec2, DVec3, DVec4, Vec4Swizzles as _};

use crate::{Ink, Panel, Picture, brief_number};

/// How far rounding may move the shadow P of V: a few units of the last place of each term of
///
/// ```text
/// P = ((π·L) V − (π·V) L) / w          w = π·L − L_w (π·V)
/// ```
///
/// with every product positive. It also allows a plane that is made unit first, or another order of the sums.
#[must_use]
pub fn shadow_bound(plane: DVec4, light: DVec4, v: DVec3) -> f64 {
    let v = v.extend(1.0);
    let (dot, height) = (plane.dot(light), plane.dot(v));
    let (dots, heights) = (plane.abs().dot(light.abs()), plane.abs().dot(v.abs()));
    let w = (dot - light.w * height).abs();
    let numerator = (dot * v - height * light).truncate().abs().max_element();
    let numerators = dots * v.abs().max_element() + heights * light.abs().max_element();
    let ws = dots + light.w.abs() * heights;
    // Eight roundings at most stand one upon another in each sum, and the same again in a plane made unit.
    16.0 * f64::EPSILON * (numerators + numerator / w * ws) / w
}

/// Four homogeneous coordinates with few digits: `[x, y, z, w]`.
#[must_use]
pub fn brief4(v: DVec4) -> String {
    format!("[{}]", v.to_array().map(brief_number).join(", "))
}

/// The section through light, vertex and shadow, square to the plane: what was answered beside what is right.
#[track_caller]
pub fn shadow_section(
    plane: DVec4,
    light: DVec4,
    v: DVec3,
    got: Option<DVec3>,
    want: Option<DVec3>,
) -> Picture {
    let length = plane.xyz().length();
    let side = if plane.dot(light) < 0.0 { -1.0 } else { 1.0 };
    let (n, d) = (side * plane.xyz() / length, side * plane.w / length);
    let ray = light.xyz() - light.w * v;
    let along = ray - n.dot(ray) * n;
    let along = along
        .try_normalize()
        .unwrap_or_else(|| n.any_orthonormal_vector());
    let at = |p: DVec3| DVec2::new(along.dot(p - v), n.dot(p) + d);
    let half = |p: Option<DVec3>, ink: Ink| {
        let mut panel = Panel::plane();
        let height = at(v).y.abs().max(1.0);
        let (lamp, sun) = if light.w == 0.0 {
            let towards = at(v + ray.normalize_or_zero() * 2.0 * height);
            (towards, false)
        } else {
            (at(light.xyz() / light.w), true)
        };
        let ends = [Some(v), got, want].map(|p| p.map(|p| at(p).x));
        let ends = ends.into_iter().flatten().chain([lamp.x]);
        let (left, right) = ends.fold((0.0_f64, 0.0_f64), |(l, r), x| (l.min(x), r.max(x)));
        let air = 0.1 * (right - left) + 0.2 * height;
        panel.segment(
            DVec2::new(left - air, 0.0),
            DVec2::new(right + air, 0.0),
            Ink::Ideal,
        );
        if let Some(p) = p {
            panel.segment(lamp, at(p), Ink::Faint);
            panel.segment(at(v), at(p), Ink::Faint);
        }
        if sun {
            panel.point(lamp, "L", Ink::Light);
        } else {
            panel.arrow(lamp, at(v).lerp(lamp, 0.3), Ink::Light);
        }
        panel.point(at(v), "V", Ink::Shade(0));
        match (p, want) {
            (Some(p), _) => panel.point(at(p), "P", ink),
            (None, Some(want)) => panel.point(at(want), "", Ink::Missing),
            (None, None) => {}
        }
        panel
    };
    let wrong = if want.is_none() {
        Ink::Extra
    } else {
        Ink::Right
    };
    Picture::beside(half(got, wrong), half(want, Ink::Shadow))
}

/// The shadows of a box's eight corners in the deck's order, lower face first, seen from above: x to the right, z up.
#[track_caller]
pub fn shadow_plan(got: &[DVec3], want: &[DVec3]) -> Picture {
    let half = |corners: &[DVec3], ink: Ink| {
        let mut panel = Panel::plane();
        let flat: Vec<DVec2> = corners.iter().map(|p| DVec2::new(p.x, p.z)).collect();
        for face in flat.chunks(4) {
            panel.polygon(face, ink);
        }
        for (lower, upper) in flat.iter().zip(flat.iter().skip(4)).take(4) {
            panel.segment(*lower, *upper, ink);
        }
        panel
    };
    Picture::beside(half(got, Ink::Right), half(want, Ink::Shadow))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bound_grows_near_the_light() {
        let light = DVec4::new(0.0, 8.0, 0.0, 1.0);
        let bound = |y| shadow_bound(DVec4::Y, light, DVec3::new(1.0, y, 0.0));
        assert!(bound(1.0) < 1e-13);
        assert!(bound(8.0 - 1e-9) > 1e-7);
        // Another scale of the plane is the same plane.
        let scaled = shadow_bound(1e100 * DVec4::Y, light, DVec3::Y);
        let once = shadow_bound(DVec4::Y, light, DVec3::Y);
        assert!((scaled - once).abs() <= 1e-12 * once);
    }

    #[test]
    fn a_section_has_the_light_above_the_plane() {
        let light = DVec4::new(1.0, -5.0, 0.0, 1.0);
        let picture = shadow_section(DVec4::Y, light, -DVec3::Y, None, Some(DVec3::X));
        let svg = picture.svg();
        let y = |name: &str| {
            let before = svg.split(name).next().unwrap_or_default();
            let at = before.rsplit(" y=\"").next().unwrap_or_default();
            at.split('"').next().and_then(|y| y.parse::<f64>().ok())
        };
        assert!(y(">L<") < y(">V<"), "{svg}");
    }

    #[test]
    fn a_box_has_two_faces_and_four_edges() {
        let corners = [DVec3::ZERO; 8].map(|p| p + DVec3::X);
        let svg = shadow_plan(&corners, &corners).svg();
        assert_eq!(svg.matches("fill-opacity").count(), 4);
        assert_eq!(svg.matches("fill=\"none\" stroke").count(), 8);
    }
}
