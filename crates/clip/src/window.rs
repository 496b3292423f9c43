//! The clipping window: an upright rectangle, and the four inequalities of a point inside it.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/point-window.svg"))]
#![doc(alias = "viewport clipping")]

use core::fmt;

use ombra_math::glam::DVec2;

/// The rectangle x_min ≤ x ≤ x_max, y_min ≤ y ≤ y_max, with y upwards.
///
/// # Properties
///
/// The border belongs to it. It may be a segment or a single point (min = max in one axis or both). Fields are
/// public; a window written by hand with min above max, or with NaN, contains no point, and nothing is left of
/// what is clipped against it.
///
/// # Examples
///
/// ```
/// use ombra_clip::Window;
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// assert!(window.contains(DVec2::new(0.0, 10.0)));
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The corner on the left, below.
    pub min: DVec2,
    /// The corner on the right, above.
    pub max: DVec2,
}

/// Why two corners are no window.
pub type WindowError = CornersError<DVec2>;

/// Why two corners are no window in the plane, no box in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CornersError<V> {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The corner with that coordinate.
        corner: V,
    },
    /// A coordinate of the first corner exceeds the second's.
    Swapped {
        /// The corner given as the one with the least coordinates.
        min: V,
        /// The corner given as the one with the greatest.
        max: V,
    },
}

impl<V: fmt::Display> fmt::Display for CornersError<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { corner: p } => {
                write!(f, "corner {p}: each coordinate must be a finite number")
            }
            Self::Swapped { min, max } => {
                write!(f, "corners from {min} to {max}: ")?;
                f.write_str("no coordinate of the first may exceed the second's")
            }
        }
    }
}

impl<V: fmt::Debug + fmt::Display> core::error::Error for CornersError<V> {}

/// A side of a window, in the order of the lecture's bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// y = y_max.
    Above,
    /// y = y_min.
    Below,
    /// x = x_max.
    Right,
    /// x = x_min.
    Left,
}

impl Side {
    /// All four: bit 1 to bit 4.
    pub const ALL: [Self; 4] = [Self::Above, Self::Below, Self::Right, Self::Left];
}

impl Window {
    /// The window with the corners `min` (left, below) and `max` (right, above).
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, or a `min` that exceeds `max` in x or y. Equal ones are allowed.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_clip::Window;
    /// use ombra_math::glam::DVec2;
    ///
    /// let error = Window::new(DVec2::splat(10.0), DVec2::ZERO).unwrap_err();
    /// assert!(error.to_string().contains("from [10, 10] to [0, 0]"));
    /// ```
    pub fn new(min: DVec2, max: DVec2) -> Result<Self, WindowError> {
        match [min, max].into_iter().find(|p| !p.is_finite()) {
            Some(corner) => Err(WindowError::NotFinite { corner }),
            None if min.cmple(max).all() => Ok(Self { min, max }),
            None => Err(WindowError::Swapped { min, max }),
        }
    }

    /// Whether `p` lies in the window.
    ///
    /// # Formula
    ///
    /// ```text
    /// x_min ≤ x ≤ x_max          y_min ≤ y ≤ y_max
    /// ```
    ///
    /// # Properties
    ///
    /// The border is inside. A point with a NaN is not.
    ///
    /// # Pitfalls
    ///
    /// Asking whether p is *outside* (x < x_min or …) and turning the answer round lets NaN in.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_clip::Window;
    /// use ombra_math::glam::DVec2;
    ///
    /// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
    /// assert!(window.contains(DVec2::new(0.0, 10.0)));
    /// assert!(!window.contains(DVec2::new(10.000001, 5.0)));
    /// assert!(!window.contains(DVec2::new(f64::NAN, 5.0)));
    /// # Ok::<(), ombra_clip::WindowError>(())
    /// ```
    ///
    /// # References
    ///
    /// Grafica 3, «Clipping», Clipping di un punto.
    #[inline]
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// Whether no point lies in the window: min above max, or NaN. Never so for one made by [`Window::new`].
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !(self.min.x <= self.max.x && self.min.y <= self.max.y)
    }

    /// Whether points lie strictly inside.
    pub(crate) fn has_area(&self) -> bool {
        self.min.x < self.max.x && self.min.y < self.max.y
    }

    /// The four corners, counter-clockwise from `min`.
    ///
    /// # Properties
    ///
    /// - Error: none: coordinates of `min` and `max` as they are.
    #[must_use]
    pub const fn corners(&self) -> [DVec2; 4] {
        [
            self.min,
            DVec2::new(self.max.x, self.min.y),
            self.max,
            DVec2::new(self.min.x, self.max.y),
        ]
    }

    /// The line of a side, at 0 rather than −0.
    #[inline]
    pub(crate) const fn line(&self, side: Side) -> Line {
        match side {
            Side::Above => Line::Horizontal(self.max.y + 0.0),
            Side::Below => Line::Horizontal(self.min.y + 0.0),
            Side::Right => Line::Vertical(self.max.x + 0.0),
            Side::Left => Line::Vertical(self.min.x + 0.0),
        }
    }

    /// Whether `p` lies strictly beyond a side.
    #[inline]
    pub(crate) fn is_beyond(&self, side: Side, p: DVec2) -> bool {
        match side {
            Side::Above => p.y > self.max.y,
            Side::Below => p.y < self.min.y,
            Side::Right => p.x > self.max.x,
            Side::Left => p.x < self.min.x,
        }
    }
}

