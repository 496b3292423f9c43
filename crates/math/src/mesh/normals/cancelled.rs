//! Vertex normals where the faces cancel almost or altogether: summed again with twice the digits, by area exactly.

use super::{SINE_IS_ANGLE, Weighting};
use crate::double_double::DoubleDouble;
use crate::exact::Sum;
use crate::scaling::common;
use crate::triangle::{CYCLE, cross_terms, pick, unit};
use glam::DVec3;

/// The normal of the vertex that is the first corner of all `faces`.
pub(super) fn normal(
    weighting: Weighting,
    faces: impl Iterator<Item = [DVec3; 3]> + Clone,
) -> DVec3 {
    let faces = faces.filter(|face| face.iter().all(|p| p.is_finite()));
    let sum = match weighting {
        // Σ AB × AC is a sum of products.
        Weighting::Area => common(CYCLE.map(|ij| cross(faces.clone(), ij).to_scaled())).0,
        Weighting::Plain => sum(faces.filter_map(|face| Some((scaled_unit(face)?.0, 0)))),
        Weighting::Angle => sum(faces.filter_map(|face| {
            let (n, length, exponent) = scaled_unit(face)?;
            let (w, e) = angle(face, length, exponent);
            Some((n.map(|n| n * w), e))
        })),
    };
    unit(sum.into()).unwrap_or(DVec3::ZERO)
}

/// Σ wᵢ nᵢ of such terms times powers of two, up to a factor; zero where it is less than their rounding.
fn sum(terms: impl Iterator<Item = ([DoubleDouble; 3], i32)> + Clone) -> [f64; 3] {
    let top = terms.clone().map(|(_, e)| e).max().unwrap_or(0);
    let (mut sum, mut size) = ([DoubleDouble::default(); 3], 0.0);
    for (term, e) in terms {
        let mut largest = 0.0f64;
        for (sum, term) in sum.iter_mut().zip(term) {
            let term = shifted(term, e - top);
            *sum = *sum + term;
            largest = largest.max(term.hi.abs());
        }
        size += largest;
    }
    let sum = sum.map(|x| x.hi);
    let none = sum.iter().all(|x| x.abs() <= libm::scalbn(size, -90));
    if none { [0.0; 3] } else { sum }
}

/// Unit normal of a face, and the length l · 2ᵉ of AB × AC; `None` for a face without area.
fn scaled_unit(face: [DVec3; 3]) -> Option<([DoubleDouble; 3], DoubleDouble, i32)> {
    let components = CYCLE.map(|ij| in_double_double(&cross([face].into_iter(), ij)));
    let nonzero = components.iter().filter(|(n, _)| n.hi != 0.0);
    let exponent = nonzero.map(|&(_, e)| e).max()?;
    let n = components.map(|(n, e)| shifted(n, e - exponent));
    let [x, y, z] = n.map(|n| n * n);
    let length = (x + y + z).sqrt();
    Some((n.map(|n| n.over(length)), length, exponent))
}

/// atan2(|AB × AC|, AB·AC) as w · 2ᵏ, the product's length being l · 2ᵉ.
fn angle([a, b, c]: [DVec3; 3], length: DoubleDouble, exponent: i32) -> (DoubleDouble, i32) {
    let mut dot = Sum::default();
    for i in 0..3 {
        // (bᵢ − aᵢ)(cᵢ − aᵢ), multiplied out.
        dot.add([b[i], c[i], 1.0]);
        dot.add([-b[i], a[i], 1.0]);
        dot.add([-a[i], c[i], 1.0]);
        dot.add([a[i], a[i], 1.0]);
    }
    let (x, x_exponent) = in_double_double(&dot);
    let down = exponent - x_exponent;
    if x.hi == 0.0 {
        (arctangent(length, x), 0)
    } else if down < SINE_IS_ANGLE && x.hi > 0.0 {
        (length.over(x), down)
    } else {
        let smaller = down.min(0);
        (
            arctangent(shifted(length, smaller), shifted(x, smaller - down)),
            0,
        )
    }
}

/// One component of Σ AB × AC.
fn cross(faces: impl Iterator<Item = [DVec3; 3]>, ij: [usize; 2]) -> Sum {
    let mut sum = Sum::default();
    for face in faces {
        for term in cross_terms(face.map(|p| pick(p, ij))) {
            sum.add(term);
        }
    }
    sum
}

/// The sum as f · 2ᵉ, f with twice the digits.
fn in_double_double(sum: &Sum) -> (DoubleDouble, i32) {
    let (hi, e) = sum.to_scaled();
    // hi · 2ᵉ as a product of three doubles, taken off.
    let [e1, e2] = [e / 3, e / 3];
    let power = |e: i32| libm::scalbn(1.0, e);
    let mut rest = sum.clone();
    rest.add([-hi * power(e - e1 - e2), power(e1), power(e2)]);
    let (lo, lo_exponent) = rest.to_scaled();
    let lo = libm::scalbn(lo, lo_exponent - e);
    (DoubleDouble { hi, lo }, e)
}

fn shifted(x: DoubleDouble, e: i32) -> DoubleDouble {
    DoubleDouble {
        hi: libm::scalbn(x.hi, e),
        lo: libm::scalbn(x.lo, e),
    }
}

fn whole(x: f64) -> DoubleDouble {
    DoubleDouble { hi: x, lo: 0.0 }
}

/// The angle of (x, y) for y ≥ 0, by one step of Newton's method from the double's: what is left after turning back by that.
fn arctangent(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let near = libm::atan2(y.hi, x.hi);
    let (sin, cos) = sine_and_cosine(near);
    let rest = (y * cos - x * sin).over(x * cos + y * sin);
    whole(near) + rest
}

/// Taylor's series of a 64th of the angle, then doubled six times.
fn sine_and_cosine(angle: f64) -> (DoubleDouble, DoubleDouble) {
    let part = angle / 64.0;
    let square = DoubleDouble::product(part, part);
    // x (1 − x²/2·3 (1 − x²/4·5 (…))), and for 1 − cos x likewise: fewer than 106 bits are left after ten terms.
    let series = |first: f64| {
        (0..10).rev().fold(whole(1.0), |inner, k| {
            let n = first + 2.0 * f64::from(k);
            whole(1.0) - (square * inner).over(whole(n * (n + 1.0)))
        })
    };
    let mut sin = series(2.0).times(part);
    // cos x − 1, which keeps the digits of a small angle.
    let mut less = -(square * series(3.0)).times(0.5);
    for _ in 0..6 {
        sin = (sin * (whole(1.0) + less)).times(2.0);
        less = (less * (whole(2.0) + less)).times(2.0);
    }
    (sin, whole(1.0) + less)
}
