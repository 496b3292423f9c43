//! `cast` against the exact shadow: a hundred thousand planes, lights and vertices from the whole range of the
//! doubles, compared without rounding.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::BTreeMap;
use std::thread;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_shadows::planar::{Placement, cast, classify};
use ombra_tests::cases::{Case, Random, case};
use ombra_tests::shadow::{Decision, ExactShadow};

/// What is demanded of every answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Demand {
    /// A shadow exactly where there is one that doubles can hold.
    Decision,
    /// Each coordinate within (ε/2) Σᵢ |∂P_j/∂xᵢ · xᵢ|, plus half the smallest subnormal.
    Condition,
    /// Each coordinate the double nearest to the exact one, ties to even.
    Nearest,
    /// |n·P + d| ≤ (ε/2) Σ |n_j P_j|, plus half the smallest subnormal times Σ |n_j|.
    OnPlane,
}

/// What was met on the way and how often, so that no demand is kept by never being made.
#[derive(Default)]
struct Tally {
    broken: BTreeMap<Demand, usize>,
    first: Option<String>,
    decisions: BTreeMap<Decision, usize>,
    nearly_degenerate: usize,
    beyond_doubles: usize,
    subnormal: usize,
}

impl Tally {
    fn break_(&mut self, demand: Demand, case: &Case, answer: Option<DVec3>, exact: &ExactShadow) {
        *self.broken.entry(demand).or_default() += 1;
        self.first.get_or_insert_with(|| {
            let hex = |x: &[f64]| -> Vec<String> {
                x.iter().map(|x| format!("{:#018x}", x.to_bits())).collect()
            };
            format!(
                "{demand:?}: {case:?}\nplane {:?}\nlight {:?}\nvertex {:?}\nexact {:?} {:?}\nanswer {answer:?}",
                hex(&case.plane.coefficients().to_array()),
                hex(&case.light.to_array()),
                hex(&case.vertex.to_array()),
                exact.decision(),
                exact.nearest(),
            )
        });
    }

    fn absorb(&mut self, other: Self) {
        for (demand, n) in other.broken {
            *self.broken.entry(demand).or_default() += n;
        }
        for (decision, n) in other.decisions {
            *self.decisions.entry(decision).or_default() += n;
        }
        self.first = self.first.take().or(other.first);
        self.nearly_degenerate += other.nearly_degenerate;
        self.beyond_doubles += other.beyond_doubles;
        self.subnormal += other.subnormal;
    }
}

/// Puts every demand to the answer of `cast_under_test` in one case.
fn examine(
    tally: &mut Tally,
    case: &Case,
    cast_under_test: impl Fn(Plane, DVec4, DVec3) -> Option<DVec3>,
) {
    let Some(exact) = ExactShadow::new(case.plane, case.light, case.vertex) else {
        return;
    };
    *tally.decisions.entry(exact.decision()).or_default() += 1;
    tally.nearly_degenerate += usize::from(exact.is_nearly_degenerate());
    let expected = exact.answer();
    tally.beyond_doubles += usize::from(exact.decision() == Decision::Casts && expected.is_none());

    let answer = cast_under_test(case.plane, case.light, case.vertex);
    let (computed, expected) = match (answer, expected) {
        (Some(computed), Some(expected)) => (computed, expected),
        (None, None) => return,
        _ => return tally.break_(Demand::Decision, case, answer, &exact),
    };
    tally.subnormal += usize::from(computed.to_array().iter().any(|x| x.is_subnormal()));
    if (0..3).any(|j| !exact.within_condition(computed[j], j)) {
        tally.break_(Demand::Condition, case, answer, &exact);
    }
    if computed != expected {
        tally.break_(Demand::Nearest, case, answer, &exact);
    }
    if !exact.on_plane(computed) {
        tally.break_(Demand::OnPlane, case, answer, &exact);
    }
}

/// `blocks` times a thousand cases, each block with a course of its own, shared out among the processors.
fn run(
    blocks: u64,
    cast_under_test: impl Fn(Plane, DVec4, DVec3) -> Option<DVec3> + Sync,
) -> Tally {
    let workers = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let work = |worker: u64| {
        let mut tally = Tally::default();
        for block in (worker..blocks).step_by(workers as usize) {
            let seed = Random::new(block).bits();
            let mut random = Random::new(seed);
            for _ in 0..1000 {
                examine(&mut tally, &case(&mut random), &cast_under_test);
            }
        }
        tally
    };
    thread::scope(|scope| {
        let handles: Vec<_> = (0..workers).map(|n| scope.spawn(move || work(n))).collect();
        let mut sum = Tally::default();
        for handle in handles {
            sum.absorb(handle.join().unwrap());
        }
        sum
    })
}

#[test]
fn a_hundred_thousand_cases() {
    let tally = run(100, cast);
    assert!(
        tally.broken.is_empty(),
        "broken: {:?}\nfirst: {}",
        tally.broken,
        tally.first.unwrap_or_default()
    );
    // The cases reach everything: a third near a degenerate one, every decision, both ends of the range.
    assert!(
        tally.nearly_degenerate > 33_333,
        "{}",
        tally.nearly_degenerate
    );
    for decision in [
        Decision::Casts,
        Decision::BehindPlane,
        Decision::LevelWithLight,
        Decision::BeyondLight,
        Decision::LightAlongPlane,
    ] {
        let times = tally.decisions.get(&decision).copied().unwrap_or(0);
        assert!(times >= 200, "{decision:?} only {times} times");
    }
    assert!(tally.beyond_doubles >= 500, "{}", tally.beyond_doubles);
    assert!(tally.subnormal >= 500, "{}", tally.subnormal);
}

