//! A ray against planes and outlines: a rounded value with its bound first, exact sums where that leaves a doubt.

use core::cmp::Ordering;

use ombra_math::camera::SightLine;
use ombra_math::double_double::DoubleDouble;
use ombra_math::exact::Sum;
use ombra_math::glam::{DVec3, DVec4};

/// Differences, products and sums of a triple product round eight times, by ε/2 each; twice that leaves room for the
/// rounding of the bound.
const ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// A rounded value and a bound of its error.
#[derive(Clone, Copy)]
struct Rounded {
    value: f64,
    bound: f64,
}

impl Rounded {
    fn sign(self) -> Option<Ordering> {
        // Not `>=`: 0 with the bound 0 is exact, but rare, and NaN must not pass.
        if self.value.abs() > self.bound {
            self.value.partial_cmp(&0.0)
        } else {
            None
        }
    }
}

/// Whether products of three coordinates stay clear of overflow and underflow, so that bounds hold.
pub(super) fn is_ordinary(p: DVec3) -> bool {
    p.to_array().into_iter().all(DoubleDouble::in_range)
}

/// A sight line, ready to be intersected.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    origin: DVec3,
    direction: DVec3,
    ordinary: bool,
}

impl Ray {
    /// `None` for a line that is not finite or has no direction.
    pub(super) fn new(line: SightLine) -> Option<Self> {
        let SightLine { origin, direction } = line;
        let valid = origin.is_finite() && direction.is_finite() && direction != DVec3::ZERO;
        valid.then(|| Self {
            origin,
            direction,
            ordinary: is_ordinary(origin) && is_ordinary(direction),
        })
    }

    /// On which side the edge a → b is passed: the sign of D·((A − O) × (B − O)), exact.
    pub(super) fn passes(&self, a: DVec3, b: DVec3, ordinary: bool) -> Ordering {
        if self.ordinary && ordinary {
            let (u, v) = (a - self.origin, b - self.origin);
            let rounded = Rounded {
                value: self.direction.dot(u.cross(v)),
                bound: ROUNDINGS * self.direction.abs().dot(size_of_cross(u, v)),
            };
            if let Some(sign) = rounded.sign() {
                return sign;
            }
        }
        let mut sum = Sum::default();
        add_turn(&mut sum, self.direction, [a, b, self.origin], 1.0);
        sum.sign().unwrap_or(Ordering::Equal)
    }
}

/// |u| × |v| with every minus a plus: what the coordinates of u × v are differences of.
pub(super) fn size_of_cross(u: DVec3, v: DVec3) -> DVec3 {
    let (u, v) = (u.abs(), v.abs());
    DVec3::new(
        u.y * v.z + u.z * v.y,
        u.z * v.x + u.x * v.z,
        u.x * v.y + u.y * v.x,
    )
}

/// Adds sign · a·(b × c).
fn add_triple(sum: &mut Sum, a: DVec3, b: DVec3, c: DVec3, sign: f64) {
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        sum.add([sign * a[i], b[j], c[k]]);
        sum.add([-sign * a[i], b[k], c[j]]);
    }
}

/// Adds sign · v·(A × B + B × C + C × A).
fn add_turn(sum: &mut Sum, v: DVec3, [a, b, c]: [DVec3; 3], sign: f64) {
    for [p, q] in [[a, b], [b, c], [c, a]] {
        add_triple(sum, v, p, q, sign);
    }
}

/// What a plane is given by, exactly.
#[derive(Clone, Copy)]
enum Given {
    Corners([DVec3; 3]),
    Coefficients(DVec4),
}

/// A plane to be met by rays.
#[derive(Clone, Copy)]
pub(super) struct Target {
    given: Given,
    normal: DVec3,
    /// What the coordinates of the normal are differences of, for its error bound.
    size: DVec3,
    pub(super) ordinary: bool,
}

impl Target {
    pub(super) fn of_triangle(corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners;
        Self {
            given: Given::Corners(corners),
            normal: (b - a).cross(c - a),
            size: size_of_cross(b - a, c - a),
            ordinary: corners.into_iter().all(is_ordinary),
        }
    }

    pub(super) fn of_coefficients(plane: DVec4) -> Self {
        let normal = plane.truncate();
        Self {
            given: Given::Coefficients(plane),
            normal,
            size: normal.abs(),
            ordinary: is_ordinary(normal) && DoubleDouble::in_range(plane.w),
        }
    }

    /// n·D: how fast the ray comes through.
    fn speed(&self, ray: &Ray) -> Rounded {
        Rounded {
            value: self.normal.dot(ray.direction),
            bound: ROUNDINGS * self.size.dot(ray.direction.abs()),
        }
    }

