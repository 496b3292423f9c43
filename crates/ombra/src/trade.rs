//! `ombra trade`.

use std::path::PathBuf;

use clap::Args;
use ombra_figures::style::{Format, Language, Size, Style, Theme};
use ombra_trade::error::TradeError;
use ombra_trade::run::run as run_study;
use ombra_trade::select;
use ombra_trade::study::Effort;

use crate::figures::{formats, named, progress};

/// What `ombra trade` takes.
#[derive(Args)]
pub struct Options {
    /// Studies; all if none is named
    study: Vec<String>,
    /// Few inputs and rounds: seconds instead of minutes
    #[arg(long)]
    quick: bool,
    /// Formats of the charts, separated by commas: svg, png
    #[arg(long, default_value = "svg,png")]
    format: String,
    /// Size of the charts in pixels, WIDTHxHEIGHT
    #[arg(long, default_value = "1920x1080")]
    size: String,
    /// Theme of the charts: light or dark
    #[arg(long, default_value = "light")]
    theme: String,
    /// Language of the charts' figures: en, it, cs, hr
    #[arg(long, default_value = "en")]
    lang: String,
    /// Folder to write into, a folder a study
    #[arg(long, default_value = "target/trade", value_name = "DIR")]
    out: PathBuf,
}

pub fn run(options: &Options) -> Result<(), String> {
    let sentence = |error: ombra_figures::error::FigureError| error.to_string();
    let style = Style {
        size: options.size.parse::<Size>().map_err(sentence)?,
        theme: options.theme.parse::<Theme>().map_err(sentence)?,
        language: options.lang.parse::<Language>().map_err(sentence)?,
        ..Style::default()
    };
    let formats = formats(&options.format).map_err(sentence)?;
    measure(options, &style, &formats).map_err(|error| match &error {
        TradeError::Figure(error) => named(&options.out, error),
        _ => error.to_string(),
    })
}

fn measure(options: &Options, style: &Style, formats: &[Format]) -> Result<(), TradeError> {
    let effort = if options.quick {
        Effort::Quick
    } else {
        Effort::Full
    };
    for study in select(&options.study)? {
        let bar = progress(0);
        let report = run_study(study, effort, &mut |progress| {
            bar.set_length(progress.total as u64);
            bar.set_position(progress.done as u64);
            bar.set_message(format!("{}: {}", progress.study, progress.stage));
        })?;
        bar.finish_and_clear();
        let folder = options.out.join(study.id);
        let files = report.write(&folder, style, formats)?;
        crate::print(format_args!("{}: {}", study.id, report.advice));
        crate::print(format_args!(
            "{} files in {}",
            files.len(),
            folder.display()
        ));
    }
    Ok(())
}
