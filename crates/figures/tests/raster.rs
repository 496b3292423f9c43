//! What the figures of the rasterization lecture show, against answers worked out apart from the library.

#![allow(clippy::unwrap_used)]

use ombra_figures::course::select;
use ombra_figures::error::FigureError;
use ombra_figures::input::Inputs;
use ombra_figures::style::{Language, Style};

/// Values as typed: `a=9,11`.
fn moved(id: &str, values: &[&str]) -> Inputs {
    let inputs = select(&[id]).unwrap()[0].takes.inputs();
    values.iter().fold(Inputs::default(), |all, value| {
        let (name, text) = value.split_once('=').unwrap();
        let input = inputs.iter().find(|input| input.name == name).unwrap();
        all.with(input, text).unwrap()
    })
}

fn words_with(id: &str, values: &[&str]) -> Vec<String> {
    let figure = select(&[id]).unwrap()[0];
    let drawing = figure.draw(&Style::default(), &moved(id, values)).unwrap();
    let texts = drawing.labels.into_iter().map(|label| label.text);
    texts.map(|text| text.replace('\u{a0}', " ")).collect()
}

fn words(id: &str) -> Vec<String> {
    words_with(id, &[])
}

fn said(words: &[String], expected: &[&str]) {
    for line in expected {
        assert!(
            words.iter().any(|word| word == line),
            "'{line}' is not among {words:?}"
        );
    }
}

fn says(id: &str, expected: &[&str]) {
    said(&words(id), expected);
}

fn caption(id: &str, values: &[&str]) -> String {
    let figure = select(&[id]).unwrap()[0];
    figure.caption(&moved(id, values), Language::En)
}

/// What a table says behind `heading`.
fn row<'a>(words: &'a [String], heading: &str, count: usize) -> Vec<&'a str> {
    let behind = words.iter().skip_while(|word| *word != heading).skip(1);
    behind.take(count).map(String::as_str).collect()
}

/// F(x, y) = 3x − 8y by hand at the midpoints after (0, 0), (1, 0), (2, 1), (3, 1), …
#[test]
fn the_trace_has_the_lectures_decisions() {
    let words = words("raster/bresenham-trace");
    let numbers = row(&words, "2F(M)", 8);
    assert_eq!(numbers, ["−2", "4", "−6", "0", "6", "−4", "2", "−8"]);
    let moves = row(&words, "move", 8);
    assert_eq!(moves, ["E", "NE", "E", "E", "NE", "E", "NE", "E"]);
    let added = row(&words, "added", 8);
    assert_eq!(added, ["+6", "−10", "+6", "+6", "−10", "+6", "−10", "+6"]);
    let caption = caption("raster/bresenham-trace", &[]);
    assert!(caption.contains("= −2 at the start, +6 after E, −10 after NE"));
}

/// From (9, 11) down to (6, 2): nine moves of which three go both ways, so 2F begins at 6 − 9.
#[test]
fn the_trace_of_a_steep_segment() {
    let values = ["a=9,11", "b=6,2"];
    let words = words_with("raster/bresenham-trace", &values);
    let numbers = row(&words, "2F(M)", 9);
    assert_eq!(numbers, ["−3", "3", "−9", "−3", "3", "−9", "−3", "3", "−9"]);
    assert_eq!(row(&words, "added", 2), ["+6", "−12"]);
    let caption = caption("raster/bresenham-trace", &values);
    assert!(caption.contains("longer axis") && caption.contains("−12 after NE"));
}

/// y = 3x/8, and the nearest integer, 3/2 to the lower one.
#[test]
fn dda_rounds_eighths() {
    let words = words("raster/dda-rounding");
    let y = ["0", "3/8", "3/4", "9/8", "3/2", "15/8", "9/4", "21/8", "3"];
    assert_eq!(row(&words, "yi", 9), y);
    let pixels = ["0", "0", "1", "1", "1", "2", "2", "3", "3"];
    assert_eq!(row(&words, "pixel", 9), pixels);
    let caption_of = |values: &[&str]| caption("raster/dda-rounding", values);
    assert!(caption_of(&[]).contains("m* = 3/8") && caption_of(&[]).contains("at 3/2"));
    // x = 1 − 2i/3: no point is half-way.
    let steep = ["a=1,0", "b=9,12"];
    assert!(!caption_of(&steep).contains("Half-way"));
    let words = words_with("raster/dda-rounding", &steep);
    assert_eq!(row(&words, "xi", 4), ["1", "5/3", "7/3", "3"]);
}

