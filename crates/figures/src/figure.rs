//! What a figure is, and what of an instructor's own it takes.

use ombra_math::glam::DVec4;
use ombra_math::plane::Plane;

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::object::NamedMesh;
use crate::sheet::Sheet;
use crate::solid;
use crate::style::{Language, Style};
use crate::words::Word;

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

impl Takes {
    /// Neither.
    pub const NOTHING: Takes = Takes {
        light: false,
        plane: false,
        mesh: false,
    };
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
pub(crate) struct About {
    /// One line for lists and for readers who cannot see the figure.
    pub(crate) summary: Word,
    /// One or two sentences below the figure.
    pub(crate) caption: Word,
    /// More, where there is something to say of the object or of how it was drawn.
    pub(crate) notes: Vec<Word>,
}

impl About {
    pub(crate) fn new(summary: Word, caption: Word) -> About {
        About {
            summary,
            caption,
            notes: Vec::new(),
        }
    }

    /// The same of a figure that draws the instructor's object.
    pub(crate) fn with_object(self, inputs: &Inputs) -> About {
        let object = inputs.mesh.as_ref();
        About {
            notes: object.map(solid::notes).unwrap_or_default(),
            ..self
        }
    }
}

/// One figure.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Lecture and name; also its path below the output folder, without extension.
    pub id: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// Every word it shows.
    pub words: &'static [Word],
    pub(crate) about: fn(&Inputs) -> About,
    pub(crate) drawn: Drawn,
}

impl Figure {
    /// One line for lists on what `inputs` let it show.
    pub fn summary(&self, inputs: &Inputs, language: Language) -> &'static str {
        (self.about)(inputs).summary.text(language)
    }

    /// A few sentences on it, set below the figure where the style asks for a caption.
    pub fn caption(&self, inputs: &Inputs, language: Language) -> String {
        let About { caption, notes, .. } = (self.about)(inputs);
        let sentences = core::iter::once(caption).chain(notes);
        let sentences: Vec<&str> = sentences.map(|word| word.text(language)).collect();
        sentences.join(" ")
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
        let mut sheet = Sheet::new(style, &self.caption(inputs, style.language))?;
        (self.drawn)(&mut sheet, inputs)?;
        sheet.finish(self.id, self.summary(inputs, style.language))
    }
}

/// Reads `--light x,y,z,w`.
///
/// # Errors
///
/// [`FigureError::Value`] for anything but four finite numbers, and for the zero vector, which is no light.
pub fn parse_light(text: &str) -> Result<DVec4, FigureError> {
    let light = four(text).filter(|light| *light != DVec4::ZERO);
    light.ok_or_else(|| FigureError::Value {
        option: "--light",
        value: text.to_owned(),
        allowed: "four finite numbers x,y,z,w, not all 0: w = 1 for a light at (x, y, z), w = 0 for one in that direction".to_owned(),
    })
}

/// Reads `--plane a,b,c,d`.
///
/// # Errors
///
/// [`FigureError::Value`] for anything but four finite numbers, and for a zero normal, which is no plane.
pub fn parse_plane(text: &str) -> Result<Plane, FigureError> {
    let plane = four(text).filter(|plane| plane.truncate() != DVec4::ZERO.truncate());
    let plane = plane.ok_or_else(|| FigureError::Value {
        option: "--plane",
        value: text.to_owned(),
        allowed:
            "four finite numbers a,b,c,d with a, b, c not all 0: the plane ax + by + cz + d = 0"
                .to_owned(),
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
}
