//! One random case of each, in units of ε.

use ombra_clip::{Segment, crossing};
use ombra_hsr::z_buffer::precision::depth_at;
use ombra_math::exact;
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4};
use ombra_math::homogeneous::{incidence, project};
use ombra_math::plane::Plane;
use ombra_math::triangle::{area, barycentric, normal};
use ombra_math::view::{frustum, frustum_infinite, orthographic};
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot as inner, exact as point, minus};
use ombra_raster::attributes::{linear, perspective_weights, weights};
use ombra_raster::triangle::edge_function;
use ombra_shadows::planar::{cast, shadow_matrix};
use ombra_tests::cases::Random;

/// A measured bound: the worst of one random case, in units of ε times what `unit` says.
pub struct Measured {
    pub path: &'static str,
    pub unit: &'static str,
    /// The bound, in the same units.
    pub most: f64,
    case: fn(&mut Random) -> f64,
}

/// Random cases of each; a third of them next to a degenerate one, where the case has such.
pub const CASES: u32 = 1000;
/// 2⁻⁴¹, 2⁻⁴⁰ and 2⁻³⁹ in units of ε.
const BITS_41: f64 = 2048.0;

const fn of(
    path: &'static str,
    unit: &'static str,
    most: f64,
    case: fn(&mut Random) -> f64,
) -> Measured {
    Measured {
        path,
        unit,
        most,
        case,
    }
}

/// The worst that a measured function does, over all cases.
pub fn worst(measured: &Measured) -> f64 {
    let mut random = Random::new(measured.path.bytes().map(u64::from).sum());
    most((0..CASES).map(|_| (measured.case)(&mut random)))
}

#[rustfmt::skip]
pub const MEASURED: &[Measured] = &[
    of("ombra_clip::crossing::at_x", "|value|", 0.5, crossing_at_x),
    of("ombra_hsr::z_buffer::precision::depth_at", "|value|", 2.5, depth),
    of("ombra_math::exact::Sum::quotient", "|value|", 0.5, quotient_of_sums),
    of("ombra_math::exact::dot", "|value|", 1.0, dot),
    of("ombra_math::homogeneous::incidence", "|value|", 1.0, plane_and_point),
    of("ombra_math::homogeneous::project", "|coordinate|", 0.5, projected),
    of("ombra_math::plane::Plane::signed_distance", "|value|", 4.0, distance),
    of("ombra_math::triangle::area", "|value|", 2.0 * BITS_41, triangle_area),
    of("ombra_math::triangle::barycentric", "|w| / |n|", 4.0 * BITS_41, coordinates),
    of("ombra_math::triangle::normal", "|component|", BITS_41, triangle_normal),
    of("ombra_math::view::frustum", "|entry|", 2.0, frustum_entries),
    of("ombra_math::view::frustum_infinite", "|entry|", 2.0, infinite_entries),
    of("ombra_math::view::orthographic", "|entry|", 2.0, orthographic_entries),
    of("ombra_raster::attributes::linear", "Σ|λᵢ aᵢ|", 2.0, mixture),
    of("ombra_raster::attributes::perspective_weights", "|μᵢ|", 5.0, in_perspective),
    of("ombra_raster::attributes::weights", "|λᵢ|", 64.0, on_screen),
    of("ombra_raster::triangle::edge_function", "its two |products|", 2.01, edge),
    of("ombra_shadows::planar::cast", "|coordinate|", 0.5, shadow),
    of("ombra_shadows::planar::shadow_matrix", "Σ of an entry's |terms|", 2.0, matrix),
];

fn q(x: f64) -> Exact {
    Exact::new(x).unwrap_or_else(|| panic!("{x} is no number"))
}

fn q3(v: DVec3) -> [Exact; 3] {
    point(v).unwrap_or_else(|| panic!("{v} is no point"))
}

/// x / y, which must not be 0.
fn quotient(x: &Exact, y: &Exact) -> Exact {
    x.over(y).unwrap_or_else(|| panic!("{x} by 0"))
}

/// |computed − exact| in units of ε times `scale`; what is exactly 0 must be 0.
fn off(computed: f64, exact: &Exact, scale: &Exact) -> f64 {
    let error = (q(computed) - exact).abs();
    if error.is_zero() {
        return 0.0;
    }
    error.ratio(scale) / f64::EPSILON
}

