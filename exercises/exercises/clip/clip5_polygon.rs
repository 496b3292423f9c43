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
/// keep their order. Fewer than three are no polygon, so the answer has none. Coordinates and s are finite. A
/// crossing may be off by a few roundings; which side a vertex is on is decided by its s, as it is.
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
    use assess::{Inputs, PolygonCase};
    use glam::{DVec2, DVec3};

    fn points(list: &[(f64, f64)]) -> Vec<DVec2> {
        list.iter().map(|&p| p.into()).collect()
    }

    #[track_caller]
    fn against(polygon: &[DVec2], line: DVec3) {
        PolygonCase::against(polygon, line).check(&|polygon| clip_against_line(polygon, line));
    }

    #[track_caller]
    fn in_window(polygon: &[DVec2], min: DVec2, max: DVec2) {
        let clip = |polygon: &[DVec2]| clip_polygon(Window { min, max }, polygon);
        PolygonCase::in_window(polygon, min, max).check(&clip);
    }

    /// Numbers of vertices and sizes, the small ones first.
    fn sizes() -> impl Iterator<Item = (usize, i32)> {
        [(3, 6), (4, 6), (3, 24), (4, 24), (5, 24), (8, 24)]
            .into_iter()
            .flat_map(|size| [size; 50])
    }

    /// Any vertices with whole coordinates, also concave and self-intersecting ones.
    fn any(inputs: &mut Inputs, (count, size): (usize, i32)) -> Vec<DVec2> {
        let mut whole = || f64::from(inputs.integer(0, size));
        loop {
            let polygon: Vec<_> = (0..count).map(|_| DVec2::new(whole(), whole())).collect();
            let mut next = polygon.iter().cycle().skip(1);
            if polygon.iter().all(|p| next.next() != Some(p)) {
                return polygon;
            }
        }
    }

    fn any_line_near(inputs: &mut Inputs, size: i32) -> DVec3 {
        inputs.whole_vector(-5, 5) * DVec3::new(1.0, 1.0, f64::from(size) * 0.75)
    }

    #[test]
    fn known_triangle() {
        let triangle = points(&[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        against(&triangle, DVec3::new(0.0, 1.0, 0.0));
        against(&triangle, DVec3::new(-1.0, 0.0, 10.0));
        in_window(&triangle, DVec2::ZERO, DVec2::splat(20.0));
        in_window(&triangle, DVec2::ZERO, DVec2::splat(10.0));
        // The square of area 25.
        let window = Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        };
        let got = clip_polygon(window, &triangle);
        assert!(
            got.len() == 4,
            "the triangle in the window 0…10 leaves a square, and not {} vertices",
            got.len()
        );
    }

    #[test]
    fn any_line() {
        let mut inputs = Inputs::new(39);
        for size in sizes() {
            let polygon = any(&mut inputs, size);
            against(&polygon, any_line_near(&mut inputs, size.1));
        }
    }

    #[test]
    fn any_window() {
        let mut inputs = Inputs::new(40);
        let mut cases = Vec::new();
        for size in sizes() {
            let polygon = any(&mut inputs, size);
            let most = size.1 / 2;
            let mut whole = |least, most| {
                DVec2::new(
                    inputs.integer(least, most).into(),
                    inputs.integer(least, most).into(),
                )
            };
            let min = whole(1, most - 1);
            cases.push((polygon, min, min + whole(1, most)));
        }
        let with_answer = |(polygon, min, max): &(Vec<DVec2>, DVec2, DVec2)| {
            let (min, max) = (*min, *max);
            let got = clip_polygon(Window { min, max }, polygon);
            (PolygonCase::in_window(polygon, min, max), got)
        };
        PolygonCase::assert_no_pattern(&cases.iter().map(with_answer).collect::<Vec<_>>());
        for (polygon, min, max) in cases {
            in_window(&polygon, min, max);
        }
    }

    #[test]
    fn any_first_vertex() {
        let mut inputs = Inputs::new(41);
        for size in sizes() {
            let mut polygon = any(&mut inputs, size);
            let line = any_line_near(&mut inputs, size.1);
            for _ in 0..size.0 {
                polygon.rotate_left(1);
                against(&polygon, line);
            }
        }
    }

    #[test]
    fn vertices_on_the_line() {
        for few in [&[][..], &[(2.0, 2.0)], &[(2.0, 2.0), (8.0, 2.0)]] {
            let got = clip_against_line(&points(few), DVec3::Z);
            assert!(
                got.is_empty(),
                "a list of {} vertices is no polygon, so nothing is left of it, but got {} vertices",
                few.len(),
                got.len()
            );
        }
        let square = points(&[(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)]);
        for line in [
            // Along a side, from within and from without; through one corner, and two; beyond.
            (1.0, 0.0, -2.0),
            (-1.0, 0.0, 2.0),
            (1.0, 1.0, -4.0),
            (-1.0, -1.0, 4.0),
            (1.0, -1.0, 0.0),
            (-1.0, 1.0, 0.0),
            (0.0, 1.0, -9.0),
        ] {
            against(&square, line.into());
        }
    }

    #[test]
    fn a_hair_outside() {
        PolygonCase::check_hairs(clip_against_line, |min, max, polygon| {
            clip_polygon(Window { min, max }, polygon)
        });
    }

    #[test]
    fn huge_and_tiny() {
        let triangle = points(&[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        // Powers of two scale every step exactly.
        for scale in [1.0, 2f64.powi(400), 2f64.powi(-400)] {
            let scaled: Vec<_> = triangle.iter().map(|p| scale * p).collect();
            in_window(&scaled, DVec2::ZERO, DVec2::splat(10.0 * scale));
        }
    }
}
