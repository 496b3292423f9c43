//! Sutherland–Hodgman: a concave polygon after each of the four lines.

use ombra_clip::Window;
use ombra_clip::sutherland_hodgman::{HalfPlane, clip_against_line};
use ombra_math::glam::DVec2;

use super::board::{Board, NAMES, window};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/sutherland-hodgman-steps",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Sutherland–Hodgman: a concave polygon after each of the four lines",
        it: "Sutherland–Hodgman: un poligono concavo dopo ognuna delle quattro rette",
        cs: "Sutherland–Hodgman: nekonvexní polygon po každé ze čtyř přímek",
        hr: "Sutherland–Hodgman: konkavni poligon nakon svakog od četiri pravca",
    }

    CAPTION {
        en: "Each line keeps what lies on its inner side; what is left goes on to the next.",
        it: "Ogni retta conserva ciò che sta dalla sua parte interna; ciò che resta passa alla successiva.",
        cs: "Každá přímka ponechá, co leží na její vnitřní straně; zbytek jde k další.",
        hr: "Svaki pravac zadržava što je na njegovoj unutarnjoj strani; ostatak ide na sljedeći.",
    }
}

const WINDOW: Window = window(0.0, 0.0, 10.0, 18.0);
const SHOWN: Window = window(-3.6, -5.4, 13.6, 23.4);
/// A star with a tip beyond each side.
const STAR: [(f64, f64); 8] = [
    (4.0, 22.6),
    (3.0, 13.0),
    (-2.8, 10.8),
    (3.0, 6.0),
    (5.8, -4.4),
    (7.0, 5.0),
    (12.8, 8.0),
    (6.8, 12.0),
];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let [above, below, right, left] = NAMES;
    let lines = [
        format!("*y* ≤ {above}"),
        format!("*y* ≥ {below}"),
        format!("*x* ≤ {right}"),
        format!("*x* ≥ {left}"),
    ];
    let panels = panels(sheet, &lines.each_ref().map(String::as_str), 1.7)?;

    let mut polygon = STAR.map(DVec2::from).to_vec();
    for (i, (panel, half)) in panels.into_iter().zip(halves()).enumerate() {
        let board = Board::fit(WINDOW, SHOWN, panel)?;
        board.draw_window(sheet);
        let kept = clip_against_line(&polygon, half);
        board.draw_cut_off(sheet, &polygon);
        board.draw_kept(sheet, &kept);
        if let Some(line) = board.lines().get(i) {
            let [a, b] = line.map(|p| board.at(p));
            sheet.line(a, b, Pen::new(Role::Text, NORMAL));
        }
        for &p in kept.iter().filter(|p| !polygon.contains(p)) {
            marks::point(sheet, board.at(p), Role::Chosen);
        }
        polygon = kept;
    }
    Ok(())
}

/// The inner sides of the window's lines, in the order of [`Board::lines`].
fn halves() -> [HalfPlane; 4] {
    [
        (DVec2::NEG_Y, -WINDOW.max.y),
        (DVec2::Y, WINDOW.min.y),
        (DVec2::NEG_X, -WINDOW.max.x),
        (DVec2::X, WINDOW.min.x),
    ]
    .map(|(normal, offset)| HalfPlane { normal, offset })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_cuts_one_tip_and_the_last_picture_is_the_clipped_polygon() {
        let mut polygon = STAR.map(DVec2::from).to_vec();
        for half in halves() {
            let kept = clip_against_line(&polygon, half);
            // A tip goes, two crossings come.
            assert_eq!(kept.len(), polygon.len() + 1);
            let new: Vec<&DVec2> = kept.iter().filter(|p| !polygon.contains(p)).collect();
            assert_eq!(new.len(), 2);
            assert!(new.iter().all(|p| half.normal.dot(**p) == half.offset));
            polygon = kept;
        }
        let at_once = ombra_clip::sutherland_hodgman::clip_polygon(&WINDOW, &STAR.map(DVec2::from));
        assert_eq!(at_once.len(), polygon.len());
        assert!(at_once.iter().all(|p| polygon.contains(p)));
    }
}
