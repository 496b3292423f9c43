//! What a figure can be given: one mechanism for numbers, points, polygons, lights, planes, objects and choices.
//!
//! A figure declares each input once, with its name, its symbol in the picture, what it is, its default (the lecture's
//! numbers) and its range. What is typed (`--set NAME=VALUE`), what `ombra list` shows and what tests move follow from
//! that; a figure never asks where a value came from.

use core::fmt;
use core::marker::PhantomData;
use std::collections::BTreeMap;
use std::sync::Arc;

use ombra_math::glam::{DVec2, DVec3, DVec4, IVec2};
use ombra_math::plane::Plane;

use crate::error::FigureError;
use crate::number::{as_typed, inline};
use crate::object::{NamedMesh, SOLIDS};
use crate::style::Language;
use crate::words::Word;

mod settings;

pub use self::settings::{STEP, Settings};

/// What an input is, its default and its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number; angles are in degrees.
    Number {
        /// The lecture's.
        default: f64,
        /// Least and greatest.
        range: [f64; 2],
    },
    /// A whole number.
    Whole {
        /// The lecture's.
        default: i32,
        /// Least and greatest.
        range: [i32; 2],
    },
    /// A point in the plane.
    Point {
        /// The lecture's.
        default: [f64; 2],
        /// The least and the greatest coordinates.
        range: [[f64; 2]; 2],
    },
    /// A pixel.
    Pixel {
        /// The lecture's.
        default: [i32; 2],
        /// The least and the greatest coordinates.
        range: [[i32; 2]; 2],
    },
    /// A place or direction in space.
    Place {
        /// The lecture's.
        default: [f64; 3],
        /// The least and the greatest of each coordinate.
        range: [f64; 2],
    },
    /// Corners of a polygon, in order.
    Polygon {
        /// The lecture's.
        default: &'static [[f64; 2]],
        /// Fewest and most corners.
        corners: [usize; 2],
        /// The least and the greatest coordinates.
        range: [[f64; 2]; 2],
    },
    /// A homogeneous light: w = 1 a place, w = 0 a direction towards it.
    Light {
        /// The lecture's.
        default: [f64; 4],
    },
    /// The plane ax + by + cz + d = 0.
    Plane {
        /// The lecture's.
        default: [f64; 4],
    },
    /// A built-in solid or an OBJ file.
    Object {
        /// A built-in solid.
        default: &'static str,
    },
    /// One of several words.
    Choice {
        /// The lecture's.
        default: &'static str,
        /// All there are.
        of: &'static [&'static str],
    },
}

/// A value of an input.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Of [`Kind::Number`].
    Number(f64),
    /// Of [`Kind::Whole`].
    Whole(i32),
    /// Of [`Kind::Point`].
    Point(DVec2),
    /// Of [`Kind::Pixel`].
    Pixel(IVec2),
    /// Of [`Kind::Place`].
    Place(DVec3),
    /// Of [`Kind::Polygon`].
    Polygon(Vec<DVec2>),
    /// Of [`Kind::Light`].
    Light(DVec4),
    /// Of [`Kind::Plane`].
    Plane(Plane),
    /// Of [`Kind::Object`].
    Object(Arc<NamedMesh>),
    /// Of [`Kind::Choice`].
    Choice(&'static str),
}

/// One input of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// The name typed for it, ASCII: `theta`.
    pub name: &'static str,
    /// Its symbol in the picture, in the markup of [`crate::text`]: `*θ*`; empty where it has none.
    pub symbol: &'static str,
    /// What it is.
    pub about: Word,
    /// Its default and range.
    pub kind: Kind,
}

/// An input whose values are of type `T`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ask<T> {
    pub(crate) input: Input,
    of: PhantomData<fn() -> T>,
}

/// What an input's value can be taken out as.
pub(crate) trait Given: Sized {
    fn of(value: &Value) -> Option<Self>;
    /// Where there is neither a value nor a default, as of an object that is the figure's own.
    fn none() -> Self;
}

