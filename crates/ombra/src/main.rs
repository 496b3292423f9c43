//! `ombra`: figures for slides, and the measured trade of speed against accuracy.
//!
//! Nothing but reading arguments and printing: the work is done in `ombra-figures` and `ombra-trade`.

mod figures;
mod list;
mod trade;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// The course you can run: slide figures and measured trade-offs.
#[derive(Parser)]
#[command(name = "ombra", version, propagate_version = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Draws the figures (all, or the named ones) as SVG and PNG, with a gallery page
    Figures(figures::Options),
    /// Runs the studies (all, or the named ones) of speed against accuracy
    Trade(trade::Options),
    /// Names every figure and study, with a line each
    List(list::Options),
}

fn main() -> ExitCode {
    // clap answers a mistyped option itself, with what is allowed and exit code 2.
    let result = match Arguments::parse().command {
        Command::Figures(options) => figures::run(&options),
        Command::Trade(options) => trade::run(&options),
        Command::List(options) => list::run(&options),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            eprintln!("ombra: {sentence}");
            ExitCode::from(2)
        }
    }
}

/// Prints a line; a reader that went away (`ombra list | head`) is no error.
fn print(line: impl core::fmt::Display) {
    use std::io::Write as _;
    let _ = writeln!(std::io::stdout(), "{line}");
}
