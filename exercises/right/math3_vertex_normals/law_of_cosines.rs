// right: the angle by the law of cosines
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
        let [a, b, c] = [0, 1, 2].map(|i| positions[triangle[(at + i) % 3]]);
        let (ab, ac) = (b - a, c - a);
        let cross = ab.cross(ac);
        let Some(normal) = cross.try_normalize() else {
            continue;
        };
        sum += match weighting {
            Weighting::Plain => normal,
            Weighting::Area => cross / 2.0,
            Weighting::Angle => {
                normal * {
                    let (b2, c2, a2) = (ab.length(), ac.length(), ab.distance(ac));
                    ((b2 * b2 + c2 * c2 - a2 * a2) / (2.0 * b2 * c2))
                        .clamp(-1.0, 1.0)
                        .acos()
                }
            }
        };
    }
    sum.try_normalize()
}
