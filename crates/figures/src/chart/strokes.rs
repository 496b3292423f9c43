//! plotters' backend: lines as paths of the display list.

use core::convert::Infallible;

use ombra_math::glam::DVec2;
use plotters::prelude::*;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingErrorKind};

use crate::path::Path;

/// Lengths of the display list as plotters' pixels.
pub(super) fn hundredths(length: f64) -> u32 {
    (length * 100.0).round() as u32
}

/// plotters' backend: it collects lines; colours are numbers of curves.
pub(super) struct Strokes<'a> {
    pub(super) size: DVec2,
    pub(super) drawn: &'a mut Vec<(Path, u8, f64)>,
}

impl Strokes<'_> {
    fn push(
        &mut self,
        points: impl IntoIterator<Item = BackendCoord>,
        colour: BackendColor,
        width: u32,
    ) {
        let points: Vec<DVec2> = points
            .into_iter()
            .map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 100.0)
            .collect();
        self.drawn.push((
            Path::polyline(&points),
            colour.rgb.0,
            f64::from(width) / 100.0,
        ));
    }
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Strokes<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (hundredths(self.size.x), hundredths(self.size.y))
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.push([point, point], color, 1);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.push([from, to], style.color(), style.stroke_width());
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        self.push(path, style.color(), style.stroke_width());
        Ok(())
    }
}
