//! Planar shadows: the point where the ray from a light through a vertex meets a plane.
//!
//! One formula serves every plane and every light, at a place or at infinity. It exists as a matrix, as a quotient
//! and as a parameter along the ray; they differ in cost and in the digits they lose ([`cast`] loses none). A
//! shadow is only true where the vertex lies between the light and the plane: the matrix does not know that,
//! [`cast`] and [`cast_polygon`] do.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/why.svg"))]
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`light_at_infinity`] | onto the ground, all rays parallel |
//! | [`point_light`] | onto the ground, from a lamp |
//! | [`any_plane`] | onto any plane, under any light: formula and matrix |
//! | [`limits`] | false shadows, polygons, clipping to the receiver |
//! | [`textbook`] | the formulas in doubles, as a book leaves them |
//!
//! # Where digits are lost
//!
//! ```text
//! P = (s V − t L) / (s − L_w t)        s = π·L,  t = n·V + d
//! ```
//!
//! s and t cancel where the light or the vertex is close to the plane, the denominator where the vertex is almost
//! level with the light, the numerator where the shadow lies close to the origin but the vertex does not. In
//! doubles ([`textbook`], [`shadow_matrix`]) the error is ε times the terms
//! that cancelled. Far from the origin the matrix loses twice as many digits as the quotient: its last column holds
//! products of two large numbers. Move the origin close to the scene first; where that is not enough, use [`cast`].
#![doc(alias = "projected shadow")]
#![doc(alias = "planar projected shadow")]

pub mod any_plane;
mod error;
pub mod light_at_infinity;
pub mod limits;
mod placement;
pub mod point_light;
pub mod textbook;

pub use any_plane::{cast, cast_plain, counted, shadow_matrix};
pub use error::PlanarShadowError;
pub use light_at_infinity::ground_matrix_directional;
pub use limits::{cast_onto, cast_polygon, cast_polygon_each};
pub use placement::{Placement, classify};
pub use point_light::ground_matrix_point;
