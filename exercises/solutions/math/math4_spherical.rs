use glam::DVec3;

/// A point by its distance and two angles, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Spherical {
    /// Distance from the origin.
    r: f64,
    /// Angle from the z axis, from 0 (the pole above) to π (the pole below).
    theta: f64,
    /// Angle from the x axis towards the y axis, above −π and at most π; 0 where x = y = 0.
    phi: f64,
}

/// From spherical to Cartesian coordinates.
///
/// ```text
/// x = r cos φ sin θ     y = r sin φ sin θ     z = r cos θ
/// ```
///
/// Each coordinate is right to 64 ε r, ε being `f64::EPSILON`.
///
/// Olomouc, Prostorové úhly.
fn to_cartesian(s: Spherical) -> DVec3 {
    let ring = s.r * s.theta.sin();
    DVec3::new(ring * s.phi.cos(), ring * s.phi.sin(), s.r * s.theta.cos())
}

/// From Cartesian to spherical coordinates.
///
/// ```text
/// r = √(x² + y² + z²)     tan φ = y / x     tan θ = √(x² + y²) / z
/// ```
///
/// A tangent leaves open which of two opposite directions is meant; φ and θ are those of `Spherical`. At the
/// origin all three are 0. The slide has tan φ = x / y (erratum E6) and calls θ the elevation (erratum E30); both
/// contradict its own x, y and z.
///
/// A coordinate −0 is 0, so (−1, −0, 0) has φ = π, as (−1, 0, 0) has.
///
/// r is right to 64 ε r, θ and φ to 64 ε, wherever the point lies. Beside the z axis z / r rounds to 1 and has lost θ,
/// so no arc cosine of it can keep that bound; the quotients above can. r may be from 10⁻¹⁵⁰ to 10¹⁵⁰.
///
/// Olomouc, Prostorové úhly.
fn to_spherical(p: DVec3) -> Spherical {
    // −0 + 0 is 0. To atan2 the sign of a zero is a side: it would answer −π for y = −0 and π for z = −0.
    let p = p + DVec3::ZERO;
    let ring = p.x.hypot(p.y);
    Spherical {
        r: p.length(),
        theta: ring.atan2(p.z),
        phi: p.y.atan2(p.x),
    }
}

fn main() {}
