//! Planar shadows: the point where the ray from a light through a vertex meets a plane.
//!
//! One formula serves every plane and every light, at a place or at infinity. It exists as a matrix, as a quotient
//! and as a parameter along the ray; they differ in cost and in the digits they lose ([`cast`] loses none). A
//! shadow is only true where the vertex lies between the light and the plane: the matrix does not know that,
//! [`cast`] and [`cast_polygon`] do.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/planar-similar-triangles.svg"))]
//!
//! # Where digits are lost
//!
//! ```text
//! P = (s V − t L) / (s − L_w t)        s = π·L,  t = n·V + d
//! ```
//!
//! s and t cancel where the light or the vertex is close to the plane, the denominator where the vertex is almost
//! level with the light, the numerator where the shadow lies close to the origin but the vertex does not. In
//! plain doubles ([`cast_by_quotient`], [`cast_by_parameter`], [`shadow_matrix`]) the error is ε times the terms
//! that cancelled. Far from the origin the matrix loses twice as many digits as the quotient: its last column holds
//! products of two large numbers. Move the origin close to the scene first; where that is not enough, use [`cast`].

mod exact_cast;
mod matrix;
mod plain;
mod polygon;

pub use exact_cast::{Placement, cast, cast_counted, classify};
pub use matrix::{
    PlanarShadowError, ground_matrix_directional, ground_matrix_point, shadow_matrix,
};
pub use plain::{
    cast_by_parameter, cast_by_parameter_counted, cast_by_quotient, cast_by_quotient_counted,
};
pub use polygon::{cast_onto, cast_polygon, cast_polygon_each};
