//! The gallery shows what lies in its folder.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process;

use ombra_figures::course::{figures, select};
use ombra_figures::gallery::{file_stem, lectures};
use ombra_figures::input::{Inputs, Settings};
use ombra_figures::style::{Format, Language, Size, Style, Theme};
use ombra_figures::write;
use roxmltree::{Document, Node, ParsingOptions};

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("ombra-gallery-{name}-{}", process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    /// An empty file in the place of a figure's.
    fn put(&self, name: &str) {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "").unwrap();
    }

    fn page(&self, language: Language) -> Page {
        let path = write::index(&self.0, language).unwrap();
        Page(fs::read_to_string(path).unwrap())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The page is HTML that is XML as well, so that an independent parser tells what is in it.
struct Page(String);

impl Page {
    fn document(&self) -> Document<'_> {
        let options = ParsingOptions {
            allow_dtd: true,
            ..ParsingOptions::default()
        };
        Document::parse_with_options(&self.0, options).unwrap_or_else(|error| panic!("{error}"))
    }

    /// What the elements at the end of a path of names hold: `figure a`.
    fn of<T>(&self, path: &str, take: impl Fn(Node) -> T) -> Vec<T> {
        let names: Vec<&str> = path.split(' ').rev().collect();
        let fits = |node: &Node| {
            let mut above = node.ancestors();
            above.next().is_some_and(|node| node.has_tag_name(names[0]))
                && names[1..]
                    .iter()
                    .all(|name| above.any(|node| node.has_tag_name(*name)))
        };
        let document = self.document();
        document.descendants().filter(fits).map(take).collect()
    }

    fn texts(&self, path: &str) -> Vec<String> {
        self.of(path, |node| {
            let texts = node.descendants().filter(Node::is_text);
            texts.filter_map(|text| text.text()).collect()
        })
    }

    fn values(&self, path: &str, attribute: &str) -> Vec<String> {
        self.of(path, |node| node.attribute(attribute).unwrap().to_owned())
    }
}

fn draw(folder: &Path, pattern: &str, style: &Style, inputs: &Inputs, formats: &[Format]) {
    for figure in select(&[pattern]).unwrap() {
        write::figure(folder, figure, style, inputs, formats).unwrap();
    }
}

#[test]
fn another_choice_adds_and_takes_nothing_away() {
    let folder = Folder::new("adds");
    let default = Style::default();
    let none = Inputs::default();
    draw(
        &folder.0,
        "raster/dda",
        &default,
        &none,
        &[Format::Svg, Format::Png],
    );
    let first = folder.page(Language::En);
    assert_eq!(
        first.texts("figure").len(),
        select(&["raster/dda"]).unwrap().len()
    );

    let small = Style {
        size: Size::new(320, 240).unwrap(),
        theme: Theme::Dark,
        language: Language::It,
        ..default
    };
    let mut settings = Settings::default();
    settings.set("light=0,60,90,1").unwrap();
    let light = settings
        .of(select(&["shadows/cube-point"]).unwrap()[0])
        .unwrap();
    draw(
        &folder.0,
        "shadows/cube-point",
        &small,
        &light,
        &[Format::Svg],
    );
    draw(
        &folder.0,
        "shadows/cube-point",
        &default,
        &none,
        &[Format::Png],
    );
    let page = folder.page(Language::It);
    let names = page.texts("h3");
    assert_eq!(
        names[names.len() - 2..],
        ["cube-point", "cube-point.it.dark.320x240.light=0,60,90,1"]
    );
    for source in first.values("img", "src") {
        assert!(page.values("img", "src").contains(&source), "{source}");
    }
    // Titles are words in the page's language, the command is the one that makes the picture.
    assert_eq!(page.texts("h2"), ["Rasterizzazione", "Ombre"]);
    let commands = page.texts("code");
    assert_eq!(
        commands[commands.len() - 2..],
        [
            "ombra figures shadows/cube-point",
            "ombra figures shadows/cube-point --lang it --theme dark --size 320x240 --light 0,60,90,1"
        ]
    );
    // Every file linked is there.
    for file in page.values("figure a", "href") {
        assert!(folder.0.join(&file).is_file(), "{file}");
    }
}

#[test]
fn the_page_is_valid_and_loads_nothing_from_the_network() {
    let folder = Folder::new("valid");
    for figure in figures() {
        for &language in Language::ALL {
            let style = Style {
                language,
                ..Style::default()
            };
            folder.put(&format!("{}.svg", file_stem(figure, &style, None)));
            folder.put(&format!(
                "{}.png",
                file_stem(figure, &style, Some("a<b>&\"c"))
            ));
        }
    }
    for &language in Language::ALL {
        let page = folder.page(language);
        assert_eq!(
            page.texts("figure").len(),
            figures().len() * 2 * Language::ALL.len()
        );
        assert_eq!(page.values("html", "lang"), [language.word()]);
        for (part, times) in [
            ("title", 1),
            ("main", 1),
            ("h1", 1),
            ("section", lectures().len()),
        ] {
            assert_eq!(page.texts(part).len(), times, "{part}");
        }
        // Every link within the page has its goal.
        let ids = page.values("section", "id");
        let goals = page.values("nav a", "href");
        assert!(
            goals
                .iter()
                .map(|goal| goal.trim_start_matches('#'))
                .eq(ids.iter())
        );
        assert!(page.values("img", "alt").iter().all(|alt| !alt.is_empty()));
        assert!(page.texts("script").is_empty() && !page.0.contains("@import"));
        assert!(
            page.values("img", "src")
                .iter()
                .all(|source| !source.contains(':'))
        );
    }
}

#[test]
fn files_of_others_are_left_out_and_untouched() {
    let folder = Folder::new("others");
    let others = [
        "notes.txt",
        "raster/notes.svg",
        "raster/bresenham-trace.my copy.svg",
        "raster/bresenham-trace.svg.bak",
        "raster/.hidden",
        "mine/cube.svg",
        "shadows",
    ];
    for other in others {
        folder.put(other);
    }
    fs::create_dir_all(folder.0.join("raster/bresenham-trace.png")).unwrap();
    assert!(folder.page(Language::En).texts("figure").is_empty());
    for other in others {
        assert!(folder.0.join(other).is_file(), "{other}");
    }
    // What is no SVG inside is shown by its name.
    fs::write(folder.0.join("raster/bresenham-trace.svg"), b"\xff<title>").unwrap();
    let page = folder.page(Language::En);
    assert_eq!(page.texts("h3"), ["bresenham-trace"]);
    assert_eq!(page.texts("code"), ["ombra figures raster/bresenham-trace"]);
}

#[test]
fn steps_stand_in_their_order() {
    let folder = Folder::new("steps");
    for name in [
        "cube-point.step-10",
        "cube-point.step-9",
        "cube-point",
        "cube-point.dark",
    ] {
        folder.put(&format!("shadows/{name}.svg"));
    }
    assert_eq!(
        folder.page(Language::En).texts("h3"),
        [
            "cube-point",
            "cube-point.dark",
            "cube-point.step-9",
            "cube-point.step-10"
        ]
    );
}
