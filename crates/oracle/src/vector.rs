//! Points and vectors without rounding: plain arrays of exact numbers.

use core::array::from_fn;

use crate::Exact;

/// The coordinates of a point, a vector or an array of doubles (`[f64; N]` or whatever turns into one, such as a `DVec3`);
/// `None` unless all are finite.
///
/// # Examples
///
/// ```
/// use ombra_oracle::vector::exact;
///
/// assert!(exact([0.5, -2.0, 1e-300]).is_some_and(|p| p[1] == -2));
/// assert_eq!(exact([0.5, f64::NAN]), None);
/// ```
#[must_use]
pub fn exact<const N: usize>(p: impl Into<[f64; N]>) -> Option<[Exact; N]> {
    let mut coordinates = from_fn(|_| Exact::ZERO);
    for (coordinate, x) in coordinates.iter_mut().zip(p.into()) {
        *coordinate = Exact::new(x)?;
    }
    Some(coordinates)
}

/// a·b.
#[must_use]
pub fn dot<const N: usize>(a: &[Exact; N], b: &[Exact; N]) -> Exact {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a × b.
#[must_use]
pub fn cross(a: &[Exact; 3], b: &[Exact; 3]) -> [Exact; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// a − b.
#[must_use]
pub fn minus<const N: usize>(a: &[Exact; N], b: &[Exact; N]) -> [Exact; N] {
    from_fn(|k| &a[k] - &b[k])
}

/// s a + t b.
#[must_use]
pub fn mix<const N: usize>(s: &Exact, a: &[Exact; N], t: &Exact, b: &[Exact; N]) -> [Exact; N] {
    from_fn(|k| s * &a[k] + t * &b[k])
}

/// (|a₁|, |a₂|, …).
#[must_use]
pub fn abs<const N: usize>(a: &[Exact; N]) -> [Exact; N] {
    a.each_ref().map(Exact::abs)
}

/// Twice the signed area of the triangle abp: positive if a, b, p turn anticlockwise where y points up, 0 on one line.
#[must_use]
pub fn turn(a: &[Exact; 2], b: &[Exact; 2], p: &[Exact; 2]) -> Exact {
    (&b[0] - &a[0]) * (&p[1] - &a[1]) - (&b[1] - &a[1]) * (&p[0] - &a[0])
}

/// Twice the signed area of a polygon, positive if it turns anticlockwise where y points up.
///
/// # Examples
///
/// ```
/// use ombra_oracle::Exact;
/// use ombra_oracle::vector::doubled_area;
///
/// let half_a_square = [[0, 0], [4, 0], [4, 4]].map(|p| p.map(Exact::from));
/// assert_eq!(doubled_area(&half_a_square), 16);
/// ```
#[must_use]
pub fn doubled_area(polygon: &[[Exact; 2]]) -> Exact {
    let next = polygon.iter().cycle().skip(1);
    (polygon.iter().zip(next))
        .map(|(p, q)| &p[0] * &q[1] - &p[1] * &q[0])
        .sum()
}

#[cfg(test)]
mod tests {
    use super::{abs, cross, dot, doubled_area, minus, mix, turn};
    use crate::Exact;

    fn v<const N: usize>(v: [i32; N]) -> [Exact; N] {
        v.map(Exact::from)
    }

    // Numbers that no two mistakes share: each component another one.
    #[test]
    fn by_hand() {
        let (a, b) = (v([1, -2, 3]), v([4, 5, -7]));
        assert_eq!(dot(&a, &b), 4 - 10 - 21);
        assert_eq!(cross(&a, &b), v([14 - 15, 12 + 7, 5 + 8]));
        assert_eq!(minus(&a, &b), v([-3, -7, 10]));
        assert_eq!(
            mix(&Exact::from(2), &a, &Exact::from(-3), &b),
            v([-10, -19, 27])
        );
        assert_eq!(abs(&b), v([4, 5, 7]));
        assert_eq!(dot::<0>(&[], &[]), 0);
    }

    #[test]
    fn turns_and_areas() {
        let (a, b) = (v([1, 1]), v([5, 3]));
        assert_eq!(turn(&a, &b, &v([1, 2])), 4);
        assert_eq!(turn(&a, &b, &v([2, 1])), -2);
        assert_eq!(turn(&a, &b, &v([-1, 0])), 0);
        let mut square = [v([0, 0]), v([3, 0]), v([3, 2]), v([0, 2])];
        assert_eq!(doubled_area(&square), 12);
        square.reverse();
        assert_eq!(doubled_area(&square), -12);
        assert_eq!(doubled_area(&[]), 0);
        assert_eq!(doubled_area(&square[..2]), 0);
    }
}
