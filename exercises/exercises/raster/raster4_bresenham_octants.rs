use glam::IVec2;

/// The pixels of the segment from `a` to `b` in whole numbers alone: Bresenham's algorithm in all eight octants.
///
/// ```text
/// run = max(|dx|, |dy|)      rise = min(|dx|, |dy|)
///
/// d = 2F:   at a        d = 2 rise − run
///           d ≤ 0:  E,  one pixel along the longer axis;  d grows by 2 rise
///           d > 0:  NE, one pixel along both axes;        d grows by 2 rise − 2 run
/// ```
///
/// «Along» is towards b: the sign of dx or dy. The octant of the slide is 0 ≤ dy ≤ dx; the others are its mirror
/// images. d = 0 is a tie and takes E, the pixel nearer the start. The first pixel is a, the last one b; a = b is one
/// pixel. a and b are any two pixels of `i32`: dx can be 2³² − 1, and d twice that.
///
/// `plot(x, y)` lights a pixel; y points down.
///
/// Grafica 3, Algoritmo di Bresenham.
fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    // TODO: dx and dy in a type that holds them; run and rise; then the loop of raster3 along the longer axis.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster4_bresenham_octants {
    use super::segment;
    use assess::{Grid, Inputs, Segment};
    use glam::IVec2;

    #[test]
    fn known_segments() {
        let slide = Segment::new(IVec2::ZERO, IVec2::new(8, 3));
        let pixels = slide.drawn_by(segment);
        slide.assert_pixels(&pixels);
        Grid::of(9, 4, pixels).assert_is(
            "(0, 0) to (8, 3)",
            &["##.......", "..###....", ".....##..", ".......##"],
        );
        // One segment in each octant, |m| = 2/5 or 5/2.
        let centre = IVec2::splat(5);
        for end in [
            (5, 2),
            (2, 5),
            (-2, 5),
            (-5, 2),
            (-5, -2),
            (-2, -5),
            (2, -5),
            (5, -2),
        ] {
            let one = Segment::new(centre, centre + IVec2::from(end));
            one.assert_pixels(&one.drawn_by(segment));
        }
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(26);
        for run in (8..64).flat_map(|run| [run; 8]) {
            let any = Segment::any(&mut inputs, run);
            any.assert_pixels(&any.drawn_by(segment));
        }
    }

    #[test]
    fn rims_of_the_octants() {
        let a = IVec2::new(-3, 4);
        for (x, y) in [
            (0, 0),
            (1, 0),
            (1, 1),
            (0, 1),
            (-1, 1),
            (-1, 0),
            (-1, -1),
            (0, -1),
            (1, -1),
        ] {
            let rim = Segment::new(a, a + 10 * IVec2::new(x, y));
            rim.assert_pixels(&rim.drawn_by(segment));
        }
    }

    #[test]
    fn all_of_i32() {
        let (min, max) = (i32::MIN, i32::MAX);
        let start = |(ax, ay), (bx, by)| Segment::new(IVec2::new(ax, ay), IVec2::new(bx, by));
        for long in [
            start((min, min), (max, max)),
            start((min, max), (max, 0)),
            start((max, min), (max - 1, max)),
            start((max, 7), (min, -1_500_000_000)),
            start((max - 8, min), (max, min + 3)),
            start((min + 3, max - 8), (min, max)),
        ] {
            let pixels = long.begun_by(300, segment).unwrap_or_else(|said| {
                panic!(
                    "{}: {said}: i32 does not hold dx, dy and 2F, i64 does; or x or y is moved away from b",
                    long.show()
                )
            });
            long.assert_begins_with(&pixels);
        }
    }
}
