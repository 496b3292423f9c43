//! The ground floor of the course: points, planes, meshes and views that every lecture shares.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/frustum.svg"))]
//!
//! ```
//! use ombra_math::view::{Viewport, look_at, perspective};
//! use ombra_math::{camera::Camera, glam::DVec3, solids};
//!
//! // The vertices of a torus in letters: a near, z far.
//! let torus = solids::torus(3.0, 1.2, 240, 120)?;
//! let view = look_at(DVec3::new(0.0, 7.0, 7.0), DVec3::ZERO, DVec3::Y)?;
//! let camera = Camera {
//!     view_projection: perspective(0.85, 1.6, 5.0, 15.0)? * view,
//!     viewport: Viewport { width: 54, height: 17 },
//! };
//! let mut picture = vec![vec!['.'; 54]; 17];
//! for p in torus.positions.iter().filter_map(|&p| camera.to_pixel(p)) {
//!     let seen = &mut picture[p.y as usize][p.x as usize];
//!     let letter = char::from(b'a' + (26.0 * p.z) as u8);
//!     *seen = if *seen == '.' { letter } else { letter.min(*seen) };
//! }
//! let picture: Vec<String> = picture.iter().map(String::from_iter).collect();
//! assert_eq!(picture, [
//!     "......................................................",
//!     "......................................................",
//!     "......................................................",
//!     "...................vuuuvvvvvvvvuuuv...................",
//!     "...............uttttuuuuuuuuuuuuuuttttu...............",
//!     ".............sssssstttuuuuuuuuuutttssssss.............",
//!     "...........srrrrrrssttuuuvvvvuuuttssrrrrrrs...........",
//!     "..........rqqpppqqrrtuuvvwwwwvvuutrrqqpppqqr..........",
//!     "..........qpoooooopqru..........urqpoooooopq..........",
//!     "..........ponnnnnnnnoo..........oonnnnnnnnop..........",
//!     "..........onnmmmmmmmmmmmmmmmmmmmmmmmmmmmmnno..........",
//!     "..........onmmllllllkkkkkkkkkkkkkkllllllmmno..........",
//!     "...........nmmllkkkkkkkjjjjjjjjkkkkkkkllmmn...........",
//!     "............mmllkkkkjjjjjjjjjjjjjjkkkkllmm............",
//!     ".............nmllkkkjjjjjjjjjjjjjjkkkllmn.............",
//!     "...............mlkkkkjjjjjjjjjjjjkkkklm...............",
//!     "...................llkkkkkkkkkkkkll...................",
//! ]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - Geometry is `f64` on [`glam`]'s types, right-handed, angles in radians; matrices act on column vectors, so that in
//!   `projection * view * p` the view acts first.
//! - A point is homogeneous where a light or a projection asks for it: w = 1 is a place, w = 0 a direction, and −P is the
//!   same point as P ([`homogeneous`]).
//! - The eye looks along −z. Clip space is OpenGL's: −w ≤ x, y, z ≤ w. Divided by w that is NDC, −1 … 1 with y up and
//!   z = −1 at the near plane.
//! - In the picture y runs **down**, pixel (i, j) has its centre at (i + ½, j + ½), and depth is (z_ndc + 1)/2, 0 … 1
//!   ([`view::Viewport`]).
//! - The plane of a, b, c has its normal along AB × AC: a front face is counter-clockwise, seen from outside.
//! - A sign that decides comes from exact arithmetic ([`exact`], [`predicates`]).
//!
//! # Topics
//!
//! | module | what it answers |
//! | --- | --- |
//! | [`homogeneous`] | places, directions, division by w |
//! | [`plane`] | n·X + d = 0, distance, exact side |
//! | [`triangle`] | normal, area, barycentric coordinates |
//! | [`spherical`] | r, θ, φ and solid angles |
//! | [`view`] | look-at, frustum and its limit, orthographic, viewport |
//! | [`camera`] | eye, sight lines and pixels of one matrix |
//! | [`mesh`] | indexed triangles, edges with their faces, vertex normals |
//! | [`solids`] | the lectures' cube, tetrahedron, sphere, torus, teapot |
//! | [`predicates`] | orientation of points, exact at every exponent |
//! | [`exact`] | sums of products without rounding |
//! | [`double_double`] | 106 bits, with error bounds |
//! | [`scaling`] | powers of two against overflow and underflow |
//! | [`work`] | counted work |
//!
//! # The decks
//!
//! *Olomouc* is Světlo a stíny, on light and shadows, of Palacký University in Olomouc. *Bologna* is an Italian lecture,
//! Shadowing, *CIS 781* one in English on shadow volumes, *Grafica 3* the third of Grafica computazionale, an Italian
//! course, and *Croatian 8.4* the section on shadows, 8.4, of a Croatian one. What stands in «…» is the heading of a slide.
//!
//! # Errata
//!
//! Where a slide is wrong, the function says so by its number. [All errata](https://github.com/ombra-rs/ombra/blob/main/notes/src/errata.md),
//! with their proofs, are a chapter of the notes.
//!
//! | | on the slide | right |
//! | --- | --- | --- |
//! | <a id="e6"></a>E6 | Olomouc: tan φ = x/y | y/x, and atan2(y, x), which keeps the quadrant |
//! | <a id="e14"></a>E14 | Olomouc: the mean of normals of different length | each made unit first |
//! | <a id="e30"></a>E30 | Olomouc: θ is the height above the horizon | the angle from the pole: z = r cos θ |
#![doc(html_root_url = "https://docs.rs/ombra-math/latest")]

pub use glam;

pub mod camera;
pub mod double_double;
pub mod exact;
pub mod homogeneous;
pub mod mesh;
pub mod plane;
pub mod predicates;
pub mod scaling;
pub mod solids;
pub mod spherical;
#[cfg(test)]
#[path = "../tests/to_300_bits/mod.rs"]
mod to_300_bits;
pub mod triangle;
pub mod view;
pub mod work;
