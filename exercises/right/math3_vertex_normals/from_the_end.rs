// right: iterators, the cross product at the first corner
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
    triangles
        .iter()
        .rev()
        .filter(|t| t.contains(&vertex))
        .filter_map(|t| {
            let n = (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
            let k = t.iter().position(|&v| v == vertex).unwrap();
            let (u, v) = (
                positions[t[(k + 2) % 3]] - positions[vertex],
                positions[t[(k + 1) % 3]] - positions[vertex],
            );
            let unit = n.try_normalize()?;
            Some(
                unit * match weighting {
                    Weighting::Plain => 1.0,
                    Weighting::Area => n.length(),
                    Weighting::Angle => u.angle_between(v),
                },
            )
        })
        .sum::<DVec3>()
        .try_normalize()
}
