//! A drawing as SVG.
//!
//! The first line is the `<svg …>` tag alone, no line is empty, there is no `<style>`, and every id begins with the
//! figure's own, so that the file can stand in a doc comment or a web page among others.

use core::fmt::Write as _;

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{Drawing, FillRule, HALO, Item, Paint, Pen};
use crate::error::FigureError;
use crate::font::Cut;
use crate::path::{Path, Segment, round, round_length};
use crate::png;
use crate::style::{Background, TextForm};
use crate::text::Line;

/// The licence of every figure.
pub const LICENCE: &str = "CC0 1.0";
/// Where its text stands.
pub const LICENCE_URL: &str = "https://creativecommons.org/publicdomain/zero/1.0/";

/// The whole file.
///
/// # Errors
///
/// [`FigureError::Font`].
pub fn svg(drawing: &Drawing) -> Result<String, FigureError> {
    written(drawing, "", 0.0)
}

/// The same on a card with round corners, no wider than the page it stands on.
///
/// # Errors
///
/// [`FigureError::Font`].
pub fn card(drawing: &Drawing) -> Result<String, FigureError> {
    written(drawing, " style=\"max-width:100%;height:auto\"", 24.0)
}

fn written(drawing: &Drawing, attributes: &str, corner: f64) -> Result<String, FigureError> {
    let (size, canvas) = (drawing.style.size, round(drawing.canvas));
    let mut writer = Writer {
        drawing,
        prefix: drawing.id.replace('/', "-"),
        out: String::new(),
        gradients: 0,
        halos: 0,
    };
    let title = escaped(&drawing.title);
    writer.line(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\" \
         aria-label=\"{title}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{attributes}>",
        size.width(),
        size.height(),
        canvas.x,
        canvas.y
    ));
    writer.line(&format!("<title>{title}</title>"));
    if !drawing.over.is_empty() {
        let over = escaped(&drawing.over.join("; "));
        writer.line(&format!("<desc>{over}</desc>"));
    }
    writer.line(&format!(
        "<metadata>Figure {} of the Ombra graphics course. {LICENCE}, free to use in slides: {LICENCE_URL}</metadata>",
        escaped(&drawing.id)
    ));
    if drawing.style.background != Background::Transparent {
        let paper = writer.colour("fill", Role::Paper.into());
        let round = if corner > 0.0 {
            format!(" rx=\"{corner}\"")
        } else {
            String::new()
        };
        writer.line(&format!(
            "<rect width=\"{}\" height=\"{}\"{round}{paper}/>",
            canvas.x, canvas.y
        ));
    }
    for item in &drawing.items {
        writer.item(item)?;
    }
    writer.line("</svg>");
    Ok(writer.out)
}

struct Writer<'a> {
    drawing: &'a Drawing,
    prefix: String,
    out: String,
    gradients: usize,
    halos: usize,
}

