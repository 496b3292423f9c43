//! What an instructor chooses about all figures at once: size, theme, language, background, text form, caption.

use core::fmt;
use core::ops::RangeInclusive;
use core::str::FromStr;

use crate::colour::{Palette, contrast};
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
    /// Shorter side of a size that is given as an aspect.
    pub const SHORTER: u32 = 1080;
    /// Full HD, 16:9.
    pub const FULL_HD: Size = Size {
        width: 1920,
        height: 1080,
    };

    /// Checks the sides before anything is allocated.
    ///
    /// # Errors
    ///
    /// [`FigureError::Value`] outside [`Size::SIDES`], above [`Size::MOST_PIXELS`], or when a side is more than 2 times
    /// the other.
    pub fn new(width: u32, height: u32) -> Result<Size, FigureError> {
        let pixels = u64::from(width) * u64::from(height);
        let (short, long) = (width.min(height), width.max(height));
        if Self::SIDES.contains(&width)
            && Self::SIDES.contains(&height)
            && pixels <= Self::MOST_PIXELS
            && u64::from(long) <= 2 * u64::from(short)
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
                 than 2 times the other; or an aspect as 16:9, whose shorter side is then {}",
                Self::MOST_PIXELS,
                Self::SHORTER
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

    /// `1920x1080`; or an aspect, `16:9`, whose shorter side is then [`Size::SHORTER`] and whose longer one is rounded
    /// to the nearest pixel.
    fn from_str(text: &str) -> Result<Self, FigureError> {
        let wrong = || Size::refused(text.to_owned());
        let number = |digits: &str| -> Result<u32, FigureError> {
            let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
            plain
                .then(|| digits.parse().ok())
                .flatten()
                .ok_or_else(wrong)
        };
        let (width, height) = if let Some((width, height)) = text.split_once(':') {
            let (width, height) = (number(width)?, number(height)?);
            let (short, long) = (width.min(height), width.max(height));
            let longer = (u64::from(long) * u64::from(Size::SHORTER) + u64::from(short) / 2)
                .checked_div(u64::from(short))
                .and_then(|longer| u32::try_from(longer).ok())
                .ok_or_else(wrong)?;
            // An aspect is refused before it is rounded.
            if u64::from(long) > 2 * u64::from(short) {
                return Err(wrong());
            }
            if width < height {
                (Size::SHORTER, longer)
            } else {
                (longer, Size::SHORTER)
            }
        } else {
            let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
            (number(width)?, number(height)?)
        };
        Size::new(width, height).map_err(|_| wrong())
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

            /// In small or capital letters.
            fn from_str(text: &str) -> Result<Self, FigureError> {
                Self::ALL.iter().copied().find(|value| value.word().eq_ignore_ascii_case(text)).ok_or_else(|| {
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

impl Theme {
    /// The theme whose letters stand out on a colour, 0xRRGGBB.
    pub fn on(rgb: u32) -> Theme {
        if contrast(0xFF_FF_FF, rgb) > contrast(0, rgb) {
            Theme::Dark
        } else {
            Theme::Light
        }
    }
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

/// What lies behind the figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Background {
    /// The theme's paper.
    #[default]
    Theme,
    /// Nothing: the slide shows through.
    Transparent,
    /// A colour, 0xRRGGBB.
    Colour(u32),
}

impl FromStr for Background {
    type Err = FigureError;

    fn from_str(text: &str) -> Result<Self, FigureError> {
        let hex = |text: &str| {
            let digits = text.strip_prefix('#')?;
            let plain = digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
            plain
                .then(|| u32::from_str_radix(digits, 16).ok())
                .flatten()
        };
        match text.to_ascii_lowercase().as_str() {
            "theme" => Ok(Background::Theme),
            "transparent" => Ok(Background::Transparent),
            other => hex(other)
                .map(Background::Colour)
                .ok_or_else(|| FigureError::Value {
                    option: "--background",
                    value: text.to_owned(),
                    allowed: "theme, transparent, or a colour #RRGGBB of six hexadecimal digits"
                        .to_owned(),
                }),
        }
    }
}

impl fmt::Display for Background {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Background::Theme => f.write_str("theme"),
            Background::Transparent => f.write_str("transparent"),
            Background::Colour(rgb) => write!(f, "#{rgb:06x}"),
        }
    }
}

/// How large letters are, in hundredths of the usual size; what does not fit gets smaller all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextScale(u16);

impl Default for TextScale {
    fn default() -> Self {
        TextScale(100)
    }
}

impl TextScale {
    /// The usual size times this.
    pub fn factor(self) -> f64 {
        f64::from(self.0) / 100.0
    }
}

impl TextScale {
    /// In hundredths of the usual size.
    pub fn hundredths(self) -> u16 {
        self.0
    }

    /// From 100 to 200 hundredths of the usual size; none for others.
    pub fn of_hundredths(hundredths: u16) -> Option<TextScale> {
        (100..=200)
            .contains(&hundredths)
            .then_some(TextScale(hundredths))
    }
}

impl FromStr for TextScale {
    type Err = FigureError;

    fn from_str(text: &str) -> Result<Self, FigureError> {
        let factor: Option<f64> = text.trim().parse().ok();
        let hundredths = factor.filter(|factor| (1.0..=2.0).contains(factor));
        hundredths
            // Between 100 and 200.
            .map(|factor| TextScale((factor * 100.0).round() as u16))
            .ok_or_else(|| FigureError::Value {
                option: "--text-scale",
                value: text.to_owned(),
                allowed: "a number from 1 to 2".to_owned(),
            })
    }
}

impl fmt::Display for TextScale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.factor())
    }
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
    /// Size of letters.
    pub text_scale: TextScale,
}

impl Style {
    /// The colours of roles.
    pub fn palette(&self) -> Palette {
        let paper = match self.background {
            Background::Colour(rgb) => Some(rgb),
            _ => None,
        };
        Palette {
            theme: self.theme,
            paper,
        }
    }
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
            text_scale: TextScale::default(),
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
        assert_eq!("640X480".parse(), Size::new(640, 480));
        assert_eq!("64x128".parse(), Size::new(64, 128));
        for (aspect, width, height) in [
            ("16:9", 1920, 1080),
            ("16:10", 1728, 1080),
            ("4:3", 1440, 1080),
            ("3:2", 1620, 1080),
            ("1:1", 1080, 1080),
            ("3:4", 1080, 1440),
            ("9:16", 1080, 1920),
            ("2:1", 2160, 1080),
            ("1:2", 1080, 2160),
            ("7:6", 1260, 1080),
            ("9:7", 1389, 1080),
            ("4294967295:4294967294", 1080, 1080),
        ] {
            assert_eq!(aspect.parse(), Size::new(width, height), "{aspect}");
        }
        for wrong in [
            "",
            "x",
            ":",
            "0:0",
            "0:1",
            "1:0",
            "16:",
            "16:9:1",
            "16.0:9",
            "-16:9",
            "21:9",
            "20001:10000",
            "99999999999:1",
            "1920",
            "1920x",
            "+64x64",
            "64x-64",
            "63x64",
            "64x16385",
            "16384x16384",
            "64x129",
            "2000x999",
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
            "english".parse::<Language>().unwrap_err().to_string(),
            "--lang cannot be 'english': it is one of en, it, cs, hr"
        );
        assert_eq!("EN".parse(), Ok(Language::En));
        assert_eq!("Dark".parse(), Ok(Theme::Dark));
        assert_eq!("SVG".parse(), Ok(Format::Svg));
        assert!("jpg".parse::<Format>().is_err());
        assert!("white".parse::<Background>().is_err());
    }
}
