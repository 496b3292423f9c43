//! `ombra figures`.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use indicatif::{ProgressBar, ProgressStyle};
use ombra_figures::course::select;
use ombra_figures::docs::write_docs;
use ombra_figures::error::FigureError;
use ombra_figures::figure::Figure;
use ombra_figures::input::{Inputs, Settings};
use ombra_figures::style::{Background, Format, Language, Size, Style, TextForm, TextScale, Theme};
use ombra_figures::{gallery, write};

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
    /// Light or dark [default: light, on a dark background dark]
    #[arg(long, ignore_case = true, value_parser = one_of(Theme::ALL, Theme::word))]
    theme: Option<Theme>,
    /// Language of the labels
    #[arg(long, default_value_t = Language::En, ignore_case = true, value_parser = one_of(Language::ALL, Language::word))]
    lang: Language,
    /// theme, transparent, or a colour #RRGGBB
    #[arg(long, default_value_t = Background::Theme, value_parser = background)]
    background: Background,
    /// Size of letters, from 1 to 2; what does not fit gets smaller all the same
    #[arg(long, default_value_t = TextScale::default(), value_parser = text_scale)]
    text_scale: TextScale,
    /// An input of the figures, such as a=2,14; repeatable; `ombra list FIGURE` shows them
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// Your own light x,y,z,w: w = 1 a place, w = 0 a direction towards the light; short for --set light=…
    #[arg(long, value_name = "X,Y,Z,W", allow_hyphen_values = true)]
    light: Option<String>,
    /// Your own plane a,b,c,d: ax + by + cz + d = 0; short for --set plane=…
    #[arg(long, value_name = "A,B,C,D", allow_hyphen_values = true)]
    plane: Option<String>,
    /// Your own object: an OBJ file, or cube, teapot, sphere, torus; short for --set mesh=…
    #[arg(long, value_name = "FILE.obj|NAME")]
    mesh: Option<String>,
    /// Moves and scales the object to where the lecture has its own
    #[arg(long, requires = "mesh")]
    fit: bool,
    /// A file a step, all in one layout, for slides that build up
    #[arg(long)]
    steps: bool,
    /// SVG with text elements instead of outlines, for editing
    #[arg(long)]
    text: bool,
    /// A sentence below each figure
    #[arg(long)]
    caption: bool,
    /// Folder to write into
    #[arg(long, default_value = "target/figures", value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// Rewrites the small SVGs committed with the crates and the notes; run from the repository's root
    #[arg(long, conflicts_with_all = ["select", "format", "size", "theme", "lang", "background", "text_scale", "set", "light", "plane", "mesh", "fit", "steps", "text", "caption", "out"])]
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

fn background(text: &str) -> Result<Background, String> {
    text.parse().map_err(allowed)
}

fn text_scale(text: &str) -> Result<TextScale, String> {
    text.parse().map_err(allowed)
}

pub fn run(options: &Options) -> Result<(), String> {
    if options.docs {
        return docs();
    }
    draw(options)
}

/// What went wrong; where it was with writing, with the option that said where to.
pub fn named(out: &Path, error: &FigureError) -> String {
    match error {
        FigureError::Write { .. } => format!("--out {}: {error}", out.display()),
        _ => error.to_string(),
    }
}

impl Options {
    fn style(&self) -> Style {
        let usual = match self.background {
            Background::Colour(rgb) => Theme::on(rgb),
            _ => Theme::Light,
        };
        Style {
            size: self.size,
            theme: self.theme.unwrap_or(usual),
            language: self.lang,
            background: self.background,
            text: if self.text {
                TextForm::Text
            } else {
                TextForm::Paths
            },
            caption: self.caption,
            text_scale: self.text_scale,
        }
    }

    fn settings(&self) -> Result<Settings, FigureError> {
        let mut settings = Settings::default();
        settings.fit = self.fit;
        for text in &self.set {
            settings.set(text)?;
        }
        let short = [
            ("light", &self.light),
            ("plane", &self.plane),
            ("mesh", &self.mesh),
        ];
        for (name, text) in short {
            if let Some(text) = text {
                settings.set(&format!("{name}={text}"))?;
            }
        }
        Ok(settings)
    }
}

/// One figure, or one step of it, to be written.
struct Job {
    figure: &'static Figure,
    inputs: Inputs,
}

fn draw(options: &Options) -> Result<(), String> {
    let said = |error: FigureError| named(&options.out, &error);
    let chosen = select(&options.select).map_err(said)?;
    let style = options.style();
    let formats = each_once(&options.format);
    let mut settings = options.settings().map_err(said)?;
    settings.check(&chosen).map_err(said)?;
    // What is mistyped is told before anything is written; what cannot be drawn stops no other figure.
    let mut jobs = Vec::new();
    let mut refused = Vec::new();
    for figure in &chosen {
        let inputs = settings.of(figure).map_err(said)?;
        let steps = if options.steps {
            figure.steps(&style, &inputs)
        } else {
            Ok(0)
        };
        match steps {
            Ok(0) => jobs.push(Job { figure, inputs }),
            Ok(last) => jobs.extend((1..=last).map(|step| {
                let mut inputs = inputs.clone();
                inputs.step = step;
                Job { figure, inputs }
            })),
            Err(error) => refused.push(format!("{}: {error}", figure.id)),
        }
    }

    for line in settings.left_out() {
        eprintln!("ombra: {line}");
    }
    let bar = progress(jobs.len() as u64);
    let (mut files, mut drawn) = (0, Vec::new());
    for Job { figure, inputs } in &jobs {
        bar.set_message(figure.id);
        match write::figure(&options.out, figure, &style, inputs, &formats) {
            Ok(written) => {
                files += written.files.len();
                if !written.over.is_empty() {
                    bar.suspend(|| {
                        eprintln!(
                            "ombra: {}: no room for: {}",
                            figure.id,
                            written.over.join("; ")
                        );
                    });
                }
                if drawn.last() != Some(&figure.id) {
                    drawn.push(figure.id);
                }
            }
            Err(error @ FigureError::Write { .. }) => return Err(said(error)),
            Err(error) => refused.push(format!("{}: {error}", figure.id)),
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if !drawn.is_empty() {
        let index = write::index(&options.out, options.lang).map_err(said)?;
        crate::print(format_args!(
            "{}, {}, in {}; gallery:\n{}",
            counted(drawn.len(), "figure"),
            counted(files, "file"),
            options.out.display(),
            gallery::address(&index)
        ));
    }
    if refused.is_empty() {
        Ok(())
    } else {
        Err(refused.join("\nombra: "))
    }
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
