//! What ombra-math states of views, planes and numbers.

use ombra_math::double_double::DoubleDouble;
use ombra_math::exact::Sum;
use ombra_math::glam::DVec3;
use ombra_math::plane::Plane;
use ombra_math::scaling::{common, normalised, product_over, split};
use ombra_math::spherical::solid_angle;
use ombra_math::view::{look_at, perspective};
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, minus};
use ombra_tests::cases::Random;

use super::share::{Share, Worst, eps, length, q3};
use super::to_300_bits::{q, quotient, root, sine_and_cosine};

pub fn shares() -> Vec<Share> {
    let mut random = Random::new(15);
    [
        cameras(&mut random),
        lenses(&mut random),
        sums(&mut random),
        double_doubles(&mut random),
        powers(&mut random),
    ]
    .concat()
}

fn number(random: &mut Random) -> f64 {
    random.exponential(-20, 20)
}
fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| number(random)))
}
fn unit(v: &[Exact; 3]) -> [Exact; 3] {
    let length = length(v);
    v.each_ref().map(|x| quotient(x, &length).truncated(300))
}

fn cameras(random: &mut Random) -> Vec<Share> {
    let mut worst = Worst::default();
    for _ in 0..300 {
        let [eye, target, mut up] = [(); 3].map(|()| vector(random));
        if random.below(3) == 0 {
            // All but along the view.
            up = (target - eye) + random.direction() * random.power_of_two(-60, -20);
        }
        let Ok(m) = look_at(eye, target, up) else {
            continue;
        };
        let forward = minus(&q3(target), &q3(eye));
        let side = unit(&cross(&forward, &q3(up)));
        let forward = unit(&forward);
        let upward = cross(&side, &forward);
        let back = forward.each_ref().map(|x| -x);
        for (i, axis) in [side, upward, back].iter().enumerate() {
            let row = m.row(i);
            for k in 0..3 {
                worst.see(row[k], &axis[k], &eps(8.0));
            }
            // The last column belongs to the axes as they are.
            let own = q3(row.truncate());
            let right = -dot(&own, &q3(eye));
            assert!((q(row.w) - &right).abs() <= (q(right.nearest()) - &right).abs());
        }
    }
    vec![worst.of("ombra_math::view::look_at")]
}

fn lenses(random: &mut Random) -> Vec<Share> {
    let (mut lens, mut angle) = (Worst::default(), Worst::default());
    for _ in 0..150 {
        let (fov, aspect) = (random.between(1e-3, 3.1), random.between(0.1, 10.0));
        let near = random.power_of_two(-10, 10) * random.between(1.0, 2.0);
        let far = near * (1.0 + random.power_of_two(-40, 20));
        let m = perspective(fov, aspect, near, far).unwrap();
        let (sine, cosine) = sine_and_cosine(&(q(fov) * q(0.5)));
        let (n, f) = (q(near), q(far));
        let y = quotient(&cosine, &sine).truncated(400);
        for (found, right) in [
            (m.y_axis.y, y.clone()),
            (m.x_axis.x, quotient(&y, &q(aspect))),
            (m.z_axis.z, -quotient(&(&f + &n), &(&f - &n))),
            (m.w_axis.z, -quotient(&(q(2.0) * &f * &n), &(&f - &n))),
        ] {
            lens.see(found, &right, &(eps(3.0) * right.abs()));
        }
        let theta = [(); 2].map(|()| random.between(0.0, std::f64::consts::PI));
        let phi = [(); 2].map(|()| random.between(-3.0, 3.0));
        let cosine = |x: f64| sine_and_cosine(&q(x)).1;
        let right = (cosine(theta[0]) - cosine(theta[1])) * (q(phi[1]) - q(phi[0]));
        let found = solid_angle(theta[0]..theta[1], phi[0]..phi[1]);
        angle.see(found, &right, &(eps(4.0) * right.abs()));
    }
    vec![
        lens.of("ombra_math::view::perspective"),
        angle.of("ombra_math::spherical::solid_angle"),
    ]
}

