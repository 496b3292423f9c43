use glam::DVec3;

/// The normal of the triangle A B C: the cross product of its two sides that start in A.
///
/// ```text
/// n = AB × AC
/// ```
///
/// Seen from the side to which n points, A, B, C run counterclockwise (right-handed coordinates). Its length is
/// twice the area of the triangle, so it is not of unit length, and a triangle without area has n = (0, 0, 0).
///
/// Nothing is rounded where the coordinates are whole numbers up to 1000: there n is exact. Triangles with sides of
/// 10⁻¹⁵⁰ or 10¹⁵⁰ are triangles like all others.
///
/// Olomouc, Flat shading.
fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    // TODO: two sides, then their cross product.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod math1_triangle_normal {
    use super::triangle_normal;
    use assess::{Inputs, brief, brief_number};
    use glam::{DMat3, DVec3};

    /// The first triangle looked at: small whole numbers, A not in the origin, each component of n of another size.
    const FIRST: [DVec3; 3] = [
        DVec3::new(1.0, 0.0, 0.0),
        DVec3::new(2.0, 2.0, 0.0),
        DVec3::new(1.0, 1.0, 3.0),
    ];

    const SLIDE: [DVec3; 3] = [
        DVec3::ZERO,
        DVec3::new(10.0, 0.0, 5.0),
        DVec3::new(3.0, 2.0, 5.0),
    ];

    const ROUNDING: f64 = 16.0 * f64::EPSILON;

    fn upright(n: DVec3, sides: [DVec3; 2]) -> bool {
        sides
            .into_iter()
            .all(|side| n.dot(side).abs() <= ROUNDING * n.length() * side.length())
    }

    /// Whether the answer is upright and on the right side if its middle component is negated, and not as it is.
    fn middle_turned([a, b, c]: [DVec3; 3]) -> bool {
        let sides = [b - a, c - a];
        let n = triangle_normal(a, b, c);
        let turned = DVec3::new(n.x, -n.y, n.z);
        !upright(n, sides)
            && upright(turned, sides)
            && DMat3::from_cols(sides[0], sides[1], turned).determinant() > 0.0
    }

    /// Whole coordinates up to 1000 keep every product and sum exact, so n has no tolerance at the end. The sentences
    /// before have one of a few roundings, for n may be a rounded one.
    fn examine([a, b, c]: [DVec3; 3]) {
        let n = triangle_normal(a, b, c);
        let what = format!(
            "A {}, B {}, C {}, n {}",
            brief(a),
            brief(b),
            brief(c),
            brief(n)
        );
        let (ab, ac) = (b - a, c - a);
        // |AB|² |AC|² − (AB·AC)² is the square of twice the area.
        let square = ab.length_squared() * ac.length_squared() - ab.dot(ac).powi(2);

        if square == 0.0 {
            assert!(
                n == DVec3::ZERO,
                "{what}: this triangle has no area, so n must be (0, 0, 0)"
            );
            return;
        }
        assert!(
            n != DVec3::ZERO,
            "{what}: n is the zero vector, but this triangle has an area"
        );
        assert!(
            triangle_normal(DVec3::ZERO, ab, ac) == n,
            "{what}: n changes when the triangle is moved: it is made of the sides AB and AC, not of the points",
        );
        assert!(
            !(middle_turned([a, b, c]) && [FIRST, SLIDE].into_iter().all(middle_turned)),
            "{what}: the sign of the middle component is turned round: with AB = (x₁, y₁, z₁) and AC = (x₂, y₂, z₂) \
             it is z₁x₂ − x₁z₂",
        );
        assert!(
            upright(n, [ab, ac]),
            "{what}: n is not perpendicular to the triangle: n·AB is {} and n·AC is {}, but both must be 0",
            brief_number(n.dot(ab)),
            brief_number(n.dot(ac)),
        );
        assert!(
            DMat3::from_cols(ab, ac, n).determinant() > 0.0,
            "{what}: n points to the back, as AC × AB does: the cross product changes sign with the order of its \
             factors, and when one of the two sides is run backwards",
        );
        let length = n.length();
        assert!(
            square == 1.0 || (length - 1.0).abs() > ROUNDING,
            "{what}: this normal was made unit; AB × AC is asked for, whose length is twice the area",
        );
        assert!(
            (2.0 * length - square.sqrt()).abs() > ROUNDING * length,
            "{what}: the length of n is the area of the triangle, but that of AB × AC is twice the area",
        );
        assert!(
            n.length_squared() == square,
            "{what}: the direction is right, but the length is {}, and must be {}, twice the area (off by {:.1e}, \
             and nothing is rounded here)",
            brief_number(length),
            brief_number(square.sqrt()),
            (length - square.sqrt()).abs(),
        );
    }

    #[test]
    fn slide_triangle() {
        // AB = (10, 0, 5), AC = (3, 2, 5): 0·5 − 5·2, 5·3 − 10·5, 10·2 − 0·3.
        examine(SLIDE);
        let [a, b, c] = SLIDE;
        assert_eq!(triangle_normal(a, b, c), DVec3::new(-10.0, -35.0, 20.0));
    }

    #[test]
    fn any_triangle() {
        examine(FIRST);
        let mut inputs = Inputs::new(1);
        for size in [9, 99, 1000] {
            for _ in 0..100 {
                examine([(); 3].map(|()| inputs.whole_vector(-size, size)));
            }
        }
    }

    #[test]
    fn no_area() {
        examine(FIRST);
        let a = DVec3::new(1.0, -2.0, 3.0);
        let side = DVec3::new(2.0, 7.0, -1.0);
        for (b, c) in [
            (a, a),
            (a + side, a),
            (a, a + side),
            (a + side, a + side),
            (a + side, a + 3.0 * side),
            (a - side, a + side),
        ] {
            examine([a, b, c]);
        }
        // However thin it is: AB = (length, 0, 0) and AC = (length, 1, 0) have n = (0, 0, length), exactly.
        for length in [1e3, 1e6, 1e9] {
            let b = DVec3::new(length, 0.0, 0.0);
            let n = triangle_normal(DVec3::ZERO, b, b + DVec3::Y);
            assert!(
                n != DVec3::ZERO,
                "A (0, 0, 0), B ({length}, 0, 0), C ({length}, 1, 0) is thin, but has an area, so n is not (0, 0, 0): \
                 whether it is zero is decided without a tolerance",
            );
            assert!(
                n == length * DVec3::Z,
                "A (0, 0, 0), B ({length}, 0, 0), C ({length}, 1, 0) is thin: n must be \
                 (0, 0, {length}), got {}",
                brief(n),
            );
        }
    }

    #[test]
    fn huge_and_tiny() {
        examine(FIRST);
        let [a, b, c] = FIRST;
        let n = triangle_normal(a, b, c);
        // Powers of two near 10^±3, 10^±6, 10^±9 and 10^±150: scaling by them rounds nothing.
        for exponent in [10, 20, 30, 496, -10, -20, -30, -496] {
            let scale = 2f64.powi(exponent);
            let scaled = triangle_normal(scale * a, scale * b, scale * c);
            assert!(
                scaled != DVec3::ZERO,
                "a triangle {} times as large has an area, but n is (0, 0, 0): whether n is zero is decided without a \
                 tolerance",
                brief_number(scale),
            );
            assert!(
                scaled == scale * scale * n,
                "a triangle {} times as large has {}² = {} times the normal: {}, got {}",
                brief_number(scale),
                brief_number(scale),
                brief_number(scale * scale),
                brief(scale * scale * n),
                brief(scaled),
            );
        }
    }
}
