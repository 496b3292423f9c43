//! A drawing as pixels.

use tiny_skia::{
    Color, FillRule as SkiaRule, FilterQuality, GradientStop, IntSize, LineCap, LineJoin,
    LinearGradient, Paint as SkiaPaint, PathBuilder, Pixmap, PixmapPaint, Point, RadialGradient,
    Shader, SpreadMode, Stroke, StrokeDash, Transform,
};

use crate::colour::{Ink, Palette, Role};
use crate::drawing::{Drawing, FillRule, HALO, Item, Paint, Pen, Picture};
use crate::error::FigureError;
use crate::path::{Path, Rect, Segment};
use crate::style::{Background, Size};

/// The whole file; transparent where the style says so.
///
/// # Errors
///
/// [`FigureError::Value`] when the picture cannot be allocated or encoded, [`FigureError::Font`].
pub fn png(drawing: &Drawing) -> Result<Vec<u8>, FigureError> {
    let style = drawing.style;
    let wrong = || Size::refused(style.size.to_string());
    let mut canvas = Canvas {
        pixels: Pixmap::new(style.size.width(), style.size.height()).ok_or_else(wrong)?,
        transform: {
            let scale = style.size.shorter() as f32 / 1000.0;
            Transform::from_scale(scale, scale)
        },
        palette: style.palette(),
    };
    if style.background != Background::Transparent {
        canvas.pixels.fill(canvas.colour(Role::Paper.into()));
    }
    for item in &drawing.items {
        match item {
            Item::Shape { path, fill, stroke } => {
                let Some(outline) = outline(path) else {
                    continue;
                };
                if let Some((paint, rule)) = fill {
                    canvas.fill(&outline, paint, *rule);
                }
                if let Some(pen) = stroke {
                    canvas.stroke(&outline, pen);
                }
            }
            Item::Picture { place, picture } => canvas.picture(place, picture),
            Item::Text {
                line,
                at,
                ink,
                halo,
            } => {
                let Some(outline) = outline(&line.outline(*at)?) else {
                    continue;
                };
                if *halo {
                    canvas.stroke(&outline, &Pen::new(Role::Paper, 2.0 * HALO));
                }
                canvas.fill(&outline, &Paint::Solid(*ink), FillRule::NonZero);
            }
        }
    }
    canvas.pixels.encode_png().map_err(|_| wrong())
}

/// A picture as a file of its own; none when it has no pixels or not as many as it says.
pub(crate) fn file(picture: &Picture) -> Option<Vec<u8>> {
    pixmap(picture)?.encode_png().ok()
}

fn pixmap(picture: &Picture) -> Option<Pixmap> {
    let (width, height) = picture.size;
    Pixmap::from_vec(picture.rgba.clone(), IntSize::from_wh(width, height)?)
}

struct Canvas {
    pixels: Pixmap,
    transform: Transform,
    palette: Palette,
}

impl Canvas {
    fn colour(&self, ink: Ink) -> Color {
        let rgb = ink.rgb(self.palette);
        let channel = |shift: u32| (rgb >> shift & 255) as u8;
        let mut colour = Color::from_rgba8(channel(16), channel(8), channel(0), 255);
        colour.apply_opacity(ink.alpha as f32);
        colour
    }

    fn paint(&self, paint: &Paint) -> SkiaPaint<'static> {
        let stops = |stops: &[(f64, Ink)]| -> Vec<GradientStop> {
            stops
                .iter()
                .map(|&(offset, ink)| GradientStop::new(offset as f32, self.colour(ink)))
                .collect()
        };
        let first = |stops: &[(f64, Ink)]| {
            let ink = stops.first().map_or(Ink::of(Role::Paper), |stop| stop.1);
            Shader::SolidColor(self.colour(ink))
        };
        let shader = match paint {
            Paint::Solid(ink) => Shader::SolidColor(self.colour(*ink)),
            Paint::Linear {
                from,
                to,
                stops: inks,
            } => LinearGradient::new(
                Point::from_xy(from.x as f32, from.y as f32),
                Point::from_xy(to.x as f32, to.y as f32),
                stops(inks),
                SpreadMode::Pad,
                Transform::identity(),
            )
            .unwrap_or_else(|| first(inks)),
            Paint::Radial {
                centre,
                radius,
                stops: inks,
            } => {
                let centre = Point::from_xy(centre.x as f32, centre.y as f32);
                RadialGradient::new(
                    centre,
                    0.0,
                    centre,
                    *radius as f32,
                    stops(inks),
                    SpreadMode::Pad,
                    Transform::identity(),
                )
                .unwrap_or_else(|| first(inks))
            }
        };
        SkiaPaint {
            shader,
            anti_alias: true,
            ..SkiaPaint::default()
        }
    }

    fn picture(&mut self, place: &Rect, picture: &Picture) {
        let Some(pixels) = pixmap(picture) else {
            return;
        };
        let (at, size) = (place.min.as_vec2(), place.size().as_vec2());
        let (across, down) = (pixels.width() as f32, pixels.height() as f32);
        let placed = self
            .transform
            .pre_translate(at.x, at.y)
            .pre_scale(size.x / across, size.y / down);
        let paint = PixmapPaint {
            quality: FilterQuality::Bilinear,
            ..PixmapPaint::default()
        };
        self.pixels
            .draw_pixmap(0, 0, pixels.as_ref(), &paint, placed, None);
    }

    fn fill(&mut self, path: &tiny_skia::Path, paint: &Paint, rule: FillRule) {
        let rule = match rule {
            FillRule::NonZero => SkiaRule::Winding,
            FillRule::EvenOdd => SkiaRule::EvenOdd,
        };
        self.pixels
            .fill_path(path, &self.paint(paint), rule, self.transform, None);
    }

    fn stroke(&mut self, path: &tiny_skia::Path, pen: &Pen) {
        let stroke = Stroke {
            width: pen.width as f32,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: pen
                .dash
                .and_then(|(dash, gap)| StrokeDash::new(vec![dash as f32, gap as f32], 0.0)),
            ..Stroke::default()
        };
        self.pixels
            .stroke_path(path, &self.paint(&pen.paint), &stroke, self.transform, None);
    }
}

fn outline(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for &segment in &path.segments {
        match segment {
            Segment::Move(p) => builder.move_to(p.x as f32, p.y as f32),
            Segment::Line(p) => builder.line_to(p.x as f32, p.y as f32),
            Segment::Quad(c, p) => builder.quad_to(c.x as f32, c.y as f32, p.x as f32, p.y as f32),
            Segment::Cubic(c, d, p) => {
                builder.cubic_to(
                    c.x as f32, c.y as f32, d.x as f32, d.y as f32, p.x as f32, p.y as f32,
                );
            }
            Segment::Close => builder.close(),
        }
    }
    builder.finish()
}
