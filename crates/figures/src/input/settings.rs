//! What was typed for a whole selection of figures.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Inputs, Kind, Value};
use crate::error::FigureError;
use crate::figure::{Figure, Takes};
use crate::object::{LeftOut, NamedMesh};

/// Texts by the names of inputs; each figure takes those that it has. An object is read once for all of them.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    texts: BTreeMap<String, String>,
    objects: BTreeMap<String, Arc<NamedMesh>>,
    left_out: Vec<String>,
    /// Whether an object from a file is moved and scaled to the place of the lectures' cube.
    pub fit: bool,
}

/// The name of the input that says how many steps are shown; every figure that is built up in steps has it.
pub const STEP: &str = "step";

impl Settings {
    /// Takes `NAME=VALUE`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Value`] without a name, and for a name that has a value already.
    pub fn set(&mut self, text: &str) -> Result<(), FigureError> {
        let wrong = |allowed: &str| FigureError::Value {
            option: "--set",
            value: text.to_owned(),
            allowed: allowed.to_owned(),
        };
        let (name, value) = text
            .split_once('=')
            .filter(|(name, _)| !name.trim().is_empty())
            .ok_or_else(|| wrong("NAME=VALUE; 'ombra list FIGURE' shows the names"))?;
        let name = name.trim().to_ascii_lowercase();
        if self.texts.contains_key(&name) {
            return Err(wrong(&format!("given once: {name} has a value already")));
        }
        self.texts.insert(name, value.to_owned());
        Ok(())
    }

    /// The values for one figure; objects that are read for it stay read for the next.
    ///
    /// # Errors
    ///
    /// Those of [`Inputs::with`].
    pub fn of(&mut self, figure: &Figure) -> Result<Inputs, FigureError> {
        let mut inputs = Inputs::default();
        for input in figure.takes.inputs() {
            let Some(text) = self.texts.get(input.name) else {
                continue;
            };
            let value = match input.kind {
                Kind::Object { .. } => {
                    let text = text.clone();
                    Value::Object(self.object(&text)?)
                }
                _ => input.read(text)?,
            };
            inputs.fitted |= self.fit && matches!(value, Value::Object(_));
            inputs.put(input, value);
        }
        if let Some(text) = self.texts.get(STEP) {
            let wrong = || FigureError::Input {
                name: STEP,
                value: text.clone(),
                allowed: "a whole number: 0 for the whole figure, else how many steps are shown"
                    .to_owned(),
            };
            inputs.step = text.trim().parse().map_err(|_| wrong())?;
        }
        Ok(inputs)
    }

    /// The object of that name, read at its first use.
    fn object(&mut self, text: &str) -> Result<Arc<NamedMesh>, FigureError> {
        if let Some(object) = self.objects.get(text) {
            return Ok(object.clone());
        }
        let (object, left_out) = NamedMesh::read(text)?;
        if left_out != LeftOut::default() {
            self.left_out.push(format!("{text}: left out: {left_out}"));
        }
        let object = Arc::new(if self.fit { object.fitted() } else { object });
        self.objects.insert(text.to_owned(), object.clone());
        Ok(object)
    }

    /// What of the objects read so far is not shown, a line each.
    pub fn left_out(&self) -> &[String] {
        &self.left_out
    }

    /// Checks that each name is an input of at least one of `figures`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Value`] for the first that is none, with those there are.
    pub fn check(&self, figures: &[&Figure]) -> Result<(), FigureError> {
        let has = |name: &str| {
            name == STEP
                || figures.iter().any(|figure| {
                    let mut inputs = figure.takes.inputs().iter();
                    inputs.any(|input| input.name == name)
                })
        };
        let Some((name, value)) = self.texts.iter().find(|(name, _)| !has(name)) else {
            return Ok(());
        };
        // These have options of their own.
        if let "light" | "plane" | "mesh" = name.as_str() {
            let ids: Vec<&str> = figures.iter().map(|figure| figure.id).collect();
            return Err(FigureError::Scene {
                reason: format!(
                    "--{name} moves nothing in {}: 'ombra list' says which figures take it",
                    ids.join(", ")
                ),
            });
        }
        let mut names: Vec<&str> = figures
            .iter()
            .flat_map(|figure| figure.takes.inputs())
            .map(|input| input.name)
            .collect();
        names.sort_unstable();
        names.dedup();
        let allowed = match (figures, &names[..]) {
            ([figure], []) => match figure.takes {
                Takes::Nothing(why) => format!("nothing: {} takes no input: {}", figure.id, why.en),
                Takes::These(_) => String::new(),
            },
            (_, []) => "nothing: none of these figures takes an input".to_owned(),
            _ => format!(
                "the name of an input of these figures: {}",
                names.join(", ")
            ),
        };
        Err(FigureError::Value {
            option: "--set",
            value: format!("{name}={value}"),
            allowed,
        })
    }
}
