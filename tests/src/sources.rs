//! What a crate offers, read from its sources: the public functions, types, constants and modules, with their
//! documentation and the words they are also found by.
//!
//! Not a parser: it relies on the layout that `cargo fmt` gives, and follows `pub use` inside the crate.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// One public thing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Item {
    /// Its public path, such as `ombra_math::view::look_at` or `ombra_math::plane::Plane::side`.
    pub path: String,
    /// Its other public paths, by re-export.
    pub also: Vec<String>,
    /// What introduces it: `fn`, `struct`, `enum`, `mod`, `variant` …
    pub kind: String,
    /// Lines of its documentation, without the slashes.
    pub docs: Vec<String>,
    /// The words of `#[doc(alias = "…")]` directly on it.
    pub aliases: Vec<String>,
    /// What a function answers, as it is written; empty for others.
    pub answer: String,
    /// The file that defines it.
    pub file: PathBuf,
}

impl Item {
    /// The last part of the path.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.rsplit("::").next().unwrap_or_default()
    }

    /// Whether `path` is one of its public paths.
    #[must_use]
    pub fn is_at(&self, path: &str) -> bool {
        self.path == path || self.also.iter().any(|also| also == path)
    }
}

/// The root of the repository.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folders of `crates/` that are lectures or what they stand on, sorted: every one but the tools.
#[must_use]
pub fn lectures() -> Vec<String> {
    let tools = ["figures", "trade", "ombra", "oracle"];
    let mut names: Vec<String> = fs::read_dir(root().join("crates"))
        .into_iter()
        .flatten()
        .flatten()
        .map(|folder| folder.file_name().to_string_lossy().into_owned())
        .filter(|name| !tools.contains(&name.as_str()))
        .collect();
    names.sort();
    names
}

/// All files of `folder` and below whose names end in `ending`, sorted.
#[must_use]
pub fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The public items of all lectures, by path.
#[must_use]
pub fn public_items() -> Vec<Item> {
    let mut sources = Vec::new();
    for name in lectures() {
        let folder = root().join("crates").join(&name).join("src");
        for file in files(&folder, ".rs") {
            if let (Ok(inner), Ok(text)) = (file.strip_prefix(&folder), fs::read_to_string(&file)) {
                let module = module_path(&format!("ombra_{name}"), inner);
                sources.push((module, text, file));
            }
        }
    }
    resolve(sources)
}

/// `view/projection.rs` of ombra_math is `ombra_math::view::projection`.
fn module_path(root: &str, file: &Path) -> String {
    let inner = file.with_extension("");
    let parts = inner.iter().map(|part| part.to_string_lossy());
    let parts = parts.filter(|part| part != "lib" && part != "mod");
    parts.fold(root.to_owned(), |path, part| format!("{path}::{part}"))
}