#[test]
fn classify_gives_the_reason() {
    let mut random = Random::new(7);
    for _ in 0..20_000 {
        let case = case(&mut random);
        let expected =
            ExactShadow::new(case.plane, case.light, case.vertex).map(|exact| {
                match exact.decision() {
                    Decision::Casts => Placement::Casts,
                    Decision::BehindPlane => Placement::BehindPlane,
                    Decision::LevelWithLight => Placement::LevelWithLight,
                    Decision::BeyondLight => Placement::BeyondLight,
                    Decision::LightAlongPlane => Placement::LightAlongPlane,
                }
            });
        let placement = classify(case.plane, case.light, case.vertex);
        assert_eq!(placement, expected, "{case:?}");
    }
}

/// Halves of a last place go to the even neighbour, and the least bit beyond a half decides.
///
/// P_x = V_x − V_y L_x/L_y over the ground, so V_y is what the sum is off V_x.
#[test]
fn ties_go_to_the_even_double() {
    let toward = |x: f64| DVec4::new(x, 1.0, 0.0, 0.0);
    let x_of = |light: DVec4, vx: f64, vy: f64| {
        cast(Plane::GROUND, light, DVec3::new(vx, vy, 0.0))
            .unwrap()
            .x
    };
    let half = f64::EPSILON / 2.0;
    let (one, odd) = (1.0_f64, 1.0_f64.next_up());
    // Above 1 a half place is 2⁻⁵³; below it 2⁻⁵⁴.
    assert_eq!(x_of(toward(-1.0), one, half), one);
    assert_eq!(x_of(toward(-1.0), odd, half), odd.next_up());
    assert_eq!(x_of(toward(-1.0), one, half.next_up()), odd);
    assert_eq!(x_of(toward(-1.0), odd, half.next_down()), odd);
    assert_eq!(x_of(toward(1.0), one, half / 2.0), one);
    assert_eq!(
        x_of(toward(1.0), one, (half / 2.0).next_up()),
        one.next_down()
    );
    // A light at a place halves exactly too: P_x = (2·V_x − 0)/(2 − 1) with L = (0, 2, 0, 1), V_y = 1 …
    let lamp = DVec4::new(-half, 2.0, 0.0, 1.0);
    // … plus L_x's share: (2·½ + 2⁻⁵³ · 1)/1 = 1 + 2⁻⁵³.
    assert_eq!(x_of(lamp, 0.5, 1.0), one);
    // Among the subnormals, half of the smallest.
    let least = f64::from_bits(1);
    assert_eq!(x_of(toward(-0.5), 0.0, least), 0.0);
    assert_eq!(x_of(toward(-0.5), least, least), 2.0 * least);
    assert_eq!(x_of(toward(-0.5_f64.next_up()), 0.0, least), least);
}

/// The largest double is still an answer up to half its last place beyond it, and from there on there is none.
#[test]
fn the_largest_double_is_the_last_answer() {
    let half_place = 2.0_f64.powi(970);
    let beyond = |y: f64| {
        let light = DVec4::new(-1.0, 1.0, 0.0, 0.0);
        cast(Plane::GROUND, light, DVec3::new(f64::MAX, y, 0.0))
    };
    assert_eq!(beyond(0.0), Some(DVec3::new(f64::MAX, 0.0, 0.0)));
    assert_eq!(
        beyond(half_place.next_down()),
        Some(DVec3::new(f64::MAX, 0.0, 0.0))
    );
    assert_eq!(beyond(half_place), None);
    assert_eq!(beyond(2.0 * half_place), None);
}

/// The check itself, put to answers that are wrong in one way each.
#[test]
fn wrong_answers_are_caught() {
    let caught = |wrong: &(dyn Fn(Plane, DVec4, DVec3) -> Option<DVec3> + Sync), demand| {
        let tally = run(4, wrong);
        assert!(tally.broken.contains_key(&demand), "{demand:?} not missed");
    };
    let exact = |plane, light, v| ExactShadow::new(plane, light, v);
    let right = |plane, light, v| exact(plane, light, v)?.answer();

    // The formula in plain doubles: overflow, underflow and cancellation.
    let plain = |plane: Plane, light: DVec4, v: DVec3| {
        let s = plane.coefficients().dot(light);
        let t = plane.normal.dot(v) + plane.d;
        let p = (s * v - t * light.truncate()) / (s - t * light.w);
        (s * t >= 0.0 && p.is_finite()).then_some(p)
    };
    caught(&plain, Demand::Decision);
    caught(&plain, Demand::Condition);
    caught(&plain, Demand::OnPlane);
    // Right but for one last place.
    let one_place_off = |plane, light, v| {
        right(plane, light, v).map(|p: DVec3| DVec3::new(p.x.next_up(), p.y, p.z))
    };
    caught(&one_place_off, Demand::Nearest);
    // Right, and the false shadows of what is beyond the light as well.
    let false_shadows = |plane, light, v| {
        right(plane, light, v).or_else(|| {
            let beyond = exact(plane, light, v)?.decision() == Decision::BeyondLight;
            beyond.then_some(DVec3::ZERO)
        })
    };
    caught(&false_shadows, Demand::Decision);
    // Clamped where there is none.
    let clamped = |plane, light, v| {
        let p = DVec3::from_array(exact(plane, light, v)?.nearest()?);
        Some(p.clamp(DVec3::MIN, DVec3::MAX))
    };
    caught(&clamped, Demand::Decision);
    assert!(run(4, right).broken.is_empty());
}
