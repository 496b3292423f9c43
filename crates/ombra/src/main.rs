//! `ombra`: figures for slides, and the measured trade of speed against accuracy.
//!
//! Nothing but reading arguments and printing: the work is done in [`ombra_figures`] and [`ombra_trade`]. The lectures:
//!
//! | crate | lecture |
//! | --- | --- |
//! | [`ombra_raster`](../ombra_raster/index.html) | rasterization: segments, polygons, triangles |
//! | [`ombra_clip`](../ombra_clip/index.html) | clipping: points, segments, polygons, the view volume |
//! | [`ombra_hsr`](../ombra_hsr/index.html) | hidden surfaces: object space, image space, painter, z-buffer |
//! | [`ombra_shadows`](../ombra_shadows/index.html) | shadows on a plane |
//! | [`ombra_math`](../ombra_math/index.html) | what all of them stand on: planes, views, meshes, exact signs |

mod figures;
mod list;
mod mistyped;
mod trade;

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

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
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return refuse(&error),
    };
    let result = match arguments.command {
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

/// Help and version are printed as clap does; a mistake gets a sentence.
fn refuse(error: &clap::Error) -> ExitCode {
    let mut command = Arguments::command();
    command.build();
    let typed = std::env::args_os().skip(1);
    let typed: Vec<String> = typed.filter_map(|word| word.into_string().ok()).collect();
    match mistyped::sentence(error, &command, &typed) {
        Some(sentence) => {
            eprintln!("ombra: {sentence}");
            ExitCode::from(2)
        }
        None => {
            let _ = error.print();
            ExitCode::SUCCESS
        }
    }
}

/// Prints a line; a reader that went away (`ombra list | head`) is no error.
fn print(line: impl core::fmt::Display) {
    use std::io::Write as _;
    let _ = writeln!(std::io::stdout(), "{line}");
}
