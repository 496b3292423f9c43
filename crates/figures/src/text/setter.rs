//! Reads the markup and sets its characters one after the other.

use ombra_math::glam::DVec2;

use super::{BAR, CAPITALS, CLEAR, Line, MATH_AXIS, Run, SCRIPT};
use crate::error::FigureError;
use crate::font::{Cut, Glyph};
use crate::path::Rect;

/// Lays out one line of `markup` with letters of `size`, none below `least`.
///
/// # Errors
///
/// [`FigureError::Markup`], [`FigureError::MissingGlyph`].
pub(super) fn set(markup: &str, size: f64, least: f64) -> Result<Line, FigureError> {
    let mut setter = Setter {
        markup,
        rest: markup.chars().collect::<Vec<_>>().into_iter().peekable(),
        line: Line {
            runs: Vec::new(),
            bars: Vec::new(),
            width: 0.0,
            ascent: CAPITALS * size,
            descent: 0.0,
            plain: String::new(),
        },
        previous: None,
        least,
    };
    setter.sequence(Setting {
        cut: Cut::Upright,
        size,
        rise: 0.0,
        until: None,
    })?;
    Ok(setter.line)
}

#[derive(Clone, Copy)]
struct Setting {
    cut: Cut,
    size: f64,
    /// Baseline above the label's.
    rise: f64,
    until: Option<char>,
}

impl Setting {
    fn script(self, rise: f64, least: f64) -> Setting {
        let size = (self.size * SCRIPT).max(least);
        Setting {
            size,
            rise: self.rise + rise * self.size,
            ..self
        }
    }
}

struct Setter<'a> {
    markup: &'a str,
    rest: core::iter::Peekable<std::vec::IntoIter<char>>,
    line: Line,
    previous: Option<(Cut, Glyph, DVec2)>,
    least: f64,
}

