//! Words of the rasterization lecture.

use super::Key;

words! {
    /// `raster/continuous-to-discrete` in lists.
    CONTINUOUS_TO_DISCRETE_SUMMARY {
        en: "A segment and a polygon, and the pixels that stand for them",
        it: "Un segmento e un poligono, e i pixel che li rappresentano",
        cs: "Úsečka a polygon a pixely, které je zastupují",
        hr: "Dužina i poligon te pikseli koji ih predstavljaju",
    }

    /// `raster/continuous-to-discrete` below the figure.
    CONTINUOUS_TO_DISCRETE_CAPTION {
        en: "On the left, points of the plane; on the right, pixels: samples at whole places, without a size of their own.",
        it: "A sinistra punti del piano, a destra pixel: campioni in posizioni intere, senza dimensione propria.",
        cs: "Vlevo body roviny, vpravo pixely: vzorky v celočíselných místech, bez vlastní velikosti.",
        hr: "Lijevo točke ravnine, desno pikseli: uzorci na cjelobrojnim mjestima, bez vlastite veličine.",
    }

    /// `raster/continuous-to-discrete`: the first picture.
    CONTINUOUS {
        en: "continuous",
        it: "continuo",
        cs: "spojité",
        hr: "kontinuirano",
    }

    /// `raster/continuous-to-discrete`: the second picture.
    DISCRETE {
        en: "discrete: pixels",
        it: "discreto: pixel",
        cs: "diskrétní: pixely",
        hr: "diskretno: pikseli",
    }

    /// `raster/segment-slopes` in lists.
    SEGMENT_SLOPES_SUMMARY {
        en: "Gentle segments have a pixel a column, steep ones a pixel a row",
        it: "Un pixel per colonna nei segmenti poco inclinati, uno per riga in quelli ripidi",
        cs: "Pozvolné úsečky mají pixel v každém sloupci, strmé v každém řádku",
        hr: "Blage dužine imaju piksel u svakom stupcu, strme u svakom retku",
    }

    /// `raster/segment-slopes` below the figure.
    SEGMENT_SLOPES_CAPTION {
        en: "One step along the longer axis, one pixel: no gaps and no doubles.",
        it: "Un passo lungo l’asse maggiore, un pixel: niente buchi né doppioni.",
        cs: "Jeden krok podél delší osy, jeden pixel: žádné mezery ani dvojice.",
        hr: "Jedan korak uzduž dulje osi, jedan piksel: bez rupa i bez dvostrukih.",
    }

    /// `raster/segment-slopes`: the first picture.
    SLOPE_COLUMNS {
        en: "\\|*m*\\|\u{a0}≤\u{a0}1: a pixel a column",
        it: "\\|*m*\\|\u{a0}≤\u{a0}1: un pixel per colonna",
        cs: "\\|*m*\\|\u{a0}≤\u{a0}1: pixel v každém sloupci",
        hr: "\\|*m*\\|\u{a0}≤\u{a0}1: piksel u svakom stupcu",
    }

    /// `raster/segment-slopes`: the second picture.
    SLOPE_ROWS {
        en: "\\|*m*\\|\u{a0}>\u{a0}1: a pixel a row",
        it: "\\|*m*\\|\u{a0}>\u{a0}1: un pixel per riga",
        cs: "\\|*m*\\|\u{a0}>\u{a0}1: pixel v každém řádku",
        hr: "\\|*m*\\|\u{a0}>\u{a0}1: piksel u svakom retku",
    }

    /// `raster/dda-rounding` in lists.
    DDA_ROUNDING_SUMMARY {
        en: "DDA: the points of the line and the pixels they are rounded to",
        it: "DDA: i punti della retta e i pixel a cui si arrotondano",
        cs: "DDA: body přímky a pixely, na které se zaokrouhlí",
        hr: "DDA: točke pravca i pikseli na koje se zaokružuju",
    }

    /// `raster/dda-rounding` below the figure.
    DDA_ROUNDING_CAPTION {
        en: "*y*_{*i*+1} = *y*_i + *m* with *m* = 3/8. The nearest pixel is lit; the tie 3/2 goes to the lower one.",
        it: "*y*_{*i*+1} = *y*_i + *m* con *m* = 3/8. Si accende il pixel più vicino; la parità 3/2 va al più basso.",
        cs: "*y*_{*i*+1} = *y*_i + *m*, *m* = 3/8. Rozsvítí se nejbližší pixel; shoda 3/2 patří nižšímu.",
        hr: "*y*_{*i*+1} = *y*_i + *m*, *m* = 3/8. Pali se najbliži piksel; jednakost 3/2 ide nižem.",
    }

    /// One pixel.
    PIXEL {
        en: "pixel",
        it: "pixel",
        cs: "pixel",
        hr: "piksel",
    }

    /// Pixels after their number, five or more or none.
    PIXELS_OF {
        en: "pixels",
        it: "pixel",
        cs: "pixelů",
        hr: "piksela",
    }

    /// `raster/bresenham-choice` in lists.
    BRESENHAM_CHOICE_SUMMARY {
        en: "Bresenham: E or NE, by the side of the midpoint on which the line passes",
        it: "Bresenham: E o NE, secondo il lato del punto di mezzo da cui passa la retta",
        cs: "Bresenham: E nebo NE podle toho, kde přímka míjí prostřední bod",
        hr: "Bresenham: E ili NE, prema tome s koje strane polovišta prolazi pravac",
    }

    /// `raster/bresenham-choice` below the figure.
    BRESENHAM_CHOICE_CAPTION {
        en: "*Q* below *M*: E is nearer. *Q* above *M*: NE is nearer. For *d* = 0 both are equally near, and E is taken.",
        it: "*Q* sotto *M*: è più vicino E. *Q* sopra *M*: è più vicino NE. Con *d* = 0 è indifferente, e si prende E.",
        cs: "*Q* pod *M*: blíž je E. *Q* nad *M*: blíž je NE. Při *d* = 0 jsou stejně daleko a bere se E.",
        hr: "*Q* ispod *M*: bliži je E. *Q* iznad *M*: bliži je NE. Za *d* = 0 jednako su daleko i uzima se E.",
    }

    /// `raster/bresenham-increments` in lists.
    BRESENHAM_INCREMENTS_SUMMARY {
        en: "Bresenham: the next midpoint after E and after NE",
        it: "Bresenham: il punto di mezzo successivo dopo E e dopo NE",
        cs: "Bresenham: další prostřední bod po E a po NE",
        hr: "Bresenham: sljedeće polovište nakon E i nakon NE",
    }

    /// `raster/bresenham-increments` below the figure.
    BRESENHAM_INCREMENTS_CAPTION {
        en: "The decision at the next midpoint *M*′ is an addition away: *dy* after E, *dy* − *dx* after NE.",
        it: "La decisione nel punto di mezzo successivo *M*′ costa un’addizione: *dy* dopo E, *dy* − *dx* dopo NE.",
        cs: "K rozhodnutí v dalším prostředním bodě *M*′ stačí sčítání: *dy* po E, *dy* − *dx* po NE.",
        hr: "Do odluke u sljedećem polovištu *M*′ dovoljno je zbrajanje: *dy* nakon E, *dy* − *dx* nakon NE.",
    }

    /// After a choice: before its name.
    AFTER {
        en: "after",
        it: "dopo",
        cs: "po",
        hr: "nakon",
    }

    /// `raster/bresenham-trace` in lists.
    BRESENHAM_TRACE_SUMMARY {
        en: "Bresenham: a whole segment with the decision of every move",
        it: "Bresenham: un intero segmento con la decisione di ogni passo",
        cs: "Bresenham: celá úsečka s rozhodnutím v každém kroku",
        hr: "Bresenham: cijela dužina s odlukom u svakom koraku",
    }

    /// `raster/bresenham-trace` below the figure.
    BRESENHAM_TRACE_CAPTION {
        en: "2*F* is an integer: 2*dy* − *dx* = −2 at the start, + 6 after E, − 10 after NE. Above 0 the next pixel is NE, else E.",
        it: "2*F* è intero: 2*dy* − *dx* = −2 all’inizio, + 6 dopo E, − 10 dopo NE. Se è positivo si va a NE, altrimenti a E.",
        cs: "2*F* je celé číslo: na začátku 2*dy* − *dx* = −2, + 6 po E, − 10 po NE. Je-li kladné, následuje NE, jinak E.",
        hr: "2*F* je cijeli broj: na početku 2*dy* − *dx* = −2, + 6 nakon E, − 10 nakon NE. Ako je pozitivan, slijedi NE, inače E.",
    }

    /// `raster/rectangle` in lists.
    RECTANGLE_SUMMARY {
        en: "A rectangle along the axes, its outline and filled",
        it: "Un rettangolo parallelo agli assi, vuoto e pieno",
        cs: "Obdélník rovnoběžný s osami, obrys a výplň",
        hr: "Pravokutnik usporedan s osima, obris i ispuna",
    }

    /// `raster/rectangle` below the figure.
    RECTANGLE_CAPTION {
        en: "Both corners are pixels of the rectangle: columns 1 to 5 are five columns, not four.",
        it: "I due vertici sono pixel del rettangolo: le colonne da 1 a 5 sono cinque, non quattro.",
        cs: "Oba rohy jsou pixely obdélníku: sloupce 1 až 5 jsou pět sloupců, ne čtyři.",
        hr: "Oba su kuta pikseli pravokutnika: od stupca 1 do 5 ima ih pet, a ne četiri.",
    }

    /// `raster/rectangle`: the first picture.
    RECTANGLE_OUTLINE {
        en: "outline",
        it: "vuoto",
        cs: "obrys",
        hr: "obris",
    }

    /// `raster/rectangle`: the second picture.
    RECTANGLE_FILLED {
        en: "filled",
        it: "pieno",
        cs: "výplň",
        hr: "ispuna",
    }

    /// `raster/polygon-kinds` in lists.
    POLYGON_KINDS_SUMMARY {
        en: "Four kinds of polygon under the even-odd and the non-zero rule",
        it: "Quattro tipi di poligono con la regola pari-dispari e con quella non-zero",
        cs: "Čtyři druhy polygonů podle pravidla sudá-lichá a nenulového pravidla",
        hr: "Četiri vrste poligona po pravilu par-nepar i po pravilu različito od nule",
    }

    /// `raster/polygon-kinds` below the figure.
    POLYGON_KINDS_CAPTION {
        en: "Inside is what the contours wind round an odd number of times, or a number of times other than 0. Arrows show the direction.",
        it: "È interno ciò attorno a cui i contorni girano un numero dispari di volte, o non zero volte. Le frecce dicono il verso.",
        cs: "Uvnitř je to, co obrysy obíhají lichým počtem otočení, nebo nenulovým. Šipky udávají směr.",
        hr: "Unutra je ono što konture obilaze neparan broj puta, ili broj puta različit od nule. Strelice pokazuju smjer.",
    }

    /// The rule of odd winding numbers.
    EVEN_ODD {
        en: "even-odd",
        it: "pari-dispari",
        cs: "sudá-lichá",
        hr: "par-nepar",
    }

    /// The rule of winding numbers that are not 0.
    NON_ZERO {
        en: "non-zero",
        it: "non-zero",
        cs: "nenulová",
        hr: "različito od nule",
    }

    /// `raster/polygon-kinds`: the first kind.
    KIND_CONVEX {
        en: "convex",
        it: "convesso",
        cs: "konvexní",
        hr: "konveksan",
    }

    /// `raster/polygon-kinds`: the second kind.
    KIND_CONCAVE {
        en: "concave",
        it: "concavo",
        cs: "nekonvexní",
        hr: "konkavan",
    }

    /// `raster/polygon-kinds`: the third kind.
    KIND_CROSSED {
        en: "self-crossing",
        it: "intrecciato",
        cs: "překřížený",
        hr: "samosijekući",
    }

    /// `raster/polygon-kinds`: the fourth kind.
    KIND_SEVERAL {
        en: "several contours",
        it: "a contorni multipli",
        cs: "více obrysů",
        hr: "više kontura",
    }

    /// `raster/scanline` in lists.
    SCANLINE_SUMMARY {
        en: "One scan line: edge table, active edges and the spans between them",
        it: "Una scan-line: tabella dei lati, lati attivi e gli intervalli tra loro",
        cs: "Jeden řádek: tabulka hran, aktivní hrany a úseky mezi nimi",
        hr: "Jedan redak: tablica bridova, aktivni bridovi i rasponi među njima",
    }

    /// `raster/scanline` below the figure.
    SCANLINE_CAPTION {
        en: "The active edges cross the row at the places *X*. Between the first and the second, the third and the fourth, centres are inside.",
        it: "I lati attivi incrociano la riga nei punti *X*. Tra il primo e il secondo, tra il terzo e il quarto, i centri sono interni.",
        cs: "Aktivní hrany protínají řádek v místech *X*. Mezi prvním a druhým, třetím a čtvrtým leží středy uvnitř.",
        hr: "Aktivni bridovi sijeku redak na mjestima *X*. Između prvog i drugog, trećeg i četvrtog središta su unutra.",
    }

    /// Heading of the edge table.
    SCAN_EDGE {
        en: "edge",
        it: "lato",
        cs: "hrana",
        hr: "brid",
    }

    /// Heading of the edge table: where an edge begins and ends.
    SCAN_ROWS {
        en: "rows",
        it: "righe",
        cs: "řádky",
        hr: "redci",
    }

    /// `raster/triangle-shared-edge` in lists.
    SHARED_EDGE_SUMMARY {
        en: "Two triangles with a common edge: one owner a pixel, and what comes without the rule",
        it: "Due triangoli con un lato comune: un solo proprietario per pixel, e che cosa succede senza regola",
        cs: "Dva trojúhelníky se společnou hranou: každý pixel má jednoho vlastníka, a co nastane bez pravidla",
        hr: "Dva trokuta sa zajedničkim bridom: svaki piksel ima jednog vlasnika, i što biva bez pravila",
    }

    /// `raster/triangle-shared-edge` below the figure.
    SHARED_EDGE_CAPTION {
        en: "The edge runs through six centres. A centre on an edge belongs to the triangle for which the edge is a top or a left one.",
        it: "Il lato passa per sei centri. Un centro su un lato appartiene al triangolo per cui quel lato è in alto o a sinistra.",
        cs: "Hrana prochází šesti středy. Střed na hraně patří trojúhelníku, pro který je hrana horní nebo levá.",
        hr: "Brid prolazi kroz šest središta. Središte na bridu pripada trokutu kojemu je taj brid gornji ili lijevi.",
    }

    /// `raster/triangle-shared-edge`: the first picture.
    SHARED_TOP_LEFT {
        en: "top-left rule: one owner each",
        it: "alto-sinistra: un solo proprietario",
        cs: "vlevo-nahoře: jeden vlastník",
        hr: "gore-lijevo: jedan vlasnik",
    }

    /// `raster/triangle-shared-edge`: the second picture.
    SHARED_CLOSED {
        en: "edges inside: drawn twice",
        it: "lati compresi: disegnati due volte",
        cs: "hrany uvnitř: kresleno dvakrát",
        hr: "bridovi unutra: crtano dvaput",
    }

    /// `raster/triangle-shared-edge`: the third picture.
    SHARED_OPEN {
        en: "edges outside: gaps",
        it: "lati esclusi: buchi",
        cs: "hrany venku: mezery",
        hr: "bridovi izvan: rupe",
    }

    /// `raster/sliver` in lists.
    SLIVER_SUMMARY {
        en: "A long thin triangle: pixels found against area",
        it: "Un triangolo stretto e lungo: pixel trovati e area",
        cs: "Dlouhý úzký trojúhelník: nalezené pixely a obsah",
        hr: "Dug i uzak trokut: nađeni pikseli i površina",
    }

    /// `raster/sliver` below the figure.
    SLIVER_CAPTION {
        en: "The same triangle three times, each time an eighth of a pixel lower. Only centres count, so its pixels depend on where it lies.",
        it: "Lo stesso triangolo tre volte, ogni volta un ottavo di pixel più in basso. Contano solo i centri: i pixel dipendono da dove sta.",
        cs: "Týž trojúhelník třikrát, pokaždé o osminu pixelu níž. Počítají se jen středy, a tak pixely závisejí na jeho poloze.",
        hr: "Isti trokut tri puta, svaki put za osminu piksela niže. Broje se samo središta, pa pikseli ovise o tome gdje leži.",
    }

    /// Before an area.
    AREA {
        en: "area",
        it: "area",
        cs: "obsah",
        hr: "površina",
    }
}
