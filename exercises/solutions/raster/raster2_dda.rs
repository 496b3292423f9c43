use glam::IVec2;

/// x + m, given. The tests count its calls: it is the one operation of a step.
fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

/// The pixels of the segment from `a` to `b` with one addition and one rounding a pixel: the DDA (digital
/// differential analyzer).
///
/// ```text
/// |dx| ≥ |dy|:   x_{i+1} = x_i ± 1      y_{i+1} = y_i ± m      m = |dy / dx|
/// |dx| < |dy|:   y_{i+1} = y_i ± 1      x_{i+1} = x_i ± 1/m
/// ```
///
/// max(|dx|, |dy|) steps lead from a to b; each sign is that of dx or dy. The pixels are those of the analytic
/// segment: the nearest ones, and at a tie the one nearer the start. Add in f64, by the function `add` above: each step adds
/// the same m to what the last one left, and no step multiplies. dx and dy fit an `i32`.
///
/// `plot(x, y)` lights a pixel; y points down.
///
/// Grafica 3, Soluzione analitica.
fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    // It may be 2³¹, which i32 does not hold.
    let steps = d.x.unsigned_abs().max(d.y.unsigned_abs());
    let step = d.as_dvec2() / f64::from(steps.max(1));
    let (mut x, mut y) = (0.0, 0.0);
    for _ in 0..=steps {
        plot(a.x + nearest(x), a.y + nearest(y));
        (x, y) = (add(x, step.x), add(y, step.y));
    }
}

// The nearest whole number; halfway between two, the one nearer 0.
fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}

/// How far n additions of m lead away from n m, when each sum is rounded to f32.
///
/// ```text
/// y_0 = 0      y_{i+1} = y_i + m, in f32      drift = y_n − n m
/// ```
///
/// Only the additions are made in f32. n m and the difference are exact in f64, for n < 2²⁹.
///
/// Grafica 3, Soluzione analitica: «introduzione e propagazione di errore».
fn drift(m: f32, n: u32) -> f64 {
    let mut y = 0.0_f32;
    for _ in 0..n {
        y += m;
    }
    f64::from(y) - f64::from(n) * f64::from(m)
}

fn main() {}
