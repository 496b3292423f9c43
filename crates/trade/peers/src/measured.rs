//! What a race measured, as a table and as JSON.

use std::fmt;

use serde_json::{Value, json};

/// A median and the quartiles around it.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    pub median: f64,
    pub low: f64,
    pub high: f64,
}

impl Spread {
    /// NaN of no values.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = values.collect();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().saturating_sub(1);
        let at = |index: usize| sorted.get(index).copied().unwrap_or(f64::NAN);
        Self {
            median: at(last / 2),
            low: at(last / 4),
            high: at(last - last / 4),
        }
    }

    fn json(&self) -> Value {
        json!({ "median": self.median, "low": self.low, "high": self.high })
    }
}

/// `1.23 (1.20–1.26)`.
impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let decimals = if self.median < 100.0 { 2 } else { 0 };
        let [median, low, high] =
            [self.median, self.low, self.high].map(|v| format!("{v:.decimals$}"));
        let text = format!("{median} ({low}–{high})");
        f.pad(&text)
    }
}

/// A number that shows what was done.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    pub name: &'static str,
    pub value: f64,
    /// The largest relative difference from ours at which the work is still the same; `None`: it may be any.
    pub within: Option<f64>,
}

impl Shown {
    /// Whether a contestant that shows `a` did the work of one that shows `b`.
    pub fn agree(a: &[Self], b: &[Self]) -> bool {
        a.len() == b.len()
            && (a.iter().zip(b)).all(|(a, b)| {
                let difference = (a.value - b.value).abs();
                (a.within).is_none_or(|within| difference <= within * b.value.abs())
            })
    }
}

/// `area 0.497661532`, `lit 1 012 345`.
impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, value, .. } = *self;
        if value.fract() == 0.0 && value.abs() < 1e15 {
            write!(f, "{name} {}", grouped(value as i64))
        } else {
            write!(f, "{name} {value:.9}")
        }
    }
}

/// `1 012 345`.
fn grouped(n: i64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) && !text.ends_with('-') {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    Limit,
    /// With what is wrong with its results, if anything.
    Peer {
        fault: Option<String>,
    },
    Ours,
}

/// What a goal is measured against.
#[derive(Clone, Copy, Debug)]
pub enum Against {
    Limit,
    /// The fastest peer that is right and does the same work.
    FastestPeer,
    /// The fastest peer, right or wrong.
    AnyPeer,
    /// The peer of this name.
    Peer(&'static str),
}

/// "To reach".
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    pub at_least: f64,
    pub against: Against,
}

#[derive(Clone, Debug)]
pub struct Entry {
    pub name: String,
    pub role: Role,
    /// Items a second.
    pub throughput: f64,
    pub of_limit: Option<Spread>,
    /// For each of ours: how many times as fast as this.
    pub ours_over_it: Vec<(String, Spread)>,
    /// Whether it was measured once, not in each round.
    pub once: bool,
    pub shown: Vec<Shown>,
    /// Whether the numbers shown agree with the first of ours.
    pub same_work: bool,
}

#[derive(Clone, Debug)]
pub struct Verdict {
    pub ours: String,
    pub goal: Goal,
    pub rival: String,
    pub ratio: Spread,
    pub reached: bool,
}

#[derive(Clone, Debug)]
pub struct Measured {
    pub row: String,
    pub work: String,
    pub unit: &'static str,
    pub items: f64,
    pub rounds: usize,
    pub entries: Vec<Entry>,
    pub verdicts: Vec<Verdict>,
    pub notes: Vec<String>,
}

impl Measured {
    /// Contestants that did something else, though nothing was known to be wrong with them.
    pub fn impostors(&self) -> impl Iterator<Item = &Entry> {
        (self.entries.iter())
            .filter(|e| !e.same_work && !matches!(e.role, Role::Peer { fault: Some(_) }))
    }

    /// One line of JSON.
    pub fn json(&self) -> Value {
        let entries: Vec<Value> = (self.entries.iter())
            .map(|e| {
                let (role, fault) = match &e.role {
                    Role::Limit => ("limit", None),
                    Role::Peer { fault } => ("peer", fault.clone()),
                    Role::Ours => ("ours", None),
                };
                let ours: serde_json::Map<_, _> = (e.ours_over_it.iter())
                    .map(|(name, ratio)| (name.clone(), ratio.json()))
                    .collect();
                let shown: serde_json::Map<_, _> = (e.shown.iter())
                    .map(|s| (s.name.to_owned(), s.value.into()))
                    .collect();
                json!({
                    "name": e.name, "role": role, "fault": fault, "items_per_second": e.throughput,
                    "of_limit": e.of_limit.map(|s| s.json()), "ours_over_it": ours, "shown": shown,
                    "same_work": e.same_work, "once": e.once,
                })
            })
            .collect();
        let goals: Vec<Value> = (self.verdicts.iter())
            .map(|v| {
                json!({
                    "ours": v.ours, "rival": v.rival, "at_least": v.goal.at_least,
                    "ratio": v.ratio.json(), "reached": v.reached,
                })
            })
            .collect();
        json!({
            "row": self.row, "work": self.work, "unit": self.unit, "items": self.items,
            "rounds": self.rounds, "entries": entries, "goals": goals, "notes": self.notes,
        })
    }
}

