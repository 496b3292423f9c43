//! The shadow of a block on the ground, seen from above, in letters: `o` the block, `#` its shadow.
//!
//! ```sh
//! cargo run -p ombra-shadows --example lamp                 # a lamp at (20, 14, 8)
//! cargo run -p ombra-shadows --example lamp -- 1 1 0.5 0    # the sun, towards (1, 1, ½)
//! ```

use std::error::Error;

use ombra_clip::sutherland_hodgman::clip_homogeneous;
use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::solids::cuboid;
use ombra_raster::polygon::{FillRule, fill};
use ombra_shadows::planar::{cast, cast_polygon};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 26;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<f64> = std::env::args()
        .skip(1)
        .map(|n| n.parse())
        .collect::<Result<_, _>>()?;
    let light = <[f64; 4]>::try_from(given).unwrap_or([20.0, 14.0, 8.0, 1.0]);
    let light = DVec4::from_array(light);
    let block = cuboid(DVec3::new(26.0, 3.0, 10.0), DVec3::new(34.0, 9.0, 15.0))?;

    let mut picture = vec![vec!['.'; WIDTH as usize]; HEIGHT as usize];
    let mut paint = |outline: &[DVec2], ink: char| -> Result<(), Box<dyn Error>> {
        for span in fill(&[outline.to_vec()], FillRule::NonZero, WIDTH, HEIGHT)? {
            picture[span.y as usize][span.x.start as usize..span.x.end as usize].fill(ink);
        }
        Ok(())
    };
    let faces = || (0..block.triangles.len()).filter_map(|i| block.triangle(i));
    for face in faces() {
        // A shadow may reach to infinity: cut to the picture, −w ≤ … and so on, before the division by w.
        let mut shadow = cast_polygon(Plane::GROUND, light, &face);
        let (right, far) = (f64::from(WIDTH), f64::from(HEIGHT));
        for side in [
            DVec4::X,
            DVec4::new(-1.0, 0.0, 0.0, right),
            DVec4::Z,
            DVec4::new(0.0, 0.0, -1.0, far),
        ] {
            shadow = clip_homogeneous(&shadow, side);
        }
        let seen: Vec<DVec2> = shadow.iter().map(|p| DVec2::new(p.x, p.z) / p.w).collect();
        paint(&seen, '#')?;
    }
    for face in faces() {
        paint(&face.map(|v| DVec2::new(v.x, v.z)), 'o')?;
    }
    for row in &picture {
        println!("{}", String::from_iter(row));
    }

    println!("\nvertex → its shadow under the light {light}");
    for &v in &block.positions {
        match cast(Plane::GROUND, light, v) {
            Some(p) => println!("{v} → {p}"),
            None => println!("{v} casts none"),
        }
    }
    Ok(())
}
