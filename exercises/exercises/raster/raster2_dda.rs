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
    // TODO: the number of steps, what one step adds, then the loop.
    todo!()
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
    // TODO: the sum, addition by addition; then its distance from the product.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster2_dda {
    use super::{drift, segment};
    use assess::{Grid, Inputs, Segment, brief_number, calls_within, near_number, sums, watched};
    use glam::IVec2;

    /// The pixels, and the additions that were made for them.
    type Drawn = (Vec<(i32, i32)>, Vec<(f64, f64)>);

    fn drawn(wanted: Segment) -> Drawn {
        let (a, b) = (wanted.a, wanted.b);
        let run = move || {
            sums(|| {
                calls_within(&wanted.show(), limit(wanted), |take| {
                    segment(a, b, &mut |x, y| take((x, y)));
                })
            })
        };
        watched(&wanted.show(), run)
    }

    /// Twice the pixels that there are.
    fn limit(wanted: Segment) -> usize {
        let d = (wanted.b - wanted.a).abs();
        2 * (d.max_element() as usize + 1)
    }

    /// Fails unless each step adds what the others add, to what the last one left.
    fn check_sums(wanted: Segment, additions: &[(f64, f64)]) {
        let what = wanted.show();
        let steps = (wanted.b - wanted.a).abs().max_element() as usize;
        if steps < 4 {
            return;
        }
        assert!(
            !additions.is_empty(),
            "{what}: `add` is not called: in a DDA each step adds m to the coordinate that is kept, by `add`",
        );
        let mut added: Vec<f64> = additions.iter().map(|&(_, m)| m).collect();
        added.sort_by(f64::total_cmp);
        added.dedup();
        assert!(
            added.len() <= 3,
            "{what}: the steps add {} different numbers, {}, {}, {} …: m times the step, or m worked out anew, is a product a \
             pixel; a DDA adds the same m each time to what it kept",
            added.len(),
            brief_number(added[0]),
            brief_number(added[1]),
            brief_number(added[2]),
        );
        // One addition a step and coordinate; the last one may be left out.
        assert!(
            (steps - 1..=2 * steps + 2).contains(&additions.len()),
            "{what}: `add` is called {}×, but {steps} steps lead from a to b: one addition a step for the coordinate \
             that gets m, one more at most for the other",
            additions.len(),
        );
    }

    fn check(wanted: Segment) {
        let (pixels, additions) = drawn(wanted);
        let moves = || {
            pixels
                .windows(2)
                .map(|w| (w[1].0 - w[0].0, w[1].1 - w[0].1))
        };
        let d = (wanted.b - wanted.a).abs();
        let between = d.min_element() > 0 && d.x != d.y;
        assert!(
            !between || moves().any(|other| Some(other) != moves().next()),
            "{}: all steps are the same, straight or diagonal: the sum itself was rounded and lost what it had \
             gathered; round only what is plotted",
            wanted.show(),
        );
        wanted.assert_pixels(&pixels);
        check_sums(wanted, &additions);
    }

    /// n times m = k / 2²⁴ in f32, in units of 2⁻²⁴: a sum of more than 24 bits is rounded to 24, a half to even.
    fn rounded_sum(k: u64, n: u32) -> u64 {
        (0..n).fold(0, |sum, _| {
            let exact: u64 = sum + k;
            let unit = 1 << (u64::BITS - exact.leading_zeros()).saturating_sub(24);
            let (down, rest) = (exact / unit, exact % unit);
            let up = 2 * rest > unit || (2 * rest == unit && down % 2 == 1);
            unit * (down + u64::from(up))
        })
    }

    fn check_drift(k: u64, n: u32) {
        let unit = 2f64.powi(-24);
        // k has at most 24 bits.
        let m = (k as f64 * unit) as f32;
        let want = (rounded_sum(k, n) as f64 - (k * u64::from(n)) as f64) * unit;
        let got = drift(m, n);
        let what = format!("{n} additions of {m}");
        assert!(
            want == 0.0 || got.abs() > 1e-6 * want.abs(),
            "{what} drift by {want}, but got {got}: so little comes from sums in f64; add in f32",
        );
        assert!(
            want == 0.0 || got != -want,
            "{what} drift by {want}, but got {got}: the drift is the sum minus the product",
        );
        near_number(&format!("the drift of {what}"), got, want, 0.0);
    }

    #[test]
    fn known_segment() {
        let slide = Segment::new(IVec2::ZERO, IVec2::new(8, 3));
        check(slide);
        let pixels = slide.drawn_by(segment);
        Grid::of(9, 4, pixels).assert_is(
            "(0, 0) to (8, 3)",
            &["##.......", "..###....", ".....##..", ".......##"],
        );
    }

    #[test]
    fn ties() {
        let mut inputs = Inputs::new(22);
        // m has a power of two below the line, so f64 holds every sum and every tie exactly.
        for run in [8, 16, 32, 64].into_iter().flat_map(|run| [run; 50]) {
            check(Segment::any(&mut inputs, run));
        }
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(23);
        // 2 dy x / dx is never odd: no ties here.
        for run in (5..65).step_by(2).flat_map(|run| [run; 7]) {
            check(Segment::any(&mut inputs, run));
        }
        for a in [IVec2::ZERO, IVec2::new(7, -5)] {
            check(Segment::new(a, a));
        }
    }

    #[test]
    fn long_segments() {
        // 30 011 is prime: no ties, and every pixel is clear of one by 1 / 60 022. The sums of f64 are off by 10⁻⁷ at
        // most: 30 011 additions, each rounded by 2⁻³⁸, half the spacing of numbers below 2¹⁵.
        for way in [(30_011, 12_345), (-30_011, 29_998), (7, 30_011)] {
            let a = IVec2::new(100, -40);
            let long = Segment::new(a, a + IVec2::from(way));
            let pixels = long.drawn_by(segment);
            assert!(
                long.nearest(&pixels)
                    || !long.within_one(&pixels)
                    || !pixels.get(..65).is_some_and(|first| long.nearest(first)),
                "{}: most pixels are right, but not all: the sum, or m, is kept in f32, which has 24 bits; add in f64",
                long.show(),
            );
            check(long);
        }
    }

    #[test]
    fn at_the_rim_of_i32() {
        let a = IVec2::new(i32::MAX - 8, i32::MIN);
        for (a, b) in [(a, a + IVec2::new(8, 3)), (a + IVec2::new(3, 8), a)] {
            let rim = Segment::new(a, b);
            let pixels = rim.begun_by(20, segment).unwrap_or_else(|said| {
                panic!("{}: {said}: x or y goes beyond the last pixel", rim.show())
            });
            rim.assert_pixels(&pixels);
        }
        // |dx| = 2³¹ is no i32, though dx is one.
        for (x, y) in [(i32::MIN, 5), (5, i32::MIN), (i32::MIN, i32::MIN)] {
            let long = Segment::new(IVec2::ZERO, IVec2::new(x, y));
            let pixels = long.begun_by(100, segment).unwrap_or_else(|said| {
                panic!(
                    "{}: {said}: |dx| or |dy| is 2³¹, which i32 does not hold",
                    long.show()
                )
            });
            long.assert_begins_with(&pixels);
        }
    }

    #[test]
    fn any_drift() {
        let mut inputs = Inputs::new(24);
        for _ in 0..20 {
            check_drift(inputs.integer(1 << 20, (1 << 24) - 1) as u64, 20_000);
        }
        check_drift(1 << 23, 20_000);
        check_drift(12_345, 0);
    }

    #[test]
    fn a_million_steps() {
        // 0.1 in f32 is 13 421 773 / 2²⁷; multiplied by 8, which rounds nothing, it is within 24 bits of 2⁻²⁴.
        let (sum, exact) = (
            rounded_sum(13_421_773, 1_000_000),
            13_421_773 * 1_000_000_u64,
        );
        let want = (sum as f64 - exact as f64) * 2f64.powi(-27);
        // The known sum is 100 958.34.
        assert!((want - 958.342_26).abs() < 1e-5);
        near_number(
            "the drift of a million additions of 0.1",
            drift(0.1, 1_000_000),
            want,
            0.0,
        );
        // 2²⁴ + 1 has 25 bits: the sum stops growing.
        near_number(
            "the drift of 2²⁴ + 5 additions of 1",
            drift(1.0, (1 << 24) + 5),
            -5.0,
            0.0,
        );
    }
}
