//! The forms that the row has.

use std::fmt;
use std::str::FromStr;

/// What is drawn of the mesh, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    pub size: u32,
    /// Or depth alone.
    pub coloured: bool,
    /// Whether triangles seen from behind are left out.
    pub cull: bool,
}

pub const COLOURED: Form = Form {
    size: 1024,
    coloured: true,
    cull: false,
};

pub const SHADOW_MAP: Form = Form {
    size: 2048,
    coloured: false,
    cull: false,
};

impl Form {
    pub fn culled(self) -> Self {
        Self { cull: true, ..self }
    }

    pub fn described(self, triangles: usize, threads: usize) -> String {
        let size = self.size;
        let what = if self.coloured {
            "flat colours (RGBA) and depth (f32)"
        } else {
            "depth alone (f32)"
        };
        let sides = if self.cull {
            "front sides"
        } else {
            "both sides"
        };
        let clock = if threads == 1 {
            "processor time"
        } else {
            "time by the clock"
        };
        format!("{triangles} triangles, {size}², {what}, {sides}, cleared each time, {clock}")
    }
}

/// `1024 true false`: how it is told to another process.
impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.size, self.coloured, self.cull)
    }
}

impl FromStr for Form {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = |words: &[&str]| -> Option<Self> {
            let &[size, coloured, cull] = words else {
                return None;
            };
            Some(Self {
                size: size.parse().ok()?,
                coloured: coloured.parse().ok()?,
                cull: cull.parse().ok()?,
            })
        };
        let words: Vec<&str> = text.split(' ').collect();
        form(&words).ok_or_else(|| format!("\"{text}\" is no form of a row; \"{COLOURED}\" is one"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_is_understood_by_the_other_process() {
        for form in [COLOURED, SHADOW_MAP, COLOURED.culled()] {
            assert_eq!(form.to_string().parse(), Ok(form));
        }
        for text in [
            "",
            "1024",
            "1024 true",
            "1024 true maybe",
            "-1 true true",
            "1 true true true",
        ] {
            let sentence = text.parse::<Form>().unwrap_err();
            assert!(sentence.contains("\"1024 true false\""), "{sentence}");
        }
    }
}
