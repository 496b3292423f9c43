//! Words of the gallery.

use super::Key;

words! {
    /// Heading of the gallery.
    GALLERY_TITLE {
        en: "Figures",
        it: "Figure",
        cs: "Obrázky",
        hr: "Slike",
    }

    /// The licence of the figures, said in the gallery.
    GALLERY_LICENCE {
        en: "Free to use in slides (CC0 1.0).",
        it: "Di libero uso nelle slide (CC0 1.0).",
        cs: "Volně k použití v prezentacích (CC0 1.0).",
        hr: "Slobodno za upotrebu u prezentacijama (CC0 1.0).",
    }
}
