//! The clipping lecture: what of a point, a segment or a polygon lies inside a window.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/polygon-cases.svg"))]
//!
//! ```
//! use ombra_clip::{Window, pieces};
//! use ombra_math::glam::DVec2;
//! use ombra_raster::polygon::{FillRule, fill};
//!
//! // A comb in a window that holds only the ends of its teeth: four polygons remain,
//! // and no bridge between them.
//! let comb = [(1, 9), (20, 9), (20, 1), (16, 7), (13, 1), (10, 7), (7, 1), (4, 7), (1, 1)];
//! let comb = comb.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
//! let window = Window::new(DVec2::new(0.0, 0.0), DVec2::new(21.0, 5.0))?;
//! let mut picture = vec![vec!['.'; 21]; 6];
//! for (piece, name) in pieces::clip_polygon(&window, &comb).into_iter().zip('a'..) {
//!     for span in fill(&[piece], FillRule::NonZero, 21, 6).unwrap() {
//!         picture[span.y as usize][span.x.start as usize..span.x.end as usize].fill(name);
//!     }
//! }
//! let picture: Vec<String> = picture.iter().map(String::from_iter).collect();
//! assert_eq!(picture, [
//!     ".....................",
//!     ".....................",
//!     ".d....cc....bb.....a.",
//!     ".d....cc....bb....aa.",
//!     ".dd..cccc..bbbb...aa.",
//!     ".....................",
//! ]);
//! # Ok::<(), ombra_clip::WindowError>(())
//! ```
//!
//! Segments against a window of letters, with the steps of Cohen–Sutherland: `cargo run -p ombra-clip --example fan`.
//!
//! # Conventions
//!
//! - x runs to the right and y **up**; a window is an upright rectangle, and its border is inside.
//! - What decides (inside or outside, which side is met first, whether anything remains) is exact; new points are the
//!   doubles nearest to the true ones ([`crossing`]), so that results lie in the window exactly and clipping twice changes
//!   nothing.
//! - A clipped segment keeps its direction. What is not finite is nowhere: `None`.
//! - The view volume is OpenGL's, −w ≤ x, y, z ≤ w, and is clipped before the division by w: w > 0 is in front of the eye,
//!   w = 0 a direction.
//! - The same question has the same signature, so that answers can be exchanged: `direct::clip_segment`,
//!   `cohen_sutherland::clip_segment`, `liang_barsky::clip_segment`.
//!
//! # Topics
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`window`] | a point in the window: four inequalities |
//! | [`segment`] | a segment and its parametric equation |
//! | [`crossing`] | where a segment crosses a side |
//! | [`direct`] | segment: intersections with all four sides |
//! | [`cohen_sutherland`] | segment: four bits for each end, and the trace of the iterations |
//! | [`liang_barsky`] | segment: entries and exits (beyond the lecture) |
//! | [`cyrus_beck`] | segment: any convex polygon or polyhedron |
//! | [`box3`] | segment in space: a box, six bits |
//! | [`homogeneous`] | segment and polygon in space: the view volume, before the division by w |
//! | [`sutherland_hodgman`] | polygon: one line or plane after another |
//! | [`pieces`] | polygon: separate parts of a concave one |
//!
//! # Counted work
//!
//! Each function of a module `counted` gives the same answer as the one of its name and counts what it does for it,
//! there where it does it; so do the slides' own forms, `…_plain`, and a book's in plain doubles, `textbook`:
//!
//! | counter | one for each |
//! | --- | --- |
//! | comparisons | number that is held against another to decide: a coordinate against a side (four for a code or for "in the window"), n·p against 0, the parameter of one crossing against another's |
//! | multiplications | product in such a decision: two for n·p in the plane, three in space, four for a homogeneous point; two for parameters, compared as fractions |
//! | divisions | crossing that is computed, however many coordinates it has |
//! | vertices | vertex of a polygon that is looked at; one that goes on to another side is looked at again |
//!
//! A decision counts once, also where rounding leaves doubt and it is made again exactly, and a crossing is a division,
//! however it is rounded: what exactness costs is time. Not counted are tests that numbers are finite and that a vertex
//! repeats another.
//!
//! # The decks
//!
//! *Grafica 3* is the third lecture of Grafica computazionale, an Italian course: rasterization, clipping, hidden
//! surfaces, sampling. *CIS 781* is a lecture in English on shadow volumes, and *Croatian 8.4* the section on
//! shadows, 8.4, of a Croatian one. What stands in «…» is the heading of a slide.
//!
//! # Errata
//!
//! Where a slide is wrong, the function says so by its number. [All errata](https://github.com/ombra-rs/ombra/blob/main/notes/src/errata.md),
//! with their proofs, are a chapter of the notes.
//!
//! | | on the slide | right |
//! | --- | --- | --- |
//! | <a id="e22"></a>E22 | each iteration of Cohen–Sutherland tests whether OR is 0 | and whether AND is not: the rest may lie wholly beyond one side |
#![doc(html_root_url = "https://docs.rs/ombra-clip/latest")]

pub mod box3;
pub mod cohen_sutherland;
pub mod crossing;
pub mod cyrus_beck;
pub mod direct;
#[cfg(test)]
mod extremes;
pub mod homogeneous;
mod interval;
mod lanes;
pub mod liang_barsky;
#[cfg(test)]
mod oracle;
mod outline;
pub mod pieces;
pub mod segment;
pub mod sutherland_hodgman;
pub mod window;

pub use segment::Segment;
pub use window::{CornersError, Window, WindowError};