/// Everything that modules, as (path, source, file), make public. A path without `::` is a crate.
fn resolve(sources: impl IntoIterator<Item = (String, String, PathBuf)>) -> Vec<Item> {
    let mut found = Found::default();
    for (module, source, file) in sources {
        found.read(&module, &source, &file);
    }
    // The documentation of a module stands in its file, that of a crate too.
    for file in found.files {
        match found.items.iter_mut().find(|item| item.path == file.path) {
            Some(item) => {
                item.docs = file.docs;
                item.aliases.extend(file.aliases);
                item.file = file.file;
            }
            None if !file.path.contains("::") => found.items.push(file),
            None => {}
        }
    }
    // An impl in a child module is of the type that an outer module defines.
    let types: BTreeSet<String> = found.items.iter().map(|item| item.path.clone()).collect();
    for item in &mut found.items {
        while let Some((of, name)) = item.path.rsplit_once("::")
            && let Some((module, of_type)) = of.rsplit_once("::")
            && of_type.starts_with(char::is_uppercase)
            && !types.contains(of)
            && let Some((outer, _)) = module.rsplit_once("::")
        {
            item.path = format!("{outer}::{of_type}::{name}");
        }
    }
    // Every path under which something can be named, and the definition that it names.
    let mut names: BTreeMap<String, String> = BTreeMap::new();
    for item in &found.items {
        names.insert(item.path.clone(), item.path.clone());
    }
    loop {
        let before = names.len();
        for (module, target, name) in &found.uses {
            // What is re-exported brings its methods and variants along.
            let inner = format!("{target}::");
            let more: Vec<(String, String)> = names
                .iter()
                .filter(|(path, _)| *path == target || path.starts_with(&inner))
                .filter_map(|(path, definition)| {
                    let rest = path.strip_prefix(target.as_str())?;
                    Some((format!("{module}::{name}{rest}"), definition.clone()))
                })
                .collect();
            names.extend(more);
        }
        if names.len() == before {
            break;
        }
    }
    let mut public: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (path, definition) in &names {
        let mut outer = path.as_str();
        while let Some((parent, _)) = outer.rsplit_once("::")
            && names.contains_key(parent)
        {
            outer = parent;
        }
        if !outer.contains("::") {
            public.entry(definition).or_default().push(path);
        }
    }
    let mut items = Vec::new();
    for item in &found.items {
        let Some(paths) = public.get(item.path.as_str()) else {
            continue;
        };
        // Its own path, else the shortest; that of a counted twin last.
        let key = |path: &&&str| (**path != item.path, path.contains("::counted"), path.len());
        let path = paths.iter().min_by_key(key).copied().unwrap_or_default();
        let also = paths.iter().filter(|&&other| other != path);
        items.push(Item {
            path: path.to_owned(),
            also: also.map(|&path| path.to_owned()).collect(),
            ..item.clone()
        });
    }
    items.sort_by(|a, b| a.path.cmp(&b.path));
    items
}

/// Definitions that say `pub`, and re-exports as (module, definition, name).
#[derive(Default)]
struct Found {
    items: Vec<Item>,
    uses: Vec<(String, String, String)>,
    /// Modules with a file of their own: their documentation stands there.
    files: Vec<Item>,
}

/// A module, type, trait or impl whose braces are open.
struct Scope {
    indent: usize,
    path: String,
    kind: &'static str,
}

impl Found {
    fn read(&mut self, module: &str, source: &str, file: &Path) {
        let new = || Item {
            path: module.to_owned(),
            kind: "mod".to_owned(),
            file: file.to_owned(),
            ..Item::default()
        };
        let (mut of_file, mut next) = (new(), new());
        let mut scopes: Vec<Scope> = Vec::new();
        let mut lines = source.lines();
        while let Some(line) = lines.next() {
            let text = line.trim_start();
            let indent = line.len() - text.len();
            if text.starts_with('}') {
                scopes.retain(|scope| scope.indent < indent);
                continue;
            }
            // Documentation and attributes, of the file or of what comes next.
            if let Some(doc) = text.strip_prefix("//!") {
                of_file.docs.push(doc.trim_start().to_owned());
                continue;
            }
            if let Some(doc) = text.strip_prefix("///") {
                next.docs
                    .push(doc.strip_prefix(' ').unwrap_or(doc).to_owned());
                continue;
            }
            if text.starts_with("#[") || text.starts_with("#![") {
                let attribute = until(text, &mut lines, &[']']);
                let target = if text.starts_with("#!") {
                    &mut of_file
                } else {
                    &mut next
                };
                if attribute
                    .trim_start_matches(['#', '!', '['])
                    .starts_with("doc(alias")
                {
                    target
                        .aliases
                        .extend(attribute.split('"').skip(1).step_by(2).map(str::to_owned));
                }
                continue;
            }
            let item = std::mem::replace(&mut next, new());
            // Only what stands directly in the file or in an open scope is an item.
            if indent != scopes.last().map_or(0, |scope| scope.indent + 4) {
                continue;
            }
            let (outer, within) = match scopes.last() {
                Some(scope) => (scope.path.clone(), scope.kind),
                None => (module.to_owned(), "mod"),
            };
            let is_public = text.starts_with("pub ") || within == "trait";
            let head = text.trim_start_matches("pub ").replace("const fn ", "fn ");
            let (kind, rest) = head.split_once(' ').unwrap_or((&head, ""));
            let name = identifier(rest);
            let path = format!("{outer}::{name}");
            let add = |item: Item, kind: &str, path: &str| Item {
                kind: kind.to_owned(),
                path: path.to_owned(),
                ..item
            };
            match kind {
                "use" if is_public => {
                    self.reexport(&outer, &until(rest, &mut lines, &[';']));
                }
                "fn" if is_public => {
                    let answer = answer(&until(rest, &mut lines, &['{', ';', '}']));
                    self.items.push(Item {
                        answer,
                        ..add(item, kind, &path)
                    });
                }
                "struct" | "enum" | "trait" | "mod" | "type" | "const" | "static" => {
                    if is_public {
                        self.items.push(add(item, kind, &path));
                    }
                    let opens = ["struct", "enum", "trait", "mod"]
                        .into_iter()
                        .find(|&k| k == kind);
                    if let Some(kind) = opens
                        && until(rest, &mut lines, &['{', ';', '}']).ends_with('{')
                    {
                        scopes.push(Scope { indent, path, kind });
                    }
                }
                _ if kind.starts_with("impl") => {
                    let header = until(&head, &mut lines, &['{', '}']);
                    if header.ends_with('{') {
                        let path = format!("{outer}::{}", implemented(&header));
                        scopes.push(Scope {
                            indent,
                            path,
                            kind: "impl",
                        });
                    }
                }
                _ if within == "enum" => {
                    let name = identifier(text);
                    self.items
                        .push(add(item, "variant", &format!("{outer}::{name}")));
                }
                _ => {}
            }
        }
        self.files.push(of_file);
    }

