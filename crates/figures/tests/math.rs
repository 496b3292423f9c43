//! What the figures of the mathematics show, against numbers worked by hand.

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

/// n·Q = 4·2 + 3·(−1) = 5, so d = −5; n·p = 20, ‖n‖ = 5, so the distance is 15/5.
#[test]
fn plane() {
    says(
        "math/plane",
        &[
            "n = (0, 4, 3)",
            "Q (−3, 2, −1)",
            "d = −n·Q = −5",
            "4y + 3z − 5 = 0",
            "p (2, 5, 0)",
            "(n·p + d) / ∥n∥ = 3",
        ],
    );
}

#[test]
fn spherical() {
    says(
        "math/spherical",
        &["r", "θ", "φ", "1", "P (r, θ, φ)", "dω = sin θ dθ dφ"],
    );
}

/// The frustum's corners go to the cube's, the distance 2fn / (f + n) to its middle.
#[test]
fn frustum() {
    says(
        "math/frustum",
        &[
            "(l, b, −n)",
            "(r, t, −n)",
            "z = −2fn / (f + n)",
            "z = −f",
            "(−1, −1, −1)",
            "(1, 1, −1)",
            "z = 0",
            "z = 1",
        ],
    );
}
