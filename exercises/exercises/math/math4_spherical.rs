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
/// A coordinate −0 is 0, so (−1, −0, 0) has φ = π, as (−1, 0, 0) has.
///
/// r is right to 64 ε r, θ and φ to 64 ε, wherever the point lies. Beside the z axis z / r rounds to 1 and has lost θ,
/// so no arc cosine of it can keep that bound; the quotients above can. r may be from 10⁻¹⁵⁰ to 10¹⁵⁰.
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
    use assess::{Inputs, brief, brief_number, is_near};
    use glam::DVec3;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2, TAU};

    /// The bound of the doc comment.
    const BOUND: f64 = 64.0 * f64::EPSILON;

    /// Whether two angles name the same direction.
    fn same_angle(a: f64, b: f64) -> bool {
        (a - b - TAU * ((a - b) / TAU).round()).abs() <= BOUND
    }

    fn same(a: f64, b: f64) -> bool {
        a == b || (a - b).abs() <= BOUND * b.abs()
    }

    fn show(s: Spherical) -> String {
        let [r, theta, phi] = [s.r, s.theta, s.phi].map(brief_number);
        format!("r {r}, θ {theta}, φ {phi}")
    }

    fn examine_cartesian(s: Spherical, want: DVec3) {
        let got = to_cartesian(s);
        let what = format!("to_cartesian of {}: got {}", show(s), brief(got));
        assert!(
            same(got.length(), s.r),
            "{what}, which is {} long, but must be r = {} long",
            brief_number(got.length()),
            brief_number(s.r),
        );
        let bound = BOUND * s.r;
        let off = |coordinate: f64, want: f64| (coordinate - want).abs() > bound;
        assert!(
            !off(got.z, want.z) || off(got.z, s.r * s.theta.sin()),
            "{what}: this z is r sin θ, as if θ were the elevation above the plane z = 0, but θ is the angle from the z \
             axis (erratum E30)",
        );
        assert!(
            !off(got.x, want.x) || off(got.x, want.y) || off(got.y, want.x),
            "{what}: the x and y of this are exchanged: φ runs from the x axis",
        );
        let quarter = Spherical {
            r: 1.0,
            theta: 90.0,
            phi: 0.0,
        };
        assert!(
            is_near(got, want, bound) || !is_near(to_cartesian(quarter), DVec3::X, BOUND),
            "{what}, expected {}; and r 1, θ 90, φ 0 gives (1, 0, 0): the angles are in radians, not in degrees",
            brief(want),
        );
        assert!(
            is_near(got, want, bound),
            "{what}, expected {} (off by {:.1e}, allowed is {bound:.1e})",
            brief(want),
            (got - want).abs().max_element(),
        );
    }

    fn examine_spherical(p: DVec3, want: Spherical) {
        let got = to_spherical(p);
        let what = format!("to_spherical of {}: got {}", brief(p), show(got));
        let right = format!("expected {}", show(want));
        for (letter, value) in [("r", got.r), ("θ", got.theta), ("φ", got.phi)] {
            assert!(!value.is_nan(), "{what}: {letter} is not a number, {right}");
        }

        if !same(got.r, want.r) {
            assert!(
                !same(got.r, p.length_squared()),
                "{what}: this r is x² + y² + z², and its root is missing, {right}"
            );
            assert!(
                !same(got.r, p.truncate().length()),
                "{what}: this r is the distance from the z axis, but r is the one from the origin, {right}"
            );
            panic!(
                "{what}: r is off by {:.1e}, {right}",
                (got.r - want.r).abs()
            );
        }

        let near = |a: f64, b: f64| (a - b).abs() <= BOUND;
        // On an axis or between two of them different mistakes look the same.
        if p.x * p.y * p.z == 0.0 {
            assert!(
                near(got.phi, want.phi),
                "{what}: φ is off by {:.1e}, {right}",
                (got.phi - want.phi).abs()
            );
            assert!(
                near(got.theta, want.theta),
                "{what}: θ is off by {:.1e}, {right}",
                (got.theta - want.theta).abs()
            );
            return;
        }
        let (theta_right, phi_right) = (near(got.theta, want.theta), near(got.phi, want.phi));
        assert!(
            theta_right || phi_right || !near(got.theta, want.phi) || !near(got.phi, want.theta),
            "{what}: θ and φ are exchanged, {right}"
        );
        assert!(
            (theta_right || !same(got.theta, want.theta.to_degrees()))
                && (phi_right || !same(got.phi, want.phi.to_degrees())),
            "{what}: these are degrees, but the angles are in radians, {right}"
        );
        if !phi_right {
            assert!(
                !same_angle(got.phi, want.phi),
                "{what}: φ is right but for a whole turn: it is above −π and at most π, {right}"
            );
            assert!(
                !same_angle(got.phi, FRAC_PI_2 - want.phi),
                "{what}: this φ and the right one add up to π/2: x and y are swapped, as on the slide; \
                 tan φ = y / x (erratum E6), {right}",
            );
            assert!(
                !same_angle(got.phi, want.phi + PI),
                "{what}: φ looks the opposite way: y / x is the same for (x, y) and (−x, −y), but atan2(y, x) \
                 keeps the quadrant, {right}",
            );
            assert!(
                !same_angle(got.phi, -want.phi),
                "{what}: φ is that of the point with −y in the place of y: x and √(x² + y²) do not tell the sign of y, \
                 {right}",
            );
            assert!(
                !same_angle(got.phi, PI - want.phi),
                "{what}: φ is that of the point with −x in the place of x: y and √(x² + y²) do not tell the sign of x, \
                 {right}",
            );
            panic!(
                "{what}: φ is off by {:.1e}, {right}",
                (got.phi - want.phi).abs()
            );
        }
        if !theta_right {
            assert!(
                !near(got.theta, FRAC_PI_2 - want.theta),
                "{what}: this θ and the right one add up to π/2: it is the elevation above the plane z = 0, but θ is \
                 the angle from the z axis (erratum E30), {right}",
            );
            assert!(
                !same_angle(got.theta, want.theta + PI),
                "{what}: θ is half a turn off below the plane z = 0: the quotient's sign alone does not tell, \
                 atan2(√(x² + y²), z) does, {right}",
            );
            assert!(
                !near(got.theta, PI - want.theta),
                "{what}: θ is that of the point with −z in the place of z: √(x² + y²) and r do not tell the sign of z, \
                 {right}",
            );
            assert!(
                !near(got.theta.tan() * p.z, p.truncate().length_squared()),
                "{what}: tan θ is (x² + y²) / z here: the root is missing, {right}",
            );
            panic!(
                "{what}: θ is off by {:.1e}, {right}",
                (got.theta - want.theta).abs()
            );
        }
    }

    /// The points (±1, ±2, ±2), with r = 3, are asked first in each test.
    fn examine_first() {
        let (theta, phi) = ((2.0 / 3.0_f64).acos(), 2f64.atan());
        let mut octants = Vec::new();
        for (z, theta) in [(2.0, theta), (-2.0, PI - theta)] {
            for (x, y, phi) in [
                (1.0, 2.0, phi),
                (-1.0, 2.0, PI - phi),
                (1.0, -2.0, -phi),
                (-1.0, -2.0, phi - PI),
            ] {
                octants.push((DVec3::new(x, y, z), Spherical { r: 3.0, theta, phi }));
            }
        }
        for &(p, s) in &octants {
            examine_cartesian(s, p);
        }
        for &(p, s) in &octants {
            examine_spherical(p, s);
        }
    }

    #[test]
    fn known_points() {
        examine_first();
        // (1, 1, √2): r² = 4; the ring's radius √2 equals z; x equals y.
        let (p, s) = (
            DVec3::new(1.0, 1.0, SQRT_2),
            Spherical {
                r: 2.0,
                theta: FRAC_PI_4,
                phi: FRAC_PI_4,
            },
        );
        examine_cartesian(s, p);
        examine_spherical(p, s);
        // Once round the equator.
        for (x, y, phi) in [
            (3.0, 0.0, 0.0),
            (0.0, 3.0, FRAC_PI_2),
            (-3.0, 0.0, PI),
            (0.0, -3.0, -FRAC_PI_2),
        ] {
            let s = Spherical {
                r: 3.0,
                theta: FRAC_PI_2,
                phi,
            };
            let p = DVec3::new(x, y, 0.0);
            examine_cartesian(s, p);
            examine_spherical(p, s);
        }
    }

    #[test]
    fn every_octant() {
        examine_first();
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
            let s = Spherical { r, theta, phi };
            examine_cartesian(s, p);
            examine_spherical(p, s);
        }
    }

    #[test]
    fn there_and_back() {
        examine_first();
        let mut inputs = Inputs::new(6);
        for _ in 0..400 {
            let p = inputs.whole_vector(-9, 9);
            let s = to_spherical(p);
            let back = to_cartesian(s);
            // Both ways together.
            let bound = 4.0 * BOUND * p.length();
            assert!(
                is_near(back, p, bound),
                "{} there is {}, and back {} (off by {:.1e}, allowed is {bound:.1e})",
                brief(p),
                show(s),
                brief(back),
                (back - p).abs().max_element(),
            );
        }
    }

    fn examine_poles() {
        for (z, theta) in [(7.0, 0.0), (-7.0, PI), (0.0, 0.0)] {
            let s = Spherical {
                r: f64::abs(z),
                theta,
                phi: 0.0,
            };
            examine_spherical(DVec3::new(0.0, 0.0, z), s);
        }
    }

    #[test]
    fn poles_and_origin() {
        examine_first();
        examine_poles();
    }

    #[test]
    fn either_zero() {
        examine_first();
        examine_poles();
        for x in [0.0, -0.0, 3.0, -3.0] {
            for y in [0.0, -0.0, 3.0, -3.0] {
                for z in [0.0, -0.0, 3.0, -3.0] {
                    // The same point, each −0 made 0 by adding 0.
                    let (signed, plain) = (DVec3::new(x, y, z), DVec3::new(x, y, z) + DVec3::ZERO);
                    let (got, want) = (to_spherical(signed), to_spherical(plain));
                    assert!(
                        got.phi == want.phi,
                        "to_spherical of {}: φ is {}, and {} for {}: −0 is 0, so φ is 0 where x = y = 0, and π, not −π, \
                         where y = 0 and x < 0",
                        brief(signed),
                        brief_number(got.phi),
                        brief_number(want.phi),
                        brief(plain),
                    );
                    assert!(
                        got == want,
                        "to_spherical of {}: got {}, and {} for {}: −0 is 0",
                        brief(signed),
                        show(got),
                        show(want),
                        brief(plain),
                    );
                }
            }
        }
    }

    #[test]
    fn near_the_pole_and_far_away() {
        examine_first();
        // How well z / r tells θ and x / √(x² + y²) tells φ where they are nearly 1, and so on.
        let flat = |quotient: &str, angle: &str, better: &str| {
            format!(
                "{quotient} is nearly ±1 here, where it hardly changes with {angle} and does not tell it to this bound; \
                 {better} does",
            )
        };
        for aside in [1e-9, 1e-6, 1e-3] {
            let angle = f64::atan(aside);
            for (p, theta, phi) in [
                ([aside, 0.0, 1.0], angle, 0.0),
                ([-aside, 0.0, -1.0], PI - angle, PI),
                ([0.0, aside, 1.0], angle, FRAC_PI_2),
                ([0.0, 1.0, aside], FRAC_PI_2 - angle, FRAC_PI_2),
                ([1.0, aside, 0.0], FRAC_PI_2, angle),
                ([-1.0, -aside, 0.0], FRAC_PI_2, angle - PI),
                ([aside, 1.0, 0.0], FRAC_PI_2, FRAC_PI_2 - angle),
            ] {
                let p = DVec3::from_array(p);
                let got = to_spherical(p);
                let what = format!("to_spherical of {}: got {}", brief(p), show(got));
                let beside_axis = p.z.abs() > 0.5;
                for (letter, got, want, why) in [
                    (
                        "φ",
                        got.phi,
                        phi,
                        if beside_axis {
                            "φ is 0 only where x = y = 0, without a tolerance".to_owned()
                        } else {
                            flat("x or y over √(x² + y²)", "φ", "y / x")
                        },
                    ),
                    (
                        "θ",
                        got.theta,
                        theta,
                        if beside_axis {
                            flat("z / r", "θ", "√(x² + y²) / z")
                        } else {
                            flat("√(x² + y²) / r", "θ", "√(x² + y²) / z")
                        },
                    ),
                ] {
                    assert!(
                        (got - want).abs() <= BOUND,
                        "{what}, but {letter} is {} (off by {:.1e}, allowed is {BOUND:.1e}): {why}",
                        brief_number(want),
                        (got - want).abs(),
                    );
                }
            }
        }
        for scale in [1e3, 1e6, 1e9, 5e149, 1e-3, 1e-6, 1e-9, 5e-151] {
            let s = Spherical {
                r: 2.0 * scale,
                theta: FRAC_PI_4,
                phi: FRAC_PI_4,
            };
            let p = scale * DVec3::new(1.0, 1.0, SQRT_2);
            examine_cartesian(s, p);
            examine_spherical(p, s);
        }
    }
}
