//! What ombra-raster states.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_oracle::Exact;
use ombra_oracle::vector::{exact, turn};
use ombra_raster::attributes::{along, perspective, weights, weights_plain};
use ombra_raster::depth_format::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};
use ombra_raster::span::Span;
use ombra_raster::triangle_setup::{Corner, Cull, Setup};
use ombra_tests::cases::Random;

use super::share::{Share, Worst, eps};
use super::to_300_bits::{q, quotient};

pub fn shares() -> Vec<Share> {
    let mut random = Random::new(14);
    [
        attributes(&mut random),
        set_up(&mut random),
        formats(&mut random),
    ]
    .concat()
}

/// λ of `p`.
fn shares_of(triangle: [DVec2; 3], p: DVec2) -> [Exact; 3] {
    let [a, b, c] = triangle.map(|p| exact(p).unwrap());
    let p = exact(p).unwrap();
    let whole = turn(&a, &b, &c);
    [turn(&b, &c, &p), turn(&c, &a, &p), turn(&a, &b, &p)].map(|part| quotient(&part, &whole))
}

fn attributes(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 3] = Default::default();
    for _ in 0..500 {
        let mut triangle = [(); 3].map(|()| random.direction().truncate() * 40.0 + 45.0);
        if random.below(3) == 0 {
            // A sliver.
            let [a, b, _] = triangle;
            let t = random.between(0.0, 1.0);
            triangle[2] = a + t * (b - a) + random.direction().truncate() * 1e-6;
        }
        let by = [(); 3].map(|()| random.between(0.0, 1.0));
        let sum: f64 = by.iter().sum();
        let p = (by[0] * triangle[0] + by[1] * triangle[1] + by[2] * triangle[2]) / sum;
        let right = shares_of(triangle, p);
        let Some(found) = weights_plain(triangle, p) else {
            continue;
        };
        for k in 0..3 {
            worst[0].see_nearest(found[k], &right[k]);
        }
        // In the triangle, which the rounding of p may have left.
        if right.iter().all(|share| *share >= 0)
            && let Some(by) = weights(triangle, p)
        {
            let (values, w) = (
                random.direction().to_array(),
                [(); 3].map(|()| random.power_of_two(-6, 6)),
            );
            let parts: [Exact; 3] = std::array::from_fn(|k| quotient(&right[k], &q(w[k])));
            let exact = (0..3).map(|k| &parts[k] * q(values[k])).sum::<Exact>();
            let exact = quotient(&exact, &parts.iter().sum());
            let most = DVec3::from_array(values).abs().max_element();
            let found = perspective(by, values, w).unwrap();
            worst[1].see(found, &exact, &(eps(140.0) * q(most)));
        }
        let start = random.below(90);
        let span = Span {
            y: random.below(90),
            x: start..start + 1 + random.below(60),
        };
        let at = |x: u32| {
            let centre = DVec2::new(f64::from(x) + 0.5, f64::from(span.y) + 0.5);
            shares_of(triangle, centre)
        };
        let (first, last) = (at(span.x.start), at(span.x.end - 1));
        if let Some(found) = along(triangle, &span) {
            for (x, by) in span.x.clone().zip(found) {
                let right = at(x);
                for k in 0..3 {
                    let bound = eps(128.0) * first[k].abs().max(last[k].abs());
                    worst[2].see(by[k], &right[k], &bound);
                }
            }
        }
    }
    vec![
        worst[0].of("ombra_raster::attributes::weights_plain"),
        worst[1].of("ombra_raster::attributes::perspective"),
        worst[2].of("ombra_raster::attributes::along"),
    ]
}

fn set_up(random: &mut Random) -> Vec<Share> {
    let (mut edges, mut values) = (Worst::default(), Worst::default());
    for _ in 0..300 {
        let corners = [(); 3].map(|()| {
            let p = random.direction().truncate() * 20.0 + 10.0;
            Corner::snapped(p, random.between(0.0, 1.0), 1.0)
        });
        let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else {
            continue;
        };
        let place = |c: &Corner| [c.x, c.y].map(Exact::from);
        let [a, b, c] = setup.corners.map(place);
        let whole = turn(&a, &b, &c);
        for (x, y, found) in setup.pixels(24, 24) {
            let centre = [x, y].map(|i| Exact::from(256 * i + 128));
            let right = [
                turn(&b, &c, &centre),
                turn(&c, &a, &centre),
                turn(&a, &b, &centre),
            ];
            for k in 0..3 {
                edges.see(found[k], &right[k], &q(0.0));
            }
            let right = (0..3)
                .map(|k| &right[k] * q(setup.corners[k].value))
                .sum::<Exact>();
            let right = quotient(&right, &whole);
            values.see(setup.value(found), &right, &(eps(2.5) * &right));
        }
    }
    vec![
        edges.of("ombra_raster::triangle_setup::Setup::pixels"),
        edges.of("ombra_raster::triangle_setup::Setup::edges_at"),
        values.of("ombra_raster::triangle_setup::Setup::value"),
    ]
}

fn formats(random: &mut Random) -> Vec<Share> {
    let (mut decoded, mut spacing, mut value) = Default::default();
    fn bits<F: DepthFormat>(
        stored: F::Stored,
        integer: u32,
        most: u32,
        [decoded, spacing]: [&mut Worst; 2],
    ) {
        let step = quotient(&q(1.0), &Exact::from(most));
        decoded.see_nearest(F::decode(stored), &(&step * Exact::from(integer)));
        spacing.see_nearest(F::spacing(0.5), &step);
    }
    let _: (&Worst, &Worst, &Worst) = (&decoded, &spacing, &value);
    for _ in 0..1000 {
        let k = random.below(1 << 24);
        bits::<Depth24>(k, k, (1 << 24) - 1, [&mut decoded, &mut spacing]);
        bits::<Depth16>(k as u16, k & 0xffff, 0xffff, [&mut decoded, &mut spacing]);
        let single = random.between(0.0, 1.0) as f32;
        decoded.see_nearest(Depth32F::decode(single), &q(f64::from(single)));

        let (z, w) = (random.between(-1.0, 1.0), random.between(1.0, 8.0));
        let z = z * w;
        let p = DVec4::new(0.0, 0.0, z, w);
        let twice = q(2.0) * q(w);
        let right = quotient(&(q(w) + q(z)), &twice);
        value.see(Depth32F::value(p), &right, &(eps(1.0) * &right));
        let right = quotient(&(q(w) - q(z)), &twice);
        value.see(ReversedDepth32F::value(p), &right, &(eps(1.0) * &right));
    }
    let path = |name: &str| format!("ombra_raster::depth_format::DepthFormat::{name}");
    vec![
        decoded.of(&path("decode")),
        spacing.of(&path("spacing")),
        value.of(&path("value")),
    ]
}
