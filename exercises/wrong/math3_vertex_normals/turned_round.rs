// rejected by any_order_of_corners: the corners must run round the triangle in the same order
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
        if !triangle.contains(&vertex) {
            continue;
        }
        let others: Vec<usize> = triangle.iter().copied().filter(|&i| i != vertex).collect();
        let [b, c] = others[..] else { continue };
        let [a, b, c] = [vertex, b, c].map(|i| positions[i]);
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
