//! A report from its table: charts and advice are drawn anew without a run.

use std::collections::BTreeMap;

use ombra_math::work::{Count, Counter, Work};

use super::table::COLUMNS;
use super::{Answered, Measured, Report, Row};
use crate::deviation::Deviation;
use crate::error::TradeError;
use crate::statistics::Quartiles;
use crate::study::Study;

/// The one column that tables of earlier runs lack.
const LATER: &str = "lower quartile ns";

impl Report {
    /// What the table of a run of `study` says, as [`csv`](Self::csv) writes it.
    ///
    /// # Properties
    ///
    /// Errors, counts and the front are those of the run; times have the three digits after the point that a table has.
    /// The number of answers asked for is not in the table: the least that gives the shares of missing and wrong ones takes
    /// its place. Where a table has the quartiles' distance alone, half of it lies on either side of the median.
    ///
    /// # Errors
    ///
    /// [`TradeError::Table`] for what is no such table, naming the line.
    pub fn read(study: &Study, csv: &str) -> Result<Self, TradeError> {
        let failed = |reason| TradeError::Table {
            file: study.id.to_owned(),
            reason,
        };
        read(study, csv).map_err(failed)
    }
}

fn read(study: &Study, csv: &str) -> Result<Report, String> {
    let mut lines = cells(csv)?.into_iter();
    let head = lines.next().ok_or("the table is empty")?;
    for column in COLUMNS.iter().filter(|column| **column != LATER) {
        if !head.iter().any(|name| name == column) {
            return Err(format!("the table has no column '{column}'"));
        }
    }
    let mut names = Names::default();
    let mut sweeps: Vec<Measured> = Vec::new();
    for (i, cells) in lines.enumerate() {
        let line = Line {
            number: i + 2,
            head: &head,
            cells: &cells,
        };
        if cells.len() != head.len() {
            return Err(line.wrong(&format!(
                "has {} cells, the first line {}",
                cells.len(),
                head.len()
            )));
        }
        if line.text("study")? != study.id {
            return Err(line.wrong(&format!("is of the study '{}'", line.text("study")?)));
        }
        let (sweep, knob) = (
            names.kept(line.text("sweep")?),
            names.kept(line.text("knob")?),
        );
        let row = row(study, &line, &mut names)?;
        if sweeps.last().is_none_or(|last| last.name != sweep) {
            sweeps.push(Measured {
                name: sweep,
                knob,
                questions: Vec::new(),
            });
        }
        let (inputs, units) = (line.text("inputs")?.to_owned(), line.number("units")?);
        let Some(sweep) = sweeps.last_mut() else {
            continue;
        };
        // A question asks no technique twice at one setting.
        let is_same = |last: &Answered| {
            let mut rows = last.rows.iter();
            last.inputs == inputs
                && last.units == units
                && !rows
                    .any(|other| other.technique == row.technique && other.setting == row.setting)
        };
        match sweep.questions.last_mut().filter(|last| is_same(last)) {
            Some(question) => question.rows.push(row),
            None => sweep.questions.push(Answered {
                inputs,
                units,
                rows: vec![row],
            }),
        }
    }
    Ok(Report::new(study, sweeps))
}

fn row(study: &Study, line: &Line, names: &mut Names) -> Result<Row, String> {
    let (missing, wrong) = (line.number("missing share")?, line.number("wrong share")?);
    let deviation = deviation(
        missing,
        wrong,
        line.number("max error")?,
        line.number("rms error")?,
    )
    .ok_or_else(|| {
        line.wrong(&format!(
            "has shares that are none: {missing} missing, {wrong} wrong"
        ))
    })?;
    let (median, spread): (f64, f64) = (
        line.number("median ns a unit")?,
        line.number("quartile distance ns")?,
    );
    let lower = if line.head.iter().any(|name| name == LATER) {
        line.number(LATER)?
    } else {
        median - 0.5 * spread
    };
    let (mut work, mut faults) = (Work::default(), Vec::new());
    // Behind the columns that all tables have stand kinds of fault, and counters.
    for (name, cell) in line.head.iter().zip(line.cells) {
        if COLUMNS.contains(&name.as_str()) {
            continue;
        }
        let number = line.parsed(name, cell)?;
        match Counter::ALL.iter().find(|counter| counter.name() == name) {
            Some(counter) => work.add(*counter, number),
            None => faults.push((names.kept(name), number)),
        }
    }
    Ok(Row {
        technique: names.kept(line.text("technique")?),
        setting: line.number("setting")?,
        error: study
            .errors
            .first()
            .map_or(f64::NAN, |measure| measure.of(&deviation)),
        deviation,
        faults,
        work,
        nanoseconds: Quartiles {
            lower,
            median,
            upper: lower + spread,
        },
        ratio: line.number("ratio to baseline")?,
        on_front: line.text("on front")? == "yes",
    })
}

/// A line of a table.
struct Line<'a> {
    number: usize,
    head: &'a [String],
    cells: &'a [String],
}

