//! Runs a study: first errors and counted work, then times in interleaved rounds.

use core::fmt;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use ombra_math::work::Work;

use crate::deviation::{Measure, Verdict};
use crate::error::TradeError;
use crate::pareto;
use crate::report::{Answered, Measured, Report, Row};
use crate::statistics::Quartiles;
use crate::study::{Case, Effort, Study, Sweep};

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The study's id.
    pub study: &'static str,
    /// What it does now.
    pub stage: Stage,
    /// Steps done, of all stages.
    pub done: usize,
    /// Steps in all; 0 while they are not known.
    pub total: usize,
}

/// The parts of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Inputs and ground truth are made.
    Inputs,
    /// Answers are compared with the truth, work is counted.
    Errors,
    /// Time is taken.
    Times,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stage::Inputs => "inputs",
            Stage::Errors => "errors",
            Stage::Times => "times",
        })
    }
}

/// Runs `study` and tells `progress` how far it is.
///
/// # Properties
///
/// Errors and counted work are the same on every run and machine. Times are taken in [`Effort::rounds`] rounds; each
/// runs every case once, starting at another question and another technique than the round before, so that a
/// machine that slows down slows down all. A batch repeats a case until the clock can tell, after one run that warms the
/// caches. The time is the median of the rounds, its spread the distance of their quartiles, and the ratio to the
/// baseline the median of each round's own ratio.
///
/// # Errors
///
/// [`TradeError::Differs`] when a technique's counted run does not answer what its timed run answers.
pub fn run(
    study: &Study,
    effort: Effort,
    progress: &mut impl FnMut(Progress),
) -> Result<Report, TradeError> {
    let mut tell = |stage, done, total| {
        progress(Progress {
            study: study.id,
            stage,
            done,
            total,
        })
    };
    tell(Stage::Inputs, 0, 0);
    let sweeps = (study.sweeps)(effort);
    let cases = cases(&sweeps).count();
    // A step judges one case, or times one.
    let total = cases * (1 + effort.rounds());
    let judged = judge(study.id, &sweeps, &mut |done| {
        tell(Stage::Errors, done, total)
    })?;
    let times = time(&sweeps, effort, &mut |done| {
        tell(Stage::Times, cases + done, total)
    });
    let mut measured = assemble(&sweeps, study.errors, judged.into_iter().zip(times));
    mark_fronts(&mut measured);
    Ok(Report::new(study, measured))
}

/// Errors and counted work of every case, in order.
pub(crate) fn judge(
    study: &'static str,
    sweeps: &[Sweep],
    done: &mut impl FnMut(usize),
) -> Result<Vec<(Work, Verdict)>, TradeError> {
    let mut judged = Vec::new();
    for case in cases(sweeps) {
        let answer = (case.judge)().ok_or(TradeError::Differs {
            study,
            technique: case.technique,
            setting: case.setting,
        })?;
        judged.push(answer);
        done(judged.len());
    }
    Ok(judged)
}

/// What the clock said about one case.
#[derive(Debug)]
struct Time {
    /// Nanoseconds a unit.
    nanoseconds: Quartiles,
    /// Time over the baseline's.
    ratio: f64,
}

/// Times of every case, in order.
fn time(sweeps: &[Sweep], effort: Effort, done: &mut impl FnMut(usize)) -> Vec<Time> {
    let questions: Vec<_> = sweeps.iter().flat_map(|s| &s.questions).collect();
    let batch = effort.choose(Duration::from_micros(100), Duration::from_millis(1));
    let sizes: Vec<_> = questions.iter().map(|q| q.cases.len()).collect();
    let repeats: Vec<Vec<u32>> = questions
        .iter()
        .map(|q| q.cases.iter().map(|c| repeats(c, batch)).collect())
        .collect();
    // One row of times a case, one column a round.
    let mut taken: Vec<Vec<Vec<f64>>> = sizes.iter().map(|&n| vec![Vec::new(); n]).collect();
    let mut steps = 0;
    for round in 0..effort.rounds() {
        for (q, c) in order(round, &sizes) {
            let (Some(question), Some(row), Some(&repeats)) = (
                questions.get(q),
                taken.get_mut(q),
                repeats.get(q).and_then(|r| r.get(c)),
            ) else {
                continue;
            };
            let (Some(case), Some(cell)) = (question.cases.get(c), row.get_mut(c)) else {
                continue;
            };
            (case.answer)();
            let elapsed = clock(case, repeats).as_secs_f64() * 1e9;
            cell.push(elapsed / (f64::from(repeats) * question.units.max(1) as f64));
            steps += 1;
            done(steps);
        }
    }
    let ratios = |cell: &[f64], baseline: &[f64]| {
        let each: Vec<_> = cell.iter().zip(baseline).map(|(a, b)| a / b).collect();
        Quartiles::of(&each).median
    };
    taken
        .iter()
        .flat_map(|row| {
            row.iter().map(|cell| Time {
                nanoseconds: Quartiles::of(cell),
                ratio: row
                    .first()
                    .map_or(f64::NAN, |baseline| ratios(cell, baseline)),
            })
        })
        .collect()
}

