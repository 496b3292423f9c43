//! `ombra`: figures for slides, and the measured trade of speed against accuracy.
//!
//! Nothing but reading arguments and printing: the work is done in [`ombra_figures`] and [`ombra_trade`].

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

/// Help, version and what is mistyped are clap's to answer.
fn main() -> ExitCode {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The answer to a command line and its exit code; none where it is understood.
    fn answer(words: &str) -> Option<(String, i32)> {
        let typed = ["ombra"].into_iter().chain(words.split_whitespace());
        let error = Arguments::try_parse_from(typed).err()?;
        Some((error.to_string(), error.exit_code()))
    }

    #[test]
    fn a_mistake_is_named_with_what_is_allowed() {
        for (words, parts) in [
            (
                "figures --thme dark",
                &["'--thme'", "similar", "--theme"][..],
            ),
            (
                "figures --theme dar",
                &["'dar'", "--theme", "light, dark", "similar"],
            ),
            ("figures --theme pink", &["'pink'", "light, dark"]),
            ("figures --format svg,jpg", &["'jpg'", "svg, png, pdf"]),
            ("trade --lang eng", &["'eng'", "--lang", "en, it, cs, hr"]),
            (
                "figures --size",
                &["--size <WIDTHxHEIGHT>", "value is required"],
            ),
            (
                "figures --size 63x64",
                &["'63x64'", "it is WIDTHxHEIGHT in pixels", "16384"],
            ),
            (
                "trade planar",
                &["'planar'", "planar-precision", "clip-segment"],
            ),
            ("figures --text=yes", &["'yes'", "--text"]),
            (
                "figures --docs --size 640x360",
                &["--docs", "cannot be used with", "--size"],
            ),
            ("figures --lang en --lang it", &["--lang", "multiple times"]),
            ("figurs", &["'figurs'", "figures"]),
            ("--quick", &["'--quick'"]),
            ("", &["figures", "trade", "list"]),
        ] {
            let (said, code) = answer(words).unwrap();
            assert_eq!(code, 2, "{words}: {said}");
            for part in parts {
                assert!(said.contains(part), "{words}: {part} is not in {said}");
            }
        }
    }

    /// What is told before anything is written.
    #[test]
    fn a_wrong_value_of_an_input_is_named_with_what_is_allowed() {
        let out = std::env::temp_dir().join("ombra-nothing-is-written-here");
        for (words, parts) in [
            (
                "--light 0,0,0,0",
                &["light", "'0,0,0,0'", "four finite numbers"][..],
            ),
            ("--plane 1,2", &["plane", "'1,2'", "four finite numbers"]),
            (
                "--mesh dragon",
                &["--mesh dragon", "cube, teapot, sphere, torus"],
            ),
            (
                "shadows/why --light 1,2,3,0",
                &["--light", "shadows/why", "ombra list"],
            ),
            (
                "shadows/why --set height=9",
                &["height", "'9'", "from 0.2 to 4"],
            ),
            ("shadows/why --set depth=9", &["'depth=9'", "height"]),
            ("shadows/why --set height", &["'height'", "NAME=VALUE"]),
            (
                "--light 1,2,3,0 --set light=1,2,3,1",
                &["light", "given once"],
            ),
            ("shadows/whi", &["'shadows/whi'", "nearest", "shadows/why"]),
            ("shadows/why --set step=9", &["step", "'9'", "to 3"]),
        ] {
            let typed = ["ombra", "figures"]
                .into_iter()
                .chain(words.split_whitespace());
            let Ok(Arguments {
                command: Command::Figures(mut options),
            }) = Arguments::try_parse_from(typed)
            else {
                panic!("{words}")
            };
            options.out.clone_from(&out);
            let said = figures::run(&options).unwrap_err();
            for part in parts {
                assert!(said.contains(part), "{words}: {part} is not in {said}");
            }
            assert!(!out.exists(), "{words}");
        }
    }

    #[test]
    fn what_is_right_is_understood() {
        for words in [
            "figures",
            "figures shadows hsr/back-face --format png,svg,pdf,png --size 640x360 --theme dark --lang it",
            "figures --light -3,20,5,0 --plane -1,0.3,0,30 --mesh torus --background transparent",
            "figures bresenham --size 16:9 --mesh Teapot --lang EN --theme Dark --format PNG --background Transparent",
            "figures --docs",
            "trade planar-precision --quick --lang hr",
            "list --lang CS",
        ] {
            assert_eq!(answer(words), None, "{words}");
        }
        for words in ["--help", "figures -h", "--version"] {
            assert_eq!(answer(words).unwrap().1, 0, "{words}");
        }
    }
}
