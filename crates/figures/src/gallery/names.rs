//! What the file of a figure is called, and what a file is by its name.

use core::fmt::Write as _;
use std::path::Path;

use crate::course::figures;
use crate::figure::Figure;
use crate::input::Inputs;
use crate::style::{Format, Style, TextForm, TextScale};

/// Longest variant that stands in a name as it is, in bytes.
pub const LONGEST_VARIANT: usize = 64;
/// How much of any other stands before its hash.
const HEAD: usize = 40;

/// The path of a figure's file below the output folder, without extension: `shadows/cube-point`, and what differs from
/// the default behind it, `shadows/cube-point.it.dark.1024x768`.
///
/// `variant` stands for the instructor's inputs, `light=0,40,90,1`, or for a step, `step-3`. It comes last, in a form
/// that is safe on every system: small letters, digits and `= , . + - _` as they are. Whatever has another character,
/// is long, or could be taken for a language, theme, size … keeps its beginning and gets a hash behind a `~`.
///
/// # Properties
///
/// Another choice has another name, also where names that differ in case alone are the same file; so one run takes
/// nothing away from another. (Two long variants share a name when their 64-bit hashes are equal.)
pub fn file_stem(figure: &Figure, style: &Style, variant: Option<&str>) -> String {
    stem(figure, style, variant.map(safe).as_deref())
}

/// The same with a variant that is safe already.
fn stem(figure: &Figure, style: &Style, variant: Option<&str>) -> String {
    let default = Style::default();
    let mut name = figure.id.to_owned();
    let mut add = |differs: bool, word: &str| {
        if differs {
            name.push('.');
            name.push_str(word);
        }
    };
    add(style.language != default.language, style.language.word());
    add(style.theme != default.theme, style.theme.word());
    add(style.size != default.size, &style.size.to_string());
    add(
        style.background != default.background,
        &style.background.to_string().replace('#', ON),
    );
    add(style.text != default.text, TEXT);
    add(
        style.text_scale != default.text_scale,
        &format!("{SCALE}{}", style.text_scale.hundredths()),
    );
    add(style.caption != default.caption, CAPTION);
    add(variant.is_some(), variant.unwrap_or_default());
    name
}

/// Stands for the # of a colour, and before hundredths of the usual size of letters.
const ON: &str = "on-";
const SCALE: &str = "scale-";
const TEXT: &str = "text";
const CAPTION: &str = "caption";

fn plain(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || "=,.+-_".contains(c)
}

/// A variant as it stands in a file's name.
fn safe(variant: &str) -> String {
    // Its first word must not be one that a style may have in that place.
    let mut first = variant.split('.').next();
    let _ = style_of(&mut first);
    let another = first.is_none();
    if variant.len() <= LONGEST_VARIANT
        && !variant.is_empty()
        && variant.chars().all(plain)
        && !another
    {
        return variant.to_owned();
    }
    let mut name: String = variant.chars().take(HEAD).collect();
    name = name.to_ascii_lowercase();
    name = name
        .chars()
        .map(|c| if plain(c) && c != '.' { c } else { '_' })
        .collect();
    let _ = write!(name, "~{:016x}", fnv(variant.as_bytes()));
    name
}

/// The hash FNV-1a: the same on every machine and in every release.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// What a file of ours shows.
#[derive(Clone, Debug)]
pub struct Named {
    /// The figure's place in [`figures`].
    pub place: usize,
    /// The figure.
    pub figure: &'static Figure,
    /// How it was drawn.
    pub style: Style,
    /// The instructor's inputs or the step, as they stand in the name.
    pub variant: Option<String>,
}

impl Named {
    /// Path below the output folder, without extension.
    pub fn stem(&self) -> String {
        stem(self.figure, &self.style, self.variant.as_deref())
    }
}

/// What the file `name` in the folder of `lecture` shows; none where no run could have given it that name.
pub fn read_name(lecture: &str, name: &str) -> Option<(Named, Format)> {
    let (whole, extension) = name.rsplit_once('.')?;
    let format = Format::ALL.iter().find(|f| f.word() == extension)?;
    let (figure_name, mut rest) = match whole.split_once('.') {
        Some((figure_name, rest)) => (figure_name, Some(rest)),
        None => (whole, None),
    };
    let (place, figure) = figures()
        .iter()
        .enumerate()
        .find(|(_, figure)| figure.lecture() == lecture && figure.name() == figure_name)?;
    let style = style_of(&mut rest);
    let named = Named {
        place,
        figure,
        style,
        variant: rest.map(str::to_owned),
    };
    let ours = rest.is_none_or(|v| !v.is_empty() && v.chars().all(|c| plain(c) || c == '~'));
    let same = named.stem() == format!("{lecture}/{whole}");
    (ours && same).then_some((named, *format))
}

