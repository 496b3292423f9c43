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
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    // For w = 0 what is left is the direction.
    let towards_viewer = eye.truncate() - eye.w * a;
    normal.dot(towards_viewer) >= 0.0
}

fn main() {}
