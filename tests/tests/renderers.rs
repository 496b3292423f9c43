//! What a program that others use for SVG sees in our files: every SVG of a folder, drawn by it, against the PNG beside.
//!
//! ```sh
//! cargo run --release -- figures --size 960x540 --out target/renderers
//! OMBRA_RENDERER=chromium OMBRA_RENDERED=target/renderers cargo test -p ombra-tests --test renderers -- --ignored
//! ```
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test that cannot go on fails"
)]

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use image::RgbaImage;
use ombra_tests::sources::root;

/// The renderers cover pixels in ways of their own: at 960 × 540 Chromium and rsvg differ from ours by 0.6 and 0.9 of 255
/// in the mean, where cells meet, and by a quarter of 255 in fewer than 26 pixels of a figure. A letter that is missing
/// is some 60 pixels.
const MEAN: f64 = 1.2;
/// Share of pixels that may differ in a channel by more than a quarter of 255.
const FAR: f64 = 0.000_1;

fn svgs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            svgs(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "svg") {
            found.push(path);
        }
    }
    found.sort();
}

/// `svg` drawn by `renderer` into `png`.
fn render(renderer: &str, svg: &Path, png: &Path, width: u32, height: u32) {
    let mut command = Command::new(renderer);
    if renderer.contains("rsvg") {
        command.arg("-o").arg(png).arg(svg);
    } else {
        command
            .args(["--headless", "--no-sandbox", "--disable-gpu"])
            .arg("--hide-scrollbars")
            .arg(format!("--window-size={width},{height}"))
            .arg(format!("--screenshot={}", png.display()))
            .arg(format!("file://{}", svg.display()));
    }
    let status = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .unwrap_or_else(|error| panic!("{renderer}: {error}"));
    assert!(status.success(), "{renderer} {}: {status}", svg.display());
}

/// Mean of the differences of red, green and blue, and the share of pixels far off.
fn apart(a: &RgbaImage, b: &RgbaImage) -> (f64, f64) {
    assert_eq!(a.dimensions(), b.dimensions());
    let (mut sum, mut far) = (0.0, 0.0);
    for (a, b) in a.pixels().zip(b.pixels()) {
        let [r, g, b] = [0, 1, 2].map(|i| a.0[i].abs_diff(b.0[i]));
        sum += f64::from(r) + f64::from(g) + f64::from(b);
        far += f64::from(u8::from(r.max(g).max(b) > 64));
    }
    let pixels = f64::from(a.width()) * f64::from(a.height());
    (sum / 3.0 / pixels, far / pixels)
}

#[test]
#[ignore = "needs a renderer and written figures: .ci/run gives both"]
fn every_svg_drawn_by_another_program_is_the_picture_of_the_png() {
    let renderer = env::var("OMBRA_RENDERER").unwrap();
    let folder = root().join(env::var("OMBRA_RENDERED").unwrap());
    let folder = folder.canonicalize().unwrap();
    let mut files = Vec::new();
    svgs(&folder, &mut files);
    assert!(!files.is_empty(), "no SVG in {}", folder.display());
    let theirs = folder.join("rendered.png");
    let mut wrong = Vec::new();
    for file in &files {
        let ours = image::open(file.with_extension("png")).unwrap().to_rgba8();
        // A picture of the last file is none of this one.
        let _ = fs::remove_file(&theirs);
        render(&renderer, file, &theirs, ours.width(), ours.height());
        let (mean, far) = apart(&ours, &image::open(&theirs).unwrap().to_rgba8());
        println!("{}: mean {mean:.3}, far {far:.4}", file.display());
        if !(mean <= MEAN && far <= FAR) {
            wrong.push(format!("{}: mean {mean:.3}, far {far:.4}", file.display()));
        }
    }
    let _ = fs::remove_file(&theirs);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
