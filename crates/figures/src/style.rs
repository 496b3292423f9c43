//! What an instructor chooses about all figures at once: size, theme, language, background, text form, caption.

use core::fmt;
use core::ops::RangeInclusive;
use core::str::FromStr;

use crate::error::FigureError;

/// A picture's size in pixels; always within [`Size::SIDES`] and [`Size::MOST_PIXELS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// Length of a side in pixels.
    pub const SIDES: RangeInclusive<u32> = 64..=16_384;
    /// Pixels in all (8192 × 8192): 256 MiB of colour.
    pub const MOST_PIXELS: u64 = 1 << 26;
    /// Full HD, 16:9.
    pub const FULL_HD: Size = Size {
        width: 1920,
        height: 1080,
    };

    /// Checks the sides before anything is allocated.
    ///
    /// # Errors
    ///
    /// [`FigureError::Value`] outside [`Size::SIDES`], above [`Size::MOST_PIXELS`], or when a side is more than 4 times
    /// the other.
    pub fn new(width: u32, height: u32) -> Result<Size, FigureError> {
        let pixels = u64::from(width) * u64::from(height);
        let (short, long) = (width.min(height), width.max(height));
        if Self::SIDES.contains(&width)
            && Self::SIDES.contains(&height)
            && pixels <= Self::MOST_PIXELS
            && long <= 4 * short
        {
            Ok(Size { width, height })
        } else {
            Err(Size::refused(format!("{width}x{height}")))
        }
    }

    /// Why `value` is no size.
    pub(crate) fn refused(value: String) -> FigureError {
        let (least, most) = (Self::SIDES.start(), Self::SIDES.end());
        FigureError::Value {
            option: "--size",
            value,
            allowed: format!(
                "WIDTHxHEIGHT in pixels, each side from {least} to {most}, at most {} pixels in all, and no side more \
                 than 4 times the other",
                Self::MOST_PIXELS
            ),
        }
    }

    /// Pixels across.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Pixels down.
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Pixels along the shorter side.
    pub fn shorter(self) -> u32 {
        self.width.min(self.height)
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = FigureError;

    fn from_str(text: &str) -> Result<Self, FigureError> {
        let wrong = || Size::refused(text.to_owned());
        let (width, height) = text.split_once(['x', '×']).ok_or_else(wrong)?;
        let side = |digits: &str| {
            let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
            plain
                .then(|| digits.parse().ok())
                .flatten()
                .ok_or_else(wrong)
        };
        Size::new(side(width)?, side(height)?).map_err(|_| wrong())
    }
}

/// An enum whose values are typed on the command line.
macro_rules! choice {
    ($(#[$doc:meta])* $name:ident, $option:literal, $($(#[$value_doc:meta])* $value:ident = $word:literal,)+) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$value_doc])* $value,)+
        }

        impl $name {
            /// Every value there is.
            pub const ALL: &'static [$name] = &[$($name::$value,)+];

            /// The word typed for it.
            pub const fn word(self) -> &'static str {
                match self {
                    $($name::$value => $word,)+
                }
            }
        }

        impl FromStr for $name {
            type Err = FigureError;

            fn from_str(text: &str) -> Result<Self, FigureError> {
                Self::ALL.iter().copied().find(|value| value.word() == text).ok_or_else(|| {
                    FigureError::Value {
                        option: $option,
                        value: text.to_owned(),
                        allowed: format!("one of {}", [$($word,)+].join(", ")),
                    }
                })
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.word())
            }
        }
    };
}

choice! {
    /// Light or dark paper; every colour has a value of equal contrast on both.
    Theme, "--theme",
    /// White paper.
    Light = "light",
    /// Nearly black paper.
    Dark = "dark",
}

choice! {
    /// The languages of the lectures.
    Language, "--lang",
    /// English.
    En = "en",
    /// Italian.
    It = "it",
    /// Czech.
    Cs = "cs",
    /// Croatian.
    Hr = "hr",
}

choice! {
    /// What lies behind the figure.
    Background, "--background",
    /// The theme's paper.
    Theme = "theme",
    /// Nothing: the slide shows through.
    Transparent = "transparent",
}

choice! {
    /// The file formats figures are written in.
    Format, "--format",
    /// Scalable, for slides and pages.
    Svg = "svg",
    /// Pixels.
    Png = "png",
    /// Scalable, for print and for slides made with LaTeX.
    Pdf = "pdf",
}

/// How an SVG holds its letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextForm {
    /// As outlines: the same picture everywhere.
    Paths,
    /// As `<text>`: for people who edit the figure; the reader's machine supplies the typeface.
    Text,
}

/// Everything about the look of a figure that is not the figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// Size in pixels; its aspect shapes the SVG too.
    pub size: Size,
    /// Light or dark.
    pub theme: Theme,
    /// Language of the labels.
    pub language: Language,
    /// Paper or nothing.
    pub background: Background,
    /// Form of letters in SVG.
    pub text: TextForm,
    /// Whether a sentence below says what the figure shows.
    pub caption: bool,
}

impl Default for Style {
    fn default() -> Self {
        Style {
            size: Size::FULL_HD,
            theme: Theme::Light,
            language: Language::En,
            background: Background::Theme,
            text: TextForm::Paths,
            caption: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!("1920x1080".parse(), Ok(Size::FULL_HD));
        assert_eq!("640×480".parse(), Size::new(640, 480));
        for wrong in [
            "",
            "x",
            "1920",
            "1920x",
            "+64x64",
            "64x-64",
            "63x64",
            "64x16385",
            "16384x16384",
            "64x257",
            "1e3x1e3",
            "99999999999x64",
            "1920 x1080",
            "NaNx64",
        ] {
            let error = wrong.parse::<Size>().unwrap_err().to_string();
            assert!(
                error.contains(&format!("'{wrong}'")) && error.contains("64"),
                "{error}"
            );
        }
    }

    #[test]
    fn every_word_is_read_back_and_others_are_told_what_is_allowed() {
        for &theme in Theme::ALL {
            assert_eq!(theme.word().parse(), Ok(theme));
        }
        for &language in Language::ALL {
            assert_eq!(language.word().parse(), Ok(language));
        }
        assert_eq!(
            "pink".parse::<Theme>().unwrap_err().to_string(),
            "--theme cannot be 'pink': it is one of light, dark"
        );
        assert_eq!(
            "EN".parse::<Language>().unwrap_err().to_string(),
            "--lang cannot be 'EN': it is one of en, it, cs, hr"
        );
        assert!("jpg".parse::<Format>().is_err());
        assert!("white".parse::<Background>().is_err());
    }
}
