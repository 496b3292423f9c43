//! Words of the mathematics that all lectures share.

use super::Key;

words! {
    /// `math/plane` in lists.
    MATH_PLANE_SUMMARY {
        en: "A plane by a point and its normal, and how far a point is from it",
        it: "Un piano dato da un punto e dalla normale, e la distanza di un punto",
        cs: "Rovina daná bodem a normálou a vzdálenost bodu od ní",
        hr: "Ravnina zadana točkom i normalom te udaljenost točke od nje",
    }

    /// `math/plane` below the figure.
    MATH_PLANE_CAPTION {
        en: "**n** is perpendicular to the plane, *Q* lies on it: *d* = −**n**·*Q*. In front of the plane the distance is positive.",
        it: "**n** è perpendicolare al piano, *Q* vi giace: *d* = −**n**·*Q*. Davanti al piano la distanza è positiva.",
        cs: "**n** je kolmé k rovině, *Q* v ní leží: *d* = −**n**·*Q*. Před rovinou je vzdálenost kladná.",
        hr: "**n** je okomit na ravninu, *Q* leži u njoj: *d* = −**n**·*Q*. Ispred ravnine udaljenost je pozitivna.",
    }

    /// `math/spherical` in lists.
    MATH_SPHERICAL_SUMMARY {
        en: "Spherical coordinates and a solid angle",
        it: "Coordinate sferiche e un angolo solido",
        cs: "Sférické souřadnice a prostorový úhel",
        hr: "Sferne koordinate i prostorni kut",
    }

    /// `math/spherical` below the figure.
    MATH_SPHERICAL_CAPTION {
        en: "*θ* is measured from the pole, *φ* from *x* towards *y*. The patch of the unit sphere is the solid angle d*ω*.",
        it: "*θ* si misura dal polo, *φ* da *x* verso *y*. La porzione di sfera unitaria è l’angolo solido d*ω*.",
        cs: "*θ* se měří od pólu, *φ* od *x* k *y*. Ploška na jednotkové kouli je prostorový úhel d*ω*.",
        hr: "*θ* se mjeri od pola, *φ* od *x* prema *y*. Djelić jedinične sfere prostorni je kut d*ω*.",
    }

    /// `math/frustum` in lists.
    MATH_FRUSTUM_SUMMARY {
        en: "The view frustum and the cube it becomes",
        it: "Il volume di vista e il cubo che diventa",
        cs: "Pohledový objem a krychle, kterou se stane",
        hr: "Volumen pogleda i kocka u koju prelazi",
    }

    /// `math/frustum` below the figure.
    MATH_FRUSTUM_CAPTION {
        en: "The plane *z* = −2*fn* / (*f* + *n*) comes to the middle of the cube: half of all depths lies before it.",
        it: "Il piano *z* = −2*fn* / (*f* + *n*) arriva al centro del cubo: metà delle profondità sta davanti.",
        cs: "Rovina *z* = −2*fn* / (*f* + *n*) přejde do středu krychle: polovina všech hloubek leží před ní.",
        hr: "Ravnina *z* = −2*fn* / (*f* + *n*) dolazi u sredinu kocke: polovica svih dubina leži ispred nje.",
    }

    /// `math/frustum`: the first picture.
    FRUSTUM_BEFORE {
        en: "What the eye sees along\u{a0}−*z*",
        it: "Ciò che l’occhio vede lungo\u{a0}−*z*",
        cs: "Co vidí oko ve směru −*z*",
        hr: "Što oko vidi uzduž −*z*",
    }

    /// `math/frustum`: the second picture.
    FRUSTUM_AFTER {
        en: "After the matrix and the division by\u{a0}*w*",
        it: "Dopo la matrice e la divisione per\u{a0}*w*",
        cs: "Po násobení maticí a dělení\u{a0}*w*",
        hr: "Nakon matrice i dijeljenja s\u{a0}*w*",
    }
}
