use glam::DVec3;

/// How much a triangle counts in the mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Weighting {
    /// All the same.
    Plain,
    /// By its area.
    Area,
    /// By its angle at the vertex.
    Angle,
}

/// The normal of a vertex: the mean direction of the triangles that meet there, of unit length.
///
/// ```text
/// N = Σ wᵢ n̂ᵢ / ‖Σ wᵢ n̂ᵢ‖          n̂ᵢ = AB × AC / ‖AB × AC‖
///
/// Plain: wᵢ = 1     Area: wᵢ = ‖AB × AC‖ / 2     Angle: wᵢ = the angle at the vertex between its two sides
/// ```
///
/// The sum runs over the triangles A B C that have the vertex as a corner; `triangles` holds indices into
/// `positions`, all in range, in the order that makes AB × AC point outwards. A triangle without area has no
/// normal and is left out. `None` where no triangle is left or the sum is (0, 0, 0).
///
/// N is right to 256 ε Σ wᵢ / ‖Σ wᵢ n̂ᵢ‖ in each coordinate, ε being `f64::EPSILON`, where the angles lie between 5°
/// and 175°; an arc cosine is good enough for that. A thinner triangle counts too, but has fewer digits. Sides may be
/// from 10⁻⁷⁰ to 10⁷⁰ long.
///
/// The deck takes the mean of the *faces*. A mesh has triangles, and a face of the cube meets its corner in one
/// or in two of them, as its diagonal runs: find out which weighting does not notice.
///
/// Olomouc, Gouraud shading.
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
            Weighting::Angle => ab.angle_between(ac) * normal,
        };
    }
    sum.try_normalize()
}

fn main() {}
