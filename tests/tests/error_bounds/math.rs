//! What ombra-math states of planes, triangles, spheres and pictures.

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::view::Viewport;
use ombra_math::{exact, homogeneous, solids, spherical, triangle};
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact as point, minus};

use super::share::{Share, Worst, eps};
use super::to_300_bits::{angle, q, quotient, root, sine_and_cosine, trim};

/// Seeded numbers, the same on every machine.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 ^ self.0 >> 29).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11
    }

    /// Between −1 and 1.
    pub fn unit(&mut self) -> f64 {
        self.bits() as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Of any exponent from −`e` to `e`.
    pub fn wide(&mut self, e: i32) -> f64 {
        let exponent = (self.bits() % (2 * e as u64 + 1)) as i32 - e;
        libm::scalbn(self.unit(), exponent)
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }

    pub fn wide_vector(&mut self, e: i32) -> DVec3 {
        DVec3::new(self.wide(e), self.wide(e), self.wide(e))
    }
}

/// All that are measured here.
pub fn shares() -> Vec<Share> {
    [
        planes(),
        triangles(),
        spherical_coordinates(),
        pictures_and_solids(),
        the_nearest_double(),
    ]
    .concat()
}

/// Their sum.
pub fn sum(terms: impl IntoIterator<Item = Exact>) -> Exact {
    terms.into_iter().sum()
}

/// Half the smallest double.
fn least() -> Exact {
    Exact::power_of_two(-1075)
}

fn planes() -> Vec<Share> {
    let mut random = Random(3);
    let (mut distance, mut value, mut scaled, mut moved) = (
        Worst::default(),
        Worst::default(),
        Worst::default(),
        Worst::default(),
    );
    for round in 0..4000 {
        let e = [3, 60, 400][round % 3];
        let mut plane = Plane {
            normal: random.wide_vector(e),
            d: random.wide(e),
        };
        let p = random.wide_vector(e);
        if round % 2 == 0 {
            plane.d = -plane.normal.dot(p);
        }
        let n = point(plane.normal).unwrap();
        let right = dot(&n, &point(p).unwrap()) + q(plane.d);
        let length = root(&dot(&n, &n));
        let size = right.abs();
        let signed = quotient(&right, &length);
        distance.see(
            plane.signed_distance(p),
            &signed,
            &(eps(4.0) * signed.abs() + least() * q(2.0)),
        );
        let found = homogeneous::incidence(plane.coefficients(), p.extend(1.0));
        value.see(found, &right, &(eps(1.0) * &size + least()));
        let (f, exponent) = exact::dot(plane.coefficients(), p.extend(1.0));
        scaled.see(
            f,
            &right.scaled(-i64::from(exponent)),
            &(eps(1.0) * size.scaled(-i64::from(exponent))),
        );
        let by = random.wide(e);
        let bound = eps(3.0) * q(by).abs() * &length
            + eps(0.5) * (q(plane.d) - q(by) * &length).abs()
            + least();
        moved.see(plane.offset(by).d, &(q(plane.d) - q(by) * &length), &bound);
    }
    vec![
        distance.of("ombra_math::plane::Plane::signed_distance"),
        value.of("ombra_math::homogeneous::incidence"),
        scaled.of("ombra_math::exact::dot"),
        moved.of("ombra_math::plane::Plane::offset"),
    ]
}

fn triangles() -> Vec<Share> {
    let mut random = Random(4);
    let (mut normal, mut area, mut share, mut face) = (
        Worst::default(),
        Worst::default(),
        Worst::default(),
        Worst::default(),
    );
    for round in 0..2000 {
        let e = [0, 20, 200][round % 3];
        let [a, mut b, mut c, p] = [0; 4].map(|_| random.wide_vector(e));
        if round % 2 == 0 {
            // A needle.
            let along = random.vector();
            b = a + along;
            c = a + along * random.unit() + random.vector() * libm::exp10(-(round as f64) / 150.0);
        }
        let exact_normal = |a: DVec3, b: DVec3, c: DVec3| {
            let [a, b, c] = [a, b, c].map(|p| point(p).unwrap());
            cross(&minus(&b, &a), &minus(&c, &a))
        };
        let n = exact_normal(a, b, c);
        let found = triangle::normal(a, b, c);
        for i in 0..3 {
            normal.see(found[i], &n[i], &(n[i].abs().scaled(-41) + least()));
        }
        let squared = dot(&n, &n);
        let length = root(&squared);
        area.see(
            triangle::area(a, b, c),
            &length.scaled(-1),
            &(length.scaled(-41) + least()),
        );
        if let Some(found) = triangle::barycentric(p, a, b, c) {
            for (i, w) in [[p, b, c], [a, p, c], [a, b, p]].into_iter().enumerate() {
                let w = exact_normal(w[0], w[1], w[2]);
                let size = quotient(&root(&dot(&w, &w)), &length);
                let right = quotient(&dot(&w, &n), &squared);
                share.see(found[i], &right, &(size.scaled(-39) + least()));
            }
        }
        let given = [0; 3].map(|_| random.wide_vector(e));
        let units = given.map(|v| {
            let v = point(v).unwrap();
            let length = root(&dot(&v, &v));
            v.map(|x| trim(&quotient(&x, &length)))
        });
        let n = [0, 1, 2].map(|i| sum(units.iter().map(|u| u[i].clone())));
        let length = root(&dot(&n, &n));
        let found = triangle::face_normal(given).unwrap();
        for i in 0..3 {
            face.see(
                found[i],
                &quotient(&n[i], &length),
                &(eps(4.0) * (q(1.0) + quotient(&q(3.0), &length))),
            );
        }
    }
    vec![
        normal.of("ombra_math::triangle::normal"),
        area.of("ombra_math::triangle::area"),
        share.of("ombra_math::triangle::barycentric"),
        face.of("ombra_math::triangle::face_normal"),
    ]
}

