//! What another program sees in our files: SVGs are parsed and drawn by resvg and compared with our PNGs, PDFs are
//! parsed by lopdf.

#![allow(clippy::unwrap_used, clippy::panic)]

use lopdf::content::Content;
use lopdf::{Document, Object};
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

#[test]
fn every_pdf_is_one_page_of_the_drawings_size_with_its_operators_in_pairs() {
    for figure in figures() {
        let drawing = drawn(figure, Theme::Light, TextForm::Paths);
        let bytes = pdf::pdf(&drawing).unwrap();
        assert!(bytes == pdf::pdf(&drawing).unwrap(), "{}", figure.id);
        for word in ["CreationDate", "ModDate", "/ID"] {
            let word = word.as_bytes();
            assert!(!bytes.windows(word.len()).any(|part| part == word));
        }
        let document = Document::load_mem(&bytes).unwrap();
        let pages = document.get_pages();
        assert_eq!(pages.len(), 1, "{}", figure.id);
        let page = *pages.values().next().unwrap();
        let dictionary = document.get_dictionary(page).unwrap();
        let size: Vec<f32> = dictionary
            .get(b"MediaBox")
            .and_then(Object::as_array)
            .unwrap()
            .iter()
            .map(|number| number.as_float().unwrap())
            .collect();
        // 3/4 of 480 × 270.
        assert_eq!(size, [0.0, 0.0, 360.0, 202.5]);

        let content = document.get_page_content(page);
        let operations = Content::decode(&content).unwrap().operations;
        let count = |names: &[&str]| {
            let known = |o: &&lopdf::content::Operation| names.contains(&o.operator.as_str());
            operations.iter().filter(known).count()
        };
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
        // Whatever a name stands for is in the page's dictionaries.
        let resources = dictionary
            .get(b"Resources")
            .and_then(Object::as_dict)
            .unwrap();
        for (operator, kind) in [("gs", "ExtGState"), ("scn", "Pattern"), ("Do", "XObject")] {
            for operation in operations.iter().filter(|o| o.operator == operator) {
                let name = operation.operands.last().and_then(|o| o.as_name().ok());
                let known = resources.get(kind.as_bytes()).and_then(Object::as_dict);
                let id = known
                    .unwrap()
                    .get(name.unwrap())
                    .and_then(Object::as_reference);
                document.get_object(id.unwrap()).unwrap();
            }
        }
    }
}
