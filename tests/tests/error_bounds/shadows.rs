//! What ombra-shadows states.

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::vector::{dot, exact};
use ombra_shadows::fake::Ellipse;
use ombra_shadows::planar::textbook::{by_parameter, by_quotient};
use ombra_shadows::planar::{ground_matrix_directional, ground_matrix_point};
use ombra_tests::cases::Random;

use super::share::{Share, Worst, eps, q3};
use super::to_300_bits::{q, quotient, sine_and_cosine};

pub fn shares() -> Vec<Share> {
    let mut random = Random::new(12);
    [
        textbook(&mut random),
        grounds(&mut random),
        points(&mut random),
    ]
    .concat()
}

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.exponential(-20, 20)))
}

/// Σ|aᵢ bᵢ|.
fn size<const N: usize>(a: &[Exact; N], b: &[Exact; N]) -> Exact {
    a.iter().zip(b).map(|(a, b)| (a * b).abs()).sum()
}

fn textbook(random: &mut Random) -> Vec<Share> {
    let (mut by_s_and_t, mut parameter) = (Worst::default(), Worst::default());
    for _ in 0..3000 {
        let plane = Plane {
            normal: vector(random),
            d: random.exponential(-20, 20),
        };
        let light = vector(random).extend(f64::from(random.below(2)));
        let v = vector(random);
        let (n, l, w) = (q3(plane.normal), q3(light.truncate()), q(light.w));
        let (vertex, d) = (q3(v), q(plane.d));
        let [pi, homogeneous] =
            [plane.coefficients(), light].map(|v: DVec4| exact::<4>(v).unwrap());
        let (s, big_s) = (dot(&pi, &homogeneous), size(&pi, &homogeneous));
        let (t, big_t) = (dot(&n, &vertex) + &d, size(&n, &vertex) + d.abs());
        let below = &s - &w * &t;
        // Where the sign of the denominator is mostly rounding, the first-order bound says nothing.
        let all = &big_s + &big_t * &w;
        if below.abs() < all * Exact::power_of_two(-30) {
            continue;
        }
        let right: [Exact; 3] =
            std::array::from_fn(|j| quotient(&(&s * &vertex[j] - &t * &l[j]), &below));
        if let Some(found) = by_quotient(plane, light, v, &mut ()) {
            for j in 0..3 {
                let sum = &big_s * vertex[j].abs()
                    + &big_t * l[j].abs()
                    + (&big_s + &big_t * &w) * right[j].abs();
                let bound = eps(3.0) * quotient(&sum, &below.abs()) + eps(0.5) * right[j].abs();
                by_s_and_t.see(found[j], &right[j], &bound);
            }
        }
        if let Some(found) = by_parameter(plane, light, v, &mut ()) {
            // k = num / den along R from A.
            let to_light: [Exact; 3] = std::array::from_fn(|j| &l[j] - &vertex[j]);
            let (num, big_num, den, big_den) = if light.w == 0.0 {
                (&t, &big_t, &s, &big_s)
            } else {
                (&s, &big_s, &below, &(&big_s + &big_t))
            };
            let k = quotient(num, den).abs();
            for j in 0..3 {
                let (from, along) = if light.w == 0.0 {
                    (&vertex[j], &l[j])
                } else {
                    (&l[j], &to_light[j])
                };
                let bound = quotient(&((big_num + &k * big_den) * along.abs()), &den.abs())
                    + (&k + q(1.0)) * from.abs()
                    + right[j].abs();
                parameter.see(found[j], &right[j], &(eps(4.0) * bound));
            }
        }
    }
    vec![
        by_s_and_t.of("ombra_shadows::planar::textbook::by_quotient"),
        parameter.of("ombra_shadows::planar::textbook::by_parameter"),
    ]
}

fn grounds(random: &mut Random) -> Vec<Share> {
    let (mut directional, mut point) = (Worst::default(), Worst::default());
    for _ in 0..1000 {
        let l = vector(random);
        let m = ground_matrix_directional(l).unwrap();
        directional.see_nearest(m.y_axis.x, &-quotient(&q(l.x), &q(l.y)));
        directional.see_nearest(m.y_axis.z, &-quotient(&q(l.z), &q(l.y)));
        let m = ground_matrix_point(l).unwrap();
        let entries = [m.x_axis.x, m.y_axis.x, m.y_axis.z, m.y_axis.w, m.w_axis.w];
        for (found, right) in entries.into_iter().zip([l.y, -l.x, -l.z, -1.0, l.y]) {
            point.see_nearest(found, &q(right));
        }
    }
    vec![
        directional.of("ombra_shadows::planar::light_at_infinity::ground_matrix_directional"),
        point.of("ombra_shadows::planar::point_light::ground_matrix_point"),
    ]
}

fn points(random: &mut Random) -> Vec<Share> {
    let mut worst = Worst::default();
    for _ in 0..150 {
        let ellipse = Ellipse {
            center: random.direction(),
            u: random.direction(),
            v: random.direction(),
        };
        let phi = random.between(-7.0, 7.0);
        let (sine, cosine) = sine_and_cosine(&q(phi));
        let found = ellipse.point(phi);
        let size = |v: DVec3| super::share::length(&q3(v));
        let bound = eps(3.0) * (size(ellipse.center) + size(ellipse.u) + size(ellipse.v));
        for k in 0..3 {
            let right = q(ellipse.center[k]) + &cosine * q(ellipse.u[k]) + &sine * q(ellipse.v[k]);
            worst.see(found[k], &right, &bound);
        }
    }
    vec![worst.of("ombra_shadows::fake::Ellipse::point")]
}
