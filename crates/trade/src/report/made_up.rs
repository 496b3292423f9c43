//! Results made up for tests: a sentence is made from numbers that nobody measured.

use ombra_math::work::Work;

use super::{Answered, Measured, Row};
use crate::advice::Advice;
use crate::deviation::Deviation;
use crate::statistics::Quartiles;

/// A technique of one answer, which errs by `error`; `None` where it is missing.
pub fn row(technique: &'static str, setting: f64, ratio: f64, error: Option<f64>) -> Row {
    let deviation = Deviation::of([error]);
    Row {
        technique,
        setting,
        error: error.unwrap_or(f64::INFINITY),
        deviation,
        faults: vec![],
        work: Work::default(),
        nanoseconds: Quartiles::of(&[ratio]),
        ratio,
        on_front: false,
    }
}

/// A sweep whose questions have these rows, over a thousand units each.
pub fn sweep(name: &'static str, questions: Vec<Vec<Row>>) -> Measured {
    let question = |rows| Answered {
        inputs: String::new(),
        units: 1000,
        rows,
    };
    Measured {
        name,
        knob: "",
        questions: questions.into_iter().map(question).collect(),
    }
}

/// The rows of some advice, their cells joined.
pub fn lines(advice: &Advice) -> Vec<String> {
    advice
        .rows
        .iter()
        .map(|row| row.cells().join(" | "))
        .collect()
}
