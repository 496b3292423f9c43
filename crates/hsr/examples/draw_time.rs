//! How long the z-buffer takes: a bumpy sphere of 100 352 triangles, 1024² with colour and 2048² depth only.
//!
//! ```sh
//! RAYON_NUM_THREADS=1 cargo run --release -p ombra-hsr --example draw_time
//! ```

use std::error::Error;
use std::f64::consts::PI;
use std::time::Instant;

use cpu_time::ProcessTime;

use ombra_hsr::z_buffer::{
    Colours, Cull, Depth16, Depth24, Depth32F, DepthBuffer, DepthFormat, Options, ReversedDepth32F,
    draw, draw_depth,
};
use ombra_math::camera::Camera;
use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;
use ombra_math::view::{Viewport, look_at, perspective};
use ombra_raster::buffers::image::Rgba;
use ombra_raster::buffers::{self, ColourBuffer};

/// Quads round and from pole to pole: 224 · 224 · 2 triangles.
const QUADS: u32 = 224;

fn bumpy_sphere() -> Mesh {
    let at = |i: u32, j: u32| {
        let [theta, phi] = [i, j].map(|k| PI * f64::from(k) / f64::from(QUADS));
        let phi = 2.0 * phi;
        let r = 1.0 + 0.05 * (9.0 * theta).sin() * (7.0 * phi).sin();
        r * DVec3::new(
            theta.sin() * phi.cos(),
            theta.cos(),
            theta.sin() * phi.sin(),
        )
    };
    let side = QUADS + 1;
    let positions = (0..side * side).map(|k| at(k / side, k % side)).collect();
    let triangles = (0..QUADS * QUADS)
        .flat_map(|k| {
            let a = k / QUADS * side + k % QUADS;
            let (b, c, d) = (a + 1, a + side + 1, a + side);
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Mesh {
        positions,
        triangles,
    }
}

fn camera(side: u32) -> Result<Camera, Box<dyn Error>> {
    let view = look_at(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, DVec3::Y)?;
    let projection = perspective(0.8, 1.0, 0.1, 100.0)?;
    let viewport = Viewport {
        width: side,
        height: side,
    };
    Ok(Camera {
        view_projection: projection * view,
        viewport,
    })
}

/// The least and the median of each of two times in milliseconds: passed, and spent by the processor.
fn time<E>(runs: usize, mut f: impl FnMut() -> Result<(), E>) -> Result<[[f64; 2]; 2], E> {
    let mut times = [const { Vec::new() }; 2];
    for _ in 0..runs {
        let (start, start_processor) = (Instant::now(), ProcessTime::now());
        f()?;
        times[0].push(start.elapsed().as_secs_f64() * 1e3);
        times[1].push(start_processor.elapsed().as_secs_f64() * 1e3);
    }
    Ok(times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        [times[0], times[times.len() / 2]]
    }))
}

fn report<F: DepthFormat>(mesh: &Mesh, runs: usize) -> Result<(), Box<dyn Error>> {
    let triangles = mesh.triangles.len() as f64;
    let line = |what: &str, times: [[f64; 2]; 2]| {
        print!("{:12} {what:21}", F::NAME);
        for (clock, [least, median]) in ["wall", "processor"].iter().zip(times) {
            let rate = triangles / median / 1e3;
            print!("  {clock}: {least:6.2} ms, median {median:6.2}, {rate:5.1} Mtri/s");
        }
        println!();
    };
    let mut depth: DepthBuffer<F> = DepthBuffer::new(1024, 1024)?;
    let mut picture: ColourBuffer = buffers::new(1024, 1024, Rgba([0; 4]))?;
    let colours: Vec<_> = (0..mesh.triangles.len())
        .map(|i| Rgba([i as u8, (i >> 8) as u8, 128, 255]))
        .collect();
    let (view, colours) = (camera(1024)?, Colours::PerTriangle(&colours));
    let times = time(runs, || {
        depth.clear();
        picture.fill(0);
        draw(
            mesh,
            &view,
            colours,
            Options::default(),
            &mut picture,
            &mut depth,
        )
    })?;
    line("1024² colour + depth", times);
    let mut depth: DepthBuffer<F> = DepthBuffer::new(2048, 2048)?;
    let view = camera(2048)?;
    let times = time(runs, || {
        depth.clear();
        draw_depth(mesh, &view, Cull::Nothing, &mut depth)
    })?;
    line("2048² depth only", times);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let runs: usize = std::env::args()
        .nth(1)
        .and_then(|n| n.parse().ok())
        .unwrap_or(50);
    let mesh = bumpy_sphere();
    report::<Depth32F>(&mesh, runs)?;
    report::<ReversedDepth32F>(&mesh, runs)?;
    report::<Depth24>(&mesh, runs)?;
    report::<Depth16>(&mesh, runs)
}
