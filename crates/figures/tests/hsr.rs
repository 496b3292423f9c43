//! What the figures of the hidden surfaces lecture show, against numbers worked by hand.

#![allow(clippy::unwrap_used)]

use ombra_figures::course::select;
use ombra_figures::input::Inputs;
use ombra_figures::style::Style;

fn words(id: &str) -> Vec<String> {
    let figure = select(&[id]).unwrap()[0];
    let drawing = figure.draw(&Style::default(), &Inputs::default()).unwrap();
    let text = |text: String| text.replace('\u{a0}', " ");
    let labels = drawing.labels.into_iter();
    labels.map(|label| text(label.text)).collect()
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

/// Grafica 3, Approccio Object-Space: the three relations, each in a picture and from above.
#[test]
fn three_relations_of_two_primitives() {
    let id = "hsr/object-space-pairs";
    says(
        id,
        &["A hides B", "A and B are visible", "A hides part of B"],
    );
    for name in ["A", "B"] {
        assert_eq!(count(id, name), 6, "{name}");
    }
}

/// The primitives stand across the view, 6, 9 and 4 away.
#[test]
fn a_ray_meets_the_plane_of_c_outside_c() {
    let id = "hsr/image-space-ray";
    says(id, &["A", "B", "C", "t = 4, outside C", "t = 6", "t = 9"]);
}

/// Grafica 3, Algoritmo del Pittore: back to front, whatever the order of submission.
#[test]
fn the_painter_goes_from_the_farthest_to_the_nearest() {
    says(
        "hsr/painter-steps",
        &["first C", "then A", "then D", "last B"],
    );
}

/// Is there always an order? (No.)
#[test]
fn three_sticks_have_no_order_until_one_is_cut() {
    let id = "hsr/painter-cycle";
    says(
        id,
        &[
            "A hides B, B hides C, C hides A",
            "A is cut in two; order: 1, 2, 3, 4",
        ],
    );
    // Beside the pieces; the panels have numbers, too.
    for (number, times) in [("1", 2), ("2", 2), ("3", 1), ("4", 1)] {
        assert_eq!(count(id, number), times, "{number}");
    }
}

/// Grafica 3, Back Face Culling: of the prism's six faces three look towards the eye; two show their angles.
#[test]
fn faces_turned_away_have_a_negative_product() {
    let id = "hsr/back-face";
    for (verdict, times) in [
        ("n·v ≥ 0: kept", 1),
        ("kept", 2),
        ("n·v < 0: culled", 1),
        ("culled", 2),
    ] {
        assert_eq!(count(id, verdict), times, "{verdict}");
    }
    for (name, times) in [("n", 2), ("v", 2), ("θ ≤ 90°", 1), ("θ > 90°", 1)] {
        assert_eq!(count(id, name), times, "{name}");
    }
}

/// Distances by hand: A is x + 1 in column x, B is 6 − x, C is 7, nothing is 8.
#[test]
fn the_z_buffer_holds_the_nearest_after_each_triangle() {
    let words = words("hsr/zbuffer-steps");
    let digit = |word: &&String| word.len() == 1 && word.starts_with(|c: char| c.is_ascii_digit());
    // The numbers of the four steps come first.
    let digits: Vec<&str> = words
        .iter()
        .filter(digit)
        .skip(4)
        .map(String::as_str)
        .collect();
    let steps: Vec<String> = digits.chunks(36).map(<[&str]>::concat).collect();
    let expected = [
        "888888 888888 888888 888888 888888 888888",
        "188888 123488 123458 188888 888888 888888",
        "188888 123421 123321 154321 888821 888888",
        "188788 123421 123321 154321 877721 777777",
    ];
    assert_eq!(steps, expected.map(|rows| rows.replace(' ', "")));
}

#[test]
fn curves_of_depth_formats_are_named_and_the_planes_stated() {
    says(
        "hsr/depth-precision",
        &["16 bits", "24 bits, f32", "f32", "f32 reversed"],
    );
    says(
        "hsr/depth-precision",
        &["distance z (m)", "n = 0.1 m, f = 10000 m"],
    );
}
