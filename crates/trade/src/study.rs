//! What a study is made of: sweeps of questions, and the techniques that answer them.

use core::hint::black_box;
use std::rc::Rc;

use ombra_math::work::{Counter, Work};

use crate::advice::Advice;
use crate::deviation::{Measure, Verdict};
use crate::report::Measured;

/// How much time a run may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Few inputs and rounds: seconds.
    Quick,
    /// What results are published from.
    Full,
}

impl Effort {
    /// One of two values.
    #[must_use]
    pub fn choose<T>(self, quick: T, full: T) -> T {
        match self {
            Effort::Quick => quick,
            Effort::Full => full,
        }
    }

    /// Interleaved rounds, each of which times every case once.
    #[must_use]
    pub fn rounds(self) -> usize {
        self.choose(7, 31)
    }
}

/// Techniques that trade speed for accuracy, and what they are asked.
pub struct Study {
    /// Its name on the command line and in files: `planar-precision`.
    pub id: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// One of the things worked on: `vertex`. Times are for one of them.
    pub unit: &'static str,
    /// How the errors of a case become one number. The first is what the front and the advice go by.
    pub errors: &'static [Measure],
    /// What a chart of counted work shows: of each technique the first of these counters that it moves.
    pub charted_work: &'static [Counter],
    /// Its charts: those that the notes show, and no others.
    pub charts: &'static [Shown],
    /// Techniques that are not asked beyond some setting, each with the reason, which stands at the ends of its curves.
    pub ends: &'static [(&'static str, &'static str)],
    /// Makes inputs and cases, the same every time.
    pub sweeps: fn(Effort) -> Vec<Sweep>,
    /// What to take, from the numbers.
    pub advice: fn(&[Measured]) -> Advice,
}

/// A chart of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The sweep.
    pub sweep: &'static str,
    /// What it shows.
    pub what: What,
}

/// What a chart shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// The error over the knob, by the measure in this place among the study's.
    Error(usize),
    /// The time over the knob.
    Time,
    /// The counted work over the knob.
    Work,
    /// The error against the time, with the Pareto front, of the question in this place.
    Cost(usize),
}

/// One question over a range: of inputs (a question for each) or of the techniques' own knob (all in one question).
pub struct Sweep {
    /// Part of file names: `towards-plane`.
    pub name: &'static str,
    /// What is turned, for the table and the axis: `height of the light / its distance`.
    pub knob: &'static str,
    /// From easy to hard.
    pub questions: Vec<Question>,
}

/// One set of inputs with its ground truth, put to several techniques.
pub struct Question {
    /// What the inputs are, for the table.
    pub inputs: String,
    /// How many units one answer works on.
    pub units: usize,
    /// Who answers. The first is the baseline: the others' times are divided by its time.
    pub cases: Vec<Case>,
}

/// One technique with its knob at one setting.
pub struct Case {
    pub(crate) technique: &'static str,
    pub(crate) setting: f64,
    pub(crate) answer: Box<dyn Fn()>,
    pub(crate) judge: Box<dyn Fn() -> Option<(Work, Verdict)>>,
}

impl Case {
    /// Names a technique, its knob's setting, the inputs, and the ground truth; [`case!`](crate::case) makes `timed` and
    /// `counted` of one body.
    ///
    /// - `timed` answers the whole question and counts nothing (it passes `&mut ()`): the clock sees only this.
    /// - `counted` does the same with a counter, which adds up where the operations happen.
    /// - `judge` compares answers with a truth that owes nothing to the technique, and gives a
    ///   [`Deviation`](crate::deviation::Deviation), or a [`Verdict`] where kinds of fault are told apart.
    ///
    /// `timed` and `counted` must give equal answers, and the run checks that they do; so the errors are those of the
    /// answers that were timed. What is to stay outside the clock belongs into `inputs`. An answer that is no number
    /// is better given as `None`: NaN is not equal to itself.
    pub fn new<I: 'static, A: PartialEq + 'static, V: Into<Verdict> + 'static>(
        technique: &'static str,
        setting: f64,
        inputs: &Rc<I>,
        timed: fn(&I) -> A,
        counted: fn(&I, &mut Work) -> A,
        judge: fn(&I, &A) -> V,
    ) -> Self {
        let (clocked, judged) = (Rc::clone(inputs), Rc::clone(inputs));
        Self {
            technique,
            setting,
            // The optimiser may know neither the inputs nor that nobody reads the answers.
            answer: Box::new(move || {
                black_box(timed(black_box(&clocked)));
            }),
            judge: Box::new(move || {
                let mut work = Work::default();
                let answers = counted(&judged, &mut work);
                (timed(&judged) == answers).then(|| (work, judge(&judged, &answers).into()))
            }),
        }
    }
}

/// A [`Case`](crate::study::Case) whose technique is written once: `|inputs, work| answer`, a body that is compiled for
/// `work: &mut ()`, which the clock sees, and for `work: &mut Work`, which counts.
///
/// # Examples
///
/// ```
/// use std::rc::Rc;
/// use ombra_math::work::{Count, Counter};
/// use ombra_trade::case;
/// use ombra_trade::deviation::Deviation;
///
/// fn doubled(x: &f64, work: &mut impl Count) -> f64 {
///     work.add(Counter::Additions, 1);
///     x + x
/// }
/// let inputs = Rc::new(0.5);
/// let judge = |x: &f64, answer: &f64| Deviation::of([Some(answer - 2.0 * x)]);
/// let _case = case!("doubled", 1.0, &inputs, |x, work| doubled(x, work), judge);
/// ```
#[macro_export]
macro_rules! case {
    ($technique:expr, $setting:expr, $inputs:expr, |$given:ident, $work:ident| $answer:expr, $judge:expr $(,)?) => {
        $crate::study::Case::new(
            $technique,
            $setting,
            $inputs,
            |$given| {
                let $work = &mut ();
                $answer
            },
            |$given, $work| $answer,
            $judge,
        )
    };
}
