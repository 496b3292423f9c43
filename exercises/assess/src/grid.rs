//! Pictures of characters: what was plotted, and how it differs from what should be.

use std::fmt;

use glam::DVec2;

use crate::{Ink, Panel, Picture};

/// Pixels plotted on a grid whose row 0 is the top one.
#[derive(Clone, Debug)]
pub struct Grid {
    width: usize,
    counts: Vec<u32>,
    outside: Option<(i32, i32)>,
}

impl Grid {
    /// Plots pixels `(x, y)` on a grid of `width` × `height`.
    ///
    /// # Panics
    ///
    /// When there are more than 16 times as many pixels as the grid has: the loop does not end.
    #[track_caller]
    pub fn of(width: usize, height: usize, pixels: impl IntoIterator<Item = (i32, i32)>) -> Self {
        let mut grid = Self {
            width,
            counts: vec![0; width * height],
            outside: None,
        };
        let mut steps = crate::Steps::new(16 * width * height);
        for (x, y) in pixels {
            steps.take("plotting");
            let column = usize::try_from(x).ok().filter(|&column| column < width);
            let row = usize::try_from(y).ok().filter(|&row| row < height);
            match (column, row) {
                (Some(column), Some(row)) => grid.counts[row * width + column] += 1,
                _ => grid.outside = grid.outside.or(Some((x, y))),
            }
        }
        grid
    }

    /// Fails unless exactly the `#` pixels of `want` were plotted (`.` is empty), however often each.
    ///
    /// # Panics
    ///
    /// When the pictures differ, with the difference: `#` right, `?` missing, `!` extra. Also when a pixel lies
    /// outside the grid, and when `want` has another size.
    #[track_caller]
    pub fn assert_is(&self, what: &str, want: &[&str]) {
        let height = self.counts.len() / self.width.max(1);
        assert!(
            want.len() == height && want.iter().all(|row| row.len() == self.width),
            "{what}: the expected picture is not {} × {height}",
            self.width,
        );
        let is_wanted = |x: usize, y: usize| want[y].as_bytes()[x] == b'#';
        let (mut missing, mut extra, mut first) = (0, 0, None);
        let mut rows = vec![String::new(); height];
        let (mut yours, mut right) = (Panel::pixels(), Panel::pixels());
        for (x, y) in (0..height).flat_map(|y| (0..self.width).map(move |x| (x, y))) {
            let (wanted, drawn) = (is_wanted(x, y), self.counts[y * self.width + x] > 0);
            let (mark, ink) = match (wanted, drawn) {
                (true, true) => ('#', Some(Ink::Right)),
                (true, false) => ('?', Some(Ink::Missing)),
                (false, true) => ('!', Some(Ink::Extra)),
                (false, false) => ('.', None),
            };
            missing += usize::from(mark == '?');
            extra += usize::from(mark == '!');
            if wanted != drawn {
                first = first.or(Some((x, y)));
            }
            rows[y].push(mark);
            if let Some(ink) = ink {
                yours.pixel(x as i32, y as i32, ink);
            }
            if wanted {
                right.pixel(x as i32, y as i32, Ink::Right);
            }
        }
        let corners = [(0, 0), (self.width, 0), (self.width, height), (0, height)];
        let corners = corners.map(|(x, y)| DVec2::new(x as f64, y as f64));
        yours.polygon(&corners, Ink::Faint);
        right.polygon(&corners, Ink::Faint);
        let _picture = Picture::beside(yours, right);
        if let Some((x, y)) = first {
            assert!(
                self.outside.is_some() || self.counts.iter().any(|&count| count > 0),
                "{what}: nothing is plotted",
            );
            let exchanged = |x: usize, y: usize| {
                let is_there = y < self.width && x < height;
                is_there && self.counts[x * self.width + y] > 0
            };
            let fits = (0..height)
                .flat_map(|y| (0..self.width).map(move |x| (x, y)))
                .all(|(x, y)| exchanged(x, y) == is_wanted(x, y));
            assert!(
                !fits || self.outside.is_some(),
                "{what}: x and y are exchanged: plot takes the column first, then the row",
            );
            // Eight rows at most, those round the first that is wrong.
            let from = if height <= 8 {
                0
            } else {
                y.saturating_sub(3).min(height - 8)
            };
            let shown = rows.iter().enumerate().skip(from).take(8);
            let picture: Vec<String> = shown
                .map(|(y, row)| {
                    if height <= 8 {
                        row.clone()
                    } else {
                        format!("{row}  row {y}")
                    }
                })
                .collect();
            panic!(
                "{what}: {missing} missing, {extra} extra, the first is ({x}, {y}) (# right, ? missing, ! extra)\n{}",
                picture.join("\n"),
            );
        }
        if let Some((x, y)) = self.outside {
            panic!(
                "{what}: pixel ({x}, {y}) lies outside the picture of {} × {height}",
                self.width
            );
        }
    }