    /// −(n·O + d): how far off the plane the origin is, against the normal.
    fn distance(&self, ray: &Ray) -> Rounded {
        let (value, size) = match self.given {
            Given::Corners([a, ..]) => {
                let way = a - ray.origin;
                (self.normal.dot(way), self.size.dot(way.abs()))
            }
            Given::Coefficients(plane) => (
                -(self.normal.dot(ray.origin) + plane.w),
                self.size.dot(ray.origin.abs()) + plane.w.abs(),
            ),
        };
        Rounded {
            value,
            bound: ROUNDINGS * size,
        }
    }

    fn exact_speed(&self, ray: &Ray) -> Sum {
        match self.given {
            Given::Corners(corners) => {
                let mut sum = Sum::default();
                add_turn(&mut sum, ray.direction, corners, 1.0);
                sum
            }
            Given::Coefficients(plane) => Sum::dot(plane, ray.direction.extend(0.0), 1.0),
        }
    }

    fn exact_distance(&self, ray: &Ray) -> Sum {
        match self.given {
            Given::Corners([a, b, c]) => {
                let mut sum = Sum::default();
                add_triple(&mut sum, a, b, c, 1.0);
                add_turn(&mut sum, ray.origin, [a, b, c], -1.0);
                sum
            }
            Given::Coefficients(plane) => Sum::dot(plane, ray.origin.extend(1.0), -1.0),
        }
    }

    /// Where the ray comes through, before its origin too; `None` along the plane.
    #[inline]
    pub(super) fn meet(&self, ray: &Ray) -> Option<Meeting> {
        if self.ordinary && ray.ordinary {
            let (n, d) = (self.distance(ray), self.speed(ray));
            let t = n.value / d.value;
            let least = d.value.abs() - d.bound;
            // |N̂/D̂ − N/D| ≤ (δN + |t| δD) / (|D̂| − δD), and the division rounds.
            let error = (n.bound + t.abs() * d.bound) / least + f64::EPSILON * t.abs();
            // Below the normal doubles a bound may vanish, and with it the sign.
            if least > 0.0 && error <= t.abs() * ACCURACY && t.abs() >= f64::MIN_POSITIVE {
                return Some(Meeting {
                    t,
                    error,
                    along: d.value > 0.0,
                    is_behind: t < 0.0,
                });
            }
        }
        self.meet_exactly(ray)
    }

    #[cold]
    fn meet_exactly(&self, ray: &Ray) -> Option<Meeting> {
        let speed = self.exact_speed(ray);
        let sign = speed.sign().filter(|&sign| sign != Ordering::Equal)?;
        let distance = self.exact_distance(ray);
        let t = distance.quotient(&speed);
        t.is_finite().then_some(Meeting {
            t,
            error: f64::EPSILON * t.abs() + f64::from_bits(1),
            along: sign == Ordering::Greater,
            is_behind: distance.sign() == Some(sign.reverse()),
        })
    }
}

/// Largest relative error of a parameter that is taken as it comes.
const ACCURACY: f64 = f64::EPSILON * 4096.0;

/// Where a ray meets a plane: t = N/D.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    pub(super) t: f64,
    /// A bound of the error of t.
    error: f64,
    /// Whether the ray comes through along the normal: D > 0.
    along: bool,
    /// Whether it does so before its origin: t < 0, also where t is rounded to 0.
    pub(super) is_behind: bool,
}

/// Which of two meetings comes first on the ray: exact for ordinary coordinates, by the nearest doubles of t beyond.
pub(super) fn order(
    ray: &Ray,
    first: (&Target, &Meeting),
    second: (&Target, &Meeting),
) -> Ordering {
    let ((a, m), (b, n)) = (first, second);
    if (m.t - n.t).abs() > m.error + n.error {
        return m.t.total_cmp(&n.t);
    }
    // N₁/D₁ < N₂/D₂  ⇔  N₁ D₂ − N₂ D₁ < 0, turned round by the sign of D₁ D₂.
    let turned = m.along != n.along;
    match determinant(ray, a, b) {
        Some(sign) if turned => sign.reverse(),
        Some(sign) => sign,
        None => m.t.total_cmp(&n.t),
    }
}

/// Whether a meeting with `target` lies in front of the plane `limit` or on it: n·P + d ≥ 0, exact for ordinary
/// coordinates.
pub(super) fn is_within(ray: &Ray, target: &Target, meeting: &Meeting, limit: &Target) -> bool {
    let (n, d) = (limit.distance(ray), limit.speed(ray));
    // At t the value is t D − N.
    let rounded = Rounded {
        value: meeting.t * d.value - n.value,
        bound: n.bound
            + meeting.t.abs() * d.bound
            + meeting.error * d.value.abs()
            + ROUNDINGS * (meeting.t * d.value).abs(),
    };
    if limit.ordinary
        && ray.ordinary
        && target.ordinary
        && let Some(sign) = rounded.sign()
    {
        return sign == Ordering::Greater;
    }
    match determinant(ray, target, limit) {
        // N₁/D₁ D₂ − N₂, times D₁.
        Some(sign) if meeting.along => sign != Ordering::Less,
        Some(sign) => sign != Ordering::Greater,
        None => rounded.value >= 0.0,
    }
}

