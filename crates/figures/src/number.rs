//! Numbers as a lecture writes them: the fraction where a double is one, a rounded decimal otherwise.

use ombra_math::glam::DVec3;
use ombra_math::plane::Plane;

/// Largest denominator shown as a fraction.
const MOST: u32 = 999;
/// Above this an integer or numerator is no longer read at a glance.
const LARGEST: f64 = 1e6;

/// A number in the markup of [`crate::text`]: `−{300|7}` where `x` is the double nearest to −300/7, `12`, `−0.333`.
///
/// # Properties
///
/// A fraction is shown only when dividing its two integers gives `x` to the last bit; the smallest denominator wins.
/// Everything else is rounded to four significant digits.
pub fn exact(x: f64) -> String {
    let minus = if x < 0.0 { "−" } else { "" };
    match fraction(x) {
        Some((n, 1)) => format!("{minus}{n}"),
        Some((n, d)) => format!("{minus}{{{n}|{d}}}"),
        None => decimal(x),
    }
}

/// [`exact`] for running text, whose lines are too close for a stacked fraction: −300/7.
pub fn inline(x: f64) -> String {
    let stacked = exact(x);
    match stacked.contains('|') {
        true => stacked.replace(['{', '}'], "").replace('|', "/"),
        false => stacked,
    }
}

/// Numerator and denominator of `x.abs()`, if it is exactly the double nearest to a fraction with a small denominator.
pub fn fraction(x: f64) -> Option<(u32, u32)> {
    let x = x.abs();
    if x >= LARGEST || x.is_nan() {
        return None;
    }
    (1..=MOST).find_map(|d| {
        let n = (x * f64::from(d)).round();
        // n is an integer below 10⁹ here, so the conversion keeps it.
        (n < LARGEST && n / f64::from(d) == x).then_some((n as u32, d))
    })
}

/// Four significant digits, without trailing zeros; powers of ten as ×10^k far from 1.
pub fn decimal(x: f64) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    let minus = if x < 0.0 { "−" } else { "" };
    let x = x.abs();
    if x == 0.0 {
        return "0".to_owned();
    }
    if x.is_infinite() {
        return format!("{minus}∞");
    }
    // Rust prints the exact decimal expansion, rounded half to even: no logarithm is needed.
    let scientific = format!("{x:.3e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if (-4..6).contains(&exponent) {
        let places = usize::try_from(3 - exponent).unwrap_or(0);
        // Rounding again to the same digit of the already rounded value changes nothing.
        let rounded: f64 = scientific.parse().unwrap_or(x);
        format!("{minus}{}", trimmed(&format!("{rounded:.places$}")))
    } else {
        let sign = if exponent < 0 { "−" } else { "" };
        format!("{minus}{}·10^{{{sign}{}}}", trimmed(digits), exponent.abs())
    }
}

/// A point as (x, y, z), each coordinate by [`exact`].
pub fn coordinates(p: DVec3) -> String {
    format!("({}, {}, {})", exact(p.x), exact(p.y), exact(p.z))
}

/// Numbers as an option takes them: `0,100,100,1`, `1e300,0.5,-2,1`; the shortest digits that give the same doubles.
pub fn as_typed(numbers: &[f64]) -> String {
    let short = |x: &f64| {
        let text = format!("{x:?}");
        text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
    };
    numbers.iter().map(short).collect::<Vec<_>>().join(",")
}

/// The least of 1, 2, 5 times a power of ten that is at least `length`; 0 where there is none.
pub fn round_step(length: f64) -> f64 {
    if !(length > 0.0 && length.is_finite()) {
        return 0.0;
    }
    // The printed exponent is exact where a logarithm may err.
    let exponent: i32 = format!("{length:e}")
        .split_once('e')
        .and_then(|(_, e)| e.parse().ok())
        .unwrap_or(0);
    [
        (1, exponent),
        (2, exponent),
        (5, exponent),
        (1, exponent + 1),
    ]
    .into_iter()
    .filter_map(|(digit, power)| format!("{digit}e{power}").parse::<f64>().ok())
    .find(|step| *step >= length)
    .unwrap_or(0.0)
}

