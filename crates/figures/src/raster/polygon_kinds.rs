//! Four kinds of polygon under the two rules for what is inside.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::polygon::{FillRule, fill};

use super::columns::pixels;
use super::scanline::RULE_WORD;
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::{Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/polygon-kinds",
    takes: Takes::These(&[POLYGON.input, RULES.input]),
    words: WORDS,
    about: |inputs, language| {
        let summary = if inputs.has(&POLYGON) {
            OWN_SUMMARY
        } else {
            SUMMARY
        };
        About::new(language, summary, CAPTION)
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Four kinds of polygon under the even-odd and the non-zero rule",
        it: "Quattro tipi di poligono con la regola pari-dispari e con quella non-zero",
        cs: "Čtyři druhy polygonů podle pravidla sudá-lichá a nenulového pravidla",
        hr: "Četiri vrste poligona po pravilu par-nepar i po pravilu različito od nule",
    }

    /// The summary with a polygon of one's own.
    OWN_SUMMARY {
        en: "A polygon under the even-odd and the non-zero rule",
        it: "Un poligono con la regola pari-dispari e con quella non-zero",
        cs: "Polygon podle pravidla sudá-lichá a nenulového pravidla",
        hr: "Poligon po pravilu par-nepar i po pravilu različito od nule",
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
        en: "compound",
        it: "multiplo",
        cs: "složený",
        hr: "složen",
    }

    /// An input.
    OWN_WORD {
        en: "the corners of a polygon of one’s own, shown in place of the four",
        it: "i vertici di un poligono proprio, mostrato al posto dei quattro",
        cs: "vrcholy vlastního polygonu, ukázaného místo čtyř",
        hr: "vrhovi vlastitog poligona, prikazanog umjesto četiriju",
    }
}

/// Pixels across and down.
const SIZE: u32 = 10;
const CONVEX: &[&[[f64; 2]]] = &[&[[5.2, 9.4], [9.4, 6.3], [7.8, 0.9], [2.3, 0.6], [0.6, 5.8]]];
const CONCAVE: &[&[[f64; 2]]] = &[&[
    [0.7, 0.7],
    [5.0, 4.2],
    [9.3, 0.7],
    [9.3, 9.3],
    [5.0, 6.7],
    [0.7, 9.3],
]];
/// In one stroke: its middle is wound round twice.
const STAR: &[[f64; 2]] = &[[5.0, 9.8], [8.0, 0.3], [0.1, 6.2], [9.9, 6.2], [2.0, 0.3]];
/// Around two others, one in its own direction, one against it.
const SEVERAL: &[&[[f64; 2]]] = &[
    &[[0.3, 0.3], [9.7, 0.3], [9.7, 9.7], [0.3, 9.7]],
    &[[2.3, 2.3], [4.3, 2.3], [4.3, 7.7], [2.3, 7.7]],
    &[[5.7, 2.3], [5.7, 7.7], [7.7, 7.7], [7.7, 2.3]],
];
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "",
    OWN_WORD,
    STAR,
    [3, 12],
    [[0.0; 2], [10.0; 2]],
);
const RULES: Ask<&'static str> = Ask::choice(
    "rule",
    "",
    RULE_WORD,
    "both",
    &["both", "even-odd", "non-zero"],
);
/// The line above pictures of one rule.
const HEADING: f64 = 1.5 * LABEL;
/// The line with a kind's name.
const NAME: f64 = 1.7 * LABEL;
/// Between two kinds.
const BETWEEN: f64 = 36.0;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let mut rules = vec![(EVEN_ODD, FillRule::EvenOdd), (NON_ZERO, FillRule::NonZero)];
    let asked = inputs.get(&RULES);
    rules.retain(|(word, _)| asked == "both" || asked == word.en);
    if inputs.has(&POLYGON) {
        return draw_own(sheet, &inputs.get(&POLYGON), &rules);
    }
    let kinds = [
        (KIND_CONVEX, CONVEX),
        (KIND_CONCAVE, CONCAVE),
        (KIND_CROSSED, &[STAR]),
        (KIND_SEVERAL, SEVERAL),
    ];
    // Four beside each other, or two on a narrow sheet.
    let frame = sheet.frame();
    let across = if frame.size().x > 1.1 * frame.size().y {
        4
    } else {
        2
    };
    let (columns, rows, count) = (f64::from(across), f64::from(4 / across), rules.len() as f64);
    let block = (frame.size() + BETWEEN) / DVec2::new(columns, rows) - BETWEEN;
    let side = block.x.min((block.y - NAME) / count - HEADING);
    let used = count * (HEADING + side) + NAME;
    let start = frame.centre().y - 0.5 * (rows * (used + BETWEEN) - BETWEEN);
    for (i, (word, contours)) in (0_u32..).zip(kinds) {
        let (column, row) = (f64::from(i % across), f64::from(i / across));
        let left = frame.min.x + column * (block.x + BETWEEN);
        let middle = left + 0.5 * block.x;
        let mut top = start + row * (used + BETWEEN);
        sheet.step(i as usize + 1);
        for (name, rule) in &rules {
            // The first of a row names the rule for all.
            if i % across == 0 {
                let at = DVec2::new(middle - 0.5 * side, top + 0.45 * HEADING);
                sheet.text(at, Align::Left, name.text(language), LABEL, Role::Text)?;
            }
            top += HEADING;
            let frame = Rect::new(
                DVec2::new(middle - 0.5 * side, top),
                DVec2::new(middle + 0.5 * side, top + side),
            );
            draw_filled(sheet, frame, &contours_of(contours), *rule);
            top += side;
        }
        let at = DVec2::new(middle, top + 0.6 * NAME);
        sheet.text(at, Align::Centre, word.text(language), LABEL, Role::Text)?;
    }
    sheet.step(0);
    Ok(())
}