/// 2F(3, 3/2) = 18 − 24 and 2F(5, 3/2) = 30 − 24.
#[test]
fn choice_shows_both_signs() {
    let id = "raster/bresenham-choice";
    let all = words(id).join(" ");
    for line in ["2F(M) = −6 < 0: E", "2F(M) = 6 > 0: NE"] {
        assert!(all.contains(line), "'{line}' is not in {all}");
    }
    // The tie, and the first NE after it.
    let tie = words_with(id, &["at=3"]).join(" ");
    assert!(
        tie.contains("2F(M) = 0: E") && tie.contains("2F(M) = 6 > 0: NE"),
        "{tie}"
    );
    // 45°: NE alone.
    let diagonal = words_with(id, &["b=8,8"]).join(" ");
    assert!(
        diagonal.contains("2F(M) = 8 > 0: NE") && !diagonal.contains(": E"),
        "{diagonal}"
    );
}

/// 2dy = 6 is added after E, 2dy − 2dx = 6 − 16 after NE.
#[test]
fn increments_add_up() {
    let all = words("raster/bresenham-increments").join(" ");
    for line in [
        "after E: 2F(M′) = −6 + 6 = 0",
        "after NE: 2F(M′) = 6 − 10 = −4",
    ] {
        assert!(all.contains(line), "'{line}' is not in {all}");
    }
    says("raster/bresenham-increments", &["+ 2dy", "+ 2dy − 2dx"]);
}

#[test]
fn a_move_that_the_segment_does_not_have_is_named() {
    for id in ["raster/bresenham-choice", "raster/bresenham-increments"] {
        let figure = select(&[id]).unwrap()[0];
        for (values, reason) in [
            (
                vec!["at=8"],
                "there is no move 8: the segment from (0, 0) to (8, 3) has 8, counted from 0",
            ),
            (
                vec!["b=0,0"],
                "both ends of the segment are the pixel (0, 0)",
            ),
        ] {
            let drawn = figure.draw(&Style::default(), &moved(id, &values));
            assert!(
                matches!(&drawn, Err(FigureError::Scene { reason: said }) if said.contains(reason)),
                "{drawn:?}"
            );
        }
    }
}

/// 5 columns and 4 rows: 2 (5 + 4) − 4 pixels around, 5 · 4 in all; a single row is all outline.
#[test]
fn a_rectangle_counts_its_pixels() {
    let id = "raster/rectangle";
    says(id, &["outline: 14 pixels", "filled: 20 pixels", "A", "B"]);
    assert!(caption(id, &[]).contains("from 1 to 5 are 5 − 1 + 1 = 5"));
    let words = words_with(id, &["a=9,4", "b=3,4"]);
    said(&words, &["outline: 7 pixels", "filled: 7 pixels"]);
    assert!(caption(id, &["a=9,4"]).contains("from 5 to 9 are 9 − 5 + 1 = 5"));
}

/// In the middle: half-way on the screen, w_A / (w_A + w_B) along the wall.
#[test]
fn perspective_moves_the_middle() {
    let id = "raster/perspective-correct";
    says(id, &["wA = 1", "wB = 3", "u = 1/2", "u = 1/4"]);
    said(&words_with(id, &["wb=6", "wa=4"]), &["u = 1/2", "u = 2/5"]);
    assert!(caption(id, &["wb=1"]).contains("equally far"));
}

/// Four centres lie on the edge; with both triangles on one side of it they overlap under every rule.
#[test]
fn a_shared_edge_counts_what_is_drawn_twice_and_never() {
    let id = "raster/triangle-shared-edge";
    let all = words(id).join(" ");
    for said in ["each once", "4 twice", "4 missing"] {
        assert!(all.contains(said), "'{said}' is not in {all}");
    }
    let all = words_with(id, &["b=5,0.5"]).join(" ");
    assert!(
        !all.contains("each once") && all.matches("twice").count() == 3,
        "{all}"
    );
}

/// (1.2, 2)–(4.6, 0.8), (4.6, 0.8)–(7.4, 8.2), (7.4, 8.2)–(10.5, 1), (10.5, 1)–(13, 4) at y = 3/2.
#[test]
fn another_row_has_other_crossings() {
    let words = words_with("raster/scanline", &["row=1"]);
    assert_eq!(row(&words, "X", 4), ["2.617", "4.865", "10.28", "10.92"]);
    let windings = words_with("raster/scanline", &["row=1", "rule=non-zero"]);
    assert_eq!(windings.iter().filter(|word| *word == "+1").count(), 2);
    assert_eq!(windings.iter().filter(|word| *word == "−1").count(), 2);
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
