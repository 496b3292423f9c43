//! What every figure keeps to: in every language, aspect and theme; a figure added to the list is covered at once.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;

use ombra_figures::course::figures;
use ombra_figures::drawing::{Drawing, Item, MARGIN};
use ombra_figures::error::FigureError;
use ombra_figures::figure::Figure;
use ombra_figures::input::{Inputs, Kind};
use ombra_figures::object::said;
use ombra_figures::path::Rect;
use ombra_figures::style::{Background, Language, Size, Style, TextForm, Theme};
use ombra_figures::text::{LABEL, Line, SMALLEST};
use ombra_figures::words::Word;
use ombra_figures::{docs, gallery, png, solid, svg, words};
use ombra_math::glam::DVec2;

/// The aspects slides have, a small picture, and the most slender sheets that are promised.
const SIZES: [(u32, u32); 7] = [
    (1920, 1080),
    (1024, 768),
    (360, 240),
    (1080, 1080),
    (768, 1024),
    (2000, 1000),
    (540, 1080),
];

/// Every figure in every language and aspect, with and without caption.
fn drawings() -> impl Iterator<Item = (&'static str, String, Drawing)> {
    figures().iter().flat_map(move |figure| {
        SIZES.into_iter().flat_map(move |(width, height)| {
            Language::ALL.iter().flat_map(move |&language| {
                [false, true].into_iter().map(move |caption| {
                    let size = Size::new(width, height).unwrap();
                    let style = Style {
                        size,
                        language,
                        caption,
                        ..Style::default()
                    };
                    let name = format!("{} {size} {language} caption {caption}", figure.id);
                    let drawing = figure.draw(&style, &Inputs::default());
                    {
                        let drawing = drawing.unwrap_or_else(|error| panic!("{name}: {error}"));
                        (figure.id, name, drawing)
                    }
                })
            })
        })
    })
}

fn default(figure: &Figure) -> Drawing {
    figure.draw(&Style::default(), &Inputs::default()).unwrap()
}

/// Why a drawing is not as every drawing must be: no label meets another, leaves the canvas or is too small; nothing
/// drawn lies off the canvas.
fn fault(name: &str, drawing: &Drawing) -> Option<String> {
    // A hundredth is what rounding may move a box.
    let inside = Rect::new(DVec2::splat(MARGIN), drawing.canvas - DVec2::splat(MARGIN)).grown(0.02);
    for (i, label) in drawing.labels.iter().enumerate() {
        let text = &label.text;
        if !inside.contains(&label.bounds) {
            return Some(format!(
                "{name}: '{text}' leaves the canvas: {:?}",
                label.bounds
            ));
        }
        if label.smallest < SMALLEST - 1e-9 {
            return Some(format!(
                "{name}: '{text}' has letters of {}",
                label.smallest
            ));
        }
        let shrunk = label.bounds.grown(-0.02);
        if let Some(other) = drawing.labels[..i]
            .iter()
            .find(|other| shrunk.meets(&other.bounds))
        {
            return Some(format!("{name}: '{text}' meets '{}'", other.text));
        }
    }
    let letters = |item: &&Item| matches!(item, Item::Text { .. });
    let letters = drawing.items.iter().filter(letters).count();
    if letters != drawing.labels.len() {
        return Some(format!(
            "{name}: {letters} texts, {} labels",
            drawing.labels.len()
        ));
    }
    let canvas = Rect::new(DVec2::ZERO, drawing.canvas).grown(0.02);
    let shapes = drawing.items.iter().filter_map(|item| match item {
        Item::Shape { path, .. } => Some(path),
        _ => None,
    });
    let off = |p: &DVec2| !canvas.contains(&Rect::new(*p, *p));
    let off = shapes
        .flat_map(|path| path.points().collect::<Vec<_>>())
        .find(off);
    off.map(|p| format!("{name}: a shape reaches {p}"))
}

/// The first fault of each figure, all together.
fn told(mut faults: Vec<(&str, String)>) {
    faults.dedup_by_key(|(figure, _)| *figure);
    let lines: Vec<&str> = faults.iter().map(|(_, fault)| fault.as_str()).collect();
    assert!(
        lines.is_empty(),
        "{} figures\n{}",
        lines.len(),
        lines.join("\n")
    );
}

#[test]
fn every_figure_has_room_in_every_language_and_aspect() {
    let mut faults = Vec::new();
    for (figure, name, drawing) in drawings() {
        faults.extend(fault(&name, &drawing).map(|fault| (figure, fault)));
        if !drawing.over.is_empty() {
            faults.push((figure, format!("{name}: no room for {:?}", drawing.over)));
        }
    }
    told(faults);
}

