//! An edge followed from row to row in rounded arithmetic, with the columns exact all the same.
//!
//! A crossing X = x + slope · k is rounded to the nearest integer. Unless X lies so close to the half between
//! two integers, a pixel centre, that its error could matter, that integer is the column; otherwise the exact predicate
//! decides. For all but one crossing in thousands no predicate is asked.

use core::ops::Range;

use ombra_math::work::{Count, Counter};

use crate::edge::{Edge, first, first_centre};

/// More than the error of a stepped crossing, see [`Steps::near`].
pub(crate) const MARGIN: f64 = 1.0 / (1u64 << 14) as f64;
/// Widest picture whose crossings are kept in fixed point, with room for as much again on either side.
pub(crate) const WIDEST: u32 = 1 << 30;
/// Largest |x| of an end whose crossings are computed without exact arithmetic: in fixed point, and otherwise.
const REACH: [f64; 2] = [WIDEST as f64, (1u64 << 33) as f64];
/// An edge of more rows that leaves the picture is cut where it does.
const MANY_ROWS: u32 = 1024;
/// Adding it leaves no bit for a fraction: the sum is rounded to the nearest integer, kept in the low bits.
const TO_INTEGER: f64 = (3u64 << 51) as f64;

/// Where and how the crossings of an edge are computed.
///
/// In the rows of neither range, the edge passes to the right of the picture's last centre.
#[derive(Clone, Debug)]
pub(crate) struct Steps {
    /// Rows where it passes at or left of the first centre of the row: all centres are right of it.
    pub left: Range<u32>,
    /// Rows where the crossing is stepped.
    pub stepped: Range<u32>,
    /// Crossing in the first stepped row.
    pub x: f64,
    /// Its change a row.
    pub slope: f64,
}

impl Steps {
    /// The crossings of `edge` in a picture `width` columns wide.
    #[inline]
    pub fn new(edge: &Edge, width: u32) -> Self {
        Self::near(edge, width).unwrap_or_else(|| Self::far(edge, width))
    }

    /// The same without exact arithmetic; `None` for an edge with an end so far away that its crossings would lose
    /// their digits, or so long that walking along it outside the picture would cost more than finding where it enters.
    #[inline(always)]
    pub fn near(edge: &Edge, width: u32) -> Option<Self> {
        let (a, b) = (edge.top, edge.bottom);
        let Range { start, end } = edge.rows;
        let steps = |left_end, stepped_end, x, slope| {
            Some(Self {
                left: start..left_end,
                stepped: left_end..stepped_end,
                x,
                slope,
            })
        };
        let (least, most) = if a.x < b.x { (a.x, b.x) } else { (b.x, a.x) };
        let last_centre = f64::from(width) - 0.5;
        if most <= 0.5 {
            return steps(end, end, 0.0, 0.0);
        }
        if least > last_centre {
            return steps(start, start, 0.0, 0.0);
        }
        // With |x| ≤ B = 2³³ and u = 2⁻⁵³, the crossing in the first row is within 11 uB, the slope within 3u of
        // itself, the stepped crossing within 20 uB < 2⁻¹⁵. No vertical distance enters but as a ratio up to 1.
        let height = b.y - a.y;
        let reach = REACH[usize::from(width > WIDEST)];
        let in_reach = least >= -reach && most <= reach && height < f64::INFINITY;
        let leaves = least <= 0.5 || most > last_centre;
        if !in_reach || (leaves && end - start > MANY_ROWS) {
            return None;
        }
        if a.x == b.x {
            // One column for all rows; as an integer it is never in doubt.
            return steps(start, end, f64::from(first_centre(a.x, width)), 0.0);
        }
        let slope = (b.x - a.x) / height;
        let centre = f64::from(start) + 0.5;
        steps(start, end, a.x + slope * (centre - a.y), slope)
    }

    /// The same for all others.
    #[cold]
    pub fn far(edge: &Edge, width: u32) -> Self {
        let rows = edge.rows.clone();
        let last = width.saturating_sub(1);
        // Columns rise with the rows or fall: either way the picture's part lies between two rows.
        let (left, stepped) = if edge.top.x <= edge.bottom.x {
            let inside = first(rows.clone(), |row| edge.has_on_left(0, row));
            let right = first(inside..rows.end, |row| edge.has_on_left(last, row));
            (rows.start..inside, inside..right)
        } else {
            let inside = first(rows.clone(), |row| !edge.has_on_left(last, row));
            let left = first(inside..rows.end, |row| !edge.has_on_left(0, row));
            (left..rows.end, inside..left)
        };
        // Both ends lie in the picture now, rounded once.
        let (x, slope) = if stepped.is_empty() {
            (0.0, 0.0)
        } else {
            let (first, last) = (edge.x(stepped.start), edge.x(stepped.end - 1));
            let moves = stepped.end - 1 - stepped.start;
            (first, (last - first) / f64::from(moves.max(1)))
        };
        Self {
            left,
            stepped,
            x,
            slope,
        }
    }

    /// The rows in which not all centres are right of the edge, and those in which not all are left of it.
    pub fn beside(&self, edge: &Edge) -> [Range<u32>; 2] {
        // What is left of the picture is the edge's beginning, or its end.
        let not_left = if self.left.start == edge.rows.start {
            self.left.end..edge.rows.end
        } else {
            edge.rows.start..self.left.start
        };
        [not_left, hull(&self.left, &self.stepped)]
    }

    /// [`Edge::column`] in one of the edge's rows.
    #[inline]
    pub fn column(&self, edge: &Edge, row: u32, width: u32, work: &mut impl Count) -> u32 {
        if self.stepped.contains(&row) {
            self.stepped_column(edge, row, width, work)
        } else if self.left.contains(&row) {
            0
        } else {
            width
        }
    }

    /// The same in one of the stepped rows.
    #[inline(always)]
    pub fn stepped_column(&self, edge: &Edge, row: u32, width: u32, work: &mut impl Count) -> u32 {
        let x = self.x + self.slope * f64::from(row.wrapping_sub(self.stepped.start));
        nearest(x, width).unwrap_or_else(|| settle(edge, x, row, width, work))
    }
}

/// The least range that holds both.
pub(crate) fn hull(a: &Range<u32>, b: &Range<u32>) -> Range<u32> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b.clone(),
        (_, true) => a.clone(),
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}

/// The column of a crossing, or `None` where its error leaves doubt.
#[inline(always)]
pub(crate) fn nearest(x: f64, width: u32) -> Option<u32> {
    let sum = x + TO_INTEGER;
    let off = x - (sum - TO_INTEGER);
    let integer = sum.to_bits() as i64 - TO_INTEGER.to_bits() as i64;
    (off.abs() <= 0.5 - MARGIN).then(|| integer.clamp(0, i64::from(width)) as u32)
}

/// The column of a crossing beside a pixel centre: exact.
#[cold]
#[inline(never)]
pub(crate) fn settle(edge: &Edge, x: f64, row: u32, width: u32, work: &mut impl Count) -> u32 {
    let column = x.floor();
    if column < 0.0 {
        0
    } else if column >= f64::from(width) {
        width
    } else {
        work.add(Counter::ExactFallbacks, 1);
        let column = column as u32;
        column + u32::from(edge.has_on_left(column, row))
    }
}
