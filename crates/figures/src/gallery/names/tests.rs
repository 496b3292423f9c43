use std::collections::BTreeSet;

use super::*;
use crate::style::{Language, Size, Theme};

fn cube() -> &'static Figure {
    figures()
        .iter()
        .find(|figure| figure.id == "shadows/cube-point")
        .unwrap()
}

#[test]
fn what_differs_from_the_default_stands_in_the_name() {
    let default = Style::default();
    assert_eq!(file_stem(cube(), &default, None), "shadows/cube-point");
    let style = Style {
        language: Language::It,
        theme: Theme::Dark,
        size: Size::new(1024, 768).unwrap(),
        ..default
    };
    assert_eq!(
        file_stem(cube(), &style, None),
        "shadows/cube-point.it.dark.1024x768"
    );
    let style = Style {
        background: Background::Transparent,
        text: TextForm::Text,
        caption: true,
        ..default
    };
    assert_eq!(
        file_stem(cube(), &style, Some("step-3")),
        "shadows/cube-point.transparent.text.caption.step-3"
    );
    assert_eq!(
        file_stem(cube(), &default, Some("light=0.5,40,-90,1")),
        "shadows/cube-point.light=0.5,40,-90,1"
    );
}

/// Odd variants, among them what Windows refuses, and those that look like a style's words.
const VARIANTS: &[&str] = &[
    "step-3",
    "step-10",
    "light=0,40,90,1",
    "a.b",
    ".",
    "..",
    "",
    "dark",
    "dark.x",
    "it.dark",
    "IT",
    "1024x768",
    "16:9",
    "text",
    "caption",
    "en",
    "light",
    "theme",
    "transparent",
    "Mesh=A",
    "mesh=a",
    "mesh=a/b.obj",
    "mesh=C:\\b.obj",
    "mesh=číše.obj",
    "a b",
    "a\nb",
    "a~b",
    "con",
    "x*?\"<>|",
    "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa1",
    "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa2",
];

#[test]
fn every_choice_has_a_name_of_its_own_that_is_read_back() {
    let mut seen = BTreeSet::new();
    let sizes = [Size::FULL_HD, Size::new(640, 640).unwrap()];
    let variants = VARIANTS.iter().copied().map(Some).chain([None]);
    for variant in variants {
        for choice in 0..4 * 2 * 2 * 2 * 2 * 2 {
            let bit = |place: usize| choice >> (place + 2) & 1;
            let style = Style {
                language: Language::ALL[choice & 3],
                theme: Theme::ALL[bit(0)],
                size: sizes[bit(1)],
                background: Background::ALL[bit(2)],
                text: [TextForm::Paths, TextForm::Text][bit(3)],
                caption: bit(4) == 1,
            };
            let name = file_stem(cube(), &style, variant);
            assert!(seen.insert(name.to_lowercase()), "{name} is there twice");
            let (lecture, file) = name.split_once('/').unwrap();
            assert!(
                file.len() < 150 && file.chars().all(|c| plain(c) || c == '~'),
                "{name}"
            );
            let (named, format) = read_name(lecture, &format!("{file}.png")).unwrap();
            assert_eq!((named.figure.id, format), (cube().id, Format::Png));
            assert_eq!(named.style, style, "{name}");
            assert_eq!(named.variant.is_some(), variant.is_some(), "{name}");
            assert_eq!(named.stem(), name);
        }
    }
}

#[test]
fn files_of_others_are_not_taken_for_ours() {
    for name in [
        "",
        ".",
        ".svg",
        "cube-point",
        "cube-point.",
        "cube-point.txt",
        "cube-point.SVG",
        "Cube-point.svg",
        "cube-point.dark.it.svg.bak",
        "cube-point.en.svg",
        "cube-point.light.svg",
        "cube-point.DARK.svg",
        "cube-point.1920x1080.svg",
        "cube-point.0640x0640.svg",
        "cube-point..svg",
        "cube-point copy.svg",
        "cube-point.my copy.svg",
        "my-cube-point.svg",
        ".cube-point.svg.77-0.part",
        "čtverec.svg",
    ] {
        assert!(read_name("shadows", name).is_none(), "{name}");
    }
    assert!(read_name("shadows", "cube-point.svg").is_some());
    assert!(read_name("raster", "cube-point.svg").is_none());
}

#[test]
fn the_command_says_what_was_chosen_and_a_shell_reads_it() {
    let input = |name: &str| {
        let mut all = cube().takes.inputs().iter();
        all.find(|input| input.name == name).unwrap()
    };
    let inputs = Inputs::default();
    assert_eq!(variant(&inputs), None);
    let inputs = inputs.with(input("light"), "0,40.5,-90,1").unwrap();
    let style = Style {
        language: Language::Cs,
        theme: Theme::Dark,
        caption: true,
        ..Style::default()
    };
    assert_eq!(
        command(cube(), &style, &inputs),
        "ombra figures shadows/cube-point --lang cs --theme dark --caption --light 0,40.5,-90,1"
    );
    assert_eq!(variant(&inputs).as_deref(), Some("light=0,40.5,-90,1"));
    let step = inputs.with(input("turn"), "30").unwrap().at_step(3);
    assert_eq!(
        variant(&step).as_deref(),
        Some("light=0,40.5,-90,1+turn=30+step-3")
    );
    let style = Style {
        background: Background::Colour(0x1E_5A_A0),
        text_scale: "1.5".parse().unwrap(),
        ..Style::default()
    };
    assert_eq!(
        command(cube(), &style, &step),
        "ombra figures shadows/cube-point --background '#1e5aa0' --text-scale 1.5 --light 0,40.5,-90,1 --set turn=30 --set step=3"
    );
    let stem = file_stem(cube(), &style, None);
    assert_eq!(stem, "shadows/cube-point.on-1e5aa0.scale-150");
    let (named, _) = read_name("shadows", "cube-point.on-1e5aa0.scale-150.svg").unwrap();
    assert_eq!(named.style, style);
    assert_eq!(quoted("my file's.obj"), r"'my file'\''s.obj'");
    assert_eq!(quoted("$(rm)"), "'$(rm)'");
    assert_eq!(quoted(""), "''");
}

#[test]
fn addresses_open_in_a_browser() {
    for (path, windows, address) in [
        ("/a/b.html", false, "file:///a/b.html"),
        (
            "/a b/č#?%\\.html",
            false,
            "file:///a%20b/%C4%8D%23%3F%25%5C.html",
        ),
        (r"C:\a b\i.html", true, "file:///C:/a%20b/i.html"),
        (r"\\?\C:\a\i.html", true, "file:///C:/a/i.html"),
        (r"\\server\share\i.html", true, "file://server/share/i.html"),
        (
            r"\\?\UNC\server\share\i.html",
            true,
            "file://server/share/i.html",
        ),
        ("", false, "file://"),
    ] {
        assert_eq!(address_of(path.as_bytes(), windows), address, "{path}");
    }
    let here = address(Path::new("x/index.html"));
    assert!(here.starts_with("file:///") && here.ends_with("/x/index.html"));
}
