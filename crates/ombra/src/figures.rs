//! `ombra figures`.

use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use ombra_figures::course::select;
use ombra_figures::docs::write_docs;
use ombra_figures::error::FigureError;
use ombra_figures::figure::{Figure, Inputs, Takes, parse_light, parse_plane};
use ombra_figures::object::NamedMesh;
use ombra_figures::style::{Background, Format, Language, Size, Style, TextForm, Theme};
use ombra_figures::write;

/// What `ombra figures` takes.
#[derive(Args)]
pub struct Options {
    /// Figures or lectures: `shadows/cube-point`, `shadows`; all if none is named
    select: Vec<String>,
    /// Formats, separated by commas: svg, png
    #[arg(long, default_value = "svg,png")]
    format: String,
    /// Size in pixels, WIDTHxHEIGHT
    #[arg(long, default_value = "1920x1080")]
    size: String,
    /// light or dark
    #[arg(long, default_value = "light")]
    theme: String,
    /// Language of the labels: en, it, cs, hr
    #[arg(long, default_value = "en")]
    lang: String,
    /// theme or transparent
    #[arg(long, default_value = "theme")]
    background: String,
    /// Your own light x,y,z,w: w = 1 a place, w = 0 a direction towards the light
    #[arg(long, value_name = "X,Y,Z,W", allow_hyphen_values = true)]
    light: Option<String>,
    /// Your own plane a,b,c,d: ax + by + cz + d = 0
    #[arg(long, value_name = "A,B,C,D", allow_hyphen_values = true)]
    plane: Option<String>,
    /// Your own object: an OBJ file, or cube, teapot, sphere, torus
    #[arg(long, value_name = "FILE.obj|NAME")]
    mesh: Option<String>,
    /// SVG with text elements instead of outlines, for editing
    #[arg(long)]
    text: bool,
    /// A sentence below each figure
    #[arg(long)]
    caption: bool,
    /// Folder to write into
    #[arg(long, default_value = "target/figures", value_name = "DIR")]
    out: PathBuf,
    /// Rewrites the small SVGs committed with the crates and the notes; run from the repository's root
    #[arg(long, conflicts_with_all = ["select", "format", "size", "theme", "lang", "background", "light", "plane", "mesh", "text", "caption", "out"])]
    docs: bool,
}

pub fn run(options: &Options) -> Result<(), String> {
    if options.docs {
        return docs();
    }
    draw(options).map_err(|error| named(&options.out, &error))
}

/// What went wrong; where it was with writing, with the option that said where to.
pub fn named(out: &Path, error: &FigureError) -> String {
    match error {
        FigureError::Write { .. } => format!("--out {}: {error}", out.display()),
        _ => error.to_string(),
    }
}

fn draw(options: &Options) -> Result<(), FigureError> {
    let chosen = select(&options.select)?;
    let formats = formats(&options.format)?;
    let style = Style {
        size: options.size.parse::<Size>()?,
        theme: options.theme.parse::<Theme>()?,
        language: options.lang.parse::<Language>()?,
        background: options.background.parse::<Background>()?,
        text: if options.text {
            TextForm::Text
        } else {
            TextForm::Paths
        },
        caption: options.caption,
    };
    let inputs = Inputs {
        light: options.light.as_deref().map(parse_light).transpose()?,
        plane: options.plane.as_deref().map(parse_plane).transpose()?,
        mesh: options
            .mesh
            .as_deref()
            .map(str::parse::<NamedMesh>)
            .transpose()?,
    };
    refuse_what_none_takes(&chosen, &inputs)?;
    // Everything is laid out before anything is written.
    for figure in &chosen {
        figure.draw(&style, &inputs)?;
    }
    let bar = progress(chosen.len() as u64);
    let mut files = 0;
    for figure in &chosen {
        bar.set_message(figure.id);
        files += write::figure(&options.out, figure, &style, &inputs, &formats)?.len();
        bar.inc(1);
    }
    let index = write::index(&options.out, &chosen, &style, &inputs, &formats)?;
    bar.finish_and_clear();
    crate::print(format_args!(
        "{}, {}, in {}; gallery: {}",
        counted(chosen.len(), "figure"),
        counted(files, "file"),
        options.out.display(),
        index.display()
    ));
    Ok(())
}

/// `1 figure`, `2 figures`.
fn counted(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// The formats named in `text`, each once.
pub fn formats(text: &str) -> Result<Vec<Format>, FigureError> {
    let mut formats = Vec::new();
    for word in text.split(',') {
        let format = word.trim().parse()?;
        if !formats.contains(&format) {
            formats.push(format);
        }
    }
    Ok(formats)
}

/// An option that no chosen figure takes is a mistake worth telling.
fn refuse_what_none_takes(chosen: &[&Figure], inputs: &Inputs) -> Result<(), FigureError> {
    let taken = |takes: fn(&Takes) -> bool| chosen.iter().any(|figure| takes(&figure.takes));
    let given = [
        (
            "--light",
            inputs.light.is_some(),
            taken(|takes| takes.light),
        ),
        (
            "--plane",
            inputs.plane.is_some(),
            taken(|takes| takes.plane),
        ),
        ("--mesh", inputs.mesh.is_some(), taken(|takes| takes.mesh)),
    ];
    for (option, given, taken) in given {
        if given && !taken {
            let ids: Vec<_> = chosen.iter().map(|figure| figure.id).collect();
            let reason = format!(
                "{option} moves nothing in {}: 'ombra list' says which figures take it",
                ids.join(", ")
            );
            return Err(FigureError::Scene { reason });
        }
    }
    Ok(())
}

fn docs() -> Result<(), String> {
    let root = Path::new(".");
    if !root.join("crates/figures").is_dir() {
        let here = std::env::current_dir().unwrap_or_default();
        return Err(format!(
            "--docs rewrites crates/*/figures and notes/src/figures, and must be run in the repository's root, not in {}",
            here.display()
        ));
    }
    let files = write_docs(root).map_err(|error| error.to_string())?;
    crate::print(format_args!(
        "{} for the documentation",
        counted(files.len(), "file")
    ));
    Ok(())
}

/// A bar on the terminal, nothing where standard error is no terminal.
pub fn progress(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    if let Ok(style) = style {
        bar.set_style(style);
    }
    bar
}
