//! The README's table of topics, taken apart: which module, figure, exercise and study teaches what.
//!
//! ```text
//! | topic | deck | module | figure | exercise | study |
//! | --- | --- | --- | --- | --- | --- |
//! | plane | Bologna | `ombra_math::plane` | `math/plane` | – | – |
//! ```
//!
//! Names stand in backticks, several in a cell are told apart by commas, and a cell without a name holds a dash.

/// One row of the table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The topic, in words.
    pub topic: String,
    /// The decks that teach it.
    pub deck: String,
    /// Paths of modules, such as `ombra_math::plane`.
    pub modules: Vec<String>,
    /// Identifiers of figures, such as `shadows/why`.
    pub figures: Vec<String>,
    /// Names of exercises, such as `math1_triangle_normal`.
    pub exercises: Vec<String>,
    /// Identifiers of studies, such as `planar-precision`.
    pub studies: Vec<String>,
}

const HEADER: [&str; 6] = ["topic", "deck", "module", "figure", "exercise", "study"];

/// The rows of the table of topics in `markdown`.
///
/// # Errors
///
/// A sentence when there is no such table, when there are two, when a row has another number of cells, no topic,
/// or a cell that is neither names in backticks nor a dash.
pub fn parse(markdown: &str) -> Result<Vec<Row>, String> {
    let lines: Vec<&str> = markdown.lines().collect();
    let is_header = |line: &&str| cells(line).is_some_and(|cells| cells.iter().eq(HEADER.iter()));
    let mut headers = lines.iter().enumerate().filter(|(_, line)| is_header(line));
    let (start, _) = headers
        .next()
        .ok_or_else(|| format!("no table with the columns {}", HEADER.join(" | ")))?;
    if headers.next().is_some() {
        return Err("two tables of topics: one place for each thing".into());
    }
    let mut table = lines.iter().skip(start + 1).map_while(|line| cells(line));
    let rule = table.next().unwrap_or_default();
    if rule.len() != HEADER.len() || !rule.iter().all(|cell| cell.contains("---")) {
        return Err("the line below the header is not | --- | for every column".into());
    }
    table.map(|cells| row(&cells)).collect()
}

/// The trimmed cells of a line of a table, or `None` if it is none.
fn cells(line: &str) -> Option<Vec<String>> {
    let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    // An escaped bar is a character of its cell.
    let inner = inner.replace("\\|", "\u{0}");
    Some(
        inner
            .split('|')
            .map(|cell| cell.trim().replace('\u{0}', "|"))
            .collect(),
    )
}

fn row(cells: &[String]) -> Result<Row, String> {
    let [topic, deck, module, figure, exercise, study] = cells else {
        return Err(format!(
            "{} cells instead of {}: {}",
            cells.len(),
            HEADER.len(),
            cells.join(" | ")
        ));
    };
    if topic.is_empty() || deck.is_empty() {
        return Err(format!(
            "a row without topic or deck: {}",
            cells.join(" | ")
        ));
    }
    let named = |column: &str, cell: &str| {
        names(cell).map_err(|rest| {
            format!("{topic}, {column}: \"{rest}\" is neither a name in backticks nor a dash")
        })
    };
    Ok(Row {
        topic: topic.clone(),
        deck: deck.clone(),
        modules: named("module", module)?,
        figures: named("figure", figure)?,
        exercises: named("exercise", exercise)?,
        studies: named("study", study)?,
    })
}

/// The names in backticks in a cell, whether linked or not; what else stands there is an error.
fn names(cell: &str) -> Result<Vec<String>, String> {
    if ["–", "—", "-"].contains(&cell) {
        return Ok(Vec::new());
    }
    let mut names = Vec::new();
    for part in cell.split([',', '·']).map(str::trim) {
        // [`name`](target) is a name with a link.
        let part = match part
            .strip_prefix('[')
            .and_then(|part| part.split_once("]("))
        {
            Some((text, target)) if target.ends_with(')') => text,
            _ => part,
        };
        let name = part
            .strip_prefix('`')
            .and_then(|part| part.strip_suffix('`'))
            .filter(|name| !name.is_empty() && !name.contains('`'))
            .ok_or_else(|| part.to_owned())?;
        names.push(name.to_owned());
    }
    Ok(names)
}

/// The public modules that a crate's `lib.rs` declares, in order.
#[must_use]
pub fn public_modules(lib_rs: &str) -> Vec<String> {
    lib_rs
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod "))
        .filter_map(|rest| rest.split([';', ' ', '{']).next())
        .map(str::to_owned)
        .collect()
}

/// The pictures that a module's own documentation includes: their names without folder and ending.
#[must_use]
pub fn included_figures(module: &str) -> Vec<String> {
    module
        .lines()
        .filter(|line| {
            line.starts_with("#![cfg_attr(doc, doc = include_str!(")
                || line.starts_with("#![doc = include_str!(")
        })
        .filter_map(|line| line.split_once("../figures/")?.1.split_once(".svg"))
        .map(|(name, _)| name.to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{included_figures, parse, public_modules};

    const TABLE: &str = "\
# Ombra

| other | table |
| --- | --- |
| a | b |

| topic | deck | module | figure | exercise | study |
| --- | --- | --- | --- | --- | --- |
| plane \\| side | Bologna | `ombra_math::plane` | [`math/plane`](a.svg) | – | - |
| any plane | Olomouc, Bologna | `ombra_shadows::planar` | `shadows/a`, `shadows/b` | `shadows3_any_plane` | `planar-precision` |

After.
";

    #[test]
    fn takes_the_table_apart() {
        let rows = parse(TABLE).unwrap();
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].topic, "plane | side");
        assert_eq!(rows[0].modules, ["ombra_math::plane"]);
        assert_eq!(rows[0].figures, ["math/plane"]);
        assert!(rows[0].exercises.is_empty() && rows[0].studies.is_empty());
        assert_eq!(rows[1].deck, "Olomouc, Bologna");
        assert_eq!(rows[1].figures, ["shadows/a", "shadows/b"]);
        assert_eq!(rows[1].exercises, ["shadows3_any_plane"]);
        assert_eq!(rows[1].studies, ["planar-precision"]);
    }

    #[test]
    fn says_what_is_wrong_with_a_table() {
        let with = |from: &str, to: &str| parse(&TABLE.replace(from, to)).unwrap_err();
        assert!(parse("# Ombra").unwrap_err().contains("no table"));
        assert!(parse(&TABLE.repeat(2)).unwrap_err().contains("two tables"));
        assert!(with("| – | - |", "| – |").contains("5 cells instead of 6"));
        assert!(with("`ombra_math::plane`", "ombra_math::plane").contains("module"));
        assert!(with("`shadows/a`, ", "`shadows/a` and ").contains("figure"));
        assert!(with("| – | - |", "| | - |").contains("exercise"));
        assert!(with("| plane \\| side |", "| |").contains("without topic"));
        let rule = "| --- | --- | --- | --- | --- | --- |\n";
        assert!(with(rule, "").contains("below the header"));
    }

    #[test]
    fn reads_sources() {
        let lib = "pub use glam;\n\npub mod plane;\nmod hidden;\npub mod work;\n// pub mod no;\n";
        assert_eq!(public_modules(lib), ["plane", "work"]);
        let module = "//! Planes.\n#![cfg_attr(doc, doc = \"\")]\n\
            #![cfg_attr(doc, doc = include_str!(\"../figures/plane.svg\"))]\n";
        assert_eq!(included_figures(module), ["plane"]);
        assert!(
            included_figures("//! No picture: ../figures/plane.svg is elsewhere.\n").is_empty()
        );
    }
}