/// Letters may be twice as large and are still placed.
#[test]
fn larger_letters_find_room_too() {
    // Letters that fill cells get smaller as others get larger; the largest may not.
    let most = |drawing: &Drawing| {
        let sizes = drawing.labels.iter().map(|label| label.smallest);
        sizes.fold(0.0, f64::max)
    };
    let mut faults = Vec::new();
    for figure in figures() {
        let usual = default(figure);
        let style = Style {
            text_scale: "2".parse().unwrap(),
            ..Style::default()
        };
        let large = figure.draw(&style, &Inputs::default()).unwrap();
        faults.extend(fault(figure.id, &large).map(|fault| (figure.id, fault)));
        if !large.over.is_empty() || most(&large) < most(&usual) - 1e-9 {
            faults.push((
                figure.id,
                format!("{}: no room for {:?}", figure.id, large.over),
            ));
        }
    }
    told(faults);
}

/// A stream of numbers that is the same on every run.
struct Random(u64);

impl Random {
    /// In 0..1.
    fn unit(&mut self) -> f64 {
        // Knuth's constants; the upper bits are the better ones.
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, [least, most]: [f64; 2]) -> f64 {
        least + (most - least) * self.unit()
    }

    /// Mostly a round number, as people type them.
    fn number(&mut self, range: [f64; 2]) -> f64 {
        let x = match range {
            // Of a range over many powers of ten each is as likely.
            [least, most] if least > 0.0 && most > 1000.0 * least => {
                least * libm::pow(most / least, self.unit())
            }
            _ => self.within(range),
        };
        let round = match (self.unit() * 3.0) as u32 {
            0 => x,
            1 => (x * 10.0).round() / 10.0,
            _ => x.round(),
        };
        round.clamp(range[0], range[1])
    }

    fn point(&mut self, [low, high]: [[f64; 2]; 2]) -> String {
        let (x, y) = (
            self.number([low[0], high[0]]),
            self.number([low[1], high[1]]),
        );
        format!("{x},{y}")
    }

    /// Any value of a kind.
    fn value(&mut self, kind: &Kind) -> String {
        let far = [-200.0, 200.0];
        match *kind {
            Kind::Number { range, .. } => self.number(range).to_string(),
            Kind::Whole {
                range: [least, most],
                ..
            } => {
                let x = self.within([f64::from(least), f64::from(most) + 1.0]);
                (x.floor() as i32).min(most).to_string()
            }
            Kind::Point { range, .. } => self.point(range),
            Kind::Pixel {
                range: [low, high], ..
            } => {
                let mut whole = |i: usize| {
                    let x = self.within([f64::from(low[i]), f64::from(high[i]) + 1.0]);
                    (x.floor() as i32).min(high[i])
                };
                format!("{},{}", whole(0), whole(1))
            }
            Kind::Place { range, .. } => {
                let [x, y, z] = [0; 3].map(|_| self.number(range));
                format!("{x},{y},{z}")
            }
            Kind::Polygon {
                corners: [fewest, most],
                range,
                ..
            } => {
                let count = fewest + (self.unit() * (most.min(12) - fewest + 1) as f64) as usize;
                let corners: Vec<String> =
                    (0..count.min(most)).map(|_| self.point(range)).collect();
                corners.join(" ")
            }
            Kind::Light { .. } => {
                let [x, y, z] = [0; 3].map(|_| self.number(far));
                let w = ["0", "1", "-1", "0.5"][(self.unit() * 4.0) as usize];
                format!("{x},{y},{z},{w}")
            }
            Kind::Plane { .. } => {
                let [a, b, c] = [0; 3].map(|_| self.number([-3.0, 3.0]));
                format!("{a},{b},{c},{}", self.number([-40.0, 40.0]))
            }
            Kind::Object { .. } => {
                ["cube", "teapot", "sphere", "torus"][(self.unit() * 4.0) as usize].to_owned()
            }
            Kind::Choice { of, .. } => of[(self.unit() * of.len() as f64) as usize].to_owned(),
        }
    }
}

