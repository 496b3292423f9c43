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
//! a line break         a line below, from the same left edge
//! ```
//!
//! Nothing is smaller than [`SMALLEST`]: scripts and fractions of a small label shrink less. A character that the
//! typeface lacks is an error, never an empty box; the tiny Unicode scripts (₁, ²) are refused in favour of `_1`, `^2`.

mod setter;

use ombra_math::glam::DVec2;

use crate::error::FigureError;
use crate::font::{Cut, Glyph};
use crate::path::{Path, Rect, round};

/// Letter size (em) below which nobody in the back row reads, in thousandths of the shorter side.
pub const SMALLEST: f64 = 31.0;
/// Letter size of labels.
pub const LABEL: f64 = 45.0;
/// Letter size of ticks, captions and notes.
pub const NOTE: f64 = 37.0;

/// Scripts and stacked numbers, as a share of the label's size.
const SCRIPT: f64 = 0.7;
/// Height of the minus sign and of fraction bars above the baseline, in ems.
const MATH_AXIS: f64 = 0.314;
/// From one baseline to the next, in ems.
const LEADING: f64 = 1.3;
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
    /// Lays out `markup` with letters of `size`, a line below the other where it has line breaks.
    ///
    /// # Errors
    ///
    /// [`FigureError::Markup`], [`FigureError::MissingGlyph`].
    pub fn new(markup: &str, size: f64) -> Result<Line, FigureError> {
        let size = if size > SMALLEST { size } else { SMALLEST };
        let mut lines = markup.split('\n').map(|line| setter::set(line, size));
        let mut whole = match lines.next() {
            Some(first) => first?,
            None => setter::set("", size)?,
        };
        for (below, line) in lines.enumerate() {
            let mut line = line?;
            let down = LEADING * size * (below + 1) as f64;
            line.shift(0, 0, down);
            whole.width = whole.width.max(line.width);
            whole.descent = whole.descent.max(line.descent + down);
            whole.plain.push_str(", ");
            whole.plain.push_str(&line.plain);
            whole.runs.append(&mut line.runs);
            whole.bars.append(&mut line.bars);
        }
        Ok(whole)
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

/// Lines of at most `width`, broken at spaces; a longer word stands alone. As many as are needed, and about equally long.
///
/// # Errors
///
/// As [`Line::new`].
pub fn wrapped(markup: &str, size: f64, width: f64) -> Result<Vec<Line>, FigureError> {
    let mut lines = filled(markup, size, |line| line <= width)?;
    // Ever narrower, until that needs a line more or no line can be broken.
    while lines.len() > 1 {
        let most = widest(&lines);
        let narrower = filled(markup, size, |line| line < most)?;
        if narrower.len() > lines.len() || widest(&narrower) >= most {
            break;
        }
        lines = narrower;
    }
    Ok(lines)
}

/// Each line as full as `fits` allows.
fn filled(markup: &str, size: f64, fits: impl Fn(f64) -> bool) -> Result<Vec<Line>, FigureError> {
    let mut lines = Vec::new();
    let mut last: Option<(String, Line)> = None;
    for word in markup.split(' ') {
        let longer = match &last {
            Some((words, _)) => format!("{words} {word}"),
            None => word.to_owned(),
        };
        let line = Line::new(&longer, size)?;
        last = match last.take() {
            Some((_, before)) if !fits(line.width) => {
                lines.push(before);
                Some((word.to_owned(), Line::new(word, size)?))
            }
            _ => Some((longer, line)),
        };
    }
    lines.extend(last.map(|(_, line)| line));
    Ok(lines)
}

fn widest(lines: &[Line]) -> f64 {
    lines.iter().map(|line| line.width).fold(0.0, f64::max)
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
    fn a_line_break_begins_a_line_below() {
        let (one, two) = (line("*x* wide"), line("**L**"));
        let both = line("**L**\n*x* wide");
        assert_eq!(both.width, one.width.max(two.width));
        assert_eq!(
            (both.ascent, both.plain.as_str()),
            (two.ascent, "L, x wide")
        );
        assert_eq!(both.runs.len(), one.runs.len() + two.runs.len());
        let below = both.runs.last().unwrap();
        assert_eq!(
            (below.at.x, below.at.y),
            (one.runs[1].at.x, LEADING * LABEL)
        );
        // The upper line's letters end above the lower one's.
        assert!(both.descent > LEADING * LABEL && two.descent < (LEADING - CAPITALS) * LABEL);
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

    /// Against every way of breaking at two of the spaces.
    #[test]
    fn a_text_is_broken_into_few_and_even_lines() {
        let words = "one two three *four* five six seven eight nine ten eleven twelve";
        let width = |words: &[&str]| line(&words.join(" ")).width;
        let all: Vec<&str> = words.split(' ').collect();
        let most = 0.45 * width(&all);
        let lines = wrapped(words, LABEL, most).unwrap();
        assert_eq!(lines.len(), 3);
        let found = lines.iter().map(|line| line.width).fold(0.0, f64::max);
        for i in 1..all.len() {
            for j in i..all.len() {
                let parts = [&all[..i], &all[i..j], &all[j..]].map(width);
                assert!(found <= parts.into_iter().fold(0.0, f64::max));
            }
        }
        let plain: Vec<&str> = lines.iter().map(|line| line.plain.as_str()).collect();
        assert_eq!(plain.join(" "), line(words).plain);
        // What fits stays whole, and a word too long for any line stands alone.
        assert_eq!(wrapped(words, LABEL, width(&all)).unwrap().len(), 1);
        assert_eq!(wrapped("a verylongword b", LABEL, 40.0).unwrap().len(), 3);
    }

    #[test]
    fn names_from_outside_are_taken_literally() {
        let name = "my_mesh*{1}|^\\";
        assert_eq!(line(&escape(name)).plain, name);
    }
}
