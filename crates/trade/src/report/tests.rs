use ombra_figures::drawing::Drawing;
use ombra_figures::style::{Format, Style};

use super::*;
use crate::advice::Choice;
use crate::study::What;
use ombra_math::work::Count;
use std::fs;

const SHOWN: &[Shown] = &[
    shown(What::Error(0)),
    shown(What::Error(1)),
    shown(What::Time),
    shown(What::Work),
    shown(What::Cost(0)),
];

const fn shown(what: What) -> Shown {
    Shown {
        sweep: "sweep",
        what,
    }
}

fn use_plain(_: &[Measured]) -> Advice {
    let choice = Choice {
        need: "speed".to_owned(),
        method: "plain".to_owned(),
        setting: "any".to_owned(),
        cost: "1.0".to_owned(),
        loss: "0.25 and more".to_owned(),
    };
    Advice {
        baseline: "plain",
        rows: vec![choice],
    }
}

/// A study that the report could be of.
const STUDY: Study = Study {
    id: "made-up",
    summary: "Made up",
    unit: "vertex",
    errors: &[Measure::Largest("error"), Measure::Share("wrong answers")],
    charted_work: &[Counter::Fragments, Counter::Taps],
    charts: SHOWN,
    ends: &[("gone", "k² pairs")],
    sweeps: |_| vec![],
    advice: use_plain,
};

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
        shown: SHOWN,
        ends: &[("gone", "k² pairs")],
        sweeps: vec![Measured {
            name: "sweep",
            knob: "knob",
            questions: vec![question(0.25), question(256.0)],
        }],
        advice: use_plain(&[]),
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
            "made-up,sweep,plain,knob,2.5e-1,\"light, \"\"0.25\"\"\",2,2.5e-1,{rms:e},0,0.5,1.500,0.500,1.250,plain,1.000,yes,5,3"
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
        // An error of 0 is shown below a logarithmic axis.
        assert!(
            has(chart, "largest error") && has(chart, "0"),
            "{}",
            chart.id
        );
    }
    // Half of what is missing is wrong; all of it took its time.
    for chart in [share, time] {
        assert!(has(chart, "gone"), "{}", chart.id);
    }
    assert!(has(share, "wrong answers (%)"));
    assert!(has(time, "time per vertex (ns)"));
    // Nobody makes fragments, all read three texels of a filter, and so have one curve.
    assert!(has(work, "plain, exact, gone") && has(work, "filter taps"));
    // What each loses at its point.
    assert!(has(cost, "× 9.0, exact") && has(cost, "× 1.0, off by 0.25"));
    // At which settings: what all questions have in common, and from where to where the rest goes; or one of them.
    let titled = |chart: &Drawing, text: &str| {
        chart.title.ends_with(text)
            && chart
                .labels
                .iter()
                .any(|label| label.text.starts_with(text))
    };
    assert!(
        titled(error, "light, \"0.25\" … \"256\""),
        "{}",
        error.title
    );
    assert!(titled(cost, "light, \"0.25\""), "{}", cost.title);
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
    use ombra_figures::colour::Role;
    use ombra_figures::drawing::{Item, NORMAL};

    let mut report = report();
    // A ring is drawn in the colour of what is chosen.
    let rings = |report: &Report| {
        let charts = report.charts(&Style::default()).unwrap();
        let items = charts.last().unwrap().items.iter();
        let rings = items.filter(|item| {
            matches!(item, Item::Shape { stroke: Some(pen), .. }
                if pen.paint == Role::Chosen.into() && pen.width == NORMAL)
        });
        rings.count()
    };
    assert_eq!(rings(&report), 2);
    report.sweeps[0].questions[0].rows[0].on_front = false;
    assert_eq!(rings(&report), 1);
    // That of another question is not drawn.
    report.sweeps[0].questions[1].rows[1].on_front = false;
    assert_eq!(rings(&report), 1);
}