/// An upright or level line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Line {
    /// x = c.
    Vertical(f64),
    /// y = c.
    Horizontal(f64),
}

impl Line {
    /// Where it is: c.
    #[inline]
    pub(crate) const fn place(self) -> f64 {
        match self {
            Self::Vertical(c) | Self::Horizontal(c) => c,
        }
    }

    #[inline]
    pub(crate) const fn is_vertical(self) -> bool {
        matches!(self, Self::Vertical(_))
    }

    /// The coordinates of two points across it, and those along it.
    #[inline]
    pub(crate) const fn turn(self, a: DVec2, b: DVec2) -> [[f64; 2]; 2] {
        match self {
            Self::Vertical(_) => [[a.x, b.x], [a.y, b.y]],
            Self::Horizontal(_) => [[a.y, b.y], [a.x, b.x]],
        }
    }

    /// Its point at a coordinate along it.
    #[inline]
    pub(crate) const fn point(self, along: f64) -> DVec2 {
        match self {
            Self::Vertical(x) => DVec2::new(x, along),
            Self::Horizontal(y) => DVec2::new(along, y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lecture() -> Window {
        Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
    }

    #[test]
    fn the_lectures_points() {
        assert!(lecture().contains(DVec2::new(0.0, 10.0)));
        assert!(!lecture().contains(DVec2::new(10.000001, 5.0)));
        assert!(!lecture().contains(DVec2::new(f64::NAN, 5.0)));
    }

    #[test]
    fn every_inequality_counts() {
        for (x, y) in [(5.0, 0.0), (10.0, 5.0), (5.0, 10.0), (0.0, 5.0)] {
            let border = DVec2::new(x, y);
            assert!(lecture().contains(border), "{border}");
            // One double further from the middle.
            let away = |c: f64| match c {
                0.0 => -f64::from_bits(1),
                5.0 => c,
                _ => c.next_up(),
            };
            let outside = DVec2::new(away(x), away(y));
            assert!(!lecture().contains(outside), "{outside}");
        }
    }

    #[test]
    fn degenerate() {
        let v = DVec2::new;
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for corner in [v(bad, 0.0), v(0.0, bad)] {
                let error = Window::new(corner, v(1.0, 1.0)).unwrap_err();
                assert!(matches!(error, WindowError::NotFinite { .. }), "{error}");
                assert!(error.to_string().contains("finite"), "{error}");
                assert!(Window::new(v(-1.0, -1.0), corner).is_err());
                assert!(!lecture().contains(corner));
            }
        }
        for (min, max) in [(v(1.0, 0.0), v(0.0, 1.0)), (v(0.0, 1.0), v(1.0, 0.0))] {
            assert_eq!(
                Window::new(min, max),
                Err(WindowError::Swapped { min, max })
            );
        }
        let point = Window::new(v(3.0, 4.0), v(3.0, 4.0)).unwrap();
        assert!(point.contains(v(3.0, 4.0)) && !point.contains(v(3.0, 4.0_f64.next_up())));
        let whole = Window::new(DVec2::splat(-f64::MAX), DVec2::splat(f64::MAX)).unwrap();
        assert!(whole.contains(v(f64::MAX, -f64::MAX)) && !whole.contains(v(f64::INFINITY, 0.0)));
        assert!(lecture().contains(v(-0.0, -0.0)));
        let by_hand = Window {
            min: v(1.0, 1.0),
            max: v(0.0, 0.0),
        };
        assert!(by_hand.corners().iter().all(|&c| !by_hand.contains(c)));
    }
}
