//! Files written whole or not at all: into a temporary file beside the goal, then renamed.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::FigureError;
use crate::figure::{Figure, Inputs};
use crate::gallery::gallery;
use crate::style::{Format, Style};
use crate::{png, svg};

/// Writes `bytes` to `path`; folders on the way are made.
///
/// # Errors
///
/// [`FigureError::Write`]; what was at `path` before is then unchanged.
pub fn whole(path: &Path, bytes: &[u8]) -> Result<(), FigureError> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let wrong = |error: std::io::Error| FigureError::Write {
        path: path.display().to_string(),
        reason: error.to_string(),
    };
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(wrong)?;
    let name = path
        .file_name()
        .ok_or_else(|| wrong(std::io::ErrorKind::InvalidInput.into()))?;
    // No two writers share a temporary file: the process and a count name it.
    let mut temporary = std::ffi::OsString::from(".");
    temporary.push(name);
    temporary.push(format!(
        ".{}-{}",
        process::id(),
        COUNT.fetch_add(1, Ordering::Relaxed)
    ));
    let temporary = folder.join(temporary);
    let written = fs::File::create_new(&temporary)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        // The goal's own error is the one worth telling.
        let _ = fs::remove_file(&temporary);
        wrong(error)
    })
}

/// Draws `figure` and writes it below `folder` in every format, `shadows/cube-infinity.svg`.
///
/// # Errors
///
/// Those of drawing; [`FigureError::Write`]. Nothing is written before everything is drawn.
pub fn figure(
    folder: &Path,
    figure: &Figure,
    style: &Style,
    inputs: &Inputs,
    formats: &[Format],
) -> Result<Vec<PathBuf>, FigureError> {
    let drawing = figure.draw(style, inputs)?;
    let mut files = Vec::with_capacity(formats.len());
    for &format in formats {
        let bytes = match format {
            Format::Svg => svg::svg(&drawing)?.into_bytes(),
            Format::Png => png::png(&drawing)?,
        };
        files.push((folder.join(format!("{}.{format}", figure.id)), bytes));
    }
    for (path, bytes) in &files {
        whole(path, bytes)?;
    }
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

/// Writes `index.html` into `folder` for the figures written there.
///
/// # Errors
///
/// [`FigureError::Write`].
pub fn index(
    folder: &Path,
    figures: &[&Figure],
    style: &Style,
    formats: &[Format],
) -> Result<PathBuf, FigureError> {
    let path = folder.join("index.html");
    whole(&path, gallery(figures, style, formats).as_bytes())?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Folder {
            let path = std::env::temp_dir().join(format!("ombra-figures-{name}-{}", process::id()));
            let _ = fs::remove_dir_all(&path);
            fs::create_dir_all(&path).unwrap();
            Folder(path)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_replaced_and_nothing_else_is_left() {
        let folder = Folder::new("replace");
        let path = folder.0.join("new/a.svg");
        whole(&path, b"one").unwrap();
        whole(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(path.parent().unwrap()), ["a.svg"]);
    }

    #[test]
    fn what_cannot_be_written_leaves_everything_as_it_was() {
        let folder = Folder::new("refuse");
        fs::create_dir(folder.0.join("goal")).unwrap();
        fs::write(folder.0.join("goal/inside"), "kept").unwrap();
        // A folder that is not empty stands where the file should go.
        let error = whole(&folder.0.join("goal"), b"x").unwrap_err().to_string();
        assert!(error.contains("goal cannot be written"), "{error}");
        assert_eq!(names(&folder.0), ["goal"]);
        assert!(whole(&folder.0.join("goal/inside/below"), b"x").is_err());
        assert_eq!(fs::read(folder.0.join("goal/inside")).unwrap(), b"kept");
        assert!(whole(Path::new("/"), b"x").is_err());
        assert!(whole(Path::new(""), b"x").is_err());
    }
}
