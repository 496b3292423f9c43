//! Polygons of 1000 vertices filled in a picture of 2048², pixels in or out, no coverage between.

use std::f64::consts::TAU;

use image::{ImageBuffer, Luma, Pixel, Rgba};
use ombra_math::glam::DVec2;
use ombra_raster::buffers::paint;
use ombra_raster::polygon::{self, FillRule};
use tiny_skia::{IntSize, Mask, Paint, Path, PathBuilder, Pixmap, Transform};

use crate::measured::{Against, Goal, Measured, Shown};
use crate::race::{Race, Rounds, Scene};
use crate::random::SplitMix;

const SIZE: u32 = 2048;
const VERTICES: usize = 1000;
const COLOUR: [u8; 4] = [200, 100, 50, 255];

pub struct Polygon {
    name: &'static str,
    points: Vec<DVec2>,
    /// Times the fastest correct peer.
    at_least: f64,
}

pub fn smooth() -> Polygon {
    Polygon {
        name: "smooth 1000-gon",
        points: around(|_| 1000.3),
        at_least: 1.2,
    }
}

pub fn star() -> Polygon {
    Polygon {
        name: "star of 1000 vertices",
        points: around(|i| if i % 2 == 0 { 1000.3 } else { 400.7 }),
        at_least: 1.5,
    }
}

pub fn crossing() -> Polygon {
    let mut random = SplitMix(0xf111);
    let mut coordinate = || random.real(4.0, 2044.0);
    Polygon {
        name: "self-crossing, 1000 random vertices",
        points: (0..VERTICES)
            .map(|_| representable(DVec2::new(coordinate(), coordinate())))
            .collect(),
        at_least: 1.5,
    }
}

fn around(radius: impl Fn(usize) -> f64) -> Vec<DVec2> {
    (0..VERTICES)
        .map(|i| {
            let angle = TAU * i as f64 / VERTICES as f64;
            representable(DVec2::splat(1024.0) + radius(i) * DVec2::from_angle(angle))
        })
        .collect()
}

/// Coordinates that f32 has too: every contestant gets the same polygon.
fn representable(p: DVec2) -> DVec2 {
    p.as_vec2().as_dvec2()
}

/// The samples of the picture, lent to each contestant in its own wrapping.
struct Picture {
    samples: Vec<u8>,
    channels: usize,
    /// For each pixel: whether the plain form of the fill has it.
    ideal: Vec<bool>,
}

impl Scene for Picture {
    fn clear(&mut self) {
        self.samples.fill(0);
    }

    fn shows(&self) -> Vec<Shown> {
        // The last sample is opacity, or the mask itself.
        let lit = || {
            let pixels = self.samples.chunks_exact(self.channels);
            pixels.map(|pixel| pixel.last().is_some_and(|&sample| sample > 0))
        };
        let unlike = lit().zip(&self.ideal).filter(|(a, b)| a != *b).count();
        vec![
            Shown {
                name: "lit",
                value: lit().filter(|&lit| lit).count() as f64,
                within: Some(1e-2),
            },
            Shown {
                name: "unlike fill_plain",
                value: unlike as f64,
                within: None,
            },
        ]
    }
}

pub fn rgba(name: &str, polygon: Polygon, rounds: Rounds) -> Measured {
    let path = path(&polygon.points);
    let mut colour = Paint::default();
    let [r, g, b, a] = COLOUR;
    colour.set_color_rgba8(r, g, b, a);
    colour.anti_alias = false;
    row(name, "RGBA", &polygon, Rgba(COLOUR), rounds, |picture| {
        let samples = std::mem::take(&mut picture.samples);
        let size = IntSize::from_wh(SIZE, SIZE);
        let pixmap = size.and_then(|size| Pixmap::from_vec(samples, size));
        if let (Some(mut pixmap), Some(path)) = (pixmap, &path) {
            let rule = tiny_skia::FillRule::EvenOdd;
            pixmap.fill_path(path, &colour, rule, Transform::identity(), None);
            picture.samples = pixmap.take();
        }
    })
}

pub fn mask(name: &str, polygon: Polygon, rounds: Rounds) -> Measured {
    let path = path(&polygon.points);
    row(name, "mask", &polygon, Luma([255]), rounds, |picture| {
        let samples = std::mem::take(&mut picture.samples);
        let size = IntSize::from_wh(SIZE, SIZE);
        let mask = size.and_then(|size| Mask::from_vec(samples, size));
        if let (Some(mut mask), Some(path)) = (mask, &path) {
            let rule = tiny_skia::FillRule::EvenOdd;
            mask.fill_path(path, rule, false, Transform::identity());
            picture.samples = mask.take();
        }
    })
}

fn path(points: &[DVec2]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (i, p) in points.iter().map(|p| p.as_vec2()).enumerate() {
        match i {
            0 => builder.move_to(p.x, p.y),
            _ => builder.line_to(p.x, p.y),
        }
    }
    builder.close();
    builder.finish()
}

fn row<P: Pixel<Subpixel = u8>>(
    name: &str,
    format: &str,
    polygon: &Polygon,
    pixel: P,
    rounds: Rounds,
    tiny_skia: impl FnMut(&mut Picture),
) -> Measured {
    let contours = vec![polygon.points.clone()];
    let rule = FillRule::EvenOdd;
    let mut ideal = vec![false; (SIZE * SIZE) as usize];
    // Contours that are not finite have no pixels.
    let _ = polygon::fill_plain(&contours, rule, SIZE, SIZE, &mut (), |span| {
        let row = (span.y * SIZE) as usize;
        if let Some(run) = ideal.get_mut(row + span.x.start as usize..row + span.x.end as usize) {
            run.fill(true);
        }
    });
    let lit = ideal.iter().filter(|&&lit| lit).count();
    let channels = usize::from(P::CHANNEL_COUNT);
    let picture = Picture {
        samples: vec![0; (SIZE * SIZE) as usize * channels],
        channels,
        ideal,
    };
    let work = format!(
        "{}, even-odd, {SIZE}², {format}, no anti-aliasing",
        polygon.name
    );
    let goal = Goal {
        at_least: polygon.at_least,
        against: Against::FastestPeer,
    };
    Race::new(name, work, lit as f64, "px", picture)
        .limit("memset of as many pixels", |picture: &mut Picture| {
            if let Some(samples) = picture.samples.get_mut(..lit * channels) {
                samples.fill(255);
            }
        })
        .peer("tiny-skia", tiny_skia)
        .ours("fill", &[goal], |picture| {
            let samples = std::mem::take(&mut picture.samples);
            let Some(mut image) = ImageBuffer::<P, _>::from_raw(SIZE, SIZE, samples) else {
                return;
            };
            // A failure shows itself: nothing is lit.
            if let Ok(spans) = polygon::fill(&contours, rule, SIZE, SIZE) {
                let _ = paint(&mut image, spans, pixel);
            }
            picture.samples = image.into_raw();
        })
        .run(rounds)
}