/// The sign of N₁ D₂ − N₂ D₁, or `None` where its parts leave the range of doubles.
#[cold]
fn determinant(ray: &Ray, first: &Target, second: &Target) -> Option<Ordering> {
    sign_of_minor(&Quotient::of(ray, first)?, &Quotient::of(ray, second)?)
}

/// t = N/D, exactly.
struct Quotient {
    n: Vec<f64>,
    d: Vec<f64>,
}

impl Quotient {
    /// `None` where its parts leave the range of doubles.
    fn of(ray: &Ray, target: &Target) -> Option<Self> {
        Some(Self {
            n: parts(target.exact_distance(ray))?,
            d: parts(target.exact_speed(ray))?,
        })
    }
}

/// The sign of N₁ D₂ − N₂ D₁.
fn sign_of_minor(a: &Quotient, b: &Quotient) -> Option<Ordering> {
    let mut sum = Sum::default();
    for (ns, ds, sign) in [(&a.n, &b.d, 1.0), (&b.n, &a.d, -1.0)] {
        for &n in ns {
            for &d in ds {
                sum.add([sign, n, d]);
            }
        }
    }
    sum.sign()
}

/// A primitive that a ray meets.
#[derive(Clone, Copy)]
pub(super) struct Met {
    /// As it was submitted.
    pub(super) index: usize,
    pub(super) target: Target,
    pub(super) meeting: Meeting,
}

/// Sorts what a ray meets by t and then as submitted: exactly for ordinary coordinates, by the nearest doubles of t
/// beyond.
pub(super) fn sort(ray: &Ray, found: &mut [Met]) {
    found.sort_by(|a, b| a.meeting.t.total_cmp(&b.meeting.t));
    // What rounding may have mixed up lies side by side: runs in which errors overlap. Twice the error, as its own
    // bounds are rounded.
    let mut runs: Vec<(usize, f64)> = Vec::new();
    for (i, Met { meeting, .. }) in found.iter().enumerate() {
        let Meeting { t, error, .. } = *meeting;
        let (low, mut high, mut start) = (t - 2.0 * error, t + 2.0 * error, i);
        while let Some((before, farthest)) = runs.pop_if(|(_, farthest)| low <= *farthest) {
            (start, high) = (before, high.max(farthest));
        }
        runs.push((start, high));
    }
    let mut rest = found;
    for (start, _) in runs.into_iter().rev() {
        let (before, run) = rest.split_at_mut(start);
        if run.len() > 1 {
            sort_exactly(ray, run);
        }
        rest = before;
    }
}

/// Each t is made exact once, not once a comparison.
fn sort_exactly(ray: &Ray, run: &mut [Met]) {
    let exact = run.iter().map(|met| Quotient::of(ray, &met.target));
    let mut sorted: Vec<Met> = if let Some(exact) = exact.collect::<Option<Vec<_>>>() {
        let mut keyed: Vec<_> = exact.into_iter().zip(run.iter().copied()).collect();
        keyed.sort_by(|(s, a), (t, b)| {
            let sign = sign_of_minor(s, t).unwrap_or(Ordering::Equal);
            let is_turned = a.meeting.along != b.meeting.along;
            let order = if is_turned { sign.reverse() } else { sign };
            order.then(a.index.cmp(&b.index))
        });
        keyed.into_iter().map(|(_, met)| met).collect()
    } else {
        let nearest = |met: &Met| {
            let (n, d) = (met.target.exact_distance(ray), met.target.exact_speed(ray));
            n.quotient(&d)
        };
        let mut keyed: Vec<_> = run.iter().map(|met| (nearest(met), *met)).collect();
        keyed.sort_by(|(s, a), (t, b)| s.total_cmp(t).then(a.index.cmp(&b.index)));
        keyed.into_iter().map(|(_, met)| met).collect()
    };
    run.swap_with_slice(&mut sorted);
}

/// A sum as doubles that add up to it exactly.
fn parts(mut sum: Sum) -> Option<Vec<f64>> {
    let mut parts = Vec::new();
    while sum.sign()? != Ordering::Equal {
        let part = sum.to_f64();
        // Zero: what is left is below the smallest double.
        if part == 0.0 || !part.is_finite() {
            return None;
        }
        sum.add([-part, 1.0, 1.0]);
        parts.push(part);
    }
    Some(parts)
}
