//! The hidden-surfaces lecture: what of a scene an eye sees.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/zbuffer-steps.svg"))]
//!
//! ```
//! use ombra_hsr::z_buffer::{Colours, Depth24, DepthBuffer, Options, draw};
//! use ombra_math::view::{Viewport, look_at, perspective};
//! use ombra_math::{camera::Camera, glam::DVec3, mesh::Weighting, solids};
//! use ombra_raster::buffers::{self, image::Rgb};
//!
//! let mesh = solids::teapot(8)?;
//! let view = look_at(DVec3::new(4.0, 5.0, 9.0), DVec3::Y, DVec3::Y)?;
//! let camera = Camera {
//!     view_projection: perspective(0.7, 4.0 / 3.0, 1.0, 100.0)? * view,
//!     viewport: Viewport { width: 320, height: 240 },
//! };
//! let normals = mesh.vertex_normals(Weighting::Angle);
//! let colour = |n: &DVec3| Rgb((127.0 * (*n + 1.0)).to_array().map(|c| c as u8));
//! let colours: Vec<_> = normals.iter().map(colour).collect();
//! let colours = Colours::PerVertex(&colours);
//! let mut picture = buffers::new(320, 240, Rgb([255; 3]))?;
//! let mut depth = DepthBuffer::<Depth24>::new(320, 240)?;
//! draw(&mesh, &camera, colours, Options::default(), &mut picture, &mut depth)?;
//! let mut file = Vec::new();
//! let mut encoder = png::Encoder::new(&mut file, 320, 240);
//! encoder.set_color(png::ColorType::Rgb);
//! encoder.write_header()?.write_image_data(&picture)?;
//! # assert!(file.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same into a file: `cargo run --release -p ombra-hsr --example teapot`.
//!
//! # Conventions
//!
//! - World and eye are right-handed, matrices act on column vectors, the eye looks along −z.
//! - An eye is homogeneous: w = 1 a place, w = 0 the direction *towards* the viewer of a parallel view.
//! - In the picture y runs **down**, pixel (i, j) has its centre at (i + ½, j + ½), and depth runs from 0 at the near plane
//!   to 1 at the far one: (z_ndc + 1)/2, with z_ndc from −1 to 1 as in OpenGL.
//! - Front faces are counter-clockwise seen from outside, before y is turned.
//! - Which primitive is nearer is decided exactly or to a tolerance that is stated; of equal depths the first stays.
//!
//! # Topics
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`mod@polygon`] | a planar convex polygon in space: the primitive of the lecture |
//! | [`pair`] | two primitives: one hides the other, both are visible, or they cross |
//! | [`object_space`] | the visible parts of every primitive, as polygons |
//! | [`image_space`] | a ray a pixel, the nearest hit wins |
//! | [`painter`] | back to front; what to do when no order exists |
//! | [`z_buffer`] | a depth a pixel, primitives in any order |
//! | [`back_face`] | faces turned away, left out before anything else |
//! | [`picture`] | which primitive is seen at each pixel: what the methods are compared by |
//!
//! # The decks
//!
//! *Grafica 3* is the third lecture of Grafica computazionale, an Italian course: rasterization, clipping, hidden
//! surfaces, sampling. *Olomouc* is Světlo a stíny, on light and shadows, of Palacký University in Olomouc. *CIS 781* is a
//! lecture in English on shadow volumes. What stands in «…» is the heading of a slide.
//!
//! # Errata
//!
//! Where a slide is wrong, the function says so by its number. [All errata](https://github.com/ombra-rs/ombra/blob/main/notes/src/errata.md),
//! with their proofs, are a chapter of the notes.
//!
//! | | on the slide | right |
//! | --- | --- | --- |
//! | <a id="e13"></a>E13 | a face is seen if its normal is under 90° from the direction of view | from the direction *towards* the viewer: n·v > 0 |
//! | <a id="e23"></a>E23 | a ray takes the nearest intersection with a plane | the nearest inside its primitive and in front of the eye |
//! | <a id="e31"></a>E31 | a positive n_z is front-facing | in a parallel view; in perspective n·v, or the area's sign after projection |
#![doc(html_root_url = "https://docs.rs/ombra-hsr/latest")]

pub mod back_face;
pub mod image_space;
pub mod object_space;
pub mod painter;
pub mod pair;
pub mod picture;
pub mod polygon;
pub mod z_buffer;

pub use polygon::Polygon;
