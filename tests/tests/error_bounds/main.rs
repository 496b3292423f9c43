//! What each function that answers a double promises of its error, and the worst that was found: the table
//! `notes/src/error-bounds.md`, made from the line `- Error: …` of each function's documentation and from exact
//! fractions.
//!
//! ```sh
//! cargo test -p ombra-tests --test error_bounds -- --ignored     # writes the table anew
//! ```
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test that cannot go on fails"
)]

mod cameras;
mod clip;
mod hsr;
mod math;
mod measured;
mod numbers;
mod raster;
mod shadows;
mod share;
mod table;
#[path = "../../../crates/math/tests/to_300_bits/mod.rs"]
mod to_300_bits;

use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::thread;

use measured::{MEASURED, Measured, worst};
use ombra_tests::sources::{public_items, root};
use share::Share;
use table::{answers_doubles, stated, table};

/// What is measured as a share of its bound.
fn shares() -> &'static [Share] {
    static SHARES: OnceLock<Vec<Share>> = OnceLock::new();
    SHARES.get_or_init(|| {
        let checks = [
            cameras::shares,
            math::shares,
            numbers::shares,
            raster::shares,
            clip::shares,
            hsr::shares,
            shadows::shares,
        ];
        thread::scope(|scope| {
            let running = checks.map(|check| {
                scope.spawn(move || {
                    let t = std::time::Instant::now();
                    let r = check();
                    eprintln!("T {:?} {:?}", r[0].path, t.elapsed());
                    r
                })
            });
            running.map(|check| check.join().unwrap()).concat()
        })
    })
}

fn file() -> PathBuf {
    root().join("notes/src/error-bounds.md")
}

#[test]
fn every_function_that_answers_doubles_states_its_error() {
    let items = public_items();
    let silent = items
        .iter()
        .filter(|item| answers_doubles(item) && stated(item).is_none());
    let silent: Vec<String> = silent
        .map(|item| format!("{} -> {}", item.path, item.answer))
        .collect();
    assert!(
        silent.is_empty(),
        "no line \"- Error: …\":\n{}",
        silent.join("\n")
    );
}

#[test]
fn no_bound_is_exceeded() {
    let items = public_items();
    let mut complaints = Vec::new();
    for measured in MEASURED {
        let Measured {
            path, unit, most, ..
        } = measured;
        if !items.iter().any(|item| item.is_at(path)) {
            complaints.push(format!("there is no {path}"));
        }
        let worst = worst(measured);
        if !(worst > 0.0 && worst <= *most) {
            complaints.push(format!("{path}: {worst} ε · {unit}, the bound is {most}"));
        }
    }
    for Share { path, of_bound } in shares() {
        if !items.iter().any(|item| item.is_at(path)) {
            complaints.push(format!("there is no {path}"));
        }
        if of_bound.is_some_and(|share| !(0.0..=1.0).contains(&share)) {
            complaints.push(format!("{path}: {of_bound:?} of the bound"));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn the_table_is_current() {
    let committed = fs::read_to_string(file()).unwrap_or_default();
    assert!(
        committed == table(&public_items()),
        "cargo test -p ombra-tests --test error_bounds -- --ignored, and commit notes/src/error-bounds.md"
    );
}

#[test]
#[ignore = "writes the table"]
fn write_the_table() {
    fs::write(file(), table(&public_items())).unwrap();
}
