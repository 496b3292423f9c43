//! What every figure keeps to: in every language, aspect and theme; a figure added to the list is covered at once.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;

use ombra_figures::course::figures;
use ombra_figures::drawing::{Drawing, Item, MARGIN};
use ombra_figures::figure::{Figure, Inputs};
use ombra_figures::object::said;
use ombra_figures::path::Rect;
use ombra_figures::style::{Background, Language, Size, Style, TextForm, Theme};
use ombra_figures::text::{LABEL, Line, SMALLEST};
use ombra_figures::words::Word;
use ombra_figures::{docs, gallery, png, solid, svg, words};
use ombra_math::glam::{DVec2, DVec4};

/// Every figure in every language, aspect and theme, with and without caption, and as it stands in doc comments.
fn drawings() -> impl Iterator<Item = (String, Drawing)> {
    let sizes = [(1920, 1080), (1024, 768), (720, 405)];
    figures().iter().flat_map(move |figure| {
        sizes.into_iter().flat_map(move |(width, height)| {
            Language::ALL.iter().flat_map(move |&language| {
                Theme::ALL.iter().flat_map(move |&theme| {
                    [false, true].into_iter().map(move |caption| {
                        let size = Size::new(width, height).unwrap();
                        let style = Style {
                            size,
                            theme,
                            language,
                            caption,
                            ..Style::default()
                        };
                        let name =
                            format!("{} {size} {language} {theme} caption {caption}", figure.id);
                        let drawing = figure.draw(&style, &Inputs::default());
                        (
                            name.clone(),
                            drawing.unwrap_or_else(|error| panic!("{name}: {error}")),
                        )
                    })
                })
            })
        })
    })
}

fn default(figure: &Figure) -> Drawing {
    figure.draw(&Style::default(), &Inputs::default()).unwrap()
}

#[test]
fn no_label_meets_another_leaves_the_canvas_or_is_too_small() {
    for (name, drawing) in drawings() {
        // Half a hundredth is what rounding may move a box.
        let inside =
            Rect::new(DVec2::splat(MARGIN), drawing.canvas - DVec2::splat(MARGIN)).grown(0.005);
        for (i, label) in drawing.labels.iter().enumerate() {
            assert!(
                inside.contains(&label.bounds),
                "{name}: '{}' leaves the canvas",
                label.text
            );
            assert!(
                label.smallest >= SMALLEST,
                "{name}: '{}' has letters of {}",
                label.text,
                label.smallest
            );
            for other in &drawing.labels[..i] {
                assert!(
                    !label.bounds.meets(&other.bounds),
                    "{name}: '{}' meets '{}'",
                    label.text,
                    other.text
                );
            }
        }
    }
}

#[test]
fn every_letter_drawn_is_in_the_list_of_labels() {
    for (name, drawing) in drawings() {
        let letters = drawing
            .items
            .iter()
            .filter(|item| matches!(item, Item::Text { .. }))
            .count();
        assert_eq!(letters, drawing.labels.len(), "{name}");
    }
}

/// Every word of every figure, those that several share, and the gallery's.
fn words() -> BTreeSet<Word> {
    let of_figures = figures().iter().map(|figure| figure.words);
    let all = of_figures.chain([words::WORDS, gallery::WORDS, solid::WORDS, said::WORDS]);
    all.flatten().copied().collect()
}

#[test]
fn every_word_of_every_language_can_be_set() {
    let words = words();
    assert!(words.len() > figures().len());
    for word in words {
        for &language in Language::ALL {
            let Some(text) = word.translated(language) else {
                continue;
            };
            let said = format!("'{text}' ({language} of '{}')", word.en);
            assert!(!text.is_empty() && text.trim() == text, "{said}");
            if let Err(error) = Line::new(text, LABEL) {
                panic!("{said}: {error}");
            }
        }
    }
}

/// Never fails: English stands in. `cargo test -p ombra-figures not_translated -- --nocapture` shows them.
#[test]
fn words_not_translated_are_printed() {
    for word in words() {
        for &language in Language::ALL {
            if word.translated(language).is_none() {
                println!("no {language} of '{}'", word.en);
            }
        }
    }
}

