// right: arc tangents case by case
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
    let ring = p.x.hypot(p.y);
    Spherical {
        r: p.length(),
        theta: {
            use std::f64::consts::PI;
            if ring == 0.0 {
                if p.z < 0.0 { PI } else { 0.0 }
            } else if p.z > 0.0 {
                (ring / p.z).atan()
            } else if p.z < 0.0 {
                PI + (ring / p.z).atan()
            } else {
                PI / 2.0
            }
        },
        phi: {
            use std::f64::consts::PI;
            let (x, y) = (p.x, p.y);
            if x > 0.0 {
                (y / x).atan()
            } else if x < 0.0 {
                if y >= 0.0 {
                    (y / x).atan() + PI
                } else {
                    (y / x).atan() - PI
                }
            } else if y > 0.0 {
                PI / 2.0
            } else if y < 0.0 {
                -PI / 2.0
            } else {
                0.0
            }
        },
    }
}