/// The order of one round: from another question on, and within each from another case on, than the round before.
fn order(round: usize, sizes: &[usize]) -> impl Iterator<Item = (usize, usize)> {
    let rotated = move |n: usize| (0..n).map(move |i| (i + round) % n);
    rotated(sizes.len())
        .flat_map(move |q| rotated(sizes.get(q).copied().unwrap_or(0)).map(move |c| (q, c)))
}

/// How often a case runs in a batch, so that the batch takes `at_least` that long.
fn repeats(case: &Case, at_least: Duration) -> u32 {
    let mut repeats = 1;
    while repeats < 1 << 20 && clock(case, repeats) < at_least {
        repeats *= 2;
    }
    repeats
}

fn clock(case: &Case, repeats: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..repeats {
        (case.answer)();
    }
    start.elapsed()
}

fn cases(sweeps: &[Sweep]) -> impl Iterator<Item = &Case> {
    sweeps
        .iter()
        .flat_map(|s| &s.questions)
        .flat_map(|q| &q.cases)
}

/// Puts the numbers of all cases, which come in order, back into sweeps and questions.
fn assemble(
    sweeps: &[Sweep],
    errors: &[Measure],
    numbers: impl IntoIterator<Item = ((Work, Verdict), Time)>,
) -> Vec<Measured> {
    let mut numbers = numbers.into_iter();
    let sweeps = sweeps.iter().map(|sweep| Measured {
        name: sweep.name,
        knob: sweep.knob,
        questions: sweep
            .questions
            .iter()
            .map(|question| Answered {
                inputs: question.inputs.clone(),
                units: question.units,
                rows: question
                    .cases
                    .iter()
                    .zip(&mut numbers)
                    .map(|(case, ((work, verdict), time))| Row {
                        technique: case.technique,
                        setting: case.setting,
                        error: errors
                            .first()
                            .map_or(f64::NAN, |measure| measure.of(&verdict.deviation)),
                        deviation: verdict.deviation,
                        faults: verdict.faults,
                        work,
                        nanoseconds: time.nanoseconds,
                        ratio: time.ratio,
                        on_front: false,
                    })
                    .collect(),
            })
            .collect(),
    });
    sweeps.collect()
}

/// Marks each question's front, among the rows whose twins have no fewer faults.
fn mark_fronts(sweeps: &mut [Measured]) {
    let mut faults: BTreeMap<&str, u64> = BTreeMap::new();
    for row in sweeps.iter().flat_map(Measured::rows) {
        let number = row.faults.iter().map(|fault| fault.1).sum();
        let all = faults.entry(row.technique).or_default();
        *all = all.saturating_add(number);
    }
    let faults = |row: &Row| faults.get(row.technique).copied().unwrap_or(0);
    for question in sweeps.iter_mut().flat_map(|sweep| &mut sweep.questions) {
        let is_sound = |row: &Row| {
            let is_twin = |other: &&Row| other.setting == row.setting && other.error == row.error;
            let mut twins = question.rows.iter().filter(is_twin);
            twins.all(|twin| faults(row) <= faults(twin))
        };
        // A point with NaN in it is never on the front, and beats none.
        let point = |row: &Row| (if is_sound(row) { row.ratio } else { f64::NAN }, row.error);
        let front = pareto::front(&question.rows.iter().map(point).collect::<Vec<_>>());
        for (row, on_front) in question.rows.iter_mut().zip(front) {
            row.on_front = on_front;
        }
    }
}

#[cfg(test)]
pub(crate) mod judged;
#[cfg(test)]
mod tests;
