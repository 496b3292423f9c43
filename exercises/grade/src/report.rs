//! What grading found, as JUnit XML, as JSON and as a table.

use std::fmt::Write;
use std::time::Duration;

use serde_json::{Value, json};

/// What became of one student's answers.
#[derive(Debug)]
pub struct Report {
    /// The folder that was graded, as it was named.
    pub student: String,
    /// How long the tests of an exercise were allowed to run.
    pub time_limit: Duration,
    /// One for each exercise, in the order of info.toml.
    pub results: Vec<ExerciseResult>,
}

/// What became of one exercise.
#[derive(Debug)]
pub struct ExerciseResult {
    /// The exercise.
    pub name: String,
    /// Its topic.
    pub topic: String,
    /// In one word.
    pub status: Status,
    /// Its tests, in the order of the file.
    pub tests: Vec<Test>,
}

/// What became of one test.
#[derive(Debug)]
pub struct Test {
    /// Its name.
    pub name: String,
    /// How it ended.
    pub verdict: Verdict,
    /// How long it ran.
    pub time: Duration,
}

/// How a test ended.
#[derive(Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It passed.
    Passed,
    /// It failed, and said why.
    Failed(String),
    /// It was stopped at the time limit.
    Stopped(String),
    /// It could not be run.
    Error(String),
}

/// An exercise in one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Status {
    /// All tests pass.
    Solved,
    /// A test fails.
    Failed,
    /// A test ran too long.
    TimeLimit,
    /// The compiler rejects the answer.
    DoesNotCompile,
    /// There is no file.
    Missing,
    /// The file is not text, or too large.
    Unreadable,
    /// There is a link in place of the file.
    Link,
}

impl Status {
    fn text(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Failed => "failed",
            Self::TimeLimit => "time limit",
            Self::DoesNotCompile => "does not compile",
            Self::Missing => "missing",
            Self::Unreadable => "unreadable",
            Self::Link => "link",
        }
    }
}

impl ExerciseResult {
    fn passed(&self) -> usize {
        self.tests
            .iter()
            .filter(|test| test.verdict == Verdict::Passed)
            .count()
    }
}

/// Counts of solved exercises and passed tests.
fn counts<'a>(results: impl Iterator<Item = &'a ExerciseResult> + Clone) -> [usize; 4] {
    [
        results.clone().count(),
        results
            .clone()
            .filter(|result| result.status == Status::Solved)
            .count(),
        results.clone().map(|result| result.tests.len()).sum(),
        results.map(ExerciseResult::passed).sum(),
    ]
}

impl Report {
    /// The topics in the order of their first exercise.
    fn topics(&self) -> Vec<&str> {
        let mut topics: Vec<&str> = Vec::new();
        for result in &self.results {
            if !topics.contains(&result.topic.as_str()) {
                topics.push(&result.topic);
            }
        }
        topics
    }

    fn of_topic<'a>(&'a self, topic: &'a str) -> impl Iterator<Item = &'a ExerciseResult> + Clone {
        self.results
            .iter()
            .filter(move |result| result.topic == topic)
    }

    /// A summary for every topic, and the fingerprint of what was graded.
    pub fn json(&self, fingerprint: u64) -> String {
        let topic = |topic: &str| {
            let [exercises, solved, tests, passed] = counts(self.of_topic(topic));
            let results = self.of_topic(topic).map(|result| {
                json!({
                    "name": result.name,
                    "status": result.status.text(),
                    "tests": result.tests.len(),
                    "tests_passed": result.passed(),
                })
            });
            json!({
                "topic": topic,
                "exercises": exercises,
                "exercises_solved": solved,
                "tests": tests,
                "tests_passed": passed,
                "results": results.collect::<Vec<Value>>(),
            })
        };
        let [exercises, solved, tests, passed] = counts(self.results.iter());
        let summary = json!({
            "student": self.student,
            "fingerprint": format!("{fingerprint:016x}"),
            "time_limit_seconds": self.time_limit.as_secs_f64(),
            "exercises": exercises,
            "exercises_solved": solved,
            "tests": tests,
            "tests_passed": passed,
            "topics": self.topics().into_iter().map(topic).collect::<Vec<Value>>(),
        });
        format!("{summary:#}\n")
    }