fn spherical_coordinates() -> Vec<Share> {
    let mut random = Random(5);
    let (mut r, mut theta, mut phi, mut back) = (
        Worst::default(),
        Worst::default(),
        Worst::default(),
        Worst::default(),
    );
    let (mut element, mut area) = (Worst::default(), Worst::default());
    for round in 0..120 {
        let p = random.wide_vector([0, 30, 300][round % 3]);
        let [x, y, z] = p.to_array().map(q);
        let s = spherical::Spherical::from_cartesian(p);
        let across = root(&(x.squared() + y.squared()));
        let right = root(&(x.squared() + y.squared() + z.squared()));
        r.see(s.r, &right, &(eps(2.0) * &right + least() * q(2.0)));
        let right = angle(&across, &z);
        theta.see(s.theta, &right, &(eps(2.0) * &right + least() * q(2.0)));
        let right = angle(&y.abs(), &x);
        phi.see(s.phi.abs(), &right, &(eps(2.0) * &right + least() * q(2.0)));

        let s = spherical::Spherical {
            r: random.wide(300),
            theta: random.unit().abs() * core::f64::consts::PI,
            phi: random.unit() * core::f64::consts::PI,
        };
        let ((sin_theta, cos_theta), (sin_phi, cos_phi)) =
            (sine_and_cosine(&q(s.theta)), sine_and_cosine(&q(s.phi)));
        let right = [cos_phi * &sin_theta, sin_phi * &sin_theta, cos_theta];
        for (i, right) in right.into_iter().enumerate() {
            back.see(
                s.to_cartesian()[i],
                &(right * q(s.r)),
                &(eps(4.0) * q(s.r).abs()),
            );
        }
        let found = spherical::solid_angle_element(s.theta);
        element.see(found, &sin_theta, &(eps(1.0) * &sin_theta));
        let found = spherical::area_element(s.r, s.theta);
        let right = sin_theta * q(s.r) * q(s.r);
        area.see(found, &right, &(eps(2.0) * &right + least() * q(2.0)));
    }
    vec![
        r.of("ombra_math::spherical::Spherical::from_cartesian"),
        theta.of("ombra_math::spherical::Spherical::from_cartesian"),
        phi.of("ombra_math::spherical::Spherical::from_cartesian"),
        back.of("ombra_math::spherical::Spherical::to_cartesian"),
        element.of("ombra_math::spherical::solid_angle_element"),
        area.of("ombra_math::spherical::area_element"),
    ]
}

fn pictures_and_solids() -> Vec<Share> {
    let mut random = Random(6);
    let (mut pixel, mut corner, mut ball, mut ring) = (
        Worst::default(),
        Worst::default(),
        Worst::default(),
        Worst::default(),
    );
    for _ in 0..3000 {
        let (width, height) = (
            1 + random.bits() as u32 % 5000,
            1 + random.bits() as u32 % 5000,
        );
        let ndc = random.vector();
        let found = Viewport { width, height }.to_pixel(ndc);
        let sizes = [
            (f64::from(width), 1.0),
            (f64::from(height), -1.0),
            (1.0, 1.0),
        ];
        for (i, (size, sign)) in sizes.into_iter().enumerate() {
            let right = (q(sign) * q(ndc[i]) + q(1.0)) * q(0.5) * q(size);
            pixel.see(found[i], &right, &(eps(2.0) * q(size)));
        }
    }
    let third = root(&quotient(&q(1.0), &q(3.0)));
    for p in solids::tetrahedron().positions {
        for x in p.to_array() {
            corner.see(x.abs(), &third, &eps(1.0));
        }
    }
    let length = |v: &[Exact]| root(&v.iter().map(Exact::squared).sum());
    for p in solids::sphere(0.7, 40, 20).unwrap().positions {
        let far = length(&p.to_array().map(q));
        ball.see(0.7, &far, &(eps(4.0) * q(0.7)));
    }
    for p in solids::torus(3.1, 0.7, 40, 20).unwrap().positions {
        let [x, y, z] = p.to_array().map(q);
        let from_circle = length(&[x, z]) - q(3.1);
        ring.see(0.7, &length(&[from_circle, y]), &(eps(4.0) * q(3.8)));
    }
    vec![
        pixel.of("ombra_math::view::Viewport::to_pixel"),
        corner.of("ombra_math::solids::tetrahedron"),
        ball.of("ombra_math::solids::sphere"),
        ring.of("ombra_math::solids::torus"),
    ]
}

fn the_nearest_double() -> Vec<Share> {
    let mut random = Random(7);
    let nearest = |found: f64, right: &Exact| {
        let off = (q(found) - right).abs();
        for other in [found.next_up(), found.next_down()] {
            assert!(off <= (q(other) - right).abs(), "{found:e}");
        }
    };
    for _ in 0..1000 {
        let v = DVec4::new(
            random.wide(200),
            random.wide(200),
            random.wide(200),
            random.wide(200),
        );
        let found = homogeneous::project(v).unwrap();
        for i in 0..3 {
            nearest(found[i], &quotient(&q(v[i]), &q(v.w)));
        }
        let (a, n) = (random.wide_vector(200), random.wide_vector(200));
        let found = Plane::through(a, n).unwrap();
        nearest(found.d, &-dot(&point(a).unwrap(), &point(n).unwrap()));
    }
    vec![
        Share::nearest("ombra_math::homogeneous::project"),
        Share::nearest("ombra_math::plane::Plane::through"),
    ]
}
