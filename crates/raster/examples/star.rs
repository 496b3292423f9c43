//! A star under both fill rules, and a segment with Bresenham's decisions, in letters.
//!
//! ```sh
//! cargo run -p ombra-raster --example star          # 36 pixels wide
//! cargo run -p ombra-raster --example star -- 60
//! ```

use std::error::Error;
use std::f64::consts::TAU;

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;
use ombra_raster::buffers::{self, image::Luma};
use ombra_raster::polygon::{FillRule, fill};

fn main() -> Result<(), Box<dyn Error>> {
    let size: u32 = std::env::args().nth(1).map_or(Ok(36), |n| n.parse())?;

    // Every second corner of a pentagon: the edges cross, and the middle is wound twice.
    let middle = DVec2::splat(f64::from(size) / 2.0);
    let corner =
        |i: u32| middle + middle.x * DVec2::from_angle(TAU * (f64::from(2 * i) / 5.0 - 0.25));
    let star: Vec<DVec2> = (0..5).map(corner).collect();

    let [mut even_odd, mut non_zero] = [
        buffers::new(size, size, Luma([b'.']))?,
        buffers::new(size, size, Luma([b'.']))?,
    ];
    let contours = [star];
    buffers::paint(
        &mut even_odd,
        fill(&contours, FillRule::EvenOdd, size, size)?,
        Luma([b'#']),
    )?;
    buffers::paint(
        &mut non_zero,
        fill(&contours, FillRule::NonZero, size, size)?,
        Luma([b'#']),
    )?;
    println!("even-odd, and non-zero: the middle has the winding number 2");
    let columns = size.max(1) as usize;
    for (left, right) in even_odd.chunks(columns).zip(non_zero.chunks(columns)) {
        println!(
            "{}  {}",
            String::from_utf8_lossy(left),
            String::from_utf8_lossy(right)
        );
    }

    println!("\nfrom (0, 0) to (8, 3): where Bresenham stands, his 2d, where he goes");
    for step in bresenham::trace(IVec2::ZERO, IVec2::new(8, 3)) {
        println!(
            "{}  2d = {:3}  {:?}",
            step.pixel, step.decision, step.choice
        );
    }
    Ok(())
}
