//! The chapters of the notes: every formula is MathML that also reads without its tags, every module, exercise and figure
//! stands in one, and no link is dead.
#![allow(clippy::panic, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use ombra_figures::course::select;
use ombra_figures::input::Inputs;
use ombra_figures::style::{Style, TextForm};
use ombra_math::glam::{DVec3, DVec4, IVec2};
use ombra_math::plane::Plane;
use ombra_raster::bresenham;
use ombra_shadows::planar::cast;
use ombra_tests::sources::{files, lectures, root};
use ombra_tests::topic_index::public_modules;
use roxmltree::{Document, Node};

/// The elements of MathML Core that a formula of the notes may have, and how many children each takes.
const ELEMENTS: [(&str, Option<usize>); 12] = [
    ("math", None),
    ("mrow", None),
    ("mi", Some(0)),
    ("mn", Some(0)),
    ("mo", Some(0)),
    ("mtext", Some(0)),
    ("mspace", Some(0)),
    ("mfrac", Some(2)),
    ("msub", Some(2)),
    ("msup", Some(2)),
    ("msubsup", Some(3)),
    ("msqrt", None),
];

/// The attributes of MathML Core that they may have.
const ATTRIBUTES: [(&str, &str); 8] = [
    ("math", "display"),
    ("math", "alttext"),
    ("mi", "mathvariant"),
    ("mo", "form"),
    ("mo", "stretchy"),
    ("mo", "style"),
    ("mspace", "width"),
    ("mfrac", "linethickness"),
];

/// Keeps a token out of the picture and in the text.
const HIDDEN: &str = "display:none";

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn folder() -> PathBuf {
    root().join("notes/src")
}

/// The pages of the notes that people write, by name, with their text.
fn chapters() -> BTreeMap<String, String> {
    let pages = fs::read_dir(folder()).into_iter().flatten().flatten();
    let chapters: BTreeMap<String, String> = pages
        .map(|page| page.path())
        .filter(|page| page.extension().is_some_and(|ending| ending == "md"))
        .map(|page| {
            let name = page.file_name().unwrap_or_default().to_string_lossy();
            (name.into_owned(), read(&page))
        })
        .collect();
    assert!(chapters.len() >= 10, "{} pages found", chapters.len());
    chapters
}

/// The formulas of a page, as they are written.
fn formulas(page: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = page;
    while let Some(start) = rest.find("<math") {
        let formula = &rest[start..];
        let end = formula
            .find("</math>")
            .map_or(formula.len(), |end| end + "</math>".len());
        found.push(&formula[..end]);
        rest = &formula[end..];
    }
    found
}

fn is_hidden(node: Node) -> bool {
    node.attribute("style") == Some(HIDDEN)
}

/// The children that are drawn.
fn drawn<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = Node<'a, 'a>> {
    node.children()
        .filter(|child| child.is_element() && !is_hidden(*child))
}

/// The formula in one line, as `alttext` has it: an index after a `_`, a vector without its weight, no spaces.
fn in_line(node: Node) -> String {
    if node.is_text() {
        return node.text().map(plain_letters).unwrap_or_default();
    }
    let parts: Vec<String> = node
        .children()
        .filter(|child| child.is_element() || child.is_text())
        .map(in_line)
        .collect();
    if matches!(node.tag_name().name(), "msub" | "msubsup") {
        let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        return match parts.split_first() {
            Some((base, index)) => format!("{base}_{}", index.concat()),
            None => String::new(),
        };
    }
    parts.concat()
}

/// Letters without their weight and without spaces.
fn plain_letters(text: &str) -> String {
    let plain = |c: char| match u32::from(c) {
        // Bold italic capitals, small letters, π.
        code @ 0x1d468..=0x1d481 => char::from_u32(code - 0x1d468 + u32::from('A')).unwrap_or(c),
        code @ 0x1d482..=0x1d49b => char::from_u32(code - 0x1d482 + u32::from('a')).unwrap_or(c),
        0x1d745 => 'π',
        _ => c,
    };
    text.chars()
        .filter(|c| !c.is_whitespace())
        .map(plain)
        .collect()
}

