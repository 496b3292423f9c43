//! What ombra-hsr states.

use ombra_hsr::image_space::hits;
use ombra_hsr::pair::{CutPlane, tolerance};
use ombra_hsr::polygon::Polygon;
use ombra_hsr::z_buffer::precision::depth_step;
use ombra_hsr::z_buffer::{Depth16, Depth24};
use ombra_math::camera::SightLine;
use ombra_math::glam::DVec3;
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, minus};
use ombra_tests::cases::Random;

use super::share::{Share, Worst, eps, length, q3, smallest};
use super::to_300_bits::{q, quotient};

pub fn shares() -> Vec<Share> {
    let mut random = Random::new(13);
    [
        areas(&mut random),
        planes(&mut random),
        sight_lines(&mut random),
        steps(&mut random),
    ]
    .concat()
}

fn largest(points: &[DVec3]) -> f64 {
    let sizes = points.iter().map(|p| p.abs().max_element());
    sizes.fold(0.0, f64::max)
}

/// A convex pentagon, thin and far from the origin by chance.
fn pentagon(random: &mut Random) -> Vec<DVec3> {
    let first = random.direction() * 2.0_f64.powi(random.below(16) as i32);
    let (u, v) = (random.direction(), random.direction());
    let v = u + v * 2.0_f64.powi(-(random.below(20) as i32));
    let outline = [DVec3::ZERO, u, u + v, 0.5 * u + 1.5 * v, v];
    outline.map(|p| first + p).to_vec()
}

fn areas(random: &mut Random) -> Vec<Share> {
    let (mut area, mut centre) = (Worst::default(), Worst::default());
    for _ in 0..400 {
        let polygon = Polygon {
            vertices: pentagon(random),
        };
        let m = q(largest(&polygon.vertices));
        let from_first: Vec<[Exact; 3]> = polygon
            .vertices
            .iter()
            .map(|&v| minus(&q3(v), &q3(polygon.vertices[0])))
            .collect();
        let crosses: Vec<_> = from_first.windows(2).map(|p| cross(&p[0], &p[1])).collect();
        let whole: [Exact; 3] = std::array::from_fn(|k| crosses.iter().map(|c| &c[k]).sum());
        let right = length(&whole) * q(0.5);
        area.see(polygon.area(), &right, &(eps(8.0 * 5.0) * m.squared()));
        let Some(found) = polygon.centroid() else {
            continue;
        };
        let weights: Vec<_> = crosses.iter().map(|c| dot(c, &whole)).collect();
        let total = weights.iter().sum::<Exact>() * q(3.0);
        let bound = quotient(&(eps(16.0 * 5.0) * m.squared() * &m), &right) + smallest();
        for k in 0..3 {
            let moment: Exact = (weights.iter().zip(from_first.windows(2)))
                .map(|(w, p)| w * (&p[0][k] + &p[1][k]))
                .sum();
            let right = q(polygon.vertices[0][k]) + quotient(&moment, &total);
            centre.see(found[k], &right, &bound);
        }
    }
    vec![
        area.of("ombra_hsr::polygon::Polygon::area"),
        centre.of("ombra_hsr::polygon::Polygon::centroid"),
    ]
}

fn planes(random: &mut Random) -> Vec<Share> {
    let (mut distance, mut split) = (Worst::default(), Worst::default());
    for _ in 0..400 {
        let polygon = pentagon(random);
        // A plane through three points among the polygon's, as the edges of other polygons make them.
        let near = |random: &mut Random| {
            polygon[random.below(5) as usize] + random.direction() * random.power_of_two(-30, 0)
        };
        let made_of = [(); 3].map(|()| near(random));
        let Some(plane) = Plane::of_triangle(made_of[0], made_of[1], made_of[2]) else {
            continue;
        };
        let Some(cut) = CutPlane::of(plane) else {
            continue;
        };
        let m = largest(&polygon).max(largest(&made_of));
        let (n, tolerance) = (q3(plane.normal), q(tolerance(m)));
        let from_plane = |p: &[Exact; 3]| quotient(&(dot(&n, p) + q(plane.d)), &length(&n));
        for &v in &polygon {
            distance.see(cut.distance(v), &from_plane(&q3(v)), &(&tolerance * q(0.5)));
        }
        let crossings = cut.split(&polygon, 0.0)[0].clone();
        for x in crossings.iter().filter(|x| !polygon.contains(x)) {
            let off = from_plane(&q3(*x)).abs();
            split.see(0.0, &off, &tolerance);
            // The place on an edge where its plane is crossed, by the coordinate that changes most.
            let beside = (0..5).map(|i| {
                let (a, b) = (polygon[i], polygon[(i + 1) % 5]);
                let k = (b - a).abs().max_position();
                let t = quotient(&(q(x[k]) - q(a[k])), &(q(b[k]) - q(a[k])));
                let t = t.max(q(0.0)).min(q(1.0));
                (0..3)
                    .map(|j| (q(x[j]) - q(a[j]) - &t * (q(b[j]) - q(a[j]))).abs())
                    .max()
                    .unwrap()
            });
            split.see(0.0, &beside.min().unwrap(), &(eps(2.0) * q(m)));
        }
    }
    vec![
        distance.of("ombra_hsr::pair::CutPlane::distance"),
        split.of("ombra_hsr::pair::CutPlane::split"),
    ]
}

fn sight_lines(random: &mut Random) -> Vec<Share> {
    let mut worst = Worst::default();
    for _ in 0..600 {
        let vertices = [(); 3].map(|()| random.direction() * random.power_of_two(-3, 3));
        let origin = random.direction() * random.power_of_two(-3, 10);
        let by = [(); 3].map(|()| random.between(0.0, 1.0));
        let inside = (by[0] * vertices[0] + by[1] * vertices[1] + by[2] * vertices[2])
            / (by[0] + by[1] + by[2]);
        let line = SightLine {
            origin,
            direction: inside - origin,
        };
        let polygon = Polygon {
            vertices: vertices.to_vec(),
        };
        let [a, b, c] = vertices.map(q3);
        let n = cross(&minus(&b, &a), &minus(&c, &a));
        for hit in hits(&[polygon], line) {
            let right = quotient(
                &dot(&n, &minus(&a, &q3(line.origin))),
                &dot(&n, &q3(line.direction)),
            );
            let bound = Exact::power_of_two(-40) * &right + smallest();
            worst.see(hit.t, &right, &bound);
        }
    }
    vec![worst.of("ombra_hsr::image_space::hits")]
}

fn steps(random: &mut Random) -> Vec<Share> {
    let mut worst = Worst::default();
    for _ in 0..1000 {
        let near = random.power_of_two(-10, 10) * random.between(1.0, 2.0);
        let far = near * (1.0 + random.power_of_two(-30, 20));
        let distance = random.between(near, far).clamp(near, far);
        let [n, f, z] = [near, far, distance].map(q);
        let slope = quotient(&(z.squared() * (&f - &n)), &(&f * &n));
        for (found, bits) in [
            (depth_step::<Depth16>(near, far, distance), 16),
            (depth_step::<Depth24>(near, far, distance), 24),
        ] {
            let right = quotient(&slope, &(Exact::power_of_two(bits) - q(1.0)));
            worst.see(found.unwrap(), &right, &(eps(3.5) * &right));
        }
    }
    vec![worst.of("ombra_hsr::z_buffer::precision::depth_step")]
}
