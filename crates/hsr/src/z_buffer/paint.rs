//! What a fragment that passes the depth test writes.

use fearless_simd::{Simd, f64x4};
use num_traits::{ToPrimitive, Zero};
use ombra_math::mesh::Mesh;
use ombra_raster::buffers::image::{Pixel, Primitive};
use ombra_raster::triangle_setup::Setup;

use super::options::{Blend, Colours};
use super::projected::Weights;

/// Pixels that the fast form does at once.
pub(super) const LANES: usize = 4;

/// A pixel that pictures are drawn with: any [`Pixel`] that threads may share.
pub trait PicturePixel: Pixel<Subpixel: Send + Sync> + Send + Sync {}

impl<P: Pixel<Subpixel: Send + Sync> + Send + Sync> PicturePixel for P {}

/// Writes fragments into some rows of a picture.
pub(super) trait Paint: Copy + Sync {
    /// The numbers that pixels are made of; nothing where only depth is drawn.
    type Sample: Send + Sync;
    /// What the fragments of a piece have in common.
    type Ink;

    fn ink(&self, triangle: usize, weights: &Weights, setup: &Setup<'_>) -> Option<Self::Ink>;

    /// Writes into pixel `i` of `samples`, where the triangle's edge functions are `edges`.
    fn write(&self, samples: &mut [Self::Sample], i: usize, ink: &Self::Ink, edges: [f64; 3]);

    /// Writes into the pixels from `i` on for which `pass` is true.
    #[inline(always)]
    fn write_lanes<S: Simd>(
        &self,
        samples: &mut [Self::Sample],
        i: usize,
        ink: &Self::Ink,
        pass: &[bool; LANES],
        [e0, e1, e2]: [f64x4<S>; 3],
    ) {
        for (l, &pass) in pass.iter().enumerate() {
            if pass {
                self.write(samples, i + l, ink, [e0[l], e1[l], e2[l]]);
            }
        }
    }
}

/// Depth alone.
#[derive(Clone, Copy)]
pub(super) struct DepthOnly;

impl Paint for DepthOnly {
    type Sample = ();
    type Ink = ();

    #[inline(always)]
    fn ink(&self, _: usize, _: &Weights, _: &Setup<'_>) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn write(&self, _: &mut [()], _: usize, (): &(), _: [f64; 3]) {}

    #[inline(always)]
    fn write_lanes<S: Simd>(
        &self,
        _: &mut [()],
        _: usize,
        (): &(),
        _: &[bool; LANES],
        _: [f64x4<S>; 3],
    ) {
    }
}

/// One colour a triangle.
#[derive(Clone, Copy)]
pub(super) struct Flat<'a, P> {
    pub(super) colours: Colours<'a, P>,
    pub(super) blend: Blend,
}

impl<P: PicturePixel> Paint for Flat<'_, P> {
    type Sample = P::Subpixel;
    type Ink = P;

    #[inline(always)]
    fn ink(&self, triangle: usize, _: &Weights, _: &Setup<'_>) -> Option<P> {
        match self.colours {
            Colours::One(one) => Some(one),
            Colours::PerTriangle(colours) => colours.get(triangle).copied(),
            Colours::PerVertex(_) => None,
        }
    }

    #[inline(always)]
    fn write(&self, samples: &mut [P::Subpixel], i: usize, ink: &P, _: [f64; 3]) {
        put(samples, i, *ink, self.blend);
    }

    #[inline(always)]
    fn write_lanes<S: Simd>(
        &self,
        samples: &mut [P::Subpixel],
        i: usize,
        ink: &P,
        pass: &[bool; LANES],
        _: [f64x4<S>; 3],
    ) {
        match (self.blend, ink.channels()) {
            (Blend::Replace, &[v]) => replace(samples, i, [v], pass),
            (Blend::Replace, &[r, g, b]) => replace(samples, i, [r, g, b], pass),
            (Blend::Replace, &[r, g, b, a]) => replace(samples, i, [r, g, b, a], pass),
            _ => {
                for (l, &pass) in pass.iter().enumerate() {
                    if pass {
                        put(samples, i + l, *ink, self.blend);
                    }
                }
            }
        }
    }
}

/// Chooses for each pixel between old and new without branches, which would often be guessed wrong.
#[inline(always)]
fn replace<T: Copy, const CHANNELS: usize>(
    samples: &mut [T],
    i: usize,
    ink: [T; CHANNELS],
    pass: &[bool; LANES],
) {
    let pixels = samples.get_mut(i * CHANNELS..(i + LANES) * CHANNELS);
    for (pixel, &pass) in pixels
        .unwrap_or_default()
        .as_chunks_mut()
        .0
        .iter_mut()
        .zip(pass)
    {
        *pixel = core::hint::select_unpredictable(pass, ink, *pixel);
    }
}

/// Colours of the vertices, interpolated with perspective.
#[derive(Clone, Copy)]
pub(super) struct Smooth<'a, P> {
    pub(super) colours: &'a [P],
    pub(super) triangles: &'a [[u32; 3]],
    pub(super) blend: Blend,
}

/// The vertices' colours, and for each corner of the setup the weights of the vertices over w.
pub(super) struct Gradient<P> {
    colours: [P; 3],
    weights: [[f64; 3]; 3],
}

impl<P: PicturePixel> Paint for Smooth<'_, P> {
    type Sample = P::Subpixel;
    type Ink = Gradient<P>;

    fn ink(&self, triangle: usize, weights: &Weights, setup: &Setup<'_>) -> Option<Gradient<P>> {
        Gradient::new(self.colours, self.triangles.get(triangle)?, weights, setup)
    }

    fn write(&self, samples: &mut [P::Subpixel], i: usize, ink: &Gradient<P>, edges: [f64; 3]) {
        put(samples, i, ink.at(edges), self.blend);
    }
}

