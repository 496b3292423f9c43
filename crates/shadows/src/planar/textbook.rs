//! The formulas as a book leaves them, in doubles: fast, and wrong where digits cancel.
//!
//! s and t cancel where the light or the vertex is close to the plane, the denominator where the vertex is almost level with
//! the light. Whether there is a shadow is then decided by rounding. [`cast_plain`](super::cast_plain) is the same
//! formula without it.

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::work::{Count, Counter};

use super::placement::towards_place;

/// The shadow of `v` by the quotient form in doubles, or `None` where there is none.
///
/// # Formula
///
/// ```text
/// P = (s V − t L) / (s − L_w t)        s = π·L,  t = n·V + d
/// ```
///
/// # Properties
///
/// The nearest double where products and sums are exact, as for the lectures' integers. The error is large where s, t or
/// s − L_w t cancel: use [`cast`](super::cast()) there. Decisions are made on the rounded s, t and s − L_w t. With
/// S = Σ|π_i L_i| and T = Σ|n_i V_i| + |d| it is in P_j
///
/// - Error: at most 3 ε (S |V_j| + T |L_j| + (S + T |L_w|) |P_j|) / |s − L_w t| + ½ ε |P_j|.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::textbook::by_quotient;
///
/// let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
/// let shadow = by_quotient(Plane::GROUND, light, DVec3::new(0.0, 20.0, 0.0), &mut ());
/// assert_eq!(shadow, Some(DVec3::new(0.0, 0.0, -25.0)));
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani»; Olomouc, «Zdroj světla v bodě».
#[inline]
#[must_use]
pub fn by_quotient(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Option<DVec3> {
    let light = towards_place(light);
    let l = light.truncate();
    let [s, t, w] = heights(plane, light, v, work);
    if !casts(s, t, w) {
        return None;
    }
    let p = (s * v - t * l) / w;
    work.add(Counter::Multiplications, 6);
    work.add(Counter::Additions, 3);
    work.add(Counter::Divisions, 3);
    p.is_finite().then_some(p)
}

/// The shadow of `v` by the parameter along its ray, in doubles, or `None` where there is none.
///
/// # Formula
///
/// ```text
/// light at a place:       P = L + k (V − L)        k = (n·L + d) / (n·(L − V))
/// light at infinity:      P = V − k L              k = (n·V + d) / (n·L)
/// ```
///
/// # Properties
///
/// k is rounded before it is used, so the result is not the nearest double even for the lectures' integers: for the
/// slides' cube it is within 2ε |P|, which is up to 3 last places. `None` also where L/L_w is beyond the largest double.
/// The error grows with the light's distance, ε |k (V − L)|: far lights lose the most. With k = n/d along the ray R from
/// the point A (V − L from L, or L from V), N and D the sums of the absolute terms of n and d, it is in P_j
///
/// - Error: at most 4 ε ((N + |k| D) |R_j| / |d| + |k| |A_j| + |A_j| + |P_j|).
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::textbook::by_parameter;
///
/// let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
/// let shadow = by_parameter(Plane::GROUND, light, DVec3::new(0.0, 20.0, 0.0), &mut ());
/// assert_eq!(shadow, Some(DVec3::new(0.0, 0.0, -25.0)));
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani», general case; Olomouc, «Zdroj v nekonečnu», «Projekce na libovolnou plochu».
#[inline]
#[must_use]
pub fn by_parameter(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Option<DVec3> {
    let light = towards_place(light);
    let l = light.truncate();
    let [s, t, w] = heights(plane, light, v, work);
    if !casts(s, t, w) {
        return None;
    }
    work.add(Counter::Multiplications, 3);
    let p = if light.w == 0.0 {
        // Against the direction of the light, down to the plane.
        let k = t / s;
        work.add(Counter::Divisions, 1);
        work.add(Counter::Additions, 3);
        v - k * l
    } else {
        // From the light's place through the vertex.
        let k = s / w;
        let place = l / light.w;
        work.add(Counter::Divisions, 4);
        work.add(Counter::Additions, 6);
        place + k * (v - place)
    };
    p.is_finite().then_some(p)
}

/// s = π·L and t = n·V + d, the heights of light and vertex times ‖n‖, and s − L_w t.
#[inline]
fn heights(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> [f64; 3] {
    let s = plane.coefficients().dot(light);
    let t = plane.normal.dot(v) + plane.d;
    let w = s - light.w * t;
    work.add(Counter::Vertices, 1);
    work.add(Counter::Multiplications, 8);
    work.add(Counter::Additions, 7);
    [s, t, w]
}

/// A true shadow: the vertex on the light's side of the plane or on it, and nearer to it than the light.
#[inline]
fn casts(s: f64, t: f64, w: f64) -> bool {
    if s < 0.0 {
        t <= 0.0 && w < 0.0
    } else {
        s > 0.0 && t >= 0.0 && w > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::super::cast;
    use super::*;
    use ombra_math::work::Work;
    use ombra_oracle::Exact;
    use proptest::prelude::*;

    type Form = fn(Plane, DVec4, DVec3) -> Option<DVec3>;
    const FORMS: [Form; 2] = [
        |plane, light, v| by_quotient(plane, light, v, &mut ()),
        |plane, light, v| by_parameter(plane, light, v, &mut ()),
    ];

    proptest! {
        /// Far from any cancellation both forms are good: a bound of this scene, against the correctly rounded answer.
        #[test]
        fn ordinary_scenes(x in prop::array::uniform3(-10.0..10.0f64), h in 0.0..10.0f64,
                           l in prop::array::uniform3(-10.0..10.0f64), w in 0u8..2) {
            let light = DVec4::new(l[0], l[1].abs() + 20.0, l[2], w.into());
            let v = DVec3::new(x[0], h, x[2]);
            let expected = cast(Plane::GROUND, light, v).unwrap();
            // s ≤ 30, |V| ≤ 10, t ≤ 10, |L| ≤ 30, denominator ≥ 10.
            let bound = 8.0 * f64::EPSILON * (30.0 * 10.0 + 10.0 * 30.0) / 10.0;
            for form in FORMS {
                let p = form(Plane::GROUND, light, v).unwrap();
                prop_assert!((p - expected).abs().max_element() <= bound, "{} {}", p, expected);
            }
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 11)) {
            let plane = Plane { normal: DVec3::new(x[0], x[1], x[2]), d: x[3] };
            let light = DVec4::new(x[4], x[5], x[6], x[7]);
            for form in FORMS {
                let shadow = form(plane, light, DVec3::new(x[8], x[9], x[10]));
                prop_assert!(shadow.is_none_or(|p| p.is_finite()));
            }
        }
    }

    /// Both stated bounds, in exact numbers, with cancellation and without; the worst shares are printed.
    #[test]
    fn errors_stay_within_the_bounds() {
        let q = |x: f64| Exact::new(x).unwrap();
        let quotient = |x: &Exact, y: &Exact| x.over(y).unwrap();
        let mut seed = 1u64;
        let mut unit = move || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let (mut compared, mut worst) = (0, [0.0f64; 2]);
        while compared < 200 {
            let mut vector = || DVec3::new(unit(), unit(), unit());
            let (mut v, normal, l) = (vector(), vector(), vector() * 9.0);
            let mut plane = Plane { normal, d: unit() };
            let mut light = l.extend(if compared % 2 == 0 { 0.0 } else { 1.0 + unit() });
            match compared % 5 {
                // A vertex almost on the plane, a light almost along it, both far from the origin.
                0 => plane.d = -normal.dot(v) * (1.0 + 1e-9 * unit()),
                1 if light.w != 0.0 => {
                    // The vertex half as high above the plane: hardly any other has a shadow.
                    let place = l / light.w;
                    plane.d = -normal.dot(place) * (1.0 + 1e-9 * unit());
                    let middle = 0.5 * (normal.dot(place) + plane.d);
                    v -= normal * (normal.dot(v) + plane.d - middle) / normal.length_squared();
                }
                2 => {
                    let far = DVec3::splat(1e6);
                    v += far;
                    plane.d -= normal.dot(far);
                    light += (far * light.w).extend(0.0);
                }
                _ => {}
            }
            let found = FORMS.map(|form| form(plane, light, v));
            let (Some(exact), [Some(by_quotient), Some(by_parameter)]) =
                (cast(plane, light, v), found)
            else {
                continue;
            };
            compared += 1;
            let light = towards_place(light);
            let pi = plane.coefficients();
            let products = |p: DVec4| [0, 1, 2, 3].map(|i| q(pi[i]) * q(p[i]));
            let total = |x: [Exact; 4]| x.into_iter().sum::<Exact>();
            let (at_light, at_vertex) = (products(light), products(v.extend(1.0)));
            let (big_s, big_t) = (
                total(at_light.each_ref().map(Exact::abs)),
                total(at_vertex.each_ref().map(Exact::abs)),
            );
            let (s, t) = (total(at_light), total(at_vertex));
            let w = &s - q(light.w) * &t;
            let big_w = &big_s + q(light.w) * &big_t;
            let eps = q(f64::EPSILON);
            for j in 0..3 {
                let (vj, lj) = (q(v[j]), q(light[j]));
                let right = quotient(&(&s * &vj - &t * &lj), &w);
                let size = right.abs();
                let terms = &big_s * vj.abs() + &big_t * lj.abs() + &big_w * &size;
                let first = quotient(&(q(3.0) * terms), &w.abs()) + q(0.5) * &size;
                let (n, d, big_n, big_d, ray, start) = if light.w == 0.0 {
                    (&t, &s, &big_t, &big_s, lj, vj)
                } else {
                    let place = quotient(&lj, &q(light.w));
                    (&s, &w, &big_s, &big_w, vj - &place, place)
                };
                let (k, start) = (quotient(n, d).abs(), start.abs());
                let along = quotient(&((big_n + &k * big_d) * ray.abs()), &d.abs());
                let second = q(4.0) * (along + &k * &start + start + &size);
                for (form, (p, bound)) in [(by_quotient, first), (by_parameter, second)]
                    .into_iter()
                    .enumerate()
                {
                    let off = (q(p[j]) - &right).abs();
                    // First-order bounds: a thousandth for the products of two roundings.
                    let bound = bound * &eps * q(1.001);
                    assert!(
                        off <= bound,
                        "form {form}, {plane:?} {light} {v}: {p} for {exact}"
                    );
                    worst[form] = worst[form].max(off.ratio(&bound));
                }
            }
        }
        println!(
            "by_quotient: {:.2} of the bound, by_parameter: {:.2}",
            worst[0], worst[1]
        );
    }

    #[test]
    fn no_false_shadows() {
        let lamp = DVec4::new(0.0, 10.0, 0.0, 1.0);
        for form in FORMS {
            for (light, y) in [
                (lamp, -1.0),
                (lamp, 10.0),
                (lamp, 11.0),
                (DVec4::Y, -1.0),
                (DVec4::X, 1.0),
            ] {
                assert_eq!(
                    form(Plane::GROUND, light, DVec3::Y * y),
                    None,
                    "{light} {y}"
                );
                assert_eq!(
                    form(Plane::GROUND.turned(), light, DVec3::Y * y),
                    None,
                    "{light} {y}"
                );
            }
            assert_eq!(form(Plane::GROUND, -lamp, DVec3::Y), Some(DVec3::ZERO));
            assert_eq!(form(Plane::GROUND, -DVec4::Y, -DVec3::Y), Some(DVec3::ZERO));
        }
    }

    #[test]
    fn counted_work_is_that_of_the_formulas() {
        let (lamp, sun) = (DVec4::new(0.0, 10.0, 0.0, 1.0), DVec4::Y);
        let mut work = Work::default();
        let _ = by_quotient(Plane::GROUND, lamp, DVec3::Y, &mut work);
        assert_eq!(
            (work.vertices, work.multiplications, work.divisions),
            (1, 14, 3)
        );
        let mut work = Work::default();
        let _ = by_parameter(Plane::GROUND, sun, DVec3::Y, &mut work);
        assert_eq!(
            (work.vertices, work.multiplications, work.divisions),
            (1, 11, 1)
        );
    }
}
