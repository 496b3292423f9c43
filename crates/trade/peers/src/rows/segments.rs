//! Random segments drawn into a picture of 1024².

use ombra_math::glam::IVec2;
use ombra_raster::bresenham;

use crate::measured::{Against, Goal, Measured, Shown};
use crate::race::{Race, Rounds, Scene};
use crate::random::SplitMix;

const SIZE: usize = 1024;
const SEGMENTS: usize = 10_000;

type Segment = (IVec2, IVec2);

/// The drawn picture, and the one it should be.
struct Picture<T> {
    pixels: Vec<T>,
    ideal: Vec<T>,
}

impl<T: Copy + Default + PartialEq> Scene for Picture<T> {
    fn clear(&mut self) {
        self.pixels.fill(T::default());
    }

    fn shows(&self) -> Vec<Shown> {
        let unlike = |other: &[T]| {
            self.pixels
                .iter()
                .zip(other)
                .filter(|(a, b)| a != b)
                .count()
        };
        let nothing = vec![T::default(); self.pixels.len()];
        vec![
            Shown {
                name: "lit",
                value: unlike(&nothing) as f64,
                within: Some(1e-2),
            },
            // Every other pixel has the right value, that of the last segment over it.
            Shown {
                name: "not as the ideal",
                value: unlike(&self.ideal) as f64,
                within: None,
            },
        ]
    }
}

/// All peers that are iterators put their pixels alike.
#[inline(always)]
fn put<T>(picture: &mut Picture<T>, x: usize, y: usize, value: T) {
    if let Some(pixel) = picture.pixels.get_mut(y * SIZE + x) {
        *pixel = value;
    }
}

