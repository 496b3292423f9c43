//! Roots, angles and sines of exact numbers, to 300 bits.
#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each test takes what it needs, and stops where something is missing"
)]

use ombra_oracle::Exact;

/// The double `x`, exactly.
pub fn q(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// x / y, which must not be 0.
pub fn quotient(x: &Exact, y: &Exact) -> Exact {
    x.over(y).unwrap()
}

/// `x` with its first 300 bits, or fractions grow without end.
pub fn trim(x: &Exact) -> Exact {
    let e = x.exponent().unwrap_or(0);
    x.scaled(-e).truncated(300).scaled(e)
}

/// √x by Newton's method, from the processor's root of x / 4ʰ, which is between 1 and 4.
pub fn root(x: &Exact) -> Exact {
    let Some(e) = x.exponent() else {
        return Exact::ZERO;
    };
    let h = e.div_euclid(2);
    let x = x.scaled(-2 * h);
    let mut root = q(x.nearest().sqrt());
    // 53 bits are right; 106, 212 and 424.
    for _ in 0..3 {
        root = (quotient(&x, &root) + root).scaled(-1).truncated(300);
    }
    root.scaled(h)
}

/// The angle of (x, y), y ≥ 0, by halving it until the series of the arctangent is short.
pub fn angle(y: &Exact, x: &Exact) -> Exact {
    let one = Exact::from(1);
    if *x < 0 {
        return angle(&one, &Exact::ZERO).scaled(1) - angle(y, &-x);
    }
    let mut t = trim(&quotient(y, &(x + root(&(x.squared() + y.squared())))));
    for _ in 0..5 {
        t = trim(&quotient(&t, &(&one + root(&(&one + t.squared())))));
    }
    let square = trim(&t.squared());
    let (mut sum, mut term) = (t.clone(), t);
    for k in 1..40 {
        term = -trim(&(term * &square));
        sum += trim(&quotient(&term, &Exact::from(2 * k + 1)));
    }
    trim(&sum).scaled(6)
}

/// Sine and cosine by their series, for angles of a few turns at most.
pub fn sine_and_cosine(x: &Exact) -> (Exact, Exact) {
    let (mut sin, mut cos, mut term) = (Exact::ZERO, Exact::ZERO, Exact::from(1));
    for k in 0..160 {
        match k % 4 {
            0 => cos += term.clone(),
            1 => sin += term.clone(),
            2 => cos -= term.clone(),
            _ => sin -= term.clone(),
        }
        term = quotient(&(term * x), &Exact::from(k + 1)).truncated(500);
    }
    (sin, cos)
}
