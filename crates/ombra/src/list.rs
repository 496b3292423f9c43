//! `ombra list`.

use clap::Args;
use ombra_figures::course::figures;
use ombra_figures::figure::Inputs;
use ombra_figures::style::Language;
use ombra_trade::studies;

use crate::figures::one_of;

/// What `ombra list` takes.
#[derive(Args)]
pub struct Options {
    /// Language of the lines
    #[arg(long, default_value_t = Language::En, ignore_case = true, value_parser = one_of(Language::ALL, Language::word))]
    lang: Language,
}

pub fn run(options: &Options) {
    let width = figures()
        .iter()
        .map(|figure| figure.id.len())
        .max()
        .unwrap_or(0);
    crate::print("figures");
    for figure in figures() {
        let takes = figure.takes;
        let names = [
            ("--light", takes.light),
            ("--plane", takes.plane),
            ("--mesh", takes.mesh),
        ];
        let names: Vec<_> = names
            .iter()
            .filter(|(_, taken)| *taken)
            .map(|(name, _)| *name)
            .collect();
        let suffix = if names.is_empty() {
            String::new()
        } else {
            format!("  [{}]", names.join(" "))
        };
        crate::print(format_args!(
            "  {:width$}  {}{suffix}",
            figure.id,
            figure.summary(&Inputs::default(), options.lang)
        ));
    }
    crate::print("studies");
    for study in studies() {
        crate::print(format_args!("  {:width$}  {}", study.id, study.summary));
    }
}
