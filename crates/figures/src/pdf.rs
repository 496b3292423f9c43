//! A drawing as PDF: one page as large as the drawing, a pixel of it 3/4 of a point.
//!
//! Letters are outlines, as in the SVG. Nothing in the file tells when or where it was made: the same drawing gives the
//! same bytes.

use core::cmp::Ordering;

use miniz_oxide::deflate::compress_to_vec_zlib;
use ombra_math::glam::DVec2;
use pdf_writer::types::{ColorSpaceOperand, FunctionShadingType, LineCapStyle, LineJoinStyle};
use pdf_writer::types::{MaskType, ProcSet};
use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect as Box, Ref, TextStr};

use crate::colour::{Ink, Palette, Role};
use crate::drawing::{Drawing, FillRule, HALO, Item, Paint, Pen, Picture};
use crate::error::FigureError;
use crate::path::{Path, Rect, Segment};
use crate::style::Background;
use crate::svg::{LICENCE, LICENCE_URL};

/// Points of a pixel: 96 pixels and 72 points are an inch.
const POINT: f64 = 0.75;
/// How hard streams are pressed, 0 to 10; fixed, so that the bytes are.
const PRESSED: u8 = 6;
/// The page's own objects; what it uses comes after them.
const CATALOGUE: i32 = 1;
const PAGES: i32 = 2;
const PAGE: i32 = 3;
const CONTENT: i32 = 4;
const INFO: i32 = 5;

/// The whole file.
///
/// # Errors
///
/// [`FigureError::Font`].
pub fn pdf(drawing: &Drawing) -> Result<Vec<u8>, FigureError> {
    let style = drawing.style;
    let page = DVec2::new(style.size.width().into(), style.size.height().into()) * POINT;
    let scale = f64::from(style.size.shorter()) * POINT / 1000.0;
    let mut writer = Writer {
        pdf: Pdf::new(),
        content: Content::new(),
        palette: style.palette(),
        canvas: drawing.canvas,
        // The page's y axis points up.
        matrix: [scale, 0.0, 0.0, -scale, 0.0, page.y].map(|x| x as f32),
        last: INFO,
        states: Vec::new(),
        alphas: Vec::new(),
        patterns: Vec::new(),
        pictures: Vec::new(),
    };
    let content = &mut writer.content;
    content.transform(writer.matrix);
    content.set_line_cap(LineCapStyle::RoundCap);
    content.set_line_join(LineJoinStyle::RoundJoin);
    if style.background != Background::Transparent {
        let paper = Path::polygon(&[
            DVec2::ZERO,
            DVec2::new(drawing.canvas.x, 0.0),
            drawing.canvas,
            DVec2::new(0.0, drawing.canvas.y),
        ]);
        writer.fill(&paper, &Role::Paper.into(), FillRule::NonZero);
    }
    for item in &drawing.items {
        writer.item(item)?;
    }
    Ok(writer.finish(drawing, page))
}

struct Writer {
    pdf: Pdf,
    content: Content,
    palette: Palette,
    canvas: DVec2,
    /// From the canvas to the page.
    matrix: [f32; 6],
    /// The last object's number.
    last: i32,
    states: Vec<Ref>,
    /// Opacities in use, with the place of their state.
    alphas: Vec<(f64, usize)>,
    patterns: Vec<Ref>,
    pictures: Vec<Ref>,
}

/// A thing of the page's dictionaries by its kind and place.
fn name(kind: char, place: usize) -> Vec<u8> {
    format!("{kind}{place}").into_bytes()
}

/// Where a gradient lies, in PDF's numbers.
struct Along<'a> {
    kind: FunctionShadingType,
    coordinates: Vec<f32>,
    stops: &'a [(f64, Ink)],
}

impl<'a> Along<'a> {
    /// None for one ink, and for a gradient that has no length: it is as its first stop.
    fn of(paint: &'a Paint) -> Result<Along<'a>, Ink> {
        let first = |stops: &[(f64, Ink)]| stops.first().map_or(Ink::of(Role::Paper), |s| s.1);
        let single = |values: &[f64]| values.iter().map(|&x| x as f32).collect();
        match paint {
            Paint::Solid(ink) => Err(*ink),
            Paint::Linear { stops, .. } | Paint::Radial { stops, .. } if stops.len() < 2 => {
                Err(first(stops))
            }
            Paint::Linear { from, to, stops } if from == to => Err(first(stops)),
            Paint::Radial { radius, stops, .. } if radius.is_nan() || *radius <= 0.0 => {
                Err(first(stops))
            }
            Paint::Linear { from, to, stops } => Ok(Along {
                kind: FunctionShadingType::Axial,
                coordinates: single(&[from.x, from.y, to.x, to.y]),
                stops,
            }),
            Paint::Radial {
                centre: c,
                radius,
                stops,
            } => Ok(Along {
                kind: FunctionShadingType::Radial,
                coordinates: single(&[c.x, c.y, 0.0, c.x, c.y, *radius]),
                stops,
            }),
        }
    }
}

impl Writer {
    fn next(&mut self) -> Ref {
        self.last += 1;
        Ref::new(self.last)
    }

