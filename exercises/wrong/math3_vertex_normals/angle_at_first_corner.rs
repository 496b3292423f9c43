// rejected by any_order_of_corners: the angle is the one at the vertex, wherever that is listed
use glam::DVec3;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Weighting {
    Plain,
    Area,
    Angle,
}

fn vertex_normal(
    positions: &[DVec3],
    triangles: &[[usize; 3]],
    vertex: usize,
    weighting: Weighting,
) -> Option<DVec3> {
    let mut sum = DVec3::ZERO;
    for triangle in triangles {
        let at = triangle.iter().position(|&corner| corner == vertex);
        let Some(at) = at else { continue };
        // From the vertex itself the corners run in the same order.
        let [a, b, c] = triangle.map(|i| positions[i]);
        let (ab, ac) = (b - a, c - a);
        let cross = ab.cross(ac);
        let Some(normal) = cross.try_normalize() else {
            continue;
        };
        sum += match weighting {
            Weighting::Plain => normal,
            Weighting::Area => cross / 2.0,
            Weighting::Angle => ab.angle_between(ac) * normal,
        };
    }
    sum.try_normalize()
}
