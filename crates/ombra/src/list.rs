//! `ombra list`.

use clap::Args;
use ombra_figures::course::figures;
use ombra_figures::figure::Inputs;
use ombra_figures::style::Language;
use ombra_trade::studies;

/// What `ombra list` takes.
#[derive(Args)]
pub struct Options {
    /// Language of the lines: en, it, cs, hr
    #[arg(long, default_value = "en")]
    lang: String,
}

pub fn run(options: &Options) -> Result<(), String> {
    let language: Language = options.lang.parse().map_err(|e| format!("{e}"))?;
    let width = figures()
        .iter()
        .map(|figure| figure.id.len())
        .max()
        .unwrap_or(0);
    crate::print("figures");
    for figure in figures() {
        let takes = figure.takes;
        let options = [
            ("--light", takes.light),
            ("--plane", takes.plane),
            ("--mesh", takes.mesh),
        ];
        let options: Vec<_> = options
            .iter()
            .filter(|(_, taken)| *taken)
            .map(|(name, _)| *name)
            .collect();
        let suffix = if options.is_empty() {
            String::new()
        } else {
            format!("  [{}]", options.join(" "))
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
    Ok(())
}
