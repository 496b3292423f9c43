//! The table of a report, as comma-separated values.

use ombra_math::work::Counter;

use super::{Answered, Measured, Report, Row};

/// The columns that every study has, before its kinds of fault and its counters.
pub(super) const COLUMNS: [&str; 17] = [
    "study",
    "sweep",
    "technique",
    "knob",
    "setting",
    "inputs",
    "units",
    "max error",
    "rms error",
    "missing share",
    "wrong share",
    "median ns a unit",
    "quartile distance ns",
    "lower quartile ns",
    "baseline",
    "ratio to baseline",
    "on front",
];

impl Report {
    /// The table, one row a technique and setting; counters that are zero everywhere have no column.
    ///
    /// Errors are written with all their digits, times with three after the point. Times and what follows from them
    /// (ratio, front) differ from run to run; nothing else does.
    #[must_use]
    pub fn csv(&self) -> String {
        let all = || self.sweeps.iter().flat_map(Measured::rows);
        let is_moved = |counter: &Counter| all().any(|row| row.work.get(*counter) > 0);
        let counters: Vec<Counter> = Counter::ALL.iter().copied().filter(is_moved).collect();
        let faults = all().next().map_or(&[][..], |row| &row.faults);
        let mut head: Vec<String> = COLUMNS.map(str::to_owned).into();
        head.extend(faults.iter().map(|(kind, _)| (*kind).to_owned()));
        head.extend(counters.iter().map(|c| c.name().to_owned()));
        let mut csv = line(&head);
        for sweep in &self.sweeps {
            for question in &sweep.questions {
                for row in &question.rows {
                    csv.push_str(&line(&self.cells(sweep, question, row, &counters)));
                }
            }
        }
        csv
    }

    fn cells(
        &self,
        sweep: &Measured,
        question: &Answered,
        row: &Row,
        counters: &[Counter],
    ) -> Vec<String> {
        let baseline = question.rows.first().map_or("", |first| first.technique);
        let mut cells: Vec<String> = [
            self.study.to_owned(),
            sweep.name.to_owned(),
            row.technique.to_owned(),
            sweep.knob.to_owned(),
            format!("{:e}", row.setting),
            question.inputs.clone(),
            question.units.to_string(),
            format!("{:e}", row.deviation.max),
            format!("{:e}", row.deviation.rms),
            row.deviation.missing_share().to_string(),
            row.deviation.wrong_share().to_string(),
            format!("{:.3}", row.nanoseconds.median),
            format!("{:.3}", row.nanoseconds.spread()),
            format!("{:.3}", row.nanoseconds.lower),
            baseline.to_owned(),
            format!("{:.3}", row.ratio),
            if row.on_front { "yes" } else { "no" }.to_owned(),
        ]
        .into();
        cells.extend(row.faults.iter().map(|(_, number)| number.to_string()));
        cells.extend(counters.iter().map(|&c| row.work.get(c).to_string()));
        cells
    }
}

/// One line of comma-separated values, quoted where a comma, a quote or a line break asks for it (RFC 4180).
fn line(cells: &[String]) -> String {
    let quoted = |cell: &String| {
        if cell.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", cell.replace('"', "\"\""))
        } else {
            cell.clone()
        }
    };
    let quoted: Vec<String> = cells.iter().map(quoted).collect();
    quoted.join(",") + "\n"
}
