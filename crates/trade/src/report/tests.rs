use ombra_figures::drawing::Drawing;
use ombra_figures::style::{Format, Style};

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
fn the_front_drawn_is_the_front_of_the_table() {
    let mut report = report();
    let marked = |report: &Report| {
        let charts = report.charts(&Style::default()).unwrap();
        let cost = charts.last().unwrap();
        let texts = cost.labels.iter().map(|label| label.text.clone());
        texts
            .filter(|text| text.starts_with('×'))
            .collect::<Vec<_>>()
    };
    assert_eq!(marked(&report), ["× 1.00", "× 9.00"]);
    report.sweeps[0].questions[0].rows[0].on_front = false;
    assert_eq!(marked(&report), ["× 9.00"]);
    // That of another question is not drawn.
    report.sweeps[0].questions[1].rows[1].on_front = false;
    assert_eq!(marked(&report), ["× 9.00"]);
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
    let folder = std::env::temp_dir().join(format!("ombra-trade-report-{}", std::process::id()));
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
            "sweep-cost.pdf",
            "sweep-cost.png",
            "sweep-cost.svg",
            "sweep-error.pdf",
            "sweep-error.png",
            "sweep-error.svg",
            "sweep-share.pdf",
            "sweep-share.png",
            "sweep-share.svg",
            "sweep-time.pdf",
            "sweep-time.png",
            "sweep-time.svg",
            "sweep-work.pdf",
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
