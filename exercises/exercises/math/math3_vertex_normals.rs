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
/// normal and is left out. `None` where no triangle is left or the sum is (0, 0, 0).
///
/// N is right to 256 ε Σ wᵢ / ‖Σ wᵢ n̂ᵢ‖ in each coordinate, ε being `f64::EPSILON`, where the angles lie between 5°
/// and 175°; an arc cosine is good enough for that. A thinner triangle counts too, but has fewer digits. Sides may be
/// from 10⁻⁷⁰ to 10⁷⁰ long.
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
    use assess::{Inputs, brief, brief_number, is_near, parallel};
    use glam::DVec3;

    const WEIGHTINGS: [Weighting; 3] = [Plain, Area, Angle];

    /// The bound of the doc comment, for sums that are not short.
    const BOUND: f64 = 256.0 * f64::EPSILON;

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
        what: &str,
        positions: &[DVec3],
        triangles: &[[usize; 3]],
        vertex: usize,
        weighting: Weighting,
    ) -> DVec3 {
        let Some(n) = vertex_normal(positions, triangles, vertex, weighting) else {
            panic!("{weighting:?}, {what}: got None, but triangles with an area meet there");
        };
        assert!(!n.is_nan(), "{weighting:?}, {what}: got Some(NaN)");
        assert!(
            n != DVec3::ZERO,
            "{weighting:?}, {what}: got (0, 0, 0), which is no direction"
        );
        n
    }

    #[track_caller]
    fn near(what: &str, n: DVec3, want: DVec3, bound: f64) {
        assert!(
            is_near(n, want, bound),
            "{what}: expected {}, got {} (off by {:.1e}, allowed is {bound:.1e})",
            brief(want),
            brief(n),
            (n - want).abs().max_element(),
        );
    }

    /// What holds of one triangle and of three is asked first in each test.
    fn examine_first() {
        // The vertex, a corner at 2 on each axis, a triangle elsewhere, and a corner at 45°.
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let positions = [
            DVec3::ZERO,
            2.0 * x,
            2.0 * y,
            2.0 * z,
            9.0 * x,
            9.0 * x + y,
            9.0 * x + z,
            2.0 * x + 2.0 * y,
        ];
        let elsewhere = [4, 5, 6];
        for weighting in WEIGHTINGS {
            let ask = |what: &str, triangles: &[[usize; 3]]| {
                normal(what, &positions, triangles, 0, weighting)
            };
            if weighting == Angle && vertex_normal(&positions, &[[0, 1, 2]], 0, Angle).is_none() {
                let half = vertex_normal(&positions, &[[0, 1, 7]], 0, Angle);
                assert!(
                    half.is_none(),
                    "Angle: a triangle with a right angle at the vertex does not count, but one with 45° does: the weight \
                     is the angle itself (its cosine, for one, is 0 at 90°)",
                );
            }
            let three = [[0, 1, 2], [0, 2, 3], [0, 3, 1]];
            let what = "three equal triangles with the normals (0, 0, 1), (1, 0, 0), (0, 1, 0)";
            let n = ask(what, &three);
            for (which, part) in [("first", n.z), ("second", n.x), ("third", n.y)] {
                assert!(
                    part.abs() > BOUND,
                    "{weighting:?}, {what}: N is {}, so the {which} triangle does not count",
                    brief(n),
                );
            }
            let what = "the triangle (0, 0, 0) (2, 0, 0) (0, 2, 0) at the vertex (0, 0, 0)";
            let n = ask(what, &[[0, 1, 2]]);
            assert!(
                !parallel(-n, z, BOUND),
                "{weighting:?}, {what}: N is {}, inwards, as AC × AB is",
                brief(n),
            );
            assert!(
                !parallel(n, z, BOUND) || (n.length() - 1.0).abs() <= BOUND,
                "{weighting:?}, {what}: the direction is right, but the length is {}: make the sum unit",
                brief_number(n.length()),
            );
            near(&format!("{weighting:?}, {what}"), n, z, BOUND);

            for (place, triangle) in [("third", [1, 2, 0]), ("second", [2, 0, 1])] {
                let listed = format!("{what}, which it lists as its {place} corner");
                let n = ask(&listed, &[triangle]);
                assert!(
                    !parallel(-n, z, BOUND),
                    "{weighting:?}, {listed}: N turns to {}, inwards: from the vertex on, the corners must run round \
                     the triangle in the same order",
                    brief(n),
                );
                near(&format!("{weighting:?}, {listed}"), n, z, BOUND);
            }

            for triangles in [[[0, 1, 2], elsewhere], [elsewhere, [0, 1, 2]]] {
                let n = ask("one of two triangles at the vertex", &triangles);
                assert!(
                    is_near(n, z, BOUND),
                    "{weighting:?}: N changes from (0, 0, 1) to {} when the mesh has a triangle elsewhere, without \
                     the vertex among its corners: only those at the vertex count",
                    brief(n),
                );
            }

            let what = "three equal triangles with the normals (0, 0, 1), (1, 0, 0), (0, 1, 0)";
            let n = ask(what, &three);
            let [first, second, third] = three;
            let again = ask(what, &[third, first, second]);
            assert!(
                parallel(n, again, BOUND),
                "{weighting:?}, {what}: N is {}, and {} when the third triangle is listed first: add all of them and \
                 make the sum unit once, after the loop",
                brief(n),
                brief(again),
            );
            assert!(
                !parallel(n, x + y + z, BOUND) || (n.length() - 1.0).abs() <= BOUND,
                "{weighting:?}, {what}: the direction is right, but the length is {}: make the sum unit",
                brief_number(n.length()),
            );
            near(
                &format!("{weighting:?}, {what}"),
                n,
                (x + y + z).normalize(),
                BOUND,
            );
        }
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

    /// A triangle by its two sides at the vertex and the angle between them in degrees.
    #[derive(Clone, Copy)]
    struct Corner(f64, f64, f64);

    impl Corner {
        fn angle(self) -> f64 {
            self.2.to_radians()
        }

        fn weight(self, weighting: Weighting) -> f64 {
            match weighting {
                Plain => 1.0,
                Area => self.0 * self.1 * self.angle().sin() / 2.0,
                Angle => self.angle(),
            }
        }
    }

    /// The vertex normal of two triangles that are square to each other: the normal of `first` is (0, 0, 1) and that
    /// of `second` (1, 0, 0). So N.x / N.z is how many times the first one's weight the second one has.
    fn two(first: Corner, second: Corner, turn: usize, weighting: Weighting) -> DVec3 {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let far = |c: Corner, u: DVec3, v: DVec3| {
            let (sin, cos) = c.angle().sin_cos();
            c.1 * (cos * u + sin * v)
        };
        let positions = [
            DVec3::ZERO,
            first.0 * x,
            far(first, x, y),
            second.0 * y,
            far(second, y, z),
        ];
        let triangles = [[0, 1, 2], [0, 3, 4]].map(|mut triangle| {
            triangle.rotate_left(turn);
            triangle
        });
        normal(
            "two triangles square to each other",
            &positions,
            &triangles,
            0,
            weighting,
        )
    }

    fn times(first: Corner, second: Corner, weighting: Weighting) -> f64 {
        let n = two(first, second, 0, weighting);
        n.x / n.z
    }

    fn same(a: f64, b: f64) -> bool {
        (a - b).abs() <= 4.0 * BOUND * b
    }

    #[test]
    fn slide_cube() {
        examine_first();
        let positions = corners(DVec3::splat(10.0));
        // At vertex 0 the faces −y and −z are cut into two triangles that touch it, −x into one or two.
        let one = cut([true, true, true, true, false, true]);
        let two = cut([true; 6]);
        let even = -DVec3::ONE / 3f64.sqrt();
        let uneven = DVec3::new(-1.0, -2.0, -2.0) / 3.0;
        for (weighting, triangles, want, why) in [
            (Plain, &two, even, "two triangles of each face"),
            (
                Plain,
                &one,
                uneven,
                "one triangle of −x, two of −y and of −z",
            ),
            (Area, &two, even, "all triangles are of one size here"),
            (Area, &one, uneven, "all triangles are of one size here"),
            (Angle, &two, even, "the angles of each face add up to 90°"),
            (Angle, &one, even, "the angles of each face add up to 90°"),
        ] {
            let what = "the corner (0, 20, 0) of the cube";
            let n = normal(what, &positions, triangles, 0, weighting);
            near(&format!("{weighting:?}, {what}, {why}"), n, want, BOUND);
        }
        for vertex in 0..8 {
            let outwards = (positions[vertex] - DVec3::new(5.0, 25.0, 5.0)).normalize();
            let what = format!("the corner {} of the cube", brief(positions[vertex]));
            let n = normal(&what, &positions, &one, vertex, Angle);
            near(&format!("Angle, {what}"), n, outwards, BOUND);
        }
    }

    #[test]
    fn weights() {
        examine_first();
        let square = Corner(1.0, 1.0, 90.0);
        let larger = Corner(2.0, 2.0, 90.0);
        let found = WEIGHTINGS.map(|weighting| times(square, larger, weighting));
        for (weighting, found) in [Plain, Angle].into_iter().zip([found[0], found[2]]) {
            assert!(
                same(found, 1.0),
                "{weighting:?}: of two right angles, one with four times the area counts {} times as much: ‖AB × AC‖ \
                 is twice the area, so the weight belongs to the unit normal",
                brief_number(found),
            );
        }
        assert!(
            !same(found[1], 1.0),
            "Area: a triangle with four times the area counts no more than the other: its weight is missing",
        );
        assert!(
            same(found[1], 4.0),
            "Area: a triangle with four times the area counts {} times as much, but must count 4 times: the weight \
             is the area itself, and belongs to the unit normal",
            brief_number(found[1]),
        );

        let longer = times(square, Corner(1.0, 2.0, 90.0), Angle);
        assert!(
            same(longer, 1.0),
            "Angle: two triangles have a right angle at the vertex, but the one with sides 1 and 2 there counts {} \
             times as much as the one with 1 and 1: the angle is the one at the vertex, not at another corner",
            brief_number(longer),
        );
        let half = times(Corner(1.0, 1.0, 45.0), square, Angle);
        assert!(
            !same(half, 1.0),
            "Angle: 90° counts no more than 45°: the angle is missing as the weight",
        );
        assert!(
            same(half, 2.0),
            "Angle: 90° counts {} times as much as 45°, but must count twice: the weight is the angle itself, not \
             a function of it",
            brief_number(half),
        );
        let obtuse = times(Corner(1.0, 1.0, 60.0), Corner(1.0, 1.0, 120.0), Angle);
        assert!(
            !same(obtuse, 1.0),
            "Angle: 120° counts as much as 60°: both have one sine, so the arc sine of ‖AB × AC‖ / (‖AB‖ ‖AC‖) does \
             not tell an obtuse angle; the cosine does",
        );
        assert!(
            obtuse > 0.0,
            "Angle: 120° counts {} times as much as 60°: the arc tangent of ‖AB × AC‖ / (AB·AC) is negative beyond 90°, \
             but atan2 of the two is not",
            brief_number(obtuse),
        );
        assert!(
            same(obtuse, 2.0),
            "Angle: 120° counts {} times as much as 60°, but must count twice",
            brief_number(obtuse),
        );

        let mut inputs = Inputs::new(5);
        for _ in 0..200 {
            let [first, second] = [(); 2].map(|()| {
                Corner(
                    inputs.real(1.0, 9.0),
                    inputs.real(1.0, 9.0),
                    inputs.real(10.0, 170.0),
                )
            });
            for weighting in WEIGHTINGS {
                let n = two(first, second, 0, weighting);
                let [w1, w2] = [first, second].map(|corner| corner.weight(weighting));
                let show = |Corner(ab, ac, angle): Corner| {
                    format!(
                        "‖AB‖ {}, ‖AC‖ {}, {}°",
                        brief_number(ab),
                        brief_number(ac),
                        brief_number(angle)
                    )
                };
                assert!(
                    is_near(n, DVec3::new(w2, 0.0, w1).normalize(), 2.0 * BOUND),
                    "{weighting:?}: a triangle with {} counts {} times as much as one with {}, but must count {} times",
                    show(second),
                    brief_number(n.x / n.z),
                    show(first),
                    brief_number(w2 / w1),
                );
            }
        }
    }

    #[test]
    fn any_order_of_corners() {
        examine_first();
        let corners_of_two = [Corner(1.0, 1.0, 90.0), Corner(1.0, 2.0, 90.0)];
        for turn in [1, 2] {
            for weighting in WEIGHTINGS {
                let [first, second] = corners_of_two;
                let n = two(first, second, 0, weighting);
                let again = two(first, second, turn, weighting);
                assert!(
                    parallel(n, again, BOUND),
                    "{weighting:?}: N is {} when two triangles list the vertex first, and {} when they list it {}: \
                     {}",
                    brief(n),
                    brief(again),
                    ["third", "second"][turn - 1],
                    match weighting {
                        Angle => "the angle is the one at the vertex, wherever that is listed",
                        Plain | Area => "it is the same mesh",
                    },
                );
            }
        }
        let mut inputs = Inputs::new(3);
        for _ in 0..200 {
            let (size, triangles, vertex) = any_box(&mut inputs);
            let turned: Vec<_> = triangles.iter().map(|&[a, b, c]| [b, c, a]).collect();
            for weighting in WEIGHTINGS {
                let what = format!("vertex {vertex} of a box of {}", brief(size));
                let n = normal(&what, &corners(size), &triangles, vertex, weighting);
                let again = normal(&what, &corners(size), &turned, vertex, weighting);
                assert!(
                    parallel(n, again, BOUND),
                    "{weighting:?}, {what}: N depends on which corner a triangle lists first: {} or {}",
                    brief(n),
                    brief(again),
                );
            }
        }
    }

    #[test]
    fn any_size() {
        examine_first();
        let mut inputs = Inputs::new(4);
        for _ in 0..200 {
            let (size, triangles, vertex) = any_box(&mut inputs);
            for weighting in WEIGHTINGS {
                let what = format!("vertex {vertex} of a box of {}", brief(size));
                let n = normal(&what, &corners(size), &triangles, vertex, weighting);
                let want = expected(size, &triangles, vertex, weighting);
                near(&format!("{weighting:?}, {what}"), n, want, BOUND);
            }
        }
    }

    #[test]
    fn without_area() {
        examine_first();
        let mut positions = corners(DVec3::splat(10.0));
        positions.push(DVec3::new(5.0, 20.0, 0.0));
        for weighting in WEIGHTINGS {
            let none = vertex_normal(&positions, &[[1, 2, 3]], 0, weighting);
            assert!(
                none.is_none(),
                "{weighting:?}: no triangle meets the vertex, so None, got {none:?}"
            );
            // A point, an edge run twice, and three points in a row.
            for flat in [[0, 0, 0], [0, 1, 1], [1, 0, 1], [0, 8, 1]] {
                let mut triangles = cut([true; 6]);
                let want = normal("the whole cube", &positions, &triangles, 0, weighting);
                triangles.insert(0, flat);
                let what = format!(
                    "{weighting:?}, the cube and a triangle without area, {} {} {}",
                    brief(positions[flat[0]]),
                    brief(positions[flat[1]]),
                    brief(positions[flat[2]])
                );
                let Some(n) = vertex_normal(&positions, &triangles, 0, weighting) else {
                    panic!("{what}: got None, but that triangle is left out and the others count");
                };
                assert!(
                    !n.is_nan(),
                    "{what}: got Some(NaN): it has no normal and is left out"
                );
                near(&what, n, want, BOUND);
                let alone = vertex_normal(&positions, &[flat], 0, weighting);
                assert!(
                    alone.is_none(),
                    "{weighting:?}: only a triangle without area is there, so None, got {alone:?}"
                );
            }
        }
    }

    #[test]
    fn thin() {
        examine_first();
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let triangles = [[0, 1, 2], [0, 3, 4]];
        // A right angle with the normal (0, 0, 1), and a thin triangle with the normal (1, 0, 0).
        for thin in [1e-3, 1e-6, 1e-9] {
            let positions = [DVec3::ZERO, x, y, y, y + thin * z];
            for (weighting, want) in [
                (Plain, x + z),
                (Area, thin * x + z),
                (Angle, f64::atan(thin) * x + f64::acos(0.0) * z),
            ] {
                let what = format!("a right angle and an angle of {thin:e}");
                let n = normal(&what, &positions, &triangles, 0, weighting);
                assert!(
                    weighting == Angle || n.x > 0.0,
                    "{weighting:?}, {what}: N is {}: the thin triangle, with the normal (1, 0, 0), does not count, but it \
                     has an area",
                    brief(n),
                );
                near(&format!("{weighting:?}, {what}"), n, want.normalize(), 1e-7);
            }
        }
        let mut inputs = Inputs::new(6);
        for _ in 0..200 {
            let side = inputs.whole_vector(1, 9);
            let positions = [DVec3::ZERO, x, y, side, side + 1e-9 * y];
            let n = vertex_normal(&positions, &triangles, 0, Angle);
            assert!(
                n.is_some_and(|n| is_near(n, z, 1e-7)),
                "Angle, a right angle with the normal (0, 0, 1) and an angle below 10⁻⁹ along {}: got {}: rounded, \
                 AB·AC / (‖AB‖ ‖AC‖) may be above 1, which has no arc cosine",
                brief(side),
                n.map_or("None".to_owned(), brief),
            );
        }
    }

    #[test]
    fn sum_is_zero() {
        examine_first();
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        // The same triangle from both sides. Whole coordinates: each product of one is that of the other, negated.
        let positions = [
            DVec3::ZERO,
            DVec3::new(3.0, 1.0, 0.0),
            DVec3::new(-1.0, 2.0, 2.0),
        ];
        for weighting in WEIGHTINGS {
            for triangles in [[[0, 1, 2], [0, 2, 1]], [[1, 2, 0], [2, 1, 0]]] {
                let Some(n) = vertex_normal(&positions, &triangles, 0, weighting) else {
                    continue;
                };
                assert!(
                    !n.is_nan(),
                    "{weighting:?}, a triangle and its back: got Some(NaN): the sum is (0, 0, 0) and cannot be made \
                     unit, so the answer is None",
                );
                panic!(
                    "{weighting:?}, a triangle and its back: the sum is (0, 0, 0), so the answer is None, got {}",
                    brief(n),
                );
            }
            // The back a little aside: its normal is (0, aside, −1), so the sum is nearly (0, aside, 0).
            for aside in [1e-3_f64, 1e-6, 1e-9] {
                let s = 1.0 / (1.0 + aside * aside).sqrt();
                let want = match weighting {
                    Plain | Angle => aside * s * y + aside * aside * s * s / (1.0 + s) * z,
                    Area => aside * y,
                };
                let positions = [DVec3::ZERO, x, y, y + aside * z];
                let n = vertex_normal(&positions, &[[0, 1, 2], [0, 3, 1]], 0, weighting);
                let what =
                    format!("{weighting:?}, a triangle and, {aside:e} aside, nearly its back");
                let Some(n) = n else {
                    panic!("{what}: got None, but the sum is only short, not (0, 0, 0)");
                };
                near(&what, n, want.normalize(), 2.0 * BOUND / aside);
            }
        }
    }

    #[test]
    fn huge_and_tiny() {
        examine_first();
        let triangles = cut([true, true, true, true, false, true]);
        for scale in [1.0, 1e3, 1e6, 1e9, 1e69, 1e-3, 1e-6, 1e-9, 1e-71] {
            let positions: Vec<_> = corners(DVec3::splat(10.0))
                .into_iter()
                .map(|p| scale * (p - DVec3::new(0.0, 20.0, 0.0)))
                .collect();
            for (weighting, want) in [
                (Plain, DVec3::new(-1.0, -2.0, -2.0) / 3.0),
                (Area, DVec3::new(-1.0, -2.0, -2.0) / 3.0),
                (Angle, -DVec3::ONE / 3f64.sqrt()),
            ] {
                let what = format!("the cube {scale:e} times as large");
                let n = normal(&what, &positions, &triangles, 0, weighting);
                near(&format!("{weighting:?}, {what}"), n, want, BOUND);
            }
        }
    }
}
