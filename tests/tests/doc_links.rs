//! No link of the documentation that `cargo doc --workspace` has written leads nowhere.
//!
//! ```sh
//! cargo doc --workspace && cargo test -p ombra-tests --test doc_links -- --ignored
//! ```
#![allow(clippy::panic, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::path::{Component, Path, PathBuf};

use ombra_tests::sources::{files, root};

/// Stands among the places of a page that only sends on to another.
const ELSEWHERE: &str = "*";

/// Where cargo writes documentation.
fn documentation() -> PathBuf {
    let target =
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    target.join("doc")
}

/// What stands between quotes after each `before`.
fn attributes<'a>(html: &'a str, before: &'a str) -> impl Iterator<Item = &'a str> {
    html.split(before)
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
}

/// `path` without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut path, part| {
        match part {
            Component::ParentDir => {
                path.pop();
            }
            Component::CurDir => {}
            part => path.push(part),
        }
        path
    })
}

/// The links of `html`, at `page`, that no file and no place in a file answers.
fn dead_links(
    page: &Path,
    html: &str,
    places: &mut impl FnMut(&Path) -> Option<BTreeSet<String>>,
) -> Vec<String> {
    let links: BTreeSet<&str> = attributes(html, " href=\"")
        .chain(attributes(html, " src=\""))
        .collect();
    let dead = |link: &&str| {
        let (file, place) = link.split_once('#').unwrap_or((link, ""));
        if ["http:", "https:", "data:"]
            .iter()
            .any(|scheme| file.starts_with(scheme))
        {
            return false;
        }
        let target = match file.split('?').next() {
            None | Some("") => page.to_owned(),
            Some(file) => plain(&page.parent().unwrap_or(page).join(file)),
        };
        // The lines of a source page get their numbers in the browser.
        let is_source = target.components().any(|part| part.as_os_str() == "src");
        match places(&target) {
            None => true,
            Some(places) => {
                let goes_on = is_source || places.contains(ELSEWHERE);
                !place.is_empty() && !goes_on && !places.contains(place)
            }
        }
    };
    links
        .into_iter()
        .filter(dead)
        .map(|link| format!("{}: {link}", page.display()))
        .collect()
}

#[test]
#[ignore = "after cargo doc --workspace, as .ci/run does"]
fn no_link_of_the_documentation_is_dead() {
    let folder = plain(&documentation());
    let mut known: BTreeMap<PathBuf, Option<BTreeSet<String>>> = BTreeMap::new();
    let mut places = |file: &Path| {
        let read = || {
            let bytes = fs::read(file).ok()?;
            let html = String::from_utf8_lossy(&bytes);
            if html.contains("http-equiv=\"refresh\"") {
                return Some(BTreeSet::from([ELSEWHERE.to_owned()]));
            }
            Some(attributes(&html, " id=\"").map(str::to_owned).collect())
        };
        known.entry(file.to_owned()).or_insert_with(read).clone()
    };
    let (mut pages, mut complaints) = (0, Vec::new());
    for krate in fs::read_dir(&folder).into_iter().flatten().flatten() {
        if !krate.file_name().to_string_lossy().starts_with("ombra") {
            continue;
        }
        for page in files(&krate.path(), ".html") {
            let html =
                fs::read_to_string(&page).unwrap_or_else(|e| panic!("{}: {e}", page.display()));
            complaints.extend(dead_links(&page, &html, &mut places));
            pages += 1;
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(
        pages > 300,
        "{pages} pages in {}: cargo doc --workspace first",
        folder.display()
    );
}

#[test]
fn dead_links_are_found() {
    let html = "<a href=\"../b/c.html#here\">x</a><a class=\"y\" href=\"../b/c.html#there\">x</a>\
        <a href=\"gone.html\">x</a><a href=\"https://a.b/c\">x</a><a href=\"#own\">x</a><a href=\"crate::view\">x</a>\
        <a href=\"../src/b.html#4\">x</a>";
    let mut places = |file: &Path| match file.to_str()? {
        "doc/b/c.html" => Some(BTreeSet::from(["here".to_owned()])),
        "doc/a/index.html" => Some(BTreeSet::from(["own".to_owned()])),
        "doc/src/b.html" => Some(BTreeSet::new()),
        _ => None,
    };
    let page = Path::new("doc/a/index.html");
    let dead = ["../b/c.html#there", "crate::view", "gone.html"];
    assert_eq!(
        dead_links(page, html, &mut places),
        dead.map(|link| format!("doc/a/index.html: {link}"))
    );
}