/// A polygon of one's own, as large as there is room.
fn draw_own(
    sheet: &mut Sheet,
    polygon: &[DVec2],
    rules: &[(Word, FillRule)],
) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines: Vec<&str> = rules.iter().map(|(word, _)| word.text(language)).collect();
    for (i, (panel, (_, rule))) in panels(sheet, &lines, 1.0)?
        .into_iter()
        .zip(rules)
        .enumerate()
    {
        sheet.panel(i, panel);
        draw_filled(sheet, panel, &[polygon.to_vec()], *rule);
    }
    Ok(())
}

fn contours_of(contours: &[&[[f64; 2]]]) -> Vec<Vec<DVec2>> {
    let contour = |contour: &&[[f64; 2]]| contour.iter().copied().map(DVec2::from).collect();
    contours.iter().map(contour).collect()
}

fn draw_filled(sheet: &mut Sheet, frame: Rect, contours: &[Vec<DVec2>], rule: FillRule) {
    let last = IVec2::splat(SIZE as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Raised, frame);
    let on = fill(contours, rule, SIZE, SIZE).map_or(Vec::new(), pixels);
    grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
    for contour in contours {
        grid.polygon(sheet, contour);
        // The direction counts under the non-zero rule.
        let [from, to] = [0, 1].map(|i| contour.get(i).copied().unwrap_or_default());
        let middle = grid.at(0.5 * (from + to));
        let along = (grid.at(to) - grid.at(from)).normalize_or_zero();
        let reach = (0.4 * grid.at(to).distance(grid.at(from))).min(18.0);
        marks::arrow(
            sheet,
            middle - reach * along,
            middle + reach * along,
            Role::Text,
            NORMAL,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(contours: &[&[[f64; 2]]], rule: FillRule) -> Vec<IVec2> {
        pixels(fill(&contours_of(contours), rule, SIZE, SIZE).unwrap())
    }

    #[test]
    fn the_rules_differ_in_the_stars_middle_and_in_one_hole() {
        for simple in [CONVEX, CONCAVE] {
            assert_eq!(
                filled(simple, FillRule::EvenOdd),
                filled(simple, FillRule::NonZero)
            );
        }
        let middle = IVec2::new(4, 4);
        assert!(!filled(&[STAR], FillRule::EvenOdd).contains(&middle));
        assert!(filled(&[STAR], FillRule::NonZero).contains(&middle));
        // Centres ½, 3/2, …: 10 × 10 within 0.3 … 9.7, and 2 × 6 within each of the inner contours.
        let holes = [
            filled(SEVERAL, FillRule::EvenOdd),
            filled(SEVERAL, FillRule::NonZero),
        ];
        assert_eq!(holes.map(|on| on.len()), [100 - 2 * 12, 100 - 12]);
    }
}
