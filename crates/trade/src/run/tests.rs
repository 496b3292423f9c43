use super::*;
use crate::advice::Advice;
use crate::deviation::Deviation;
use crate::report::made_up;
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
        },
        Sweep {
            name: "second",
            knob: "n",
            questions: vec![question(6)],
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
    charts: &[],
    ends: &[],
    advice: |measured| Advice {
        baseline: measured.last().map_or("", |sweep| sweep.name),
        rows: vec![],
    },
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
    assert_eq!(report.advice.baseline, "second");
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

#[test]
fn what_errs_alike_but_has_faults_elsewhere_is_not_on_the_front() {
    let faulty = |technique, ratio, error, faults| Row {
        faults: vec![("gaps", faults)],
        ..made_up::row(technique, 4.0, ratio, Some(error))
    };
    let front = |second: f64, elsewhere: u64| {
        let here = vec![
            faulty("sound", 1.0, 0.5, 5),
            faulty("quick", 0.5, second, 5),
            faulty("exact", 9.0, 0.0, 5),
        ];
        let there = vec![faulty("quick", 1.0, 0.0, elsewhere)];
        let mut sweeps = [
            made_up::sweep("first", vec![here]),
            made_up::sweep("second", vec![there]),
        ];
        mark_fronts(&mut sweeps);
        sweeps[0].rows().map(|row| row.on_front).collect::<Vec<_>>()
    };
    assert_eq!(front(0.5, 0), [false, true, true]);
    // One fault in another sweep.
    assert_eq!(front(0.5, 1), [true, false, true]);
    // Another error is another choice, faults or not.
    assert_eq!(front(0.75, 1), [true, true, true]);
}