    /// Enters `a::{b, c as d}` of `module`.
    fn reexport(&mut self, module: &str, tree: &str) {
        let tree = tree.trim_end_matches(';');
        let (prefix, names) = match tree.split_once('{') {
            Some((prefix, names)) => (prefix, names.trim_end_matches('}')),
            None => ("", tree),
        };
        for name in names
            .split(',')
            .map(str::trim)
            .filter(|name| !name.is_empty())
        {
            let (target, name) = match name.split_once(" as ") {
                Some((target, name)) => (target, name),
                None => (name, name.rsplit("::").next().unwrap_or(name)),
            };
            let target = format!("{prefix}{target}");
            let krate = module.split("::").next().unwrap_or(module);
            let target = match target.split_once("::") {
                Some(("crate", rest)) => format!("{krate}::{rest}"),
                Some(("self", rest)) => format!("{module}::{rest}"),
                Some(("super", rest)) => {
                    let parent = module
                        .rsplit_once("::")
                        .map_or(module, |(parent, _)| parent);
                    format!("{parent}::{rest}")
                }
                Some((other, _)) if other.starts_with("ombra_") => target,
                _ => format!("{module}::{target}"),
            };
            self.uses.push((module.to_owned(), target, name.to_owned()));
        }
    }
}

/// `text` and the lines after it, joined, up to the first that ends in one of `ends`.
fn until<'a>(text: &str, lines: &mut impl Iterator<Item = &'a str>, ends: &[char]) -> String {
    let mut all = text.trim_end().to_owned();
    while !all.ends_with(ends) {
        let Some(line) = lines.next() else { break };
        let line = line.trim();
        // What ends a line of a signature is often a bracket; no space after it, none before its partner.
        if !all.ends_with(['(', '{', '<']) && !line.starts_with([')', '}', '>']) {
            all.push(' ');
        }
        all.push_str(line);
    }
    all
}

/// The identifier that `text` begins with.
fn identifier(text: &str) -> String {
    text.chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect()
}

/// The type that an impl's header names.
fn implemented(header: &str) -> String {
    let rest = header.trim_start_matches("impl");
    let rest = rest.get(generics(rest)..).unwrap_or_default();
    let rest = rest.split_once(" for ").map_or(rest, |(_, of)| of);
    identifier(rest.trim_start())
}

