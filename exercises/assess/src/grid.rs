//! Pictures of characters: what was plotted, and how it differs from what should be.

use std::fmt;

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
        let (mut missing, mut extra) = (0, 0);
        let mut picture = String::new();
        for (row, counts) in want.iter().zip(self.counts.chunks(self.width.max(1))) {
            for (wanted, &count) in row.bytes().zip(counts) {
                picture.push(match (wanted == b'#', count > 0) {
                    (true, true) => '#',
                    (true, false) => {
                        missing += 1;
                        '?'
                    }
                    (false, true) => {
                        extra += 1;
                        '!'
                    }
                    (false, false) => '.',
                });
            }
            picture.push('\n');
        }
        assert!(
            missing == 0 && extra == 0,
            "{what}: {missing} missing, {extra} extra (# right, ? missing, ! extra)\n{picture}",
        );
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
        expected = "a step: 1 missing, 1 extra (# right, ? missing, ! extra)\n#?.\n!.#\n"
    )]
    fn a_difference_is_drawn() {
        Grid::of(3, 2, [(0, 0), (0, 1), (2, 1)]).assert_is("a step", &["##.", "..#"]);
    }

    #[test]
    #[should_panic(
        expected = "a step: 1 missing, 0 extra (# right, ? missing, ! extra)\n##.\n..?\n"
    )]
    fn a_difference_from_a_rule_is_drawn() {
        let step = Grid::of(3, 2, [(0, 0), (1, 0)]);
        step.assert_where("a step", |x, y| y == 0 && x < 2);
        step.assert_where("a step", |x, y| (x < 2) == (y == 0));
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
