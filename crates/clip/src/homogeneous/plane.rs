//! The six planes of the view volume.

use ombra_math::glam::DVec4;

/// A plane of the view volume.
///
/// # Formula
///
/// ```text
/// left: w + x ≥ 0     below: w + y ≥ 0     near: w + z ≥ 0
/// right: w − x ≥ 0    above: w − y ≥ 0     far: w − z ≥ 0
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum projection matrix» (OpenGL's clip space).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ViewPlane {
    /// x = −w.
    Left,
    /// x = w.
    Right,
    /// y = −w.
    Below,
    /// y = w.
    Above,
    /// z = −w.
    #[doc(alias = "near plane")]
    Near,
    /// z = w.
    #[doc(alias = "far plane")]
    Far,
}

impl ViewPlane {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self::Near,
        Self::Far,
        Self::Left,
        Self::Right,
        Self::Below,
        Self::Above,
    ];

    /// The two numbers whose sum is positive inside: w and ± a coordinate.
    ///
    /// # Properties
    ///
    /// - Error: none: numbers of `p` as they are, or with the other sign.
    #[must_use]
    pub fn terms(self, p: DVec4) -> [f64; 2] {
        match self {
            Self::Left => [p.w, p.x],
            Self::Right => [p.w, -p.x],
            Self::Below => [p.w, p.y],
            Self::Above => [p.w, -p.y],
            Self::Near => [p.w, p.z],
            Self::Far => [p.w, -p.z],
        }
    }

    /// The sum of the terms, rounded; its sign is exact.
    pub(super) fn side(self, p: DVec4) -> f64 {
        let [w, x] = self.terms(p);
        w + x
    }
}
