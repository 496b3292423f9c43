//! The depth buffer: a depth for every pixel.

use image::Luma;

use super::{BufferError, Picture};
use crate::depth_format::DepthFormat;

/// A stored depth for every pixel.
///
/// # Examples
///
/// ```
/// use ombra_raster::buffers::DepthBuffer;
/// use ombra_raster::depth_format::Depth16;
///
/// let depth: DepthBuffer<Depth16> = DepthBuffer::new(640, 480).unwrap();
/// assert_eq!(depth.stored(0, 0), Some(65_535));
/// assert_eq!(depth.depth(639, 479), Some(1.0));
/// assert_eq!(depth.depth(640, 479), None);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»: of the size of the picture, first filled with the greatest distance.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthBuffer<F: DepthFormat> {
    image: Picture<Luma<F::Stored>>,
}

impl<F: DepthFormat> DepthBuffer<F> {
    /// A buffer of `width` × `height` pixels, all at the far plane; a size of 0 is allowed.
    ///
    /// # Errors
    ///
    /// [`BufferError::TooLarge`], before anything is allocated.
    pub fn new(width: u32, height: u32) -> Result<Self, BufferError> {
        let image = super::new(width, height, Luma([F::FAR]))?;
        Ok(Self { image })
    }

    /// Puts all pixels back to the far plane.
    pub fn clear(&mut self) {
        let values: &mut [F::Stored] = &mut self.image;
        values.fill(F::FAR);
    }

    /// Columns and rows.
    #[must_use]
    pub fn dimensions(&self) -> (u32, u32) {
        self.image.dimensions()
    }

    /// What is stored for a pixel, or `None` outside the picture.
    #[must_use]
    pub fn stored(&self, x: u32, y: u32) -> Option<F::Stored> {
        self.image.get_pixel_checked(x, y).map(|p| p.0[0])
    }

    /// What is stored for a pixel, to be changed, or `None` outside the picture.
    pub fn stored_mut(&mut self, x: u32, y: u32) -> Option<&mut F::Stored> {
        self.image.get_pixel_mut_checked(x, y).map(|p| &mut p.0[0])
    }

    /// The depth of a pixel, 0 on the near plane and 1 on the far one, as far as the format kept it; `None` outside
    /// the picture.
    ///
    /// # Properties
    ///
    /// - Error: ½ ε of itself, from what is stored
    #[must_use]
    pub fn depth(&self, x: u32, y: u32) -> Option<f64> {
        let value = F::decode(self.stored(x, y)?);
        Some(if F::REVERSED { 1.0 - value } else { value })
    }

    /// The stored values as a picture.
    #[must_use]
    pub fn image(&self) -> &Picture<Luma<F::Stored>> {
        &self.image
    }

    /// The stored values as a picture.
    #[must_use]
    pub fn into_image(self) -> Picture<Luma<F::Stored>> {
        self.image
    }

    /// The stored values, row after row from the top.
    pub fn values_mut(&mut self) -> &mut [F::Stored] {
        &mut self.image
    }
}