/// Whether `node` multiplies what stands beside it: a letter, a number, a bracket that is seen.
fn is_factor(node: Node, bracket: &str) -> bool {
    match node.tag_name().name() {
        "mo" => !is_hidden(node) && node.text() == Some(bracket),
        name => name != "mspace",
    }
}

/// Everything that is wrong with one formula, a sentence each.
fn faults(formula: &str) -> Vec<String> {
    let document = match Document::parse(formula) {
        Ok(document) => document,
        Err(error) => return vec![format!("is no XML: {error}")],
    };
    let mut faults = Vec::new();
    let math = document.root_element();
    for node in math.descendants() {
        if node.is_comment() {
            faults.push("has a comment".to_owned());
        }
        if !node.is_element() {
            continue;
        }
        let name = node.tag_name().name();
        let Some((_, takes)) = ELEMENTS.iter().find(|(known, _)| *known == name) else {
            faults.push(format!(
                "<{name}> is not among the elements of MathML Core that the notes use"
            ));
            continue;
        };
        let children = drawn(node).count();
        if takes.is_some_and(|takes| takes != children) {
            faults.push(format!("<{name}> has {children} children"));
        }
        for attribute in node.attributes() {
            if !ATTRIBUTES.contains(&(name, attribute.name())) {
                faults.push(format!("<{name}> has the attribute {}", attribute.name()));
            }
        }
        if node.attribute("style").is_some_and(|style| style != HIDDEN) {
            faults.push("a style other than display:none".to_owned());
        }
        let loose =
            |text: Node| text.is_text() && text.text().is_some_and(|t| !t.trim().is_empty());
        let is_token = matches!(name, "mi" | "mn" | "mo" | "mtext");
        if !is_token && node.children().any(loose) {
            faults.push(format!("<{name}> has text outside a token"));
        }
        if name == "mfrac" {
            faults.extend(faults_of_fraction(node));
        }
        if matches!(name, "msup" | "msubsup")
            && !node
                .children()
                .any(|n| is_hidden(n) && n.text() == Some("^"))
        {
            faults.push(
                "without its tags, a power reads like an index: a hidden ^ is missing".to_owned(),
            );
        }
    }
    let line = in_line(math);
    match (math.attribute("display"), math.attribute("alttext")) {
        (Some("block"), None) => {
            faults.push("stands in a line of its own and has no alttext".to_owned())
        }
        (Some("block"), Some(text)) if plain_letters(text) != line => {
            faults.push(format!("its alttext is {text} and it reads {line}"));
        }
        (None, Some(_)) => faults.push("has an alttext inside a sentence".to_owned()),
        (Some("block") | None, _) => {}
        (Some(other), _) => faults.push(format!("display is {other}")),
    }
    if math.attribute("display").is_none() && math.descendants().any(|n| n.has_tag_name("mfrac")) {
        faults.push("a fraction inside a sentence is too small to be read".to_owned());
    }
    faults
}

/// The first of `siblings` after the node itself that is more than a space.
fn neighbour<'a>(siblings: impl Iterator<Item = Node<'a, 'a>>) -> Option<Node<'a, 'a>> {
    siblings
        .skip(1)
        .find(|node| node.is_element() && !node.has_tag_name("mspace"))
}

