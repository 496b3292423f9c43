//! The shadow matrices and the plain forms of the formula against the exact one: every entry, the sign of w, and
//! how far off rounding can lead.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_math::glam::{DVec3, DVec4, dvec3, dvec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_shadows::planar::{
    Placement, cast, classify, ground_matrix_directional, ground_matrix_point, shadow_matrix,
    textbook,
};
use ombra_tests::cases::{Random, case};
use ombra_tests::shadow::{Decision, ExactShadow};

fn by_quotient(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_quotient(plane, light, v, &mut ())
}

fn by_parameter(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_parameter(plane, light, v, &mut ())
}

const MAX: f64 = f64::MAX;

/// The smallest double above zero.
const LEAST: f64 = 5e-324;

const fn plane(a: f64, b: f64, c: f64, d: f64) -> Plane {
    Plane {
        normal: dvec3(a, b, c),
        d,
    }
}

#[test]
fn ground_matrices_at_the_ends() {
    for l in [DVec3::ZERO, DVec3::X, dvec3(1.0, -0.0, 1.0)] {
        assert!(ground_matrix_directional(l).is_err(), "{l}");
        assert!(ground_matrix_point(l).is_err(), "{l}");
    }
    // L_x/L_y beyond the doubles has no matrix with last row 0 0 0 1; the homogeneous one exists.
    assert!(ground_matrix_directional(dvec3(1.0, LEAST, 0.0)).is_err());
    assert!(shadow_matrix(Plane::GROUND, dvec4(1.0, LEAST, 0.0, 0.0)).is_ok());
    for l in [
        dvec3(LEAST, LEAST, LEAST),
        dvec3(MAX, MAX, MAX),
        dvec3(1e300, 1e300, 1e300),
    ] {
        let m = ground_matrix_directional(l).unwrap();
        // All three have the direction (1, 1, 1).
        assert_eq!(
            m * dvec4(5.0, 2.0, 7.0, 1.0),
            dvec4(3.0, 0.0, 5.0, 1.0),
            "{l}"
        );
        let m = ground_matrix_point(l).unwrap();
        assert!(m.is_finite());
        assert_eq!(m.row(3), dvec4(0.0, -1.0, 0.0, l.y), "{l}");
    }
}

/// Every entry of the matrix against M = (π·L) I − L πᵀ without rounding, over the whole range: one power of two
/// for all entries, and only where plain products leave the range of doubles.
#[test]
fn matrix_entries_over_the_whole_range() {
    let mut random = Random::new(21);
    let (mut matrices, mut scaled) = (0, 0);
    for _ in 0..20_000 {
        let case = case(&mut random);
        let (pi, mut light) = (case.plane.coefficients().to_array(), case.light);
        let Some(exact) = ExactShadow::new(case.plane, light, DVec3::ZERO) else {
            assert!(shadow_matrix(case.plane, light).is_err());
            continue;
        };
        if exact.decision() == Decision::LightAlongPlane {
            assert!(shadow_matrix(case.plane, light).is_err(), "{case:?}");
            continue;
        }
        let m = shadow_matrix(case.plane, light).unwrap_or_else(|e| panic!("{e}: {case:?}"));
        matrices += 1;

        // w ≥ 0 for the light, and π·L > 0 by turning the plane.
        if light.w < 0.0 {
            light = -light;
        }
        let product =
            |i: usize, j: usize| Exact::new(light[i]).unwrap() * Exact::new(pi[j]).unwrap();
        let s: Exact = (0..4).map(|k| product(k, k)).sum();
        let turned = s.sign().is_lt();
        let entry = |i: usize, j: usize| {
            // The diagonal without L_j π_j, which cancels.
            let entry = if i == j {
                &s - product(i, i)
            } else {
                -product(i, j)
            };
            if turned { -entry } else { entry }
        };
        let size = |i: usize, j: usize| {
            if i != j {
                return product(i, j).abs();
            }
            (0..4)
                .filter(|&k| k != i)
                .map(|k| product(k, k).abs())
                .sum()
        };
        // The power of two, read off the largest entry.
        let all: Vec<(usize, usize)> = (0..16).map(|k| (k / 4, k % 4)).collect();
        let (i, j) = all
            .iter()
            .copied()
            .max_by(|a, b| m.col(a.1)[a.0].abs().total_cmp(&m.col(b.1)[b.0].abs()))
            .unwrap();
        assert!(m.is_finite() && m.col(j)[i] != 0.0, "{case:?}: {m}");
        let shift = power_between(&entry(i, j), m.col(j)[i]);
        scaled += usize::from(shift != 0);
        for &(i, j) in &all {
            let computed = Exact::new(m.col(j)[i]).unwrap();
            let off = (computed - entry(i, j).scaled(shift)).abs();
            // Three products and two sums, or one product; and the subnormals' last place, once each.
            let bound = size(i, j).scaled(shift - 51) + Exact::power_of_two(-1072);
            assert!(off <= bound, "({i}, {j}), 2^{shift}: {case:?}\n{m}");
        }
        // Scaled only where a product overflows or underflows.
        let leaves = |i: usize, j: usize| {
            let p = light[i] * pi[j];
            !p.is_finite() || (!p.is_normal() && light[i] != 0.0 && pi[j] != 0.0)
        };
        let sums_overflow = (0..4).any(|i| {
            let terms = (0..4).filter(|&k| k != i).map(|k| (light[k] * pi[k]).abs());
            !terms.sum::<f64>().is_finite()
        });
        if shift != 0 {
            assert!(
                sums_overflow || all.iter().any(|&(i, j)| leaves(i, j)),
                "{case:?}"
            );
        }
    }
    assert!(
        matrices > 15_000 && scaled > 1000 && scaled < matrices - 1000,
        "{matrices} {scaled}"
    );
}