#[test]
fn a_curve_that_ends_says_why() {
    let mut report = report();
    let texts = |report: &Report| -> Vec<String> {
        let charts = report.charts(&Style::default()).unwrap();
        let labels = charts[0].labels.iter().chain(&charts[2].labels);
        labels.map(|label| label.text.clone()).collect()
    };
    let said = |report: &Report, text: &str| texts(report).iter().any(|label| label == text);
    assert!(!said(&report, "to 0.25: k2 pairs"));
    // Answers of the third go missing at the second setting only; then it is not asked at all.
    report.sweeps[0].questions[0].rows[2] = Row {
        technique: "gone",
        ..report.sweeps[0].questions[0].rows[0].clone()
    };
    assert!(
        said(&report, "beyond 0.25: no answer"),
        "{:?}",
        texts(&report)
    );
    report.sweeps[0].questions[1].rows.pop();
    assert!(said(&report, "to 0.25: k2 pairs"), "{:?}", texts(&report));
}

#[test]
fn charts_and_advice_come_back_from_the_table() {
    let report = report();
    let table = report.csv();
    let read = Report::read(&STUDY, &table).unwrap();
    assert_eq!(read.csv(), table);
    assert_eq!(
        read.charts(&Style::default()),
        report.charts(&Style::default())
    );
    assert_eq!(read.advice_markdown(), report.advice_markdown());
    assert_eq!(read.sweeps[0].questions.len(), 2);
    // An earlier run's table has the distance of the quartiles alone: half of it on either side.
    let lines = table
        .replace(",lower quartile ns", "")
        .replace(",1.250,plain", ",plain")
        .replace(",11.250,plain", ",plain")
        .replace(",0.625,plain", ",plain");
    let earlier = Report::read(&STUDY, &lines).unwrap();
    let times = |report: &Report| -> Vec<Quartiles> {
        report.sweeps[0].rows().map(|row| row.nanoseconds).collect()
    };
    assert_eq!(times(&earlier), times(&report));
}

#[test]
fn what_is_no_table_is_an_error_that_names_the_line() {
    let table = report().csv();
    let lines: Vec<&str> = table.lines().collect();
    for (text, says) in [
        (String::new(), "made-up: the table is empty"),
        ("study,sweep\n".to_owned(), "no column 'technique'"),
        (
            format!("{}\nmade-up,sweep\n", lines[0]),
            "line 2 has 2 cells, the first line 19",
        ),
        (
            table.replacen("made-up,sweep,plain", "other,sweep,plain", 1),
            "line 2 is of the study 'other'",
        ),
        (
            table.replacen(",1.500,", ",soon,", 1),
            "line 2 has 'soon' as 'median ns a unit', where a number belongs",
        ),
        (
            table.replacen(",0,0.5,1.500", ",2,0.5,1.500", 1),
            "line 2 has shares that are none: 2 missing, 0.5 wrong",
        ),
        (format!("{table}\""), "within quotation marks"),
    ] {
        let error = Report::read(&STUDY, &text).unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    }
}

#[test]
fn a_report_without_answers_has_no_charts() {
    let mut report = report();
    report.sweeps[0].questions.clear();
    assert_eq!(report.charts(&Style::default()), Ok(vec![]));
    report.sweeps.clear();
    assert_eq!(report.charts(&Style::default()), Ok(vec![]));
    assert_eq!(report.csv().lines().count(), 1);
}

#[test]
fn files_are_written_and_named() {
    let folder = std::env::temp_dir().join(format!("ombra-trade-report-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    let report = report();
    let files = report
        .write(&folder, &Style::default(), Format::ALL, true)
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
            .starts_with("| need  | method |")
    );
    // A file where the folder should be: a sentence, and the file is kept.
    let error = report
        .write(
            &folder.join("advice.md"),
            &Style::default(),
            &[Format::Svg],
            false,
        )
        .unwrap_err();
    assert!(error.to_string().contains("cannot be written"), "{error}");
    assert!(folder.join("advice.md").is_file());
    let _ = fs::remove_dir_all(&folder);
}