/// The types of values, each with the constructor of inputs that have them.
macro_rules! kinds {
    ($($variant:ident $of:ty = $none:expr, $make:ident($($field:ident: $type:ty),*);)+) => {
        $(
            impl Given for $of {
                fn of(value: &Value) -> Option<Self> {
                    match value {
                        Value::$variant(value) => Some(value.clone()),
                        _ => None,
                    }
                }

                fn none() -> Self {
                    $none
                }
            }

            impl Ask<$of> {
                /// An input of this kind.
                pub(crate) const fn $make(name: &'static str, symbol: &'static str, about: Word, $($field: $type),*) -> Self {
                    let kind = Kind::$variant { $($field),* };
                    Ask { input: Input { name, symbol, about, kind }, of: PhantomData }
                }
            }
        )+
    };
}

kinds! {
    Number f64 = 0.0, number(default: f64, range: [f64; 2]);
    Whole i32 = 0, whole(default: i32, range: [i32; 2]);
    Point DVec2 = DVec2::ZERO, point(default: [f64; 2], range: [[f64; 2]; 2]);
    Pixel IVec2 = IVec2::ZERO, pixel(default: [i32; 2], range: [[i32; 2]; 2]);
    Place DVec3 = DVec3::ZERO, place(default: [f64; 3], range: [f64; 2]);
    Polygon Vec<DVec2> = Vec::new(), polygon(default: &'static [[f64; 2]], corners: [usize; 2], range: [[f64; 2]; 2]);
    Light DVec4 = DVec4::Y, light(default: [f64; 4]);
    Plane Plane = Plane::GROUND, plane(default: [f64; 4]);
    Object Arc<NamedMesh> = Arc::default(), object(default: &'static str);
    Choice &'static str = "", choice(default: &'static str, of: &'static [&'static str]);
}

/// The values a figure is drawn with: those given, and the defaults of all others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    given: BTreeMap<&'static str, Value>,
    /// How many steps are shown; 0 for the whole figure.
    pub step: u32,
    /// Whether an object of one's own was moved to the place of the lecture's.
    pub(crate) fitted: bool,
}

impl Inputs {
    /// The same with another value of `input`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Value`] for a text that is no value of it or outside its range; for an object what
    /// [`NamedMesh`] says of the file.
    pub fn with(mut self, input: &Input, text: &str) -> Result<Inputs, FigureError> {
        self.put(input, input.read(text)?);
        Ok(self)
    }

    /// The same with as many steps shown; 0 for the whole figure.
    #[must_use]
    pub fn at_step(mut self, step: u32) -> Inputs {
        self.step = step;
        self
    }

    /// The same with another object.
    #[cfg(test)]
    pub(crate) fn with_object(mut self, ask: &Ask<Arc<NamedMesh>>, mesh: NamedMesh) -> Inputs {
        self.put(&ask.input, Value::Object(Arc::new(mesh)));
        self
    }

    fn put(&mut self, input: &Input, value: Value) {
        // The default, typed or not, is the same figure.
        if input.kind.default().as_ref() == Some(&value) {
            self.given.remove(input.name);
        } else {
            self.given.insert(input.name, value);
        }
    }

    /// What `ask` has been given, or its default.
    pub(crate) fn get<T: Given>(&self, ask: &Ask<T>) -> T {
        let given = self.given.get(ask.input.name).and_then(T::of);
        let default = || ask.input.kind.default().as_ref().and_then(T::of);
        given.or_else(default).unwrap_or_else(T::none)
    }

    /// Whether `ask` has a value other than its default.
    pub(crate) fn has<T>(&self, ask: &Ask<T>) -> bool {
        self.given.contains_key(ask.input.name)
    }

    /// Whether every value is the lecture's; how many steps are shown does not matter.
    pub fn is_default(&self) -> bool {
        self.given.is_empty()
    }

    /// What differs from the defaults, names and what would be typed, in the order of names.
    pub fn changed(&self) -> Vec<(&'static str, String)> {
        let given = self.given.iter();
        given
            .map(|(name, value)| (*name, value.to_string()))
            .collect()
    }

    /// The same in one line: `a=1,2 theta=30`.
    pub fn typed(&self) -> String {
        let changed = self.changed().into_iter();
        let typed: Vec<String> = changed
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        typed.join(" ")
    }

    /// What differs from the defaults, in the words of the picture: *A* = (1, 2), *θ* = 30.
    pub(crate) fn said(&self, inputs: &[Input]) -> Option<String> {
        let said = inputs.iter().filter_map(|input| {
            let value = self.given.get(input.name)?;
            (!input.symbol.is_empty()).then(|| format!("{} = {}", input.symbol, value.said()))
        });
        let said: Vec<String> = said.collect();
        (!said.is_empty()).then(|| format!("{}.", said.join(", ")))
    }
}

