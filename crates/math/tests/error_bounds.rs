//! Each bound that a page of this crate states in a line `- Error: …`, against exact numbers; with `--nocapture` the worst
//! that was found, as a share of the bound.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod to_300_bits;

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::view::{Viewport, frustum, look_at, orthographic};
use ombra_math::{exact, homogeneous, solids, spherical, triangle};
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact as point, minus};
use to_300_bits::{angle, q, quotient, root, sine_and_cosine, trim};

const EPS: f64 = f64::EPSILON;

/// Seeded numbers, the same on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 ^ self.0 >> 29).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11
    }

    /// Between −1 and 1.
    fn unit(&mut self) -> f64 {
        self.bits() as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Of any exponent from −`e` to `e`.
    fn wide(&mut self, e: i32) -> f64 {
        let exponent = (self.bits() % (2 * e as u64 + 1)) as i32 - e;
        libm::scalbn(self.unit(), exponent)
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }

    fn wide_vector(&mut self, e: i32) -> DVec3 {
        DVec3::new(self.wide(e), self.wide(e), self.wide(e))
    }
}

/// The largest share of a bound that errors took.
#[derive(Default)]
struct Worst(f64);

impl Worst {
    fn see(&mut self, found: f64, right: &Exact, bound: &Exact) {
        let off = (q(found) - right).abs();
        if off > *bound {
            panic_with(found, right, bound);
        }
        if bound.is_zero() {
            return;
        }
        self.0 = self.0.max(off.ratio(bound));
    }

    fn report(&self, name: &str) {
        println!("{name}: {:.2} of the bound", self.0);
        assert!(self.0 > 0.0, "{name}: nothing was measured");
    }
}

#[allow(clippy::panic, reason = "a test that cannot go on fails")]
fn panic_with(found: f64, right: &Exact, bound: &Exact) {
    panic!(
        "{found:e} instead of {:e}, bound {:e}",
        right.nearest(),
        bound.nearest()
    );
}

fn sum(terms: impl IntoIterator<Item = Exact>) -> Exact {
    terms.into_iter().sum()
}

fn eps(k: f64) -> Exact {
    q(k * EPS)
}

/// Half the smallest double.
fn least() -> Exact {
    Exact::power_of_two(-1075)
}

#[test]
fn points_of_cameras() {
    let mut random = Random(1);
    let (mut at, mut clip, mut pixel) = (Worst::default(), Worst::default(), Worst::default());
    for _ in 0..3000 {
        let line = SightLine {
            origin: random.wide_vector(20),
            direction: random.vector(),
        };
        let t = random.wide(20);
        let p = line.at(t);
        for i in 0..3 {
            let step = q(line.direction[i]) * q(t);
            let bound = eps(1.0) * (q(line.origin[i]).abs() + step.abs());
            at.see(p[i], &(q(line.origin[i]) + step), &bound);
        }
        let m = DMat4::from_cols_array(&core::array::from_fn(|_| random.wide(6)));
        let camera = Camera {
            view_projection: m,
            viewport: Viewport {
                width: 640,
                height: 480,
            },
        };
        let world = random.wide_vector(6);
        let terms = |i: usize| [0, 1, 2, 3].map(|j| q(m.row(i)[j]) * q(world.extend(1.0)[j]));
        let absolute = |i: usize| sum(terms(i).map(|x| x.abs()));
        let c = camera.to_clip(world);
        for i in 0..4 {
            clip.see(c[i], &sum(terms(i)), &(eps(3.0) * absolute(i)));
        }
        let w = sum(terms(3));
        if let Some(found) = camera.to_pixel(world) {
            let k = quotient(&(0..4).map(absolute).max().unwrap(), &w);
            // Where w itself is mostly rounding, the first-order bound says nothing.
            if k > 1e9 {
                continue;
            }
            for (i, (size, sign)) in [(640.0, 1.0), (480.0, -1.0), (1.0, 1.0)]
                .into_iter()
                .enumerate()
            {
                let ndc = quotient(&sum(terms(i)), &w);
                let bound = eps(3.0) * &k * (q(1.0) + ndc.abs()) * q(size);
                pixel.see(
                    found[i],
                    &((q(sign) * ndc + q(1.0)) * q(0.5) * q(size)),
                    &bound,
                );
            }
        }
    }
    at.report("camera::SightLine::at");
    clip.report("camera::Camera::to_clip");
    pixel.report("camera::Camera::to_pixel");
}

/// The minors of three homogeneous planes, and what they would be without any minus sign.
fn meet(planes: &[[Exact; 4]; 3]) -> ([Exact; 4], [Exact; 4]) {
    let minor = |columns: [usize; 3], signless: bool| {
        let mut total = Exact::ZERO;
        for (k, [i, j, l]) in [
            [0, 1, 2],
            [1, 2, 0],
            [2, 0, 1],
            [0, 2, 1],
            [2, 1, 0],
            [1, 0, 2],
        ]
        .into_iter()
        .enumerate()
        {
            let term = &planes[0][columns[i]] * &planes[1][columns[j]] * &planes[2][columns[l]];
            total += if signless {
                term.abs()
            } else if k < 3 {
                term
            } else {
                -term
            };
        }
        total
    };
    let of = |signless: bool| {
        let m = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].map(|c| minor(c, signless));
        let [x, y, z, w] = m;
        if signless {
            [x, y, z, w]
        } else {
            [x, -y, z, -w]
        }
    };
    (of(false), of(true))
}

