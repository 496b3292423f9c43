//! What the figures of the clipping lecture show, against the lecture's answers.

#![allow(clippy::unwrap_used)]

use ombra_figures::course::select;
use ombra_figures::input::Inputs;
use ombra_figures::style::Style;

fn words(id: &str) -> Vec<String> {
    let figure = select(&[id]).unwrap()[0];
    let drawing = figure.draw(&Style::default(), &Inputs::default()).unwrap();
    drawing.labels.into_iter().map(|label| label.text).collect()
}

fn says(id: &str, expected: &[&str]) {
    let words = words(id);
    for line in expected {
        assert!(
            words.iter().any(|word| word == line),
            "'{line}' is not among {words:?}"
        );
    }
}

fn count(id: &str, word: &str) -> usize {
    words(id).iter().filter(|found| *found == word).count()
}

/// Two points lie outside: on the right, and on the left above.
#[test]
fn a_point_outside_breaks_the_inequality_said_of_it() {
    for broken in ["Q: x > xmax", "R: x < xmin", "R: y > ymax"] {
        assert_eq!(count("clip/point-window", broken), 1, "{broken}");
    }
    assert!(
        !words("clip/point-window")
            .iter()
            .any(|word| word.starts_with("P:"))
    );
}

/// Grafica 3, Clipping di un segmento: AB stays, CD and GH are cut, EF and IJ go.
#[test]
fn segments_get_new_ends_where_they_cross_the_border() {
    let id = "clip/segment-cases";
    for (name, times) in ["A", "B", "C", "D", "E", "F", "G", "H", "I", "J"].map(|name| (name, 1)) {
        assert_eq!(count(id, name), times, "{name}");
    }
    for (name, times) in [
        ("D", 1),
        ("G", 1),
        ("H", 1),
        ("I", 1),
        ("J", 1),
        ("A", 0),
        ("B", 0),
        ("C", 0),
        ("E", 0),
        ("F", 0),
    ] {
        assert_eq!(count(id, &format!("{name}′")), times, "{name}′");
    }
}

/// Four regions beyond one side, four beyond two: 12 digits 1 of 36, and none in the middle.
#[test]
fn outcodes_have_a_1_for_each_side_beyond() {
    let digits: String = words("clip/outcodes")
        .into_iter()
        .filter(|word| word == "0" || word == "1")
        .collect();
    // Row by row from below, left to right.
    assert_eq!(digits, "010101000110000100000010100110001010");
    says(
        "clip/outcodes",
        &[
            "bit 1", "y > ymax", "bit 2", "y < ymin", "bit 3", "x > xmax", "bit 4", "x < xmin",
        ],
    );
}

/// From above on the left to below on the right: three cuts, and each of the four bits occurs.
#[test]
fn cohen_sutherland_cuts_three_times() {
    let id = "clip/cohen-sutherland-steps";
    for (end, times) in [
        ("A 1001", 1),
        ("B 0110", 2),
        ("A′ 0000", 3),
        ("B′ 0010", 1),
        ("B′ 0000", 1),
    ] {
        assert_eq!(count(id, end), times, "{end}");
    }
    let words = words(id);
    let sentence = |words: &[String]| words.join(" ").replace('\u{a0}', " ");
    let all = sentence(&words);
    for line in [
        "OR 1111, AND 0000: cut at y = ymax",
        "OR 0110, AND 0000: cut at y = ymin",
        "OR 0010, AND 0000: cut at x = xmax",
        "OR 0000: accepted",
    ] {
        assert!(all.contains(line), "'{line}' is not in {all}");
    }
}

#[test]
fn sutherland_hodgman_goes_round_the_window() {
    says(
        "clip/sutherland-hodgman-steps",
        &["y ≤ ymax", "y ≥ ymin", "x ≤ xmax", "x ≥ xmin"],
    );
}
