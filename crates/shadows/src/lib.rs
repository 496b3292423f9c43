//! The shadows lecture: where light does not reach, and what it costs to know.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/why.svg"))]
//!
//! ```
//! use ombra_math::{glam::{DVec2, DVec3, DVec4}, plane::Plane, solids};
//! use ombra_raster::polygon::{FillRule, fill};
//! use ombra_shadows::planar::cast_polygon;
//!
//! // A cube over the ground and a lamp above it, seen from above: o the cube, # what of its
//! // shadow it does not cover.
//! let cube = solids::cuboid(DVec3::new(10.0, 1.0, 4.0), DVec3::new(14.0, 6.0, 8.0))?;
//! let lamp = DVec4::new(6.0, 10.0, 6.0, 1.0);
//! let mut picture = vec![vec!['.'; 28]; 12];
//! let faces = |ink| (0..12).filter_map(|i| cube.triangle(i)).map(move |face| (ink, face));
//! for (ink, face) in faces('#').chain(faces('o')) {
//!     let itself = || face.iter().map(|v| v.extend(1.0)).collect();
//!     let shadow = || cast_polygon(Plane::GROUND, lamp, &face);
//!     let shape: Vec<DVec4> = if ink == 'o' { itself() } else { shadow() };
//!     let above = shape.iter().map(|p| DVec2::new(p.x, p.z) / p.w).collect();
//!     for span in fill(&[above], FillRule::NonZero, 28, 12).unwrap() {
//!         picture[span.y as usize][span.x.start as usize..span.x.end as usize].fill(ink);
//!     }
//! }
//! let picture: Vec<String> = picture.iter().map(String::from_iter).collect();
//! assert_eq!(picture, [
//!     "............................",
//!     "...............###########..",
//!     ".............#############..",
//!     "...........###############..",
//!     "..........oooo############..",
//!     "..........oooo############..",
//!     "..........oooo############..",
//!     "..........oooo############..",
//!     "...........###############..",
//!     ".............#############..",
//!     "...............###########..",
//!     "............................",
//! ]);
//! # Ok::<(), ombra_math::solids::SolidError>(())
//! ```
//!
//! With your own lamp: `cargo run -p ombra-shadows --example lamp -- 6 10 6 1`.
//!
//! # Conventions
//!
//! - Right-handed, y up, the ground is y = 0; matrices act on column vectors.
//! - A light is homogeneous: w = 1 a place, w = 0 a direction *towards* the light, and a negative w the same place as with
//!   all signs turned. The zero vector is no light.
//! - A plane is n·X + d = 0 and casts shadows on either side; a light in the plane lights nothing.
//! - A shadow is true only where the vertex lies between the light and the plane. [`planar::cast`] asks, a matrix does not.
//!
//! # Topics
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`planar`] | the shadow on a plane: matrix, per point, polygon, clipped to its receiver |
//! | [`fake`] | an ellipse instead of a shadow |
//!
//! # The decks
//!
//! *Olomouc* is Světlo a stíny, on light and shadows, of Palacký University in Olomouc. *Bologna* is an Italian lecture,
//! Shadowing: planar shadows, shadow buffers, soft shadows. *Croatian 8.4* is the section on shadows, 8.4, of a Croatian
//! course: all methods. What stands in «…» is the heading of a slide.
//!
//! # Errata
//!
//! Where a slide is wrong, the function says so by its number. [All errata](https://github.com/ombra-rs/ombra/blob/main/notes/src/errata.md),
//! with their proofs, are a chapter of the notes.
//!
//! | | on the slide | right |
//! | --- | --- | --- |
//! | <a id="e1"></a>E1 | Bologna: the matrix with the rows a·L, b·L, c·L, d·L | its transpose, M = (π·L) I − L πᵀ |
//! | <a id="e2"></a>E2 | Olomouc: row 3, column 2 repeats L_z, and rows are multiplied | −L_y n_z; the deck's other matrices multiply columns |
//! | <a id="e3"></a>E3 | Olomouc: the answer for the lamp at (0, 100, 100) is that of the direction (0, 1, 1) | (0, −25), (25/2, −25), …: a lamp spreads its rays |
//! | <a id="e4"></a>E4 | Olomouc: the last row of the shadows is 0 | 1: they are places |
//! | <a id="e21"></a>E21 | Olomouc: the fourth coordinate is y_P − y_L, negative for every true shadow | y_L − y_P: what is clipped to w > 0 remains |
#![doc(html_root_url = "https://docs.rs/ombra-shadows/latest")]

pub mod fake;
pub mod planar;
