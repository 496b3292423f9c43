//! Labels: a small markup, laid out with the embedded typeface.
//!
//! ```text
//! words and 12.5       upright
//! *x*                  a variable, italic
//! **L**                a vector, bold italic
//! *P*_x  *P*_{12}      subscript; ^ for a superscript
//! −{300|7}             a stacked fraction
//! **n̂**                a combining accent, centred over its letter
//! \*  \_  \{           the character itself
//! ```
//!
//! Nothing is smaller than [`SMALLEST`]: scripts and fractions of a small label shrink less. A character that the
//! typeface lacks is an error, never an empty box; the tiny Unicode scripts (₁, ²) are refused in favour of `_1`, `^2`.

use ombra_math::glam::DVec2;

use crate::drawing::round;
use crate::error::FigureError;
use crate::font::{Cut, Glyph};
use crate::path::{Path, Rect};

/// Letter size (em) below which nobody in the back row reads, in thousandths of the shorter side.
pub const SMALLEST: f64 = 21.0;
/// Letter size of labels.
pub const LABEL: f64 = 32.0;
/// Letter size of ticks, captions and notes.
pub const NOTE: f64 = 26.0;

/// Scripts and stacked numbers, as a share of the label's size.
const SCRIPT: f64 = 0.7;
/// Height of the minus sign and of fraction bars above the baseline, in ems.
const MATH_AXIS: f64 = 0.314;
/// From a fraction's bar to its letters, at least, in ems.
const CLEAR: f64 = 0.07;
/// Height of capitals, in ems.
pub(crate) const CAPITALS: f64 = 0.729;

/// Letters of one cut and size on one baseline.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Upright, italic or bold italic.
    pub cut: Cut,
    /// Em.
    pub size: f64,
    /// Its letters.
    pub text: String,
    /// Start of its baseline, from the label's own.
    pub at: DVec2,
    /// From its start to where the next would start.
    pub width: f64,
    glyphs: Vec<(Glyph, DVec2)>,
}

/// A laid-out label; its origin is the start of its baseline, y points down.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Letters.
    pub runs: Vec<Run>,
    /// Fraction bars.
    pub bars: Vec<Rect>,
    /// From its origin to where the next would start.
    pub width: f64,
    /// Above the baseline, at least the height of capitals.
    pub ascent: f64,
    /// Below the baseline.
    pub descent: f64,
    /// What a reader aloud says.
    pub plain: String,
}

impl Line {
    /// Lays out `markup` with letters of `size`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Markup`], [`FigureError::MissingGlyph`].
    pub fn new(markup: &str, size: f64) -> Result<Line, FigureError> {
        let size = if size > SMALLEST { size } else { SMALLEST };
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
        };
        setter.sequence(Setting {
            cut: Cut::Upright,
            size,
            rise: 0.0,
            until: None,
        })?;
        Ok(setter.line)
    }

    /// Puts what a reader says from the byte `from` on in brackets if it is a sum.
    fn bracket_plain(&mut self, from: usize) {
        let part = self.plain.get(from..).unwrap_or_default();
        if part.contains(' ') {
            let part = format!("({part})");
            self.plain.truncate(from);
            self.plain.push_str(&part);
        }
    }

    /// Moves its runs and bars from the given ones on down by `by`.
    fn shift(&mut self, runs: usize, bars: usize, by: f64) {
        let by = DVec2::new(0.0, by);
        for run in self.runs.iter_mut().skip(runs) {
            run.at += by;
        }
        for bar in self.bars.iter_mut().skip(bars) {
            *bar = Rect::new(bar.min + by, bar.max + by);
        }
    }

    /// The smallest letters in it.
    pub fn smallest(&self) -> f64 {
        self.runs
            .iter()
            .fold(f64::INFINITY, |least, run| least.min(run.size))
    }

    /// Box of a label whose baseline starts at `at`.
    pub fn bounds(&self, at: DVec2) -> Rect {
        Rect::new(
            at - DVec2::new(0.0, self.ascent),
            at + DVec2::new(self.width, self.descent),
        )
    }

    /// Where the baseline starts when the label's box has its middle at `centre`.
    pub fn centred(&self, centre: DVec2) -> DVec2 {
        centre + DVec2::new(-self.width * 0.5, (self.ascent - self.descent) * 0.5)
    }

    /// Outlines of letters and bars, the baseline starting at `at`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Font`].
    pub fn outline(&self, at: DVec2) -> Result<Path, FigureError> {
        let mut path = Path::new();
        for run in &self.runs {
            let font = run.cut.font()?;
            for &(glyph, offset) in &run.glyphs {
                font.outline(glyph, at + run.at + offset, run.size, &mut path);
            }
        }
        for bar in &self.bars {
            let (a, b) = (at + bar.min, at + bar.max);
            path.add_polygon(&[a, DVec2::new(a.x, b.y), b, DVec2::new(b.x, a.y)]);
        }
        Ok(path.map(round))
    }
}

/// `words` with the markup's own characters escaped, for names that come from outside.
pub fn escape(words: &str) -> String {
    let mut escaped = String::with_capacity(words.len());
    for character in words.chars() {
        if matches!(character, '*' | '_' | '^' | '{' | '}' | '|' | '\\') {
            escaped.push('\\');
        }
        escaped.push(character);
    }
    escaped
}

