// rejected by every_octant: it is the elevation
use glam::DVec3;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Spherical {
    r: f64,
    theta: f64,
    phi: f64,
}

fn to_cartesian(s: Spherical) -> DVec3 {
    let ring = s.r * s.theta.sin();
    DVec3::new(ring * s.phi.cos(), ring * s.phi.sin(), s.r * s.theta.cos())
}

fn to_spherical(p: DVec3) -> Spherical {
    let p = p + DVec3::ZERO;
    let ring = p.x.hypot(p.y);
    Spherical {
        r: p.length(),
        theta: p.z.atan2(ring),
        phi: p.y.atan2(p.x),
    }
}