#[test]
fn nothing_drawn_lies_off_the_canvas() {
    for (name, drawing) in drawings() {
        let canvas = Rect::new(DVec2::ZERO, drawing.canvas);
        for item in &drawing.items {
            if let Item::Shape { path, .. } = item {
                for p in path.points() {
                    assert!(
                        canvas.contains(&Rect::new(p, p)),
                        "{name}: a shape reaches {p}"
                    );
                }
            }
        }
    }
}

/// Tags open and close in order, attributes are quoted, nothing but tags and escaped text.
fn check_xml(name: &str, text: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        assert!(!rest[..start].contains('>'), "{name}: a stray '>'");
        let end = start
            + rest[start..]
                .find('>')
                .unwrap_or_else(|| panic!("{name}: a tag stays open"));
        let tag = &rest[start + 1..end];
        assert_eq!(tag.matches('"').count() % 2, 0, "{name}: {tag}");
        assert!(!tag.contains('<'), "{name}: {tag}");
        if let Some(closing) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(closing), "{name}");
        } else if !tag.ends_with('/') {
            open.push(tag.split_whitespace().next().unwrap());
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty(), "{name}: {open:?} stays open");
    for (at, _) in text.match_indices('&') {
        let entity = &text[at..text.len().min(at + 6)];
        assert!(
            ["&amp;", "&lt;", "&gt;", "&quot;"]
                .iter()
                .any(|known| entity.starts_with(known)),
            "{name}: {entity}"
        );
    }
}

fn check_svg(name: &str, id: &str, text: &str) {
    check_xml(name, text);
    let first = text.lines().next().unwrap();
    assert!(
        first.starts_with("<svg ") && first.ends_with('>') && first.matches('<').count() == 1,
        "{name}"
    );
    assert!(
        first.contains(" role=\"img\"") && first.contains(" aria-label=\""),
        "{name}"
    );
    assert!(
        text.lines().all(|line| !line.trim().is_empty()),
        "{name} has an empty line"
    );
    assert!(
        text.contains("<title>") && !text.contains("<style"),
        "{name}"
    );
    assert!(
        text.contains("<metadata>") && text.contains("CC0 1.0"),
        "{name}"
    );
    let prefix = id.replace('/', "-");
    let mut ids = BTreeSet::new();
    for (at, _) in text.match_indices(" id=\"") {
        let id = text[at + 5..].split('"').next().unwrap();
        assert!(id.starts_with(&prefix), "{name}: id {id}");
        assert!(ids.insert(id), "{name}: id {id} twice");
    }
    for reference in ["href=\"#", "url(#"] {
        for (at, _) in text.match_indices(reference) {
            let id = text[at + reference.len()..]
                .split(['"', ')'])
                .next()
                .unwrap();
            assert!(ids.contains(id), "{name}: nothing has the id {id}");
        }
    }
    for wrong in ["NaN", "inf\"", "\"-0\"", "e-"] {
        let numbers_only = text
            .split(" d=\"")
            .skip(1)
            .map(|d| d.split('"').next().unwrap());
        assert!(
            numbers_only.clone().all(|d| !d.contains(wrong)),
            "{name}: {wrong}"
        );
    }
}

#[test]
fn svgs_are_well_formed_and_fit_into_a_page_among_others() {
    for (name, mut drawing) in drawings() {
        let outlines = svg::svg(&drawing).unwrap();
        check_svg(&name, &drawing.id, &outlines);
        assert!(!outlines.contains("<text"), "{name}");
        drawing.style.text = TextForm::Text;
        drawing.style.background = Background::Transparent;
        let letters = svg::svg(&drawing).unwrap();
        check_svg(&name, &drawing.id, &letters);
        assert_eq!(
            letters.matches("<text").count(),
            drawing.labels.len(),
            "{name}"
        );
    }
    for figure in figures() {
        let text = docs::docs_svg(figure).unwrap();
        check_svg(figure.id, figure.id, &text);
        assert!(
            text.len() < 60_000,
            "{}: {} bytes are much for a doc comment",
            figure.id,
            text.len()
        );
    }
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    for figure in figures() {
        let (one, two) = (default(figure), default(figure));
        assert_eq!(
            svg::svg(&one).unwrap(),
            svg::svg(&two).unwrap(),
            "{}",
            figure.id
        );
        let style = Style {
            size: Size::new(320, 180).unwrap(),
            ..Style::default()
        };
        let small = || png::png(&figure.draw(&style, &Inputs::default()).unwrap()).unwrap();
        assert!(small() == small(), "{}", figure.id);
    }
}