impl<P: PicturePixel> Gradient<P> {
    #[inline(always)]
    fn new(
        colours: &[P],
        &[a, b, c]: &[u32; 3],
        weights: &Weights,
        setup: &Setup<'_>,
    ) -> Option<Self> {
        let colour = |index: u32| colours.get(index as usize).copied();
        // Over w, in units that cannot overflow.
        let least_w = setup.corners.iter().fold(f64::INFINITY, |w, c| w.min(c.w));
        let mut over_w = [[0.0; 3]; 3];
        for ((over_w, &from), corner) in over_w.iter_mut().zip(&setup.order).zip(&setup.corners) {
            *over_w = weights
                .get(from)?
                .map(|weight| weight * (least_w / corner.w));
        }
        Some(Self {
            colours: [colour(a)?, colour(b)?, colour(c)?],
            weights: over_w,
        })
    }

    /// The colour where the edge functions have these values.
    #[inline(always)]
    fn at(&self, edges: [f64; 3]) -> P {
        // Linear in the picture are weight / w and 1 / w; their quotient is the weight.
        let [mut a, mut b, mut c] = [0.0; 3];
        for (e, weights) in edges.iter().zip(&self.weights) {
            a += e * weights[0];
            b += e * weights[1];
            c += e * weights[2];
        }
        let sum = a + b + c;
        let share = [a / sum, b / sum, c / sum];
        let mut pixel = self.colours[0];
        for (k, sample) in pixel.channels_mut().iter_mut().enumerate() {
            let at = |colour: &P| colour.channels().get(k).copied();
            let mixed = self
                .colours
                .iter()
                .zip(share)
                .filter_map(|(colour, share)| Some(at(colour)?.to_f64()? * share));
            *sample = stored(mixed.sum()).unwrap_or(*sample);
        }
        pixel
    }
}

/// What the fragments of a piece have in common, whatever the [`Colours`].
pub(super) enum Ink<P> {
    Flat(P),
    Smooth(Gradient<P>),
}

impl<P: PicturePixel> Ink<P> {
    /// The colour of the fragment where the edge functions are `edges`.
    pub(super) fn at(&self, edges: [f64; 3]) -> P {
        match self {
            Self::Flat(colour) => *colour,
            Self::Smooth(gradient) => gradient.at(edges),
        }
    }
}

impl<P: PicturePixel> Colours<'_, P> {
    /// The ink of a piece of a triangle.
    pub(super) fn ink(
        &self,
        mesh: &Mesh,
        triangle: usize,
        weights: &Weights,
        setup: &Setup<'_>,
    ) -> Option<Ink<P>> {
        Some(match *self {
            Self::One(colour) => Ink::Flat(colour),
            Self::PerTriangle(colours) => Ink::Flat(*colours.get(triangle)?),
            Self::PerVertex(colours) => {
                let triangle = mesh.triangles.get(triangle)?;
                Ink::Smooth(Gradient::new(colours, triangle, weights, setup)?)
            }
        })
    }
}

#[inline(always)]
fn put<P: PicturePixel>(samples: &mut [P::Subpixel], i: usize, pixel: P, blend: Blend) {
    let channels = usize::from(P::CHANNEL_COUNT);
    if let Some(below) = samples.get_mut(i * channels..(i + 1) * channels) {
        blend.write(below, pixel);
    }
}

impl Blend {
    /// Puts a fragment's colour into a pixel that holds `below`.
    #[inline(always)]
    pub(super) fn write<P: PicturePixel>(self, below: &mut [P::Subpixel], pixel: P) {
        match self {
            Self::Replace => below.copy_from_slice(pixel.channels()),
            Self::Over => over(below, pixel),
        }
    }
}

/// `pixel` laid over what is there: a share α of it, and of what is below what it lets through.
///
/// ```text
/// α' = α + (1 − α) α_below          C' = (α C + (1 − α) α_below C_below) / α'
/// ```
fn over<P: PicturePixel>(below: &mut [P::Subpixel], pixel: P) {
    // RGBA and YA; all others are opaque.
    if !P::COLOR_MODEL.ends_with('A') {
        below.copy_from_slice(pixel.channels());
        return;
    }
    let opaque = P::Subpixel::DEFAULT_MAX_VALUE.to_f64().unwrap_or(1.0);
    let fraction = |alpha: P::Subpixel| alpha.to_f64().unwrap_or(f64::NAN) / opaque;
    let (Some((alpha_below, colours_below)), Some((&alpha, colours))) =
        (below.split_last_mut(), pixel.channels().split_last())
    else {
        return;
    };
    let alpha = fraction(alpha);
    let through = (1.0 - alpha) * fraction(*alpha_below);
    let sum = alpha + through;
    if sum.is_zero() {
        return;
    }
    for (old, new) in colours_below.iter_mut().zip(colours) {
        if let (Some(c), Some(c_below)) = (new.to_f64(), old.to_f64()) {
            *old = stored((alpha * c + through * c_below) / sum).unwrap_or(*old);
        }
    }
    *alpha_below = stored(sum * opaque).unwrap_or(*alpha_below);
}

/// The nearest number of the pixel's type, halves up for integers.
fn stored<T: Primitive>(value: f64) -> Option<T> {
    let half = <T as num_traits::NumCast>::from(0.5)?;
    let is_integer = half.is_zero();
    <T as num_traits::NumCast>::from(if is_integer {
        (value + 0.5).floor()
    } else {
        value
    })
}
