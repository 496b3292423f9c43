//! The results of a study: table, charts, advice.

use core::fmt::Write as _;
use std::path::{Path, PathBuf};

use ombra_figures::drawing::Drawing;
use ombra_figures::style::{Format, Style};
use ombra_figures::{png, svg, write};
use ombra_math::work::{Counter, Work};

use crate::charts;
use crate::deviation::{Deviation, Measure};
use crate::error::TradeError;
use crate::statistics::Quartiles;

/// What a run of a study found.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The study's id.
    pub study: &'static str,
    /// The study in one line.
    pub summary: &'static str,
    /// One of the things worked on.
    pub unit: &'static str,
    /// How errors are measured; the first is what the front goes by.
    pub errors: &'static [Measure],
    /// Which counted work has a chart.
    pub charted_work: &'static [Counter],
    /// Its sweeps.
    pub sweeps: Vec<Measured>,
    /// One sentence from the numbers.
    pub advice: String,
}

/// A sweep with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Part of file names.
    pub name: &'static str,
    /// What is turned.
    pub knob: &'static str,
    /// The place of the question whose cost is charted against its error.
    pub charted: usize,
    /// From easy to hard.
    pub questions: Vec<Answered>,
}

/// A question with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Answered {
    /// What the inputs are.
    pub inputs: String,
    /// How many units one answer works on.
    pub units: usize,
    /// One row a case; the first is the baseline.
    pub rows: Vec<Row>,
}

/// A technique with its knob at one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The technique.
    pub technique: &'static str,
    /// Its knob's setting.
    pub setting: f64,
    /// Its error by the study's first measure: the same on every run.
    pub error: f64,
    /// Its errors.
    pub deviation: Deviation,
    /// How many of its answers have faults of certain kinds.
    pub faults: Vec<(&'static str, u64)>,
    /// Its counted work for all units: the same on every run.
    pub work: Work,
    /// Its time a unit, in nanoseconds.
    pub nanoseconds: Quartiles,
    /// Its time over the baseline's, the median of each round's ratio.
    pub ratio: f64,
    /// Whether no case of the same question is better in both time (ratio) and worst error.
    pub on_front: bool,
}

impl Measured {
    /// Its techniques, each once, in the order in which they first appear.
    #[must_use]
    pub fn techniques(&self) -> Vec<&'static str> {
        let mut techniques = Vec::new();
        for row in self.questions.iter().flat_map(|q| &q.rows) {
            if !techniques.contains(&row.technique) {
                techniques.push(row.technique);
            }
        }
        techniques
    }

    /// The rows of one technique, from easy to hard.
    pub fn rows_of(&self, technique: &str) -> impl Iterator<Item = &Row> {
        self.questions
            .iter()
            .flat_map(|q| &q.rows)
            .filter(move |row| row.technique == technique)
    }

    /// The first of `counters` that a technique moves anywhere in the sweep.
    #[must_use]
    pub fn first_moved(&self, technique: &str, counters: &[Counter]) -> Option<Counter> {
        let is_moved = |&what: &Counter| self.rows_of(technique).any(|row| row.work.get(what) > 0);
        counters.iter().copied().find(is_moved)
    }

    /// The median over the sweep of a technique's time over the baseline's.
    #[must_use]
    pub fn typical_ratio(&self, technique: &str) -> f64 {
        Quartiles::of(
            &self
                .rows_of(technique)
                .map(|row| row.ratio)
                .collect::<Vec<_>>(),
        )
        .median
    }
}

impl Report {
    /// The table, one row a technique and setting; counters that are zero everywhere have no column.
    ///
    /// Errors are written with all their digits, times with three after the point. Times and what follows from them
    /// (ratio, front) differ from run to run; nothing else does.
    #[must_use]
    pub fn csv(&self) -> String {
        let rows = || {
            self.sweeps
                .iter()
                .flat_map(|s| &s.questions)
                .flat_map(|q| &q.rows)
        };
        let counters: Vec<Counter> = Counter::ALL
            .iter()
            .copied()
            .filter(|&c| rows().any(|row| row.work.get(c) > 0))
            .collect();
        let mut head: Vec<String> = [
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
            "baseline",
            "ratio to baseline",
            "on front",
        ]
        .map(str::to_owned)
        .to_vec();
        let faults = rows().next().map_or(&[][..], |row| &row.faults);
        head.extend(faults.iter().map(|(kind, _)| (*kind).to_owned()));
        head.extend(counters.iter().map(|c| c.name().to_owned()));
        let mut csv = line(&head);
        for sweep in &self.sweeps {
            for question in &sweep.questions {
                for row in &question.rows {
                    let mut cells = vec![
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
                        question
                            .rows
                            .first()
                            .map_or("", |first| first.technique)
                            .to_owned(),
                        format!("{:.3}", row.ratio),
                        if row.on_front { "yes" } else { "no" }.to_owned(),
                    ];
                    cells.extend(row.faults.iter().map(|(_, number)| number.to_string()));
                    cells.extend(counters.iter().map(|&c| row.work.get(c).to_string()));
                    csv.push_str(&line(&cells));
                }
            }
        }
        csv
    }

