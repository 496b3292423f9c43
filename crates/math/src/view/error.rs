//! Why a matrix cannot be made, and the checks that say so.

use core::fmt;

use glam::{DMat4, DVec3};

/// Why there is no such view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewError {
    /// A number is NaN or infinite.
    NotFinite {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Eye and target are the same place.
    NoDirection {
        /// That place.
        eye: DVec3,
    },
    /// The up vector is zero or parallel to the direction of view.
    UpAlongView {
        /// The up vector.
        up: DVec3,
    },
    /// Two opposite planes of the view volume coincide.
    NoExtent {
        /// The names of the two.
        what: &'static str,
        /// Their common value.
        value: f64,
    },
    /// A number that must be positive is not.
    NotPositive {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The field of view does not lie between 0 and π.
    FieldOfView {
        /// The angle in radians.
        fov_y: f64,
    },
    /// An entry of the matrix is beyond the largest double.
    TooLarge {
        /// What the entry is made of.
        what: &'static str,
    },
}

impl fmt::Display for ViewError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { what, value } => {
                write!(f, "{what} is {value}; it must be a finite number")
            }
            Self::NoDirection { eye } => {
                write!(f, "eye and target are both {eye}; they must be two places")
            }
            Self::UpAlongView { up } => write!(
                f,
                "up is {up}, zero or parallel to the direction of view; it must point to a side of it"
            ),
            Self::NoExtent { what, value } => {
                write!(f, "{what} are both {value}; they must differ")
            }
            Self::NotPositive { what, value } => {
                write!(f, "{what} is {value}; it must be greater than 0")
            }
            Self::FieldOfView { fov_y } => write!(
                f,
                "the field of view is {fov_y} rad; it must lie between 0 and π (an angle in degrees, perhaps?)"
            ),
            Self::TooLarge { what } => {
                write!(
                    f,
                    "{what} give an entry beyond the largest f64; bring them closer together"
                )
            }
        }
    }
}

impl core::error::Error for ViewError {}

pub(super) fn finite(what: &'static str, value: f64) -> Result<(), ViewError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ViewError::NotFinite { what, value })
    }
}

pub(super) fn positive(what: &'static str, value: f64) -> Result<(), ViewError> {
    finite(what, value)?;
    if value > 0.0 {
        Ok(())
    } else {
        Err(ViewError::NotPositive { what, value })
    }
}

/// `m`, unless an entry is beyond the largest double.
pub(super) fn whole(m: DMat4, what: &'static str) -> Result<DMat4, ViewError> {
    if m.is_finite() {
        Ok(m)
    } else {
        Err(ViewError::TooLarge { what })
    }
}
