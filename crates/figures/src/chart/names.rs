//! The names of a chart's curves: a column at their ends, or a list below the chart.

use ombra_math::glam::DVec2;

use super::axes::LEADING;
use super::curve::{curve, mark};
use super::{Chart, Series};
use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::marks::DOT;
use crate::path::{Path, Rect};
use crate::sheet::Sheet;
use crate::text::{LABEL, Line, NOTE, SMALLEST, wrapped};

/// Letters of names and of notes below them, from the largest on.
const SIZES: [[f64; 2]; 3] = [[LABEL, NOTE], [NOTE, SMALLEST], [SMALLEST, SMALLEST]];
/// The least width over height of a frame whose names stand in a column.
const WIDE: f64 = 1.5;
/// The most of the frame's width that a column takes.
const SHARE: f64 = 0.38;
/// Room for the mark before a name.
const MARK: f64 = 2.0 * DOT + 16.0;
/// From the curves to the column.
const GAP: f64 = 56.0;
/// Between two names.
const APART: f64 = 14.0;

/// The name of one curve with what is said below it.
struct Entry {
    series: usize,
    lines: Vec<(Line, f64, Role)>,
    height: f64,
    width: f64,
    /// Whether it names the end of a line.
    leads: bool,
}

/// The names of all curves that are drawn.
pub(super) struct Names {
    entries: Vec<Entry>,
    frame: Rect,
    /// Where a column may begin.
    top: f64,
    /// The number of columns of a list; none for a column at the curves' ends.
    columns: Option<usize>,
}

impl Names {
    /// The ways to set them, in the largest letters first; with `top` the upper end of a column.
    pub(super) fn ways(chart: &Chart, frame: Rect, top: f64) -> Result<Vec<Names>, FigureError> {
        let size = frame.size();
        let is_wide = size.x >= WIDE * size.y;
        let mut ways = Vec::new();
        for sizes in SIZES {
            if is_wide {
                let most = SHARE * size.x;
                let entries = entries(chart, sizes, most - GAP - MARK)?;
                let names = Names {
                    entries,
                    frame,
                    top,
                    columns: None,
                };
                if names.column_height() <= frame.max.y - top && names.beside() <= most {
                    ways.push(names);
                }
                continue;
            }
            let lists = [3_u32, 2, 1].map(|columns| {
                let width = size.x / f64::from(columns) - MARK - APART;
                let entries = entries(chart, sizes, width)?;
                let fits = entries.iter().all(|entry| entry.width <= width);
                Ok(fits.then_some(Names {
                    entries,
                    frame,
                    top,
                    columns: Some(columns as usize),
                }))
            });
            let lists: Vec<Option<Names>> =
                lists.into_iter().collect::<Result<_, FigureError>>()?;
            let lowest = |a: &Names, b: &Names| a.below().total_cmp(&b.below());
            ways.extend(lists.into_iter().flatten().min_by(lowest));
        }
        Ok(ways)
    }

    /// How much of the width they take.
    pub(super) fn beside(&self) -> f64 {
        match self.columns {
            Some(_) => 0.0,
            None if self.entries.is_empty() => 0.0,
            None => {
                GAP + MARK
                    + self
                        .entries
                        .iter()
                        .map(|entry| entry.width)
                        .fold(0.0, f64::max)
            }
        }
    }

    /// How much of that a tick's label may take.
    pub(super) fn spare(&self) -> f64 {
        if self.beside() > 0.0 {
            GAP - APART
        } else {
            0.0
        }
    }

    /// How much of the height they take.
    pub(super) fn below(&self) -> f64 {
        let heights = self
            .rows()
            .map(|row| row.iter().map(|entry| entry.height).fold(0.0, f64::max) + APART);
        heights.sum()
    }

    /// The rows of a list.
    fn rows(&self) -> impl Iterator<Item = &[Entry]> {
        let columns = self.columns.unwrap_or(0);
        let listed = if columns == 0 { &[] } else { &self.entries[..] };
        listed.chunks(columns.max(1))
    }

    fn column_height(&self) -> f64 {
        self.entries
            .iter()
            .map(|entry| entry.height + APART)
            .sum::<f64>()
            - APART
    }

    /// Draws them; `points` are those of each series.
    pub(super) fn draw(&self, sheet: &mut Sheet, area: Rect, points: &[Vec<DVec2>]) {
        if let Some(columns) = self.columns {
            let width = self.frame.size().x / columns as f64;
            let mut y = self.frame.max.y - self.below() + APART;
            for row in self.rows() {
                let mut x = self.frame.min.x;
                for entry in row {
                    entry.draw(sheet, DVec2::new(x, y));
                    x += width;
                }
                y += row.iter().map(|entry| entry.height).fold(0.0, f64::max) + APART;
            }
            return;
        }
        let ends = |entry: &Entry| {
            points
                .get(entry.series)
                .and_then(|points| points.last())
                .copied()
        };
        let mut order: Vec<&Entry> = self.entries.iter().collect();
        let height = |entry: &Entry| ends(entry).map_or(area.max.y, |end| end.y);
        order.sort_by(|a, b| {
            height(a)
                .total_cmp(&height(b))
                .then(a.series.cmp(&b.series))
        });
        let wanted: Vec<(f64, f64)> = order
            .iter()
            .map(|entry| (height(entry) - entry.first() * 0.5, entry.height + APART))
            .collect();
        let tops = stacked(&wanted, self.top, self.frame.max.y + APART);
        let x = self.frame.max.x - (self.beside() - GAP);
        for (entry, top) in order.into_iter().zip(tops) {
            entry.draw(sheet, DVec2::new(x, top));
            let at = DVec2::new(x - 6.0, top + 0.5 * entry.first());
            // From an end at the right border a line leads to the name.
            if let Some(end) = ends(entry).filter(|end| entry.leads && end.x > area.max.x - GAP) {
                let start = end + DVec2::new(1.6 * DOT, 0.0);
                let pen = Pen::new(Role::Curve(curve(entry.series)), THIN);
                sheet.stroke_unmarked(Path::line(start, at), pen);
            }
        }
    }
}