/// The ends of a kind's range, and what is degenerate.
fn extremes(kind: &Kind) -> Vec<String> {
    match *kind {
        Kind::Number { range, .. } => range.map(|x| x.to_string()).to_vec(),
        Kind::Whole { range, .. } => range.map(|x| x.to_string()).to_vec(),
        Kind::Point {
            range: [low, high], ..
        } => {
            let of = |p: [f64; 2]| format!("{},{}", p[0], p[1]);
            vec![
                of(low),
                of(high),
                of([low[0], high[1]]),
                of([high[0], low[1]]),
            ]
        }
        Kind::Pixel {
            range: [low, high], ..
        } => {
            let of = |p: [i32; 2]| format!("{},{}", p[0], p[1]);
            vec![
                of(low),
                of(high),
                of([low[0], high[1]]),
                of([high[0], low[1]]),
            ]
        }
        Kind::Place {
            range: [least, most],
            ..
        } => vec![
            format!("{least},{least},{least}"),
            format!("{most},{most},{most}"),
            format!("{least},{most},{least}"),
        ],
        Kind::Polygon {
            corners: [fewest, most],
            range: [low, high],
            ..
        } => {
            let same = format!("{},{}", low[0], low[1]);
            let line = |n: usize| -> Vec<String> {
                let at = |i: usize| low[0] + (high[0] - low[0]) * i as f64 / n as f64;
                (0..n).map(|i| format!("{},{}", at(i), low[1])).collect()
            };
            vec![
                vec![same; fewest].join(" "),
                line(fewest).join(" "),
                line(most).join(" "),
                [
                    format!("{},{}", low[0], low[1]),
                    format!("{},{}", high[0], high[1]),
                    format!("{},{}", high[0], low[1]),
                    format!("{},{}", low[0], high[1]),
                ][..4.min(most)]
                    .join(" "),
            ]
        }
        Kind::Light { .. } => [
            "0,1,0,0",
            "1,1e-9,0,0",
            "1,0.0001,0,0",
            "0,-5,0,1",
            "5,25,5,1",
            "-3,-40,2,-1",
            "1e300,1e300,1e300,1e300",
            "1e308,1e308,1e308,1",
            "5e-324,5e-324,5e-324,5e-324",
            "0,0,0,1",
            "10,30,10,1",
        ]
        .map(str::to_owned)
        .to_vec(),
        Kind::Plane { .. } => [
            "1,0.3,0,30",
            "0,0,1,25",
            "0,1e300,0,1e300",
            "0,1e-300,0,0",
            "0,1,0,1e300",
            "0,-1,0,0",
            "1,0,0,0",
            "0,1,0,-25",
            "1e-9,1,0,0",
        ]
        .map(str::to_owned)
        .to_vec(),
        Kind::Object { .. } => ["teapot", "sphere", "torus", "cube"]
            .map(str::to_owned)
            .to_vec(),
        Kind::Choice { of, .. } => of.iter().map(|&word| word.to_owned()).collect(),
    }
}

#[test]
fn every_input_moved_anywhere_gives_a_drawing_or_a_sentence() {
    let mut random = Random(7);
    let mut turn = 0;
    let mut faults = Vec::new();
    for figure in figures() {
        let mut refused = 0;
        let mut draw = |inputs: &Inputs| {
            turn += 1;
            let (width, height) = SIZES[turn % 5];
            let style = Style {
                size: Size::new(width, height).unwrap(),
                language: Language::ALL[turn % 4],
                ..Style::default()
            };
            let (size, language) = (style.size, style.language);
            let name = format!("{} {size} {language} with {}", figure.id, inputs.typed());
            match figure.draw(&style, inputs) {
                Ok(drawing) => {
                    check_svg(&name, figure.id, &svg::svg(&drawing).unwrap());
                    faults.extend(fault(&name, &drawing).map(|fault| (figure.id, fault)));
                }
                Err(FigureError::Scene { reason })
                    if reason.len() > 20 && !reason.contains("NaN") =>
                {
                    refused += 1;
                }
                Err(error) => faults.push((figure.id, format!("{name}: {error}"))),
            }
        };
        let inputs = figure.takes.inputs();
        for input in inputs {
            for text in extremes(&input.kind) {
                draw(&Inputs::default().with(input, &text).unwrap());
            }
        }
        for _ in 0..if inputs.is_empty() { 0 } else { 16 } {
            let mut moved = Inputs::default();
            for input in inputs {
                if random.unit() < 0.7 {
                    moved = moved.with(input, &random.value(&input.kind)).unwrap();
                }
            }
            draw(&moved);
        }
        println!("{}: {refused} times a sentence", figure.id);
    }
    told(faults);
}

