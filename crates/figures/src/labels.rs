//! Every word in the figures, in the four languages of the lectures: a file a lecture.
//!
//! A missing translation does not compile. The terms are the lectures' own (Italian: Grafica 3 and Bologna; Czech:
//! Olomouc; Croatian: Croatian 8.4; English: CIS 781).

use crate::style::Language;

/// Keys with their words in every language.
macro_rules! words {
    ($($(#[$about:meta])* $name:ident { $($language:ident: $text:literal,)* })*) => {
        impl Key {
            $($(#[$about])* pub const $name: Key = Key { $($language: $text),* };)*
        }

        pub(super) const ALL: &[(&str, Key)] = &[$((stringify!($name), Key::$name)),*];
    };
}

mod clip;
mod gallery;
mod hsr;
mod math;
mod raster;
mod shadows;

/// A word or sentence in the markup of [`crate::text`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key {
    en: &'static str,
    it: &'static str,
    cs: &'static str,
    hr: &'static str,
}

impl Key {
    /// Every key there is with its name, for tests.
    pub fn all() -> impl Iterator<Item = (&'static str, Key)> {
        let lectures = [
            gallery::ALL,
            math::ALL,
            raster::ALL,
            clip::ALL,
            shadows::ALL,
            hsr::ALL,
        ];
        lectures.into_iter().flatten().copied()
    }

    /// Its words.
    pub const fn text(self, language: Language) -> &'static str {
        match language {
            Language::En => self.en,
            Language::It => self.it,
            Language::Cs => self.cs,
            Language::Hr => self.hr,
        }
    }
}
