//! The next midpoint after E and after NE, and what the decision gains on the way.

use ombra_math::glam::IVec2;
use ombra_raster::bresenham::{Choice, Step};

use super::bresenham_trace::gain;
use super::columns::{A, AT, B, Ends};
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Inputs;
use crate::marks;
use crate::number::exact;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/bresenham-increments",
    takes: Takes::These(&[A.input, B.input, AT.input]),
    words: WORDS,
    about: |inputs, language| {
        let about = About::new(language, SUMMARY, CAPTION);
        Ends::of(inputs).about(about, language)
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Bresenham: the next midpoint after E and after NE",
        it: "Bresenham: il punto di mezzo successivo dopo E e dopo NE",
        cs: "Bresenham: další prostřední bod po E a po NE",
        hr: "Bresenham: sljedeće polovište nakon E i nakon NE",
    }

    CAPTION {
        en: "The decision at the next midpoint *M*′ is an addition of integers away: 2*dy* after E, 2*dy* − 2*dx* after NE.",
        it: "La decisione nel punto di mezzo successivo *M*′ costa un’addizione di interi: 2*dy* dopo E, 2*dy* − 2*dx* dopo NE.",
        cs: "K rozhodnutí v dalším prostředním bodě *M*′ stačí sčítání celých čísel: 2*dy* po E, 2*dy* − 2*dx* po NE.",
        hr: "Do odluke u sljedećem polovištu *M*′ dovoljno je zbrajanje cijelih brojeva: 2*dy* nakon E, 2*dy* − 2*dx* nakon NE.",
    }

    /// After a choice: before its name.
    AFTER {
        en: "after",
        it: "dopo",
        cs: "po",
        hr: "nakon",
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let ends = Ends::of(inputs);
    let moves = ends.two_moves(inputs.get(&AT))?;
    let after = AFTER.text(sheet.style().language);
    let [dx, dy] = ends.extent().map(i64::from);
    let line = |step: &Step| {
        let next = match step.choice {
            Choice::E => step.decision + 2 * dy,
            Choice::NE => step.decision + 2 * dy - 2 * dx,
        };
        let [old, new] = [step.decision, next].map(|decision| exact(decision as f64));
        let gain = gain(ends, step.choice)
            .replace('+', "+ ")
            .replace('−', "− ");
        let sum = format!("2*F*(*M*′) = {old} {gain} = {new}").replace(' ', "\u{a0}");
        format!("{after}\u{a0}{}: {sum}", step.choice)
    };
    let lines: Vec<String> = moves.iter().map(|(_, step)| line(step)).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let panels = panels(sheet, &lines, 1.0)?;
    for (n, (panel, (i, step))) in panels.into_iter().zip(moves).enumerate() {
        sheet.panel(n, panel);
        draw_increment(sheet, panel, ends, f64::from(i), &step)?;
    }
    Ok(())
}

fn draw_increment(
    sheet: &mut Sheet,
    panel: Rect,
    ends: Ends,
    i: f64,
    step: &Step,
) -> Result<(), FigureError> {
    let [to_east, to_north] = ends.moves();
    let p = step.pixel;
    let next = match step.choice {
        Choice::E => p + to_east,
        Choice::NE => p + to_east + to_north,
    };
    let far = p + 2 * to_east + 2 * to_north;
    let grid = Grid::fit(p.min(far), p.max(far), Orientation::Mathematical, panel);
    grid.draw(sheet, &[(Role::Chosen.into(), &[p, next])]);
    ends.draw_line(sheet, &grid, [i - 0.5, i + 2.5]);

    // Directions on the sheet, whatever the octant.
    let on_sheet = |step: IVec2| (grid.centre(p + step) - grid.centre(p)).normalize_or_zero();
    let [e, n] = [to_east, to_north].map(on_sheet);
    for (pixel, name) in [(p, "*P*"), (next, step.choice.to_string().as_str())] {
        marks::point(sheet, grid.centre(pixel), Role::Chosen);
        let label = Label::new(grid.centre(pixel), name).towards(-n);
        sheet.label(label.size(1.25 * LABEL).beside());
    }
    let midpoint = |p: IVec2| grid.at((p + to_east).as_dvec2() + 0.5 * to_north.as_dvec2());
    let (old, new) = (midpoint(p), midpoint(next));
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
    let before = match step.choice {
        Choice::E => n - e,
        Choice::NE => -n - e,
    };
    for (at, name, towards) in [(old, "*M*", before), (new, "*M*′", along)] {
        marks::hollow_point(sheet, at, Role::Undecided);
        let label = Label::new(at, name).towards(towards);
        sheet.label(label.size(1.25 * LABEL).beside());
    }
    // Below the arrow to NE there is a row of pixels for what it adds.
    if step.choice == Choice::NE && to_east.y == 0 {
        let at = grid.centre(p) + 1.55 * grid.cell() * e;
        sheet.text(
            at,
            Align::Centre,
            "+ 2*dy* − 2*dx*",
            1.1 * LABEL,
            Role::Text,
        )?;
        return Ok(());
    }
    let (increment, share, towards) = match step.choice {
        Choice::E => ("+ 2*dy*", 0.5, n),
        Choice::NE => ("+ 2*dy* − 2*dx*", 0.25, e),
    };
    let label = Label::new(old.lerp(new, share), increment).towards(towards);
    sheet.label(label.size(1.1 * LABEL).beside());
    Ok(())
}
