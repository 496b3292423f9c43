//! The drawing kit of the course and its figures.
//!
//! A figure is a function from a [`style::Style`] and an instructor's own [`input::Inputs`] to a [`drawing::Drawing`]:
//! one display list that SVG, PNG and PDF are written from, so that they agree. The bytes are the same on every run and
//! machine.
//!
//! ```
//! use ombra_figures::course::select;
//! use ombra_figures::input::Inputs;
//! use ombra_figures::style::{Style, Theme};
//! use ombra_figures::{png, svg};
//!
//! let style = Style { theme: Theme::Dark, size: "640x360".parse()?, ..Style::default() };
//! for figure in select(&["shadows/cube-infinity"])? {
//!     let drawing = figure.draw(&style, &Inputs::default())?;
//!     assert!(svg::svg(&drawing)?.starts_with("<svg "));
//!     assert!(png::png(&drawing)?.starts_with(b"\x89PNG"));
//! }
//! # Ok::<(), ombra_figures::error::FigureError>(())
//! ```
//!
//! # From the outside
//!
//! | module | what it is for |
//! | --- | --- |
//! | [`course`] | the list of figures, choosing among them |
//! | [`figure`] | what a figure is |
//! | [`input`] | what it can be given, read from the command line |
//! | [`style`] | size, theme, language, background, text form, caption |
//! | [`object`] | built-in solids and OBJ files, checked |
//! | [`write`](mod@write) | files written whole or not at all |
//! | [`gallery`] | `index.html` |
//! | [`docs`] | the small SVGs committed beside the crates |
//! | [`chart`] | charts for studies |
//!
//! # Drawing a figure
//!
//! Lengths are thousandths of the canvas's shorter side, from the upper left corner, y down. A figure draws on a
//! [`sheet::Sheet`], from the back to the front, in the ink of a [`colour::Role`], and asks for [`sheet::Label`]s,
//! which find their places when it is finished. Its [`words`] stand in its file. Add it to its lecture's list, that
//! [`course::figures`] joins; the tests over all figures then cover it.
//!
//! | module | what it holds |
//! | --- | --- |
//! | [`sheet`] | shapes, fixed text, labels |
//! | [`marks`] | sun, parallel arrows, eye, points, arrows, rays, normals |
//! | [`space`], [`solid`], [`patch`] | the house perspective, axes; solids in it; the receiving plane |
//! | [`section`] | the plane of a section: x to the right, y up |
//! | [`panels`], [`table`], [`matrix`] | steps side by side, short lists in columns, matrices |
//! | [`pixels`] | pixels as cells with their centres |
//! | [`number`] | exact fractions |
//! | [`text`], [`font`] | markup, layout, the embedded typeface |
//! | [`place`] | where labels go |
//! | [`colour`], [`path`], [`drawing`] | roles, outlines, the display list |
//! | [`contour`] | the contour of many triangles |
//! | [`svg`], [`png`], [`pdf`] | writing |
//! | [`words`] | what a word is, and those that several figures share |
//!
//! The figures themselves are free to use in slides: CC0 1.0, as each SVG says. The typeface is DejaVu Sans, under its
//! own licence in `fonts/`.
#![doc(html_root_url = "https://docs.rs/ombra-figures/latest")]

pub mod chart;
mod clip;
pub mod colour;
pub mod contour;
pub mod course;
pub mod docs;
pub mod drawing;
pub mod error;
pub mod figure;
pub mod font;
pub mod gallery;
mod hsr;
pub mod input;
pub mod marks;
mod math;
pub mod matrix;
pub mod number;
pub mod object;
pub mod panels;
pub mod patch;
pub mod path;
pub mod pdf;
pub mod pixels;
pub mod place;
pub mod png;
mod raster;
mod room;
pub mod section;
mod shadows;
pub mod sheet;
pub mod solid;
pub mod space;
pub mod style;
pub mod svg;
pub mod table;
pub mod text;
mod whole;
pub mod words;
pub mod write;
