//! Building with cargo: which programs came out, and what the compiler said of the rest.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// An error (or a denied warning) of the compiler.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complaint {
    /// The target that it was building.
    pub target: String,
    /// The file, as cargo names it.
    pub file: String,
    /// The whole message as a programmer reads it.
    pub text: String,
}

/// What a build left.
#[derive(Debug, Default)]
pub struct Built {
    /// The test programs, by the name of their target.
    pub programs: BTreeMap<String, PathBuf>,
    /// The libraries, by the name of their target.
    pub libraries: BTreeMap<String, PathBuf>,
    /// Errors, in the order in which they came.
    pub complaints: Vec<Complaint>,
    /// Whether cargo ended well.
    pub succeeded: bool,
    /// What cargo itself said.
    pub cargo_said: String,
}

/// Runs `cargo ARGUMENTS --locked --message-format=json -- LINTS` in the folder `dir`, with the target folder `target`.
pub fn cargo(
    dir: &Path,
    target: &Path,
    arguments: &[&str],
    lints: &[&str],
) -> Result<Built, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .current_dir(dir)
        .args(arguments)
        .args(["--locked", "--message-format=json", "--target-dir"])
        .arg(target)
        .arg("--")
        .args(lints)
        // A caller's flags, such as denied warnings, are not meant for this package.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env_remove("CARGO_BUILD_RUSTFLAGS")
        .env("CARGO_TERM_COLOR", "never")
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    let mut built = read_messages(&String::from_utf8_lossy(&output.stdout));
    built.succeeded = output.status.success();
    built.cargo_said = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok(built)
}

fn read_messages(lines: &str) -> Built {
    let mut built = Built::default();
    for message in lines
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
    {
        let target = message["target"]["name"].as_str().unwrap_or_default();
        match message["reason"].as_str() {
            Some("compiler-artifact") if message["profile"]["test"] != true => {
                let files = message["filenames"].as_array().into_iter().flatten();
                let mut files = files.filter_map(Value::as_str);
                if let Some(library) = files.find(|file| file.ends_with(".rlib")) {
                    built.libraries.insert(target.to_owned(), library.into());
                }
            }
            Some("compiler-artifact") => {
                if let Some(program) = message["executable"].as_str() {
                    built.programs.insert(target.to_owned(), program.into());
                }
            }
            Some("compiler-message") if message["message"]["level"] == "error" => {
                let complaint = &message["message"];
                let spans = complaint["spans"].as_array().into_iter().flatten();
                let file = spans.filter_map(|span| span["file_name"].as_str()).next();
                built.complaints.push(Complaint {
                    target: target.to_owned(),
                    file: file.unwrap_or_default().replace('\\', "/"),
                    text: complaint["rendered"]
                        .as_str()
                        .unwrap_or_default()
                        .to_owned(),
                });
            }
            _ => {}
        }
    }
    built
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_give_programs_and_complaints() {
        let built = read_messages(concat!(
            r#"{"reason":"compiler-artifact","target":{"name":"lib"},"profile":{"test":false},"filenames":["y/lib.rmeta","y/lib.rlib"],"executable":null}"#,
            "\n",
            r#"{"reason":"compiler-artifact","target":{"name":"a"},"profile":{"test":false},"executable":"x/a"}"#,
            "\n",
            r#"{"reason":"compiler-artifact","target":{"name":"a"},"profile":{"test":true},"executable":"x/a-1"}"#,
            "\n",
            r#"{"reason":"compiler-message","target":{"name":"b"},"message":{"level":"warning","spans":[]}}"#,
            "\n",
            r#"{"reason":"compiler-message","target":{"name":"b"},"message":{"level":"error","rendered":"E","spans":[{"file_name":"src\\b.rs"}]}}"#,
            "\nnot json\n",
        ));
        assert_eq!(
            built.programs.into_iter().collect::<Vec<_>>(),
            [("a".into(), "x/a-1".into())]
        );
        assert_eq!(
            built.libraries.into_iter().collect::<Vec<_>>(),
            [("lib".into(), "y/lib.rlib".into())]
        );
        let complaint = Complaint {
            target: "b".into(),
            file: "src/b.rs".into(),
            text: "E".into(),
        };
        assert_eq!(built.complaints, [complaint]);
    }
}
