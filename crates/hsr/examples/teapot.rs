//! The teapot through the z-buffer: a picture in colours of its normals, and its depths.
//!
//! ```sh
//! cargo run --release -p ombra-hsr --example teapot     # target/teapot.png, target/teapot-depth.png
//! ```

use std::error::Error;
use std::fs::{File, create_dir_all};

use ombra_hsr::z_buffer::{Colours, Depth16, DepthBuffer, Options, draw};
use ombra_math::camera::Camera;
use ombra_math::glam::DVec3;
use ombra_math::mesh::Weighting;
use ombra_math::solids::teapot;
use ombra_math::view::{Viewport, look_at, perspective};
use ombra_raster::buffers::{self, image::Rgb};

const WIDTH: u32 = 800;
const HEIGHT: u32 = 600;

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = teapot(16)?;
    let (eye, target) = (DVec3::new(4.0, 5.0, 9.0), DVec3::new(0.3, 1.5, 0.0));
    let projection = perspective(0.55, f64::from(WIDTH) / f64::from(HEIGHT), 6.0, 16.0)?;
    let camera = Camera {
        view_projection: projection * look_at(eye, target, DVec3::Y)?,
        viewport: Viewport {
            width: WIDTH,
            height: HEIGHT,
        },
    };

    // A colour a vertex: x, y, z of the unit normal from −1 … 1 to 0 … 254.
    let channel = |n: f64| (127.0 * (n + 1.0)).round() as u8;
    let normals = mesh.vertex_normals(Weighting::Angle);
    let colours: Vec<Rgb<u8>> = normals
        .iter()
        .map(|n| Rgb(n.normalize_or_zero().to_array().map(channel)))
        .collect();

    let mut picture = buffers::new(WIDTH, HEIGHT, Rgb([255; 3]))?;
    let mut depth: DepthBuffer<Depth16> = DepthBuffer::new(WIDTH, HEIGHT)?;
    let colours = Colours::PerVertex(&colours);
    draw(
        &mesh,
        &camera,
        colours,
        Options::default(),
        &mut picture,
        &mut depth,
    )?;

    let near_is_white: Vec<u8> = depth
        .image()
        .as_raw()
        .iter()
        .map(|&d| 255 - (d >> 8) as u8)
        .collect();
    create_dir_all("target")?;
    write("target/teapot.png", png::ColorType::Rgb, &picture)?;
    write(
        "target/teapot-depth.png",
        png::ColorType::Grayscale,
        &near_is_white,
    )?;
    println!(
        "target/teapot.png, target/teapot-depth.png: {} triangles",
        mesh.triangles.len()
    );
    Ok(())
}

fn write(path: &str, colour: png::ColorType, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(File::create(path)?, WIDTH, HEIGHT);
    encoder.set_color(colour);
    encoder.write_header()?.write_image_data(bytes)?;
    Ok(())
}
