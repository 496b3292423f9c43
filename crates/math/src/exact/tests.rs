use super::*;
use ombra_oracle::Exact;
use proptest::prelude::*;

fn number(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn exact(terms: &[[f64; 3]]) -> Exact {
    let product = |t: &[f64; 3]| number(t[0]) * number(t[1]) * number(t[2]);
    terms.iter().map(product).sum()
}

/// Brute force: no double is nearer to `exact` than `x`, and on a tie x is even.
fn is_nearest(x: f64, exact: &Exact) -> bool {
    // Beyond the largest double, ∞ stands for 2¹⁰²⁴, which is even.
    let infinity = |y: f64| Exact::power_of_two(1024) * number(y.signum());
    let distance = |y: f64| (Exact::new(y).unwrap_or_else(|| infinity(y)) - exact).abs();
    let here = distance(x);
    if x.is_infinite() {
        return here <= distance(f64::MAX.copysign(x));
    }
    [x.next_up(), x.next_down()].into_iter().all(|y| {
        let there = distance(y);
        here < there || (here == there && x.to_bits() & 1 == 0)
    })
}

/// Any finite double, every exponent alike, often with few significant bits so that ties happen.
fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => proptest::num::f64::ANY.prop_filter("finite", |x| x.is_finite()),
        1 => (-1i32..=1, -1074i32..=1023, 0u32..8).prop_map(|(s, e, m)| {
            libm::scalbn(f64::from(s) * (1.0 + f64::from(m) / 8.0), e)
        }),
        1 => (-100i32..100).prop_map(f64::from),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn differences_are_exact(a in prop::collection::vec([finite(), finite(), finite()], 0..5),
                             b in prop::collection::vec([finite(), finite(), finite()], 0..5)) {
        let difference = Sum::of(&a) - Sum::of(&b);
        let exact = exact(&a) - exact(&b);
        prop_assert_eq!(difference.sign(), Some(exact.sign()));
        prop_assert!(is_nearest(difference.to_f64(), &exact));
    }

    #[test]
    fn sign_and_rounding_are_exact(terms in prop::collection::vec([finite(), finite(), finite()], 0..6)) {
        let (sum, exact) = (Sum::of(&terms), exact(&terms));
        prop_assert_eq!(sum.sign(), Some(exact.sign()));
        let x = sum.to_f64();
        prop_assert!(is_nearest(x, &exact), "{x:e}");
        let (f, e) = sum.to_scaled();
        prop_assert!(f == 0.0 || (1.0..2.0).contains(&f.abs()));
        prop_assert!(is_nearest(f, &exact.scaled(-i64::from(e))), "{f:e}");
    }

    #[test]
    fn quotients_are_nearest(a in prop::collection::vec([finite(), finite(), finite()], 1..5),
                             b in prop::collection::vec([finite(), finite(), finite()], 1..5)) {
        let (n, d) = (exact(&a), exact(&b));
        prop_assume!(d != 0);
        let q = Sum::of(&a).quotient(&Sum::of(&b));
        prop_assert!(is_nearest(q, &n.over(&d).unwrap()), "{q:e}");
    }

    #[test]
    fn one_over_another_is_the_hardware_quotient(a in finite(), b in finite()) {
        prop_assume!(b != 0.0);
        prop_assert_eq!(Sum::of(&[[a, 1.0, 1.0]]).quotient(&Sum::of(&[[b, 1.0, 1.0]])), a / b);
    }

    #[test]
    fn one_product_of_two_is_the_hardware_product(a in finite(), b in finite()) {
        prop_assert_eq!(Sum::of(&[[a, b, 1.0]]).to_f64(), a * b);
    }
}

proptest! {
    #[test]
    fn dots_have_the_sign_and_an_epsilon(a in [finite(), finite(), finite(), finite()],
                                         b in [finite(), finite(), finite(), finite()], near in any::<bool>()) {
        let mut b = b;
        if near {
            let rest = -(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / a[3];
            if rest.is_finite() {
                b[3] = rest;
            }
        }
        let terms: Vec<_> = a.iter().zip(&b).map(|(&x, &y)| [x, y, 1.0]).collect();
        let expected = exact(&terms);
        let (f, e) = dot(DVec4::from_array(a), DVec4::from_array(b));
        prop_assert_eq!(f.partial_cmp(&0.0), Some(expected.sign()));
        let error = number(f).scaled(i64::from(e)) - &expected;
        prop_assert!(error.abs() <= expected.abs().scaled(-52));
    }
}

#[test]
fn huge_cancels_and_tiny_remains() {
    let tiny = [5e-324, 5e-324, -5e-324];
    let sum = Sum::of(&[[f64::MAX; 3], tiny, [-f64::MAX, f64::MAX, f64::MAX]]);
    assert_eq!(sum.sign(), Some(Ordering::Less));
    assert_eq!(sum.to_f64(), 0.0);
    assert_eq!(sum.to_scaled(), (-1.0, LOWEST));
}

#[test]
fn degenerate() {
    let one = Sum::of(&[[1.0; 3]]);
    assert_eq!(Sum::of(&[]).sign(), Some(Ordering::Equal));
    assert_eq!(Sum::of(&[]).to_f64(), 0.0);
    assert_eq!(Sum::of(&[]).to_scaled(), (0.0, 0));
    assert_eq!(Sum::of(&[[f64::MAX; 3]]).to_f64(), f64::INFINITY);
    assert_eq!(Sum::of(&[]).quotient(&one), 0.0);
    assert!(one.quotient(&Sum::of(&[])).is_nan());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let sum = Sum::of(&[[1.0, bad, 0.0]]);
        assert_eq!(sum.sign(), None);
        assert!(
            sum.to_f64().is_nan() && sum.quotient(&one).is_nan() && one.quotient(&sum).is_nan()
        );
    }
}

#[test]
fn ratios_of_any_exponents() {
    let (top, least) = (i32::MAX, i32::MIN);
    for (given, expected) in [
        ([(1.0, top), (1.0, least)], [1.0, 5e-324]),
        ([(-1.5, least), (1.0, top)], [-5e-324, 1.0]),
        ([(1.0, least), (-1.0, least)], [1.0, -1.0]),
        ([(0.0, top), (1.0, least)], [0.0, 1.0]),
        ([(-0.0, least), (1.0, top)], [0.0, 1.0]),
        ([(1.0, 1), (1.0, top)], [5e-324, 1.0]),
    ] {
        assert_eq!(relative(&given), expected, "{given:?}");
    }
    assert!(relative(&[(f64::NAN, least), (1.0, top)])[0].is_nan());
    assert_eq!(relative(&[]), [0.0; 0]);
}

#[test]
fn what_is_not_finite_is_no_difference() {
    let (good, bad) = (Sum::of(&[[1.0; 3]]), Sum::of(&[[f64::NAN, 0.0, 1.0]]));
    for difference in [
        good.clone() - bad.clone(),
        bad.clone() - good,
        bad.clone() - bad,
    ] {
        assert_eq!(difference.sign(), None);
    }
}
