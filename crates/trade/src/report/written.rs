//! The files of a report.

use std::path::{Path, PathBuf};

use ombra_figures::style::{Format, Style};
use ombra_figures::{pdf, png, svg, write};

use super::Report;
use crate::error::TradeError;

impl Report {
    /// Writes `advice.md`, the charts and, where it `is_new`, the table `results.csv` into `folder`, and names the files.
    ///
    /// What was read from a table is not new: its times are rounded, and written again they would look measured.
    ///
    /// # Errors
    ///
    /// [`TradeError::Figure`]. Everything is drawn before the first file is written, and the files come together, as by
    /// [`write::together`].
    pub fn write(
        &self,
        folder: &Path,
        style: &Style,
        formats: &[Format],
        is_new: bool,
    ) -> Result<Vec<PathBuf>, TradeError> {
        let mut files = vec![(
            folder.join("advice.md"),
            self.advice_markdown().into_bytes(),
        )];
        if is_new {
            files.push((folder.join("results.csv"), self.csv().into_bytes()));
        }
        for drawing in self.charts(style)? {
            let name = drawing.id.rsplit('/').next().unwrap_or(&drawing.id);
            for &format in formats {
                let bytes = match format {
                    Format::Svg => svg::svg(&drawing)?.into_bytes(),
                    Format::Png => png::png(&drawing)?,
                    Format::Pdf => pdf::pdf(&drawing)?,
                };
                files.push((folder.join(format!("{name}.{format}")), bytes));
            }
        }
        let pairs: Vec<(&Path, &[u8])> = files
            .iter()
            .map(|(path, bytes)| (path.as_path(), bytes.as_slice()))
            .collect();
        write::together(&pairs)?;
        Ok(files.into_iter().map(|(path, _)| path).collect())
    }
}
