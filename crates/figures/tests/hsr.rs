//! The figures of the hidden surfaces lecture show what the lecture says.

#![allow(clippy::unwrap_used, clippy::panic)]
