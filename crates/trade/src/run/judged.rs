//! Errors and counted work of a study's quick run, without times: what tests assert on.

use ombra_math::work::Work;

use super::judge;
use crate::deviation::Deviation;
use crate::study::{Effort, Study};

/// A case with what it answered.
#[derive(Clone, Debug)]
pub struct Judged {
    pub sweep: &'static str,
    pub technique: &'static str,
    pub setting: f64,
    /// Of the question.
    pub units: usize,
    pub work: Work,
    pub deviation: Deviation,
    pub faults: Vec<(&'static str, u64)>,
}

/// All cases, in order.
pub fn judged(study: &Study) -> Vec<Judged> {
    let sweeps = (study.sweeps)(Effort::Quick);
    let mut numbers = judge(study.id, &sweeps, &mut |_| ()).unwrap().into_iter();
    let mut found = Vec::new();
    for sweep in &sweeps {
        for question in &sweep.questions {
            for (case, (work, verdict)) in question.cases.iter().zip(&mut numbers) {
                found.push(Judged {
                    sweep: sweep.name,
                    technique: case.technique,
                    setting: case.setting,
                    units: question.units,
                    work,
                    deviation: verdict.deviation,
                    faults: verdict.faults,
                });
            }
        }
    }
    found
}

impl Judged {
    /// For the message of an assertion that fails.
    pub fn context(&self) -> String {
        format!(
            "{} {} {:e}: {:?}, {:?}, {}",
            self.sweep, self.technique, self.setting, self.deviation, self.faults, self.work
        )
    }
}
