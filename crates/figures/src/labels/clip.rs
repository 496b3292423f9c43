//! Words of the clipping lecture.

use super::Key;

words! {
    /// `clip/point-window` in lists.
    POINT_WINDOW_SUMMARY {
        en: "A point and the window: four inequalities",
        it: "Un punto e il rettangolo di clipping: quattro disuguaglianze",
        cs: "Bod a okno: čtyři nerovnosti",
        hr: "Točka i prozor: četiri nejednakosti",
    }

    /// `clip/point-window` below the figure.
    POINT_WINDOW_CAPTION {
        en: "A point is inside when all four hold; the border belongs to the window.",
        it: "Un punto è interno se valgono tutte e quattro; il bordo appartiene al rettangolo.",
        cs: "Bod leží uvnitř, platí-li všechny čtyři; hranice patří k oknu.",
        hr: "Točka je unutra ako vrijede sve četiri; rub pripada prozoru.",
    }

    /// `clip/segment-cases` in lists.
    SEGMENT_CASES_SUMMARY {
        en: "Where the ends of a segment can lie, and what is kept of it",
        it: "Dove possono stare gli estremi di un segmento e che cosa ne resta",
        cs: "Kde mohou ležet konce úsečky a co z ní zůstane",
        hr: "Gdje mogu ležati krajevi dužine i što od nje ostaje",
    }

    /// `clip/segment-cases` below the figure.
    SEGMENT_CASES_CAPTION {
        en: "*G*′ and *H*′ lie on sides of the window; *I*′ and *J*′ only on the lines through them: nothing of *IJ* is kept.",
        it: "*G*′ e *H*′ stanno sui lati del rettangolo; *I*′ e *J*′ solo sulle rette su cui giacciono i lati: di *IJ* non resta nulla.",
        cs: "*G*′ a *H*′ leží na stranách okna; *I*′ a *J*′ jen na přímkách stran: z *IJ* nezůstane nic.",
        hr: "*G*′ i *H*′ leže na stranicama prozora; *I*′ i *J*′ samo na pravcima stranica: od *IJ* ne ostaje ništa.",
    }

    /// `clip/outcodes` in lists.
    OUTCODES_SUMMARY {
        en: "The nine regions around a window and their codes",
        it: "Le nove regioni intorno al rettangolo di clipping e i loro codici",
        cs: "Devět oblastí kolem okna a jejich kódy",
        hr: "Devet područja oko prozora i njihovi kodovi",
    }

    /// `clip/outcodes` below the figure.
    OUTCODES_CAPTION {
        en: "Each bit stands for one side: 1 where a point lies beyond it. Inside all are 0.",
        it: "Ogni bit sta per un lato: 1 dove il punto è oltre. All’interno sono tutti 0.",
        cs: "Každý bit patří jedné straně: 1, leží-li bod za ní. Uvnitř jsou všechny 0.",
        hr: "Svaki bit pripada jednoj stranici: 1 ako je točka iza nje. Unutra su svi 0.",
    }

    /// A digit of an outcode.
    BIT {
        en: "bit",
        it: "bit",
        cs: "bit",
        hr: "bit",
    }

    /// `clip/cohen-sutherland-steps` in lists.
    COHEN_SUTHERLAND_SUMMARY {
        en: "Cohen–Sutherland: a segment cut twice, with its codes at every step",
        it: "Cohen–Sutherland: un segmento tagliato due volte, con i codici a ogni passo",
        cs: "Cohen–Sutherland: úsečka dvakrát oříznutá, s kódy v každém kroku",
        hr: "Cohen–Sutherland: dužina dvaput odsječena, s kodovima u svakom koraku",
    }

    /// `clip/cohen-sutherland-steps` below the figure.
    COHEN_SUTHERLAND_CAPTION {
        en: "OR = 0000 accepts, AND ≠ 0000 rejects. Otherwise the first bit that differs says where to cut, and both are tested again.",
        it: "OR = 0000 accetta, AND ≠ 0000 rifiuta. Altrimenti il primo bit discordante dice dove tagliare, e si ripetono i due test.",
        cs: "OR = 0000 přijímá, AND ≠ 0000 zamítá. Jinak první odlišný bit určí řez a oba testy se opakují.",
        hr: "OR = 0000 prihvaća, AND ≠ 0000 odbacuje. Inače prvi različiti bit kaže gdje rezati i obje se provjere ponavljaju.",
    }

    /// Cohen–Sutherland: the segment is inside.
    ACCEPT {
        en: "accepted",
        it: "accettato",
        cs: "přijato",
        hr: "prihvaćeno",
    }

    /// Cohen–Sutherland: the segment is outside.
    REJECT {
        en: "rejected",
        it: "rifiutato",
        cs: "zamítnuto",
        hr: "odbačeno",
    }

    /// Cohen–Sutherland: before the line that cuts.
    CUT_AT {
        en: "cut at",
        it: "taglio a",
        cs: "řez na",
        hr: "rez na",
    }

    /// `clip/sutherland-hodgman-steps` in lists.
    SUTHERLAND_HODGMAN_SUMMARY {
        en: "Sutherland–Hodgman: a concave polygon after each of the four lines",
        it: "Sutherland–Hodgman: un poligono concavo dopo ognuna delle quattro rette",
        cs: "Sutherland–Hodgman: nekonvexní polygon po každé ze čtyř přímek",
        hr: "Sutherland–Hodgman: konkavni poligon nakon svakog od četiri pravca",
    }

    /// `clip/sutherland-hodgman-steps` below the figure.
    SUTHERLAND_HODGMAN_CAPTION {
        en: "Each line keeps what lies on its inner side; what is left goes on to the next.",
        it: "Ogni retta conserva ciò che sta dalla sua parte interna; ciò che resta passa alla successiva.",
        cs: "Každá přímka ponechá, co leží na její vnitřní straně; zbytek jde k další.",
        hr: "Svaki pravac zadržava što je na njegovoj unutarnjoj strani; ostatak ide na sljedeći.",
    }

    /// `clip/polygon-cases` in lists.
    POLYGON_CASES_SUMMARY {
        en: "What clipping makes of a polygon: one, several pieces, always closed",
        it: "Che cosa diventa un poligono: uno, più componenti, sempre chiusi",
        cs: "Co se stane s polygonem: jeden, více částí, vždy uzavřené",
        hr: "Što postaje od poligona: jedan, više dijelova, uvijek zatvoreni",
    }

    /// `clip/polygon-cases` below the figure.
    POLYGON_CASES_CAPTION {
        en: "A bridge edge runs back and forth along the border between two pieces. In C the thick edges alone would be loose; the border closes them.",
        it: "Un lato ponte percorre il bordo avanti e indietro tra due componenti. In C i lati spessi da soli sarebbero sconnessi; il bordo li chiude.",
        cs: "Spojovací hrana běží mezi dvěma částmi po hranici tam a zpět. V C by samy tlusté hrany byly volné; uzavírá je hranice.",
        hr: "Spojni brid ide rubom između dvaju dijelova naprijed i natrag. U C bi sami debeli bridovi bili slobodni; rub ih zatvara.",
    }

    /// `clip/polygon-cases`: the first picture.
    CASE_CONVEX {
        en: "A convex: one polygon",
        it: "A convesso: un poligono",
        cs: "A konvexní: jeden polygon",
        hr: "A konveksan: jedan poligon",
    }

    /// `clip/polygon-cases`: the second picture.
    CASE_BRIDGES {
        en: "B concave: a bridge edge",
        it: "B concavo: un lato ponte",
        cs: "B nekonvexní: spojovací hrana",
        hr: "B konkavan: spojni brid",
    }

    /// `clip/polygon-cases`: the third picture.
    CASE_PIECES {
        en: "B: separate pieces",
        it: "B: componenti separate",
        cs: "B: oddělené části",
        hr: "B: odvojeni dijelovi",
    }

    /// `clip/polygon-cases`: the fourth picture.
    CASE_CLOSED {
        en: "C: a closed polygon",
        it: "C: un poligono chiuso",
        cs: "C: uzavřený obrys",
        hr: "C: zatvoren poligon",
    }
}