impl Writer<'_> {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn colour(&self, attribute: &str, ink: Ink) -> String {
        let mut text = format!(
            " {attribute}=\"#{:06x}\"",
            ink.rgb(self.drawing.style.palette())
        );
        if ink.alpha < 1.0 {
            let _ = write!(text, " {attribute}-opacity=\"{}\"", round_length(ink.alpha));
        }
        text
    }

    /// The attribute for a paint; a gradient is written out first.
    fn paint(&mut self, attribute: &str, paint: &Paint) -> String {
        let (head, tail, stops) = match paint {
            Paint::Solid(ink) => return self.colour(attribute, *ink),
            Paint::Linear { from, to, stops } => (
                format!(
                    "<linearGradient x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"",
                    from.x, from.y, to.x, to.y
                ),
                "</linearGradient>",
                stops,
            ),
            Paint::Radial {
                centre,
                radius,
                stops,
            } => (
                format!(
                    "<radialGradient cx=\"{}\" cy=\"{}\" r=\"{radius}\"",
                    centre.x, centre.y
                ),
                "</radialGradient>",
                stops,
            ),
        };
        self.gradients += 1;
        let id = format!("{}-gradient-{}", self.prefix, self.gradients);
        let mut text = format!("<defs>{head} gradientUnits=\"userSpaceOnUse\" id=\"{id}\">");
        for &(offset, ink) in stops {
            let _ = write!(
                text,
                "<stop offset=\"{}\"{}/>",
                round_length(offset),
                self.colour("stop-color", ink)
                    .replace("stop-color-opacity", "stop-opacity")
            );
        }
        self.line(&format!("{text}{tail}</defs>"));
        format!(" {attribute}=\"url(#{id})\"")
    }

    fn item(&mut self, item: &Item) -> Result<(), FigureError> {
        match item {
            Item::Shape { path, fill, stroke } => {
                let mut attributes = match fill {
                    None => " fill=\"none\"".to_owned(),
                    Some((paint, rule)) => {
                        let mut text = self.paint("fill", paint);
                        if *rule == FillRule::EvenOdd {
                            text.push_str(" fill-rule=\"evenodd\"");
                        }
                        text
                    }
                };
                if let Some(pen) = stroke {
                    attributes.push_str(&self.pen(pen));
                }
                self.line(&format!("<path{attributes} d=\"{}\"/>", data(path)));
            }
            Item::Picture { place, picture } => {
                let (at, size) = (place.min, round(place.size()));
                // Programs of before SVG 2 know the second form of a reference alone.
                let file = format!(
                    "data:image/png;base64,{}",
                    base64(&png::file(picture).unwrap_or_default())
                );
                self.line(&format!(
                    "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
                     href=\"{file}\" xlink:href=\"{file}\"/>",
                    at.x, at.y, size.x, size.y
                ));
            }
            Item::Text {
                line,
                at,
                ink,
                halo,
            } => {
                let fill = self.colour("fill", *ink);
                let rim = format!(
                    "{} stroke-width=\"{}\"",
                    self.colour("stroke", Role::Paper.into()),
                    2.0 * HALO
                );
                match self.drawing.style.text {
                    TextForm::Text => {
                        if *halo {
                            // Not every program knows paint-order: the rim is a text of its own, which nobody reads out.
                            self.letters(
                                line,
                                *at,
                                &format!(" fill=\"none\"{rim} aria-hidden=\"true\""),
                            );
                        }
                        self.letters(line, *at, &fill);
                    }
                    TextForm::Paths => {
                        let outline = data(&line.outline(*at)?);
                        let label = escaped(&line.plain);
                        if *halo {
                            // The outline is written once and drawn twice: rim, then letters.
                            self.halos += 1;
                            let id = format!("{}-label-{}", self.prefix, self.halos);
                            self.line(&format!("<g role=\"img\" aria-label=\"{label}\">"));
                            self.line(&format!("<defs><path id=\"{id}\" d=\"{outline}\"/></defs>"));
                            let reference = format!("<use href=\"#{id}\" xlink:href=\"#{id}\"");
                            self.line(&format!(
                                "{reference} fill=\"none\"{rim}/>{reference}{fill}/>"
                            ));
                            self.line("</g>");
                        } else {
                            self.line(&format!(
                                "<path role=\"img\" aria-label=\"{label}\"{fill} d=\"{outline}\"/>"
                            ));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn pen(&mut self, pen: &Pen) -> String {
        let mut text = self.paint("stroke", &pen.paint);
        let _ = write!(text, " stroke-width=\"{}\"", pen.width);
        if let Some((dash, gap)) = pen.dash {
            let _ = write!(text, " stroke-dasharray=\"{dash} {gap}\"");
        }
        text
    }

    /// A label as letters; each run says where it starts and how long it is, so that it keeps its place in any typeface.
    fn letters(&mut self, line: &Line, at: DVec2, attributes: &str) {
        let mut text =
            format!("<text font-family=\"'DejaVu Sans',Verdana,sans-serif\"{attributes}>");
        for run in &line.runs {
            let start = round(at + run.at);
            let cut = match run.cut {
                Cut::Upright => "",
                Cut::Italic => " font-style=\"italic\"",
                Cut::BoldItalic => " font-style=\"italic\" font-weight=\"bold\"",
            };
            let _ = write!(
                text,
                "<tspan x=\"{}\" y=\"{}\" font-size=\"{}\"{cut} textLength=\"{}\" \
                 lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\">{}</tspan>",
                start.x,
                start.y,
                round_length(run.size),
                round_length(run.width),
                escaped(&run.text)
            );
        }
        text.push_str("</text>");
        self.line(&text);
        for bar in &line.bars {
            let (min, size) = (round(at + bar.min), round(bar.size()));
            self.line(&format!(
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{attributes}/>",
                min.x, min.y, size.x, size.y
            ));
        }
    }
}

/// Path data; a letter a command, absolute coordinates.
fn data(path: &Path) -> String {
    let mut text = String::new();
    let point = |text: &mut String, letter: char, points: &[DVec2]| {
        text.push(letter);
        for (i, p) in points.iter().enumerate() {
            let _ = write!(text, "{}{} {}", if i == 0 { "" } else { " " }, p.x, p.y);
        }
    };
    for &segment in &path.segments {
        match segment {
            Segment::Move(p) => point(&mut text, 'M', &[p]),
            Segment::Line(p) => point(&mut text, 'L', &[p]),
            Segment::Quad(c, p) => point(&mut text, 'Q', &[c, p]),
            Segment::Cubic(c, d, p) => point(&mut text, 'C', &[c, d, p]),
            Segment::Close => text.push('Z'),
        }
    }
    text
}

/// XML's own characters as entities.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // A control character is not XML, a line break would break the form.
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Bytes as letters, six bits each.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |i| three.get(i).copied().map_or(0, u32::from);
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let letter = LETTERS.get((bits >> (18 - 6 * i) & 63) as usize);
            text.push(
                letter
                    .filter(|_| i <= three.len())
                    .map_or('=', |&b| char::from(b)),
            );
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// RFC 4648, 10.
    #[test]
    fn bytes_as_letters() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(base64(&[0xfb, 0xff]), "+/8=");
    }
}
