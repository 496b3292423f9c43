//! Advice from numbers: which technique to take where, at which setting, and what it costs and loses.

use core::fmt;

use crate::report::{Measured, Row};

/// What a study says to somebody who has to choose.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Advice {
    /// Whose time is 1.
    pub baseline: &'static str,
    /// From the most usual need on.
    pub rows: Vec<Choice>,
}

/// What to take for one need.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What is needed: `no pixel wrong`.
    pub need: String,
    /// The technique to take.
    pub method: String,
    /// Where, or with its knob at what.
    pub setting: String,
    /// Its time over the baseline's.
    pub cost: String,
    /// What is lost.
    pub loss: String,
}

impl Choice {
    /// Its cells, in the order of the table.
    #[must_use]
    pub fn cells(&self) -> [&str; 5] {
        [
            &self.need,
            &self.method,
            &self.setting,
            &self.cost,
            &self.loss,
        ]
    }
}

/// A table in Markdown, its columns of one width, so that it reads as it stands too; nothing of no advice.
impl fmt::Display for Advice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.rows.is_empty() {
            return Ok(());
        }
        let cost = format!("time ({} = 1)", self.baseline);
        let head = ["need", "method", "setting", &cost, "loss"];
        let width = |column: usize| {
            let cells = self.rows.iter().map(Choice::cells).chain([head]);
            let letters = cells.filter_map(|row| Some(row.get(column)?.chars().count()));
            letters.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..head.len()).map(width).collect();
        let line = |f: &mut fmt::Formatter<'_>, row: [&str; 5]| {
            for (cell, width) in row.iter().zip(&widths) {
                write!(f, "| {cell:<width$} ")?;
            }
            writeln!(f, "|")
        };
        line(f, head)?;
        for width in &widths {
            write!(f, "| {} ", "-".repeat(*width))?;
        }
        writeln!(f, "|")?;
        self.rows.iter().try_for_each(|row| line(f, row.cells()))
    }
}

/// What is lost by errors up to `most`, as `words` say it; nothing where there are none.
#[must_use]
pub fn lost(most: f64, words: impl FnOnce(f64) -> String) -> String {
    if most == 0.0 {
        "nothing".to_owned()
    } else {
        words(most)
    }
}

/// A range of a sweep over which one technique is the one to take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The cheapest technique that keeps the tolerance; `None` where none does.
    pub technique: Option<&'static str>,
    /// The easiest setting of the range.
    pub from: f64,
    /// The hardest.
    pub to: f64,
    /// The smallest and the largest of its times over the baseline's; NaN where there is no technique.
    pub ratios: (f64, f64),
}

/// What is cheaper by less than this factor is not worth another name in a sentence.
const WORTH_A_CHANGE: f64 = 1.25;

/// Divides a sweep into the ranges over which the cheapest technique that keeps `tolerance` is the same.
///
/// # Properties
///
/// A technique keeps the tolerance at a setting when its error there, by the study's first measure, does not exceed it.
/// Of those that do, the cheapest is taken; of several that take less than a quarter longer, the one with the least
/// [`typical_ratio`](Measured::typical_ratio). It is kept until it misses the tolerance, or takes over a quarter longer
/// than another at two settings running, or at the last: one noisy time in between does not make the advice waver.
#[must_use]
pub fn stretches(sweep: &Measured, tolerance: f64) -> Vec<Stretch> {
    let techniques = sweep.techniques();
    // Of several settings of one technique in one question, the cheapest that keeps it.
    let cheapest = |q: usize, technique: Option<&str>| -> Option<&Row> {
        let rows = sweep.questions.get(q)?.rows.iter();
        let asked = rows.filter(|row| technique.is_none_or(|name| row.technique == name));
        let good = asked.filter(|row| row.error <= tolerance);
        good.min_by(|a, b| a.ratio.total_cmp(&b.ratio))
    };
    let is_beaten = |q: usize, technique: &str| {
        let (own, best) = (cheapest(q, Some(technique)), cheapest(q, None));
        own.zip(best)
            .is_some_and(|(own, best)| own.ratio > WORTH_A_CHANGE * best.ratio)
    };
    let choose = |q: usize| {
        let own = techniques.iter().filter_map(|name| cheapest(q, Some(name)));
        let about_the_cheapest = own.filter(|row| !is_beaten(q, row.technique));
        about_the_cheapest.min_by(|a, b| {
            let typical = |row: &Row| sweep.typical_ratio(row.technique);
            typical(a).total_cmp(&typical(b))
        })
    };
    let mut stretches: Vec<Stretch> = Vec::new();
    for (q, question) in sweep.questions.iter().enumerate() {
        let before = stretches.last().and_then(|last| last.technique);
        let goes_on = q + 1 < sweep.questions.len();
        let is_beaten_from_here =
            |name: &str| is_beaten(q, name) && (!goes_on || is_beaten(q + 1, name));
        let stays = before.filter(|name| !is_beaten_from_here(name));
        let own = stays.and_then(|name| cheapest(q, Some(name)));
        let best = own.or_else(|| choose(q));
        let Some(setting) = best.or(question.rows.first()).map(|row| row.setting) else {
            continue;
        };
        let technique = best.map(|row| row.technique);
        let ratio = best.map_or(f64::NAN, |row| row.ratio);
        match stretches.last_mut() {
            Some(last) if last.technique == technique => {
                last.to = setting;
                last.ratios = (last.ratios.0.min(ratio), last.ratios.1.max(ratio));
            }
            _ => stretches.push(Stretch {
                technique,
                from: setting,
                to: setting,
                ratios: (ratio, ratio),
            }),
        }
    }
    stretches
}

