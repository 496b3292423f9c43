use glam::IVec2;

/// The pixels of the segment from `a` to `b`, by the equation of its line.
///
/// ```text
/// |dx| ≥ |dy|:   y = y_a + m (x − x_a)      m = dy / dx      one pixel a column
/// |dx| < |dy|:   x = x_a + (y − y_a) / m                     one pixel a row
/// ```
///
/// The result of the formula is rounded to the nearest whole number. Halfway between two it is a tie, and the pixel
/// nearer the start is taken: the one nearer to y_a, or to x_a. The first pixel is a, the last one b, whichever way
/// the segment runs; a = b is one pixel. dx and dy fit an `i32`.
///
/// `plot(x, y)` lights a pixel. y points down, as in every picture; the slide draws it upwards, with the same formulas.
///
/// Grafica 3, Rasterizzazione di Segmenti; Soluzione analitica.
fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    if a == b {
        return plot(a.x, a.y);
    }
    let d = b - a;
    // The longer way may be 2³¹, which i32 does not hold.
    if d.x.unsigned_abs() >= d.y.unsigned_abs() {
        let m = f64::from(d.y) / f64::from(d.x);
        for i in 0..=d.x.unsigned_abs() {
            let x = (i64::from(i) * i64::from(d.x.signum())) as i32;
            plot(a.x + x, a.y + nearest(m * f64::from(x)));
        }
    } else {
        let per_row = f64::from(d.x) / f64::from(d.y);
        for i in 0..=d.y.unsigned_abs() {
            let y = (i64::from(i) * i64::from(d.y.signum())) as i32;
            plot(a.x + nearest(per_row * f64::from(y)), a.y + y);
        }
    }
}

// The nearest whole number; halfway between two, the one nearer 0.
fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}

fn main() {}
