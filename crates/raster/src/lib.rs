//! The rasterization lecture: which pixels stand for a segment, a polygon, a triangle.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/continuous-to-discrete.svg"))]
//!
//! ```
//! use ombra_math::glam::{DVec2, IVec2};
//! use ombra_raster::{bresenham, buffers, polygon::{FillRule, fill}};
//!
//! let star = [(9.0, 0.0), (14.3, 16.0), (0.5, 6.2), (17.5, 6.2), (3.7, 16.0)];
//! let star = star.map(DVec2::from).to_vec();
//! let mut picture = buffers::new(18, 18, buffers::image::Luma([b'.'])).unwrap();
//! let inside = fill(&[star], FillRule::EvenOdd, 18, 18).unwrap();
//! buffers::paint(&mut picture, inside, buffers::image::Luma([b'#'])).unwrap();
//! for p in bresenham::segment(IVec2::new(0, 16), IVec2::new(17, 17)) {
//!     picture.get_pixel_mut(p.x as u32, p.y as u32).0 = [b'='];
//! }
//! let row = |row| std::str::from_utf8(row).unwrap();
//! let rows: Vec<&str> = picture.chunks(18).map(row).collect();
//! assert_eq!(rows, [
//!     "..................",
//!     "..................",
//!     "........##........",
//!     "........##........",
//!     "........##........",
//!     ".......####.......",
//!     ".######....######.",
//!     "..#####....#####..",
//!     "....##......##....",
//!     ".....#......#.....",
//!     "......#....#......",
//!     ".....###..###.....",
//!     ".....########.....",
//!     ".....##....##.....",
//!     "....##......##....",
//!     "..................",
//!     "=========.........",
//!     ".........=========",
//! ]);
//! ```
//!
//! Larger, under both rules, and with the decisions of a segment: `cargo run -p ombra-raster --example star`.
//!
//! # Conventions
//!
//! - x runs to the right and y **down**; pixel (0, 0) is at the top left.
//! - Pixel (i, j) covers i … i+1 by j … j+1, and its centre is (i + ½, j + ½). Polygons and triangles own the pixels whose
//!   centres are inside; a centre on an edge goes to one side of it, by the top-left rule.
//! - The ends of a **segment** are whole numbers and stand for pixels, as on the slides: there (i, j) is the pixel itself.
//!   So the segment from (0, 0) to (3, 1) runs through the centres (½, ½) and (3½, 1½) of the others.
//! - A segment takes both its ends and, of two pixels equally near, the one nearer to its start.
//!
//! # Topics
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`analytic`] | a segment by y = m x + B |
//! | [`dda`] | a segment by y += m, in `f64` and `f32` |
//! | [`bresenham`] | a segment in integers, its decisions, its part in a window |
//! | [`rectangle`] | outline and filled |
//! | [`polygon`] | outline; filled under even-odd and non-zero, edge table and active edges |
//! | [`triangle`] | edge functions with the top-left rule |
//! | [`triangle_setup`] | the same on a grid of sub-pixels, in integers, with depth |
//! | [`attributes`] | linear and perspective-correct interpolation |
//! | [`span`] | a run of pixels in a row: what filling gives |
//! | [`buffers`] | colour, depth and stencil |
//! | [`depth_format`] | a depth in 16 or 24 bits, floating point, reversed |
//!
//! # The decks
//!
//! *Grafica 3* is the third lecture of Grafica computazionale, an Italian course: rasterization, clipping, hidden
//! surfaces, sampling. *Olomouc* is Světlo a stíny, on light and shadows, of Palacký University in Olomouc. What stands
//! in «…» is the heading of a slide.
//!
//! # Errata
//!
//! Where a slide is wrong, the function says so by its number. [All errata](https://github.com/ombra-rs/ombra/blob/main/notes/src/errata.md),
//! with their proofs, are a chapter of the notes.
//!
//! | | on the slide | right |
//! | --- | --- | --- |
//! | <a id="e15"></a>E15 | d = F(M), which holds a half and has no start value | 2F: from 2dy − dx on, by 2dy after E and by 2dy − 2dx after NE |
#![doc(html_root_url = "https://docs.rs/ombra-raster/latest")]

pub mod analytic;
pub mod attributes;
pub mod bresenham;
pub mod buffers;
pub mod dda;
pub mod depth_format;
mod edge;
mod octant;
pub mod polygon;
pub mod rectangle;
pub mod span;
mod step;
pub mod triangle;
pub mod triangle_setup;

pub use span::Span;
