//! Compiling answers with rustc: what all students share once, and then one program a student.

use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::Value;

use crate::run;

/// How long the compiler may take: a constant may loop without end.
const LIMIT: Duration = Duration::from_secs(60);

/// The compiler, and the libraries that all answers are linked with.
#[derive(Debug)]
pub struct Compiler {
    rustc: PathBuf,
    /// Name and file of each library that the tests use.
    externs: Vec<(String, PathBuf)>,
    /// Where the libraries of those libraries lie.
    dependencies: PathBuf,
}

/// What rustc complained of: the first file that an error names, and the message.
#[derive(Debug)]
pub struct Complaint {
    /// As it was handed to rustc; empty where an error names none.
    pub file: String,
    /// The message as a programmer reads it.
    pub text: String,
}

impl Compiler {
    /// The compiler beside the cargo that runs us.
    pub fn new(externs: Vec<(String, PathBuf)>, dependencies: PathBuf) -> Self {
        let beside_cargo = || {
            let rustc = Path::new(&std::env::var_os("CARGO")?)
                .with_file_name(format!("rustc{}", std::env::consts::EXE_SUFFIX));
            rustc.is_file().then_some(rustc)
        };
        let asked = std::env::var_os("RUSTC").map(PathBuf::from);
        Self {
            rustc: beside_cargo().or(asked).unwrap_or_else(|| "rustc".into()),
            externs,
            dependencies,
        }
    }

    /// Compiles the file `source` in the folder `dir` to `output`, a program or a library (`kind`); what it complained
    /// of where it does not compile.
    pub fn compile(
        &self,
        dir: &Path,
        kind: &str,
        source: &str,
        output: &str,
        more: &[(&str, &str)],
    ) -> Result<Result<(), Vec<Complaint>>, String> {
        let mut arguments = vec![
            "--edition=2024".to_owned(),
            format!("--crate-type={kind}"),
            "--cap-lints=allow".to_owned(),
            "--error-format=json".to_owned(),
            "-Cdebug-assertions=on".to_owned(),
            "-Cdebuginfo=0".to_owned(),
            "-Ccodegen-units=1".to_owned(),
            format!("-o{output}"),
            format!("-Ldependency={}", self.dependencies.display()),
        ];
        let externs = self.externs.iter();
        let externs = externs.map(|(name, file)| (name.as_str(), file.display().to_string()));
        let more = more.iter().map(|&(name, file)| (name, file.to_owned()));
        for (name, file) in externs.chain(more) {
            arguments.push(format!("--extern={name}={file}"));
        }
        arguments.push(source.to_owned());
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let ended = run::start(&self.rustc, &arguments, dir, "", None)?.wait(LIMIT)?;
        let Some(status) = ended.status else {
            return Ok(Err(vec![Complaint {
                file: String::new(),
                text: format!(
                    "stopped: the compiler was not done after {} s; does a constant loop without end?",
                    LIMIT.as_secs()
                ),
            }]));
        };
        if status.success() {
            return Ok(Ok(()));
        }
        let said = ended.stderr;
        let complaints = complaints(&said);
        if complaints.is_empty() {
            return Err(format!("{} fails:\n{said}", self.rustc.display()));
        }
        Ok(Err(complaints))
    }
}

fn complaints(said: &str) -> Vec<Complaint> {
    let messages = said
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|message| message["level"] == "error");
    messages
        .map(|message| {
            let spans = message["spans"].as_array().cloned().unwrap_or_default();
            let primary = spans.iter().find(|span| span["is_primary"] == true);
            // An error within a macro lies in the file that calls it.
            let mut span = primary.or(spans.first()).cloned().unwrap_or_default();
            while span["expansion"]["span"].is_object() {
                span = span["expansion"]["span"].clone();
            }
            Complaint {
                file: span["file_name"]
                    .as_str()
                    .unwrap_or_default()
                    .replace('\\', "/"),
                text: message["rendered"].as_str().unwrap_or_default().to_owned(),
            }
        })
        // "aborting due to 2 previous errors" says nothing of its own.
        .filter(|complaint| !complaint.text.starts_with("error: aborting due to"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_lies_where_the_macro_is_called() {
        let said = concat!(
            r#"{"level":"warning","rendered":"W","spans":[{"file_name":"a.rs","is_primary":true}]}"#,
            "\nnot json\n",
            r#"{"level":"error","rendered":"E","spans":[{"file_name":"/std/m.rs","is_primary":true,"expansion":{"span":{"file_name":"x\\b.rs","expansion":null}}}]}"#,
            "\n",
            r#"{"level":"error","rendered":"error: aborting due to 1 previous error","spans":[]}"#,
        );
        let [one] = complaints(said).try_into().unwrap();
        assert_eq!((one.file.as_str(), one.text.as_str()), ("x/b.rs", "E"));
    }
}
