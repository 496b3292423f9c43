//! What lies in an output folder.

use std::collections::BTreeMap;
use std::fs;
use std::io::Read as _;
use std::path::Path;

use super::names::{Named, command_of_style, read_name};
use crate::course::figures;
use crate::input::Inputs;
use crate::style::{Format, Language, Size, Theme};

/// Bytes at the front of an SVG in which its title and its command stand.
const FRONT: u64 = 16 << 10;
/// What precedes the command in an SVG's metadata.
const MADE_BY: &str = "Made by: ";

/// A picture in the folder.
#[derive(Clone, Debug)]
pub struct Shown {
    /// What its name says.
    pub named: Named,
    /// The formats it is there in.
    pub formats: Vec<Format>,
    /// One line on what it shows.
    pub title: String,
    /// The command that made it, as far as it is known.
    pub command: Option<String>,
}

/// Where a picture stands among the others: as the course has them, the default first.
type Order = (
    usize,
    Option<(usize, String)>,
    Language,
    Theme,
    (bool, u32, u32),
    String,
);

fn order(named: &Named) -> Order {
    let size = named.style.size;
    (
        named.place,
        // Step 10 after step 9.
        named
            .variant
            .clone()
            .map(|variant| (variant.len(), variant)),
        named.style.language,
        named.style.theme,
        (size != Size::FULL_HD, size.width(), size.height()),
        named.stem(),
    )
}

/// The figures in `folder`, in the order of the course, those of the same figure side by side. What is not ours is left
/// out, and so is what cannot be read.
pub fn shown(folder: &Path) -> Vec<Shown> {
    let mut found: BTreeMap<Order, (Named, Vec<Format>)> = BTreeMap::new();
    for lecture in lectures() {
        let entries = fs::read_dir(folder.join(lecture)).into_iter().flatten();
        for entry in entries.flatten() {
            let name = entry.file_name();
            let Some((named, format)) = name.to_str().and_then(|name| read_name(lecture, name))
            else {
                continue;
            };
            if fs::metadata(entry.path()).is_ok_and(|about| about.is_file()) {
                let (_, formats) = found.entry(order(&named)).or_insert((named, Vec::new()));
                formats.push(format);
            }
        }
    }
    let found = found.into_values();
    found
        .map(|(named, mut formats)| {
            formats.sort();
            about(folder, named, formats)
        })
        .collect()
}

/// The lectures that have figures, in the order of the course.
pub fn lectures() -> Vec<&'static str> {
    let mut lectures: Vec<&str> = figures().iter().map(|figure| figure.lecture()).collect();
    lectures.dedup();
    lectures
}

/// With its title and command: from the SVG where it is there, else from the name.
fn about(folder: &Path, named: Named, formats: Vec<Format>) -> Shown {
    let front = if formats.contains(&Format::Svg) {
        front(&folder.join(format!("{}.svg", named.stem())))
    } else {
        String::new()
    };
    let title = between(&front, "<title>", "</title>").unwrap_or_else(|| {
        named
            .figure
            .summary(&Inputs::default(), named.style.language)
    });
    let command = between(&front, "<metadata>", "</metadata>")
        .and_then(|text| Some(text.split_once(MADE_BY)?.1.to_owned()))
        .or_else(|| {
            let known = named.variant.is_none();
            known.then(|| command_of_style(named.figure, &named.style))
        });
    Shown {
        named,
        formats,
        title,
        command,
    }
}

/// The beginning of a file, empty where it cannot be read.
fn front(path: &Path) -> String {
    let mut bytes = Vec::new();
    if let Ok(file) = fs::File::open(path) {
        let _ = file.take(FRONT).read_to_end(&mut bytes);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn between(text: &str, start: &str, end: &str) -> Option<String> {
    let (_, rest) = text.split_once(start)?;
    let (inside, _) = rest.split_once(end)?;
    let inside = inside
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&amp;", "&");
    Some(inside)
}

/// The SVG with the command that made it in its metadata.
pub(crate) fn with_command(svg: &str, command: &str) -> String {
    let command = crate::svg::escaped(command);
    svg.replacen(
        "</metadata>",
        &format!(". {MADE_BY}{command}</metadata>"),
        1,
    )
}
