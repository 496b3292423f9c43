//! What ombra-math states of cameras and sight lines.

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DMat4, DVec2};
use ombra_math::view::{Viewport, frustum, look_at, orthographic};
use ombra_oracle::Exact;
use ombra_oracle::vector::dot;

use super::math::{Random, sum};
use super::share::{Share, Worst, eps};
use super::to_300_bits::{q, quotient, root};

/// All that are measured here.
pub fn shares() -> Vec<Share> {
    [points_of_cameras(), eyes_and_sight_lines()].concat()
}

fn points_of_cameras() -> Vec<Share> {
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
    vec![
        at.of("ombra_math::camera::SightLine::at"),
        clip.of("ombra_math::camera::Camera::to_clip"),
        pixel.of("ombra_math::camera::Camera::to_pixel"),
    ]
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

fn eyes_and_sight_lines() -> Vec<Share> {
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
    vec![
        place.of("ombra_math::camera::Camera::eye"),
        towards.of("ombra_math::camera::Camera::eye"),
        origin.of("ombra_math::camera::Camera::sight_line"),
        along.of("ombra_math::camera::Camera::sight_line"),
    ]
}