/// `value` of a segment's number: what its pixels are set to.
pub fn row<T>(name: &str, value: fn(u32) -> T, rounds: Rounds) -> Measured
where
    T: Copy + Default + PartialEq + image::Primitive,
{
    let segments = random(0x5e9, SEGMENTS, 0, SIZE as i32);
    let each = || {
        let numbered = segments.iter().enumerate();
        numbered.map(move |(i, &(a, b))| (a, b, value(i as u32 + 1)))
    };
    let (mut places, mut ideal) = (Vec::new(), vec![T::default(); SIZE * SIZE]);
    for (a, b, value) in each() {
        for pixel in nearest(a, b) {
            let place = pixel.y as usize * SIZE + pixel.x as usize;
            if let Some(pixel) = ideal.get_mut(place) {
                *pixel = value;
            }
            places.push(place as u32);
        }
    }
    let (items, one) = (places.len() as f64, value(1));
    let work = format!(
        "{SEGMENTS} random segments, {SIZE}², pixels of {} bits",
        8 * size_of::<T>()
    );
    let picture = Picture {
        pixels: vec![T::default(); SIZE * SIZE],
        ideal,
    };
    let goals = [
        Goal {
            at_least: 1.0,
            against: Against::AnyPeer,
        },
        Goal {
            at_least: 0.9,
            against: Against::Limit,
        },
    ];
    Race::new(name, work, items, "px", picture)
        // No decisions, and yet no bound: runs are written faster than one by one, and places have to be read.
        .limit("stores at known places", |p: &mut Picture<T>| {
            for &place in &places {
                if let Some(pixel) = p.pixels.get_mut(place as usize) {
                    *pixel = one;
                }
            }
        })
        .checked_peer("line_drawing::Bresenham", fault(|a, b, put| line_drawing_bresenham(a, b, put)), |p| {
            for (a, b, value) in each() {
                line_drawing_bresenham(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .checked_peer("line_drawing::Midpoint", fault(|a, b, put| line_drawing_midpoint(a, b, put)), |p| {
            for (a, b, value) in each() {
                line_drawing_midpoint(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .checked_peer("bresenham", fault(|a, b, put| bresenham_crate(a, b, put)), |p| {
            for (a, b, value) in each() {
                bresenham_crate(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .checked_peer("clipline", fault(|a, b, put| clipline(a, b, put)), |p| {
            for (a, b, value) in each() {
                clipline(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .checked_peer("imageproc, iterator", fault(|a, b, put| imageproc_iterator(a, b, put)), |p| {
            for (a, b, value) in each() {
                imageproc_iterator(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .checked_peer("imageproc, drawn", fault(|a, b, put| imageproc_iterator(a, b, put)), |p| {
            let pixels = std::mem::take(&mut p.pixels);
            let side = SIZE as u32;
            let Some(mut image) = image::ImageBuffer::from_raw(side, side, pixels) else {
                return;
            };
            for (a, b, value) in each() {
                let (a, b) = (a.as_vec2().into(), b.as_vec2().into());
                imageproc::drawing::draw_line_segment_mut(&mut image, a, b, image::Luma([value]));
            }
            p.pixels = image.into_raw();
        })
        .ours("draw", &goals, |p| {
            for (a, b, value) in each() {
                bresenham::draw(&mut p.pixels, SIZE, a, b, value);
            }
        })
        .ours("segment", &[], |p| {
            for (a, b, value) in each() {
                ours(a, b, |x, y| put(p, x as usize, y as usize, value));
            }
        })
        .note(match fault(|a, b, put| ours(a, b, put)) {
            None => format!("checked too: every pixel of ours within half a pixel of the line, on {CHECKED} segments"),
            Some(fault) => format!("OURS IS WRONG: {fault}"),
        })
        .run(rounds)
}

fn random(seed: u64, number: usize, low: i32, high: i32) -> Vec<Segment> {
    let mut random = SplitMix(seed);
    let mut point = || IVec2::new(random.integer(low, high), random.integer(low, high));
    (0..number).map(|_| (point(), point())).collect()
}

/// The pixels nearest to the segment by division, those of a tie nearer `a`.
fn nearest(a: IVec2, b: IVec2) -> impl Iterator<Item = IVec2> {
    let d = (b - a).as_i64vec2();
    let run = d.abs().max_element();
    (0..=run).map(move |i| {
        // Half rounds towards a.
        let along = |d: i64| match run {
            0 => 0,
            _ => (2 * d.abs() * i + run - 1).div_euclid(2 * run) * d.signum(),
        };
        a + IVec2::new(along(d.x) as i32, along(d.y) as i32)
    })
}

fn ours(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    bresenham::segment(a, b).for_each(|p| put(p.x, p.y));
}

fn line_drawing_bresenham(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    line_drawing::Bresenham::<i32>::new(a.into(), b.into()).for_each(|(x, y)| put(x, y));
}

fn line_drawing_midpoint(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    let (a, b) = (a.as_vec2(), b.as_vec2());
    line_drawing::Midpoint::<f32, i32>::new(a.into(), b.into()).for_each(|(x, y)| put(x, y));
}

fn bresenham_crate(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    let point = |p: IVec2| (p.x as isize, p.y as isize);
    ::bresenham::Bresenham::new(point(a), point(b)).for_each(|(x, y)| put(x as i32, y as i32));
    // Its segments leave out their end.
    put(b.x, b.y);
}

fn clipline(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    clipline::LineB::<i32>::new(a.x, a.y, b.x, b.y).for_each(|(x, y)| put(x, y));
    // Its segments leave out their end.
    put(b.x, b.y);
}

fn imageproc_iterator(a: IVec2, b: IVec2, mut put: impl FnMut(i32, i32)) {
    let (a, b) = (a.as_vec2(), b.as_vec2());
    imageproc::drawing::BresenhamLineIter::new(a.into(), b.into()).for_each(|(x, y)| put(x, y));
}

const CHECKED: usize = 5000;

/// Whether pixels of random segments lie more than half a pixel off the line, across its longer axis: in integers,
/// 2 |d × (p − a)| > max(|d_x|, |d_y|); or are not one for each step from `a` to `b`.
fn fault(draw: impl Fn(IVec2, IVec2, &mut dyn FnMut(i32, i32))) -> Option<String> {
    let segments = random(0xfa17, CHECKED, -50, 51);
    let (mut off, mut broken) = (0, 0);
    for &(a, b) in &segments {
        let d = b - a;
        let mut pixels = Vec::new();
        draw(a, b, &mut |x, y| pixels.push(IVec2::new(x, y)));
        off += usize::from(
            (pixels.iter()).any(|&p| 2 * d.perp_dot(p - a).abs() > d.abs().max_element()),
        );
        let steps = pixels
            .windows(2)
            .all(|w| matches!(w, [p, q] if (q - p).abs().max_element() == 1));
        let length = 1 + d.abs().max_element() as usize;
        broken += usize::from(!steps || pixels.len() != length);
    }
    let mut found = Vec::new();
    if off > 0 {
        found.push(format!(
            "on {off} of {CHECKED} segments some pixel is more than half a pixel off the line"
        ));
    }
    if broken > 0 {
        found.push(format!(
            "{broken} of {CHECKED} segments have gaps, or too many or too few pixels"
        ));
    }
    (!found.is_empty()).then(|| found.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_found() {
        let right = |a, b, put: &mut dyn FnMut(i32, i32)| nearest(a, b).for_each(|p| put(p.x, p.y));
        assert_eq!(fault(right), None);
        // Cut off where it should be rounded.
        let cut_off = |a: IVec2, b: IVec2, put: &mut dyn FnMut(i32, i32)| {
            let (d, run) = (b - a, (b - a).abs().max_element());
            (0..=run).for_each(|i| put(a.x + d.x * i / run.max(1), a.y + d.y * i / run.max(1)));
        };
        assert!(
            fault(cut_off)
                .is_some_and(|fault| fault.contains("half a pixel") && !fault.contains("gaps"))
        );
        // The end left out.
        let short =
            |a, b, put: &mut dyn FnMut(i32, i32)| nearest(a, b).skip(1).for_each(|p| put(p.x, p.y));
        assert!(
            fault(short)
                .is_some_and(|fault| fault.contains("too few") && !fault.contains("half a pixel"))
        );
    }

    #[test]
    fn a_tie_is_nearer_the_start() {
        let rows = |a, b| nearest(a, b).map(|p| p.y).collect::<Vec<_>>();
        let (a, b) = (IVec2::ZERO, IVec2::new(2, 1));
        assert_eq!(rows(a, b), [0, 0, 1]);
        assert_eq!(rows(b, a), [1, 1, 0]);
    }
}
