//! Figures as files, written whole or not at all.

use std::path::{Path, PathBuf};

use crate::error::FigureError;
use crate::figure::Figure;
use crate::gallery::{self, gallery};
use crate::input::Inputs;
use crate::style::{Format, Language, Style};
use crate::whole::{self, Refused};
use crate::{pdf, png, svg};

/// Writes `bytes` to `path`; folders on the way are made.
///
/// # Errors
///
/// [`FigureError::Write`]; what was at `path` before is then unchanged.
pub fn whole(path: &Path, bytes: &[u8]) -> Result<(), FigureError> {
    together(&[(path, bytes)])
}

/// Writes files that belong together: all are there beside their goals before the first is renamed.
///
/// # Errors
///
/// [`FigureError::Write`]; what was at the paths before is then unchanged, unless the system refuses to rename a file
/// that it has just let be written beside its goal.
pub fn together(files: &[(&Path, &[u8])]) -> Result<(), FigureError> {
    whole::together(files).map_err(|Refused { path, error }| FigureError::Write {
        path: path.display().to_string(),
        reason: error.to_string(),
    })
}

/// What was written of a figure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The files, one a format.
    pub files: Vec<PathBuf>,
    /// Labels for which there was no room.
    pub over: Vec<String>,
}

/// Draws `figure` and writes it below `folder` in every format, under the name of [`gallery::file_stem`]:
/// `shadows/cube-infinity.svg`, `shadows/cube-infinity.step-2.svg` for a step of it. The SVG's metadata say the command that makes it.
///
/// # Errors
///
/// Those of drawing; those of [`together`].
pub fn figure(
    folder: &Path,
    figure: &Figure,
    style: &Style,
    inputs: &Inputs,
    formats: &[Format],
) -> Result<Written, FigureError> {
    let drawing = figure.draw(style, inputs)?;
    let stem = gallery::file_stem(figure, style, gallery::variant(inputs).as_deref());
    let command = gallery::command(figure, style, inputs);
    let mut files = Vec::with_capacity(formats.len());
    for &format in formats {
        let bytes = match format {
            Format::Svg => gallery::with_command(&svg::svg(&drawing)?, &command).into_bytes(),
            Format::Png => png::png(&drawing)?,
            Format::Pdf => pdf::pdf(&drawing)?,
        };
        files.push((folder.join(format!("{stem}.{format}")), bytes));
    }
    let pairs: Vec<(&Path, &[u8])> = files
        .iter()
        .map(|(path, bytes)| (path.as_path(), bytes.as_slice()))
        .collect();
    together(&pairs)?;
    Ok(Written {
        files: files.into_iter().map(|(path, _)| path).collect(),
        over: drawing.over,
    })
}

/// Writes `index.html` into `folder` for all figures that lie there, its headings in `language`; what killed runs left
/// there is removed.
///
/// # Errors
///
/// [`FigureError::Write`].
pub fn index(folder: &Path, language: Language) -> Result<PathBuf, FigureError> {
    for lecture in gallery::lectures() {
        whole::sweep(&folder.join(lecture));
    }
    let path = folder.join("index.html");
    whole(&path, gallery(&gallery::shown(folder), language).as_bytes())?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use std::{fs, process};

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
    fn of_files_that_belong_together_all_are_new_or_none() {
        let folder = Folder::new("together");
        let [a, b] = ["a.svg", "b.png"].map(|name| folder.0.join(name));
        together(&[(&a, b"one"), (&b, b"two")]).unwrap();
        assert_eq!(names(&folder.0), ["a.svg", "b.png"]);
        // A folder takes the place of the second: the first stays as it was.
        fs::remove_file(&b).unwrap();
        fs::create_dir(&b).unwrap();
        let error = together(&[(&a, b"new"), (&b, b"new")]).unwrap_err();
        assert!(error.to_string().contains("b.png cannot be written"));
        assert_eq!(fs::read(&a).unwrap(), b"one");
        assert_eq!(names(&folder.0), ["a.svg", "b.png"]);

        // The same for the formats of a figure.
        let figure = crate::course::figures().first().unwrap();
        let style = Style::default();
        let png = folder.0.join(format!("{}.png", figure.id));
        fs::create_dir_all(&png).unwrap();
        let inputs = Inputs::default();
        let draw = || super::figure(&folder.0, figure, &style, &inputs, Format::ALL);
        assert!(draw().is_err());
        assert_eq!(names(png.parent().unwrap()).len(), 1);
        fs::remove_dir(&png).unwrap();
        assert_eq!(draw().unwrap().files.len(), 3);
        assert_eq!(names(png.parent().unwrap()).len(), 3);
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
