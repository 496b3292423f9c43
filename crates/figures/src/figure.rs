//! What a figure is, the list of all of them, and how they are chosen by name.

use std::sync::LazyLock;

use ombra_math::glam::DVec4;
use ombra_math::plane::Plane;

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::labels::Key;
use crate::object::NamedMesh;
use crate::sheet::Sheet;
use crate::style::{Language, Style};

/// What of an instructor's own a figure takes; `--light` and the like leave other figures as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Takes {
    /// `--light x,y,z,w`
    pub light: bool,
    /// `--plane a,b,c,d`
    pub plane: bool,
    /// `--mesh FILE.obj`
    pub mesh: bool,
}

/// An instructor's own light, plane and object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    /// A homogeneous light: w = 1 a place, w = 0 a direction towards it.
    pub light: Option<DVec4>,
    /// The plane that receives shadows.
    pub plane: Option<Plane>,
    /// The object that casts them.
    pub mesh: Option<NamedMesh>,
}

/// Puts a figure on a sheet.
pub(crate) type Drawn = fn(&mut Sheet, &Inputs) -> Result<(), FigureError>;

impl Inputs {
    /// Whether the object is the lectures' cube, for want of another or by name.
    pub(crate) fn is_cube(&self) -> bool {
        self.mesh.as_ref().is_none_or(|mesh| mesh.name == "cube")
    }
}

/// What a figure says of itself; with an instructor's own light or object, what is then drawn.
pub(crate) struct Words {
    /// One line for lists and for readers who cannot see the figure.
    pub(crate) summary: Key,
    /// One or two sentences below the figure.
    pub(crate) caption: Key,
}

/// One figure.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Lecture and name; also its path below the output folder, without extension.
    pub id: &'static str,
    /// What it takes.
    pub takes: Takes,
    pub(crate) words: fn(&Inputs) -> Words,
    pub(crate) drawn: Drawn,
}

impl Figure {
    /// One line for lists on what `inputs` let it show.
    pub fn summary(&self, inputs: &Inputs, language: Language) -> &'static str {
        (self.words)(inputs).summary.text(language)
    }

    /// One or two sentences on it, set below the figure where the style asks for a caption.
    pub fn caption(&self, inputs: &Inputs, language: Language) -> &'static str {
        (self.words)(inputs).caption.text(language)
    }

    /// The lecture, `shadows` of `shadows/cube-infinity`.
    pub fn lecture(&self) -> &'static str {
        self.id
            .split_once('/')
            .map_or(self.id, |(lecture, _)| lecture)
    }

    /// The name, `cube-infinity` of `shadows/cube-infinity`.
    pub fn name(&self) -> &'static str {
        self.id.split_once('/').map_or(self.id, |(_, name)| name)
    }

    /// Draws it.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when light, plane and object leave nothing to draw, [`FigureError::NoRoom`] when a label
    /// has no place.
    pub fn draw(&self, style: &Style, inputs: &Inputs) -> Result<Drawing, FigureError> {
        let mut sheet = Sheet::new(style, self.caption(inputs, style.language))?;
        (self.drawn)(&mut sheet, inputs)?;
        sheet.finish(self.id, self.summary(inputs, style.language))
    }
}

/// All figures, by lecture in the order of the course.
pub fn figures() -> &'static [Figure] {
    use crate::{clip, hsr, math, raster, shadows};
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

/// The figures that `patterns` name, each an id or a lecture, in the order of [`figures`]; all when there is none.
///
/// # Errors
///
/// [`FigureError::UnknownFigure`] for the first pattern that names nothing.
pub fn select(patterns: &[impl AsRef<str>]) -> Result<Vec<&'static Figure>, FigureError> {
    let named =
        |figure: &Figure, pattern: &str| figure.id == pattern || figure.lecture() == pattern;
    for pattern in patterns {
        let pattern = pattern.as_ref();
        if !figures().iter().any(|figure| named(figure, pattern)) {
            let mut allowed: Vec<&str> = Vec::new();
            for figure in figures() {
                if !allowed.contains(&figure.lecture()) {
                    allowed.push(figure.lecture());
                }
                allowed.push(figure.id);
            }
            return Err(FigureError::UnknownFigure {
                pattern: pattern.to_owned(),
                allowed: allowed.join(", "),
            });
        }
    }
    let wanted = |figure: &&Figure| {
        patterns.is_empty() || patterns.iter().any(|p| named(figure, p.as_ref()))
    };
    Ok(figures().iter().filter(wanted).collect())
}

/// Reads `--light x,y,z,w`.
///
/// # Errors
///
/// [`FigureError::Numbers`] for anything but four finite numbers, and for the zero vector, which is no light.
pub fn parse_light(text: &str) -> Result<DVec4, FigureError> {
    let light = four(text).filter(|light| *light != DVec4::ZERO);
    light.ok_or_else(|| FigureError::Numbers {
        option: "--light",
        value: text.to_owned(),
        allowed: "four finite numbers x,y,z,w, not all 0: w = 1 for a light at (x, y, z), w = 0 for one in that direction",
    })
}

/// Reads `--plane a,b,c,d`.
///
/// # Errors
///
/// [`FigureError::Numbers`] for anything but four finite numbers, and for a zero normal, which is no plane.
pub fn parse_plane(text: &str) -> Result<Plane, FigureError> {
    let plane = four(text).filter(|plane| plane.truncate() != DVec4::ZERO.truncate());
    let plane = plane.ok_or_else(|| FigureError::Numbers {
        option: "--plane",
        value: text.to_owned(),
        allowed: "four finite numbers a,b,c,d with a, b, c not all 0: the plane ax + by + cz + d = 0",
    })?;
    Ok(Plane {
        normal: plane.truncate(),
        d: plane.w,
    })
}

fn four(text: &str) -> Option<DVec4> {
    let mut parts = text
        .split(',')
        .map(|part| part.trim().parse::<f64>().ok().filter(|x| x.is_finite()));
    let mut next = || parts.next().flatten();
    let vector = DVec4::new(next()?, next()?, next()?, next()?);
    parts.next().is_none().then_some(vector)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        assert_eq!(
            parse_light("0,100,100,1"),
            Ok(DVec4::new(0.0, 100.0, 100.0, 1.0))
        );
        assert_eq!(
            parse_light(" 1, -2 ,3e2,0"),
            Ok(DVec4::new(1.0, -2.0, 300.0, 0.0))
        );
        for wrong in [
            "",
            "1,2,3",
            "1,2,3,4,5",
            "1,2,3,x",
            "NaN,0,0,1",
            "inf,0,0,1",
            "0,0,0,0",
            "0,-0,0,0",
            "1,,2,3",
        ] {
            let error = parse_light(wrong).unwrap_err().to_string();
            assert!(
                error.starts_with(&format!("--light cannot be '{wrong}'")),
                "{error}"
            );
        }
        assert_eq!(parse_plane("0,1,0,-5").unwrap().d, -5.0);
        assert!(parse_plane("0,0,0,1").is_err());
    }

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
        let error = select(&["hsr/zbufer"]).unwrap_err().to_string();
        assert!(!error.contains("nearest"), "{error}");
        let error = select(&["hsr/zbufer-steps"]).unwrap_err().to_string();
        assert!(
            error.contains("the nearest is 'hsr/zbuffer-steps'; there are math, "),
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