impl Setter<'_> {
    fn fail<T>(&self, reason: &'static str) -> Result<T, FigureError> {
        Err(FigureError::Markup {
            text: self.markup.to_owned(),
            reason,
        })
    }

    /// Sets characters until `setting.until` or the end.
    fn sequence(&mut self, mut setting: Setting) -> Result<(), FigureError> {
        loop {
            let Some(character) = self.rest.next() else {
                return match setting.until {
                    Some(_) => self.fail("a brace stays open"),
                    None if setting.cut != Cut::Upright => self.fail("a * stays open"),
                    None => Ok(()),
                };
            };
            if setting.until == Some(character) {
                return Ok(());
            }
            match character {
                '*' => {
                    let double = self.rest.next_if_eq(&'*').is_some();
                    setting.cut = match (setting.cut, double) {
                        (Cut::Upright, false) => Cut::Italic,
                        (Cut::Upright, true) => Cut::BoldItalic,
                        (Cut::Italic, false) | (Cut::BoldItalic, true) => Cut::Upright,
                        _ => return self.fail("* closes * and ** closes **"),
                    };
                }
                '_' => self.script(setting, setting.script(-0.18, self.least))?,
                '^' => self.script(setting, setting.script(0.36, self.least))?,
                '{' => self.fraction(setting)?,
                '}' | '|' => return self.fail("a brace or bar without its opening brace"),
                '\\' => match self.rest.next() {
                    Some(literal) => self.set(literal, setting)?,
                    None => return self.fail("nothing follows the backslash"),
                },
                '\u{2070}'..='\u{209C}'
                | '²'
                | '³'
                | '¹'
                | '\u{1D62}'..='\u{1D6A}'
                | '\u{2C7C}' => {
                    return self.fail("a script is written _1 or ^2, so that its size is known");
                }
                _ => self.set(character, setting)?,
            }
        }
    }

    /// One character or a group in braces, raised or lowered.
    fn script(&mut self, outer: Setting, script: Setting) -> Result<(), FigureError> {
        // A subscript of an italic letter is a word or number of its own: upright until marked.
        let script = Setting {
            cut: Cut::Upright,
            ..script
        };
        match self.rest.next() {
            Some('{') => self.sequence(Setting {
                until: Some('}'),
                ..script
            }),
            Some('*' | '_' | '^' | '}' | '|') | None => {
                self.fail("nothing follows the script sign")
            }
            // A single letter keeps its variable's slant: P_x with an italic x.
            Some(letter) if letter.is_ascii_lowercase() => self.set(
                letter,
                Setting {
                    cut: Cut::Italic,
                    ..script
                },
            ),
            Some(character) => self.set(character, script),
        }?;
        let _ = outer;
        Ok(())
    }

    /// Numerator over denominator, each centred on the bar.
    fn fraction(&mut self, setting: Setting) -> Result<(), FigureError> {
        let size = (setting.size * 0.8).max(self.least);
        let part = |rise: f64, until: char| Setting {
            size,
            rise: setting.rise + rise,
            until: Some(until),
            ..setting
        };
        let gap = CLEAR * setting.size;
        let axis = MATH_AXIS * setting.size;
        let left = self.line.width + 0.06 * setting.size;

        let (first, plain) = (self.line.runs.len(), self.line.plain.len());
        let before = self.line.bars.len();
        let outside = (self.line.ascent, self.line.descent);
        (self.line.ascent, self.line.descent) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        self.line.width = left;
        self.previous = None;
        self.sequence(part(axis + gap, '|'))?;
        let numerator = self.line.width - left;
        self.line.bracket_plain(plain);
        self.line.plain.push('/');
        let over = self.line.plain.len();
        // What hangs below its baseline, such as a subscript, lifts the whole.
        let clear = CLEAR * setting.size;
        let up = (axis + clear + self.line.descent).max(0.0);
        self.line.shift(first, before, -up);
        let ascent = outside.0.max(self.line.ascent + up);

        let (middle, bars) = (self.line.runs.len(), self.line.bars.len());
        (self.line.ascent, self.line.descent) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        self.line.width = left;
        self.previous = None;
        self.sequence(part(axis - gap - CAPITALS * size, '}'))?;
        let denominator = self.line.width - left;
        if self.line.plain.len() <= plain + 1 {
            return self.fail("a fraction is {numerator|denominator}");
        }
        self.line.bracket_plain(over);
        // What rises above capitals, such as a superscript, lowers the whole.
        let down = (self.line.ascent - axis + clear).max(0.0);
        self.line.shift(middle, bars, down);
        let descent = outside.1.max(self.line.descent + down);
        (self.line.ascent, self.line.descent) = (ascent, descent);

        // The narrower of the two moves to the middle of the wider.
        let width = numerator.max(denominator);
        for (i, run) in self.line.runs.iter_mut().enumerate().skip(first) {
            run.at.x += 0.5 * (width - if i < middle { numerator } else { denominator });
        }
        for (i, bar) in self.line.bars.iter_mut().enumerate().skip(before) {
            let aside = 0.5 * (width - if i < bars { numerator } else { denominator });
            *bar = Rect::new(
                bar.min + DVec2::new(aside, 0.0),
                bar.max + DVec2::new(aside, 0.0),
            );
        }
        let (half, edge) = (BAR * setting.size, 0.04 * setting.size);
        let rise = -(setting.rise + axis);
        self.line.bars.push(Rect::new(
            DVec2::new(left - edge, rise - half),
            DVec2::new(left + width + edge, rise + half),
        ));
        self.line.width = left + width + 0.06 * setting.size;
        self.previous = None;
        Ok(())
    }

    /// One character at the end of the line.
    fn set(&mut self, character: char, setting: Setting) -> Result<(), FigureError> {
        let font = setting.cut.font()?;
        let Some(glyph) = font.glyph(character) else {
            return Err(FigureError::MissingGlyph {
                character,
                text: self.markup.to_owned(),
            });
        };
        self.line.plain.push(character);
        if ('\u{300}'..='\u{36F}').contains(&character) || character == '\u{20D7}' {
            return self.accent(glyph, character, setting);
        }

        let same = |run: &Run| {
            run.cut == setting.cut && run.size == setting.size && run.at.y == -setting.rise
        };
        let kerning = match self.previous {
            Some((cut, left, _))
                if cut == setting.cut && self.line.runs.last().is_some_and(same) =>
            {
                font.kerning(left, glyph) * setting.size
            }
            _ => 0.0,
        };
        if !self.line.runs.last().is_some_and(same) || self.previous.is_none() {
            self.line.runs.push(Run {
                cut: setting.cut,
                size: setting.size,
                text: String::new(),
                at: DVec2::new(self.line.width, -setting.rise),
                width: 0.0,
                glyphs: Vec::new(),
            });
        }
        let Some(run) = self.line.runs.last_mut() else {
            return Ok(());
        };
        let offset = DVec2::new(self.line.width + kerning - run.at.x, 0.0);
        run.glyphs.push((glyph, offset));
        run.text.push(character);
        run.width = offset.x + font.advance(glyph) * setting.size;
        self.line.width = run.at.x + run.width;
        self.previous = Some((setting.cut, glyph, offset));
        if let Some(extent) = font.extent(glyph) {
            self.line.ascent = self
                .line
                .ascent
                .max(setting.rise + extent.max.y * setting.size);
            self.line.descent = self
                .line
                .descent
                .max(-setting.rise - extent.min.y * setting.size);
        }
        Ok(())
    }

    /// A combining accent, centred over the letter before it and as far above as over an x.
    fn accent(
        &mut self,
        accent: Glyph,
        character: char,
        setting: Setting,
    ) -> Result<(), FigureError> {
        let font = setting.cut.font()?;
        let extents = |(_, base, offset): (Cut, Glyph, DVec2)| {
            Some((font.extent(base)?, font.extent(accent)?, offset))
        };
        let (Some((base, mark, offset)), Some(run)) =
            (self.previous.and_then(extents), self.line.runs.last_mut())
        else {
            return self.fail("an accent has no letter before it");
        };
        let x_height = font
            .glyph('x')
            .and_then(|x| font.extent(x))
            .map_or(0.0, |extent| extent.max.y);
        let up = (base.max.y - x_height).max(0.0);
        let aside = (base.min.x + base.max.x - mark.min.x - mark.max.x) * 0.5;
        run.glyphs
            .push((accent, offset + DVec2::new(aside, -up) * setting.size));
        run.text.push(character);
        self.line.ascent = self
            .line
            .ascent
            .max(setting.rise + (mark.max.y + up) * setting.size);
        Ok(())
    }
}
