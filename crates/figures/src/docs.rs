//! The small SVGs committed beside the crates, shown in their doc comments.
//!
//! A page of documentation is light or dark as its reader likes, so these carry their own light card; letters are
//! `<text>`, which keeps them small.

use std::path::{Path, PathBuf};

use crate::error::FigureError;
use crate::figure::{Figure, Inputs, figures};
use crate::style::{Size, Style, TextForm};
use crate::{svg, write};

/// The figure as it stands in doc comments.
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

/// Where it is committed: `crates/shadows/figures/cube-infinity.svg`.
pub fn docs_path(repository: &Path, figure: &Figure) -> PathBuf {
    repository
        .join("crates")
        .join(figure.lecture())
        .join("figures")
        .join(format!("{}.svg", figure.name()))
}

/// Rewrites every committed SVG.
///
/// # Errors
///
/// Those of drawing and of writing; every figure is drawn before the first is written.
pub fn write_docs(repository: &Path) -> Result<Vec<PathBuf>, FigureError> {
    let drawn: Vec<(PathBuf, String)> = figures()
        .iter()
        .map(|figure| Ok((docs_path(repository, figure), docs_svg(figure)?)))
        .collect::<Result<_, FigureError>>()?;
    for (path, text) in &drawn {
        write::whole(path, text.as_bytes())?;
    }
    Ok(drawn.into_iter().map(|(path, _)| path).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn committed_figures_are_current() {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for figure in figures() {
            if let Ok(committed) = std::fs::read_to_string(docs_path(&repository, figure)) {
                assert!(
                    committed == docs_svg(figure).unwrap(),
                    "{} has changed: run 'cargo run --release -- figures --docs'",
                    figure.id
                );
            }
        }
    }
}
