//! The next midpoint after E and after NE, and what the decision gains on the way.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::{Choice, Step, trace};

use super::columns::SEGMENT;
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/bresenham-increments",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Bresenham: the next midpoint after E and after NE",
        it: "Bresenham: il punto di mezzo successivo dopo E e dopo NE",
        cs: "Bresenham: další prostřední bod po E a po NE",
        hr: "Bresenham: sljedeće polovište nakon E i nakon NE",
    }

    CAPTION {
        en: "The decision at the next midpoint *M*′ is an addition away: *dy* after E, *dy* − *dx* after NE.",
        it: "La decisione nel punto di mezzo successivo *M*′ costa un’addizione: *dy* dopo E, *dy* − *dx* dopo NE.",
        cs: "K rozhodnutí v dalším prostředním bodě *M*′ stačí sčítání: *dy* po E, *dy* − *dx* po NE.",
        hr: "Do odluke u sljedećem polovištu *M*′ dovoljno je zbrajanje: *dy* nakon E, *dy* − *dx* nakon NE.",
    }

    /// After a choice: before its name.
    AFTER {
        en: "after",
        it: "dopo",
        cs: "po",
        hr: "nakon",
    }
}

/// The pixels of [`SEGMENT`] shown: one goes on to E, one to NE.
const COLUMNS: [usize; 2] = [2, 1];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let (a, b) = SEGMENT;
    let after = AFTER.text(sheet.style().language);
    let pairs = COLUMNS.map(|x| Some((trace(a, b).nth(x)?, trace(a, b).nth(x + 1)?)));
    let pairs: Vec<(Step, Step)> = pairs.into_iter().flatten().collect();
    let lines: Vec<String> = pairs
        .iter()
        .map(|(step, next)| {
            let [d, new] = [step, next].map(|step| exact(step.decision as f64 / 2.0));
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            let added = match step.choice {
                Choice::E => format!("+ {dy}"),
                Choice::NE => format!("+ {dy} − {dx}"),
            };
            let sum = format!("*d* = {d} {added} = {new}").replace(' ', "\u{a0}");
            format!("{after}\u{a0}{}: {sum}", step.choice)
        })
        .collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    for (panel, (step, next)) in panels(sheet, &lines, 1.0)?.into_iter().zip(&pairs) {
        draw_increment(sheet, panel, step, next);
    }
    Ok(())
}

fn draw_increment(sheet: &mut Sheet, panel: Rect, step: &Step, next: &Step) {
    let p = step.pixel;
    let grid = Grid::fit(p, p + IVec2::splat(2), Orientation::Mathematical, panel);
    grid.draw(sheet, &[(Role::Chosen.into(), &[p, next.pixel])]);
    let m = f64::from(SEGMENT.1.y) / f64::from(SEGMENT.1.x);
    let [from, to] = [-0.5, 2.5].map(|x| f64::from(p.x) + x);
    grid.line(sheet, DVec2::new(from, m * from), DVec2::new(to, m * to));

    for (pixel, name) in [(p, "*P*"), (next.pixel, step.choice.to_string().as_str())] {
        marks::point(sheet, grid.centre(pixel), Role::Chosen);
        let label = Label::new(grid.centre(pixel), name).towards(DVec2::Y);
        sheet.label(label.size(1.25 * LABEL).beside());
    }
    let [old, new] = [step, next].map(|step| {
        let p = step.pixel.as_dvec2();
        grid.at(p + DVec2::new(1.0, 0.5))
    });
    let along = (new - old).normalize_or_zero();
    let rim = 2.0 * marks::DOT;
    marks::arrow(
        sheet,
        old + along * rim,
        new - along * rim,
        Role::Text,
        NORMAL,
    );
    // M off the border of the pixels, M′ beyond the arrow.
    let before = DVec2::new(-1.0, if along.y < 0.0 { 1.0 } else { -1.0 });
    for (at, name, towards) in [(old, "*M*", before), (new, "*M*′", along)] {
        marks::hollow_point(sheet, at, Role::Undecided);
        let label = Label::new(at, name).towards(towards);
        sheet.label(label.size(1.25 * LABEL).beside());
    }
    // The line runs between the arrow to NE and what lies above it.
    let (increment, share, towards) = match step.choice {
        Choice::E => ("+ *dy*", 0.5, DVec2::NEG_Y),
        Choice::NE => ("+ *dy* − *dx*", 0.25, DVec2::X),
    };
    let label = Label::new(old.lerp(new, share), increment).towards(towards);
    sheet.label(label.size(1.25 * LABEL).beside());
}
