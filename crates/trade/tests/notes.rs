//! The notes hold the results of the last full run: what is drawn and advised there comes from their tables, every chart
//! is shown, and every study has one.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use ombra_figures::style::{Size, Style, Theme};
use ombra_figures::svg;
use ombra_trade::report::Report;
use ombra_trade::studies;
use ombra_trade::study::Study;

fn notes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../notes/src")
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn stored(study: &Study) -> Report {
    let table = text(&notes().join("trade").join(study.id).join("results.csv"));
    Report::read(study, &table).unwrap()
}

#[test]
fn charts_and_advice_are_those_of_the_tables() {
    for study in studies() {
        let report = stored(study);
        let folder = notes().join("trade").join(study.id);
        let remedy = "cargo run --release -- trade --from notes/src/trade --out notes/src/trade --format svg";
        assert_eq!(
            text(&folder.join("advice.md")),
            report.advice_markdown(),
            "{remedy}"
        );
        let mut names = BTreeSet::from(["advice.md".to_owned(), "results.csv".to_owned()]);
        for chart in report.charts(&Style::default()).unwrap() {
            let name = format!("{}.svg", chart.id.rsplit('/').next().unwrap());
            assert!(
                text(&folder.join(&name)) == svg::svg(&chart).unwrap(),
                "{name}: {remedy}"
            );
            names.insert(name);
        }
        let found = fs::read_dir(&folder).unwrap();
        let found: BTreeSet<String> = found
            .map(|file| file.unwrap().file_name().into_string().unwrap())
            .collect();
        // No chart that is used nowhere.
        assert_eq!(found, names, "{}", study.id);
    }
}

#[test]
fn the_chapter_shows_every_chart_and_the_advice_of_every_study() {
    let chapter = text(&notes().join("accuracy.md"));
    for study in studies() {
        let report = stored(study);
        assert!(!study.charts.is_empty(), "{}", study.id);
        let charts = report.charts(&Style::default()).unwrap();
        assert_eq!(charts.len(), study.charts.len(), "{}", study.id);
        for chart in charts {
            let link = format!("({}.svg)", chart.id);
            assert!(chapter.contains(&link), "{link}");
        }
        let advice = report.advice.to_string();
        assert!(chapter.contains(&advice), "{}:\n{advice}", study.id);
        for technique in report.sweeps.iter().flat_map(|sweep| sweep.techniques()) {
            // Its name is explained, or at least stands in a table.
            assert!(chapter.contains(technique), "{technique}");
        }
    }
}

/// At the sizes of slides and posters: no label over another, or out of the canvas, or too small to be read.
#[test]
fn labels_keep_apart_at_every_aspect() {
    for (width, height) in [(1920, 1080), (1024, 768), (1000, 1000), (768, 1024)] {
        for &theme in Theme::ALL {
            let style = Style {
                size: Size::new(width, height).unwrap(),
                theme,
                ..Style::default()
            };
            for study in studies() {
                for chart in stored(study).charts(&style).unwrap() {
                    for (i, label) in chart.labels.iter().enumerate() {
                        let context = format!("{} {width}x{height}: '{}'", chart.id, label.text);
                        let (min, max) = (label.bounds.min, label.bounds.max);
                        assert!(
                            min.min_element() >= 0.0 && max.cmple(chart.canvas).all(),
                            "{context}"
                        );
                        assert!(label.smallest >= ombra_figures::text::SMALLEST, "{context}");
                        for other in &chart.labels[..i] {
                            assert!(
                                !label.bounds.meets(&other.bounds),
                                "{context} over '{}'",
                                other.text
                            );
                        }
                    }
                }
            }
        }
    }
}