    /// The advice as Markdown, with what it was measured on.
    #[must_use]
    pub fn advice_markdown(&self) -> String {
        let mut text = format!("{}\n", self.advice);
        let cases: usize = self
            .sweeps
            .iter()
            .flat_map(|s| &s.questions)
            .map(|q| q.rows.len())
            .sum();
        let _ = writeln!(
            text,
            "\n<!-- Written by `ombra trade {}` from {cases} measured cases; the table is results.csv. -->",
            self.study
        );
        text
    }

    /// The charts: for each sweep the errors, the time and perhaps the counted work over the knob, and cost against
    /// error with the Pareto front.
    ///
    /// # Errors
    ///
    /// [`TradeError::Figure`] when a chart cannot be drawn.
    pub fn charts(&self, style: &Style) -> Result<Vec<Drawing>, TradeError> {
        charts::draw(self, style)
    }

    /// Writes `results.csv`, `advice.md` and the charts into `folder`, and names the files.
    ///
    /// # Errors
    ///
    /// [`TradeError::Figure`]. Everything is drawn before the first file is written, and the files come together, as by
    /// [`write::together`].
    pub fn write(
        &self,
        folder: &Path,
        style: &Style,
        formats: &[Format],
    ) -> Result<Vec<PathBuf>, TradeError> {
        let mut files = vec![
            (folder.join("results.csv"), self.csv().into_bytes()),
            (
                folder.join("advice.md"),
                self.advice_markdown().into_bytes(),
            ),
        ];
        for drawing in self.charts(style)? {
            let name = drawing.id.rsplit('/').next().unwrap_or(&drawing.id);
            for &format in formats {
                let bytes = match format {
                    Format::Svg => svg::svg(&drawing)?.into_bytes(),
                    Format::Png => png::png(&drawing)?,
                };
                files.push((folder.join(format!("{name}.{format}")), bytes));
            }
        }
        let pairs: Vec<(&Path, &[u8])> = files
            .iter()
            .map(|(path, bytes)| (path.as_path(), bytes.as_slice()))
            .collect();
        write::together(&pairs)?;
        Ok(files.into_iter().map(|(path, _)| path).collect())
    }
}

