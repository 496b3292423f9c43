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
    (b - a).cross(c - a)
}

fn main() {}