/// Takes the words of a style from the front of `rest`.
fn style_of(rest: &mut Option<&str>) -> Style {
    let mut style = Style::default();
    if let Some(language) = next(rest, |word| word.parse().ok()) {
        style.language = language;
    }
    if let Some(theme) = next(rest, |word| word.parse().ok()) {
        style.theme = theme;
    }
    if let Some(size) = next(rest, |word| word.parse().ok()) {
        style.size = size;
    }
    if let Some(background) = next(rest, |word| word.replace(ON, "#").parse().ok()) {
        style.background = background;
    }
    if next(rest, |word| (word == TEXT).then_some(())).is_some() {
        style.text = TextForm::Text;
    }
    let scale = |word: &str| TextScale::of_hundredths(word.strip_prefix(SCALE)?.parse().ok()?);
    if let Some(scale) = next(rest, scale) {
        style.text_scale = scale;
    }
    if next(rest, |word| (word == CAPTION).then_some(())).is_some() {
        style.caption = true;
    }
    style
}

/// Takes the word before the first full stop, if it is one that `read` knows.
fn next<T>(rest: &mut Option<&str>, read: impl Fn(&str) -> Option<T>) -> Option<T> {
    let text = (*rest)?;
    let (word, after) = match text.split_once('.') {
        Some((word, after)) => (word, Some(after)),
        None => (text, None),
    };
    let value = read(word)?;
    *rest = after;
    Some(value)
}

/// What of `inputs` differs from the defaults, as the variant of a figure's name: `light=0,40,90,1+mesh=teapot`, with
/// the step behind it.
pub fn variant(inputs: &Inputs) -> Option<String> {
    let named = inputs.changed().into_iter();
    let mut parts: Vec<String> = named
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    if inputs.fitted {
        parts.push(FIT.to_owned());
    }
    if inputs.step > 0 {
        parts.push(format!("step-{}", inputs.step));
    }
    // The corners of a polygon.
    (!parts.is_empty()).then(|| parts.join("+").replace(' ', "_"))
}

const FIT: &str = "fit";

/// The command that draws `figure` so, to be pasted into a shell.
pub fn command(figure: &Figure, style: &Style, inputs: &Inputs) -> String {
    let mut line = command_of_style(figure, style);
    for (name, value) in inputs.changed() {
        // Those that have an option of their own.
        let _ = match name {
            "light" | "plane" | "mesh" => write!(line, " --{name} {}", quoted(&value)),
            _ => write!(line, " --set {}", quoted(&format!("{name}={value}"))),
        };
    }
    if inputs.fitted {
        let _ = write!(line, " --{FIT}");
    }
    if inputs.step > 0 {
        let _ = write!(line, " --set step={}", inputs.step);
    }
    line
}

/// The same without inputs.
pub(super) fn command_of_style(figure: &Figure, style: &Style) -> String {
    let default = Style::default();
    let mut line = format!("ombra figures {}", figure.id);
    let mut add = |differs: bool, option: &str| {
        if differs {
            let _ = write!(line, " --{option}");
        }
    };
    let Style {
        language,
        theme,
        size,
        background,
        text_scale,
        ..
    } = *style;
    add(language != default.language, &format!("lang {language}"));
    add(theme != default.theme, &format!("theme {theme}"));
    add(size != default.size, &format!("size {size}"));
    add(
        background != default.background,
        &format!("background {}", quoted(&background.to_string())),
    );
    add(
        text_scale != default.text_scale,
        &format!("text-scale {text_scale}"),
    );
    add(style.text != default.text, TEXT);
    add(style.caption != default.caption, CAPTION);
    line
}

/// One word for a shell.
fn quoted(value: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_./,=:@%+-".contains(c);
    if !value.is_empty() && value.chars().all(plain) {
        value.to_owned()
    } else {
        format!("'{}'", value.replace('\'', "'\\''"))
    }
}

/// The address of a file for a browser, `file:///home/a/b.html`.
///
/// # Properties
///
/// Absolute; every byte but letters, digits and `- . _ ~ /` is written as `%` and two digits, so that a terminal makes
/// one link of it. On Windows `C:\a` is `file:///C:/a` and `\\server\share` is `file://server/share`.
pub fn address(path: &Path) -> String {
    let whole = std::path::absolute(path);
    let whole = whole.as_deref().unwrap_or(path);
    address_of(whole.as_os_str().as_encoded_bytes(), cfg!(windows))
}

fn address_of(path: &[u8], windows: bool) -> String {
    let mut path = path;
    let mut out = String::from("file://");
    if windows {
        if let Some(share) = path.strip_prefix(br"\\?\UNC\") {
            path = share;
        } else {
            let verbatim = path.strip_prefix(br"\\?\");
            path = verbatim.unwrap_or(path);
            match path.strip_prefix(br"\\").filter(|_| verbatim.is_none()) {
                Some(share) => path = share,
                None => out.push('/'),
            }
        }
    }
    for (i, &byte) in path.iter().enumerate() {
        match byte {
            b'\\' if windows => out.push('/'),
            // The colon of a drive.
            b':' if windows && i == 1 => out.push(':'),
            b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => out.push(char::from(byte)),
            _ => {
                let _ = write!(out, "%{byte:02X}");
            }
        }
    }
    out
}

/// A path below the page's folder as a link of the page.
pub(super) fn link(path: &str) -> String {
    let mut out = String::new();
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/=,+".contains(&byte) {
            out.push(char::from(byte));
        } else {
            let _ = write!(out, "%{byte:02X}");
        }
    }
    out
}

#[cfg(test)]
mod tests;
