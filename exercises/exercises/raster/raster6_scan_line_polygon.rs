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
    use assess::{Grid, Inputs, calls_within, show_points, watched};
    use glam::{DVec2, IVec2};

    const WIDTH: i32 = 18;
    const HEIGHT: i32 = 15;

    fn pixels(polygon: &[DVec2], rule: FillRule) -> Vec<(i32, i32)> {
        let what = format!("{rule:?}, {}", show_points(polygon));
        let polygon = polygon.to_vec();
        let limit = 4 * (WIDTH * HEIGHT) as usize;
        let name = what.clone();
        let all = watched(&name, move || {
            calls_within(&what, limit, |take| {
                fill(&polygon, rule, WIDTH, HEIGHT, &mut |x, y| take((x, y)));
            })
        });
        let is_in = |x: i32, y: i32| (0..WIDTH).contains(&x) && (0..HEIGHT).contains(&y);
        if let Some((x, y)) = all.iter().find(|&&(x, y)| !is_in(x, y)) {
            let exchanged = all.iter().all(|&(x, y)| is_in(y, x));
            panic!(
                "{name}: pixel ({x}, {y}) lies outside the picture, 0 ≤ i < {WIDTH}, 0 ≤ j < {HEIGHT}{}",
                if exchanged {
                    "; with x and y exchanged all of them lie inside: plot takes the column first, then the row"
                } else {
                    ": each span is to be kept within it"
                },
            );
        }
        all
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

    fn is_odd(winding: i32) -> bool {
        winding % 2 != 0
    }

    fn is_not_zero(winding: i32) -> bool {
        winding != 0
    }

    /// What an answer may do instead of what is asked for.
    #[derive(Clone, Copy)]
    struct Way {
        /// Where in a pixel the point is that decides, in quarters.
        at: IVec2,
        is_in: fn(i32, FillRule) -> bool,
    }

    const RIGHT: Way = Way {
        at: IVec2::splat(2),
        is_in: |winding, rule| match rule {
            EvenOdd => is_odd(winding),
            NonZero => is_not_zero(winding),
        },
    };

    impl Way {
        /// Which pixels are lit; `None` where the point is on an edge.
        fn picture(self, quarters: &[IVec2], rule: FillRule) -> Vec<Option<bool>> {
            let pixels = (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| IVec2::new(i, j)));
            let lit = |pixel: IVec2| {
                let winding = winding(quarters, 4 * pixel + self.at);
                winding.map(|winding| (self.is_in)(winding, rule))
            };
            pixels.map(lit).collect()
        }
    }

    /// A polygon in quarters, and what is plotted of it.
    struct Case {
        quarters: Vec<IVec2>,
        rule: FillRule,
        pixels: Vec<(i32, i32)>,
    }

    impl Case {
        fn new(quarters: &[IVec2], rule: FillRule) -> Self {
            Self {
                quarters: quarters.to_vec(),
                rule,
                pixels: pixels(&in_pixels(quarters), rule),
            }
        }

        fn show(&self) -> String {
            format!(
                "{:?}, {}",
                self.rule,
                show_points(&in_pixels(&self.quarters))
            )
        }

        fn lit(&self, i: usize) -> bool {
            self.pixels.contains(&(i as i32 % WIDTH, i as i32 / WIDTH))
        }

        /// Whether this is the picture that `way` gives; points on an edge may be either.
        fn fits(&self, way: Way) -> bool {
            let picture = way.picture(&self.quarters, self.rule);
            let fits =
                |(i, want): (usize, &Option<bool>)| want.is_none_or(|want| want == self.lit(i));
            picture.iter().enumerate().all(fits)
        }
    }

    /// Compares the pictures. A mistake is named where all of them are what it makes of them.
    fn check(cases: &[Case]) {
        let Some(wrong) = cases.iter().find(|case| !case.fits(RIGHT)) else {
            for case in cases {
                Grid::of(WIDTH as usize, HEIGHT as usize, case.pixels.iter().copied())
                    .assert_once(&case.show());
            }
            return;
        };
        let what = wrong.show();
        let wanted = RIGHT.picture(&wrong.quarters, wrong.rule);
        let grid = Grid::of(
            WIDTH as usize,
            HEIGHT as usize,
            wrong.pixels.iter().copied(),
        );
        let compare = |why: &str| {
            grid.assert_where(&format!("{what}{why}"), |x, y| {
                let i = (x + y * WIDTH) as usize;
                wanted[i].unwrap_or_else(|| wrong.lit(i))
            });
        };
        if cases.iter().all(|case| case.pixels.is_empty()) {
            compare("");
        }
        let at = |x, y| Way {
            at: IVec2::new(x, y),
            ..RIGHT
        };
        let with = |is_in| Way { is_in, ..RIGHT };
        let ways: [(Way, &str); 6] = [
            (
                at(0, 0),
                "these are the pictures for centres in (i, j); they lie in (i + ½, j + ½)",
            ),
            (
                at(0, 2),
                "these are the pictures for centres in (i, j + ½); they lie in (i + ½, j + ½)",
            ),
            (
                at(2, 0),
                "these are the pictures for centres in (i + ½, j); they lie in (i + ½, j + ½)",
            ),
            (
                with(|winding, _| is_odd(winding)),
                "these are the pictures of the even-odd rule: with NonZero a winding number of 2 or −2 is inside too",
            ),
            (
                with(|winding, _| is_not_zero(winding)),
                "these are the pictures of the non-zero rule: with EvenOdd a winding number of 2 or −2 is outside",
            ),
            (
                with(|winding, rule| winding > 0 && (rule == NonZero || is_odd(winding))),
                "where the winding number is negative nothing is plotted, but −1 is odd and is not 0 (in Rust −1 % 2 is −1)",
            ),
        ];
        for (way, why) in ways {
            let all = cases.iter().all(|case| case.fits(way));
            if all {
                compare(&format!(": {why}"));
            }
        }
        let right_when_closed = |case: &Case| {
            let first = case.quarters.first().copied();
            let closed: Vec<_> = case.quarters.iter().copied().chain(first).collect();
            Case::new(&closed, case.rule).fits(RIGHT)
        };
        if cases.iter().all(right_when_closed) {
            compare(
                ": all would be right with the first vertex once more at the end: the edge from the last vertex to the first is missing",
            );
        }
        let in_vertex_rows = |case: &Case| {
            let wanted = RIGHT.picture(&case.quarters, case.rule);
            let differs = |&i: &usize| wanted[i].is_some_and(|want| want != case.lit(i));
            let has_vertex = |i: usize| {
                case.quarters
                    .iter()
                    .any(|v| v.y == 4 * (i as i32 / WIDTH) + 2)
            };
            (0..wanted.len()).filter(differs).all(has_vertex)
        };
        if cases.iter().all(in_vertex_rows) {
            compare(
                ": wrong in rows with a vertex alone: it belongs to the edge below it, ≤ at the top of an edge, < at its \
                 end",
            );
        }
        compare("");
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
        let mut cases = Vec::new();
        for count in [3, 4, 5, 7, 9].into_iter().flat_map(|count| [count; 40]) {
            // Odd quarters: no vertex in the row of a centre.
            let mut odd = |max| 2 * inputs.integer(-8, 2 * max + 8) + 1;
            let polygon: Vec<_> = (0..count)
                .map(|_| IVec2::new(odd(WIDTH), odd(HEIGHT)))
                .collect();
            cases.extend([EvenOdd, NonZero].map(|rule| Case::new(&polygon, rule)));
        }
        check(&cases);
    }

    #[test]
    fn vertices_on_a_row() {
        let mut inputs = Inputs::new(29);
        let mut cases = Vec::new();
        for count in [3, 4, 5, 7].into_iter().flat_map(|count| [count; 50]) {
            // All in rows of centres, none in a centre.
            let polygon: Vec<_> = (0..count)
                .map(|_| {
                    let (x, y) = (inputs.integer(0, 2 * WIDTH), inputs.integer(0, HEIGHT));
                    IVec2::new(2 * x + 1, 4 * y + 2)
                })
                .collect();
            cases.extend([EvenOdd, NonZero].map(|rule| Case::new(&polygon, rule)));
        }
        check(&cases);
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
                "{} has no area, but {} pixels are plotted, the first is {:?}",
                show_points(&polygon),
                pixels.len(),
                pixels[0],
            );
        }
    }
}
