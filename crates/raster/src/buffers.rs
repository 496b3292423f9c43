//! Pixel buffers: colour, depth and stencil, each an [`image::ImageBuffer`].
//!
//! A pixel is a sample, not a little square: a buffer is a table of values at the centres (i + ½, j + ½), row 0
//! at the top. It is made by [`new`], which checks the size before it allocates, and spans are written into it as
//! runs by [`paint`]. A [`DepthBuffer`] also knows how its depths are stored, one of the
//! [formats](crate::depth_format).

mod depth;

use core::fmt;

use image::{ImageBuffer, Luma, Pixel, Rgb, Rgba};

use crate::span::Span;

pub use crate::depth_format::U24;
pub use depth::DepthBuffer;
pub use image;

/// A picture of pixels `P`.
pub type Picture<P> = ImageBuffer<P, Vec<<P as Pixel>::Subpixel>>;
/// Colours as they are stored, 8 bits a channel with opacity.
#[doc(alias = "frame buffer")]
#[doc(alias = "framebuffer")]
pub type ColourBuffer = Picture<Rgba<u8>>;
/// Linear colours, as lighting computes them.
pub type LinearColourBuffer = Picture<Rgb<f32>>;
/// Stencil: a count or a mark of 8 bits.
#[doc(alias = "stencil")]
pub type StencilBuffer = Picture<Luma<u8>>;

/// Most bytes that [`new`] allocates: 2³⁰, a picture of 16 384 × 16 384 pixels of 4 bytes.
pub const MAX_BYTES: u64 = 1 << 30;

/// Why a buffer is not made or not painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BufferError {
    /// The buffer would take more than [`MAX_BYTES`], or more than there is.
    TooLarge {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
        /// Bytes of a pixel.
        pixel_bytes: usize,
    },
    /// A span goes beyond the buffer.
    Outside {
        /// Row of the span.
        y: u32,
        /// Its first column.
        start: u32,
        /// The column after its last.
        end: u32,
        /// Columns of the buffer.
        width: u32,
        /// Rows of the buffer.
        height: u32,
    },
}

impl fmt::Display for BufferError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge {
                width,
                height,
                pixel_bytes,
            } => write!(
                f,
                "a buffer of {width} × {height} pixels of {pixel_bytes} bytes is too large: \
                 at most {MAX_BYTES} bytes are allowed"
            ),
            Self::Outside {
                y,
                start,
                end,
                width,
                height,
            } => write!(
                f,
                "the span of columns {start} to {end} in row {y} is outside the buffer of \
                 {width} × {height} pixels"
            ),
        }
    }
}

impl core::error::Error for BufferError {}

/// A buffer of `width` × `height` pixels, each `pixel`; a size of 0 is allowed.
///
/// # Errors
///
/// [`BufferError::TooLarge`], before anything is allocated.
///
/// # Examples
///
/// ```
/// use ombra_raster::buffers::{StencilBuffer, image::Luma, new};
///
/// let stencil: StencilBuffer = new(640, 480, Luma([0])).unwrap();
/// assert_eq!(stencil.dimensions(), (640, 480));
/// assert!(new(u32::MAX, u32::MAX, Luma([0u8])).is_err());
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer», «Stencil Buffer», «Immagine come Funzione 2D».
pub fn new<P: Pixel>(width: u32, height: u32, pixel: P) -> Result<Picture<P>, BufferError> {
    let pixel_bytes = size_of::<P::Subpixel>() * usize::from(P::CHANNEL_COUNT);
    let too_large = BufferError::TooLarge {
        width,
        height,
        pixel_bytes,
    };
    let pixels = allowed_pixels(width, height, pixel_bytes).ok_or(too_large)?;
    let mut values = Vec::new();
    let length = pixels * usize::from(P::CHANNEL_COUNT);
    values.try_reserve_exact(length).map_err(|_| too_large)?;
    match pixel.channels() {
        &[value] => values.resize(length, value),
        channels => {
            for _ in 0..pixels {
                values.extend_from_slice(channels);
            }
        }
    }
    ImageBuffer::from_raw(width, height, values).ok_or(too_large)
}

