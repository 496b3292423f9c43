// rejected by huge_and_tiny: has an area, but n is (0, 0, 0)
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let n = (b - a).cross(c - a);
    if n.length() < 1e-9 { DVec3::ZERO } else { n }
}