/// What would be misread where the tags of a fraction are dropped.
fn faults_of_fraction(fraction: Node) -> Vec<String> {
    let mut faults = Vec::new();
    let hidden = |n: &Node, text: &str| is_hidden(*n) && n.text() == Some(text);
    let children: Vec<Node> = fraction.children().filter(Node::is_element).collect();
    if !matches!(children[..], [_, bar, _] if hidden(&bar, "/")) {
        faults.push("a fraction without a hidden / between its parts".to_owned());
    }
    for part in drawn(fraction).filter(|part| part.has_tag_name("mrow")) {
        let tokens: Vec<Node> = part.children().filter(Node::is_element).collect();
        let bracketed = tokens.first().is_some_and(|n| hidden(n, "("))
            && tokens.last().is_some_and(|n| hidden(n, ")"));
        let gaps = part
            .children()
            .any(|n| n.is_text() && n.text().is_some_and(|t| t.contains(' ')));
        if gaps && !bracketed {
            faults.push("a part of a fraction without hidden brackets".to_owned());
        }
    }
    let sides = [
        (neighbour(fraction.prev_siblings()), ")"),
        (neighbour(fraction.next_siblings()), "("),
    ];
    let is_multiplied =
        |(node, bracket): (Option<Node>, &str)| node.is_some_and(|node| is_factor(node, bracket));
    if sides.into_iter().any(is_multiplied) {
        faults.push("a fraction that is a factor without hidden brackets round it".to_owned());
    }
    faults
}