    fn rgb(&self, ink: Ink) -> [f32; 3] {
        let rgb = ink.rgb(self.palette);
        [16, 8, 0].map(|shift| (rgb >> shift & 255) as f32 / 255.0)
    }

    fn item(&mut self, item: &Item) -> Result<(), FigureError> {
        match item {
            Item::Shape { path, fill, stroke } => {
                if let Some((paint, rule)) = fill {
                    self.fill(path, paint, *rule);
                }
                if let Some(pen) = stroke {
                    self.stroke(path, pen);
                }
            }
            Item::Picture { place, picture } => self.picture(place, picture),
            Item::Text {
                line,
                at,
                ink,
                halo,
            } => {
                let outline = line.outline(*at)?;
                if *halo {
                    self.stroke(&outline, &Pen::new(Role::Paper, 2.0 * HALO));
                }
                self.fill(&outline, &Paint::Solid(*ink), FillRule::NonZero);
            }
        }
        Ok(())
    }

    fn fill(&mut self, path: &Path, paint: &Paint, rule: FillRule) {
        if path.segments.is_empty() {
            return;
        }
        self.content.save_state();
        self.paint(paint, false);
        outline(&mut self.content, path);
        match rule {
            FillRule::NonZero => self.content.fill_nonzero(),
            FillRule::EvenOdd => self.content.fill_even_odd(),
        };
        self.content.restore_state();
    }

    fn stroke(&mut self, path: &Path, pen: &Pen) {
        if path.segments.is_empty() {
            return;
        }
        self.content.save_state();
        self.paint(&pen.paint, true);
        self.content.set_line_width(pen.width as f32);
        if let Some((dash, gap)) = pen.dash {
            self.content
                .set_dash_pattern([dash as f32, gap as f32], 0.0);
        }
        outline(&mut self.content, path);
        self.content.stroke();
        self.content.restore_state();
    }

    /// Chooses the colour of what comes next.
    fn paint(&mut self, paint: &Paint, stroke: bool) {
        let along = match Along::of(paint) {
            Ok(along) => along,
            Err(ink) => {
                self.opacity(ink.alpha);
                let [r, g, b] = self.rgb(ink);
                if stroke {
                    self.content.set_stroke_rgb(r, g, b);
                } else {
                    self.content.set_fill_rgb(r, g, b);
                }
                return;
            }
        };
        let opaque: Vec<f64> = along.stops.iter().map(|stop| stop.1.alpha).collect();
        match opaque.first() {
            Some(&first) if opaque.iter().all(|&alpha| alpha == first) => self.opacity(first),
            _ => self.mask(&along),
        }
        let colours: Vec<Vec<f32>> = along
            .stops
            .iter()
            .map(|stop| self.rgb(stop.1).to_vec())
            .collect();
        let function = self.function(&along, &colours);
        let pattern = self.next();
        let mut shading = self.pdf.shading_pattern(pattern);
        shading.matrix(self.matrix);
        let mut inner = shading.function_shading();
        inner.shading_type(along.kind);
        inner.color_space().device_rgb();
        inner.coords(along.coordinates.iter().copied());
        inner.extend([true, true]).function(function);
        inner.finish();
        shading.finish();
        self.patterns.push(pattern);
        let word = name('P', self.patterns.len());
        if stroke {
            self.content
                .set_stroke_color_space(ColorSpaceOperand::Pattern)
                .set_stroke_pattern([], Name(&word));
        } else {
            self.content
                .set_fill_color_space(ColorSpaceOperand::Pattern)
                .set_fill_pattern([], Name(&word));
        }
    }

    /// One opacity for all that comes next.
    fn opacity(&mut self, alpha: f64) {
        if alpha >= 1.0 {
            return;
        }
        let known = self.alphas.iter().find(|known| known.0 == alpha);
        let place = match known {
            Some(&(_, place)) => place,
            None => {
                let id = self.next();
                self.pdf
                    .ext_graphics(id)
                    .stroking_alpha(alpha as f32)
                    .non_stroking_alpha(alpha as f32);
                self.states.push(id);
                self.alphas.push((alpha, self.states.len()));
                self.states.len()
            }
        };
        self.content.set_parameters(Name(&name('S', place)));
    }

