//! The README's topic index against the sources: every public module of a lecture is in it, and what it names
//! exists.
#![allow(clippy::panic, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::slice::from_ref;

use ombra_tests::topic_index::{Row, included_figures, parse, public_modules};

/// The crates that are tools: every other one is a lecture.
const TOOLS: [&str; 4] = ["figures", "oracle", "trade", "ombra"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The crates that are lectures, by folder.
fn lectures() -> Vec<String> {
    let folders = fs::read_dir(root().join("crates"))
        .into_iter()
        .flatten()
        .flatten();
    let mut names: Vec<String> = folders
        .map(|folder| folder.file_name().to_string_lossy().into_owned())
        .filter(|name| !TOOLS.contains(&name.as_str()))
        .collect();
    names.sort();
    names
}

/// What exists, as read from the sources.
struct Existing {
    /// A public module, and the pictures its page shows.
    modules: Vec<(String, Vec<String>)>,
    /// Those that lie in files of their own below another: the index may name them.
    children: Vec<(String, Vec<String>)>,
    figures: BTreeSet<String>,
    exercises: BTreeSet<String>,
    studies: BTreeSet<String>,
}

/// Everything that is wrong with the index, a sentence each.
fn complaints(rows: &[Row], existing: &Existing) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut named_modules = BTreeSet::new();
    for row in rows {
        let modules = existing.modules.iter().chain(&existing.children);
        let modules: BTreeSet<&String> = modules.map(|(name, _)| name).collect();
        for name in &row.modules {
            named_modules.insert(name.as_str());
            if !modules.contains(name) {
                complaints.push(format!("{}: there is no public module {name}", row.topic));
            }
        }
        let columns = [
            ("figure", &row.figures, &existing.figures),
            ("exercise", &row.exercises, &existing.exercises),
            ("study", &row.studies, &existing.studies),
        ];
        for (kind, names, known) in columns {
            for name in names.iter().filter(|name| !known.contains(*name)) {
                complaints.push(format!("{}: there is no {kind} {name}", row.topic));
            }
        }
    }
    for (module, _) in &existing.modules {
        if !named_modules.contains(module.as_str()) {
            complaints.push(format!("the index lacks the module {module}"));
        }
    }
    for (module, pictures) in existing.modules.iter().chain(&existing.children) {
        if !named_modules.contains(module.as_str()) {
            continue;
        }
        // The page's picture is one of the figures that the index lists for the module, and there is one if any is.
        let of_module = rows.iter().filter(|row| row.modules.contains(module));
        let listed: BTreeSet<&String> = of_module.flat_map(|row| &row.figures).collect();
        let shown = |id: &str| {
            pictures
                .iter()
                .any(|name| id.ends_with(&format!("/{name}")))
        };
        if !listed.is_empty() && !listed.iter().any(|id| shown(id)) {
            complaints.push(format!(
                "the page of {module} shows none of the figures listed for it"
            ));
        }
        for name in pictures {
            if !listed.iter().any(|id| id.ends_with(&format!("/{name}"))) {
                complaints.push(format!(
                    "the index does not list {name}.svg, which {module} shows"
                ));
            }
        }
    }
    let listed =
        |of: fn(&Row) -> &Vec<String>| -> BTreeSet<&String> { rows.iter().flat_map(of).collect() };
    let totals = [
        ("figure", listed(|row| &row.figures), &existing.figures),
        (
            "exercise",
            listed(|row| &row.exercises),
            &existing.exercises,
        ),
        ("study", listed(|row| &row.studies), &existing.studies),
    ];
    for (kind, named, known) in totals {
        for name in known.iter().filter(|name| !named.contains(name)) {
            complaints.push(format!("the index lacks the {kind} {name}"));
        }
    }
    complaints
}

fn existing() -> Existing {
    let (mut modules, mut children) = (Vec::new(), Vec::new());
    for lecture in lectures() {
        let source = root().join("crates").join(&lecture).join("src");
        for module in public_modules(&read(source.join("lib.rs"))) {
            let file = [format!("{module}.rs"), format!("{module}/mod.rs")]
                .into_iter()
                .find(|file| source.join(file).is_file())
                .unwrap_or_else(|| panic!("no source of {lecture}::{module}"));
            let text = read(source.join(file));
            for child in public_modules(&text) {
                let file = source.join(&module).join(format!("{child}.rs"));
                if file.is_file() {
                    let pictures = included_figures(&read(file));
                    children.push((format!("ombra_{lecture}::{module}::{child}"), pictures));
                }
            }
            modules.push((
                format!("ombra_{lecture}::{module}"),
                included_figures(&text),
            ));
        }
    }
    let quoted = |line: &str| {
        Some(
            line.strip_prefix("name = \"")?
                .strip_suffix('"')?
                .to_owned(),
        )
    };
    Existing {
        modules,
        children,
        figures: ombra_figures::course::figures()
            .iter()
            .map(|f| f.id.to_owned())
            .collect(),
        exercises: read("exercises/info.toml")
            .lines()
            .filter_map(quoted)
            .collect(),
        studies: ombra_trade::studies()
            .iter()
            .map(|study| study.id.to_owned())
            .collect(),
    }
}