#[test]
fn every_input_changes_the_drawing_and_equal_inputs_give_equal_bytes() {
    let mut random = Random(11);
    for figure in figures() {
        let usual = svg::svg(&default(figure)).unwrap();
        for input in figure.takes.inputs() {
            let values = extremes(&input.kind).into_iter();
            let tried: Vec<String> = values
                .chain((0..12).map(|_| random.value(&input.kind)))
                .collect();
            let changes = |text: &String| {
                let inputs = Inputs::default().with(input, text).unwrap();
                let draw = || figure.draw(&Style::default(), &inputs);
                let Ok(drawing) = draw() else { return false };
                let bytes = svg::svg(&drawing).unwrap();
                assert_eq!(
                    bytes,
                    svg::svg(&draw().unwrap()).unwrap(),
                    "{} {text}",
                    figure.id
                );
                bytes != usual
            };
            assert!(
                tried.iter().any(changes),
                "{}: nothing that {} can be changes it",
                figure.id,
                input.name
            );
        }
    }
}

#[test]
fn inputs_are_declared_alike() {
    for figure in figures() {
        let mut names = BTreeSet::new();
        for input in figure.takes.inputs() {
            let name = format!("{} {}", figure.id, input.name);
            assert!(names.insert(input.name), "{name} is there twice");
            let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-';
            assert!(
                !input.name.is_empty() && input.name.bytes().all(plain),
                "{name}"
            );
            assert_ne!(input.name, ombra_figures::input::STEP, "{name}");
            if let Err(error) = Line::new(input.symbol, LABEL) {
                panic!("{name}: {error}");
            }
            for &language in Language::ALL {
                assert!(
                    input.about.translated(language).is_some(),
                    "{name} has no {language}"
                );
            }
            // The default is a value of its own range, and typed it is no change.
            if !matches!(input.kind, Kind::Object { .. }) {
                let typed = Inputs::default()
                    .with(input, &input.kind.default_text())
                    .unwrap();
                assert!(typed.is_default(), "{name}");
            }
        }
    }
}

/// A step shows what the whole figure shows, at the same places, and no later step less.
#[test]
fn steps_build_the_figure_up_in_one_layout() {
    let style = Style::default();
    let boxes = |drawing: &Drawing| -> Vec<(String, [i64; 2])> {
        let at = |p: DVec2| [p.x, p.y].map(|x| (x * 100.0).round() as i64);
        let labels = drawing.labels.iter();
        labels
            .map(|label| (label.text.clone(), at(label.bounds.min)))
            .collect()
    };
    for figure in figures() {
        let whole = default(figure);
        let last = figure.steps(&style, &Inputs::default()).unwrap();
        let mut before = 0;
        let mut seen = Vec::new();
        for step in 1..=last {
            let inputs = Inputs::default().at_step(step);
            let shown = figure.draw(&style, &inputs).unwrap();
            // Each brings something that the others do not have.
            assert!(!seen.contains(&shown.items), "{} step {step}", figure.id);
            seen.push(shown.items.clone());
            assert_eq!(shown.canvas, whole.canvas);
            let of_whole = boxes(&whole);
            let kept: Vec<_> = boxes(&shown)
                .into_iter()
                .filter(|label| of_whole.contains(label))
                .collect();
            assert!(kept.len() >= before, "{} step {step}", figure.id);
            before = kept.len();
        }
        assert!(
            last == 0 || before == whole.labels.len(),
            "{}: the last step is not whole",
            figure.id
        );
        let beyond = Inputs::default().at_step(last + 1);
        assert!(
            matches!(figure.draw(&style, &beyond), Err(FigureError::Input { .. })),
            "{}",
            figure.id
        );
    }
}

/// Every word of every figure, those that several share, and the gallery's.
fn words() -> BTreeSet<Word> {
    let of_figures = figures().iter().map(|figure| figure.words);
    let inputs = figures().iter().flat_map(|figure| figure.takes.inputs());
    let inputs: Vec<Word> = inputs.map(|input| input.about).collect();
    let all = of_figures.chain([words::WORDS, gallery::WORDS, solid::WORDS, said::WORDS]);
    all.flatten().copied().chain(inputs).collect()
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
    for (_, name, mut drawing) in drawings() {
        let outlines = svg::svg(&drawing).unwrap();
        check_svg(&name, &drawing.id, &outlines);
        assert!(!outlines.contains("<text"), "{name}");
        drawing.style.text = TextForm::Text;
        drawing.style.background = Background::Transparent;
        let letters = svg::svg(&drawing).unwrap();
        check_svg(&name, &drawing.id, &letters);
        // A rim is a text of its own, hidden from readers.
        let rims = letters.matches(" aria-hidden=\"true\"").count();
        let rects = letters
            .lines()
            .filter(|line| line.starts_with("<rect ") && line.contains(" aria-hidden"))
            .count();
        assert_eq!(
            letters.matches("<text").count(),
            drawing.labels.len() + rims - rects,
            "{name}"
        );
        assert!(!letters.contains("paint-order"), "{name}");
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