    /// An opacity that runs with the gradient: a grey one of the same place is the mask.
    fn mask(&mut self, along: &Along) {
        let greys: Vec<Vec<f32>> = along
            .stops
            .iter()
            .map(|stop| vec![stop.1.alpha as f32])
            .collect();
        let function = self.function(along, &greys);
        let shading = self.next();
        let mut inner = self.pdf.function_shading(shading);
        inner.shading_type(along.kind);
        inner.color_space().device_gray();
        inner.coords(along.coordinates.iter().copied());
        inner.extend([true, true]).function(function);
        inner.finish();
        let mut content = Content::new();
        content.shading(Name(b"G"));
        let content = content.finish();
        let (form, state) = (self.next(), self.next());
        let mut object = self.pdf.form_xobject(form, &content);
        object.bbox(Box::new(
            0.0,
            0.0,
            self.canvas.x as f32,
            self.canvas.y as f32,
        ));
        object.resources().shadings().pair(Name(b"G"), shading);
        let mut group = object.group();
        group.transparency().isolated(true);
        group.color_space().device_gray();
        group.finish();
        object.finish();
        let mut graphics = self.pdf.ext_graphics(state);
        graphics
            .soft_mask()
            .subtype(MaskType::Luminosity)
            .group(form);
        graphics.finish();
        self.states.push(state);
        self.content
            .set_parameters(Name(&name('S', self.states.len())));
    }

    /// Values between stops, straight from one to the next.
    fn function(&mut self, along: &Along, values: &[Vec<f32>]) -> Ref {
        let mut offsets: Vec<f32> = along.stops.iter().map(|stop| stop.0 as f32).collect();
        let mut values: Vec<&[f32]> = values.iter().map(Vec::as_slice).collect();
        // The domain is 0..=1: before the first stop and behind the last one nothing changes.
        if let (Some(&first), Some(&value)) = (offsets.first(), values.first())
            && first > 0.0
        {
            offsets.insert(0, 0.0);
            values.insert(0, value);
        }
        if let (Some(&last), Some(&value)) = (offsets.last(), values.last())
            && last < 1.0
        {
            offsets.push(1.0);
            values.push(value);
        }
        let (mut parts, mut bounds) = (Vec::new(), Vec::new());
        for (ends, between) in values.windows(2).zip(offsets.windows(2)) {
            let (&[from, to], &[start, end]) = (ends, between) else {
                continue;
            };
            // A jump has no length: its stops bound the parts beside it.
            if start.partial_cmp(&end) != Some(Ordering::Less) {
                continue;
            }
            if !parts.is_empty() {
                bounds.push(start);
            }
            let part = self.next();
            let mut function = self.pdf.exponential_function(part);
            function.domain([0.0, 1.0]).n(1.0);
            function.c0(from.iter().copied()).c1(to.iter().copied());
            function.finish();
            parts.push(part);
        }
        let whole = self.next();
        let mut function = self.pdf.stitching_function(whole);
        function.domain([0.0, 1.0]);
        function.encode(parts.iter().flat_map(|_| [0.0, 1.0]));
        function.bounds(bounds).functions(parts);
        function.finish();
        whole
    }

    /// Colours and opacities are two pictures; colours not times how opaque they are.
    fn picture(&mut self, place: &Rect, picture: &Picture) {
        let (width, height) = picture.size;
        let pixels = u64::from(width) * u64::from(height);
        let (Ok(across), Ok(down)) = (i32::try_from(width), i32::try_from(height)) else {
            return;
        };
        if pixels == 0 || picture.rgba.len() as u64 != 4 * pixels {
            return;
        }
        let mut colours = Vec::with_capacity(picture.rgba.len() / 4 * 3);
        let mut alphas = Vec::with_capacity(picture.rgba.len() / 4);
        for pixel in picture.rgba.chunks_exact(4) {
            let &[r, g, b, alpha] = pixel else { continue };
            let whole = u32::from(alpha);
            colours.extend([r, g, b].map(|c| {
                let c = u32::from(c) * 255 + whole / 2;
                c.checked_div(whole).map_or(0, |c| c.min(255) as u8)
            }));
            alphas.push(alpha);
        }
        let (image, mask) = (self.next(), self.next());
        let opaque = alphas.iter().all(|&alpha| alpha == 255);
        let colours = compress_to_vec_zlib(&colours, PRESSED);
        let mut object = self.pdf.image_xobject(image, &colours);
        object.filter(Filter::FlateDecode);
        object.width(across).height(down).bits_per_component(8);
        object.color_space().device_rgb();
        object.interpolate(true);
        if !opaque {
            object.s_mask(mask);
        }
        object.finish();
        if !opaque {
            let alphas = compress_to_vec_zlib(&alphas, PRESSED);
            let mut object = self.pdf.image_xobject(mask, &alphas);
            object.filter(Filter::FlateDecode);
            object.width(across).height(down).bits_per_component(8);
            object.color_space().device_gray();
            object.interpolate(true);
        } else {
            self.last -= 1;
        }
        self.pictures.push(image);
        let (at, size) = (place.min, place.size());
        // A picture fills the unit square, its first row at the top.
        let matrix = [size.x, 0.0, 0.0, -size.y, at.x, at.y + size.y].map(|x| x as f32);
        self.content
            .save_state()
            .transform(matrix)
            .x_object(Name(&name('I', self.pictures.len())))
            .restore_state();
    }