#[test]
fn the_index_and_the_sources_agree() {
    let rows = parse(&read("README.md")).unwrap();
    let complaints = complaints(&rows, &existing());
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn the_sources_are_found() {
    let existing = existing();
    for module in [
        "ombra_math::plane",
        "ombra_clip::sutherland_hodgman",
        "ombra_shadows::planar",
    ] {
        assert!(
            existing.modules.iter().any(|(name, _)| name == module),
            "{module}"
        );
    }
    assert!(existing.figures.contains("shadows/cube-infinity"));
    assert!(existing.exercises.contains("math1_triangle_normal"));
    assert!(existing.studies.contains("planar-precision"));
}

/// An index that agrees with its sources, made disagree in one way each.
#[test]
fn every_disagreement_is_a_sentence() {
    let set = |names: &[&str]| {
        names
            .iter()
            .map(|&name| name.to_owned())
            .collect::<BTreeSet<_>>()
    };
    let list = |names: &[&str]| {
        names
            .iter()
            .map(|&name| name.to_owned())
            .collect::<Vec<_>>()
    };
    let existing = |modules: &[(&str, &[&str])], exercises: &[&str]| Existing {
        modules: modules
            .iter()
            .map(|(name, pictures)| (name.to_string(), list(pictures)))
            .collect(),
        children: vec![("ombra_math::plane::side".into(), list(&["side"]))],
        figures: set(&["math/plane"]),
        exercises: set(exercises),
        studies: set(&["precision"]),
    };
    let row = |modules: &[&str], figures: &[&str], exercises: &[&str], studies: &[&str]| Row {
        topic: "planes".into(),
        deck: "Bologna".into(),
        modules: list(modules),
        figures: list(figures),
        exercises: list(exercises),
        studies: list(studies),
    };
    let good = row(
        &["ombra_math::plane"],
        &["math/plane"],
        &["math1"],
        &["precision"],
    );
    let shown: &[(&str, &[&str])] = &[("ombra_math::plane", &["plane"])];
    let sources = existing(shown, &["math1"]);
    assert_eq!(complaints(from_ref(&good), &sources), [""; 0]);

    let says = |rows: &[Row], sources: &Existing, sentence: &str| {
        let complaints = complaints(rows, sources);
        assert!(complaints.iter().any(|c| c == sentence), "{complaints:?}");
    };
    let more = existing(&[shown[0], ("ombra_math::view", &[])], &["math1", "math2"]);
    says(
        from_ref(&good),
        &more,
        "the index lacks the module ombra_math::view",
    );
    says(from_ref(&good), &more, "the index lacks the exercise math2");
    let named = |modules: &[&str], figures: &[&str], exercises: &[&str], studies: &[&str]| {
        [good.clone(), row(modules, figures, exercises, studies)]
    };
    says(
        &named(&["ombra_math::gone"], &[], &[], &[]),
        &sources,
        "planes: there is no public module ombra_math::gone",
    );
    says(
        &named(&["ombra_math::plane::gone"], &[], &[], &[]),
        &sources,
        "planes: there is no public module ombra_math::plane::gone",
    );
    // A module below another may be named, and then its picture must be listed.
    let below = complaints(
        &named(&["ombra_math::plane::side"], &[], &[], &[]),
        &sources,
    );
    assert_eq!(
        below,
        ["the index does not list side.svg, which ombra_math::plane::side shows"]
    );
    says(
        &named(&[], &["math/gone"], &[], &[]),
        &sources,
        "planes: there is no figure math/gone",
    );
    says(
        &named(&[], &[], &["math9"], &[]),
        &sources,
        "planes: there is no exercise math9",
    );
    says(
        &named(&[], &[], &[], &["gone"]),
        &sources,
        "planes: there is no study gone",
    );
    let bare = existing(&[("ombra_math::plane", &[])], &["math1"]);
    says(
        from_ref(&good),
        &bare,
        "the page of ombra_math::plane shows none of the figures listed for it",
    );
    let other = existing(&[("ombra_math::plane", &["plane", "other"])], &["math1"]);
    says(
        &[good],
        &other,
        "the index does not list other.svg, which ombra_math::plane shows",
    );
    let unlisted = [row(&["ombra_math::plane"], &[], &["math1"], &["precision"])];
    says(&unlisted, &sources, "the index lacks the figure math/plane");
}
