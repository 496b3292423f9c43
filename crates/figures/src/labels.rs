//! Every word in the figures, in the four languages of the lectures.
//!
//! The matches are exhaustive: a missing translation does not compile. The terms are the lectures' own (Italian:
//! Grafica 3 and Bologna; Czech: Olomouc; Croatian: Croatian 8.4; English: CIS 781).

use crate::style::Language;

/// A word or sentence in the markup of [`crate::text`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Key {
    /// Heading of the gallery.
    GalleryTitle,
    /// The licence of the figures, said in the gallery.
    GalleryLicence,
    /// `shadows/cube-infinity` in lists.
    CubeInfinitySummary,
    /// `shadows/cube-infinity` below the figure.
    CubeInfinityCaption,
}

impl Key {
    /// Every key there is, for tests.
    pub const ALL: &'static [Key] = &[
        Key::GalleryTitle,
        Key::GalleryLicence,
        Key::CubeInfinitySummary,
        Key::CubeInfinityCaption,
    ];

    /// Its words.
    pub const fn text(self, language: Language) -> &'static str {
        use Language::{Cs, En, Hr, It};
        match (self, language) {
            (Key::GalleryTitle, En) => "Figures",
            (Key::GalleryTitle, It) => "Figure",
            (Key::GalleryTitle, Cs) => "Obrázky",
            (Key::GalleryTitle, Hr) => "Slike",

            (Key::GalleryLicence, En) => "Free to use in slides (CC0 1.0).",
            (Key::GalleryLicence, It) => "Di libero uso nelle slide (CC0 1.0).",
            (Key::GalleryLicence, Cs) => "Volně k použití v prezentacích (CC0 1.0).",
            (Key::GalleryLicence, Hr) => "Slobodno za upotrebu u prezentacijama (CC0 1.0).",

            (Key::CubeInfinitySummary, En) => {
                "A cube under a light at infinity, its shadow with exact coordinates"
            }
            (Key::CubeInfinitySummary, It) => {
                "Un cubo sotto una luce all'infinito, la sua ombra con le coordinate esatte"
            }
            (Key::CubeInfinitySummary, Cs) => {
                "Krychle a zdroj v nekonečnu, její stín s přesnými souřadnicemi"
            }
            (Key::CubeInfinitySummary, Hr) => {
                "Kocka i izvor u beskonačnosti, njezina sjena s točnim koordinatama"
            }

            (Key::CubeInfinityCaption, En) => {
                "Light at infinity: every vertex moves along the same direction **L** onto the plane."
            }
            (Key::CubeInfinityCaption, It) => {
                "Luce all'infinito: ogni vertice si sposta lungo la stessa direzione **L** fino al piano."
            }
            (Key::CubeInfinityCaption, Cs) => {
                "Zdroj v nekonečnu: každý vrchol se posune týmž směrem **L** do roviny."
            }
            (Key::CubeInfinityCaption, Hr) => {
                "Izvor u beskonačnosti: svaki se vrh pomiče istim smjerom **L** do ravnine."
            }
        }
    }
}