    fn finish(mut self, drawing: &Drawing, size: DVec2) -> Vec<u8> {
        let (pages, id, content) = (Ref::new(PAGES), Ref::new(PAGE), Ref::new(CONTENT));
        let mut catalogue = self.pdf.catalog(Ref::new(CATALOGUE));
        catalogue.pages(pages);
        catalogue.lang(TextStr(drawing.style.language.word()));
        catalogue.viewer_preferences().display_doc_title(true);
        catalogue.finish();
        self.pdf.pages(pages).kids([id]).count(1);
        let mut page = self.pdf.page(id);
        page.parent(pages).contents(content);
        page.media_box(Box::new(0.0, 0.0, size.x as f32, size.y as f32));
        // What is transparent blends in the screen's colours.
        let mut group = page.group();
        group.transparency().isolated(true);
        group.color_space().device_rgb();
        group.finish();
        let mut resources = page.resources();
        resources.proc_sets([ProcSet::Pdf, ProcSet::ImageColor, ProcSet::ImageGrayscale]);
        let list = |ids: &[Ref], kind| -> Vec<(Vec<u8>, Ref)> {
            let named = ids.iter().enumerate();
            named.map(|(i, &id)| (name(kind, i + 1), id)).collect()
        };
        let named = list(&self.states, 'S');
        let pairs = named.iter().map(|(word, id)| (Name(word), *id));
        resources.ext_g_states().pairs(pairs);
        let named = list(&self.patterns, 'P');
        let pairs = named.iter().map(|(word, id)| (Name(word), *id));
        resources.patterns().pairs(pairs);
        let named = list(&self.pictures, 'I');
        let pairs = named.iter().map(|(word, id)| (Name(word), *id));
        resources.x_objects().pairs(pairs);
        resources.finish();
        page.finish();
        let bytes = compress_to_vec_zlib(&self.content.finish(), PRESSED);
        self.pdf.stream(content, &bytes).filter(Filter::FlateDecode);
        let subject = format!(
            "Figure {} of the Ombra graphics course. {LICENCE}, free to use in slides: {LICENCE_URL}",
            drawing.id
        );
        self.pdf
            .document_info(Ref::new(INFO))
            .title(TextStr(&drawing.title))
            .subject(TextStr(&subject));
        self.pdf.finish()
    }
}

/// A contour a time; a quadratic curve as the cubic one that it is.
fn outline(content: &mut Content, path: &Path) {
    let (mut start, mut last) = (DVec2::ZERO, DVec2::ZERO);
    for &segment in &path.segments {
        match segment {
            Segment::Move(p) => {
                content.move_to(p.x as f32, p.y as f32);
                (start, last) = (p, p);
            }
            Segment::Line(p) => {
                content.line_to(p.x as f32, p.y as f32);
                last = p;
            }
            Segment::Quad(c, p) => {
                let (a, b) = (last + (c - last) * (2.0 / 3.0), p + (c - p) * (2.0 / 3.0));
                curve(content, a, b, p);
                last = p;
            }
            Segment::Cubic(c, d, p) => {
                curve(content, c, d, p);
                last = p;
            }
            Segment::Close => {
                content.close_path();
                last = start;
            }
        }
    }
}

fn curve(content: &mut Content, c: DVec2, d: DVec2, p: DVec2) {
    let [a, b, c, d, e, f] = [c.x, c.y, d.x, d.y, p.x, p.y].map(|x| x as f32);
    content.cubic_to(a, b, c, d, e, f);
}
