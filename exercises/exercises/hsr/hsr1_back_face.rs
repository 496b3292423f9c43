use glam::{DVec3, DVec4};

/// Whether a triangle of a closed solid may be seen from the eye.
///
/// ```text
/// n·v ≥ 0          n = AB × AC: the normal, out of the solid          v: from the triangle towards the viewer
/// ```
///
/// `triangle` is [A, B, C], counter-clockwise as seen from outside. `eye` is homogeneous: E_w = 1 a place, E_w = 0 the
/// direction *towards* the viewer of a parallel view, the same for every triangle. A triangle seen edge-on, n·v = 0, is
/// kept: it covers no pixel. v may begin at any vertex; nothing has to be made unit, so the sign is that of n·v itself.
///
/// Grafica 3, Ottimizzazione: Back-face Culling and Back Face Culling. Beware: the first slide measures the angle from
/// the direction of view, the second from the viewer. Only one of them agrees with n·v ≥ 0.
fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    // TODO: the normal, the vector towards the viewer, one sign.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod hsr1_back_face {
    use super::is_front_facing;
    use assess::{Ink, Inputs, Panel, Picture, brief, brief_number};
    use glam::{DVec2, DVec3, DVec4};

    /// A triangle with whole coordinates, and its normal: all that is asked of them is exact.
    fn any_triangle(inputs: &mut Inputs) -> ([DVec3; 3], DVec3) {
        loop {
            let triangle = [(); 3].map(|()| inputs.whole_vector(-9, 9));
            let [a, b, c] = triangle;
            let normal = (b - a).cross(c - a);
            if normal.z != 0.0 {
                return (triangle, normal);
            }
        }
    }

    /// One whose plane passes through the origin, so that it does not matter where v begins.
    fn through_the_origin(inputs: &mut Inputs) -> ([DVec3; 3], DVec3) {
        let ([a, b, c], normal) = any_triangle(inputs);
        ([DVec3::ZERO, b - a, c - a], normal)
    }

    fn name(triangle: [DVec3; 3], eye: DVec4) -> String {
        let [a, b, c] = triangle.map(brief);
        format!(
            "triangle {a} {b} {c}, eye {} with E_w = {}",
            brief(eye.truncate()),
            brief_number(eye.w)
        )
    }

    /// The section through the triangle's first vertex and the eye, square to the triangle: it is filled where it is
    /// kept, dashed where it is left out; its normal is green.
    #[track_caller]
    fn picture(triangle: [DVec3; 3], eye: DVec4, kept: bool, seen: bool) -> Picture {
        let [a, b, c] = triangle;
        let n = (b - a).cross(c - a).normalize_or_zero();
        let v = eye.truncate() - eye.w * a;
        let across = (v - n.dot(v) * n).try_normalize();
        let across = across.unwrap_or_else(|| (b - a).normalize_or_zero());
        let at = |p: DVec3| DVec2::new(across.dot(p), n.dot(p));
        let size = v.length().max(1e-300);
        let half = |kept: bool| {
            let mut panel = Panel::plane();
            let end = DVec2::new(0.4 * size, 0.0);
            panel.segment(-end, end, if kept { Ink::Right } else { Ink::Faint });
            panel.arrow(DVec2::ZERO, DVec2::new(0.0, 0.3 * size), Ink::Normal);
            panel.arrow(DVec2::ZERO, at(v), Ink::Ideal);
            panel.point(
                at(v),
                if eye.w == 0.0 { "to the eye" } else { "eye" },
                Ink::Eye,
            );
            panel
        };
        Picture::beside(half(kept), half(seen))
    }

    /// A triangle before the eye must be kept and one behind it left out, in the plainest case: what is wrong with that
    /// is told before any finer verdict.
    fn plainest() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let [front, back] =
            [1.0, -1.0].map(|z| is_front_facing(triangle, DVec4::new(0.0, 0.0, z, 1.0)));
        let what = "A (0, 0, 0), B (1, 0, 0), C (0, 1, 0), so n = (0, 0, 1)";
        assert!(
            front || back,
            "{what}: left out for the eye in (0, 0, 1) and for the eye in (0, 0, -1): the answer seems to be false always",
        );
        assert!(
            !front || !back,
            "{what}: kept for the eye in (0, 0, 1) and for the eye in (0, 0, -1): the answer does not depend on the \
             side of the eye. The normal alone, or its z, does not tell (errata E31)",
        );
        assert!(
            front,
            "{what}: left out for the eye in (0, 0, 1), where n points to, kept for (0, 0, -1): the sign is turned round. \
             v points from the triangle to the viewer, not the way the viewer looks, and n is AB × AC",
        );
    }

    #[test]
    fn slide_cube() {
        // The decks' cube, 0 ≤ x ≤ 10, 20 ≤ y ≤ 30, 0 ≤ z ≤ 10: each face is two triangles.
        let (low, high) = (DVec3::new(0.0, 20.0, 0.0), DVec3::new(10.0, 30.0, 10.0));
        let eye = DVec4::new(30.0, 40.0, 50.0, 1.0);
        let mut kept = 0;
        plainest();
        for axis in 0..3 {
            for outer in [low, high] {
                // The face at outer[axis], its other two axes in turn, so that u × w is the axis itself.
                let (u, w) = ((axis + 1) % 3, (axis + 2) % 3);
                let corner = |s: f64, t: f64| {
                    let mut p = DVec3::ZERO;
                    p[axis] = outer[axis];
                    p[u] = s;
                    p[w] = t;
                    p
                };
                let [p, q, r, s] = [
                    corner(low[u], low[w]),
                    corner(high[u], low[w]),
                    corner(high[u], high[w]),
                    corner(low[u], high[w]),
                ];
                let is_high = outer == high;
                let triangles = if is_high {
                    [[p, q, r], [p, r, s]]
                } else {
                    [[p, r, q], [p, s, r]]
                };
                for triangle in triangles {
                    let got = is_front_facing(triangle, eye);
                    kept += usize::from(got);
                    let side = ["x", "y", "z"][axis];
                    let _picture = picture(triangle, eye, got, is_high);
                    assert!(
                        got == is_high,
                        "{}: of the cube the eye sees the faces x = 10, y = 30 and z = 10, but {side} = {} is {}",
                        name(triangle, eye),
                        outer[axis],
                        if got { "kept" } else { "left out" },
                    );
                }
            }
        }
        assert_eq!(kept, 6, "6 of the 12 triangles");
    }

    #[test]
    fn either_side() {
        let mut inputs = Inputs::new(41);
        plainest();
        for _ in 0..200 {
            let (triangle, normal) = through_the_origin(&mut inputs);
            let along = f64::from(inputs.integer(1, 5)) * normal;
            let [before, behind] =
                [along, -along].map(|e| is_front_facing(triangle, e.extend(1.0)));
            let what = name(triangle, along.extend(1.0));
            assert!(
                before != behind,
                "{what}: the answer is the same from both sides of the triangle. The normal alone, or its z, does not \
                 tell: in perspective it matters where the eye is (errata E31)",
            );
            assert!(
                before,
                "{what}: the eye is on the side of the normal, and from there the triangle is left out; from behind it is \
                 kept. v points from the triangle to the viewer, not the way the viewer looks (errata E13)",
            );
        }
    }

    #[test]
    fn moved_along() {
        let mut inputs = Inputs::new(42);
        plainest();
        for _ in 0..200 {
            let (triangle, _) = through_the_origin(&mut inputs);
            let eye = inputs.whole_vector(-30, 30);
            let by = inputs.whole_vector(-20, 20);
            let at_the_origin = is_front_facing(triangle, eye.extend(1.0));
            let moved = triangle.map(|p| p + by);
            assert!(
                is_front_facing(moved, (eye + by).extend(1.0)) == at_the_origin,
                "{}: eye and triangle have moved together by {}, and the answer has changed. An eye that is a place is \
                 no direction: v runs from a point of the triangle to the eye",
                name(moved, (eye + by).extend(1.0)),
                brief(by),
            );
        }
    }

    #[test]
    fn any_eye() {
        let mut inputs = Inputs::new(43);
        plainest();
        for _ in 0..300 {
            let (triangle, normal) = any_triangle(&mut inputs);
            // Off the plane by construction: a point of the triangle, some way along its sides and off along the normal.
            let [a, b, c] = triangle;
            let [s, t] = [(); 2].map(|()| f64::from(inputs.integer(-4, 4)));
            let off = f64::from(inputs.integer(1, 4));
            for (off, seen) in [(off, true), (-off, false)] {
                let eye = a + s * (b - a) + t * (c - a) + off * normal;
                let got = is_front_facing(triangle, eye.extend(1.0));
                let _picture = picture(triangle, eye.extend(1.0), got, seen);
                assert!(
                    got == seen,
                    "{}: n·v = {off} n·n {} 0, so the triangle is to be {}",
                    name(triangle, eye.extend(1.0)),
                    if seen { '>' } else { '<' },
                    if seen { "kept" } else { "left out" },
                );
            }
        }
    }

    #[test]
    fn parallel_view() {
        let mut inputs = Inputs::new(44);
        plainest();
        for _ in 0..200 {
            let (triangle, normal) = any_triangle(&mut inputs);
            let [a, b, c] = triangle;
            let [s, t] = [(); 2].map(|()| f64::from(inputs.integer(-4, 4)));
            for (off, seen) in [(1.0, true), (-1.0, false)] {
                let towards = s * (b - a) + t * (c - a) + off * normal;
                let got = is_front_facing(triangle, towards.extend(0.0));
                // Seen from a place, it would now turn its other side: n·n ≥ 1, |n·a| < 2¹⁵.
                let away = triangle.map(|p| p + 32_768.0 * off * normal);
                assert!(
                    is_front_facing(away, towards.extend(0.0)) == got,
                    "{}: E_w = 0 is a parallel view: v is that direction itself, wherever the triangle is, but moved away \
                     by {} the answer changes",
                    name(triangle, towards.extend(0.0)),
                    brief(32_768.0 * off * normal),
                );
                assert!(
                    got == seen,
                    "{}: n·v = {off} n·n {} 0, so the triangle is to be {}",
                    name(triangle, towards.extend(0.0)),
                    if seen { '>' } else { '<' },
                    if seen { "kept" } else { "left out" },
                );
            }
        }
    }

    /// The eye a hair before or behind the plane: 2⁻¹⁰ to 2⁻⁴⁵ of its distance, at three scales. All of it is exact.
    #[test]
    fn by_a_hair() {
        plainest();
        for scale in [0, 60, -60] {
            for power in [1, 10, 20, 30, 45] {
                let unit = 2f64.powi(scale);
                let hair = unit * 2f64.powi(-power);
                let triangle = [DVec3::ZERO, unit * DVec3::X, unit * DVec3::Y];
                for w in [1.0, 0.0] {
                    for (z, seen) in [(hair, true), (-hair, false)] {
                        let eye = DVec3::new(unit, unit, z).extend(w);
                        let got = is_front_facing(triangle, eye);
                        let _picture = picture(triangle, eye, got, seen);
                        assert!(
                            got == seen,
                            "{}: the eye is {} the plane by 2^−{power} of its distance, and that is enough: the sign of n·v \
                             is taken as it is, without a tolerance",
                            name(triangle, eye),
                            if seen { "before" } else { "behind" },
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn edge_on() {
        let mut inputs = Inputs::new(45);
        plainest();
        for w in [1.0, 0.0].into_iter().cycle().take(200) {
            let ([a, b, c], normal) = through_the_origin(&mut inputs);
            let triangle = if normal.z > 0.0 { [a, b, c] } else { [a, c, b] };
            let [s, t] = [(); 2].map(|()| f64::from(inputs.integer(-4, 4)));
            if (s, t) == (0.0, 0.0) {
                continue;
            }
            let eye = (s * b + t * c).extend(w);
            assert!(
                is_front_facing(triangle, eye),
                "{}: the eye is in the plane of the triangle, n·v = 0 exactly: the slide keeps it, cos θ ≥ 0 (nothing is \
                 rounded here if v begins at a vertex and nothing is made unit)",
                name(triangle, eye),
            );
        }
    }

    #[test]
    fn huge_and_tiny() {
        let mut inputs = Inputs::new(46);
        plainest();
        for exponent in [-300, -100, 100, 300] {
            let scale = 2f64.powi(exponent);
            for _ in 0..50 {
                let (triangle, normal) = any_triangle(&mut inputs);
                let eye = triangle[0] + normal;
                let scaled = triangle.map(|p| scale * p);
                for (eye, seen) in [(eye, true), (triangle[0] - normal, false)] {
                    assert!(
                        is_front_facing(scaled, (scale * eye).extend(1.0)) == seen,
                        "{}: 2 to the power of {exponent} times as large, with its eye, it looks the same",
                        name(scaled, (scale * eye).extend(1.0)),
                    );
                }
            }
        }
    }
}