#[test]
fn every_formula_is_mathml_and_reads_without_its_tags() {
    let mut complaints = Vec::new();
    let mut count = 0;
    for (name, page) in chapters() {
        for formula in formulas(&page) {
            count += 1;
            for fault in faults(formula) {
                complaints.push(format!("{name}: {fault}: {formula}"));
            }
        }
        if page.matches("</math>").count() != formulas(&page).len() {
            complaints.push(format!("{name}: a </math> without its <math>"));
        }
        if page.contains("```text") {
            complaints.push(format!("{name}: a formula in a block of text"));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(count > 80, "{count} formulas found");
}

#[test]
fn faults_of_formulas_are_found() {
    let good = "<math display=\"block\" alttext=\"x_1 = (a + b) / 2\">\
        <msub><mi>x</mi><mn>1</mn></msub> <mo>=</mo> \
        <mfrac><mrow><mo style=\"display:none\">(</mo><mi>𝒂</mi> <mo>+</mo> <mi>b</mi><mo style=\"display:none\">)</mo></mrow>\
        <mo style=\"display:none\">/</mo><mn>2</mn></mfrac></math>";
    assert_eq!(faults(good), [""; 0]);
    let power = "<math><msup><mi>z</mi><mo style=\"display:none\">^</mo><mn>2</mn></msup></math>";
    assert_eq!(faults(power), [""; 0]);
    let bar = "<mo style=\"display:none\">/</mo>";
    let bad = [
        (good.replace("</msub>", ""), "is no XML"),
        (good.replace("mfrac", "mover"), "<mover> is not"),
        (good.replace("<mn>1</mn>", ""), "<msub> has 1 children"),
        (
            good.replace("<mn>2</mn>", "<mn mathcolor=\"red\">2</mn>"),
            "the attribute mathcolor",
        ),
        (good.replace("<mn>2</mn>", "2"), "text outside a token"),
        (
            good.replace(" alttext=\"x_1 = (a + b) / 2\"", ""),
            "no alttext",
        ),
        (good.replace("b) / 2", "c) / 2"), "it reads x_1=(a+b)/2"),
        (good.replace("x_1", "x1"), "it reads x_1"),
        (
            good.replace(" display=\"block\"", ""),
            "an alttext inside a sentence",
        ),
        (good.replace(" display=\"block\"", ""), "too small"),
        (good.replace(bar, ""), "without a hidden /"),
        (
            good.replace("<mo style=\"display:none\">(</mo>", ""),
            "part of a fraction",
        ),
        (
            good.replace("</mfrac>", "</mfrac> <mi>c</mi>")
                .replace("/ 2", "/ 2 c"),
            "is a factor",
        ),
        (
            good.replace("<mo>=</mo>", "<mn>3</mn>")
                .replace("x_1 =", "x_1 3"),
            "is a factor",
        ),
        (
            power.replace("<mo style=\"display:none\">^</mo>", ""),
            "reads like an index",
        ),
    ];
    for (formula, sentence) in bad {
        let faults = faults(&formula).join("; ");
        assert!(faults.contains(sentence), "{sentence}: {faults}: {formula}");
    }
}

/// A link of a page: what is clicked and where it leads.
#[derive(Debug, PartialEq, Eq)]
struct Link {
    text: String,
    target: String,
    /// Whether it shows a picture.
    is_picture: bool,
}

/// Where the links of a page lead, and what is wrong with the way they are written.
fn links(page: &str) -> (Vec<Link>, Vec<String>) {
    let (mut found, mut faults) = (Vec::new(), Vec::new());
    // Those with the target beside them: [text](target).
    for (i, _) in page.match_indices("](") {
        let (before, after) = (&page[..i], &page[i + 2..]);
        let (Some(start), Some(end)) = (before.rfind('['), after.find(')')) else {
            faults.push("a link that never ends".to_owned());
            continue;
        };
        found.push(Link {
            text: before[start + 1..].to_owned(),
            target: after[..end].to_owned(),
            is_picture: before[..start].ends_with('!'),
        });
    }
    // Those with the target at the end of the page: [`name`].
    let definitions: BTreeMap<&str, &str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("[`")?.split_once("`]: "))
        .collect();
    let mut used = BTreeSet::new();
    for rest in page.split("[`").skip(1) {
        let Some((name, after)) = rest.split_once("`]") else {
            faults.push("a name that never ends".to_owned());
            continue;
        };
        if after.starts_with([':', '(']) {
            continue;
        }
        match definitions.get(name) {
            Some(target) if used.insert(name) => found.push(Link {
                text: format!("`{name}`"),
                target: (*target).to_owned(),
                is_picture: false,
            }),
            Some(_) => {}
            None => faults.push(format!("{name} is linked and leads nowhere")),
        }
    }
    for name in definitions.keys().filter(|name| !used.contains(*name)) {
        faults.push(format!("{name} has a target and is not linked"));
    }
    (found, faults)
}

/// The places in a page that a link may name: its headings, as a book and GitHub spell them, and its own marks.
fn places(page: &str) -> BTreeSet<String> {
    let heading = |line: &str| {
        let text = line.strip_prefix('#')?.trim_start_matches('#').trim();
        let kept = text
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        Some(kept.collect::<String>().to_lowercase().replace(' ', "-"))
    };
    let marks = page.split("<a id=\"").skip(1);
    let marks = marks.filter_map(|rest| Some(rest.split_once('"')?.0.to_owned()));
    page.lines().filter_map(heading).chain(marks).collect()
}

#[test]
fn links_and_places_are_found() {
    let page =
        "# A b, c\n[x](y.md#z) ![p](q.svg) [`m`], [`m`]\n## D-e\n<a id=\"f\"></a>\n\n[`m`]: n.rs\n";
    let link = |text: &str, target: &str, is_picture| Link {
        text: text.to_owned(),
        target: target.to_owned(),
        is_picture,
    };
    let (found, faults) = links(page);
    let wanted = [
        link("x", "y.md#z", false),
        link("p", "q.svg", true),
        link("`m`", "n.rs", false),
    ];
    assert_eq!(found, wanted);
    assert_eq!(faults, [""; 0]);
    assert_eq!(
        places(page).into_iter().collect::<Vec<_>>(),
        ["a-b-c", "d-e", "f"]
    );
    let (_, faults) = links("[`a`]\n\n[`b`]: c.rs\n");
    assert_eq!(
        faults,
        [
            "a is linked and leads nowhere",
            "b has a target and is not linked"
        ]
    );
}

/// The links of all pages, each with the page it stands on.
fn all_links() -> Vec<(String, Link)> {
    chapters()
        .into_iter()
        .flat_map(|(name, page)| {
            links(&page)
                .0
                .into_iter()
                .map(move |link| (name.clone(), link))
        })
        .collect()
}

/// The files that the pages link by their own name: `bresenham` to `bresenham.rs`.
fn linked_by_name() -> BTreeSet<PathBuf> {
    let is_named = |link: &Link| {
        let name = link.text.trim_matches('`');
        Path::new(&link.target)
            .file_stem()
            .is_some_and(|stem| stem == name)
    };
    all_links()
        .into_iter()
        .filter(|(_, link)| is_named(link))
        .filter_map(|(_, link)| folder().join(link.target).canonicalize().ok())
        .collect()
}

#[test]
fn no_link_of_the_notes_is_dead() {
    let mut complaints = Vec::new();
    for (name, page) in chapters() {
        let (links, faults) = links(&page);
        complaints.extend(faults.iter().map(|fault| format!("{name}: {fault}")));
        for Link {
            text,
            target,
            is_picture,
        } in links
        {
            if target.starts_with("https://") {
                continue;
            }
            let (file, place) = target.split_once('#').unwrap_or((&target, ""));
            let path = if file.is_empty() {
                folder().join(&name)
            } else {
                folder().join(file)
            };
            if !path.exists() || (!place.is_empty() && !places(&read(&path)).contains(place)) {
                complaints.push(format!("{name}: {target} is not there"));
            }
            if file.starts_with("..") && file.ends_with(".md") {
                complaints.push(format!(
                    "{name}: {target} is outside the book, which makes .html of it"
                ));
            }
            if is_picture && text.trim().is_empty() {
                complaints.push(format!(
                    "{name}: {target} is shown without a word for those who cannot see it"
                ));
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn every_page_is_in_the_summary() {
    let (links, _) = links(&chapters()["SUMMARY.md"]);
    for name in chapters().into_keys().filter(|name| name != "SUMMARY.md") {
        assert!(
            links.iter().any(|link| link.target == name),
            "{name} is not in SUMMARY.md"
        );
    }
}

#[test]
fn every_module_is_linked_from_a_chapter() {
    let linked = linked_by_name();
    let (mut count, mut complaints) = (0, Vec::new());
    for lecture in lectures() {
        let source = root().join("crates").join(&lecture).join("src");
        for module in public_modules(&read(&source.join("lib.rs"))) {
            let file = source.join(format!("{module}.rs"));
            // Modules in files of their own below it are topics too; `counted` is none.
            let below = public_modules(&read(&file)).into_iter();
            let below = below.map(|child| source.join(&module).join(format!("{child}.rs")));
            for file in below.filter(|file| file.is_file()).chain([file.clone()]) {
                count += 1;
                if !file.canonicalize().is_ok_and(|file| linked.contains(&file)) {
                    complaints.push(format!("no chapter links {}", file.display()));
                }
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(count >= 45, "{count} modules found");
}

#[test]
fn every_exercise_is_linked_from_a_chapter() {
    let linked = linked_by_name();
    let exercises = files(&root().join("exercises/exercises"), ".rs");
    let named: BTreeSet<String> = read(&root().join("exercises/info.toml"))
        .lines()
        .filter_map(|line| {
            Some(
                line.strip_prefix("name = \"")?
                    .strip_suffix('"')?
                    .to_owned(),
            )
        })
        .collect();
    assert!(named.len() >= 22, "{} exercises found", named.len());
    assert_eq!(named.len(), exercises.len());
    for exercise in exercises {
        let is_linked = exercise
            .canonicalize()
            .is_ok_and(|file| linked.contains(&file));
        assert!(is_linked, "no chapter links {}", exercise.display());
    }
}

#[test]
fn every_figure_stands_in_a_chapter() {
    let shown: BTreeSet<String> = all_links()
        .into_iter()
        .filter(|(_, link)| link.is_picture)
        .map(|(_, link)| link.target)
        .collect();
    let mut complaints = Vec::new();
    let figures = files(&folder().join("figures"), ".svg");
    for figure in &figures {
        let name = figure.file_name().unwrap_or_default().to_string_lossy();
        if !shown.contains(&format!("figures/{name}")) {
            complaints.push(format!("no chapter shows {name}"));
        }
    }
    for lecture in lectures() {
        for figure in files(
            &root().join("crates").join(&lecture).join("figures"),
            ".svg",
        ) {
            let name = figure.file_name().unwrap_or_default().to_string_lossy();
            if !folder().join(format!("figures/{lecture}-{name}")).is_file() {
                complaints.push(format!("the notes have no {lecture}-{name}"));
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(figures.len() >= 34, "{} figures found", figures.len());
}

/// A section of a page: what stands below its heading.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let (_, rest) = page
        .split_once(&format!("\n## {heading}\n"))
        .unwrap_or_else(|| panic!("no section {heading}"));
    rest.split("\n## ").next().unwrap_or(rest)
}

/// What is left of `text` without its tags and spaces.
fn without_tags(text: &str) -> String {
    let outside = text
        .split('<')
        .enumerate()
        .map(|(i, part)| match (i, part.split_once('>')) {
            (0, _) | (_, None) => part,
            (_, Some((_, text))) => text,
        });
    plain_letters(&outside.collect::<String>())
}

/// The lengths that the figure of the similar triangles writes beside their sides are those that its section speaks of.
#[test]
fn the_similar_triangles_are_those_of_the_figure() {
    let style = Style {
        text: TextForm::Text,
        ..Style::default()
    };
    let figures = select(&["shadows/planar-similar-triangles"]).unwrap_or_else(|e| panic!("{e}"));
    let drawing = figures[0]
        .draw(&style, &Inputs::default())
        .unwrap_or_else(|e| panic!("{e}"));
    let figure = ombra_figures::svg::svg(&drawing).unwrap_or_else(|e| panic!("{e}"));
    let figure = without_tags(&figure);
    let page = &chapters()["planar-shadows.md"];
    let section = section(page, "Point light, onto the ground");
    let told: BTreeSet<String> = formulas(section).into_iter().map(without_tags).collect();
    for leg in ["Lx−Px", "Lx−Vx", "Ly−Vy", "Ly"] {
        assert!(figure.contains(leg), "the figure has no {leg}: {figure}");
        assert!(told.contains(leg), "the section has no {leg}: {told:?}");
    }
    assert!(told.contains("(Lx−Px)/(Lx−Vx)=Ly/(Ly−Vy)"), "{told:?}");
    // The numbers.
    let (light, v) = (DVec4::new(16.0, 9.0, 0.0, 1.0), DVec3::new(8.0, 3.0, 0.0));
    assert_eq!(
        cast(Plane::GROUND, light, v),
        Some(DVec3::new(4.0, 0.0, 0.0))
    );
    assert!(
        figure.contains("L=(16,9,0,1)") && figure.contains("V(8,3)") && figure.contains("P(4,0)")
    );
    let legs = [16 - 4, 9, 16 - 8, 9 - 3].map(|leg: i32| leg.to_string());
    let [large_level, large_upright, small_level, small_upright] = legs;
    let sentence = format!("{large_level} and {large_upright}, {small_level} and {small_upright}");
    assert!(section.contains(&sentence), "{sentence}");
    assert!(told.contains("Px=(9·8−16·3)/(9−3)=4"), "{told:?}");
}

/// The decisions of Bresenham's segment in the notes are the doubled ones that the library computes.
#[test]
fn the_notes_double_the_decision() {
    let page = &chapters()["rasterization.md"];
    let section = section(page, "A segment");
    let decisions: Vec<i64> = bresenham::trace(IVec2::ZERO, IVec2::new(8, 3))
        .map(|step| step.decision)
        .collect();
    let mut steps: Vec<i64> = decisions.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_unstable();
    steps.dedup();
    assert_eq!(steps, [-10, 6]);
    let row: Vec<String> = decisions
        .iter()
        .map(|d| d.to_string().replace('-', "−"))
        .collect();
    let words = section.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains(&row.join(", ")), "{}", row.join(", "));
    assert!(words.contains("+6 after E and −10 after NE"));
    let told: BTreeSet<String> = formulas(section).into_iter().map(without_tags).collect();
    for formula in [
        "2F(M)=2dy−dxatthestart",
        "2F≤0E2F←2F+2dy",
        "2F>0NE2F←2F+2dy−2dx",
    ] {
        let formula = formula.replace('>', "&gt;");
        assert!(told.contains(&formula), "{formula}: {told:?}");
    }
}
