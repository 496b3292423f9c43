//! The files of a report.

use std::path::{Path, PathBuf};

use ombra_figures::style::{Format, Style};
use ombra_figures::{png, svg, write};

use super::Report;
use crate::error::TradeError;

impl Report {
    /// Writes `results.csv`, `advice.md` and the charts into `folder`, and names the files.
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
    ) -> Result<Vec<PathBuf>, TradeError> {
        let mut files = vec![
            (folder.join("results.csv"), self.csv().into_bytes()),
            (
                folder.join("advice.md"),
                self.advice_markdown().into_bytes(),
            ),
        ];
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
