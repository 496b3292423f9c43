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

/// The figures that `patterns` name, each an id or a lecture, in the order of [`figures`]; all when there is none.
///
/// # Errors
///
/// [`FigureError::UnknownFigure`] for the first pattern that names nothing.
pub fn select(patterns: &[impl AsRef<str>]) -> Result<Vec<&'static Figure>, FigureError> {
    let mut patterns = patterns.iter().map(AsRef::as_ref).peekable();
    let all = patterns.peek().is_none();
    let mut chosen = Vec::new();
    for pattern in patterns {
        if !names().contains(&pattern) {
            return Err(FigureError::UnknownFigure {
                pattern: pattern.to_owned(),
                allowed: names().join(", "),
            });
        }
        chosen.push(pattern);
    }
    let wanted =
        |figure: &&Figure| all || chosen.contains(&figure.id) || chosen.contains(&figure.lecture());
    Ok(figures().iter().filter(wanted).collect())
}

#[cfg(test)]
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
