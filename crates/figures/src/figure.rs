//! What a figure is: its inputs, its words, how it is drawn.

use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::input::{Input, Inputs};
use crate::room::{Plan, Settled};
use crate::sheet::Sheet;
use crate::style::{Language, Style};
use crate::text::{LABEL, Line};
use crate::words::Word;

/// What a figure can be given.
#[derive(Clone, Copy, Debug)]
pub enum Takes {
    /// These inputs.
    These(&'static [Input]),
    /// None, and why.
    Nothing(Word),
}

impl Takes {
    /// All inputs; none where it takes nothing.
    pub fn inputs(&self) -> &'static [Input] {
        match self {
            Takes::These(inputs) => inputs,
            Takes::Nothing(_) => &[],
        }
    }
}

/// Puts a figure on a sheet.
pub(crate) type Drawn = fn(&mut Sheet, &Inputs) -> Result<(), FigureError>;

/// What a figure says of itself with given inputs.
pub(crate) struct About {
    /// One line for lists and for readers who cannot see the figure.
    pub(crate) summary: String,
    /// One or two sentences below the figure.
    pub(crate) caption: String,
}

impl About {
    pub(crate) fn new(language: Language, summary: Word, caption: Word) -> About {
        About {
            summary: summary.text(language).to_owned(),
            caption: caption.text(language).to_owned(),
        }
    }

    /// One more sentence, if there is one.
    pub(crate) fn and(mut self, sentence: Option<impl AsRef<str>>) -> About {
        if let Some(sentence) = sentence {
            self.caption.push(' ');
            self.caption.push_str(sentence.as_ref());
        }
        self
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
    pub(crate) about: fn(&Inputs, Language) -> About,
    pub(crate) drawn: Drawn,
}

impl Figure {
    /// One line for lists on what `inputs` let it show, without markup.
    pub fn summary(&self, inputs: &Inputs, language: Language) -> String {
        let summary = (self.about)(inputs, language).summary;
        Line::new(&summary, LABEL).map_or(summary, |line| line.plain)
    }

    /// A few sentences on it, set below the figure where the style asks for a caption; what differs from the lecture's
    /// numbers is said at the end.
    pub fn caption(&self, inputs: &Inputs, language: Language) -> String {
        let about = (self.about)(inputs, language);
        about.and(inputs.said(self.takes.inputs())).caption
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

    /// Draws it, as many of its steps as `inputs` say.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when the inputs leave nothing to draw, [`FigureError::Input`] for a step that it does not
    /// have.
    pub fn draw(&self, style: &Style, inputs: &Inputs) -> Result<Drawing, FigureError> {
        let Settled { drawing, last, .. } = self.settled(style, inputs)?;
        if inputs.step > last {
            let allowed = match last {
                0 => format!("0: {} is not built up in steps", self.id),
                _ => format!("a whole number from 0, the whole figure, to {last}"),
            };
            return Err(FigureError::Input {
                name: crate::input::STEP,
                value: inputs.step.to_string(),
                allowed,
            });
        }
        Ok(drawing)
    }

    /// How many steps it is built up in; 0 where it is not.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when the inputs leave nothing to draw.
    pub fn steps(&self, style: &Style, inputs: &Inputs) -> Result<u32, FigureError> {
        Ok(self.settled(style, inputs)?.last)
    }

    fn settled(&self, style: &Style, inputs: &Inputs) -> Result<Settled, FigureError> {
        let plan = Plan {
            id: self.id,
            title: &self.summary(inputs, style.language),
            caption: &self.caption(inputs, style.language),
            style,
            step: inputs.step,
        };
        plan.settled(|sheet| (self.drawn)(sheet, inputs))
    }
}