/// The number of pixels, if they take at most [`MAX_BYTES`].
fn allowed_pixels(width: u32, height: u32, pixel_bytes: usize) -> Option<usize> {
    let pixels = u64::from(width) * u64::from(height);
    let bytes = pixels.checked_mul(pixel_bytes as u64)?;
    (bytes <= MAX_BYTES).then_some(pixels as usize)
}

/// Writes `pixel` into every pixel of `spans`, a run at a time. A span without pixels paints none, wherever it lies.
///
/// # Errors
///
/// [`BufferError::Outside`] for the first span that goes beyond the buffer; the spans before it are painted then.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::buffers::{StencilBuffer, image::Luma, new, paint};
/// use ombra_raster::triangle::cover;
///
/// let mut stencil: StencilBuffer = new(4, 3, Luma([0])).unwrap();
/// let triangle = [DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(0.0, 4.0)];
/// paint(&mut stencil, cover(triangle, 4, 3).unwrap(), Luma([1])).unwrap();
/// assert_eq!(stencil.into_raw(), [
///     1, 1, 1, 0,
///     1, 1, 0, 0,
///     1, 0, 0, 0,
/// ]);
/// ```
pub fn paint<P: Pixel>(
    buffer: &mut Picture<P>,
    spans: impl IntoIterator<Item = Span>,
    pixel: P,
) -> Result<(), BufferError> {
    let (width, height) = buffer.dimensions();
    let values: &mut [P::Subpixel] = buffer;
    let channels = usize::from(P::CHANNEL_COUNT);
    let row_length = width as usize * channels;
    for Span { y, x } in spans {
        if x.is_empty() {
            continue;
        }
        let run = if x.end <= width && y < height {
            let start = y as usize * row_length;
            values.get_mut(start + x.start as usize * channels..start + x.end as usize * channels)
        } else {
            None
        };
        let Some(run) = run else {
            return Err(BufferError::Outside {
                y,
                start: x.start,
                end: x.end,
                width,
                height,
            });
        };
        match pixel.channels() {
            &[v] => run.fill(v),
            &[r, g, b] => fill_run(run.as_chunks_mut().0, [r, g, b]),
            &[r, g, b, a] => fill_run(run.as_chunks_mut().0, [r, g, b, a]),
            other => {
                for pixel in run.chunks_exact_mut(channels.max(1)) {
                    pixel.copy_from_slice(other);
                }
            }
        }
    }
    Ok(())
}

/// `run.fill(pixel)`, for pixels of several channels.
///
/// Lengths of runs are hard to predict, so a loop over pixels would be left at a surprising moment each time. Four blocks
/// that may overlap fill any length from one block to four without a loop; a long run is copied from its own beginning.
#[inline(always)]
fn fill_run<P: Copy>(run: &mut [P], pixel: P) {
    match run.len() {
        0 => {}
        1..=4 => fill_blocks(run, [pixel]),
        5..=16 => fill_blocks(run, [pixel; 4]),
        17..=64 => fill_blocks(run, [pixel; 16]),
        length => {
            fill_blocks(run, [pixel; 16]);
            let mut filled = 64;
            while filled < length {
                let more = filled.min(length - filled);
                run.copy_within(..more, filled);
                filled += more;
            }
        }
    }
}

