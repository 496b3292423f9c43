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
    // TODO: the three formulas.
    todo!()
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
    // TODO: r, then the angles; which function gives an angle in all four quadrants?
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod math4_spherical {
    use super::{Spherical, to_cartesian, to_spherical};
    use assess::{Inputs, near, near_number, show};
    use glam::DVec3;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2, TAU};

    /// A few roundings of numbers up to π, times ten for an arc cosine of z / r, which loses a digit at θ = 0.1.
    const BOUND: f64 = 64.0 * f64::EPSILON;

    /// Whether two angles name the same direction.
    fn same_angle(a: f64, b: f64) -> bool {
        (a - b - TAU * ((a - b) / TAU).round()).abs() <= BOUND
    }

    fn check(p: DVec3, got: Spherical, want: Spherical) {
        let what = |letter| format!("{letter} of {}", show(p));
        near_number(&what("r"), got.r, want.r, BOUND * want.r);
        near_number(&what("θ"), got.theta, want.theta, BOUND);
        near_number(&what("φ"), got.phi, want.phi, BOUND);
    }

    #[test]
    fn known_points() {
        // (1, 1, √2): r² = 4; the ring's radius √2 equals z; x equals y.
        let (p, s) = (
            DVec3::new(1.0, 1.0, SQRT_2),
            Spherical {
                r: 2.0,
                theta: FRAC_PI_4,
                phi: FRAC_PI_4,
            },
        );
        near("r 2, θ π/4, φ π/4", to_cartesian(s), p, 2.0 * BOUND);
        check(p, to_spherical(p), s);
        // Once round the equator.
        for (p, phi) in [
            (DVec3::X, 0.0),
            (DVec3::Y, FRAC_PI_2),
            (-DVec3::X, PI),
            (-DVec3::Y, -FRAC_PI_2),
        ] {
            // −X has y = −0, which would stand for the other side of the seam.
            let p = p + DVec3::ZERO;
            check(
                3.0 * p,
                to_spherical(3.0 * p),
                Spherical {
                    r: 3.0,
                    theta: FRAC_PI_2,
                    phi,
                },
            );
        }
    }

    #[test]
    fn every_octant() {
        let mut inputs = Inputs::new(5);
        for octant in 0..800 {
            // Away from the octants' borders, where two answers would coincide.
            let (lower, quadrant) = (octant % 2 == 1, f64::from(octant / 2 % 4));
            let theta = inputs.real(0.1, FRAC_PI_2 - 0.1);
            let theta = if lower { PI - theta } else { theta };
            let phi = inputs.real(0.1, FRAC_PI_2 - 0.1) + quadrant * FRAC_PI_2;
            let phi = if phi > PI { phi - TAU } else { phi };
            let r = inputs.real(0.5, 50.0);
            let p = DVec3::new(
                r * phi.cos() * theta.sin(),
                r * phi.sin() * theta.sin(),
                r * theta.cos(),
            );

            let want = Spherical { r, theta, phi };
            let got = to_spherical(p);
            let what = format!("{}: θ {}, φ {}", show(p), got.theta, got.phi);
            assert!(
                same_angle(got.phi, phi) || !same_angle(got.phi, FRAC_PI_2 - phi),
                "{what}: this φ and the right one add up to π/2: x and y are swapped, as on the slide; \
                 tan φ = y / x (erratum E6)",
            );
            assert!(
                same_angle(got.theta, theta) || !same_angle(got.theta, FRAC_PI_2 - theta),
                "{what}: this θ and the right one add up to π/2: it is the elevation above the plane z = 0, but θ is \
                 the angle from the z axis (erratum E30)",
            );
            assert!(
                !same_angle(got.phi, phi + PI),
                "{what}: φ looks the opposite way: y / x is the same for (x, y) and (−x, −y), but atan2(y, x) \
                 keeps the quadrant",
            );
            assert!(
                !same_angle(got.theta, theta + PI),
                "{what}: θ is half a turn off below the plane z = 0: the quotient's sign alone does not tell, \
                 atan2(√(x² + y²), z) does",
            );
            check(p, got, want);
            near(
                &format!("to_cartesian({want:?})"),
                to_cartesian(want),
                p,
                r * BOUND,
            );
        }
    }

    #[test]
    fn there_and_back() {
        let mut inputs = Inputs::new(6);
        for _ in 0..400 {
            let p = inputs.whole_vector(-9, 9);
            near(
                &format!("{} there and back", show(p)),
                to_cartesian(to_spherical(p)),
                p,
                4.0 * BOUND,
            );
        }
    }

    #[test]
    fn poles_and_origin() {
        check(
            DVec3::ZERO,
            to_spherical(DVec3::ZERO),
            Spherical {
                r: 0.0,
                theta: 0.0,
                phi: 0.0,
            },
        );
        let up = DVec3::new(0.0, 0.0, 7.0);
        check(
            up,
            to_spherical(up),
            Spherical {
                r: 7.0,
                theta: 0.0,
                phi: 0.0,
            },
        );
        let down = DVec3::new(0.0, 0.0, -7.0);
        check(
            down,
            to_spherical(down),
            Spherical {
                r: 7.0,
                theta: PI,
                phi: 0.0,
            },
        );
    }

    #[test]
    fn near_the_pole_and_far_away() {
        // One part in 10⁹ beside the pole: cos θ rounds to 1, so an arc cosine of z / r would answer 0.
        let p = DVec3::new(1e-9, 0.0, 1.0);
        let theta = to_spherical(p).theta;
        near_number(
            "θ of (10⁻⁹, 0, 1), which an arc cosine loses",
            theta,
            1e-9,
            1e-9 * BOUND,
        );
        let far = 1e150 * DVec3::new(1.0, 1.0, SQRT_2);
        check(
            far,
            to_spherical(far),
            Spherical {
                r: 2e150,
                theta: FRAC_PI_4,
                phi: FRAC_PI_4,
            },
        );
    }
}