fn sums(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 3] = Default::default();
    for _ in 0..1000 {
        let mut terms = [(); 4].map(|()| [(); 3].map(|()| number(random)));
        if random.below(3) == 0 {
            // All digits of the first two cancel but the last ones.
            terms[1] = [-terms[0][0], terms[0][1], terms[0][2].next_up()];
            terms[2][0] *= f64::EPSILON;
            terms[3][0] *= f64::EPSILON;
        }
        let right = terms
            .iter()
            .map(|t| q(t[0]) * q(t[1]) * q(t[2]))
            .sum::<Exact>();
        let sum = Sum::of(&terms);
        worst[0].see_nearest(sum.to_f64(), &right);
        let (f, e) = sum.to_scaled();
        worst[1].see_nearest(f, &right.scaled(-i64::from(e)));

        let [a, b, c] = [(); 3].map(|()| vector(random));
        let Some(plane) = Plane::of_triangle(a, b, c) else {
            continue;
        };
        let [a, b, c] = [a, b, c].map(q3);
        let n = cross(&minus(&b, &a), &minus(&c, &a));
        for (found, right) in plane.normal.to_array().into_iter().zip(&n) {
            worst[2].see_nearest(found, right);
        }
        worst[2].see_nearest(plane.d, &-dot(&n, &a));
    }
    vec![
        worst[0].of("ombra_math::exact::Sum::to_f64"),
        worst[1].of("ombra_math::exact::Sum::to_scaled"),
        worst[2].of("ombra_math::plane::Plane::of_triangle"),
        worst[2].of("ombra_hsr::polygon::Polygon::plane"),
    ]
}

fn double_doubles(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 5] = Default::default();
    let whole = |x: DoubleDouble| q(x.hi) + q(x.lo);
    // As both parts together have no place of their own: the high one, against the value less the low one.
    let see = |worst: &mut Worst, found: DoubleDouble, right: &Exact, k: f64| {
        let bound = q(k * f64::EPSILON * f64::EPSILON) * right.abs();
        worst.see(found.hi, &(right - q(found.lo)), &bound);
    };
    for _ in 0..2000 {
        let [a, b, c] = [(); 3].map(|()| number(random));
        let (sum, product) = (DoubleDouble::sum(a, b), DoubleDouble::product(a, b));
        see(&mut worst[0], sum, &(q(a) + q(b)), 0.0);
        see(&mut worst[1], product, &(q(a) * q(b)), 0.0);
        see(
            &mut worst[2],
            product.times(c),
            &(whole(product) * q(c)),
            1.0,
        );
        let over = product.over(sum);
        see(
            &mut worst[3],
            over,
            &quotient(&whole(product), &whole(sum)),
            4.0,
        );
        let positive = if product.hi < 0.0 { -product } else { product };
        see(&mut worst[4], positive.sqrt(), &root(&whole(positive)), 2.0);
    }
    let names = ["sum", "product", "times", "over", "sqrt"];
    let all = worst.iter().zip(names);
    all.map(|(worst, name)| worst.of(&format!("ombra_math::double_double::DoubleDouble::{name}")))
        .collect()
}

fn powers(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 4] = Default::default();
    for _ in 0..1000 {
        let factors = [(); 3].map(|()| random.exponential(-300, 300));
        let divisor = random.exponential(-50, 50);
        let right = factors.iter().map(|&x| q(x)).reduce(|x, y| x * y).unwrap();
        let right = quotient(&right, &q(divisor));
        let found = product_over(factors, divisor);
        if found.is_normal() {
            // Half of n + 1 = 4 roundings.
            worst[0].see(found, &right, &(eps(2.0) * right.abs()));
        }
        let x = factors[0];
        let (f, e) = split(x);
        worst[1].see(f, &q(x).scaled(-i64::from(e)), &q(0.0));
        let (found, e) = normalised(factors);
        let (others, top) = common(factors.map(|x| (x, 7)));
        for k in 0..3 {
            let right = q(factors[k]);
            worst[2].see(found[k], &right.scaled(-i64::from(e)), &q(0.0));
            worst[3].see(others[k], &right.scaled(7 - i64::from(top)), &q(0.0));
        }
    }
    vec![
        worst[0].of("ombra_math::scaling::product_over"),
        worst[1].of("ombra_math::scaling::split"),
        worst[2].of("ombra_math::scaling::normalised"),
        worst[3].of("ombra_math::scaling::common"),
    ]
}