#[test]
fn themes_and_backgrounds_change_colours_and_nothing_else() {
    for figure in figures() {
        let light = default(figure);
        let dark = figure
            .draw(
                &Style {
                    theme: Theme::Dark,
                    ..Style::default()
                },
                &Inputs::default(),
            )
            .unwrap();
        assert_ne!(svg::svg(&light).unwrap(), svg::svg(&dark).unwrap());
        assert_eq!(light.labels, dark.labels, "{}", figure.id);
    }
}

#[test]
fn a_moved_light_moves_labels_and_geometry() {
    for figure in figures().iter().filter(|figure| figure.takes.light) {
        let usual = default(figure);
        let inputs = Inputs {
            light: Some(DVec4::new(-3.0, 20.0, 5.0, 0.0)),
            ..Inputs::default()
        };
        let moved = figure
            .draw(&Style::default(), &inputs)
            .unwrap_or_else(|error| panic!("{}: {error}", figure.id));
        let words = |drawing: &Drawing| -> BTreeSet<String> {
            drawing
                .labels
                .iter()
                .map(|label| label.text.clone())
                .collect()
        };
        assert_ne!(words(&usual), words(&moved), "{}", figure.id);
        let shapes = |drawing: &Drawing| -> Vec<Item> {
            drawing
                .items
                .iter()
                .filter(|item| matches!(item, Item::Shape { .. }))
                .cloned()
                .collect()
        };
        assert_ne!(shapes(&usual), shapes(&moved), "{}", figure.id);
    }
}

/// The slides' answer (Olomouc, Zdroj v nekonečnu, Příklad): P = V − (y_V / y_L) L.
#[test]
fn cube_infinity_shows_the_lectures_coordinates() {
    let figure = figures()
        .iter()
        .find(|figure| figure.id == "shadows/cube-infinity")
        .unwrap();
    let drawing = default(figure);
    for expected in [
        "P1 = P7 (−20, 0, −20)",
        "P2 (−10, 0, −20)",
        "P3 (−10, 0, −10)",
        "P4 (−20, 0, −10)",
        "P5 (−30, 0, −30)",
        "P6 (−20, 0, −30)",
        "P8 (−30, 0, −20)",
        "L = (10, 10, 10, 0)",
    ] {
        assert!(
            drawing.labels.iter().any(|label| label.text == expected),
            "{expected}"
        );
    }
}

/// Light, plane and object far outside what a figure is made for: it is drawn within the canvas or says why not.
#[test]
fn wild_inputs_are_drawn_or_refused_in_a_sentence() {
    let lights = [
        None,
        Some(DVec4::new(0.0, 1.0, 0.0, 0.0)),
        Some(DVec4::new(1.0, 1e-9, 0.0, 0.0)),
        Some(DVec4::new(0.0, -5.0, 0.0, 1.0)),
        Some(DVec4::new(5.0, 25.0, 5.0, 1.0)),
        Some(DVec4::new(-3.0, -40.0, 2.0, -1.0)),
        Some(DVec4::splat(1e300)),
        Some(DVec4::splat(5e-324)),
        Some(DVec4::splat(f64::NAN)),
    ];
    let plane = |a, b, c, d| {
        let normal = ombra_math::glam::DVec3::new(a, b, c);
        Some(ombra_math::plane::Plane { normal, d })
    };
    let planes = [
        None,
        plane(1.0, 0.3, 0.0, 30.0),
        plane(0.0, 0.0, 1.0, 25.0),
        plane(0.0, 1e300, 0.0, 1e300),
        plane(0.0, 1e-300, 0.0, 0.0),
        plane(0.0, 1.0, 0.0, 1e300),
        plane(0.0, 0.0, 0.0, 1.0),
        plane(f64::NAN, 1.0, 0.0, f64::INFINITY),
    ];
    for figure in figures() {
        for light in lights {
            for plane in planes {
                for mesh in [None, "torus".parse().ok()] {
                    let inputs = Inputs { light, plane, mesh };
                    match figure.draw(&Style::default(), &inputs) {
                        Ok(drawing) => {
                            check_svg(figure.id, figure.id, &svg::svg(&drawing).unwrap());
                        }
                        Err(error) => assert!(error.to_string().len() > 20, "{error}"),
                    }
                }
            }
        }
    }
}
