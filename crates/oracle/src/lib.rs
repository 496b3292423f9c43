//! Numbers without rounding, and the few operations on points that every oracle needs.
//!
//! The lectures' functions promise exact decisions and nearest doubles. What they are compared with is written the way a
//! slide would write it, in [`Exact`] numbers: no tolerance, no order of operations that matters, and
//! one rounding, at the end, where a double is asked for ([`Exact::nearest`]).
//!
//! ```
//! use ombra_oracle::Exact;
//! use ombra_oracle::vector::{exact, mix, turn};
//!
//! let [a, b] = [[2.0, 14.0], [8.0, -4.0]].map(|p: [f64; 2]| exact(p).unwrap_or_default());
//! // Where the segment from a to b crosses y = 10: (1 − t) a + t b with t = 2/9.
//! let t = (Exact::from(10) - &a[1]).over(&(&b[1] - &a[1])).ok_or("level")?;
//! let p = mix(&(Exact::from(1) - &t), &a, &t, &b);
//! assert_eq!(p.each_ref().map(Exact::nearest), [10.0 / 3.0, 10.0]);
//! // No double is on the line; this number is.
//! assert_eq!(turn(&a, &b, &p), 0);
//! # Ok::<(), &str>(())
//! ```
//!
//! | item | what it is |
//! | --- | --- |
//! | [`Exact`] | a fraction of any size: +, −, ×, quotient, order, sign, nearest double |
//! | [`vector`] | points and vectors of exact numbers: dot and cross product, turn, area |
//! | [`interval`] | where linear functions of t are not negative |

mod exact;
pub mod interval;
pub mod vector;

pub use exact::Exact;