    /// A suite for every exercise, a case for every test.
    pub fn junit(&self) -> String {
        let mut cases = String::new();
        let mut totals = [0, 0];
        for result in &self.results {
            let tests = &result.tests;
            let errors = tests
                .iter()
                .filter(|test| matches!(test.verdict, Verdict::Error(_)))
                .count();
            let failures = tests.len() - result.passed() - errors;
            totals = [totals[0] + failures, totals[1] + errors];
            let suite = escape(&format!("{}.{}", result.topic, result.name));
            let seconds: f64 = tests.iter().map(|test| test.time.as_secs_f64()).sum();
            cases += &format!(
                "  <testsuite name=\"{suite}\" tests=\"{}\" failures=\"{failures}\" errors=\"{errors}\" \
                 skipped=\"0\" time=\"{seconds:.3}\">\n",
                tests.len()
            );
            for Test {
                name,
                verdict,
                time,
            } in tests
            {
                let name = escape(name);
                cases += &format!(
                    "    <testcase classname=\"{suite}\" name=\"{name}\" time=\"{:.3}\"",
                    time.as_secs_f64()
                );
                cases += &match verdict {
                    Verdict::Passed => "/>\n".to_owned(),
                    Verdict::Failed(why) => element("failure", "failed", why),
                    Verdict::Stopped(why) => element("failure", "time limit", why),
                    Verdict::Error(why) => element("error", result.status.text(), why),
                };
            }
            cases += "  </testsuite>\n";
        }
        let [_, _, tests, _] = counts(self.results.iter());
        let [failures, errors] = totals;
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{tests}\" \
             failures=\"{failures}\" errors=\"{errors}\">\n{cases}</testsuites>\n",
            escape(&self.student)
        )
    }

    /// What the student is told: of each exercise how it stands, and what its first failing test says.
    pub fn feedback(&self) -> String {
        let [exercises, solved, tests, passed] = counts(self.results.iter());
        let mut text = format!(
            "{}\n\n{solved} of {exercises} exercises solved, {passed} of {tests} tests passed\n",
            self.student
        );
        for result in &self.results {
            // Writing to a String cannot fail.
            let _ = write!(
                text,
                "\n{}: {}, {} of {} tests\n",
                result.name,
                result.status.text(),
                result.passed(),
                result.tests.len()
            );
            let failing = result.tests.iter().find_map(|test| match &test.verdict {
                Verdict::Passed => None,
                Verdict::Failed(why) | Verdict::Stopped(why) => {
                    Some((format!("{}: ", test.name), why))
                }
                // The same for all its tests.
                Verdict::Error(why) => Some((String::new(), why)),
            });
            if let Some((test, why)) = failing {
                for line in format!("{test}{why}").lines() {
                    let _ = writeln!(text, "    {line}");
                }
            }
        }
        text
    }

    /// How many exercises are solved, of how many.
    pub fn solved(&self) -> [usize; 2] {
        let [exercises, solved, ..] = counts(self.results.iter());
        [solved, exercises]
    }

    /// A line for every exercise and a sum for every topic.
    pub fn table(&self) -> String {
        let mut table = String::new();
        let mut line = |name: &str, status: &str, passed: usize, tests: usize| {
            // Writing to a String cannot fail.
            let _ = writeln!(
                table,
                "{name:<34} {status:<18} {passed:>3} of {tests} tests"
            );
        };
        for topic in self.topics() {
            let [exercises, solved, tests, passed] = counts(self.of_topic(topic));
            line(
                topic,
                &format!("{solved} of {exercises} solved"),
                passed,
                tests,
            );
            for result in self.of_topic(topic) {
                line(
                    &format!("  {}", result.name),
                    result.status.text(),
                    result.passed(),
                    result.tests.len(),
                );
            }
        }
        table
    }
}

