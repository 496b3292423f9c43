//! Four kinds of polygon under the two rules for what is inside.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::polygon::{FillRule, fill};

use super::columns::pixels;
use crate::colour::Role;
use crate::drawing::THIN;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/polygon-kinds",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Four kinds of polygon under the even-odd and the non-zero rule",
        it: "Quattro tipi di poligono con la regola pari-dispari e con quella non-zero",
        cs: "Čtyři druhy polygonů podle pravidla sudá-lichá a nenulového pravidla",
        hr: "Četiri vrste poligona po pravilu par-nepar i po pravilu različito od nule",
    }

    CAPTION {
        en: "Inside is what the contours wind round an odd number of times, or a number of times other than 0. Arrows show the direction.",
        it: "È interno ciò attorno a cui i contorni girano un numero dispari di volte, o non zero volte. Le frecce dicono il verso.",
        cs: "Uvnitř je to, co obrysy obíhají lichým počtem otočení, nebo nenulovým. Šipky udávají směr.",
        hr: "Unutra je ono što konture obilaze neparan broj puta, ili broj puta različit od nule. Strelice pokazuju smjer.",
    }

    /// The rule of odd winding numbers.
    EVEN_ODD {
        en: "even-odd",
        it: "pari-dispari",
        cs: "sudá-lichá",
        hr: "par-nepar",
    }

    /// The rule of winding numbers that are not 0.
    NON_ZERO {
        en: "non-zero",
        it: "non-zero",
        cs: "nenulová",
        hr: "različito od nule",
    }

    /// The first kind.
    KIND_CONVEX {
        en: "convex",
        it: "convesso",
        cs: "konvexní",
        hr: "konveksan",
    }

    /// The second kind.
    KIND_CONCAVE {
        en: "concave",
        it: "concavo",
        cs: "nekonvexní",
        hr: "konkavan",
    }

    /// The third kind.
    KIND_CROSSED {
        en: "self-crossing",
        it: "intrecciato",
        cs: "překřížený",
        hr: "samosijekući",
    }

    /// The fourth kind.
    KIND_SEVERAL {
        en: "several contours",
        it: "a contorni multipli",
        cs: "více obrysů",
        hr: "više kontura",
    }
}

/// Pixels across and down.
const SIZE: u32 = 12;
const CONVEX: &[&[(f64, f64)]] = &[&[
    (6.2, 0.8),
    (11.2, 4.4),
    (9.4, 10.8),
    (2.8, 11.2),
    (0.8, 5.0),
]];
const CONCAVE: &[&[(f64, f64)]] = &[&[
    (1.0, 1.0),
    (6.0, 5.2),
    (11.0, 1.0),
    (11.0, 11.0),
    (6.0, 8.0),
    (1.0, 11.0),
]];
/// In one stroke: its middle is wound round twice.
const STAR: &[&[(f64, f64)]] = &[&[
    (6.0, 0.3),
    (9.5, 11.3),
    (0.2, 4.5),
    (11.8, 4.5),
    (2.5, 11.3),
]];
/// Around two others, one in its own direction, one against it.
const SEVERAL: &[&[(f64, f64)]] = &[
    &[(0.8, 0.8), (11.2, 0.8), (11.2, 11.2), (0.8, 11.2)],
    &[(2.8, 2.8), (5.2, 2.8), (5.2, 9.2), (2.8, 9.2)],
    &[(6.8, 2.8), (6.8, 9.2), (9.2, 9.2), (9.2, 2.8)],
];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let kinds = [
        (KIND_CONVEX, CONVEX),
        (KIND_CONCAVE, CONCAVE),
        (KIND_CROSSED, STAR),
        (KIND_SEVERAL, SEVERAL),
    ];
    let lines = kinds.map(|(word, _)| word.text(language));
    let heading = 1.9 * LABEL;
    let panels = panels(sheet, &lines, 2.4)?;
    let Some(first) = panels.first() else {
        return Ok(());
    };
    let half = 0.5 * first.size().y;
    for (row, word, rule) in [
        (0.0, EVEN_ODD, FillRule::EvenOdd),
        (1.0, NON_ZERO, FillRule::NonZero),
    ] {
        let top = first.min.y + half * row;
        let at = DVec2::new(first.min.x, top + heading - LABEL);
        sheet.text(at, Align::Left, word.text(language), LABEL, Role::Text)?;
        for (panel, (_, contours)) in panels.iter().zip(kinds) {
            let frame = Rect::new(
                DVec2::new(panel.min.x, top + heading),
                DVec2::new(panel.max.x, top + half),
            );
            draw_filled(sheet, frame, contours, rule);
        }
    }
    Ok(())
}

fn draw_filled(sheet: &mut Sheet, frame: Rect, contours: &[&[(f64, f64)]], rule: FillRule) {
    let contours: Vec<Vec<DVec2>> = contours
        .iter()
        .map(|contour| contour.iter().copied().map(DVec2::from).collect())
        .collect();
    let last = IVec2::splat(SIZE as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, frame);
    let on = fill(&contours, rule, SIZE, SIZE).map_or(Vec::new(), pixels);
    grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
    for contour in &contours {
        grid.polygon(sheet, contour);
        // The direction counts under the non-zero rule.
        let [from, to] = [0, 1].map(|i| contour.get(i).copied().unwrap_or_default());
        let middle = grid.at(0.5 * (from + to));
        let along = (grid.at(to) - grid.at(from)).normalize_or_zero();
        marks::arrow(
            sheet,
            middle - 14.0 * along,
            middle + 14.0 * along,
            Role::Text,
            THIN,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(contours: &[&[(f64, f64)]], rule: FillRule) -> Vec<IVec2> {
        let contours: Vec<Vec<DVec2>> = contours
            .iter()
            .map(|contour| contour.iter().copied().map(DVec2::from).collect())
            .collect();
        pixels(fill(&contours, rule, SIZE, SIZE).unwrap())
    }

    #[test]
    fn the_rules_differ_in_the_stars_middle_and_in_one_hole() {
        for simple in [CONVEX, CONCAVE] {
            assert_eq!(
                filled(simple, FillRule::EvenOdd),
                filled(simple, FillRule::NonZero)
            );
        }
        let middle = IVec2::new(5, 6);
        assert!(!filled(STAR, FillRule::EvenOdd).contains(&middle));
        assert!(filled(STAR, FillRule::NonZero).contains(&middle));
        // Centres ½, 3/2, …: 10 × 10 within 0.8 … 11.2, and 2 × 6 within each of the inner contours.
        let holes = [
            filled(SEVERAL, FillRule::EvenOdd),
            filled(SEVERAL, FillRule::NonZero),
        ];
        assert_eq!(holes.map(|on| on.len()), [100 - 2 * 12, 100 - 12]);
    }
}