/// The table.
impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.row, self.work)?;
        let ours: Vec<&str> = (self.entries.iter())
            .filter(|e| e.role == Role::Ours)
            .map(|e| e.name.as_str())
            .collect();
        let columns: Vec<String> = ours.iter().map(|name| format!("{name} ÷ it")).collect();
        let widths: Vec<usize> = columns.iter().map(|c| c.chars().count().max(18)).collect();
        let unit = format!("M{}/s", self.unit);
        write!(f, "  {:<34} {unit:>11} {:>9}", "", "of limit")?;
        for (column, &width) in columns.iter().zip(&widths) {
            write!(f, "  {column:>width$}")?;
        }
        writeln!(f, "  shows")?;
        for entry in &self.entries {
            line(f, entry, &widths)?;
        }
        for note in &self.notes {
            writeln!(f, "  {note}")?;
        }
        for verdict in &self.verdicts {
            writeln!(f, "  to reach: {verdict}")?;
        }
        Ok(())
    }
}

fn line(f: &mut fmt::Formatter<'_>, entry: &Entry, widths: &[usize]) -> fmt::Result {
    let name = match &entry.role {
        Role::Limit => format!("limit: {}", entry.name),
        Role::Peer { fault: None } => entry.name.clone(),
        Role::Peer { fault: Some(_) } => format!("{} (wrong)", entry.name),
        Role::Ours => format!("ours: {}", entry.name),
    };
    let throughput = digits(entry.throughput / 1e6);
    let share = (entry.of_limit).map_or(String::new(), |s| digits(100.0 * s.median) + " %");
    write!(f, "  {name:<34} {throughput:>11} {share:>9}")?;
    for (i, &width) in widths.iter().enumerate() {
        match entry.ours_over_it.get(i) {
            Some((name, ratio)) if *name != entry.name => write!(f, "  {ratio:>width$}")?,
            _ => write!(f, "  {:>width$}", "")?,
        }
    }
    if entry.role != Role::Limit {
        let shown: Vec<String> = entry.shown.iter().map(Shown::to_string).collect();
        write!(f, "  {}", shown.join(", "))?;
    }
    if entry.once {
        write!(f, "; so slow that it ran once")?;
    }
    if !entry.same_work {
        write!(f, "  NOT THE SAME WORK")?;
    }
    writeln!(f)?;
    if let Role::Peer { fault: Some(fault) } = &entry.role {
        writeln!(f, "    wrong: {fault}")?;
    }
    Ok(())
}

/// At least three significant ones.
fn digits(value: f64) -> String {
    let decimals = (2 - value.abs().log10().floor().clamp(-3.0, 2.0) as i32) as usize;
    format!("{value:.decimals$}")
}

/// `draw ≥ 1.00 × clipline (fastest correct peer): 1.20 (1.18–1.22), reached`.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let which = match self.goal.against {
            Against::Limit => " (the limit)",
            Against::FastestPeer => " (the fastest correct peer)",
            Against::AnyPeer => " (the fastest peer, right or wrong)",
            Against::Peer(_) => "",
        };
        write!(
            f,
            "{} ≥ {:.2} × {}{which}: {}, {}",
            self.ours,
            self.goal.at_least,
            self.rival,
            self.ratio,
            if self.reached {
                "reached"
            } else {
                "NOT REACHED"
            }
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_is_median_and_quartiles() {
        let Spread { median, low, high } = Spread::of([5.0, 1.0, 4.0, 2.0, 3.0].into_iter());
        assert_eq!([low, median, high], [2.0, 3.0, 4.0]);
        assert!(Spread::of([].into_iter()).median.is_nan());
    }

    #[test]
    fn the_same_work_is_told_from_other_work() {
        let shown = |value, within| Shown {
            name: "lit",
            value,
            within,
        };
        let agree = |a, b, within| Shown::agree(&[shown(a, within)], &[shown(b, within)]);
        assert!(agree(100.9, 100.0, Some(0.01)) && !agree(101.1, 100.0, Some(0.01)));
        assert!(agree(0.0, 0.0, Some(0.0)) && agree(7.0, 0.0, None));
        assert!(!agree(f64::NAN, 1.0, Some(0.5)));
        assert!(!Shown::agree(&[], &[shown(1.0, None)]));
    }

    #[test]
    fn numbers_are_readable() {
        let texts = [31_700.4, 379.9, 16.97, 0.0093, 0.0].map(digits);
        assert_eq!(texts, ["31700", "380", "17.0", "0.00930", "0.00000"]);
        let texts = [0, 999, -1000, 1_234_567].map(grouped);
        assert_eq!(texts, ["0", "999", "-1 000", "1 234 567"]);
    }
}
