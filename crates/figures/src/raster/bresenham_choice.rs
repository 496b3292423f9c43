//! From a pixel to E or to NE: on which side of the midpoint the line passes.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::{Choice, Step, trace};

use super::columns::SEGMENT;
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
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
    id: "raster/bresenham-choice",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Bresenham: E or NE, by the side of the midpoint on which the line passes",
        it: "Bresenham: E o NE, secondo il lato del punto di mezzo da cui passa la retta",
        cs: "Bresenham: E nebo NE podle toho, kde přímka míjí prostřední bod",
        hr: "Bresenham: E ili NE, prema tome s koje strane polovišta prolazi pravac",
    }

    CAPTION {
        en: "*Q* below *M*: E is nearer. *Q* above *M*: NE is nearer. For *d* = 0 both are equally near, and E is taken.",
        it: "*Q* sotto *M*: è più vicino E. *Q* sopra *M*: è più vicino NE. Con *d* = 0 è indifferente, e si prende E.",
        cs: "*Q* pod *M*: blíž je E. *Q* nad *M*: blíž je NE. Při *d* = 0 jsou stejně daleko a bere se E.",
        hr: "*Q* ispod *M*: bliži je E. *Q* iznad *M*: bliži je NE. Za *d* = 0 jednako su daleko i uzima se E.",
    }
}

/// Pixels of [`SEGMENT`] from which the line passes well below the midpoint, and well above it.
const COLUMNS: [usize; 2] = [2, 4];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let (a, b) = SEGMENT;
    let steps = COLUMNS.map(|x| trace(a, b).nth(x)).into_iter().flatten();
    let steps: Vec<Step> = steps.collect();
    let lines: Vec<String> = steps.iter().map(line).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    for (panel, step) in panels(sheet, &lines, 1.0)?.into_iter().zip(&steps) {
        draw_choice(sheet, panel, step);
    }
    Ok(())
}

/// The decision in one line.
fn line(step: &Step) -> String {
    let sign = match step.decision.cmp(&0) {
        Ordering::Less => "< 0",
        Ordering::Equal => "= 0",
        Ordering::Greater => "> 0",
    };
    let d = exact(step.decision as f64 / 2.0);
    format!("*d* = *F*(*M*) = {d} {sign}: {}", step.choice)
}

fn draw_choice(sheet: &mut Sheet, panel: Rect, step: &Step) {
    let p = step.pixel;
    let [east, north_east] = [p + IVec2::X, p + IVec2::ONE];
    let grid = Grid::fit(p, north_east, Orientation::Mathematical, panel);
    let (chosen, rejected) = match step.choice {
        Choice::E => (east, north_east),
        Choice::NE => (north_east, east),
    };
    grid.draw_cells(sheet);
    grid.fill(sheet, &[p, chosen], Role::Chosen.into());
    sheet.stroke_unmarked(
        grid.cells(&[rejected]),
        Pen::new(Role::Rejected, NORMAL).dashed(),
    );

    // The line across the cells, and the column where it is decided.
    let m = f64::from(SEGMENT.1.y) / f64::from(SEGMENT.1.x);
    let on_line = |x: f64| DVec2::new(x, m * x);
    let x = f64::from(p.x);
    let next = x + 1.0;
    sheet.line(
        grid.centre(east),
        grid.centre(north_east),
        Pen::new(Role::Note, THIN).dashed(),
    );
    grid.line(sheet, on_line(x - 0.5), on_line(next + 0.5));

    for (pixel, name, towards) in [
        (p, "*P*", DVec2::X),
        (east, "E", DVec2::ONE),
        (north_east, "NE", DVec2::new(1.0, -1.0)),
    ] {
        let at = grid.centre(pixel);
        if pixel == rejected {
            marks::hollow_point(sheet, at, Role::Rejected);
        } else {
            marks::point(sheet, at, Role::Chosen);
        }
        sheet.label(large(at, name).towards(towards));
    }
    let midpoint = grid.at(DVec2::new(next, f64::from(p.y) + 0.5));
    let q = grid.at(on_line(next));
    marks::hollow_point(sheet, midpoint, Role::Undecided);
    marks::point(sheet, q, Role::Text);
    // M in the cell that is left out, Q on the side of M, where the line leaves room.
    let free = DVec2::new(-1.0, (grid.centre(rejected) - midpoint).y.signum());
    sheet.label(large(midpoint, "*M*").towards(free));
    let aside = DVec2::splat((midpoint - q).y.signum());
    sheet.label(large(q, "*Q*").towards(aside));
}

/// A name in large letters: there is room.
fn large(at: DVec2, name: &str) -> Label {
    Label::new(at, name).size(1.25 * LABEL).beside()
}
