use glam::DVec3;

/// How much a triangle counts in the mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Weighting {
    /// All the same.
    Plain,
    /// By its area.
    Area,
    /// By its angle at the vertex.
    Angle,
}

/// The normal of a vertex: the mean direction of the triangles that meet there, of unit length.
///
/// ```text
/// N = Σ wᵢ n̂ᵢ / ‖Σ wᵢ n̂ᵢ‖          n̂ᵢ = AB × AC / ‖AB × AC‖
///
/// Plain: wᵢ = 1     Area: wᵢ = ‖AB × AC‖ / 2     Angle: wᵢ = the angle at the vertex between its two sides
/// ```
///
/// The sum runs over the triangles A B C that have the vertex as a corner; `triangles` holds indices into
/// `positions`, all in range, in the order that makes AB × AC point outwards. A triangle without area has no
/// normal and is left out. `None` where no triangle is left or the sum is zero.
///
/// The deck takes the mean of the *faces*. A mesh has triangles, and a face of the cube meets its corner in one
/// or in two of them, as its diagonal runs: find out which weighting does not notice.
///
/// Olomouc, Gouraud shading.
fn vertex_normal(
    positions: &[DVec3],
    triangles: &[[usize; 3]],
    vertex: usize,
    weighting: Weighting,
) -> Option<DVec3> {
    // TODO: add up the weighted normals of the triangles that have `vertex` as a corner.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod math3_vertex_normals {
    use super::{Weighting, vertex_normal};
    use Weighting::{Angle, Area, Plain};
    use assess::{Inputs, is_near, near, parallel, show, some};
    use glam::DVec3;

    /// The corners of a box in the deck's order, its lowest one at (0, 20, 0).
    fn corners(size: DVec3) -> Vec<DVec3> {
        [
            (0, 0, 0),
            (1, 0, 0),
            (1, 0, 1),
            (0, 0, 1),
            (0, 1, 0),
            (1, 1, 0),
            (1, 1, 1),
            (0, 1, 1),
        ]
        .map(|(x, y, z)| {
            DVec3::new(0.0, 20.0, 0.0) + size * DVec3::new(x.into(), y.into(), z.into())
        })
        .to_vec()
    }

    /// The faces −y, +y, −z, +z, −x, +x, outwards, each cut along the diagonal from its first corner or across.
    fn cut(from_first: [bool; 6]) -> Vec<[usize; 3]> {
        let faces = [
            [0, 1, 2, 3],
            [4, 7, 6, 5],
            [0, 4, 5, 1],
            [3, 2, 6, 7],
            [0, 3, 7, 4],
            [1, 5, 6, 2],
        ];
        let halves = |([a, b, c, d], from_first): ([usize; 4], bool)| {
            if from_first {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            }
        };
        faces.into_iter().zip(from_first).flat_map(halves).collect()
    }

    fn normal(
        positions: &[DVec3],
        triangles: &[[usize; 3]],
        vertex: usize,
        weighting: Weighting,
    ) -> DVec3 {
        let what = format!("vertex {vertex}, {weighting:?}");
        let n = vertex_normal(positions, triangles, vertex, weighting);
        some(&what, n, "triangles with area meet there")
    }

    /// A box of any size, cut along any diagonals, and one of its vertices.
    fn any_box(inputs: &mut Inputs) -> (DVec3, Vec<[usize; 3]>, usize) {
        let size = inputs.whole_vector(1, 9);
        let triangles = cut([(); 6].map(|()| inputs.integer(0, 1) == 1));
        (size, triangles, inputs.integer(0, 7) as usize)
    }

    /// The faces of a box are square to the axes, so each triangle's outward normal is known without any product:
    /// it runs along the one coordinate in which its corners agree.
    fn expected(
        size: DVec3,
        triangles: &[[usize; 3]],
        vertex: usize,
        weighting: Weighting,
    ) -> DVec3 {
        let positions = corners(size);
        let middle = DVec3::new(0.0, 20.0, 0.0) + size / 2.0;
        let mut counts = DVec3::ZERO;
        for triangle in triangles
            .iter()
            .filter(|triangle| triangle.contains(&vertex))
        {
            let [a, b, c] = triangle.map(|corner| positions[corner]);
            for axis in 0..3 {
                if a[axis] == b[axis] && a[axis] == c[axis] {
                    counts[axis] += (a[axis] - middle[axis]).signum();
                }
            }
        }
        match weighting {
            Plain => counts.normalize(),
            // A triangle is half of its face, whose area is the product of the two other sizes.
            Area => {
                (counts * DVec3::new(size.y * size.z, size.z * size.x, size.x * size.y)).normalize()
            }
            // However a face is cut, its angles at the vertex add up to a right angle.
            Angle => counts.signum() / 3f64.sqrt(),
        }
    }

    /// Sums of at most six weighted unit normals; an angle of a 1 : 9 box loses a decimal digit to the arc cosine.
    const BOUND: f64 = 64.0 * f64::EPSILON;

    #[test]
    fn slide_cube() {
        let positions = corners(DVec3::splat(10.0));
        // At vertex 0 the faces −y and −z are cut into two triangles that touch it, −x into one or two.
        let one = cut([true, true, true, true, false, true]);
        let two = cut([true; 6]);
        let even = -DVec3::ONE / 3f64.sqrt();
        let uneven = DVec3::new(-1.0, -2.0, -2.0) / 3.0;
        for (weighting, triangles, want, why) in [
            (
                Plain,
                &one,
                uneven,
                "one triangle of −x, two of −y and of −z",
            ),
            (Plain, &two, even, "two triangles of each face"),
            (Area, &one, uneven, "all triangles are of one size here"),
            (Area, &two, even, "all triangles are of one size here"),
            (Angle, &one, even, "the angles of each face add up to 90°"),
            (Angle, &two, even, "the angles of each face add up to 90°"),
        ] {
            near(
                &format!("(0, 20, 0), {weighting:?}: {why}"),
                normal(&positions, triangles, 0, weighting),
                want,
                BOUND,
            );
        }
        for vertex in 0..8 {
            let outwards = (positions[vertex] - DVec3::new(5.0, 25.0, 5.0)).normalize();
            near(
                &format!("vertex {vertex}, Angle"),
                normal(&positions, &one, vertex, Angle),
                outwards,
                BOUND,
            );
        }
    }

    #[test]
    fn any_order_of_corners() {
        let mut inputs = Inputs::new(3);
        for _ in 0..200 {
            let (size, triangles, vertex) = any_box(&mut inputs);
            let turned: Vec<_> = triangles.iter().map(|&[a, b, c]| [b, c, a]).collect();
            for weighting in [Plain, Area, Angle] {
                let n = normal(&corners(size), &triangles, vertex, weighting);
                let again = normal(&corners(size), &turned, vertex, weighting);
                assert!(
                    parallel(n, again, BOUND),
                    "{weighting:?}, a box of {}: the answer depends on which corner a triangle lists first, {} or {}: \
                     the angle is the one at the vertex",
                    show(size),
                    show(n),
                    show(again),
                );
            }
        }
    }

    #[test]
    fn any_size() {
        let mut inputs = Inputs::new(4);
        for _ in 0..200 {
            let (size, triangles, vertex) = any_box(&mut inputs);
            let what =
                |weighting| format!("{weighting:?}, vertex {vertex} of a box of {}", show(size));
            for weighting in [Plain, Area, Angle] {
                let n = normal(&corners(size), &triangles, vertex, weighting);
                let want = expected(size, &triangles, vertex, weighting);
                assert!(
                    !parallel(n, want, BOUND) || is_near(n, want, BOUND),
                    "{}: the direction is right, but its length is {}: make the sum unit",
                    what(weighting),
                    n.length(),
                );
                assert!(
                    !parallel(-n, want, BOUND),
                    "{}: the normal points inwards",
                    what(weighting)
                );
                near(&what(weighting), n, want, BOUND);
            }
        }
    }

    #[test]
    fn one_larger_triangle() {
        let mut inputs = Inputs::new(5);
        let fan = [[0, 1, 2], [0, 3, 4], [0, 5, 6]];
        for _ in 0..50 {
            // Three triangles square to each other meet at the origin; the first one is then made larger.
            let sides = [DVec3::X, DVec3::Y, DVec3::Y, DVec3::Z, DVec3::Z, DVec3::X];
            let mut positions = vec![DVec3::ZERO];
            positions.extend(sides.map(|side| inputs.real(1.0, 9.0) * side));
            let before = [Plain, Angle].map(|weighting| normal(&positions, &fan, 0, weighting));
            positions[1] *= 4.0;
            positions[2] *= 4.0;
            for (weighting, before) in [Plain, Angle].into_iter().zip(before) {
                assert!(
                    is_near(normal(&positions, &fan, 0, weighting), before, BOUND),
                    "{weighting:?}: the larger triangles count more: ‖AB × AC‖ is twice the area, so the weight \
                     belongs to the unit normal",
                );
            }
        }
    }

    #[test]
    fn without_area() {
        let mut positions = corners(DVec3::splat(10.0));
        let mut triangles = cut([true; 6]);
        let whole =
            [Plain, Area, Angle].map(|weighting| normal(&positions, &triangles, 0, weighting));
        // A point, an edge run twice, and three points in a row.
        positions.push(DVec3::new(5.0, 20.0, 0.0));
        triangles.extend([[0, 0, 0], [0, 1, 1], [1, 0, 1], [0, 8, 1]]);
        for (weighting, want) in [Plain, Area, Angle].into_iter().zip(whole) {
            let n = normal(&positions, &triangles, 0, weighting);
            assert!(
                !n.is_nan(),
                "{weighting:?} is NaN: a triangle without area has no normal and is left out"
            );
            near(
                &format!("{weighting:?}, with triangles without area"),
                n,
                want,
                BOUND,
            );
            let row = vertex_normal(&positions, &[[0, 8, 1]], 0, weighting);
            assert!(
                row.is_none(),
                "{weighting:?}: only a triangle without area is there, so None, got {row:?}"
            );
            let none = vertex_normal(&positions, &[[1, 2, 3]], 0, weighting);
            assert!(
                none.is_none(),
                "{weighting:?}: no triangle meets the vertex, so None, got {none:?}"
            );
        }
    }

    #[test]
    fn huge_and_tiny() {
        let triangles = cut([true, true, true, true, false, true]);
        for scale in [1e70, 1e-70] {
            let positions: Vec<_> = corners(DVec3::splat(10.0))
                .into_iter()
                .map(|p| scale * p)
                .collect();
            for (weighting, want) in [
                (Plain, DVec3::new(-1.0, -2.0, -2.0) / 3.0),
                (Area, DVec3::new(-1.0, -2.0, -2.0) / 3.0),
                (Angle, -DVec3::ONE / 3f64.sqrt()),
            ] {
                let what = format!("the cube {scale:e} times as large, {weighting:?}");
                near(
                    &what,
                    normal(&positions, &triangles, 0, weighting),
                    want,
                    BOUND,
                );
            }
        }
    }
}
