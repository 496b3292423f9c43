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
/// Olomouc, Prostorové úhly.
fn to_spherical(p: DVec3) -> Spherical {
    let ring = p.x.hypot(p.y);
    Spherical {
        r: p.length(),
        theta: ring.atan2(p.z),
        phi: p.y.atan2(p.x),
    }
}

fn main() {}