/// Lines of at most `width`, broken at spaces; a longer word stands alone.
///
/// # Errors
///
/// As [`Line::new`].
pub fn wrapped(markup: &str, size: f64, width: f64) -> Result<Vec<Line>, FigureError> {
    let mut lines = Vec::new();
    let mut current = String::new();
    for word in markup.split(' ') {
        let longer = if current.is_empty() {
            word.to_owned()
        } else {
            format!("{current} {word}")
        };
        if !current.is_empty() && Line::new(&longer, size)?.width > width {
            lines.push(Line::new(&current, size)?);
            word.clone_into(&mut current);
        } else {
            current = longer;
        }
    }
    lines.push(Line::new(&current, size)?);
    Ok(lines)
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
    fn script(self, rise: f64) -> Setting {
        let size = (self.size * SCRIPT).max(SMALLEST);
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
                '_' => self.script(setting, setting.script(-0.18))?,
                '^' => self.script(setting, setting.script(0.36))?,
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
        let size = (setting.size * 0.8).max(SMALLEST);
        let part = |rise: f64, until: char| Setting {
            size,
            rise: setting.rise + rise,
            until: Some(until),
            ..setting
        };
        let gap = 0.09 * setting.size;
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
        let (half, edge) = (0.035 * setting.size, 0.04 * setting.size);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn line(markup: &str) -> Line {
        Line::new(markup, LABEL).unwrap()
    }

    #[test]
    fn cuts_follow_the_markup() {
        let line = line("**L** = (*x*, 0)");
        let runs: Vec<_> = line
            .runs
            .iter()
            .map(|run| (run.cut, run.text.as_str()))
            .collect();
        assert_eq!(
            runs,
            [
                (Cut::BoldItalic, "L"),
                (Cut::Upright, " = ("),
                (Cut::Italic, "x"),
                (Cut::Upright, ", 0)"),
            ]
        );
        assert_eq!(line.plain, "L = (x, 0)");
    }

    #[test]
    fn a_fraction_is_stacked_around_the_height_of_the_minus() {
        assert_eq!(Line::new("{1 + *x*|7}", LABEL).unwrap().plain, "(1 + x)/7");
        let line = line("−{300|7}");
        assert_eq!(line.plain, "−300/7");
        let [minus, over, under] = &line.runs[..] else {
            panic!("{:?}", line.runs)
        };
        let bar = line.bars[0];
        let middle = -bar.centre().y;
        assert!((middle - MATH_AXIS * LABEL).abs() < 1e-9);
        assert!(over.at.y < -middle && under.at.y > bar.max.y);
        // Each is centred on the bar, and nothing juts out over it.
        for run in [over, under] {
            assert!((run.at.x + run.width / 2.0 - bar.centre().x).abs() < 1e-9);
            assert!(run.at.x >= bar.min.x && run.at.x + run.width <= bar.max.x);
        }
        assert!(minus.width <= bar.min.x);
    }

    #[test]
    fn nothing_in_a_fraction_touches_its_bar() {
        for markup in [
            "{*L*_y *V*_x − *L*_x *V*_y|*L*_y − *V*_y}",
            "{(*g*)|*x*^2}",
            "{1|{2|3_y}}",
            "{300|7}",
        ] {
            let line = line(markup);
            // The outer bar is the longest; every glyph lies above or below it.
            let bar = line
                .bars
                .iter()
                .copied()
                .max_by(|a, b| a.size().x.total_cmp(&b.size().x));
            let bar = bar.unwrap();
            for run in &line.runs {
                for &(glyph, offset) in &run.glyphs {
                    let Some(extent) = run.cut.font().unwrap().extent(glyph) else {
                        continue;
                    };
                    let base = run.at.y + offset.y;
                    let (top, bottom) = (
                        base - extent.max.y * run.size,
                        base - extent.min.y * run.size,
                    );
                    assert!(
                        bottom < bar.min.y || top > bar.max.y,
                        "{markup}: {}",
                        run.text
                    );
                    assert!(
                        line.ascent >= -top - 1e-9 && line.descent >= bottom - 1e-9,
                        "{markup}"
                    );
                }
            }
        }
    }

    #[test]
    fn scripts_move_off_the_baseline_and_stay_legible() {
        for (markup, sign) in [("*P*_x", 1.0), ("*P*_{12}", 1.0), ("*x*^2", -1.0)] {
            let line = line(markup);
            assert!(line.runs[1].at.y * sign > 0.0, "{markup}");
            assert!(line.smallest() >= SMALLEST);
        }
        assert_eq!(Line::new("*P*_1", 2.0).unwrap().smallest(), SMALLEST);
        assert_eq!(line("*P*_x").runs[1].cut, Cut::Italic);
        assert_eq!(line("*P*_1").runs[1].cut, Cut::Upright);
    }

    #[test]
    fn an_accent_widens_nothing_and_sits_above_its_letter() {
        let (plain, hat) = (line("*x*"), line("*x\u{302}*"));
        assert_eq!(plain.width, hat.width);
        assert!(hat.ascent >= plain.ascent);
        let tops = |line: &Line| {
            line.outline(DVec2::ZERO)
                .unwrap()
                .points()
                .fold(0.0, |top, p| p.y.min(top))
        };
        assert!(tops(&hat) < tops(&plain) - 3.0);
        assert!(tops(&line("**N\u{302}**")) < tops(&line("**N**")) - 3.0);
    }

    #[test]
    fn what_does_not_parse_says_why() {
        for wrong in [
            "*x", "**x*", "{1|2", "{12}", "1}", "a|b", "x_", "x^*", "\\", "x₁", "x²", "\u{302}",
        ] {
            let error = Line::new(wrong, LABEL).unwrap_err();
            assert!(
                matches!(error, FigureError::Markup { .. }),
                "{wrong}: {error}"
            );
        }
        let error = Line::new("漢", LABEL).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the label '漢' has the character '漢' (U+6F22), which the figures' typeface lacks"
        );
    }

    #[test]
    fn names_from_outside_are_taken_literally() {
        let name = "my_mesh*{1}|^\\";
        assert_eq!(line(&escape(name)).plain, name);
    }
}
