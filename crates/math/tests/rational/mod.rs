//! What tests compare with: rationals, and roots, angles and sines of them to 300 bits.
#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each test takes what it needs, and stops where something is missing"
)]

use num_bigint::BigInt;
use num_rational::BigRational;

/// A rational.
pub type Q = BigRational;

/// The double `x`, exactly.
pub fn q(x: f64) -> Q {
    Q::from_float(x).unwrap()
}

/// 2ᵉ.
pub fn power(e: i32) -> Q {
    Q::from_integer(BigInt::from(2)).pow(e)
}

pub fn is_zero(x: &Q) -> bool {
    x.numer().bits() == 0
}

pub fn abs(x: Q) -> Q {
    if x < q(0.0) { -x } else { x }
}

/// Binary exponent, to within one.
fn exponent(x: &Q) -> i32 {
    x.numer().bits() as i32 - x.denom().bits() as i32
}

/// `x` with its first 300 bits, or fractions grow without end.
pub fn trim(x: Q) -> Q {
    if is_zero(&x) {
        return x;
    }
    let shift = 300 - exponent(&x);
    Q::from_integer((x * power(shift)).to_integer()) * power(-shift)
}

pub fn root(x: &Q) -> Q {
    if is_zero(x) {
        return x.clone();
    }
    let half = 300 - exponent(x) / 2;
    Q::from_integer((x * power(2 * half)).to_integer().sqrt()) * power(-half)
}

/// The double near `x`; ∞ for one that is too large.
pub fn to_f64(x: &Q) -> f64 {
    if is_zero(x) {
        return 0.0;
    }
    let shift = 64 - exponent(x);
    let integer: f64 = (x * power(shift)).to_integer().to_string().parse().unwrap();
    libm::scalbn(integer, -shift)
}

/// The angle of (x, y), y ≥ 0, by halving it until the series of the arctangent is short.
pub fn angle(y: &Q, x: &Q) -> Q {
    if *x < q(0.0) {
        return angle(&q(1.0), &q(0.0)) * q(2.0) - angle(y, &-x);
    }
    let mut t = trim(y / (x + root(&trim(x * x + y * y))));
    for _ in 0..5 {
        t = trim(&t / (q(1.0) + root(&trim(q(1.0) + &t * &t))));
    }
    let square = trim(&t * &t);
    let (mut sum, mut term) = (t.clone(), t);
    for k in 1..40 {
        term = -trim(term * &square);
        sum += trim(&term / q(f64::from(2 * k + 1)));
    }
    trim(sum) * q(64.0)
}

/// Sine and cosine by their series, for angles of a few turns at most.
pub fn sine_and_cosine(x: &Q) -> (Q, Q) {
    let fixed = |x: Q| Q::from_integer((x * power(500)).to_integer()) * power(-500);
    let (mut sin, mut cos, mut term) = (q(0.0), q(0.0), q(1.0));
    for k in 0..160 {
        match k % 4 {
            0 => cos += &term,
            1 => sin += &term,
            2 => cos -= &term,
            _ => sin -= &term,
        }
        term = fixed(term * x / q(f64::from(k + 1)));
    }
    (sin, cos)
}