/// A plane as *x* + 2*y* − 10 = 0, each coefficient by [`exact`].
pub fn equation(plane: Plane) -> String {
    let n = plane.normal;
    let mut text = String::new();
    for (factor, name) in [(n.x, "*x*"), (n.y, "*y*"), (n.z, "*z*"), (plane.d, "")] {
        if factor == 0.0 {
            continue;
        }
        text.push_str(match (text.is_empty(), factor < 0.0) {
            (true, true) => "−",
            (true, false) => "",
            (false, true) => " − ",
            (false, false) => " + ",
        });
        let size = factor.abs();
        if name.is_empty() || size != 1.0 {
            text.push_str(&exact(size));
        }
        text.push_str(name);
    }
    format!("{text} = 0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fraction_is_shown_only_when_it_is_one_to_the_last_bit() {
        let seventh = -300.0_f64 / 7.0;
        assert_eq!(exact(seventh), "−{300|7}");
        assert_eq!(exact(f64::from_bits(seventh.to_bits() + 1)), "−42.86");
        assert_eq!(exact(f64::from_bits(seventh.to_bits() - 1)), "−42.86");
        assert_eq!(exact(12.5), "{25|2}");
        assert_eq!(inline(-12.5), "−25/2");
        assert_eq!(inline(-1.25e-7), "−1.25·10^{−7}");
        assert_eq!(exact(0.1), "{1|10}");
        assert_eq!(exact(core::f64::consts::PI), "3.142");
        assert_eq!(exact(-20.0), "−20");
        assert_eq!(exact(-0.0), "0");
    }

    #[test]
    fn a_plane_is_written_as_its_equation() {
        let plane = |x, y, z, d| Plane {
            normal: DVec3::new(x, y, z),
            d,
        };
        for (plane, text) in [
            (Plane::GROUND, "*y* = 0"),
            (plane(1.0, -1.0, 2.0, -30.0), "*x* − *y* + 2*z* − 30 = 0"),
            (plane(-1.0, 0.0, 0.5, 0.0), "−*x* + {1|2}*z* = 0"),
            (plane(0.0, 0.0, -3.0, 1.0), "−3*z* + 1 = 0"),
        ] {
            assert_eq!(equation(plane), text);
        }
    }

    #[test]
    fn as_typed_is_short_and_reads_back() {
        let wild = [1e300, -2.0, 0.1, -0.0, 5e-324, f64::MAX, 12345678.0];
        let text = as_typed(&wild);
        assert_eq!(
            text,
            "1e300,-2,0.1,-0,5e-324,1.7976931348623157e308,12345678"
        );
        let back: Vec<f64> = text.split(',').map(|x| x.parse().unwrap()).collect();
        let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&back), bits(&wild));
        assert_eq!(as_typed(&[f64::NAN, f64::INFINITY]), "NaN,inf");
    }

    #[test]
    fn decimals() {
        for (x, text) in [
            (0.33333, "0.3333"),
            (-42.857_14, "−42.86"),
            (99_999.0, "100000"),
            (123_456.7, "123500"),
            (1.0e6, "1·10^{6}"),
            (-1.25e-7, "−1.25·10^{−7}"),
            (0.000_123_456, "0.0001235"),
            (f64::INFINITY, "∞"),
            (f64::NEG_INFINITY, "−∞"),
            (f64::NAN, "NaN"),
            (f64::MAX, "1.798·10^{308}"),
            (5e-324, "4.941·10^{−324}"),
        ] {
            assert_eq!(decimal(x), text);
        }
    }

    #[test]
    fn every_small_fraction_is_found_in_lowest_terms() {
        let gcd = |mut a: u32, mut b: u32| {
            while b != 0 {
                (a, b) = (b, a % b);
            }
            a
        };
        for d in 1..60 {
            for n in 0..200 {
                let g = gcd(n, d).max(1);
                assert_eq!(
                    fraction(f64::from(n) / f64::from(d)),
                    Some((n / g, d / g)),
                    "{n}/{d}"
                );
            }
        }
    }
}
