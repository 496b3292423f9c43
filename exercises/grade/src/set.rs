//! The set of exercises: what info.toml lists, and where the files of each lie.

use std::fs;
use std::path::{Path, PathBuf};

/// One exercise of the set.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// The name of its files, such as `math1_triangle_normal`.
    pub name: String,
    /// The folder of its topic.
    pub topic: String,
    /// The hints, one text.
    pub hint: String,
    /// The tests that the untouched exercise fails.
    pub fails: Vec<String>,
}

impl Exercise {
    /// `exercises/TOPIC/NAME.rs`, from the folder of the set.
    pub fn path(&self) -> PathBuf {
        self.file_in("exercises")
    }

    /// `solutions/TOPIC/NAME.rs`, from the folder of the set.
    pub fn solution_path(&self) -> PathBuf {
        self.file_in("solutions")
    }

    fn file_in(&self, folder: &str) -> PathBuf {
        Path::new(folder)
            .join(&self.topic)
            .join(format!("{}.rs", self.name))
    }
}

/// The exercises and the manifest that builds them.
#[derive(Debug)]
pub struct Set {
    /// The folder of info.toml.
    pub root: PathBuf,
    /// In the order of info.toml.
    pub exercises: Vec<Exercise>,
    /// The text of Cargo.toml.
    pub manifest: String,
}

impl Set {
    /// Reads info.toml and Cargo.toml of the folder `root`.
    pub fn read(root: &Path) -> Result<Self, String> {
        let info = read_text(&root.join("info.toml"))?;
        let exercises = parse_info(&info)
            .map_err(|why| format!("{}: {why}", root.join("info.toml").display()))?;
        let manifest = read_text(&root.join("Cargo.toml"))?;
        let root = root
            .canonicalize()
            .map_err(|error| format!("cannot find the folder {}: {error}", root.display()))?;
        Ok(Self {
            root,
            exercises,
            manifest,
        })
    }

    /// The folders of the manifest's path dependencies, from the folder of the set.
    pub fn path_dependencies(&self) -> Result<Vec<PathBuf>, String> {
        let manifest: toml::Table = self
            .manifest
            .parse()
            .map_err(|error| format!("Cargo.toml: {error}"))?;
        let dependencies = manifest.get("dependencies").and_then(toml::Value::as_table);
        let paths = dependencies
            .into_iter()
            .flatten()
            .filter_map(|(_, value)| value.get("path")?.as_str());
        Ok(paths.map(PathBuf::from).collect())
    }

    /// The names of the manifest's dependencies, as code names them.
    pub fn dependencies(&self) -> Result<Vec<String>, String> {
        let manifest: toml::Table = self
            .manifest
            .parse()
            .map_err(|error| format!("Cargo.toml: {error}"))?;
        let dependencies = manifest.get("dependencies").and_then(toml::Value::as_table);
        let names = dependencies.into_iter().flatten();
        Ok(names.map(|(name, _)| name.replace('-', "_")).collect())
    }

    /// The `bin` list of Cargo.toml, as rustlings writes it.
    pub fn bins(&self) -> String {
        let mut list = "\n".to_owned();
        for Exercise { name, topic, .. } in &self.exercises {
            list +=
                &format!("  {{ name = \"{name}\", path = \"exercises/{topic}/{name}.rs\" }},\n");
            list += &format!(
                "  {{ name = \"{name}_sol\", path = \"solutions/{topic}/{name}.rs\" }},\n"
            );
        }
        list
    }
}

/// The content of a manifest's list `bin = […]`, between the brackets, and what is before and after it.
pub fn split_bins(manifest: &str) -> Option<[&str; 3]> {
    let (before, rest) = manifest.split_at(manifest.find("bin = [")? + "bin = [".len());
    let (list, after) = rest.split_at(rest.find(']')?);
    Some([before, list, after])
}

/// Reads a text file, with a sentence that names it when that fails.
pub fn read_text(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

fn parse_info(text: &str) -> Result<Vec<Exercise>, String> {
    let info: toml::Table = text.parse().map_err(|error| format!("{error}"))?;
    match info.get("format_version").and_then(toml::Value::as_integer) {
        Some(1) => {}
        Some(other) => return Err(format!("format_version is {other}, but only 1 is known")),
        None => return Err("format_version = 1 is missing".to_owned()),
    }
    let entries = info
        .get("exercises")
        .and_then(toml::Value::as_array)
        .ok_or("it lists no [[exercises]]")?;
    let mut exercises: Vec<Exercise> = Vec::new();
    for entry in entries {
        let exercise = parse_entry(entry)?;
        if exercises.iter().any(|other| other.name == exercise.name) {
            return Err(format!("the exercise {} is listed twice", exercise.name));
        }
        exercises.push(exercise);
    }
    Ok(exercises)
}

fn parse_entry(entry: &toml::Value) -> Result<Exercise, String> {
    let text = |key: &str| {
        entry
            .get(key)
            .and_then(toml::Value::as_str)
            .unwrap_or_default()
            .to_owned()
    };
    let name = text("name");
    // What rustlings allows as a name, and what may stand in a path and as a module.
    let is_name = |name: &str| {
        name.len() <= 32
            && name.starts_with(|c: char| c.is_ascii_lowercase())
            && name
                .chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
    };
    if !is_name(&name) {
        return Err(format!(
            "the name {name:?} is not 1 to 32 lower-case letters, digits and underscores, a letter first"
        ));
    }
    let topic = text("dir");
    if !is_name(&topic) {
        return Err(format!(
            "{name}: dir = {topic:?} is not the name of a topic's folder"
        ));
    }
    let fails = entry.get("fails").and_then(toml::Value::as_array);
    let fails = fails
        .into_iter()
        .flatten()
        .filter_map(toml::Value::as_str)
        .map(str::to_owned)
        .collect();
    Ok(Exercise {
        hint: text("hint"),
        name,
        topic,
        fails,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const INFO: &str = "
        format_version = 1
        [[exercises]]
        name = 'a1_first'
        dir = 'a'
        fails = ['x', 'y']
        hint = '1. 2. 3.'";

    #[test]
    fn info_lists_the_exercises() {
        let [first] = parse_info(INFO).unwrap().try_into().unwrap();
        assert_eq!(
            first.path(),
            Path::new("exercises").join("a").join("a1_first.rs")
        );
        assert_eq!(
            first.solution_path(),
            Path::new("solutions").join("a").join("a1_first.rs")
        );
        assert_eq!((first.fails.len(), first.hint.as_str()), (2, "1. 2. 3."));
    }

    #[test]
    fn info_that_is_not_one_gets_a_sentence() {
        let twice = format!("{INFO}\n[[exercises]]\nname = 'a1_first'\ndir = 'a'");
        for (text, sentence) in [
            ("", "format_version = 1 is missing"),
            ("format_version = 2", "format_version is 2"),
            ("format_version = 1", "it lists no [[exercises]]"),
            (
                &INFO.replace("a1_first", "../up"),
                "the name \"../up\" is not",
            ),
            (&INFO.replace("'a'", "''"), "a1_first: dir = \"\" is not"),
            (&twice, "a1_first is listed twice"),
        ] {
            let why = parse_info(text).unwrap_err();
            assert!(why.contains(sentence), "{why}");
        }
    }

    #[test]
    fn bins_are_found_between_their_brackets() {
        assert_eq!(
            split_bins("bin = [\n x\n]\n[package]"),
            Some(["bin = [", "\n x\n", "]\n[package]"])
        );
        assert_eq!(split_bins("[package]"), None);
        assert_eq!(split_bins("bin = ["), None);
    }
}