#[test]
fn eyes_and_sight_lines() {
    let mut random = Random(2);
    let (mut place, mut towards, mut origin, mut along) = (
        Worst::default(),
        Worst::default(),
        Worst::default(),
        Worst::default(),
    );
    for round in 0..1500 {
        let view = look_at(random.vector() * 9.0, random.vector(), random.vector()).unwrap();
        let near = 0.1 + random.unit().abs();
        let projection = if round % 3 == 0 {
            orthographic(-2.0, 1.0, -1.0, 1.5, near, near + 5.0)
        } else {
            frustum(-2.0, 1.0, -1.0, 1.5, near, near + 5.0)
        };
        let camera = Camera {
            view_projection: projection.unwrap() * view * random.wide(100),
            viewport: Viewport {
                width: 320,
                height: 200,
            },
        };
        let row = |i: usize| camera.view_projection.row(i).to_array().map(q);
        let eye = camera.eye().unwrap();
        let (e, p) = meet(&[row(0), row(1), row(3)]);
        if eye.w == 1.0 {
            for i in 0..3 {
                let right = quotient(&e[i], &e[3]);
                let bound = eps(4.0) * (&p[i] + right.abs() * &p[3]);
                let bound = quotient(&bound, &e[3].abs());
                place.see(eye[i], &right, &bound);
            }
        } else {
            let length = root(&sum([0, 1, 2].map(|i| e[i].squared())));
            for i in 0..3 {
                let right = quotient(&e[i].abs(), &length);
                let bound = eps(4.0) * p[..3].iter().sum::<Exact>();
                let bound = quotient(&bound, &length);
                towards.see(eye[i].abs(), &right, &bound);
            }
        }
        let at = DVec2::new(random.unit().abs() * 320.0, random.unit().abs() * 200.0);
        let line = camera.sight_line(at).unwrap();
        let ndc = [
            quotient(&q(2.0 * at.x), &q(320.0)) - q(1.0),
            q(1.0) - quotient(&q(2.0 * at.y), &q(200.0)),
        ];
        let [x, y, z, w] = [row(0), row(1), row(2), row(3)];
        let planes = |sign: f64| {
            [
                core::array::from_fn(|j| {
                    if sign < 0.0 {
                        &x[j] - &ndc[0] * &w[j]
                    } else {
                        x[j].abs() + (&ndc[0] * &w[j]).abs()
                    }
                }),
                core::array::from_fn(|j| {
                    if sign < 0.0 {
                        &y[j] - &ndc[1] * &w[j]
                    } else {
                        y[j].abs() + (&ndc[1] * &w[j]).abs()
                    }
                }),
                core::array::from_fn(|j| {
                    if sign < 0.0 {
                        &z[j] + &w[j]
                    } else {
                        z[j].abs() + w[j].abs()
                    }
                }),
            ]
        };
        let ((o, _), (_, p)) = (meet(&planes(-1.0)), meet(&planes(1.0)));
        for i in 0..3 {
            let right = quotient(&o[i], &o[3]);
            let bound = eps(8.0) * (&p[i] + right.abs() * &p[3]);
            origin.see(line.origin[i], &right, &quotient(&bound, &o[3].abs()));
        }
        let ([column, line_row, _], [c, r, _]) = (planes(-1.0), planes(1.0));
        let cross = |u: &[Exact; 4], v: &[Exact; 4], plus: bool| {
            [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
                let (a, b) = (&u[i] * &v[j], &u[j] * &v[i]);
                if plus { a + b } else { a - b }
            })
        };
        let (d, size) = (cross(&column, &line_row, false), cross(&c, &r, true));
        let length = root(&dot(&d, &d));
        for (i, d) in d.iter().enumerate() {
            let bound = quotient(&(eps(8.0) * size.iter().sum::<Exact>()), &length);
            let right = quotient(&d.abs(), &length);
            along.see(line.direction[i].abs(), &right, &bound);
        }
    }
    place.report("camera::Camera::eye, a place");
    towards.report("camera::Camera::eye, a direction");
    origin.report("camera::Camera::sight_line, origin");
    along.report("camera::Camera::sight_line, direction");
}

#[test]
fn planes() {
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
    distance.report("plane::Plane::signed_distance");
    value.report("homogeneous::incidence");
    scaled.report("exact::dot");
    moved.report("plane::Plane::offset");
}

#[test]
fn triangles() {
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
    normal.report("triangle::normal");
    area.report("triangle::area");
    share.report("triangle::barycentric");
    face.report("triangle::face_normal");
}

#[test]
fn spherical_coordinates() {
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
    r.report("spherical::Spherical::from_cartesian, r");
    theta.report("spherical::Spherical::from_cartesian, θ");
    phi.report("spherical::Spherical::from_cartesian, φ");
    back.report("spherical::Spherical::to_cartesian");
    element.report("spherical::solid_angle_element");
    area.report("spherical::area_element");
}

#[test]
fn pictures_and_solids() {
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
    pixel.report("view::Viewport::to_pixel");
    corner.report("solids::tetrahedron");
    ball.report("solids::sphere");
    ring.report("solids::torus");
}

/// Those that are exact, or the nearest double, have no share of a bound: half a last place of the answer is none.
#[test]
fn the_nearest_double() {
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
}
