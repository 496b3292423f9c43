//! The embedded typeface: outlines, advances and kerning of DejaVu Sans, upright, oblique and bold oblique.

use std::sync::OnceLock;

use ombra_math::glam::DVec2;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

use crate::error::FigureError;
use crate::path::{Path, Segment};

/// One of the three cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cut {
    /// Words, numbers, operators.
    Upright,
    /// Variables.
    Italic,
    /// Vectors.
    BoldItalic,
}

/// A parsed cut.
pub struct Font {
    face: Face<'static>,
    scale: f64,
}

impl Cut {
    /// The parsed cut; parsed once.
    ///
    /// # Errors
    ///
    /// [`FigureError::Font`] when the embedded file is damaged.
    pub fn font(self) -> Result<&'static Font, FigureError> {
        static FONTS: [OnceLock<Option<Font>>; 3] = [const { OnceLock::new() }; 3];
        let (slot, bytes): (_, &'static [u8]) = match self {
            Cut::Upright => (0, include_bytes!("../fonts/DejaVuSans.ttf")),
            Cut::Italic => (1, include_bytes!("../fonts/DejaVuSans-Oblique.ttf")),
            Cut::BoldItalic => (2, include_bytes!("../fonts/DejaVuSans-BoldOblique.ttf")),
        };
        FONTS
            .get(slot)
            .and_then(|font| font.get_or_init(|| Font::parse(bytes)).as_ref())
            .ok_or(FigureError::Font)
    }
}

/// A glyph of a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Glyph(u16);

/// Extent of a glyph's ink in ems, y up from the baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Left and bottom.
    pub min: DVec2,
    /// Right and top.
    pub max: DVec2,
}

impl Font {
    fn parse(bytes: &'static [u8]) -> Option<Font> {
        let face = Face::parse(bytes, 0).ok()?;
        let scale = 1.0 / f64::from(face.units_per_em());
        Some(Font { face, scale })
    }

    /// The glyph of a character, if the typeface has it.
    pub fn glyph(&self, character: char) -> Option<Glyph> {
        self.face
            .glyph_index(character)
            .filter(|glyph| glyph.0 != 0)
            .map(|glyph| Glyph(glyph.0))
    }

    /// Distance to the next glyph's origin, in ems.
    pub fn advance(&self, glyph: Glyph) -> f64 {
        f64::from(self.face.glyph_hor_advance(GlyphId(glyph.0)).unwrap_or(0)) * self.scale
    }

    /// What two neighbours are moved together (negative) or apart, in ems.
    pub fn kerning(&self, left: Glyph, right: Glyph) -> f64 {
        let Some(kern) = self.face.tables().kern else {
            return 0.0;
        };
        let units = kern
            .subtables
            .into_iter()
            .filter(|table| table.horizontal && !table.variable && !table.has_cross_stream)
            .find_map(|table| table.glyphs_kerning(GlyphId(left.0), GlyphId(right.0)));
        f64::from(units.unwrap_or(0)) * self.scale
    }

    /// Extent of its ink; none for a space.
    pub fn extent(&self, glyph: Glyph) -> Option<Extent> {
        let bounds = self.face.glyph_bounding_box(GlyphId(glyph.0))?;
        let at = |x: i16, y: i16| DVec2::new(f64::from(x), f64::from(y)) * self.scale;
        Some(Extent {
            min: at(bounds.x_min, bounds.y_min),
            max: at(bounds.x_max, bounds.y_max),
        })
    }

    /// Appends its outline with the origin at `at` and the em `size` long, y turned downwards.
    pub fn outline(&self, glyph: Glyph, at: DVec2, size: f64, path: &mut Path) {
        let mut pen = Pen {
            path,
            at,
            scale: self.scale * size,
        };
        // None means an empty outline, as of a space.
        let _ = self.face.outline_glyph(GlyphId(glyph.0), &mut pen);
    }
}

struct Pen<'a> {
    path: &'a mut Path,
    at: DVec2,
    scale: f64,
}

impl Pen<'_> {
    fn point(&self, x: f32, y: f32) -> DVec2 {
        self.at + DVec2::new(f64::from(x), -f64::from(y)) * self.scale
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let p = self.point(x, y);
        self.path.segments.push(Segment::Move(p));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let p = self.point(x, y);
        self.path.segments.push(Segment::Line(p));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (c, p) = (self.point(x1, y1), self.point(x, y));
        self.path.segments.push(Segment::Quad(c, p));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (c, d, p) = (self.point(x1, y1), self.point(x2, y2), self.point(x, y));
        self.path.segments.push(Segment::Cubic(c, d, p));
    }

    fn close(&mut self) {
        self.path.segments.push(Segment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cuts_have_the_letters_of_the_four_languages_and_of_formulas() {
        let letters = "àèéìòù áčďéěíňóřšťúůýž čćđšž ÀÈÉÌÒÙ ÁČĎÉĚÍŇÓŘŠŤÚŮÝŽ ČĆĐŠŽ αβγδεθλμπρσφω ΔΣΦΩ −·×÷±≤≥≠≈∞√∫∂∇∈⊥∥→←↔⇒";
        for cut in [Cut::Upright, Cut::Italic, Cut::BoldItalic] {
            let font = cut.font().unwrap();
            for letter in letters.chars() {
                assert!(font.glyph(letter).is_some(), "{cut:?} lacks {letter}");
            }
        }
        let upright = Cut::Upright.font().unwrap();
        for letter in "ᵢᵣᵤᵥᵦᵧᵨᵩᵪⱼ₀₉⁰⁹⎡⎢⎣⎤⎥⎦\u{302}\u{303}\u{307}\u{20D7}".chars()
        {
            assert!(
                upright.glyph(letter).is_some(),
                "upright lacks U+{:04X}",
                u32::from(letter)
            );
        }
        assert!(upright.glyph('漢').is_none());
    }

    #[test]
    fn av_is_kerned() {
        let font = Cut::Upright.font().unwrap();
        let (a, v) = (font.glyph('A').unwrap(), font.glyph('V').unwrap());
        assert!(font.kerning(a, v) < -0.02);
        assert_eq!(font.kerning(v, font.glyph('0').unwrap()), 0.0);
    }
}
