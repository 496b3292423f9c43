//! The table of bounds, from the sources.

use std::fmt::Write as _;

use ombra_tests::sources::Item;

use super::measured::{CASES, MEASURED, worst};
use super::shares;

/// Whether a function answers numbers that can be wrong.
pub fn answers_doubles(item: &Item) -> bool {
    const NUMBERS: [&str; 11] = [
        "f64",
        "DVec",
        "DMat",
        "Segment",
        "Plane",
        "Spherical",
        "DoubleDouble",
        "SightLine",
        "Ellipse",
        "Vertex<",
        "Hit",
    ];
    let of_type = item.path.rsplit("::").nth(1).unwrap_or_default();
    let is_twin = item.path.contains("::counted") || item.path.ends_with("_counted");
    let own =
        item.answer.contains("Self") && ["Plane", "Spherical", "DoubleDouble"].contains(&of_type);
    // Its numbers are private; its distances tell them.
    let answer = item.answer.replace("CutPlane", "");
    item.kind == "fn" && !is_twin && (own || NUMBERS.iter().any(|number| answer.contains(number)))
}

/// The bound that the documentation states, on one line.
pub fn stated(item: &Item) -> Option<String> {
    let mut lines = item
        .docs
        .iter()
        .skip_while(|line| !line.starts_with("- Error:"));
    let mut bound = lines
        .next()?
        .trim_start_matches("- Error:")
        .trim()
        .to_owned();
    for line in lines.take_while(|line| line.starts_with("  ")) {
        bound.push(' ');
        bound.push_str(line.trim());
    }
    Some(without_links(bound.trim_end_matches('.')))
}

/// Links of the documentation lead nowhere from the notes: `[text](target)` and `[text]` as text.
fn without_links(bound: &str) -> String {
    let mut parts = bound.split("[`");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("`]").unwrap_or((part, ""));
        let rest = match rest.strip_prefix("(super::") {
            Some(target) => target.split_once(')').map_or("", |(_, rest)| rest),
            None => rest,
        };
        let _ = write!(text, "`{name}`{rest}");
    }
    text
}

/// The worst that was found, in words. The form of the slide answers what its operation does.
fn found(item: &Item) -> Option<String> {
    let paths = || [&item.path].into_iter().chain(&item.also);
    let operations = || paths().filter_map(|path| path.strip_suffix("_plain"));
    paths()
        .find_map(|path| found_for(path))
        .or_else(|| operations().find_map(found_for))
}

fn found_for(path: &str) -> Option<String> {
    if let Some(measured) = MEASURED.iter().find(|measured| measured.path == path) {
        return Some(format!("{:.2} ε · {}", worst(measured), measured.unit));
    }
    let own = || shares().iter().filter(|share| share.path == path);
    own().next()?;
    Some(
        match own().filter_map(|share| share.of_bound).reduce(f64::max) {
            Some(0.0) => "exact".to_owned(),
            Some(share) if share < 0.01 => "under 1 % of the bound".to_owned(),
            Some(share) => format!("{:.0} % of the bound", 100.0 * share),
            None => "the nearest double".to_owned(),
        },
    )
}

/// The table, as Markdown.
pub fn table(items: &[Item]) -> String {
    let mut text = format!(
        "\
# Error bounds

What each function promises of its error, as its documentation states it, and the worst that was found against exact
fractions: over {CASES} random cases in units of ε, with coordinates from 2⁻²⁰ to 2²⁰ of both signs and a third of the
cases next to a degenerate one; over some hundreds of its own as a share of the bound. ε = 2⁻⁵²; “none” means that the
answer is exact or the double nearest to it, which is within ½ ε of itself, and “the nearest double” that no case was
found in which another one was nearer. A dash: not measured here; the function's own tests are. The form of the slide,
`…_plain`, has the numbers of its operation, which it equals by test. `tests/tests/error_bounds` writes this table and
fails if it is not current.
"
    );
    let mut krate = "";
    for item in items.iter().filter(|item| answers_doubles(item)) {
        let Some(bound) = stated(item) else { continue };
        let (own, path) = item.path.split_once("::").unwrap_or(("", &item.path));
        if own != krate {
            krate = own;
            let _ = write!(
                text,
                "\n## {krate}\n\n| function | bound | worst found |\n| --- | --- | --- |\n"
            );
        }
        let found = found(item).unwrap_or("–".to_owned()).replace('|', "\\|");
        let _ = writeln!(
            text,
            "| `{path}` | {} | {found} |",
            bound.replace('|', "\\|")
        );
    }
    text
}
