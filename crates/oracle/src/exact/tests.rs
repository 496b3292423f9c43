use super::*;
use num_rational::BigRational;
use proptest::prelude::*;

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn fraction(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// The same number as a fraction of another library.
fn rational(x: &Exact) -> BigRational {
    let one = BigInt::from(1);
    let denominator = x.denominator.clone().map_or(one.clone(), BigInt::from);
    let power = one << x.exponent.unsigned_abs();
    if x.exponent < 0 {
        BigRational::new(x.integer.clone(), denominator * power)
    } else {
        BigRational::new(&x.integer * power, denominator)
    }
}

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        proptest::num::f64::ANY.prop_filter("finite", |x| x.is_finite()),
        -1e3..1e3f64,
        (-9i32..9).prop_map(f64::from),
    ]
}

/// A random course of sums, differences, products and quotients, by both libraries.
fn course() -> impl Strategy<Value = (Exact, BigRational)> {
    // Few exponents, so that fractions of whole numbers meet: equal denominators, common factors, zeros.
    let number = prop_oneof![(-9i32..9).prop_map(f64::from), -1e3..1e3f64, finite()];
    prop::collection::vec((0..4, number), 1..7).prop_map(|steps| {
        let mut value = (Exact::ZERO, fraction(0.0));
        for (operation, x) in steps {
            let ((e, r), (y, s)) = (value, (exact(x), fraction(x)));
            value = match operation {
                0 => (e + y, r + s),
                1 => (y - e, s - r),
                2 => (&e * &e + y, &r * &r + s),
                _ => match y.over(&e) {
                    Some(quotient) => (quotient, s / r),
                    None => (e, r),
                },
            };
        }
        value
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn arithmetic_is_that_of_fractions((x, r) in course(), (y, s) in course()) {
        prop_assert_eq!(rational(&x), r.clone());
        prop_assert_eq!(rational(&(&x + &y)), &r + &s);
        prop_assert_eq!(rational(&(&x - &y)), &r - &s);
        prop_assert_eq!(rational(&(&x * &y)), &r * &s);
        prop_assert_eq!(x.cmp(&y), r.cmp(&s));
        prop_assert_eq!(rational(&-&x), -&r);
        prop_assert_eq!(rational(&x.abs()), if x < 0 { -r.clone() } else { r.clone() });
        prop_assert_eq!((&x - &x).sign(), Ordering::Equal);
        match x.over(&y) {
            Some(quotient) => prop_assert_eq!(rational(&quotient), r / s),
            None => prop_assert_eq!(s, fraction(0.0)),
        }
    }

    /// No denominator is even, 1, or has a factor in common with the integer.
    #[test]
    fn sums_and_products_are_reduced((x, _) in course(), (y, _) in course()) {
        for x in [&x + &y, &x * &y] {
            let Some(n) = &x.denominator else { continue };
            prop_assert!(n.bit(0) && *n > BigUint::from(1_u8));
            let mut odd = x.integer.clone();
            odd >>= odd.trailing_zeros().unwrap();
            let reduced = BigRational::new(odd, n.clone().into());
            prop_assert_eq!(reduced.denom().magnitude(), n);
        }
    }

    #[test]
    fn the_exponent_is_that_of_the_power_below((x, r) in course()) {
        let Some(e) = x.exponent() else {
            prop_assert_eq!(r, fraction(0.0));
            return Ok(());
        };
        let power = |e: i64| rational(&Exact::power_of_two(e));
        let size = rational(&x.abs());
        prop_assert!(power(e) <= size && size < power(e + 1));
    }

    /// Nearest: no neighbour is nearer, nor as near and even.
    #[test]
    fn the_nearest_double((x, r) in course()) {
        let found = x.nearest();
        prop_assume!(found.is_finite() && found.abs() < f64::MAX);
        let distance = |y: f64| {
            let off = fraction(y) - &r;
            if off < fraction(0.0) { -off } else { off }
        };
        for neighbour in [found.next_up(), found.next_down()] {
            let (here, there) = (distance(found), distance(neighbour));
            prop_assert!(here < there || (here == there && found.to_bits().is_multiple_of(2)));
        }
    }

    // IEEE arithmetic answers the nearest double by definition: another hand's answer for every pair of doubles.
    #[test]
    fn agrees_with_the_processor(a in finite(), b in finite()) {
        let (x, y) = (exact(a), exact(b));
        prop_assert_eq!((&x + &y).nearest(), a + b);
        prop_assert_eq!((&x - &y).nearest(), a - b);
        prop_assert_eq!((&x * &y).nearest(), a * b);
        let (found, expected) = (x.ratio(&y), a / b);
        prop_assert!(found == expected || (found.is_nan() && expected.is_nan()) || b == 0.0);
        prop_assert_eq!(Some(x.cmp(&y)), a.partial_cmp(&b));
        prop_assert_eq!(x.partial_cmp(&b), a.partial_cmp(&b));
        prop_assert_eq!(x.nearest(), a);
    }

    #[test]
    fn truncated_within_a_unit_towards_zero((x, r) in course(), bits in 0..300_u32) {
        let cut_off = &r - rational(&x.truncated(bits));
        let unit = BigRational::new(1.into(), BigInt::from(1) << bits);
        prop_assert!(-&unit < cut_off && cut_off < unit);
        let zero = fraction(0.0);
        prop_assert!(cut_off == zero || (cut_off < zero) == (r < zero));
        prop_assert_eq!(rational(&x.truncated(bits)) * (BigInt::from(1) << bits) % BigInt::from(1), zero);
    }
}

#[test]
fn halves_go_to_even_at_every_size() {
    for even in [1.0, 3e300, 0.0, f64::MIN_POSITIVE, 2.0_f64.powi(-1070)] {
        let even = if f64::to_bits(even) % 2 == 0 {
            even
        } else {
            even.next_up()
        };
        // Half a last place above `even` stays, and the least bit more goes up.
        let gap = exact(even.next_up()) - exact(even);
        let half = exact(even) + gap.scaled(-1);
        let least = Exact::power_of_two(-5000);
        assert_eq!(half.nearest(), even);
        assert_eq!((-&half).nearest(), -even);
        assert_eq!((&half + &least).nearest(), even.next_up());
        assert_eq!((&half - &least).nearest(), even);
        // From the odd neighbour above, half a place up goes on to the next even one.
        let odd = exact(even.next_up()) + gap.scaled(-1);
        assert_eq!(odd.nearest(), even.next_up().next_up());
        // A third of the least bit beside the half.
        let third = least.over(&Exact::from(3)).unwrap();
        assert_eq!((&half + &third).nearest(), even.next_up());
        assert_eq!((&half - &third).nearest(), even);
    }
}

#[test]
fn beyond_the_largest_double() {
    let edge = exact(f64::MAX) + Exact::power_of_two(970);
    assert_eq!(edge.nearest(), f64::INFINITY);
    assert_eq!((-&edge).nearest(), f64::NEG_INFINITY);
    assert_eq!((&edge - &exact(5e-324)).nearest(), f64::MAX);
    assert_eq!(Exact::power_of_two(9999).nearest(), f64::INFINITY);
    assert_eq!(Exact::power_of_two(-9999).nearest(), 0.0);
    assert!((-Exact::power_of_two(-9999)).nearest().is_sign_negative());
    assert_eq!(exact(f64::MAX).ratio(&exact(5e-324)), f64::INFINITY);
    assert_eq!(exact(5e-324).ratio(&exact(f64::MAX)), 0.0);
}

#[test]
fn degenerate() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Exact::new(x), None);
        assert_ne!(Exact::ZERO, x);
    }
    assert!(Exact::ZERO < f64::INFINITY && Exact::ZERO > f64::NEG_INFINITY);
    assert_eq!(Exact::ZERO.partial_cmp(&f64::NAN), None);
    assert_eq!(exact(-0.0), 0);
    assert_eq!(exact(0.0).ratio(&exact(-3.0)), 0.0);
    assert!(exact(0.0).ratio(&exact(0.0)).is_nan());
    assert_eq!(exact(-1.0).ratio(&exact(0.0)), f64::NEG_INFINITY);
    assert_eq!(exact(1.0).ratio(&exact(0.0)), f64::INFINITY);
    assert_eq!(exact(1.0).over(&Exact::ZERO), None);
    assert_eq!(exact(-7.0).over(&exact(2.0)).unwrap().truncated(0), -3);
    assert_eq!(Exact::default(), 0);
    assert_eq!(exact(-2.5).to_string(), "-2.5");
    assert_eq!(Exact::from(i128::MIN), -Exact::power_of_two(127));
    assert_eq!(Exact::from(u32::MAX) + Exact::from(1_i64), 4_294_967_296.0);
    let terms = [1, 2, 3].map(Exact::from);
    assert_eq!(terms.iter().sum::<Exact>(), 6);
    let mut sum = Exact::from(1);
    sum += Exact::from(2);
    assert_eq!(sum, 3);
    sum -= Exact::from(5);
    assert_eq!(sum, -2);
    assert_eq!(Exact::from(-3).squared(), 9);
    assert_eq!(Exact::ZERO.exponent(), None);
    assert_eq!(exact(5e-324).exponent(), Some(-1074));
}
