use glam::DVec3;

/// The normal of a triangle whose vertex normals are known: their mean direction, of unit length.
///
/// ```text
/// n = (n̂₁ + n̂₂ + n̂₃) / ‖n̂₁ + n̂₂ + n̂₃‖          n̂ᵢ = nᵢ / ‖nᵢ‖
/// ```
///
/// A normal tells a direction, so each vertex normal is made unit before the mean is taken; the deck's example
/// leaves that open and gives normals of other lengths (erratum E14).
///
/// `None` where there is no mean direction: a vertex normal is (0, 0, 0), or the sum of the three unit normals is.
/// A short sum still has a direction, but few digits of it: n is right to 32 ε / ‖n̂₁ + n̂₂ + n̂₃‖ in each coordinate,
/// ε being `f64::EPSILON`. Vertex normals may be from 10⁻¹⁵⁰ to 10¹⁵⁰ long.
///
/// Olomouc, Flat shading.
fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [first, second, third] = normals;
    let sum = first.try_normalize()? + second.try_normalize()? + third.try_normalize()?;
    sum.try_normalize()
}

fn main() {}
