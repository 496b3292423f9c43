// right: a vector turned about y, then about z
use glam::DVec3;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Spherical {
    r: f64,
    theta: f64,
    phi: f64,
}

fn to_cartesian(s: Spherical) -> DVec3 {
    let v = DVec3::Z.rotate_y(s.theta).rotate_z(s.phi);
    v * s.r
}

fn to_spherical(p: DVec3) -> Spherical {
    let p = p + DVec3::ZERO;
    let ring = p.x.hypot(p.y);
    Spherical {
        r: p.length(),
        theta: ring.atan2(p.z),
        phi: p.y.atan2(p.x),
    }
}
