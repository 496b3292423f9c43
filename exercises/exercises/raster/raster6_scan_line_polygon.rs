use glam::DVec2;

/// Which winding numbers are inside.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FillRule {
    /// The odd ones.
    EvenOdd,
    /// All but 0.
    NonZero,
}

/// The pixels of a picture whose centres lie in a polygon, row by row (scan line by scan line).
///
/// ```text
/// pixel (i, j) has its centre in (i + ½, j + ½),  0 ≤ i < width,  0 ≤ j < height
///
/// the edge A → B crosses y = j + ½ where  A_y ≤ y < B_y  (it runs down: +1)  or  B_y ≤ y < A_y  (it runs up: −1)
///
///                       B_x − A_x
/// X = A_x + (y − A_y) ─────────────          winding number at x: the sum over all crossings X ≤ x
///                       B_y − A_y
/// ```
///
/// The last vertex is joined to the first one. With ≤ on one side and < on the other, a vertex on the row counts
/// once where two edges run on through it, and a centre exactly on an edge belongs to what lies right of the edge
/// (below it, if it is horizontal): two polygons with a common edge share no pixel and miss none.
///
/// `plot(i, j)` lights a pixel, each once, in any order; y points down. Coordinates are finite and below 10¹⁰⁰.
///
/// Grafica 3, Rasterizzazione di Poligoni, which shows convex, concave and self-intersecting polygons and goes no
/// further.
fn fill(
    polygon: &[DVec2],
    rule: FillRule,
    width: i32,
    height: i32,
    plot: &mut dyn FnMut(i32, i32),
) {
    // TODO: for each row the crossings in order, then the pixels between one and the next.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster6_scan_line_polygon {
    use super::FillRule::{EvenOdd, NonZero};
    use super::{FillRule, fill};
    use assess::{Grid, Inputs, calls_within, show_points};
    use glam::{DVec2, IVec2};

    const WIDTH: i32 = 18;
    const HEIGHT: i32 = 15;

    fn pixels(polygon: &[DVec2], rule: FillRule) -> Vec<(i32, i32)> {
        calls_within("plotting", 4 * (WIDTH * HEIGHT) as usize, |take| {
            fill(polygon, rule, WIDTH, HEIGHT, &mut |x, y| {
                assert!(
                    (0..WIDTH).contains(&x) && (0..HEIGHT).contains(&y),
                    "{rule:?}, {}: pixel ({x}, {y}) lies outside the picture, 0 ≤ i < {WIDTH}, 0 ≤ j < {HEIGHT}",
                    show_points(polygon),
                );
                take((x, y));
            });
        })
    }

    /// Vertices in quarters of a pixel.
    fn in_pixels(quarters: &[IVec2]) -> Vec<DVec2> {
        quarters.iter().map(|v| v.as_dvec2() / 4.0).collect()
    }

    /// The winding number of a point, all in quarters and so in whole numbers; `None` on an edge.
    fn winding(quarters: &[IVec2], p: IVec2) -> Option<i32> {
        let mut winding = 0;
        for (i, &a) in quarters.iter().enumerate() {
            let b = quarters[(i + 1) % quarters.len()];
            let side = (b - a).perp_dot(p - a);
            if side == 0 && (a - p).dot(b - p) <= 0 {
                return None;
            }
            winding += match (a.y <= p.y, b.y <= p.y) {
                // The edge runs down, left of the point; or up.
                (true, false) if side < 0 => 1,
                (false, true) if side > 0 => -1,
                _ => 0,
            };
        }
        Some(winding)
    }

    /// Which of the points (i, j), moved by `at` quarters, are inside; `None` on an edge.
    fn picture(quarters: &[IVec2], is_in: fn(i32) -> bool, at: IVec2) -> Vec<Option<bool>> {
        let pixels = (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| IVec2::new(i, j)));
        pixels
            .map(|pixel| winding(quarters, 4 * pixel + at).map(is_in))
            .collect()
    }

    /// Compares the picture; centres on an edge may be either.
    fn check(quarters: &[IVec2], rule: FillRule) {
        let polygon = in_pixels(quarters);
        let what = format!("{rule:?}, {}", show_points(&polygon));
        let pixels = pixels(&polygon, rule);
        let lit = |i: usize| pixels.contains(&(i as i32 % WIDTH, i as i32 / WIDTH));
        let even_odd: fn(i32) -> bool = |winding| winding % 2 != 0;
        let non_zero: fn(i32) -> bool = |winding| winding != 0;
        let (is_in, other, positive): (_, _, fn(i32) -> bool) = match rule {
            EvenOdd => (even_odd, non_zero, |winding| {
                winding > 0 && winding % 2 == 1
            }),
            NonZero => (non_zero, even_odd, |winding| winding > 0),
        };
        let centre = IVec2::splat(2);
        let fits = |is_in, at| {
            let picture = picture(quarters, is_in, at);
            picture
                .iter()
                .enumerate()
                .all(|(i, want)| want.is_none_or(|want| want == lit(i)))
        };
        if fits(is_in, centre) {
            Grid::of(WIDTH as usize, HEIGHT as usize, pixels).assert_once(&what);
            return;
        }
        for (x, y, at) in [(0, 0, "(i, j)"), (0, 2, "(i, j + ½)"), (2, 0, "(i + ½, j)")] {
            assert!(
                !fits(is_in, IVec2::new(x, y)) || pixels.is_empty(),
                "{what}: this is the picture for centres in {at}; they lie in (i + ½, j + ½)",
            );
        }
        assert!(
            !fits(other, centre),
            "{what}: this is the picture of the {}",
            match rule {
                EvenOdd => "non-zero rule: with EvenOdd a winding number of 2 or −2 is outside",
                NonZero => "even-odd rule: with NonZero a winding number of 2 or −2 is inside too",
            },
        );
        assert!(
            !fits(positive, centre),
            "{what}: where the winding number is negative nothing is plotted, but −1 is odd and is not 0 (in Rust \
             −1 % 2 is −1)",
        );
        let wanted = picture(quarters, is_in, centre);
        let mut wrong = (0..wanted.len()).filter(|&i| wanted[i].is_some_and(|want| want != lit(i)));
        let has_vertex = |i: usize| quarters.iter().any(|v| v.y == 4 * (i as i32 / WIDTH) + 2);
        let why = if wrong.all(has_vertex) {
            ", wrong in rows with a vertex alone: it belongs to the edge below it, ≤ at the top of an edge, < at its end"
        } else {
            ""
        };
        let grid = Grid::of(WIDTH as usize, HEIGHT as usize, pixels.iter().copied());
        grid.assert_where(&format!("{what}{why}"), |x, y| {
            let i = (x + y * WIDTH) as usize;
            wanted[i].unwrap_or_else(|| lit(i))
        });
    }

    fn known(what: &str, polygon: &[(f64, f64)], rule: FillRule, want: &[&str]) {
        let polygon: Vec<_> = polygon.iter().map(|&v| DVec2::from(v)).collect();
        let grid = Grid::of(WIDTH as usize, HEIGHT as usize, pixels(&polygon, rule));
        grid.assert_is(what, want);
        grid.assert_once(what);
    }

    #[test]
    fn concave_polygon() {
        let gate = [
            (3.0, 3.0),
            (15.0, 3.0),
            (15.0, 11.0),
            (12.0, 11.0),
            (9.0, 5.0),
            (6.0, 11.0),
            (3.0, 11.0),
        ];
        let mut want = vec![".................."; 15];
        want[3..11].copy_from_slice(&[
            "...############...",
            "...############...",
            "...############...",
            "...#####..#####...",
            "...#####..#####...",
            "...####....####...",
            "...####....####...",
            "...###......###...",
        ]);
        for rule in [EvenOdd, NonZero] {
            known(&format!("a concave polygon, {rule:?}"), &gate, rule, &want);
        }
    }

    #[test]
    fn five_pointed_star() {
        let star = [
            (9.0, 0.25),
            (15.0, 14.75),
            (0.25, 5.75),
            (17.75, 5.75),
            (3.0, 14.75),
        ];
        known(
            "a star, EvenOdd: its middle has the winding number 2",
            &star,
            EvenOdd,
            &[
                "..................",
                "........##........",
                "........##........",
                "........##........",
                ".......####.......",
                ".......####.......",
                ".#####......#####.",
                "...###......###...",
                ".....#......#.....",
                ".....#......#.....",
                ".....###..###.....",
                "....####..####....",
                "....###....###....",
                "....#........#....",
                "..................",
            ],
        );
        known(
            "a star, NonZero: its middle has the winding number 2",
            &star,
            NonZero,
            &[
                "..................",
                "........##........",
                "........##........",
                "........##........",
                ".......####.......",
                ".......####.......",
                ".################.",
                "...############...",
                ".....########.....",
                ".....########.....",
                ".....########.....",
                "....####..####....",
                "....###....###....",
                "....#........#....",
                "..................",
            ],
        );
    }

    #[test]
    fn any_polygon() {
        let mut inputs = Inputs::new(28);
        for count in [3, 4, 5, 7, 9].into_iter().cycle().take(200) {
            // Odd quarters: no vertex in the row of a centre.
            let mut odd = |max| 2 * inputs.integer(-8, 2 * max + 8) + 1;
            let polygon: Vec<_> = (0..count)
                .map(|_| IVec2::new(odd(WIDTH), odd(HEIGHT)))
                .collect();
            for rule in [EvenOdd, NonZero] {
                check(&polygon, rule);
            }
        }
    }

    #[test]
    fn vertices_on_a_row() {
        let mut inputs = Inputs::new(29);
        for count in [3, 4, 5, 7].into_iter().cycle().take(200) {
            // All in rows of centres, none in a centre.
            let polygon: Vec<_> = (0..count)
                .map(|_| {
                    let (x, y) = (inputs.integer(0, 2 * WIDTH), inputs.integer(0, HEIGHT));
                    IVec2::new(2 * x + 1, 4 * y + 2)
                })
                .collect();
            for rule in [EvenOdd, NonZero] {
                check(&polygon, rule);
            }
        }
    }

    #[test]
    fn common_edges() {
        let mut inputs = Inputs::new(30);
        for _ in 0..100 {
            // A rectangle from centre to centre, cut along a diagonal: a slope that is a power of two is exact.
            let (x, y) = (
                f64::from(inputs.integer(0, 5)) + 0.5,
                f64::from(inputs.integer(0, 4)) + 0.5,
            );
            let [w, h] = [(); 2].map(|()| f64::from(1 << inputs.integer(1, 3)));
            let [a, b, c, d] = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)].map(DVec2::from);
            let triangles = if inputs.integer(0, 1) == 1 {
                [[a, b, c], [a, c, d]]
            } else {
                [[b, c, d], [b, d, a]]
            };
            let [one, other] = triangles.map(|triangle| show_points(&triangle));
            let what = format!("the triangles {one} and {other}");
            let parts = triangles.map(|triangle| pixels(&triangle, NonZero));
            for &(i, j) in parts[0].iter().filter(|pixel| parts[1].contains(pixel)) {
                let row = f64::from(j) + 0.5;
                assert!(
                    row <= y || row >= y + h,
                    "{what}: ({i}, {j}) has its centre on their common edge and is in both: a span goes from its left \
                     crossing up to, but without, its right one",
                );
            }
            let all = parts.concat();
            let (left, top) = (x as i32, y as i32);
            let want =
                |i, j| (left..left + w as i32).contains(&i) && (top..top + h as i32).contains(&j);
            for (i, j) in (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| (i, j))) {
                let times = all.iter().filter(|&&pixel| pixel == (i, j)).count();
                assert!(
                    times == usize::from(want(i, j)),
                    "{what} make a rectangle; its left and upper rim are in, the others out, but ({i}, {j}) is plotted \
                     {times}×",
                );
            }
        }
    }

    #[test]
    fn huge_and_empty() {
        let far = 1e90;
        let huge = [(-far, -far), (far, -far), (far, far), (-far, far)].map(DVec2::from);
        let full = Grid::of(WIDTH as usize, HEIGHT as usize, pixels(&huge, EvenOdd));
        full.assert_is(
            "a polygon far larger than the picture",
            &["##################"; 15],
        );
        full.assert_once("a polygon far larger than the picture");
        let [p, q] = [(2.0, 3.0), (9.0, 11.0)].map(DVec2::from);
        for polygon in [vec![], vec![p], vec![p, q], vec![p, q, q], vec![p; 9]] {
            let pixels = pixels(&polygon, NonZero);
            assert!(
                pixels.is_empty(),
                "{} has no area, but got {pixels:?}",
                show_points(&polygon)
            );
        }
    }
}
