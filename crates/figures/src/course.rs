//! The figures of the whole course, and how they are chosen by name.

use std::sync::LazyLock;

use crate::error::FigureError;
use crate::figure::Figure;
use crate::{clip, hsr, math, raster, shadows};

/// All figures, by lecture in the order of the course.
pub fn figures() -> &'static [Figure] {
    static ALL: LazyLock<Vec<Figure>> = LazyLock::new(|| {
        let lectures = [
            math::FIGURES,
            raster::FIGURES,
            clip::FIGURES,
            hsr::FIGURES,
            shadows::FIGURES,
        ];
        lectures.concat()
    });
    &ALL
}

/// Every name that [`select`] knows: lectures, each followed by its figures.
pub fn names() -> Vec<&'static str> {
    let mut names: Vec<&str> = Vec::new();
    for figure in figures() {
        if !names.contains(&figure.lecture()) {
            names.push(figure.lecture());
        }
        names.push(figure.id);
    }
    names
}

/// The figures that `patterns` name, in the order of [`figures`]; all when there is none. A pattern is an id, a lecture,
/// or a part of ids: `bresenham`. Capital letters are as small ones.
///
/// # Errors
///
/// [`FigureError::UnknownFigure`] for the first pattern that names nothing, with the three names nearest to it.
pub fn select(patterns: &[impl AsRef<str>]) -> Result<Vec<&'static Figure>, FigureError> {
    let mut wanted = vec![patterns.is_empty(); figures().len()];
    for pattern in patterns.iter().map(AsRef::as_ref) {
        let small = pattern.to_lowercase();
        let whole = |figure: &Figure| figure.id == small || figure.lecture() == small;
        let part = |figure: &Figure| !small.is_empty() && figure.id.contains(&small);
        let named: Vec<bool> = if figures().iter().any(whole) {
            figures().iter().map(whole).collect()
        } else {
            figures().iter().map(part).collect()
        };
        if !named.contains(&true) {
            return Err(FigureError::UnknownFigure {
                pattern: pattern.to_owned(),
                nearest: nearest(&small).join(", "),
            });
        }
        for (wanted, named) in wanted.iter_mut().zip(named) {
            *wanted |= named;
        }
    }
    let chosen = figures().iter().zip(wanted).filter(|(_, wanted)| *wanted);
    Ok(chosen.map(|(figure, _)| figure).collect())
}

/// The three names nearest to `pattern`: those of which a part differs from it in the fewest letters, then those that
/// differ from it as a whole in the fewest.
fn nearest(pattern: &str) -> Vec<&'static str> {
    // Whatever is longer than this is as far from one name as from the other.
    let pattern: Vec<char> = pattern.chars().take(64).collect();
    let mut names = names();
    names.sort_by_cached_key(|name| {
        let name: Vec<char> = name.chars().collect();
        (edits(&pattern, &name, true), edits(&pattern, &name, false))
    });
    names.truncate(3);
    names
}

/// Letters to put in, take out, replace or swap with their neighbour, to make `pattern` into `name`, or into some part
/// of it.
fn edits(pattern: &[char], name: &[char], part: bool) -> usize {
    // Three rows of the table: what two letters, one letter and no letter less of the pattern cost.
    let mut before: Vec<usize> = Vec::new();
    let mut row: Vec<usize> = (0..=name.len()).map(|j| if part { 0 } else { j }).collect();
    for (i, &p) in pattern.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, &n) in name.iter().enumerate() {
            let replaced = row[j] + usize::from(p != n);
            let mut least = replaced.min(row[j + 1] + 1).min(next[j] + 1);
            if i > 0 && j > 0 && p == name[j - 1] && pattern[i - 1] == n {
                least = least.min(before[j - 1] + 1);
            }
            next.push(least);
        }
        before = core::mem::replace(&mut row, next);
    }
    let end = row.last().copied();
    let best = if part { row.iter().copied().min() } else { end };
    best.unwrap_or(0)
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_chosen_by_id_and_by_lecture() {
        assert_eq!(select(&[] as &[&str]).unwrap().len(), figures().len());
        let one = select(&["shadows/cube-infinity"]).unwrap();
        assert_eq!(
            one.iter().map(|figure| figure.id).collect::<Vec<_>>(),
            ["shadows/cube-infinity"]
        );
        let lecture = select(&["shadows"]).unwrap();
        assert!(lecture.iter().all(|figure| figure.lecture() == "shadows"));
        let error = select(&["shadows", "shadow/cube"]).unwrap_err().to_string();
        assert!(
            error.contains("'shadow/cube'") && error.contains("shadows/cube-infinity"),
            "{error}"
        );
    }

    fn ids(pattern: &str) -> Vec<&'static str> {
        let chosen = select(&[pattern]).unwrap();
        chosen.iter().map(|figure| figure.id).collect()
    }

    #[test]
    fn a_part_of_names_chooses_all_that_have_it_and_nothing_twice() {
        let with = |part: &str| -> Vec<&str> {
            let all = figures().iter().map(|figure| figure.id);
            all.filter(|id| id.contains(part)).collect()
        };
        for part in ["bresenham", "Bresenham", "BRESENHAM"] {
            assert_eq!(ids(part), with("bresenham"));
        }
        assert_eq!(ids("bresenham").len(), 3);
        assert_eq!(ids("Shadows/Cube-Infinity"), ["shadows/cube-infinity"]);
        assert_eq!(ids("raster/bres"), with("raster/bres"));
        assert_eq!(select(&["cube", "shadows", "SHADOWS"]).unwrap().len(), {
            let cubes = with("cube")
                .into_iter()
                .filter(|id| !id.starts_with("shadows"));
            cubes.count() + ids("shadows").len()
        });
    }

    #[test]
    fn an_unknown_name_gets_the_nearest_three() {
        for (pattern, first) in [
            ("hsr/zbufer-steps", "hsr/zbuffer-steps"),
            ("zbufer-steps", "hsr/zbuffer-steps"),
            ("shadws", "shadows"),
            ("rsater", "raster"),
            ("breesenham-trace", "raster/bresenham-trace"),
        ] {
            let near = nearest(pattern);
            assert_eq!((near.len(), near[0]), (3, first), "{pattern}: {near:?}");
        }
        for odd in ["", " ", "\u{0}", "ǅ", &"x".repeat(1 << 20)] {
            let Err(FigureError::UnknownFigure { nearest, .. }) = select(&[odd]) else {
                panic!("{odd} names something");
            };
            assert_eq!(nearest.split(", ").count(), 3);
        }
    }

    #[test]
    fn edits_are_counted() {
        let edits = |a: &str, b: &str, part| {
            let [a, b] = [a, b].map(|text| text.chars().collect::<Vec<_>>());
            edits(&a, &b, part)
        };
        assert_eq!(edits("kitten", "sitting", false), 3);
        assert_eq!(edits("ab", "ba", false), 1);
        assert_eq!(edits("", "abc", false), 3);
        assert_eq!(edits("abc", "", true), 3);
        assert_eq!(edits("zbufer", "hsr/zbuffer-steps", true), 1);
    }

    #[test]
    fn ids_are_unique_and_of_one_form() {
        let mut seen = std::collections::BTreeSet::new();
        for figure in figures() {
            assert!(seen.insert(figure.id), "{} is there twice", figure.id);
            let plain = |part: &str| {
                !part.is_empty()
                    && part
                        .bytes()
                        .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
            };
            assert!(
                plain(figure.lecture()) && plain(figure.name()),
                "{}",
                figure.id
            );
        }
    }
}
