//! A fan of segments clipped to a window, in letters, and the steps of Cohen–Sutherland for one of them.
//!
//! ```sh
//! cargo run -p ombra-clip --example fan
//! ```

use std::error::Error;
use std::f64::consts::TAU;

use ombra_clip::cohen_sutherland::{clip_segment, trace};
use ombra_clip::{Segment, Window};
use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;

const COLUMNS: i32 = 64;
const ROWS: i32 = 24;

fn main() -> Result<(), Box<dyn Error>> {
    let window = Window::new(DVec2::new(12.0, 5.0), DVec2::new(51.0, 18.0))?;
    let mut picture = vec![vec![' '; COLUMNS as usize]; ROWS as usize];
    let mut draw = |segment: Segment, ink: char| {
        // To the nearest pixels; the picture's rows run down, the window's y runs up.
        let [a, b] = [segment.a, segment.b].map(|p| p.round().as_ivec2());
        for IVec2 { x, y } in bresenham::segment(a, b) {
            if let Some(row) = picture.get_mut((ROWS - 1 - y) as usize)
                && let Some(pixel) = row.get_mut(x as usize)
            {
                *pixel = ink;
            }
        }
    };

    let middle = DVec2::new(24.0, 11.0);
    let rays = (0..16).map(|i| DVec2::from_angle(TAU * (f64::from(i) + 0.3) / 16.0));
    let fan: Vec<Segment> = rays
        .map(|d| Segment {
            a: middle + 4.0 * d,
            b: middle + 38.0 * d,
        })
        .collect();
    for &whole in &fan {
        draw(whole, '·');
    }
    for inside in fan.iter().filter_map(|&whole| clip_segment(&window, whole)) {
        draw(inside, '#');
    }
    for row in &picture {
        println!("{}", String::from_iter(row).trim_end());
    }

    println!("\n{:?} in {:?} … {:?}:", fan[2], window.min, window.max);
    for step in trace(&window, fan[2]) {
        println!(
            "codes {} and {}: {:?}",
            step.codes[0], step.codes[1], step.decision
        );
    }
    Ok(())
}
