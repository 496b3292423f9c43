//! From a pixel to E or to NE: on which side of the midpoint the line passes.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_raster::bresenham::{Choice, Step};

use super::columns::{A, AT, B, Ends};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Inputs;
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
        en: "Bresenham: E or NE, by the side of the midpoint on which the line passes",
        it: "Bresenham: E o NE, secondo il lato del punto di mezzo da cui passa la retta",
        cs: "Bresenham: E nebo NE podle toho, kde přímka míjí prostřední bod",
        hr: "Bresenham: E ili NE, prema tome s koje strane polovišta prolazi pravac",
    }

    CAPTION {
        en: "*Q* below *M*: E is nearer. *Q* above *M*: NE is nearer. For 2*F* = 0 both are equally near, and E is taken.",
        it: "*Q* sotto *M*: è più vicino E. *Q* sopra *M*: è più vicino NE. Con 2*F* = 0 è indifferente, e si prende E.",
        cs: "*Q* pod *M*: blíž je E. *Q* nad *M*: blíž je NE. Při 2*F* = 0 jsou stejně daleko a bere se E.",
        hr: "*Q* ispod *M*: bliži je E. *Q* iznad *M*: bliži je NE. Za 2*F* = 0 jednako su daleko i uzima se E.",
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let ends = Ends::of(inputs);
    let moves = ends.two_moves(inputs.get(&AT))?;
    let lines: Vec<String> = moves.iter().map(|(_, step)| line(step)).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let panels = panels(sheet, &lines, 1.0)?;
    for (n, (panel, (i, step))) in panels.into_iter().zip(moves).enumerate() {
        sheet.panel(n, panel);
        draw_choice(sheet, panel, ends, f64::from(i), &step);
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
    let sign = if step.decision == 0 {
        String::new()
    } else {
        format!(" {sign}")
    };
    let decision = exact(step.decision as f64);
    format!("2*F*(*M*) = {decision}{sign}: {}", step.choice).replace(' ', "\u{a0}")
}

fn draw_choice(sheet: &mut Sheet, panel: Rect, ends: Ends, i: f64, step: &Step) {
    let [to_east, to_north] = ends.moves();
    let p = step.pixel;
    let [east, north_east] = [p + to_east, p + to_east + to_north];
    let grid = Grid::fit(
        p.min(north_east),
        p.max(north_east),
        Orientation::Mathematical,
        panel,
    );
    let (chosen, rejected) = match step.choice {
        Choice::E => (east, north_east),
        Choice::NE => (north_east, east),
    };
    grid.draw_cells(sheet);
    grid.fill(sheet, &[p, chosen], Role::Chosen.into());
    let left_out = grid.cells(&[rejected]);
    sheet.stroke_unmarked(left_out, Pen::new(Role::Rejected, NORMAL).dashed());

    // The line across the cells, and the column where it is decided.
    let both = [east, north_east].map(|pixel| grid.centre(pixel));
    sheet.line(both[0], both[1], Pen::new(Role::Note, THIN).dashed());
    ends.draw_line(sheet, &grid, [i - 0.5, i + 1.5]);

    // Directions on the sheet, whatever the octant.
    let e = (both[0] - grid.centre(p)).normalize_or_zero();
    let n = (both[1] - both[0]).normalize_or_zero();
    let height = |q: DVec2, from: DVec2| (q - from).dot(n);
    let above = height(grid.at(ends.on_line(i)), grid.centre(p)) < 0.0;
    let beside_p = if above { e + n } else { e - n };
    for (pixel, name, towards) in [
        (p, "*P*", beside_p),
        (east, "E", e - n),
        (north_east, "NE", e + n),
    ] {
        let at = grid.centre(pixel);
        if pixel == rejected {
            marks::hollow_point(sheet, at, Role::Rejected);
        } else {
            marks::point(sheet, at, Role::Chosen);
        }
        sheet.label(large(at, name).towards(towards));
    }
    let midpoint = 0.5 * (both[0] + both[1]);
    let q = grid.at(ends.on_line(i + 1.0));
    marks::hollow_point(sheet, midpoint, Role::Undecided);
    marks::point(sheet, q, Role::Text);
    // M in the cell that is left out, Q on the side of M, where the line leaves room.
    let out = (grid.centre(rejected) - midpoint).normalize_or_zero();
    sheet.label(large(midpoint, "*M*").towards(out - e));
    let aside = if step.decision > 0 { e - n } else { n - e };
    sheet.label(large(q, "*Q*").towards(aside));
}

/// A name in large letters: there is room.
fn large(at: DVec2, name: &str) -> Label {
    Label::new(at, name).size(1.25 * LABEL).beside()
}
