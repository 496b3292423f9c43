//! `ombra trade`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValuesParser;
use ombra_figures::style::{Format, Language, Size, Style, Theme};
use ombra_trade::error::TradeError;
use ombra_trade::report::Report;
use ombra_trade::run::run as run_study;
use ombra_trade::study::{Effort, Study};
use ombra_trade::{select, studies};

use crate::figures::{each_once, named, one_of, progress, size};

/// What `ombra trade` takes.
#[derive(Args)]
pub struct Options {
    /// Studies; all if none is named
    #[arg(value_parser = PossibleValuesParser::new(studies().iter().map(|study| study.id)), hide_possible_values = true)]
    study: Vec<String>,
    /// Few inputs and rounds: seconds instead of minutes
    #[arg(long)]
    quick: bool,
    /// Formats of the charts, separated by commas
    #[arg(long, default_value = "svg,png", value_delimiter = ',', ignore_case = true, value_parser = one_of(Format::ALL, Format::word))]
    format: Vec<Format>,
    /// Size of the charts in pixels
    #[arg(long, default_value_t = Size::FULL_HD, value_name = "WIDTHxHEIGHT", value_parser = size)]
    size: Size,
    /// Theme of the charts
    #[arg(long, default_value_t = Theme::Light, ignore_case = true, value_parser = one_of(Theme::ALL, Theme::word))]
    theme: Theme,
    /// Language of the charts' figures
    #[arg(long, default_value_t = Language::En, ignore_case = true, value_parser = one_of(Language::ALL, Language::word))]
    lang: Language,
    /// Draw charts and advice anew from the tables DIR/STUDY/results.csv of an earlier run, without measuring
    #[arg(long, value_name = "DIR", conflicts_with = "quick")]
    from: Option<PathBuf>,
    /// Folder to write into, a folder a study
    #[arg(long, default_value = "target/trade", value_name = "DIR")]
    out: PathBuf,
}

pub fn run(options: &Options) -> Result<(), String> {
    let style = Style {
        size: options.size,
        theme: options.theme,
        language: options.lang,
        ..Style::default()
    };
    measure(options, &style, &each_once(&options.format)).map_err(|error| match &error {
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
        let report = match &options.from {
            Some(from) => stored(study, from)?,
            None => measured(study, effort)?,
        };
        let folder = options.out.join(study.id);
        let files = report.write(&folder, style, formats, options.from.is_none())?;
        crate::print(format_args!(
            "{}: {}\n\n{}",
            study.id, study.summary, report.advice
        ));
        crate::print(format_args!(
            "{} files in {}",
            files.len(),
            folder.display()
        ));
    }
    Ok(())
}

fn measured(study: &Study, effort: Effort) -> Result<Report, TradeError> {
    let bar = progress(0);
    let report = run_study(study, effort, &mut |progress| {
        bar.set_length(progress.total as u64);
        bar.set_position(progress.done as u64);
        bar.set_message(format!("{}: {}", progress.study, progress.stage));
    })?;
    bar.finish_and_clear();
    Ok(report)
}

/// What an earlier run wrote.
fn stored(study: &Study, from: &Path) -> Result<Report, TradeError> {
    let file = from.join(study.id).join("results.csv");
    let failed = |reason| TradeError::Table {
        file: file.display().to_string(),
        reason,
    };
    let table = std::fs::read_to_string(&file)
        .map_err(|error| failed(format!("cannot be read: {error}")))?;
    Report::read(study, &table).map_err(|error| match error {
        TradeError::Table { reason, .. } => failed(reason),
        other => other,
    })
}
