//! `ombra list`.

use clap::Args;
use ombra_figures::course::{figures, select};
use ombra_figures::figure::{Figure, Takes};
use ombra_figures::input::Inputs;
use ombra_figures::style::{Language, Style};
use ombra_trade::studies;

use crate::figures::one_of;

/// What `ombra list` takes.
#[derive(Args)]
pub struct Options {
    /// Figures or lectures, each shown with its inputs; without any, a line for every figure and study
    select: Vec<String>,
    /// Language of the lines
    #[arg(long, default_value_t = Language::En, ignore_case = true, value_parser = one_of(Language::ALL, Language::word))]
    lang: Language,
}

pub fn run(options: &Options) -> Result<(), String> {
    if options.select.is_empty() {
        all(options.lang);
        return Ok(());
    }
    for figure in select(&options.select).map_err(|error| error.to_string())? {
        one(figure, options.lang);
    }
    Ok(())
}

/// A figure with its inputs.
fn one(figure: &Figure, language: Language) {
    let inputs = Inputs::default();
    crate::print(format_args!(
        "{}  {}",
        figure.id,
        figure.summary(&inputs, language)
    ));
    match figure.takes {
        Takes::These(inputs) => {
            for input in inputs {
                crate::print(format_args!("  --set {}", input.described(language)));
            }
        }
        Takes::Nothing(why) => {
            crate::print(format_args!("  no inputs: {}", why.text(language)));
        }
    }
    if let Ok(last @ 1..) = figure.steps(&Style::default(), &inputs) {
        crate::print(format_args!(
            "  --set step=0  how many steps are shown, 0 for all: a whole number from 0 to {last}; --steps writes them all"
        ));
    }
}

fn all(language: Language) {
    let ids = figures().iter().map(|figure| figure.id.len());
    let width = ids.max().unwrap_or(0);
    crate::print("figures");
    for figure in figures() {
        let suffix = match figure.takes {
            Takes::These(inputs) => {
                let names: Vec<&str> = inputs.iter().map(|input| input.name).collect();
                format!("  [{}]", names.join(" "))
            }
            Takes::Nothing(why) => format!("  ({})", why.text(language)),
        };
        crate::print(format_args!(
            "  {:width$}  {}{suffix}",
            figure.id,
            figure.summary(&Inputs::default(), language)
        ));
    }
    crate::print("studies");
    for study in studies() {
        crate::print(format_args!("  {:width$}  {}", study.id, study.summary));
    }
}
