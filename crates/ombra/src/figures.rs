//! `ombra figures`.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use indicatif::{ProgressBar, ProgressStyle};
use ombra_figures::course::select;
use ombra_figures::docs::write_docs;
use ombra_figures::error::FigureError;
use ombra_figures::figure::{Figure, Inputs, Takes, parse_light, parse_plane};
use ombra_figures::object::NamedMesh;
use ombra_figures::style::{Background, Format, Language, Size, Style, TextForm, Theme};
use ombra_figures::{gallery, write};
use ombra_math::glam::DVec4;
use ombra_math::plane::Plane;

/// What `ombra figures` takes.
#[derive(Args)]
pub struct Options {
    /// Figures, lectures or parts of names: `shadows/cube-point`, `shadows`, `bresenham`; all if none is named
    select: Vec<String>,
    /// Formats, separated by commas
    #[arg(long, default_value = "svg,png", value_delimiter = ',', ignore_case = true, value_parser = one_of(Format::ALL, Format::word))]
    format: Vec<Format>,
    /// Size in pixels, or an aspect: 16:9, 4:3, 1:1
    #[arg(long, default_value_t = Size::FULL_HD, value_name = "WIDTHxHEIGHT", value_parser = size)]
    size: Size,
    #[arg(long, default_value_t = Theme::Light, ignore_case = true, value_parser = one_of(Theme::ALL, Theme::word))]
    theme: Theme,
    /// Language of the labels
    #[arg(long, default_value_t = Language::En, ignore_case = true, value_parser = one_of(Language::ALL, Language::word))]
    lang: Language,
    #[arg(long, default_value_t = Background::Theme, ignore_case = true, value_parser = one_of(Background::ALL, Background::word))]
    background: Background,
    /// Your own light x,y,z,w: w = 1 a place, w = 0 a direction towards the light
    #[arg(long, value_name = "X,Y,Z,W", allow_hyphen_values = true, value_parser = light)]
    light: Option<DVec4>,
    /// Your own plane a,b,c,d: ax + by + cz + d = 0
    #[arg(long, value_name = "A,B,C,D", allow_hyphen_values = true, value_parser = plane)]
    plane: Option<Plane>,
    /// Your own object: an OBJ file, or cube, teapot, sphere, torus
    #[arg(long, value_name = "FILE.obj|NAME", value_parser = object)]
    mesh: Option<NamedMesh>,
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

/// Reads one of `all` by its word; clap names them where another is typed.
pub fn one_of<T>(all: &'static [T], word: fn(T) -> &'static str) -> impl TypedValueParser<Value = T>
where
    T: FromStr<Err = FigureError> + Copy + Send + Sync,
{
    let words = all.iter().map(|&value| word(value));
    PossibleValuesParser::new(words).try_map(|word| word.parse())
}

/// What is allowed: clap has said which option has which value.
fn allowed(error: FigureError) -> String {
    match error {
        FigureError::Value { allowed, .. } => format!("it is {allowed}"),
        FigureError::Object { reason, .. } => reason,
        _ => error.to_string(),
    }
}

pub fn size(text: &str) -> Result<Size, String> {
    text.parse().map_err(allowed)
}

fn light(text: &str) -> Result<DVec4, String> {
    parse_light(text).map_err(allowed)
}

fn plane(text: &str) -> Result<Plane, String> {
    parse_plane(text).map_err(allowed)
}

fn object(text: &str) -> Result<NamedMesh, String> {
    text.parse().map_err(allowed)
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
    let style = Style {
        size: options.size,
        theme: options.theme,
        language: options.lang,
        background: options.background,
        text: if options.text {
            TextForm::Text
        } else {
            TextForm::Paths
        },
        caption: options.caption,
    };
    let inputs = Inputs {
        light: options.light,
        plane: options.plane,
        mesh: options.mesh.clone(),
    };
    let formats = each_once(&options.format);
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
    let index = write::index(&options.out, options.lang)?;
    bar.finish_and_clear();
    crate::print(format_args!(
        "{}, {}, in {}; gallery:\n{}",
        counted(chosen.len(), "figure"),
        counted(files, "file"),
        options.out.display(),
        gallery::address(&index)
    ));
    Ok(())
}

/// `1 figure`, `2 figures`.
fn counted(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// The formats, each once.
pub fn each_once(formats: &[Format]) -> Vec<Format> {
    let all = Format::ALL.iter().copied();
    all.filter(|format| formats.contains(format)).collect()
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
