//! What another program sees in our files: SVGs are parsed and drawn by resvg and compared with our PNGs, PDFs are read
//! back by their own cross-reference table.

#![allow(clippy::unwrap_used, clippy::panic)]

use ombra_figures::course::figures;
use ombra_figures::drawing::{Drawing, Item};
use ombra_figures::figure::Figure;
use ombra_figures::input::Inputs;
use ombra_figures::style::{Size, Style, TextForm, Theme};
use ombra_figures::{pdf, png, svg};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

fn drawn(figure: &Figure, theme: Theme, text: TextForm) -> Drawing {
    let style = Style {
        size: Size::new(480, 270).unwrap(),
        theme,
        text,
        ..Style::default()
    };
    figure.draw(&style, &Inputs::default()).unwrap()
}

fn rendered(text: &str) -> Pixmap {
    let tree = Tree::from_str(text, &Options::default()).unwrap();
    let size = tree.size().to_int_size();
    let mut pixels = Pixmap::new(size.width(), size.height()).unwrap();
    resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
    pixels
}

/// Mean of the differences of all channels, and how many pixels differ in a channel by more than a quarter of 255.
fn apart(a: &Pixmap, b: &Pixmap) -> (f64, usize) {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    let differences: Vec<u8> = (a.data().iter().zip(b.data()))
        .map(|(&a, &b)| a.abs_diff(b))
        .collect();
    let sum: f64 = differences.iter().copied().map(f64::from).sum();
    let far = differences
        .chunks(4)
        .filter(|pixel| pixel.iter().any(|&d| d > 64))
        .count();
    (sum / differences.len() as f64, far)
}

/// Both cover pixels in the same way, but resvg puts the scale into the outlines' numbers, so that they round elsewhere,
/// and takes a picture's edge otherwise. A mean of 1/2 of 255 and 10 pixels far off allow for that; the smallest label
/// has some 30 pixels.
const MEAN: f64 = 0.5;
const FAR: usize = 10;

#[test]
fn every_svg_read_by_another_program_is_the_picture_of_the_png() {
    for figure in figures() {
        let drawing = drawn(figure, Theme::Light, TextForm::Paths);
        let ours = Pixmap::decode_png(&png::png(&drawing).unwrap()).unwrap();
        let (mean, far) = apart(&ours, &rendered(&svg::svg(&drawing).unwrap()));
        println!("{}: mean {mean:.4}, {far} pixels far off", figure.id);
        assert!(mean < MEAN && far <= FAR, "{}: {mean} {far}", figure.id);
    }
}

#[test]
fn a_label_left_out_of_an_svg_is_seen() {
    for figure in figures() {
        let drawing = drawn(figure, Theme::Light, TextForm::Paths);
        let ours = Pixmap::decode_png(&png::png(&drawing).unwrap()).unwrap();
        let last = drawing
            .items
            .iter()
            .rposition(|item| matches!(item, Item::Text { .. }))
            .unwrap();
        let mut without = drawing.clone();
        without.items.remove(last);
        let (mean, far) = apart(&ours, &rendered(&svg::svg(&without).unwrap()));
        println!("{}: mean {mean:.4}, {far} pixels far off", figure.id);
        assert!(mean >= MEAN || far > FAR, "{}: {mean} {far}", figure.id);
    }
}

#[test]
fn svgs_with_letters_are_read_too() {
    for figure in figures() {
        let drawing = drawn(figure, Theme::Dark, TextForm::Text);
        let tree = Tree::from_str(&svg::svg(&drawing).unwrap(), &Options::default());
        let size = tree.unwrap().size();
        assert_eq!((size.width(), size.height()), (480.0, 270.0));
    }
}

/// A PDF as its own cross-reference table says it is, read without the writer's help.
struct Parsed<'a> {
    /// Objects by number, from the first on, without `obj` and `endobj`.
    objects: Vec<&'a [u8]>,
}

