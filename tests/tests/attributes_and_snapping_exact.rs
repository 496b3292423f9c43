//! Weights and attributes against fractions, within the errors that they state; snapped vertices.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_math::glam::DVec2;
use ombra_oracle::{Exact, vector};
use ombra_raster::attributes::{linear, perspective, weights};
use ombra_raster::triangle::snap;
use ombra_tests::cases::Random;

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// Weights, slivers among them: their signs and the bounds that are stated, 64ε of each; 67ε of Σ|λa| for the linear
/// attribute; 140ε of the largest |a| for the one in perspective.
#[test]
fn stated_errors_of_attributes() {
    let mut random = Random::new(314);
    let epsilon = |k: f64| exact(k * f64::EPSILON);
    let mut slivers = 0;
    for case in 0..3000 {
        let mut place = || DVec2::new(random.between(0.0, 20.0), random.between(0.0, 20.0));
        let [a, b, mut c] = [place(), place(), place()];
        if case % 3 == 0 {
            c = a + (b - a) * random.between(0.0, 1.0);
        }
        let share = random.between(0.0, 1.0);
        let p = match case % 4 {
            0 => a + (b - a) * share,
            1 => (a + b + c) / 3.0,
            _ => DVec2::new(
                f64::from(random.below(20)) + 0.5,
                f64::from(random.below(20)) + 0.5,
            ),
        };
        let doubled = |a: DVec2, b: DVec2, p: DVec2| {
            let [a, b, p] = [a, b, p].map(|p| vector::exact(p).unwrap());
            vector::turn(&a, &b, &p)
        };
        let whole = doubled(a, b, c);
        let Some(found) = weights([a, b, c], p) else {
            assert_eq!(whole, 0, "{a} {b} {c}");
            continue;
        };
        slivers += usize::from(whole.abs() < 1e-12);
        let λ =
            [doubled(b, c, p), doubled(c, a, p), doubled(a, b, p)].map(|e| e.over(&whole).unwrap());
        for (found, λ) in found.to_array().into_iter().zip(&λ) {
            assert!(
                (exact(found) - λ).abs() <= epsilon(64.0) * λ.abs(),
                "{a} {b} {c} {p}"
            );
        }
        let values = [0; 3].map(|_| random.exponential(-20, 20));
        let w = [0; 3].map(|_| random.exponential(-40, 40).abs());
        let terms: Vec<Exact> = λ.iter().zip(values).map(|(λ, a)| λ * exact(a)).collect();
        let scale: Exact = terms.iter().map(Exact::abs).sum();
        let sum: Exact = terms.iter().sum();
        assert!(
            (exact(linear(found, values)) - sum).abs() <= epsilon(67.0) * scale,
            "{a} {b} {c} {p}"
        );
        if λ.iter().all(|λ| *λ >= 0) {
            let over_w = |terms: &[Exact]| -> Exact {
                let terms = terms.iter().zip(w);
                terms.map(|(term, w)| term.over(&exact(w)).unwrap()).sum()
            };
            let expected = over_w(&terms).over(&over_w(&λ)).unwrap();
            let off = (exact(perspective(found, values, w).unwrap()) - expected).abs();
            let largest = values.into_iter().fold(0.0, |m: f64, a| m.max(a.abs()));
            assert!(
                off <= epsilon(140.0) * exact(largest),
                "{a} {b} {c} {p} {w:?}"
            );
        }
    }
    assert!(slivers > 300, "{slivers}");
}

/// ⌊x 2ᵇ + ½⌋ / 2ᵇ without rounding, where adding the ½ in doubles would round: just below a half, and from 2⁵² on.
#[test]
fn snapped_vertices() {
    let mut random = Random::new(315);
    for case in 0..4000 {
        let bits = [0, 1, 4, 8, 31, 52, 53, 64, 200][case % 9];
        let half_up = |x: Exact| {
            let moved = x + exact(0.5);
            let whole = moved.truncated(0);
            if whole > moved {
                whole - Exact::from(1)
            } else {
                whole
            }
        };
        let half = (f64::from(random.below(41)) - 20.0) * 0.5;
        let x = match case % 5 {
            0 => 0.5_f64.next_down(),
            1 => half * random.power_of_two(-60, 0),
            2 => (half * random.power_of_two(-8, 0)).next_up(),
            3 => random.exponential(50, 54).round(),
            _ => random.exponential(-220, 70),
        };
        let expected = half_up(exact(x).scaled(i64::from(bits))).scaled(-i64::from(bits));
        assert_eq!(
            exact(snap(DVec2::new(x, 0.0), bits).x),
            expected,
            "{x:e}, {bits} bits"
        );
    }
}