fn relative(computed: f64, exact: &Exact) -> f64 {
    let error = q(computed) - exact;
    match (error.is_zero(), exact.is_zero()) {
        (true, _) => 0.0,
        (_, true) => f64::INFINITY,
        _ => off(computed, exact, &exact.abs()),
    }
}

/// The relative error of `computed` as the square root of `square`: with r = computed² / square, √r − 1.
fn of_root(computed: f64, square: &Exact) -> f64 {
    if square.is_zero() {
        return if computed == 0.0 { 0.0 } else { f64::INFINITY };
    }
    let x = (q(computed).squared() - square).ratio(square);
    (x / 2.0 - x * x / 8.0).abs() / f64::EPSILON
}

fn most(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

fn number(random: &mut Random) -> f64 {
    random.exponential(-20, 20)
}
fn vector(random: &mut Random) -> DVec3 {
    DVec3::new(number(random), number(random), number(random))
}
/// `x` moved by a relative distance of 10⁻¹⁶ to 10⁻⁸.
fn beside(random: &mut Random, x: f64) -> f64 {
    x * (1.0 + random.exponential(-53, -27))
}
/// A plane and a point, in one of three cases next to it.
fn plane_and_near(random: &mut Random) -> (Plane, DVec3) {
    let (plane, mut p) = (
        Plane {
            normal: vector(random),
            d: number(random),
        },
        vector(random),
    );
    if random.below(3) == 0 {
        let n = plane.normal;
        p.x = beside(random, -(n.y * p.y + n.z * p.z + plane.d) / n.x);
    }
    (plane, p)
}
/// A triangle of one size, in one of three cases a needle.
fn triangle(random: &mut Random) -> [DVec3; 3] {
    let [a, b, mut c] = [(); 3].map(|()| random.direction());
    if random.below(3) == 0 {
        let t = random.between(-1.0, 2.0);
        c = (a + t * (b - a)).map(|x| beside(random, x));
    }
    [a, b, c]
}
fn value_of(plane: Plane, p: DVec3) -> Exact {
    inner(&q3(plane.normal), &q3(p)) + q(plane.d)
}

fn plane_and_point(random: &mut Random) -> f64 {
    let (plane, p) = plane_and_near(random);
    relative(
        incidence(plane.coefficients(), p.extend(1.0)),
        &value_of(plane, p),
    )
}
fn distance(random: &mut Random) -> f64 {
    let (plane, p) = plane_and_near(random);
    let (value, n) = (value_of(plane, p), q3(plane.normal));
    let computed = plane.signed_distance(p);
    assert_eq!(computed < 0.0, value < 0, "the sign is exact");
    of_root(computed, &quotient(&value.squared(), &inner(&n, &n)))
}
fn dot(random: &mut Random) -> f64 {
    let (plane, p) = plane_and_near(random);
    let (f, e) = exact::dot(plane.coefficients(), p.extend(1.0));
    relative(f * 2.0_f64.powi(e), &value_of(plane, p))
}
fn quotient_of_sums(random: &mut Random) -> f64 {
    let [a, b] = [(); 2].map(|()| [(); 3].map(|()| [(); 3].map(|()| number(random))));
    let sum = |terms: &[[f64; 3]; 3]| {
        terms
            .iter()
            .map(|t| q(t[0]) * q(t[1]) * q(t[2]))
            .sum::<Exact>()
    };
    let computed = exact::Sum::of(&a).quotient(&exact::Sum::of(&b));
    relative(computed, &quotient(&sum(&a), &sum(&b)))
}
fn projected(random: &mut Random) -> f64 {
    let p = vector(random).extend(number(random));
    let Some(point) = project(p) else {
        return f64::INFINITY;
    };
    most((0..3).map(|i| relative(point[i], &quotient(&q(p[i]), &q(p.w)))))
}
fn exact_normal([a, b, c]: [DVec3; 3]) -> [Exact; 3] {
    let [a, b, c] = [a, b, c].map(q3);
    cross(&minus(&b, &a), &minus(&c, &a))
}
fn triangle_normal(random: &mut Random) -> f64 {
    let [a, b, c] = triangle(random);
    let (computed, n) = (normal(a, b, c), exact_normal([a, b, c]));
    most((0..3).map(|i| relative(computed[i], &n[i])))
}
fn triangle_area(random: &mut Random) -> f64 {
    let [a, b, c] = triangle(random);
    let n = exact_normal([a, b, c]);
    of_root(area(a, b, c), &inner(&n, &n).scaled(-2))
}
fn coordinates(random: &mut Random) -> f64 {
    let ([a, b, c], p) = (triangle(random), random.direction());
    let n = exact_normal([a, b, c]);
    let square = inner(&n, &n);
    let Some(computed) = barycentric(p, a, b, c) else {
        return if square.is_zero() { 0.0 } else { f64::INFINITY };
    };
    let own = [[p, b, c], [a, p, c], [a, b, p]].map(exact_normal);
    most((0..3).map(|i| {
        let error = q(computed[i]) - quotient(&inner(&own[i], &n), &square);
        let scale = quotient(&inner(&own[i], &own[i]), &square);
        error.squared().ratio(&scale).sqrt() / f64::EPSILON
    }))
}

fn entries(computed: DMat4, rows: [[Exact; 4]; 4]) -> f64 {
    most((0..16).map(|k| relative(computed.col(k % 4)[k / 4], &rows[k / 4][k % 4])))
}
/// l, r, b, t, n, f: differences that cancel, in one of three cases f next to n.
fn bounds(random: &mut Random) -> [f64; 6] {
    let mut x = [(); 6].map(|()| number(random));
    x[4] = x[4].abs();
    x[5] = if random.below(3) == 0 {
        beside(random, x[4])
    } else {
        x[5].abs()
    };
    if x[4] == x[5] { bounds(random) } else { x }
}
fn frustum_entries(random: &mut Random) -> f64 {
    let x = bounds(random);
    let Ok(m) = frustum(x[0], x[1], x[2], x[3], x[4], x[5]) else {
        return f64::INFINITY;
    };
    let ([l, r, b, t, n, f], o, two) = (x.map(q), || q(0.0), q(2.0));
    entries(
        m,
        [
            [
                quotient(&(&two * &n), &(&r - &l)),
                o(),
                quotient(&(&r + &l), &(&r - &l)),
                o(),
            ],
            [
                o(),
                quotient(&(&two * &n), &(&t - &b)),
                quotient(&(&t + &b), &(&t - &b)),
                o(),
            ],
            [
                o(),
                o(),
                -quotient(&(&f + &n), &(&f - &n)),
                -quotient(&(&two * &f * &n), &(&f - &n)),
            ],
            [o(), o(), q(-1.0), o()],
        ],
    )
}
fn infinite_entries(random: &mut Random) -> f64 {
    let x = bounds(random);
    let Ok(m) = frustum_infinite(x[0], x[1], x[2], x[3], x[4]) else {
        return f64::INFINITY;
    };
    let ([l, r, b, t, n, _], o, two) = (x.map(q), || q(0.0), q(2.0));
    entries(
        m,
        [
            [
                quotient(&(&two * &n), &(&r - &l)),
                o(),
                quotient(&(&r + &l), &(&r - &l)),
                o(),
            ],
            [
                o(),
                quotient(&(&two * &n), &(&t - &b)),
                quotient(&(&t + &b), &(&t - &b)),
                o(),
            ],
            [o(), o(), q(-1.0), -(&two * &n)],
            [o(), o(), q(-1.0), o()],
        ],
    )
}
fn orthographic_entries(random: &mut Random) -> f64 {
    let x = bounds(random);
    let Ok(m) = orthographic(x[0], x[1], x[2], x[3], x[4], x[5]) else {
        return f64::INFINITY;
    };
    let ([l, r, b, t, n, f], o, two) = (x.map(q), || q(0.0), q(2.0));
    entries(
        m,
        [
            [
                quotient(&two, &(&r - &l)),
                o(),
                o(),
                -quotient(&(&r + &l), &(&r - &l)),
            ],
            [
                o(),
                quotient(&two, &(&t - &b)),
                o(),
                -quotient(&(&t + &b), &(&t - &b)),
            ],
            [
                o(),
                o(),
                -quotient(&two, &(&f - &n)),
                -quotient(&(&f + &n), &(&f - &n)),
            ],
            [o(), o(), o(), q(1.0)],
        ],
    )
}

fn plane_triangle(random: &mut Random) -> [DVec2; 3] {
    triangle(random).map(DVec3::truncate)
}
fn turn(a: DVec2, b: DVec2, p: DVec2) -> [Exact; 2] {
    let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, p.x, p.y].map(q);
    [(&bx - &ax) * (&py - &ay), (&by - &ay) * (&px - &ax)]
}
fn edge(random: &mut Random) -> f64 {
    let [a, b, p] = plane_triangle(random);
    let [x, y] = turn(a, b, p);
    off(edge_function(a, b, p), &(&x - &y), &(x.abs() + y.abs()))
}
fn on_screen(random: &mut Random) -> f64 {
    let ([a, b, c], p) = (plane_triangle(random), random.direction().truncate());
    let value = |a, b, p| {
        let [x, y] = turn(a, b, p);
        x - y
    };
    let whole = value(a, b, c);
    let Some(computed) = weights([a, b, c], p) else {
        return if whole.is_zero() { 0.0 } else { f64::INFINITY };
    };
    let exact = [value(b, c, p), value(c, a, p), value(a, b, p)];
    most((0..3).map(|i| relative(computed[i], &quotient(&exact[i], &whole))))
}
fn mixture(random: &mut Random) -> f64 {
    let (by, values) = (vector(random), vector(random));
    let terms: [Exact; 3] = std::array::from_fn(|i| q(by[i]) * q(values[i]));
    let scale = terms.iter().map(Exact::abs).sum::<Exact>();
    off(linear(by, values.to_array()), &terms.iter().sum(), &scale)
}
fn in_perspective(random: &mut Random) -> f64 {
    let (by, w) = (vector(random).abs(), vector(random).abs());
    let Some(computed) = perspective_weights(by, w.to_array()) else {
        return f64::INFINITY;
    };
    let parts: [Exact; 3] = std::array::from_fn(|i| quotient(&q(by[i]), &q(w[i])));
    let whole = parts.iter().sum::<Exact>();
    most((0..3).map(|i| relative(computed[i], &quotient(&parts[i], &whole))))
}
fn crossing_at_x(random: &mut Random) -> f64 {
    let [a, b] = [(); 2].map(|()| DVec2::new(number(random), number(random)));
    let x = (a.x + random.between(0.0, 1.0) * (b.x - a.x)).clamp(a.x.min(b.x), a.x.max(b.x));
    let Some(computed) = crossing::at_x(Segment::new(a, b), x) else {
        return f64::INFINITY;
    };
    let [ax, ay, bx, by, x] = [a.x, a.y, b.x, b.y, x].map(q);
    relative(
        computed,
        &quotient(&(&ay * (&bx - &x) + &by * (&x - &ax)), &(&bx - &ax)),
    )
}
fn depth(random: &mut Random) -> f64 {
    let near = number(random).abs();
    let far = if random.below(3) == 0 {
        near * (1.0 + random.power_of_two(-45, -2))
    } else {
        near * random.between(1.5, 1e6)
    };
    let distance = random.between(near, far).clamp(near, far);
    let Some(computed) = depth_at(near, far, distance) else {
        return f64::INFINITY;
    };
    let [n, f, z] = [near, far, distance].map(q);
    relative(computed, &quotient(&(&f * (&z - &n)), &(&z * (&f - &n))))
}
fn shadow(random: &mut Random) -> f64 {
    let ((plane, v), light) = (
        plane_and_near(random),
        vector(random).extend(f64::from(random.below(2))),
    );
    let Some(computed) = cast(plane, light, v) else {
        return 0.0;
    };
    let (l, w) = (q3(light.truncate()), q(light.w));
    let s = inner(&q3(plane.normal), &l) + q(plane.d) * &w;
    let t = value_of(plane, v);
    let denominator = &s - &w * &t;
    most((0..3).map(|i| {
        relative(
            computed[i],
            &quotient(&(&s * q(v[i]) - &t * &l[i]), &denominator),
        )
    }))
}
fn matrix(random: &mut Random) -> f64 {
    let (plane, light) = (
        plane_and_near(random).0,
        vector(random).extend(f64::from(random.below(2))),
    );
    let Ok(m) = shadow_matrix(plane, light) else {
        return 0.0;
    };
    // The plane is turned round where π·L < 0.
    let mut plane: DVec4 = plane.coefficients();
    if (0..4).map(|i| q(plane[i]) * q(light[i])).sum::<Exact>() < 0 {
        plane = -plane;
    }
    let entry = |i: usize, j: usize| {
        let diagonal = (0..4).filter(|_| i == j).map(|k| q(plane[k]) * q(light[k]));
        diagonal
            .chain([-(q(light[i]) * q(plane[j]))])
            .collect::<Vec<Exact>>()
    };
    most((0..16).map(|k| {
        let terms = entry(k / 4, k % 4);
        let scale = terms.iter().map(Exact::abs).sum::<Exact>();
        off(m.col(k % 4)[k / 4], &terms.iter().sum(), &scale)
    }))
}
