use ombra_math::glam::{DVec3, DVec4};
use ombra_math::work::Work;

use super::*;
use crate::pair::{Pair, compare};

mod any;
mod checks;
mod many;
mod orders;
mod parts;
mod rings;
mod scenes;

const ABOVE: DVec4 = DVec4::new(0.0, 0.0, 1.0, 0.0);

fn numbers(pieces: &[(usize, Polygon)]) -> Vec<usize> {
    pieces.iter().map(|(source, _)| *source).collect()
}
