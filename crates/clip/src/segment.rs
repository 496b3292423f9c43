//! A segment in the plane, from one end to the other.

use ombra_math::glam::DVec2;

/// The points a + t (b − a), 0 ≤ t ≤ 1.
///
/// # Formula
///
/// ```text
/// x = x_a + t (x_b − x_a)          y = y_a + t (y_b − y_a)          0 ≤ t ≤ 1
/// ```
///
/// # Properties
///
/// It has a direction, which clipping keeps. With a = b it is a single point, and clipped like one.
///
/// # Examples
///
/// ```
/// use ombra_clip::Segment;
/// use ombra_math::glam::DVec2;
///
/// let s = Segment::new(DVec2::ZERO, DVec2::X);
/// assert_eq!(s.reversed().a, DVec2::X);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un segmento».
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Segment {
    /// Where t = 0.
    pub a: DVec2,
    /// Where t = 1.
    pub b: DVec2,
}

impl Segment {
    /// The segment from `a` to `b`.
    #[must_use]
    pub const fn new(a: DVec2, b: DVec2) -> Self {
        Self { a, b }
    }

    /// The same points from b to a.
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self {
            a: self.b,
            b: self.a,
        }
    }

    /// Whether all four coordinates are finite.
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.a.is_finite() && self.b.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degenerate() {
        let (huge, tiny) = (f64::MAX, 5e-324);
        for [ax, ay, bx, by] in [
            [0.0; 4],
            [1.0, 2.0, 1.0, 2.0],
            [-0.0, 0.0, 0.0, -0.0],
            [-huge, huge, huge, -huge],
            [tiny, -tiny, 0.0, tiny],
        ] {
            let s = Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by));
            assert!(s.is_finite());
            let turned = s.reversed();
            assert_eq!((turned.a, turned.b), (s.b, s.a));
            assert_eq!(turned.reversed(), s);
        }
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for k in 0..4 {
                let mut x = [5.0; 4];
                x[k] = bad;
                let s = Segment::new(DVec2::new(x[0], x[1]), DVec2::new(x[2], x[3]));
                assert!(!s.is_finite() && !s.reversed().is_finite(), "{x:?}");
            }
        }
    }
}
