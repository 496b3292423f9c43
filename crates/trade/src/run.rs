//! Runs a study: first errors and counted work, then times in interleaved rounds.

use core::fmt;
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
    let cases: usize = sweeps
        .iter()
        .flat_map(|s| &s.questions)
        .map(|q| q.cases.len())
        .sum();
    // A step judges one case, or times one.
    let total = cases * (1 + effort.rounds());
    let judged = judge(study.id, &sweeps, &mut |done| {
        tell(Stage::Errors, done, total)
    })?;
    let times = time(&sweeps, effort, &mut |done| {
        tell(Stage::Times, cases + done, total)
    });
    let measured = assemble(&sweeps, study.errors, judged.into_iter().zip(times));
    let advice = (study.advice)(&measured);
    Ok(Report {
        study: study.id,
        summary: study.summary,
        unit: study.unit,
        errors: study.errors,
        charted_work: study.charted_work,
        sweeps: measured,
        advice,
    })
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
        charted: sweep.charted,
        questions: sweep
            .questions
            .iter()
            .map(|question| {
                let rows = question.cases.iter().zip(&mut numbers);
                let mut rows: Vec<_> = rows
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
                    .collect();
                let points: Vec<_> = rows.iter().map(|row| (row.ratio, row.error)).collect();
                for (row, on_front) in rows.iter_mut().zip(pareto::front(&points)) {
                    row.on_front = on_front;
                }
                Answered {
                    inputs: question.inputs.clone(),
                    units: question.units,
                    rows,
                }
            })
            .collect(),
    });
    sweeps.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::study::Question;
    use ombra_math::work::{Count, Counter};
    use std::collections::BTreeSet;
    use std::rc::Rc;

    /// n sums, of which one is wrong by 1.
    fn sums(n: &u64, work: &mut impl Count) -> Vec<u64> {
        (0..*n)
            .map(|i| {
                work.add(Counter::Additions, 1);
                i + u64::from(i == 0)
            })
            .collect()
    }

    fn sweeps(_: Effort) -> Vec<Sweep> {
        let judge = |_: &u64, sums: &Vec<u64>| {
            Deviation::of(
                sums.iter()
                    .enumerate()
                    .map(|(i, &sum)| Some(sum as f64 - i as f64)),
            )
        };
        let question = |n: u64| Question {
            inputs: format!("{n} sums"),
            units: n as usize,
            cases: vec![
                Case::new(
                    "once",
                    n as f64,
                    &Rc::new(n),
                    |n| sums(n, &mut ()),
                    sums,
                    judge,
                ),
                Case::new(
                    "none",
                    n as f64,
                    &Rc::new(n),
                    |_| vec![],
                    |_, _| vec![],
                    judge,
                ),
            ],
        };
        vec![
            Sweep {
                name: "first",
                knob: "n",
                questions: vec![question(4), question(5)],
                charted: 0,
            },
            Sweep {
                name: "second",
                knob: "n",
                questions: vec![question(6)],
                charted: 0,
            },
        ]
    }

    const STUDY: Study = Study {
        id: "sums",
        summary: "sums",
        unit: "sum",
        errors: &[Measure::Largest("error")],
        charted_work: &[],
        sweeps,
        advice: |measured| format!("{} sweeps.", measured.len()),
    };

    #[test]
    fn numbers_reach_their_own_rows_and_progress_its_end() {
        let mut seen = Vec::new();
        let report = run(&STUDY, Effort::Quick, &mut |progress| seen.push(progress)).unwrap();
        let rows: Vec<_> = report
            .sweeps
            .iter()
            .flat_map(|s| &s.questions)
            .flat_map(|q| &q.rows)
            .collect();
        let found: Vec<_> = rows
            .iter()
            .map(|r| (r.technique, r.setting, r.work.additions, r.deviation.asked))
            .collect();
        assert_eq!(
            found,
            [
                ("once", 4.0, 4, 4),
                ("none", 4.0, 0, 0),
                ("once", 5.0, 5, 5),
                ("none", 5.0, 0, 0),
                ("once", 6.0, 6, 6),
                ("none", 6.0, 0, 0)
            ]
        );
        assert!(
            rows.iter()
                .all(|row| row.nanoseconds.median > 0.0 && row.ratio > 0.0)
        );
        // A time over itself.
        assert!(
            rows.iter()
                .filter(|row| row.technique == "once")
                .all(|row| row.ratio == 1.0)
        );
        // Who answers nothing is never on the front, however quick.
        assert_eq!(
            rows.iter().map(|row| row.on_front).collect::<Vec<_>>(),
            [true, false].repeat(3)
        );
        assert_eq!(report.advice, "2 sweeps.");
        assert_eq!(seen.len(), 1 + 6 + 6 * Effort::Quick.rounds());
        assert_eq!(
            seen.last().map(|p| (p.stage, p.done, p.total)),
            Some((Stage::Times, 48, 48))
        );
        assert!(
            seen.iter()
                .zip(seen.iter().skip(1))
                .all(|(a, b)| a.done < b.done && a.stage as u8 <= b.stage as u8)
        );
    }

    #[test]
    fn every_effort_has_at_least_five_rounds() {
        assert!(Effort::Quick.rounds() >= 5 && Effort::Full.rounds() > Effort::Quick.rounds());
    }

    #[test]
    fn each_round_runs_every_case_once_and_begins_elsewhere() {
        let sizes = [3, 1, 2, 0, 4];
        let all: BTreeSet<_> = (0..5)
            .flat_map(|q| (0..sizes[q]).map(move |c| (q, c)))
            .collect();
        for round in 0..12 {
            let cases: Vec<_> = order(round, &sizes).collect();
            assert_eq!(cases.len(), all.len());
            assert_eq!(cases.iter().copied().collect::<BTreeSet<_>>(), all);
        }
        let firsts: BTreeSet<_> = (0..12)
            .filter_map(|round| order(round, &[3, 3]).next())
            .collect();
        assert_eq!(firsts.len(), 6);
        assert_eq!(order(3, &[]).count(), 0);
    }

    #[test]
    fn answers_that_change_when_counted_are_an_error() {
        let judge = |_: &(), _: &i32| Deviation::of([Some(0.0)]);
        let case = Case::new("sly", 2.0, &Rc::new(()), |()| 1, |(), _| 2, judge);
        let question = Question {
            inputs: String::new(),
            units: 1,
            cases: vec![case],
        };
        let sweeps = [Sweep {
            name: "",
            knob: "",
            questions: vec![question],
            charted: 0,
        }];
        let error = judge_error(&sweeps);
        assert_eq!(
            error,
            TradeError::Differs {
                study: "s",
                technique: "sly",
                setting: 2.0
            }
        );
        assert!(error.to_string().contains("'sly' at 2e0"), "{error}");
    }

    fn judge_error(sweeps: &[Sweep]) -> TradeError {
        judge("s", sweeps, &mut |_| ()).unwrap_err()
    }
}