impl Line<'_> {
    fn wrong(&self, what: &str) -> String {
        format!("line {} {what}", self.number)
    }

    fn text(&self, column: &str) -> Result<&str, String> {
        let named = self
            .head
            .iter()
            .zip(self.cells)
            .find(|(name, _)| *name == column);
        let cell = named.ok_or_else(|| self.wrong(&format!("has no '{column}'")))?;
        Ok(cell.1)
    }

    fn number<T: core::str::FromStr>(&self, column: &str) -> Result<T, String> {
        self.parsed(column, self.text(column)?)
    }

    fn parsed<T: core::str::FromStr>(&self, column: &str, cell: &str) -> Result<T, String> {
        cell.parse().map_err(|_| {
            self.wrong(&format!(
                "has '{cell}' as '{column}', where a number belongs"
            ))
        })
    }
}

/// Names that live as long as the program, like those of the studies: each is kept once a table, and a table has a dozen.
#[derive(Default)]
struct Names(BTreeMap<String, &'static str>);

impl Names {
    fn kept(&mut self, name: &str) -> &'static str {
        self.0
            .entry(name.to_owned())
            .or_insert_with(|| name.to_owned().leak())
    }
}

/// The least numbers of answers with these shares; none if the shares are none.
fn deviation(missing: f64, wrong: f64, max: f64, rms: f64) -> Option<Deviation> {
    let ((gone, of_gone), (bad, of_bad)) = (fraction(missing)?, fraction(wrong)?);
    let asked = of_gone.checked_mul(of_bad / greatest_common_divisor(of_gone, of_bad))?;
    let (missing, wrong) = (gone * (asked / of_gone), bad * (asked / of_bad));
    Some(Deviation {
        asked: usize::try_from(asked).ok()?,
        missing: usize::try_from(missing).ok()?,
        // Those that were given.
        wrong: usize::try_from(wrong.checked_sub(missing)?).ok()?,
        max,
        rms,
    })
}

/// The least numbers n ≤ d whose quotient is `share`, to the last bit, by its continued fraction.
fn fraction(share: f64) -> Option<(u64, u64)> {
    if !(0.0..=1.0).contains(&share) {
        return None;
    }
    let (mut n, mut d) = ((1_u64, 0_u64), (0_u64, 1_u64));
    let mut rest = share;
    // The 40th denominator is beyond any number of answers.
    for _ in 0..40 {
        let whole = rest.floor();
        // 0 ≤ whole: it is 0 at first, then at least 1; a cast takes what is too large for the largest.
        let next = |(now, before): (u64, u64)| {
            (whole as u64)
                .checked_mul(now)?
                .checked_add(before)
                .map(|next| (next, now))
        };
        (n, d) = (next(n)?, next(d)?);
        if n.0 as f64 / d.0 as f64 == share {
            return Some((n.0, d.0));
        }
        rest = 1.0 / (rest - whole);
    }
    None
}

fn greatest_common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// The cells of comma-separated values (RFC 4180).
fn cells(csv: &str) -> Result<Vec<Vec<String>>, String> {
    let mut lines = Vec::new();
    let (mut line, mut cell) = (Vec::new(), String::new());
    let mut quoted = false;
    let mut rest = csv.chars().peekable();
    while let Some(character) = rest.next() {
        match character {
            '"' if quoted && rest.peek() == Some(&'"') => {
                cell.push('"');
                rest.next();
            }
            '"' => quoted = !quoted,
            ',' if !quoted => line.push(core::mem::take(&mut cell)),
            '\r' if !quoted && rest.peek() == Some(&'\n') => {}
            '\n' if !quoted => {
                line.push(core::mem::take(&mut cell));
                lines.push(core::mem::take(&mut line));
            }
            _ => cell.push(character),
        }
    }
    if quoted {
        return Err("the table ends within quotation marks".to_owned());
    }
    if !cell.is_empty() || !line.is_empty() {
        line.push(cell);
        lines.push(line);
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_fractions_of_the_fewest_answers() {
        for d in [1_u64, 2, 3, 97, 4000, 262_144, 20_000_002] {
            for n in [0, 1, d / 3, d / 2, d - 1, d] {
                let (found, of) = fraction(n as f64 / d as f64).unwrap();
                assert_eq!(
                    u128::from(found) * u128::from(d),
                    u128::from(n) * u128::from(of),
                    "{n}/{d}"
                );
                assert_eq!(greatest_common_divisor(found, of), 1);
            }
        }
        for none in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
            assert_eq!(fraction(none), None);
        }
        // More are missing than are wrong in all.
        assert_eq!(deviation(0.5, 0.25, 0.0, 0.0), None);
        let both = deviation(0.25, 1.0 / 3.0, 1.0, 0.5).unwrap();
        assert_eq!((both.asked, both.missing, both.wrong), (12, 3, 1));
    }

    #[test]
    fn quoted_cells() {
        assert_eq!(
            cells("a,\"b, \"\"c\"\"\"\r\n\"d\ne\",\n").unwrap(),
            [["a", "b, \"c\""], ["d\ne", ""]]
        );
        assert!(cells("\"a").is_err());
        assert_eq!(cells("a").unwrap(), [["a"]]);
        assert!(cells("").unwrap().is_empty());
    }
}