/// One line of comma-separated values, quoted where a comma, a quote or a line break asks for it (RFC 4180).
fn line(cells: &[String]) -> String {
    let quoted: Vec<String> = cells
        .iter()
        .map(|cell| {
            if cell.contains([',', '"', '\n', '\r']) {
                format!("\"{}\"", cell.replace('"', "\"\""))
            } else {
                cell.clone()
            }
        })
        .collect();
    quoted.join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_math::work::Count;
    use std::fs;

    /// Three techniques at two settings; `exact` errs by 0 and is slow, `gone` answers half.
    fn report() -> Report {
        let question = |setting: f64| {
            let row = |technique, ratio, errors: [Option<f64>; 2], on_front| {
                let mut work = Work::default();
                work.add(Counter::Taps, 3);
                Row {
                    technique,
                    setting,
                    error: Deviation::of(errors).worst(),
                    deviation: Deviation::of(errors),
                    faults: vec![("gaps", 5)],
                    work,
                    nanoseconds: Quartiles::of(&[ratio, 2.0 * ratio]),
                    ratio,
                    on_front,
                }
            };
            Answered {
                inputs: format!("light, \"{setting}\""),
                units: 2,
                rows: vec![
                    row("plain", 1.0, [Some(setting), Some(0.0)], true),
                    row("exact", 9.0, [Some(0.0), Some(0.0)], true),
                    row("gone", 0.5, [Some(1e-9), None], false),
                ],
            }
        };
        Report {
            study: "made-up",
            summary: "Made up",
            unit: "vertex",
            errors: &[Measure::Largest("error"), Measure::Share("wrong answers")],
            charted_work: &[Counter::Fragments, Counter::Taps],
            sweeps: vec![Measured {
                name: "sweep",
                knob: "knob",
                charted: 0,
                questions: vec![question(0.25), question(256.0)],
            }],
            advice: "Use plain.".to_owned(),
        }
    }

    #[test]
    fn the_table() {
        let csv = report().csv();
        let lines: Vec<_> = csv.lines().collect();
        assert_eq!(lines.len(), 7);
        assert!(
            lines[0].ends_with("ratio to baseline,on front,gaps,filter taps"),
            "{}",
            lines[0]
        );
        // e = 0.25 and 0: rms = √(1/32), to the last bit; quartiles of (1, 2) are 1.25, 1.5, 1.75.
        let rms = (0.25f64 * 0.25 / 2.0).sqrt();
        assert_eq!(
            lines[1],
            format!(
                "made-up,sweep,plain,knob,2.5e-1,\"light, \"\"0.25\"\"\",2,2.5e-1,{rms:e},0,0.5,1.500,0.500,plain,1.000,yes,5,3"
            )
        );
        assert!(
            lines[3].contains(",gone,knob,2.5e-1,") && lines[3].contains(",1e-9,1e-9,0.5,1,"),
            "{}",
            lines[3]
        );
    }

    #[test]
    fn charts_show_all_but_incomplete_answers() {
        let charts = report().charts(&Style::default()).unwrap();
        let ids: Vec<_> = charts.iter().map(|chart| chart.id.as_str()).collect();
        assert_eq!(
            ids,
            ["error", "share", "time", "work", "cost"]
                .map(|kind| format!("trade/made-up/sweep-{kind}"))
        );
        let has = |chart: &Drawing, text: &str| chart.labels.iter().any(|label| label.text == text);
        let [error, share, time, work, cost] = charts.as_slice() else {
            panic!("five charts");
        };
        for chart in [error, cost] {
            assert!(has(chart, "plain") && has(chart, "exact") && !has(chart, "gone"));
            // An error of 0 is shown on a logarithmic axis, which says so.
            assert!(
                has(chart, "largest error (0: lowest marks)"),
                "{}",
                chart.id
            );
        }
        // Half of what is missing is wrong; all of it took its time.
        for chart in [share, time] {
            assert!(has(chart, "gone"), "{}", chart.id);
        }
        assert!(has(share, "share of wrong answers (0: lowest marks)"));
        assert!(has(time, "time a vertex / ns"));
        // Nobody makes fragments, all read three texels of a filter, and so have one curve.
        assert!(has(
            work,
            "plain: filter taps, exact: filter taps, gone: filter taps"
        ));
        assert!(has(cost, "× 9.00"));
    }

    #[test]
    fn curves_that_coincide_are_one_with_all_names() {
        let mut report = report();
        for question in &mut report.sweeps[0].questions {
            let exact = question.rows[1].clone();
            question.rows[2] = Row {
                technique: "gone",
                ..exact
            };
        }
        let charts = report.charts(&Style::default()).unwrap();
        let texts: Vec<_> = charts[0]
            .labels
            .iter()
            .map(|label| label.text.as_str())
            .collect();
        assert!(
            texts.contains(&"exact, gone") && texts.contains(&"plain"),
            "{texts:?}"
        );
        assert!(
            !texts.contains(&"exact") && !texts.contains(&"gone"),
            "{texts:?}"
        );
    }

    #[test]
    fn what_errs_alike_but_has_faults_elsewhere_is_not_on_the_front_drawn() {
        let mut report = report();
        let question = &mut report.sweeps[0].questions[0];
        // `gone` errs as `plain` does, in half its time.
        question.rows[2].deviation = question.rows[0].deviation;
        question.rows[2].error = question.rows[0].error;
        let quick = |report: &Report| {
            let charts = report.charts(&Style::default()).unwrap();
            let cost = charts.last().unwrap();
            let texts = cost.labels.iter().map(|label| label.text.clone());
            texts
                .filter(|text| text.starts_with('×'))
                .collect::<Vec<_>>()
        };
        assert_eq!(quick(&report), ["× 0.50", "× 9.00"]);
        // One more fault, in another question.
        report.sweeps[0].questions[1].rows[2].faults[0].1 += 1;
        assert_eq!(quick(&report), ["× 1.00", "× 9.00"]);
        // Another error is another choice, faults or not.
        report.sweeps[0].questions[0].rows[2].error *= 1.5;
        assert_eq!(quick(&report), ["× 0.50", "× 1.00", "× 9.00"]);
    }

    #[test]
    fn a_report_without_answers_has_no_charts() {
        let mut report = report();
        report.sweeps[0].questions.clear();
        assert_eq!(report.charts(&Style::default()), Ok(vec![]));
        report.sweeps[0].charted = 7;
        assert!(report.charts(&Style::default()).is_ok());
        assert_eq!(report.csv().lines().count(), 1);
    }

    #[test]
    fn files_are_written_and_named() {
        let folder =
            std::env::temp_dir().join(format!("ombra-trade-report-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        let report = report();
        let files = report
            .write(&folder, &Style::default(), Format::ALL)
            .unwrap();
        let mut names: Vec<_> = fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        assert_eq!(
            names,
            [
                "advice.md",
                "results.csv",
                "sweep-cost.png",
                "sweep-cost.svg",
                "sweep-error.png",
                "sweep-error.svg",
                "sweep-share.png",
                "sweep-share.svg",
                "sweep-time.png",
                "sweep-time.svg",
                "sweep-work.png",
                "sweep-work.svg"
            ]
        );
        assert!(
            files
                .iter()
                .all(|file| file.starts_with(&folder) && file.is_file())
        );
        assert_eq!(
            fs::read_to_string(folder.join("results.csv")).unwrap(),
            report.csv()
        );
        assert!(
            fs::read_to_string(folder.join("advice.md"))
                .unwrap()
                .starts_with("Use plain.\n")
        );
        // A file where the folder should be: a sentence, and the file is kept.
        let error = report
            .write(&folder.join("advice.md"), &Style::default(), &[Format::Svg])
            .unwrap_err();
        assert!(error.to_string().contains("cannot be written"), "{error}");
        assert!(folder.join("advice.md").is_file());
        let _ = fs::remove_dir_all(&folder);
    }
}