impl Input {
    /// Reads what was typed for it.
    ///
    /// # Errors
    ///
    /// As [`Inputs::with`].
    pub fn read(&self, text: &str) -> Result<Value, FigureError> {
        if let Kind::Object { .. } = self.kind {
            return text.parse().map(|mesh| Value::Object(Arc::new(mesh)));
        }
        self.kind.read(text).ok_or_else(|| FigureError::Input {
            name: self.name,
            value: text.to_owned(),
            allowed: self.kind.allowed(),
        })
    }

    /// One line of `ombra list`: `a=2,14  end of the segment; x,y with …`.
    pub fn described(&self, language: Language) -> String {
        let default = self.kind.default_text();
        let (about, allowed) = (self.about.text(language), self.kind.allowed());
        format!("{}={default}  {about}: {allowed}", self.name)
    }
}

impl Kind {
    /// The default; none only for an object that is no built-in solid.
    pub fn default(&self) -> Option<Value> {
        Some(match *self {
            Kind::Number { default, .. } => Value::Number(default),
            Kind::Whole { default, .. } => Value::Whole(default),
            Kind::Point { default, .. } => Value::Point(default.into()),
            Kind::Pixel { default, .. } => Value::Pixel(default.into()),
            Kind::Place { default, .. } => Value::Place(default.into()),
            Kind::Polygon { default, .. } => {
                Value::Polygon(default.iter().map(|&p| p.into()).collect())
            }
            Kind::Light { default } => Value::Light(default.into()),
            Kind::Plane { default } => Value::Plane(plane_of(default.into())),
            Kind::Object { default } => Value::Object(Arc::new(default.parse().ok()?)),
            Kind::Choice { default, .. } => Value::Choice(default),
        })
    }

    /// The default as it would be typed.
    pub fn default_text(&self) -> String {
        match self {
            Kind::Object { default } => (*default).to_owned(),
            _ => self
                .default()
                .map_or(String::new(), |value| value.to_string()),
        }
    }

    /// What may be typed.
    pub fn allowed(&self) -> String {
        let corner = |[low, high]: [[f64; 2]; 2]| {
            format!(
                "x from {} to {} and y from {} to {}",
                low[0], high[0], low[1], high[1]
            )
        };
        match self {
            Kind::Number { range: [least, most], .. } => format!("a number from {least} to {most}"),
            Kind::Whole { range: [least, most], .. } => {
                format!("a whole number from {least} to {most}")
            }
            Kind::Point { range, .. } => format!("x,y with {}", corner(*range)),
            Kind::Pixel { range: [low, high], .. } => format!(
                "x,y, whole numbers, with {}",
                corner([low.map(f64::from), high.map(f64::from)])
            ),
            Kind::Place { range: [least, most], .. } => {
                format!("x,y,z, each from {least} to {most}")
            }
            Kind::Polygon { corners: [fewest, most], range, .. } => format!(
                "{fewest} to {most} corners x,y with a space between two of them, with {}",
                corner(*range)
            ),
            Kind::Light { .. } => "four finite numbers x,y,z,w, not all 0: w = 1 for a light at (x, y, z), w = 0 for one in that direction".to_owned(),
            Kind::Plane { .. } => "four finite numbers a,b,c,d with a, b, c not all 0: the plane ax + by + cz + d = 0".to_owned(),
            Kind::Object { .. } => format!("an OBJ file or one of {SOLIDS}"),
            Kind::Choice { of, .. } => format!("one of {}", of.join(", ")),
        }
    }