/// The k for which `computed` is about `exact` · 2^k.
fn power_between(exact: &Exact, computed: f64) -> i64 {
    let computed = Exact::new(computed).unwrap().abs();
    let exact = exact.abs();
    // Bisection over 2^k: the last k with exact · 2^k < computed · √2, for which 3/2 will do.
    let above = computed.scaled(-1);
    let limit = computed + above;
    let (mut low, mut high) = (-10_000, 10_000);
    while high - low > 1 {
        let middle = (low + high) / 2;
        if exact.scaled(middle) < limit {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// w of M (V, 1) is positive exactly for the vertices on the light's side that are below its height.
#[test]
fn w_tells_true_shadows() {
    let mut random = Random::new(22);
    let mut seen = [0; 2];
    for _ in 0..20_000 {
        // Whole numbers this small are multiplied and added without rounding.
        let mut whole = || f64::from(random.below(41)) - 20.0;
        let plane = plane(whole(), whole(), whole(), whole());
        let (light, v) = (
            dvec4(whole(), whole(), whole(), whole()),
            dvec3(whole(), whole(), whole()),
        );
        let Ok(m) = shadow_matrix(plane, light) else {
            continue;
        };
        let w = (m * v.extend(1.0)).w;
        match classify(plane, light, v).unwrap() {
            Placement::Casts => assert!(w > 0.0),
            Placement::LevelWithLight => assert_eq!(w, 0.0),
            Placement::BeyondLight => assert!(w < 0.0),
            Placement::BehindPlane | Placement::LightAlongPlane => continue,
        }
        seen[usize::from(w > 0.0)] += 1;
    }
    assert!(seen.iter().all(|&n| n > 1000), "{seen:?}");
}

/// The plain forms agree with the exact one where nothing is lost: on whole numbers below 2⁵³ the quotient is
/// the nearest double, and the parameter is off by its three roundings.
#[test]
fn plain_forms_on_whole_numbers() {
    let mut random = Random::new(23);
    let mut compared = 0;
    for _ in 0..20_000 {
        let mut whole = || f64::from(random.below(201)) - 100.0;
        let plane = plane(whole(), whole(), whole(), whole());
        let mut light = dvec4(whole(), whole(), whole(), 1.0);
        let v = dvec3(whole(), whole(), whole());
        if compared % 2 == 0 {
            light.w = 0.0;
        }
        let exact = cast(plane, light, v);
        assert_eq!(by_quotient(plane, light, v), exact, "{plane:?} {light} {v}");
        let by_parameter = by_parameter(plane, light, v);
        let (Some(exact), Some(p)) = (exact, by_parameter) else {
            assert_eq!((exact, by_parameter), (None, None), "{plane:?} {light} {v}");
            continue;
        };
        compared += 1;
        let start = if light.w == 0.0 { v } else { light.truncate() };
        for j in 0..3 {
            // |k (V − L)| = |P − L| is rounded twice, the sum once and the reference once.
            let bound =
                f64::EPSILON * (1.0 + 1e-9) * ((exact[j] - start[j]).abs() + exact[j].abs());
            let off = (p[j] - exact[j]).abs();
            assert!(off <= bound, "{plane:?} {light} {v}: {p} against {exact}");
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// The quotient form against the error that its roundings can add up to: with S = Σ|π_i L_i| and T = Σ|n_i V_i| +
/// |d|, s and t are off by 4 roundings of S and T, numerator and denominator by 6, and the division adds one:
///
/// ```text
/// |P̃_j − P_j| ≤ 3 ε [S |V_j| + T |L_j| + (S + T |L_w|) |P_j|] / |W̃| + ½ ε |P_j|
/// ```
///
/// Not |s V_j| + |t L_j|, which is smaller where s or t itself cancels.
#[test]
fn the_quotients_bound() {
    let mut random = Random::new(24);
    let mut compared = 0;
    while compared < 10_000 {
        let mut number = || random.between(-8.0, 8.0);
        let plane = plane(number(), number(), number(), number());
        let (mut light, mut v) = (
            dvec4(number(), number(), number(), number()),
            dvec3(number(), number(), number()),
        );
        let (n, pi) = (plane.normal, plane.coefficients());
        match compared % 3 {
            0 => light.w = 0.0,
            // Close to the plane, where t cancels.
            1 => {
                v.x = -(n.y * v.y + n.z * v.z + plane.d) / n.x * (1.0 + random.between(-1e-9, 1e-9))
            }
            _ => {}
        }
        let (Some(exact), Some(p)) = (cast(plane, light, v), by_quotient(plane, light, v)) else {
            continue;
        };
        compared += 1;
        let (s_terms, t_terms) = (
            (pi * light).abs().element_sum(),
            (n * v).abs().element_sum() + plane.d.abs(),
        );
        let w_terms = s_terms + t_terms * light.w.abs();
        let w = (pi.dot(light) - light.w * (n.dot(v) + plane.d)).abs();
        // The denominator as it was rounded is at least this; 10⁻⁶ is for the roundings of the bound itself.
        let least_w = w - 6.0 * f64::EPSILON * w_terms;
        if least_w <= 0.0 {
            continue;
        }
        for j in 0..3 {
            let terms = s_terms * v[j].abs() + t_terms * light[j].abs() + w_terms * exact[j].abs();
            let bound = (3.0 * terms / least_w + exact[j].abs()) * f64::EPSILON * (1.0 + 1e-6);
            let off = (p[j] - exact[j]).abs();
            assert!(
                off <= bound,
                "{plane:?} {light} {v}: off {off:e}, bound {bound:e}"
            );
        }
    }
}
