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
    // TODO: is there one pixel a column or one a row? Then the formula for each, rounded.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster1_analytic_segment {
    use super::segment;
    use assess::{Grid, Inputs, Segment};
    use glam::IVec2;

    #[test]
    fn known_segment() {
        let slide = Segment::new(IVec2::ZERO, IVec2::new(8, 3));
        let pixels = slide.drawn_by(segment);
        slide.assert_pixels(&pixels);
        // y = 3x / 8: 0, 3/8, 6/8, 9/8, 12/8 (a tie), 15/8, 18/8, 21/8, 3.
        Grid::of(9, 4, pixels).assert_is(
            "(0, 0) to (8, 3)",
            &["##.......", "..###....", ".....##..", ".......##"],
        );
    }

    #[test]
    fn ties() {
        let mut inputs = Inputs::new(20);
        // m has a power of two below the line, so f64 holds it and every tie exactly.
        for run in [2, 4, 8, 16, 32, 64].into_iter().flat_map(|run| [run; 33]) {
            let any = Segment::any(&mut inputs, run);
            any.assert_pixels(&any.drawn_by(segment));
        }
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(21);
        let mut all = Vec::new();
        // 2 dy x / dx is never odd: no ties here.
        for run in (5..65).step_by(2).flat_map(|run| [run; 7]) {
            let any = Segment::any(&mut inputs, run);
            let pixels = any.drawn_by(segment);
            all.push((any, pixels));
        }
        assert!(
            all.iter().all(|(any, pixels)| any.nearest(pixels))
                || !all.iter().all(|(any, pixels)| any.within_one(pixels)),
            "every pixel lies within 1 of the line, but not every one is the nearest: `as i32` and `floor` cut \
             off; round instead",
        );
        for (any, pixels) in all {
            any.assert_pixels(&pixels);
        }
    }

    #[test]
    fn long_segments() {
        // 30 011 is prime: no ties, and every pixel is clear of one by 1 / 60 022, which f64 tells and f32 does not.
        for way in [(30_011, 12_345), (-30_011, 29_998), (7, 30_011)] {
            let a = IVec2::new(100, -40);
            let long = Segment::new(a, a + IVec2::from(way));
            let pixels = long.drawn_by(segment);
            assert!(
                long.nearest(&pixels)
                    || !long.within_one(&pixels)
                    || !pixels.get(..65).is_some_and(|first| long.nearest(first)),
                "{}: most pixels are right, but not all: m in f32 has 24 bits, too few for so long a segment; take f64, \
                 and round once, at the end",
                long.show(),
            );
            long.assert_pixels(&pixels);
        }
    }

    #[test]
    fn one_pixel() {
        for a in [IVec2::ZERO, IVec2::new(7, -5), IVec2::MAX] {
            let one = Segment::new(a, a);
            let pixels = one.drawn_by(segment);
            assert!(
                !pixels.is_empty(),
                "{}: plot is not called, but a = b is one pixel",
                one.show(),
            );
            assert!(
                pixels == [(a.x, a.y)],
                "{}: plotted {:?}, but this is one pixel, a itself: m = 0 / 0 is not a number",
                one.show(),
                &pixels[..pixels.len().min(3)],
            );
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
}
