//! The line that parts an exercise's file.

/// Everything from this line on belongs to the course.
pub const MARKER: &str = "// ---- tests: leave everything below as it is ----";

/// The student's part, and the rest from the marker line on; `None` without a marker line.
///
/// With several marker lines the first one counts.
#[must_use]
pub fn split(text: &str) -> Option<(&str, &str)> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if line.trim_end() == MARKER {
            return Some(text.split_at(start));
        }
        start += line.len();
    }
    None
}
