//! What the figures of the rasterization lecture show, against answers worked out apart from the library.

#![allow(clippy::unwrap_used)]

use ombra_figures::course::select;
use ombra_figures::input::Inputs;
use ombra_figures::style::Style;

fn words(id: &str) -> Vec<String> {
    let figure = select(&[id]).unwrap()[0];
    let drawing = figure.draw(&Style::default(), &Inputs::default()).unwrap();
    let texts = drawing.labels.into_iter().map(|label| label.text);
    texts.map(|text| text.replace('\u{a0}', " ")).collect()
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

/// F(x, y) = 3x − 8y by hand at the midpoints after (0, 0), (1, 0), (2, 1), (3, 1), …
#[test]
fn the_trace_has_the_lectures_decisions() {
    let words = words("raster/bresenham-trace");
    let decisions: Vec<&str> = words
        .iter()
        .map(String::as_str)
        .filter(|word| ["E", "NE"].contains(word) || word.starts_with('−'))
        .collect();
    assert_eq!(
        decisions,
        [
            "−2", "E", "NE", "−6", "E", "E", "NE", "−4", "E", "NE", "−8", "E"
        ]
    );
    let table = words.iter().skip_while(|word| *word != "2F(M)").skip(1);
    let numbers: Vec<&String> = table.step_by(2).take(8).collect();
    assert_eq!(numbers, ["−2", "4", "−6", "0", "6", "−4", "2", "−8"]);
}

/// y = 3x/8, and the nearest integer, 3/2 to the lower one.
#[test]
fn dda_rounds_eighths() {
    let words = words("raster/dda-rounding");
    let table: Vec<&str> = words
        .iter()
        .skip_while(|word| *word != "pixel")
        .skip(1)
        .map(String::as_str)
        .collect();
    let expected = [
        ("0", "0"),
        ("3/8", "0"),
        ("3/4", "1"),
        ("9/8", "1"),
        ("3/2", "1"),
        ("15/8", "2"),
        ("9/4", "2"),
        ("21/8", "3"),
        ("3", "3"),
    ];
    assert_eq!(table, expected.map(|(y, pixel)| [y, pixel]).concat());
}

/// F(3, 3/2) = 9 − 12 and F(5, 3/2) = 15 − 12.
#[test]
fn choice_shows_both_signs() {
    let all = words("raster/bresenham-choice").join(" ");
    for line in ["d = F(M) = −3 < 0: E", "d = F(M) = 3 > 0: NE"] {
        assert!(all.contains(line), "'{line}' is not in {all}");
    }
}

/// dy = 3 is added after E, dy − dx = 3 − 8 after NE.
#[test]
fn increments_add_up() {
    let all = words("raster/bresenham-increments").join(" ");
    for line in ["after E: d = −3 + 3 = 0", "after NE: d = 2 + 3 − 8 = −3"] {
        assert!(all.contains(line), "'{line}' is not in {all}");
    }
    says("raster/bresenham-increments", &["+ dy", "+ dy − dx"]);
}

/// 5 columns and 4 rows: 2 (5 + 4) − 4 pixels around, 5 · 4 in all.
#[test]
fn a_rectangle_counts_its_pixels() {
    says(
        "raster/rectangle",
        &[
            "outline: 14 pixels",
            "filled: 20 pixels",
            "(1, 1)",
            "(5, 4)",
        ],
    );
}

/// Each edge by hand: the centres j + ½ from its upper end to before its lower, and where it meets y = 13/2.
#[test]
fn the_edge_table_has_rows_and_crossings() {
    let words = words("raster/scanline");
    let table: Vec<&str> = words
        .iter()
        .skip_while(|word| *word != "edge")
        .map(String::as_str)
        .collect();
    // (4.6, 0.8)→(7.4, 8.2): 4.6 + 2.8 · 5.7/7.4; (7.4, 8.2)→(10.5, 1): 7.4 + 3.1 · 1.7/7.2;
    // (2.6, 10.4)→(1.2, 2.0): 1.2 + 1.4 · 4.5/8.4; (13, 4)→(11.2, 11.2): 13 − 1.8 · 2.5/7.2.
    let expected = [
        "edge", "e0", "e1", "e2", "e3", "e4", "e5", "e6", "rows", "1", "1 … 7", "1 … 7", "1 … 3",
        "2 … 9", "4 … 10", "10", "X", "", "6.757", "8.132", "", "1.95", "12.38", "",
    ];
    let expected = expected.into_iter().filter(|word| !word.is_empty());
    let shown: Vec<&str> = table.into_iter().filter(|word| !word.is_empty()).collect();
    assert_eq!(
        shown[..expected.clone().count()],
        expected.collect::<Vec<_>>()
    );
}

/// Half of 18 · ½ each; with the sides y = 5/4 + x/72 and y = 5/4 + x/24 counted from the tip, a row of centres h below
/// the tip is inside for 24h < x < 72h.
#[test]
fn a_slivers_pixels_are_not_its_area() {
    says(
        "raster/sliver",
        &[
            "area 9/2: 12 pixels",
            "area 9/2: 6 pixels",
            "area 9/2: 0 pixels",
        ],
    );
}