    /// Reads anything but an object.
    fn read(&self, text: &str) -> Option<Value> {
        let within = |x: f64, [least, most]: [f64; 2]| (least <= x && x <= most).then_some(x);
        let point = |text: &str, [low, high]: [[f64; 2]; 2]| {
            let [x, y] = numbers(text)?;
            let (x, y) = (within(x, [low[0], high[0]])?, within(y, [low[1], high[1]])?);
            Some(DVec2::new(x, y))
        };
        Some(match *self {
            Kind::Number { range, .. } => {
                let [x] = numbers(text)?;
                Value::Number(within(x, range)?)
            }
            Kind::Whole {
                range: [least, most],
                ..
            } => {
                let n = text.trim().parse().ok()?;
                (least..=most).contains(&n).then_some(Value::Whole(n))?
            }
            Kind::Point { range, .. } => Value::Point(point(text, range)?),
            Kind::Pixel {
                range: [low, high], ..
            } => {
                let (x, y) = text.split_once(',')?;
                let of = |text: &str, least: i32, most: i32| {
                    let n = text.trim().parse().ok()?;
                    (least..=most).contains(&n).then_some(n)
                };
                Value::Pixel(IVec2::new(of(x, low[0], high[0])?, of(y, low[1], high[1])?))
            }
            Kind::Place { range, .. } => {
                let place: [f64; 3] = numbers(text)?;
                for x in place {
                    within(x, range)?;
                }
                Value::Place(place.into())
            }
            Kind::Polygon {
                corners: [fewest, most],
                range,
                ..
            } => {
                let corners = text.split([' ', ';']).filter(|part| !part.is_empty());
                let polygon: Option<Vec<DVec2>> = corners.map(|part| point(part, range)).collect();
                let polygon = polygon?;
                (fewest..=most)
                    .contains(&polygon.len())
                    .then_some(Value::Polygon(polygon))?
            }
            Kind::Light { .. } => {
                let light: [f64; 4] = numbers(text)?;
                (light != [0.0; 4]).then_some(Value::Light(light.into()))?
            }
            Kind::Plane { .. } => {
                let plane: [f64; 4] = numbers(text)?;
                (plane[..3] != [0.0; 3]).then_some(Value::Plane(plane_of(plane.into())))?
            }
            Kind::Object { .. } => return None,
            Kind::Choice { of, .. } => Value::Choice(
                of.iter()
                    .find(|word| word.eq_ignore_ascii_case(text.trim()))?,
            ),
        })
    }
}

fn plane_of(coefficients: DVec4) -> Plane {
    Plane {
        normal: coefficients.truncate(),
        d: coefficients.w,
    }
}

/// Finite numbers with commas between them, as many as are wanted.
fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let mut found = [0.0; N];
    let mut parts = text.split(',');
    for slot in &mut found {
        let x: f64 = parts.next()?.trim().parse().ok()?;
        *slot = x.is_finite().then_some(x)?;
    }
    parts.next().is_none().then_some(found)
}

impl Value {
    /// As a caption says it, with fractions in one line.
    fn said(&self) -> String {
        let pair = |p: DVec2| format!("({}, {})", inline(p.x), inline(p.y));
        match self {
            Value::Number(x) => inline(*x),
            Value::Whole(n) => inline(f64::from(*n)),
            Value::Point(p) => pair(*p),
            Value::Pixel(p) => pair(p.as_dvec2()),
            Value::Place(p) => format!("({}, {}, {})", inline(p.x), inline(p.y), inline(p.z)),
            Value::Polygon(polygon) => {
                let corners: Vec<String> = polygon.iter().map(|&p| pair(p)).collect();
                corners.join(" ")
            }
            Value::Light(light) => {
                let numbers = light.to_array().map(inline);
                format!("({})", numbers.join(", "))
            }
            Value::Plane(plane) => {
                let numbers = plane.coefficients().to_array().map(inline);
                format!("({})", numbers.join(", "))
            }
            Value::Object(mesh) => crate::text::escape(&mesh.name),
            Value::Choice(word) => (*word).to_owned(),
        }
    }
}

impl fmt::Display for Value {
    /// As it would be typed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let typed = match self {
            Value::Number(x) => as_typed(&[*x]),
            Value::Whole(n) => n.to_string(),
            Value::Point(p) => as_typed(&p.to_array()),
            Value::Pixel(p) => format!("{},{}", p.x, p.y),
            Value::Place(p) => as_typed(&p.to_array()),
            Value::Polygon(polygon) => {
                let corners: Vec<String> =
                    polygon.iter().map(|p| as_typed(&p.to_array())).collect();
                corners.join(" ")
            }
            Value::Light(light) => as_typed(&light.to_array()),
            Value::Plane(plane) => as_typed(&plane.coefficients().to_array()),
            Value::Object(mesh) => mesh.name.clone(),
            Value::Choice(word) => (*word).to_owned(),
        };
        f.write_str(&typed)
    }
}

#[cfg(test)]
mod tests;