    /// Fails unless exactly the pixels `(x, y)` that are `wanted` were plotted; as [`Grid::assert_is`].
    ///
    /// # Panics
    ///
    /// When the pictures differ, with the difference.
    #[track_caller]
    pub fn assert_where(&self, what: &str, wanted: impl Fn(i32, i32) -> bool) {
        let height = self.counts.len() / self.width.max(1);
        let rows: Vec<String> = (0..)
            .take(height)
            .map(|y| {
                let row = (0..).take(self.width);
                row.map(|x| if wanted(x, y) { '#' } else { '.' }).collect()
            })
            .collect();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        self.assert_is(what, &rows);
    }

    /// Fails when a pixel was plotted more than once.
    ///
    /// # Panics
    ///
    /// With the first such pixel and how often it was plotted.
    #[track_caller]
    pub fn assert_once(&self, what: &str) {
        if let Some((index, count)) = self
            .counts
            .iter()
            .enumerate()
            .find(|(_, count)| **count > 1)
        {
            let (x, y) = (index % self.width, index / self.width);
            panic!("{what}: pixel ({x}, {y}) is plotted {count} times");
        }
    }
}

impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in self.counts.chunks(self.width.max(1)) {
            for &count in row {
                f.write_str(if count > 0 { "#" } else { "." })?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_pass() {
        let grid = Grid::of(3, 2, [(0, 0), (1, 0), (2, 1)]);
        grid.assert_is("a step", &["##.", "..#"]);
        grid.assert_once("a step");
        assert_eq!(grid.to_string(), "##.\n..#\n");
        Grid::of(0, 0, []).assert_is("nothing", &[]);
    }

    #[test]
    #[should_panic(
        expected = "a step: 1 missing, 1 extra, the first is (1, 0) (# right, ? missing, ! extra)\n#?.\n!.#"
    )]
    fn a_difference_is_drawn() {
        Grid::of(3, 2, [(0, 0), (0, 1), (2, 1)]).assert_is("a step", &["##.", "..#"]);
    }

    #[test]
    #[should_panic(
        expected = "a step: 1 missing, 0 extra, the first is (2, 1) (# right, ? missing, ! extra)\n##.\n..?"
    )]
    fn a_difference_from_a_rule_is_drawn() {
        let step = Grid::of(3, 2, [(0, 0), (1, 0)]);
        step.assert_where("a step", |x, y| y == 0 && x < 2);
        step.assert_where("a step", |x, y| (x < 2) == (y == 0));
    }

    #[test]
    #[should_panic(expected = "a bar: x and y are exchanged")]
    fn exchanged_axes_are_named() {
        let rows = ["#..", "#..", "#.."];
        Grid::of(3, 3, [(0, 0), (1, 0), (2, 0)]).assert_is("a bar", &rows);
    }

    #[test]
    #[should_panic(expected = "a bar: nothing is plotted")]
    fn nothing_is_named() {
        Grid::of(2, 1, []).assert_is("a bar", &["#."]);
    }

    #[test]
    #[should_panic(expected = "the first is (0, 9) (# right, ? missing, ! extra)\n#  row 4\n")]
    fn a_high_picture_is_cut() {
        let all = ["#"; 12];
        Grid::of(1, 12, (0..12).filter(|&y| y != 9).map(|y| (0, y))).assert_is("a column", &all);
    }

    #[test]
    #[should_panic(expected = "a dot: pixel (-1, 0) lies outside the picture of 1 × 1")]
    fn a_pixel_outside_is_named() {
        Grid::of(1, 1, [(0, 0), (-1, 0), (0, 7)]).assert_is("a dot", &["#"]);
    }

    #[test]
    #[should_panic(expected = "corners: pixel (1, 0) is plotted 2 times")]
    fn a_pixel_plotted_twice_is_named() {
        Grid::of(2, 1, [(1, 0), (0, 0), (1, 0)]).assert_once("corners");
    }

    #[test]
    #[should_panic(expected = "plotting: 16 steps were enough")]
    fn plotting_without_end_is_stopped() {
        Grid::of(1, 1, std::iter::repeat((0, 0)));
    }
}
