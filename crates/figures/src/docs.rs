//! The small SVGs committed in crates and notes, shown in doc comments and in the course book.
//!
//! A page of documentation is light or dark as its reader likes, so these carry their own light card; letters are
//! `<text>`, which keeps them small.

use std::path::{Path, PathBuf};

use crate::course::figures;
use crate::error::FigureError;
use crate::figure::Figure;
use crate::input::Inputs;
use crate::style::{Size, Style, TextForm};
use crate::{svg, write};

/// The figure as it stands in doc comments and in the course book.
///
/// # Errors
///
/// Those of drawing.
pub fn docs_svg(figure: &Figure) -> Result<String, FigureError> {
    let style = Style {
        size: Size::new(720, 405)?,
        text: TextForm::Text,
        ..Style::default()
    };
    svg::card(&figure.draw(&style, &Inputs::default())?)
}

/// Where it is committed: `crates/shadows/figures/cube-infinity.svg` for the crate, whose package holds only its own
/// files, and `notes/src/figures/shadows-cube-infinity.svg` for the book.
pub fn docs_paths(repository: &Path, figure: &Figure) -> [PathBuf; 2] {
    let (lecture, name) = (figure.lecture(), figure.name());
    let of_crate = repository.join("crates").join(lecture).join("figures");
    let of_notes = repository.join("notes").join("src").join("figures");
    [
        of_crate.join(format!("{name}.svg")),
        of_notes.join(format!("{lecture}-{name}.svg")),
    ]
}

/// Rewrites every committed SVG.
///
/// # Errors
///
/// Those of drawing and of writing; every figure is drawn before the first is written.
pub fn write_docs(repository: &Path) -> Result<Vec<PathBuf>, FigureError> {
    let drawn: Vec<([PathBuf; 2], String)> = figures()
        .iter()
        .map(|figure| Ok((docs_paths(repository, figure), docs_svg(figure)?)))
        .collect::<Result<_, FigureError>>()?;
    for (paths, text) in &drawn {
        for path in paths {
            write::whole(path, text.as_bytes())?;
        }
    }
    Ok(drawn.into_iter().flat_map(|(paths, _)| paths).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn committed_figures_are_current() {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for figure in figures() {
            let current = docs_svg(figure).unwrap();
            for path in docs_paths(&repository, figure) {
                let committed = std::fs::read_to_string(&path).unwrap_or_default();
                assert!(
                    committed == current,
                    "{} is missing or no longer current: run 'cargo run --release -- figures --docs'",
                    path.display()
                );
            }
        }
    }
}