impl Stretch {
    /// Its technique, in words.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.technique.unwrap_or("none that is measured here")
    }

    /// From the easiest to the hardest setting, each as `number` writes it: `10⁵ to 10¹²`.
    #[must_use]
    pub fn range(&self, number: fn(f64) -> String) -> String {
        between((self.from, self.to), number)
    }
}

/// `0.5`, or `0.5 to 1.4` where the two ends read differently.
#[must_use]
pub fn between(ends: (f64, f64), number: fn(f64) -> String) -> String {
    let (low, high) = (number(ends.0), number(ends.1));
    if low == high {
        low
    } else {
        format!("{low} to {high}")
    }
}

/// The least and the greatest; (∞, −∞) of none.
#[must_use]
pub fn extent(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), x: f64| (low.min(x), high.max(x));
    values.into_iter().fold(none, wider)
}

/// `a`, `a and b`, `a, b and c`.
#[must_use]
pub fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// A power of ten as people write it: `10⁻⁹`; other numbers with two digits, `2.5·10⁻⁹`.
#[must_use]
pub fn power_of_ten(x: f64) -> String {
    let text = format!("{x:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let power: String = exponent
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => digit
                .to_digit(10)
                .and_then(|d| char::from_u32('⁰' as u32 + d))
                .unwrap_or(digit),
        })
        .collect();
    match (digits, exponent) {
        ("1.0", "0") => "1".to_owned(),
        ("1.0", "1") => "10".to_owned(),
        ("1.0", _) => format!("10{power}"),
        (digits, "0") => digits.trim_end_matches(".0").to_owned(),
        (digits, _) => format!("{}·10{power}", digits.trim_end_matches(".0")),
    }
}

/// A number with two digits: `0.042`, `7.6`, `3400`; by its power of ten where it is small or large, `4.2·10⁻⁴`.
#[must_use]
pub fn digits(x: f64) -> String {
    let power = power_of_ten(x);
    if !(1e-3..1e4).contains(&x.abs()) {
        return power;
    }
    // Rounded to the two digits once, by the same text.
    let rounded: f64 = format!("{x:.1e}").parse().unwrap_or(x);
    rounded.to_string()
}

/// A setting: whole numbers below 10⁴ as they are, others with two digits.
#[must_use]
pub fn number(setting: f64) -> String {
    if setting.fract() == 0.0 && setting.abs() < 1e4 {
        setting.to_string()
    } else {
        digits(setting)
    }
}

/// A ratio of times with one or two digits: `0.04`, `0.6`, `49`.
#[must_use]
pub fn times(ratio: f64) -> String {
    if ratio < 0.095 {
        format!("{ratio:.2}")
    } else if ratio < 9.95 {
        format!("{ratio:.1}")
    } else {
        format!("{ratio:.0}")
    }
}

/// A share in percent with two digits, `0.0031 %`, `4.2 %`, `87 %`; near all, two digits of what is missing: `99.87 %`.
///
/// Only nothing is 0 %, and only all is 100 %.
#[must_use]
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let digits = if percent > 99.0 && percent < 100.0 {
        100.0 - percent
    } else {
        percent
    };
    // The power of ten of the first digit, after rounding to two.
    let text = format!("{digits:.1e}");
    let exponent = text
        .split_once('e')
        .and_then(|(_, e)| e.parse::<i32>().ok());
    let decimals = (1 - exponent.unwrap_or(1)).max(0) as usize;
    match percent {
        0.0 => "0 %".to_owned(),
        100.0 => "100 %".to_owned(),
        _ => format!("{percent:.decimals$} %"),
    }
}

#[cfg(test)]
mod tests;
