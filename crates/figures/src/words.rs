//! Words in the figures, in the four languages of the lectures.
//!
//! A figure's words stand in its own file, in a list that the macro `words` makes; those that several figures share
//! stand here. The terms are the lectures' own (Italian: Grafica 3 and Bologna; Czech: Olomouc; Croatian: Croatian 8.4;
//! English: CIS 781).

use crate::style::Language;

/// A word or sentence in the markup of [`crate::text`]: in English, and as far as it is translated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Word {
    /// English.
    pub en: &'static str,
    /// Italian.
    pub it: Option<&'static str>,
    /// Czech.
    pub cs: Option<&'static str>,
    /// Croatian.
    pub hr: Option<&'static str>,
}

impl Word {
    /// In English alone.
    #[must_use]
    pub const fn english(en: &'static str) -> Word {
        let (it, cs, hr) = (None, None, None);
        Word { en, it, cs, hr }
    }

    /// In `language`, if it is translated.
    #[must_use]
    pub const fn translated(self, language: Language) -> Option<&'static str> {
        match language {
            Language::En => Some(self.en),
            Language::It => self.it,
            Language::Cs => self.cs,
            Language::Hr => self.hr,
        }
    }

    /// In `language`, or in English where it is not translated.
    #[must_use]
    pub const fn text(self, language: Language) -> &'static str {
        match self.translated(language) {
            Some(text) => text,
            None => self.en,
        }
    }
}

/// Constants of the type [`Word`] and, as `WORDS`, the list of them all.
///
/// ```text
/// words! {
///     /// Where it stands.
///     NAME { en: "always", it: "se c’è", cs: "je-li", hr: "ako postoji", }
/// }
/// ```
macro_rules! words {
    ($(
        $(#[$about:meta])*
        $visibility:vis $name:ident { en: $en:literal, $($language:ident: $text:literal,)* }
    )*) => {
        $(
            $(#[$about])*
            $visibility const $name: $crate::words::Word = $crate::words::Word {
                $($language: Some($text),)*
                ..$crate::words::Word::english($en)
            };
        )*

        /// All words of this file.
        // Words of inputs alone are tested with the inputs.
        #[allow(dead_code)]
        pub const WORDS: &[$crate::words::Word] = &[
            $($crate::words::Word { $($language: Some($text),)* ..$crate::words::Word::english($en) },)*
        ];
    };
}
pub(crate) use words;

words! {
    /// An input: the light.
    pub LIGHT {
        en: "the light",
        it: "la luce",
        cs: "zdroj světla",
        hr: "izvor svjetla",
    }

    /// An input: the plane.
    pub PLANE {
        en: "the plane that receives the shadow",
        it: "il piano che riceve l’ombra",
        cs: "rovina, na kterou dopadá stín",
        hr: "ravnina na koju pada sjena",
    }

    /// An input: the object.
    pub OBJECT {
        en: "the object",
        it: "l’oggetto",
        cs: "těleso",
        hr: "objekt",
    }

    /// Pixels after their number, five or more or none.
    pub PIXELS_OF {
        en: "pixels",
        it: "pixel",
        cs: "pixelů",
        hr: "piksela",
    }

    /// What is a shadow.
    pub TRUE_SHADOW {
        en: "true shadow",
        it: "ombra vera",
        cs: "skutečný stín",
        hr: "prava sjena",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    words! {
        HALF { en: "half", hr: "pola", }
    }

    #[test]
    fn what_is_not_translated_is_said_in_english() {
        assert_eq!(WORDS, [HALF]);
        let said = Language::ALL.iter().map(|&language| HALF.text(language));
        assert!(said.eq(["half", "half", "half", "pola"]));
        assert_eq!(HALF.translated(Language::Cs), None);
    }
}
