use glam::{DVec2, DVec3};

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// The part of a polygon on one side of a line.
///
/// ```text
/// s(x, y) = a x + b y + c           inside: s ≥ 0
///
/// for every edge A → B, the last vertex to the first included:
///   A inside,  B inside     put B
///   A inside,  B outside    put the crossing
///   A outside, B inside     put the crossing, then B
///   A outside, B outside    put nothing
///
/// crossing = A + (B − A) s_A / (s_A − s_B)
/// ```
///
/// `line` is (a, b, c). A vertex on the line is inside, and is the crossing itself: no vertex is put twice. Vertices
/// keep their order. Fewer than three are no polygon, so the answer has none. Coordinates are finite.
///
/// Grafica 3, Clipping di un poligono: divide et impera.
fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    // TODO: walk round the polygon, edge by edge.
    todo!()
}

/// The part of a polygon in a window: clipped against one side after another.
///
/// ```text
/// x − x_min ≥ 0      x_max − x ≥ 0      y − y_min ≥ 0      y_max − y ≥ 0
/// ```
///
/// A concave polygon that falls into pieces comes out as one, joined along the border.
///
/// Grafica 3, Clipping di un poligono.
fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    // TODO: the four lines, each clipping what the one before has left.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod clip5_polygon {
    use super::{Window, clip_against_line, clip_polygon};
    use assess::{Grid, Inputs, show_point, show_points};
    use glam::{DVec2, DVec3};

    const SIZE: i32 = 24;

    /// A few roundings of numbers up to 24, at a crossing that may be flat by 1 : 240.
    const BOUND: f64 = 8.0 * f64::EPSILON * 24.0 * 240.0;

    fn points(list: &[(f64, f64)]) -> Vec<DVec2> {
        list.iter().map(|&p| p.into()).collect()
    }

    fn area(polygon: &[DVec2]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        polygon
            .iter()
            .zip(next)
            .map(|(a, b)| a.perp_dot(*b))
            .sum::<f64>()
            / 2.0
    }

    /// Whether both lists name the same polygon, from whichever vertex on.
    fn same(got: &[DVec2], want: &[DVec2]) -> bool {
        let near = |(p, q): (&DVec2, &DVec2)| (p - q).abs().max_element() <= BOUND;
        got.len() == want.len()
            && (got.is_empty()
                || (0..got.len()).any(|start| got.iter().cycle().skip(start).zip(want).all(near)))
    }

    fn show_line(line: DVec3) -> String {
        format!("{} x + {} y + {} ≥ 0", line.x, line.y, line.z)
    }

    #[track_caller]
    fn assert_same(what: &str, got: &[DVec2], want: &[DVec2]) {
        let (got_points, want_points) = (show_points(got), show_points(want));
        let turned: Vec<_> = got.iter().rev().copied().collect();
        assert!(
            same(got, want) || !same(&turned, want),
            "{what}: expected {want_points}, got {got_points}: the same vertices the other way round; they keep their order",
        );
        assert!(
            same(got, want),
            "{what}: expected {want_points}, got {got_points}"
        );
    }

    /// Any vertices with whole coordinates, also concave and self-intersecting ones.
    fn any(inputs: &mut Inputs, count: usize) -> Vec<DVec2> {
        let mut whole = || f64::from(inputs.integer(0, SIZE));
        (0..count).map(|_| DVec2::new(whole(), whole())).collect()
    }

    /// Whether a point is in the polygon by the even-odd rule; `None` on an edge.
    fn contains(polygon: &[DVec2], p: DVec2) -> Option<bool> {
        let mut inside = false;
        for (i, &a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let side = (b - a).perp_dot(p - a);
            if side == 0.0 && (a - p).dot(b - p) <= 0.0 {
                return None;
            }
            inside ^= (a.y <= p.y) != (b.y <= p.y) && (side < 0.0) == (a.y < b.y);
        }
        Some(inside)
    }

    /// Compares the pictures: a pixel is in the answer where its centre is in the polygon and `in_part`.
    fn check_picture(
        what: &str,
        polygon: &[DVec2],
        got: &[DVec2],
        in_part: impl Fn(DVec2) -> Option<bool>,
    ) {
        let centre = |i, j| DVec2::new(f64::from(i), f64::from(j)) + 0.5;
        let is_in = |i, j| contains(got, centre(i, j)).unwrap_or(false);
        let pixels = (0..SIZE).flat_map(|j| (0..SIZE).map(move |i| (i, j)));
        let pixels = pixels.filter(|&(i, j)| is_in(i, j));
        let grid = Grid::of(SIZE as usize, SIZE as usize, pixels);
        grid.assert_where(what, |i, j| {
            // Whole numbers and halves: exact. A centre on an edge or on the line may be either.
            let want = contains(polygon, centre(i, j)).zip(in_part(centre(i, j)));
            want.map_or_else(|| is_in(i, j), |(inside, in_part)| inside && in_part)
        });
    }

    #[test]
    fn known_triangle() {
        let triangle = points(&[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        let got = clip_against_line(&triangle, DVec3::new(-1.0, 0.0, 10.0));
        let want = points(&[(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 15.0)]);
        assert_same("the triangle against x ≤ 10", &got, &want);

        let window = Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        };
        let got = clip_polygon(window, &triangle);
        let want = points(&[(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
        assert_same("the triangle in the window 0…10", &got, &want);
        assert!(
            area(&got) == 25.0,
            "the square has the area 25, not {}",
            area(&got)
        );
    }

    #[test]
    fn any_line() {
        let mut inputs = Inputs::new(39);
        for count in [3, 4, 5, 8].into_iter().cycle().take(200) {
            let polygon = any(&mut inputs, count);
            let line = inputs.whole_vector(-5, 5) * DVec3::new(1.0, 1.0, 20.0);
            let got = clip_against_line(&polygon, line);
            let what = format!("{} against {}", show_points(&polygon), show_line(line));
            let side = |p: DVec2| line.dot(p.extend(1.0));
            for edge in polygon.windows(2) {
                let (a, b) = (edge[0], edge[1]);
                if side(a) < 0.0 && side(b) > 0.0 {
                    let crossing = a.lerp(b, side(a) / (side(a) - side(b)));
                    assert!(
                        got.is_empty()
                            || got
                                .iter()
                                .any(|p| (p - crossing).abs().max_element() <= BOUND),
                        "{what}: the edge {} to {} comes in from outside: its crossing {} is put, then B",
                        show_point(a),
                        show_point(b),
                        show_point(crossing),
                    );
                }
            }
            check_picture(&what, &polygon, &got, |p| {
                (side(p) != 0.0).then_some(side(p) > 0.0)
            });
        }
    }

    #[test]
    fn any_window() {
        let mut inputs = Inputs::new(40);
        for count in [3, 4, 5, 8].into_iter().cycle().take(200) {
            let polygon = any(&mut inputs, count);
            let min = DVec2::new(inputs.integer(1, 9).into(), inputs.integer(1, 9).into());
            let max = min + DVec2::new(inputs.integer(3, 12).into(), inputs.integer(3, 12).into());
            let got = clip_polygon(Window { min, max }, &polygon);
            let what = format!(
                "{} in the window {} to {}",
                show_points(&polygon),
                show_point(min),
                show_point(max)
            );
            for (side, beyond) in [
                ("upper", got.iter().any(|p| p.y > max.y + BOUND)),
                ("lower", got.iter().any(|p| p.y < min.y - BOUND)),
                ("right", got.iter().any(|p| p.x > max.x + BOUND)),
                ("left", got.iter().any(|p| p.x < min.x - BOUND)),
            ] {
                assert!(
                    !beyond,
                    "{what}: {} goes beyond the {side} side: clip against all four",
                    show_points(&got)
                );
            }
            check_picture(&what, &polygon, &got, |p| {
                Some(p.cmpge(min).all() && p.cmple(max).all())
            });
        }
    }

    #[test]
    fn any_first_vertex() {
        let mut inputs = Inputs::new(41);
        for count in [3, 4, 5, 8].into_iter().cycle().take(100) {
            let mut polygon = any(&mut inputs, count);
            let line = inputs.whole_vector(-5, 5) * DVec3::new(1.0, 1.0, 20.0);
            let before = clip_against_line(&polygon, line);
            polygon.rotate_left(1);
            let after = clip_against_line(&polygon, line);
            assert!(
                same(&before, &after),
                "{} against {}: {}, but {} when the list begins one vertex earlier: the edge from the last vertex to \
                 the first belongs to the polygon",
                show_points(&polygon),
                show_line(line),
                show_points(&after),
                show_points(&before),
            );
        }
    }

    #[test]
    fn vertices_on_the_line() {
        let square = points(&[(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)]);
        for (line, want) in [
            // Through two corners; along a side, from within and from without; through one corner; beyond.
            ((1.0, -1.0, 0.0), vec![(2.0, 2.0), (8.0, 2.0), (8.0, 8.0)]),
            (
                (1.0, 0.0, -2.0),
                vec![(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)],
            ),
            ((-1.0, 0.0, 2.0), vec![]),
            ((-1.0, -1.0, 4.0), vec![]),
            (
                (1.0, 1.0, -4.0),
                vec![(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)],
            ),
            ((0.0, 1.0, -9.0), vec![]),
        ] {
            let got = clip_against_line(&square, line.into());
            let what = format!(
                "the square (2, 2) to (8, 8) against {}",
                show_line(line.into())
            );
            let next = got.iter().cycle().skip(1);
            assert!(
                !got.iter().zip(next).any(|(p, q)| p == q),
                "{what}: {} has a vertex twice: one on the line is its own crossing",
                show_points(&got),
            );
            let what = format!("{what}, and a vertex on the line is inside");
            assert_same(&what, &got, &points(&want));
        }
        for few in [&square[..0], &square[..1], &square[..2]] {
            let got = clip_against_line(few, DVec3::Z);
            assert_same(&format!("{} is no polygon", show_points(few)), &got, &[]);
        }
    }

    #[test]
    fn huge_and_tiny() {
        let triangle = points(&[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        // Powers of two scale every step exactly.
        for scale in [2f64.powi(400), 2f64.powi(-400)] {
            let window = Window {
                min: DVec2::ZERO,
                max: DVec2::splat(10.0 * scale),
            };
            let large: Vec<_> = triangle.iter().map(|p| scale * p).collect();
            let got: Vec<_> = clip_polygon(window, &large)
                .iter()
                .map(|p| p / scale)
                .collect();
            let want = points(&[(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
            assert_same(
                &format!("window and triangle {scale:e} times as large, in such units"),
                &got,
                &want,
            );
        }
    }
}