fn element(kind: &str, what: &str, why: &str) -> String {
    let first = escape(why.lines().next().unwrap_or_default());
    format!(
        "><{kind} type=\"{}\" message=\"{first}\">{}</{kind}></testcase>\n",
        escape(what),
        escape(why)
    )
}

/// Text as XML 1.0 allows it in an attribute and in an element.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            '\n' | '\t' => escaped.push(c),
            // Characters that XML 1.0 has no way to write.
            '\0'..' ' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report() -> Report {
        let test = |name: &str, verdict| Test {
            name: name.into(),
            verdict,
            time: Duration::from_millis(1500),
        };
        let result = |name: &str, topic: &str, status, tests| ExerciseResult {
            name: name.into(),
            topic: topic.into(),
            status,
            tests,
        };
        Report {
            student: "Ann & Bob".into(),
            time_limit: Duration::from_secs(10),
            results: vec![
                result("a1", "a", Status::Solved, vec![test("x", Verdict::Passed)]),
                result(
                    "b1",
                    "b",
                    Status::TimeLimit,
                    vec![
                        test("x", Verdict::Failed("1 < 2\n\"no\"".into())),
                        test("y", Verdict::Stopped("late".into())),
                        test("z", Verdict::Passed),
                    ],
                ),
                result(
                    "a2",
                    "a",
                    Status::Missing,
                    vec![test("x", Verdict::Error("not there".into()))],
                ),
            ],
        }
    }

    #[test]
    fn escape_leaves_only_what_xml_allows() {
        assert_eq!(
            escape("a<b> & \"c\" 'd'"),
            "a&lt;b&gt; &amp; &quot;c&quot; &apos;d&apos;"
        );
        assert_eq!(
            escape("\u{1b}[31m\0\r\n\tφ\u{ffff}"),
            "\u{fffd}[31m\u{fffd}\u{fffd}\n\tφ\u{fffd}"
        );
    }

    #[test]
    fn junit_counts_failures_and_errors() {
        let xml = report().junit();
        for part in [
            "<testsuites name=\"Ann &amp; Bob\" tests=\"5\" failures=\"2\" errors=\"1\">",
            "<testsuite name=\"b.b1\" tests=\"3\" failures=\"2\" errors=\"0\" skipped=\"0\" time=\"4.500\">",
            "<testcase classname=\"a.a1\" name=\"x\" time=\"1.500\"/>",
            "<failure type=\"failed\" message=\"1 &lt; 2\">1 &lt; 2\n&quot;no&quot;</failure></testcase>",
            "<error type=\"missing\" message=\"not there\">not there</error></testcase>",
        ] {
            assert!(xml.contains(part), "{part}\n{xml}");
        }
    }

    #[test]
    fn json_has_a_summary_for_every_topic() {
        let summary: Value = serde_json::from_str(&report().json(7)).unwrap();
        assert_eq!(summary["tests_passed"], 2);
        assert_eq!(summary["topics"][0]["topic"], "a");
        assert_eq!(summary["topics"][0]["exercises"], 2);
        assert_eq!(summary["topics"][0]["exercises_solved"], 1);
        assert_eq!(summary["topics"][1]["tests_passed"], 1);
        assert_eq!(summary["topics"][1]["results"][0]["status"], "time limit");
    }

    #[test]
    fn feedback_has_the_first_failing_test() {
        let text = report().feedback();
        assert!(text.starts_with("Ann & Bob\n\n1 of 3 exercises solved, 2 of 5 tests passed\n"));
        assert!(text.contains(
            "\na1: solved, 1 of 1 tests\n\nb1: time limit, 1 of 3 tests\n    x: 1 < 2\n    \"no\"\n"
        ));
        assert!(
            text.ends_with("a2: missing, 0 of 1 tests\n    not there\n"),
            "{text}"
        );
    }

    #[test]
    fn table_has_a_line_for_every_exercise() {
        let table = report().table();
        assert_eq!(table.lines().count(), 5);
        assert!(
            table.starts_with(
                "a                                  1 of 2 solved        1 of 2 tests\n"
            ),
            "{table}"
        );
    }
}
