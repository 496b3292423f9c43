use glam::IVec2;

/// The outline of a rectangle: its four sides, each pixel once.
///
/// ```text
/// x_min ≤ x ≤ x_max  and  y_min ≤ y ≤ y_max,  and one of the four is an equality
/// ```
///
/// `min` and `max` are opposite corners and belong to it; a rectangle of one row, one column or one pixel is its own
/// outline. There is none where x_min > x_max or y_min > y_max. Any order of the pixels will do; `plot(x, y)` lights
/// one.
///
/// Grafica 3, Rasterizzazione di Poligoni: four times the algorithm for segments.
fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    // TODO: the upper and the lower side, then what is left of the other two.
    todo!()
}

/// The filled rectangle, each pixel once.
///
/// ```text
/// x_min ≤ x ≤ x_max  and  y_min ≤ y ≤ y_max
/// ```
///
/// With the same corners as the outline.
///
/// Grafica 3, Rasterizzazione di Poligoni: a double loop.
fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    // TODO: two loops.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster5_rectangle {
    use super::{fill, outline};
    use assess::{Grid, Inputs, calls_within, watched};
    use glam::IVec2;

    type Pixels = Vec<(i32, i32)>;

    /// The outline and the filled rectangle.
    fn both(min: IVec2, max: IVec2) -> [Pixels; 2] {
        [outline, fill].map(|draw| {
            watched(&show(min, max), move || {
                calls_within(&show(min, max), 10_000, |take| {
                    draw(min, max, &mut |x, y| take((x, y)));
                })
            })
        })
    }

    fn show(min: IVec2, max: IVec2) -> String {
        format!("({}, {}) to ({}, {})", min.x, min.y, max.x, max.y)
    }

    /// Each pixel of a picture of 24 × 24 asked for itself; each once.
    fn check(min: IVec2, max: IVec2) {
        let what = show(min, max);
        let inside = |x, y| min.x <= x && x <= max.x && min.y <= y && y <= max.y;
        let side = |x, y| inside(x, y) && (x == min.x || x == max.x || y == min.y || y == max.y);
        let [lines, filled] = both(min, max);

        for (name, pixels) in [("the outline", &lines), ("the filled rectangle", &filled)] {
            assert!(!pixels.is_empty(), "{name} {what}: no pixel is plotted");
            let of_other_axes = |&(x, y): &(i32, i32)| inside(y, x);
            assert!(
                pixels.iter().any(|&(x, y)| inside(x, y)) || !pixels.iter().all(of_other_axes),
                "{name} {what}: x and y are exchanged: the first pixel is {:?}",
                pixels[0],
            );
        }
        let row_or_column = min.x == max.x || min.y == max.y;
        let corner = |x, y| (x == min.x || x == max.x) && (y == min.y || y == max.y);
        let twice = lines
            .iter()
            .enumerate()
            .filter(|(i, pixel)| lines[..*i].contains(pixel));
        for (_, &(x, y)) in twice {
            let mut times = lines
                .iter()
                .map(|p| lines.iter().filter(|q| *q == p).count());
            assert!(
                row_or_column || !times.all(|times| times > 1),
                "the outline {what}: every pixel is plotted more than once",
            );
            assert!(
                row_or_column || !corner(x, y),
                "the outline {what}: the corner ({x}, {y}) is plotted twice: two sides meet there, and one has it",
            );
            assert!(
                !row_or_column,
                "the outline {what}: ({x}, {y}) is plotted twice: in a single row or column two sides are the same",
            );
        }
        let lost = |x, y| inside(x, y) && !filled.contains(&(x, y));
        let at_max = |x, y| x == max.x || y == max.y;
        let all = || (min.y..=max.y).flat_map(|y| (min.x..=max.x).map(move |x| (x, y)));
        assert!(
            filled.is_empty() || !all().all(|(x, y)| lost(x, y) == at_max(x, y)),
            "the filled rectangle {what}: its last row and column are missing: max belongs to it, `..=` goes up to it",
        );
        let lost = |x, y| side(x, y) && !lines.contains(&(x, y));
        assert!(
            row_or_column
                || !all().any(|(x, y)| lost(x, y))
                || !all().all(|(x, y)| lost(x, y) == corner(x, y)),
            "the outline {what}: the corners are missing: no side has them",
        );

        for (name, pixels, is_in) in [
            ("the outline", lines, &side as &dyn Fn(i32, i32) -> bool),
            ("the filled rectangle", filled, &inside),
        ] {
            let grid = Grid::of(24, 24, pixels);
            grid.assert_where(&format!("{name} {what}"), is_in);
            grid.assert_once(&format!("{name} {what}"));
        }
    }

    #[test]
    fn known_rectangle() {
        let [lines, filled] = both(IVec2::new(2, 1), IVec2::new(6, 4));
        let counts = (lines.len(), filled.len());
        let picture = |name, pixels, rows: [&str; 4]| {
            let frame = ["........", rows[0], rows[1], rows[2], rows[3], "........"];
            Grid::of(8, 6, pixels).assert_is(name, &frame);
        };
        picture(
            "(2, 1) to (6, 4)",
            lines,
            ["..#####.", "..#...#.", "..#...#.", "..#####."],
        );
        picture("(2, 1) to (6, 4), filled", filled, ["..#####."; 4]);
        // Two rows of 5 and two columns of 2 between them; 5 × 4.
        assert!(
            counts == (14, 20),
            "(2, 1) to (6, 4): the outline has 14 pixels and 20 fill it, but there were {counts:?} calls of plot",
        );
    }

    #[test]
    fn any_rectangle() {
        let mut inputs = Inputs::new(27);
        // From small ones to large ones.
        for largest in (2..=12).flat_map(|largest| [largest; 9]) {
            let min = IVec2::new(inputs.integer(0, 10), inputs.integer(0, 10));
            let size = IVec2::new(inputs.integer(1, largest), inputs.integer(1, largest));
            check(min, min + size);
        }
    }

    #[test]
    fn thin_rectangles() {
        let min = IVec2::new(3, 5);
        for (x, y) in [(0, 0), (1, 0), (0, 1), (6, 0), (0, 6)] {
            check(min, min + IVec2::new(x, y));
        }
        for (x, y) in [(-1, 3), (3, -1), (-1, 0), (0, -1), (-2, -2), (-1, -1)] {
            let max = min + IVec2::new(x, y);
            for pixels in both(min, max) {
                assert!(
                    pixels.is_empty(),
                    "{}: min lies beyond max, so there is no pixel, but {} are plotted, the first is {:?}",
                    show(min, max),
                    pixels.len(),
                    pixels[0],
                );
            }
        }
    }

    #[test]
    fn at_the_rim_of_i32() {
        let far = IVec2::new(i32::MAX - 2, i32::MIN);
        for (min, max) in [
            (far, far + IVec2::new(2, 1)),
            (far, far),
            (IVec2::MAX - 1, IVec2::MAX),
            (IVec2::MIN, IVec2::MIN + 1),
            (IVec2::MAX, IVec2::MAX),
            (IVec2::MIN, IVec2::MIN),
        ] {
            for mut pixels in both(min, max) {
                pixels.sort_unstable();
                let all: Pixels = (min.x..=max.x)
                    .flat_map(|x| (min.y..=max.y).map(move |y| (x, y)))
                    .collect();
                // With two rows at most, the outline is the filled rectangle.
                assert!(
                    pixels == all,
                    "{}: {} pixels are plotted, the first are {:?}, but it has {}, {:?} …",
                    show(min, max),
                    pixels.len(),
                    &pixels[..pixels.len().min(2)],
                    all.len(),
                    &all[..all.len().min(2)],
                );
            }
        }
    }
}