impl Entry {
    /// The height of its first line.
    fn first(&self) -> f64 {
        self.lines.first().map_or(0.0, |(_, height, _)| *height)
    }

    fn draw(&self, sheet: &mut Sheet, corner: DVec2) {
        let middle = corner.y + 0.5 * self.first();
        mark(
            sheet,
            DVec2::new(corner.x + DOT + 2.0, middle),
            curve(self.series),
        );
        let mut y = corner.y;
        for (line, height, ink) in &self.lines {
            let centre = DVec2::new(corner.x + MARK + 0.5 * line.width, y + 0.5 * height);
            sheet.set_at(line.clone(), line.centred(centre), (*ink).into());
            y += height;
        }
    }
}

/// The names of the series that have points, broken into lines of at most `width` where words allow it.
fn entries(chart: &Chart, [name, note]: [f64; 2], width: f64) -> Result<Vec<Entry>, FigureError> {
    let drawn = chart.series.iter().enumerate();
    let drawn = drawn.filter(|(_, series)| !series.points.is_empty());
    drawn
        .map(|(i, series)| {
            let mut lines = Vec::new();
            for (words, size, ink) in said(series, i, name, note) {
                for line in wrapped(words, size, width)? {
                    let height = (LEADING * size).max(line.ascent + line.descent);
                    lines.push((line, height, ink));
                }
            }
            let height = lines.iter().map(|(_, height, _)| height).sum();
            let width = lines
                .iter()
                .map(|(line, ..)| line.width)
                .fold(0.0, f64::max);
            Ok(Entry {
                series: i,
                lines,
                height,
                width,
                leads: series.joined || !series.line.is_empty(),
            })
        })
        .collect()
}

/// What is said of a curve, each with its size and colour.
fn said(
    series: &Series,
    i: usize,
    name: f64,
    note: f64,
) -> impl Iterator<Item = (&str, f64, Role)> {
    let notes = [
        (series.note.as_str(), note, Role::Note),
        (series.end.as_str(), note, Role::Note),
    ];
    let names = series
        .name
        .split('\n')
        .map(move |words| (words, name, Role::Curve(curve(i))));
    names.chain(notes).filter(|(words, ..)| !words.is_empty())
}

/// The upper ends of things of some heights, as near as can be to where they are wanted, in that order, none over
/// another, from `top` to `bottom`.
///
/// Those that would meet stand together, at the mean of what each of them wants.
fn stacked(wanted: &[(f64, f64)], top: f64, bottom: f64) -> Vec<f64> {
    // Of each group: the sum of what its members want for its upper end, how many they are, and their height.
    let mut groups: Vec<(f64, usize, f64)> = Vec::new();
    let place = |&(sum, count, height): &(f64, usize, f64)| {
        (sum / count as f64).min(bottom - height).max(top)
    };
    for &(at, height) in wanted {
        groups.push((at, 1, height));
        while let [.., before, last] = groups.as_slice() {
            if place(before) + before.2 <= place(last) {
                break;
            }
            let joined = (
                before.0 + last.0 - last.1 as f64 * before.2,
                before.1 + last.1,
                before.2 + last.2,
            );
            groups.truncate(groups.len() - 2);
            groups.push(joined);
        }
    }
    let mut heights = wanted.iter().map(|(_, height)| height);
    let mut tops = Vec::with_capacity(wanted.len());
    for group in &groups {
        let mut y = place(group);
        for height in heights.by_ref().take(group.1) {
            tops.push(y);
            y += height;
        }
    }
    tops
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_where_they_are_wanted_or_together_about_it() {
        assert_eq!(
            stacked(&[(10.0, 20.0), (50.0, 20.0)], 0.0, 100.0),
            [10.0, 50.0]
        );
        // Wanted at one height: half above it, half below.
        assert_eq!(
            stacked(&[(50.0, 20.0), (50.0, 20.0)], 0.0, 100.0),
            [40.0, 60.0]
        );
        // At the borders they move inwards.
        assert_eq!(
            stacked(&[(-5.0, 20.0), (95.0, 20.0)], 0.0, 100.0),
            [0.0, 80.0]
        );
        assert_eq!(
            stacked(&[(95.0, 20.0), (95.0, 20.0)], 0.0, 100.0),
            [60.0, 80.0]
        );
        assert_eq!(stacked(&[], 0.0, 100.0), [0.0; 0]);
    }

    /// As long as there is room in all, none meets another or leaves it.
    #[test]
    fn none_meets_another() {
        let mut state = 1_u64;
        let mut next = |most: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            ((state >> 33) % most) as f64
        };
        for _ in 0..2000 {
            let number = next(10) as usize;
            let mut wanted: Vec<(f64, f64)> = (0..number)
                .map(|_| (next(300) - 50.0, 1.0 + next(20)))
                .collect();
            wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
            let tops = stacked(&wanted, 0.0, 200.0);
            assert_eq!(tops.len(), wanted.len());
            let mut least = 0.0;
            for (top, (_, height)) in tops.iter().zip(&wanted) {
                assert!(*top >= least - 1e-9, "{wanted:?} {tops:?}");
                least = top + height;
            }
            assert!(least <= 200.0 + 1e-9, "{wanted:?} {tops:?}");
        }
    }
}