/// The length of the `<…>` that `text` begins with.
fn generics(text: &str) -> usize {
    let mut depth = 0;
    let mut before = ' ';
    for (i, c) in text.char_indices() {
        match c {
            '<' => depth += 1,
            '>' if before != '-' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return if i == 0 { 0 } else { i + 1 };
        }
        before = c;
    }
    0
}

/// The type after the arrow of a function's signature, which begins with its name; empty if there is none.
fn answer(signature: &str) -> String {
    let rest = signature.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
    let rest = rest.get(generics(rest)..).unwrap_or_default();
    let mut depth = 0;
    for (i, c) in rest.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            let after = rest.get(i + 1..).unwrap_or_default().trim();
            let answer = after.strip_prefix("-> ").unwrap_or_default();
            let answer = answer.split(" where ").next().unwrap_or_default();
            return answer
                .trim_end_matches(['{', '}', ';', ' '])
                .trim()
                .to_owned();
        }
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOT: &str = "\
//! A crate.
#![doc(alias = \"house\")]

mod hidden;
pub mod shown;

pub use hidden::{Deep as Low, near};
pub use shown::Side;
pub use glam;
";
    const HIDDEN: &str = "\
pub struct Deep {
    /// A field.
    pub x: f64,
}

impl Deep {
    /// Twice.
    #[must_use]
    pub fn twice(
        &self,
    ) -> f64 {
        if self.x > 0.0 {
            pub fn not_this() {}
        }
    }
}

impl<T: Fn() -> f64> Display for Deep<T> {
    fn fmt(&self) -> Result {}
}

/// Near.
///
/// - Error: none.
#[doc(alias = \"close\")]
#[doc(alias(\"beside\", \"next to\"))]
pub fn near<F: Fn(u8) -> f64>(f: F, g: impl Fn() -> u8) -> Option<f64> {}
pub fn unreachable() -> f64 {}
";
    const SHOWN: &str = "\
//! Shown.
#![doc(alias = \"seen\")]
mod fast;
pub fn operation() {}
pub mod counted {
    pub use super::fast::operation;
}
pub enum Side {
    /// On the left.
    #[doc(alias = \"port\")]
    Left,
    Right(u8),
}
#[cfg(test)]
mod tests {
    pub fn helper() {}
}
";

    fn items() -> Vec<Item> {
        let source = |path: &str, text: &str| (path.to_owned(), text.to_owned(), PathBuf::new());
        resolve([
            source("a", ROOT),
            source("a::hidden", HIDDEN),
            source("a::shown", SHOWN),
            source(
                "a::shown::fast",
                "pub fn operation() -> u8 {}\nimpl Side {\n    pub fn turned() {}\n}\n",
            ),
        ])
    }

    #[test]
    fn public_paths_follow_modules_and_reexports() {
        let items = items();
        let paths: Vec<&str> = items.iter().map(|item| item.path.as_str()).collect();
        assert_eq!(
            paths,
            [
                "a",
                "a::Low",
                "a::Low::twice",
                "a::near",
                "a::shown",
                "a::shown::Side",
                "a::shown::Side::Left",
                "a::shown::Side::Right",
                "a::shown::Side::turned",
                "a::shown::counted",
                "a::shown::counted::operation",
                "a::shown::operation",
            ]
        );
    }

    #[test]
    fn documentation_aliases_and_answers() {
        let items = items();
        let item = |path: &str| items.iter().find(|item| item.path == path).unwrap();
        assert_eq!(item("a::shown::Side::Left").also, ["a::Side::Left"]);
        assert_eq!(item("a").aliases, ["house"]);
        assert_eq!(item("a::shown").aliases, ["seen"]);
        assert_eq!(item("a::shown").docs, ["Shown."]);
        let near = item("a::near");
        assert_eq!(near.aliases, ["close", "beside", "next to"]);
        assert_eq!(near.docs, ["Near.", "", "- Error: none."]);
        assert_eq!(near.answer, "Option<f64>");
        assert_eq!(item("a::Low::twice").answer, "f64");
        assert_eq!(item("a::shown::operation").answer, "");
        assert_eq!(item("a::shown::Side::Left").aliases, ["port"]);
        assert!(item("a::shown::Side::Right").aliases.is_empty());
    }
}