/// Writes `block` four times from the beginning on, the last ones moved back where the run ends before.
#[inline(always)]
fn fill_blocks<P: Copy, const N: usize>(run: &mut [P], block: [P; N]) {
    let last = run.len().saturating_sub(N);
    for i in 0..4 {
        let rest = run.get_mut((i * N).min(last)..).unwrap_or_default();
        if let Some(place) = rest.first_chunk_mut() {
            *place = block;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::LumaA;

    #[test]
    fn sizes_are_checked_first() {
        for (width, height, pixel_bytes, allowed) in [
            (1 << 15, 1 << 15, 1, true),
            (1 << 15, (1 << 15) + 1, 1, false),
            (1 << 14, 1 << 14, 4, true),
            (1 << 14, 1 << 14, 5, false),
            (u32::MAX, 0, usize::MAX, true),
            (u32::MAX, u32::MAX, usize::MAX, false),
        ] {
            let pixels = allowed_pixels(width, height, pixel_bytes);
            let expected = allowed.then_some(width as usize * height as usize);
            assert_eq!(pixels, expected, "{width} {height} {pixel_bytes}");
        }
        for (width, height) in [((1 << 15) + 1, 1 << 15), (u32::MAX, u32::MAX)] {
            let error = new(width, height, Luma([0u8])).unwrap_err();
            assert_eq!(
                error.to_string(),
                format!(
                    "a buffer of {width} × {height} pixels of 1 bytes is too large: \
                     at most 1073741824 bytes are allowed"
                )
            );
        }
        // u32::MAX² · 16 bytes is more than a u64 holds.
        assert!(new(u32::MAX, u32::MAX, Rgba([0f32; 4])).is_err());
        for (width, height) in [(0, 0), (0, u32::MAX), (u32::MAX, 0)] {
            let empty = new(width, height, Rgba([1u8, 2, 3, 4])).unwrap();
            assert_eq!(empty.dimensions(), (width, height));
        }
    }

    #[test]
    fn every_kind_of_pixel_is_painted_whole() {
        fn check<P: Pixel + PartialEq + fmt::Debug>(background: P, pixel: P) {
            let mut buffer = new(5, 3, background).unwrap();
            let spans = [
                Span { y: 0, x: 0..5 },
                Span { y: 2, x: 1..4 },
                Span { y: 1, x: 5..5 },
            ];
            paint(&mut buffer, spans, pixel).unwrap();
            for (x, y, &found) in buffer.enumerate_pixels() {
                let painted = y == 0 || (y == 2 && (1..4).contains(&x));
                assert_eq!(found, if painted { pixel } else { background }, "{x} {y}");
            }
        }
        check(Luma([0u8]), Luma([9]));
        check(Luma([1.0f32]), Luma([0.25]));
        check(Luma([0u32]), Luma([U24::MAX.get()]));
        check(LumaA([0u16, 1]), LumaA([2, 3]));
        check(Rgb([0.0f32; 3]), Rgb([1.0, 2.0, 3.0]));
        check(Rgba([0u8; 4]), Rgba([1, 2, 3, 4]));
    }

    #[test]
    fn a_run_of_any_length_is_painted_and_nothing_beside_it() {
        fn check<P: Pixel + PartialEq + fmt::Debug>(background: P, pixel: P) {
            // From 65 pixels on a run is copied from its own beginning, from 257 on three times.
            for length in 0..=300 {
                let mut buffer = new(310, 1, background).unwrap();
                let x = 5..5 + length;
                paint(&mut buffer, [Span { y: 0, x: x.clone() }], pixel).unwrap();
                for (at, _, &found) in buffer.enumerate_pixels() {
                    let expected = if x.contains(&at) { pixel } else { background };
                    assert_eq!(found, expected, "{at} of {x:?}");
                }
            }
        }
        check(Luma([7u16]), Luma([9]));
        check(LumaA([0u8, 1]), LumaA([2, 3]));
        check(Rgb([0u8; 3]), Rgb([1, 2, 3]));
        check(Rgb([0.0f32; 3]), Rgb([1.0, 2.0, 3.0]));
        check(Rgba([0u8; 4]), Rgba([1, 2, 3, 4]));
    }

    #[test]
    #[allow(clippy::reversed_empty_ranges)]
    fn a_span_outside_is_named() {
        let mut buffer: StencilBuffer = new(4, 3, Luma([0])).unwrap();
        for (y, x) in [(0, 3..1), (0, 5..5), (9, 0..0)] {
            assert_eq!(paint(&mut buffer, [Span { y, x }], Luma([1])), Ok(()));
        }
        for (y, x) in [(3, 0..1), (0, 2..5), (u32::MAX, 0..u32::MAX)] {
            let (start, end) = (x.start, x.end);
            let spans = [Span { y: 1, x: 0..1 }, Span { y, x }];
            let error = paint(&mut buffer, spans, Luma([1])).unwrap_err();
            let expected = BufferError::Outside {
                y,
                start,
                end,
                width: 4,
                height: 3,
            };
            assert_eq!(error, expected);
            assert_eq!(
                error.to_string(),
                format!(
                    "the span of columns {start} to {end} in row {y} is outside the buffer of 4 × 3 pixels"
                )
            );
        }
        assert_eq!(buffer.as_raw().iter().filter(|&&v| v == 1).count(), 1);
    }
}