fn text(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

fn position(bytes: &[u8], word: &str) -> Option<usize> {
    bytes
        .windows(word.len())
        .position(|part| part == word.as_bytes())
}

impl Parsed<'_> {
    fn new(bytes: &[u8]) -> Parsed<'_> {
        assert!(bytes.starts_with(b"%PDF-1.") && bytes.ends_with(b"%%EOF"));
        let tail = text(&bytes[bytes.len() - 64..]);
        let start: usize = tail
            .split("startxref")
            .nth(1)
            .unwrap()
            .split_whitespace()
            .next()
            .unwrap()
            .parse()
            .unwrap();
        let table = text(&bytes[start..]);
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some("xref"));
        let count: usize = lines
            .next()
            .unwrap()
            .split(' ')
            .nth(1)
            .unwrap()
            .parse()
            .unwrap();
        let objects = (1..count).map(|number| {
            let entry = table.lines().nth(2 + number).unwrap();
            let at: usize = entry.split(' ').next().unwrap().parse().unwrap();
            let body = &bytes[at..];
            let head = format!("{number} 0 obj");
            assert!(body.starts_with(head.as_bytes()), "object {number}");
            let end = position(body, "\nendobj").unwrap();
            &body[head.len()..end]
        });
        Parsed {
            objects: objects.collect(),
        }
    }

    fn only(&self, word: &str) -> String {
        let found: Vec<String> = self
            .objects
            .iter()
            .map(|object| text(object))
            .filter(|object| object.contains(word))
            .collect();
        assert_eq!(found.len(), 1, "{word}");
        found[0].clone()
    }

    /// What a stream holds, unpacked.
    fn stream(&self, number: usize) -> Vec<u8> {
        let object = self.objects[number - 1];
        let start = position(object, "stream\n").unwrap() + "stream\n".len();
        let end = object.len() - "\nendstream".len();
        miniz_oxide::inflate::decompress_to_vec_zlib(&object[start..end]).unwrap()
    }
}

/// The number after a word: of `/Contents 7 0 R` 7.
fn number_after(object: &str, word: &str) -> usize {
    let rest = object.split(word).nth(1).unwrap();
    rest.split_whitespace().next().unwrap().parse().unwrap()
}

#[test]
fn every_pdf_is_one_page_of_the_drawings_size_with_its_operators_in_pairs() {
    for figure in figures() {
        let drawing = drawn(figure, Theme::Light, TextForm::Paths);
        let bytes = pdf::pdf(&drawing).unwrap();
        assert!(bytes == pdf::pdf(&drawing).unwrap(), "{}", figure.id);
        for word in ["CreationDate", "ModDate", "/ID"] {
            assert_eq!(position(&bytes, word), None);
        }
        let parsed = Parsed::new(&bytes);
        let page = parsed.only("/Type /Page\n");
        // 3/4 of 480 × 270.
        assert!(page.contains("/MediaBox [0 0 360 202.5]"), "{page}");
        let content = text(&parsed.stream(number_after(&page, "/Contents ")));
        let words: Vec<&str> = content.split_whitespace().collect();
        let count = |names: &[&str]| words.iter().filter(|word| names.contains(word)).count();
        assert_eq!(count(&["q"]), count(&["Q"]), "{}", figure.id);
        let (mut fills, mut strokes, mut pictures) = (1, 0, 0);
        for item in &drawing.items {
            match item {
                Item::Shape { path, fill, stroke } if !path.segments.is_empty() => {
                    fills += usize::from(fill.is_some());
                    strokes += usize::from(stroke.is_some());
                }
                Item::Shape { .. } => {}
                Item::Text { halo, .. } => {
                    fills += 1;
                    strokes += usize::from(*halo);
                }
                Item::Picture { .. } => pictures += 1,
            }
        }
        assert_eq!(count(&["f", "f*"]), fills, "{}", figure.id);
        assert_eq!(count(&["S"]), strokes, "{}", figure.id);
        assert_eq!(count(&["Do"]), pictures, "{}", figure.id);
        // Whatever a name stands for is an object that the page knows.
        for pair in words.windows(2) {
            if let [name, "gs" | "scn" | "SCN" | "Do"] = pair {
                let number = number_after(&page, &format!("{name} "));
                assert!((1..=parsed.objects.len()).contains(&number), "{name}");
            }
        }
    }
}
