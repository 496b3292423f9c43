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
    use assess::{Inputs, near, parallel, show};
    use glam::{DMat3, DVec3};

    /// Whole coordinates up to 1000 keep every product and sum exact, so the checks below need no tolerance.
    fn examine(a: DVec3, b: DVec3, c: DVec3) {
        let n = triangle_normal(a, b, c);
        let what = format!("A {}, B {}, C {}, n {}", show(a), show(b), show(c), show(n));
        let upright = |n: DVec3| n.dot(b - a) == 0.0 && n.dot(c - a) == 0.0;
        // |AB|² |AC|² − (AB·AC)² is the square of twice the area.
        let (ab, ac) = ((b - a).length_squared(), (c - a).length_squared());
        let square = ab * ac - (b - a).dot(c - a).powi(2);

        if square == 0.0 {
            near(
                &format!("a triangle without area: {what}"),
                n,
                DVec3::ZERO,
                0.0,
            );
            return;
        }
        let moved = triangle_normal(DVec3::ZERO, b - a, c - a);
        assert!(
            moved == n,
            "{what}: the normal changes when the triangle is moved: it is made of the sides AB and AC, not of the \
             points B and C",
        );
        assert!(
            upright(n) || !upright(DVec3::new(n.x, -n.y, n.z)),
            "{what}: the middle component has the wrong sign: it is z₁x₂ − x₁z₂",
        );
        // A unit vector is rounded: a few units in the last place of 1.
        let unit = (n.length() - 1.0).abs() < 8.0 * f64::EPSILON;
        assert!(
            square == 1.0 || !unit,
            "{what}: this normal was made unit; AB × AC is asked for, whose length is twice the area",
        );
        assert!(upright(n), "{what}: n is not perpendicular to AB and AC");
        assert!(
            DMat3::from_cols(b - a, c - a, n).determinant() > 0.0,
            "{what}: n points to the back: the cross product changes sign with the order of its factors, and \
             AB comes first",
        );
        assert!(
            n.length_squared() == square,
            "{what}: |n|² is {}, but must be {square} = (twice the area)²",
            n.length_squared(),
        );
    }

    #[test]
    fn slide_triangle() {
        // AB = (10, 0, 5), AC = (3, 2, 5): 0·5 − 5·2, 5·3 − 10·5, 10·2 − 0·3.
        let n = triangle_normal(
            DVec3::ZERO,
            DVec3::new(10.0, 0.0, 5.0),
            DVec3::new(3.0, 2.0, 5.0),
        );
        near(
            "the triangle of the slide",
            n,
            DVec3::new(-10.0, -35.0, 20.0),
            0.0,
        );
    }

    #[test]
    fn any_triangle() {
        let mut inputs = Inputs::new(1);
        for _ in 0..200 {
            let [a, b, c] = [(); 3].map(|()| inputs.whole_vector(-1000, 1000));
            examine(a, b, c);
        }
    }

    #[test]
    fn no_area() {
        let a = DVec3::new(1.0, -2.0, 3.0);
        let side = DVec3::new(2.0, 7.0, -1.0);
        for (b, c) in [
            (a, a),
            (a + side, a),
            (a, a + side),
            (a + side, a + 3.0 * side),
            (a - side, a + side),
        ] {
            examine(a, b, c);
        }
    }

    #[test]
    fn huge_and_tiny() {
        // Sides of 10^±150 have an area that f64 still holds; scaling by a power of ten turns nothing.
        let [a, b, c] = [
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::new(4.0, -1.0, 2.0),
            DVec3::new(0.0, 5.0, 9.0),
        ];
        let n = triangle_normal(a, b, c);
        for scale in [1e150, 1e-150] {
            let scaled = triangle_normal(scale * a, scale * b, scale * c);
            // Three roundings in each coordinate and a cancellation by less than ten.
            assert!(
                parallel(scaled, n, 64.0 * f64::EPSILON),
                "a triangle {scale:e} times as large has the normal {} and must keep the direction of {}",
                show(scaled),
                show(n),
            );
        }
    }
}
