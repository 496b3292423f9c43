//! Words of the hidden surfaces lecture.

use super::Key;

words! {
    /// `hsr/object-space-pairs` in lists.
    PAIRS_SUMMARY {
        en: "Two primitives: one hides the other, both are visible, one hides part of the other",
        it: "Due primitive: una oscura l’altra, entrambe visibili, una occlude parzialmente l’altra",
        cs: "Dvě plochy: jedna zakrývá druhou, obě jsou viditelné, jedna zakrývá část druhé",
        hr: "Dva poligona: jedan zaklanja drugi, oba su vidljiva, jedan zaklanja dio drugoga",
    }

    /// `hsr/object-space-pairs` below the figure.
    PAIRS_CAPTION {
        en: "Above what the eye sees, below the same from above. What lies in the pyramid behind *A* is hidden; what is left of *B* is cut into convex parts.",
        it: "In alto ciò che vede l’osservatore, in basso la pianta. Ciò che sta nella piramide dietro *A* è oscurato; ciò che resta di *B* si divide in parti convesse.",
        cs: "Nahoře to, co vidí pozorovatel, dole půdorys. Co leží v jehlanu za *A*, je zakryté; zbytek *B* se rozdělí na konvexní části.",
        hr: "Gore ono što vidi oko, dolje tlocrt. Što leži u piramidi iza *A*, zaklonjeno je; ostatak od *B* dijeli se na konveksne dijelove.",
    }

    /// The first panel.
    PAIRS_HIDDEN {
        en: "*A* hides *B*",
        it: "*A* oscura *B*",
        cs: "*A* zakrývá *B*",
        hr: "*A* zaklanja *B*",
    }

    /// The second panel.
    PAIRS_BOTH {
        en: "*A* and *B* are visible",
        it: "*A* e *B* visibili",
        cs: "*A* i *B* jsou viditelné",
        hr: "*A* i *B* su vidljivi",
    }

    /// The third panel.
    PAIRS_PART {
        en: "*A* hides part of *B*",
        it: "*A* occlude parte di *B*",
        cs: "*A* zakrývá část *B*",
        hr: "*A* zaklanja dio *B*",
    }

    /// `hsr/image-space-ray` in lists.
    IMAGE_RAY_SUMMARY {
        en: "A ray through a pixel: its hits, the nearest one, and a plane met beside its primitive",
        it: "Una semiretta per un pixel: le intersezioni, la più vicina e un piano colpito fuori della sua primitiva",
        cs: "Paprsek pixelem: jeho průsečíky, nejbližší z nich a rovina protnutá vedle své plochy",
        hr: "Zraka kroz piksel: njezini pogoci, najbliži od njih i ravnina pogođena pokraj svojeg poligona",
    }

    /// `hsr/image-space-ray` below the figure.
    IMAGE_RAY_CAPTION {
        en: "The pixel gets the primitive at the nearest hit. The plane of *C* is met sooner, but outside *C*: that does not count.",
        it: "Il pixel riceve la primitiva dell’intersezione più vicina. Il piano di *C* viene prima, ma fuori di *C*: non conta.",
        cs: "Pixel dostane plochu nejbližšího průsečíku. Rovinu plochy *C* paprsek protne dřív, ale mimo *C*: to se nepočítá.",
        hr: "Piksel dobiva poligon najbližeg pogotka. Ravninu od *C* zraka pogađa prije, ali izvan *C*: to se ne računa.",
    }

    /// The ray meets a plane outside its primitive.
    IMAGE_RAY_OUTSIDE {
        en: "outside *C*",
        it: "fuori di *C*",
        cs: "mimo *C*",
        hr: "izvan *C*",
    }

    /// `hsr/painter-steps` in lists.
    PAINTER_STEPS_SUMMARY {
        en: "The painter’s algorithm: four primitives from back to front",
        it: "L’algoritmo del pittore: quattro primitive dalla più lontana alla più vicina",
        cs: "Malířův algoritmus: čtyři plochy odzadu dopředu",
        hr: "Slikarev algoritam: četiri poligona odostraga prema naprijed",
    }

    /// `hsr/painter-steps` below the figure.
    PAINTER_STEPS_CAPTION {
        en: "The farthest first; each covers what it hides of those painted before.",
        it: "Prima la più lontana; ognuna copre ciò che oscura di quelle già dipinte.",
        cs: "Nejdřív nejvzdálenější; každá překryje, co zakrývá z dříve namalovaných.",
        hr: "Najprije najdalji; svaki prekriva ono što zaklanja od već naslikanih.",
    }

    /// After the name of the first that is painted.
    PAINTER_FARTHEST {
        en: ", the farthest",
        it: ", la più lontana",
        cs: ", nejvzdálenější",
        hr: ", najdalji",
    }

    /// Before the name of one in between.
    PAINTER_THEN {
        en: "then",
        it: "poi",
        cs: "pak",
        hr: "zatim",
    }

    /// After the name of the last.
    PAINTER_NEAREST {
        en: ", the nearest",
        it: ", la più vicina",
        cs: ", nejbližší",
        hr: ", najbliži",
    }

    /// `hsr/painter-cycle` in lists.
    PAINTER_CYCLE_SUMMARY {
        en: "Three sticks, each over the next: no order, and an order after cutting one of them",
        it: "Tre aste, ognuna sopra la seguente: nessun ordine, e un ordine dopo averne tagliata una",
        cs: "Tři tyče, každá přes další: žádné pořadí, a pořadí po rozříznutí jedné z nich",
        hr: "Tri štapa, svaki preko sljedećeg: nema poretka, a ima ga kad se jedan prereže",
    }

    /// `hsr/painter-cycle` below the figure.
    PAINTER_CYCLE_CAPTION {
        en: "Whichever is painted first hides nothing, yet each must hide one. One is cut by the plane of another, and its two pieces find their places.",
        it: "La prima dipinta non copre nulla, eppure ognuna deve coprirne una. Una si taglia con il piano di un’altra, e i suoi due pezzi trovano posto.",
        cs: "Tyč namalovaná jako první nezakryje nic, a přece má každá jednu zakrýt. Jedna se rozřízne rovinou jiné a její dva díly najdou své místo.",
        hr: "Štap naslikan prvi ne zaklanja ništa, a svaki mora zakloniti jedan. Jedan se reže ravninom drugoga i njegova dva dijela nađu svoje mjesto.",
    }

    /// One stick hides part of another.
    PAINTER_HIDES {
        en: "hides",
        it: "oscura",
        cs: "zakrývá",
        hr: "zaklanja",
    }

    /// What happens to a stick, before the numbers of the pieces in order.
    PAINTER_CUT {
        en: "is cut in two; order",
        it: "tagliata in due; ordine",
        cs: "rozříznuta na dvě; pořadí",
        hr: "prerezan nadvoje; poredak",
    }

    /// `hsr/back-face` in lists.
    BACK_FACE_SUMMARY {
        en: "A solid cut across, the normals of its faces and the vectors to the eye: kept and culled faces",
        it: "Un solido in sezione, le normali delle facce e i vettori verso l’osservatore: facce tenute ed eliminate",
        cs: "Řez tělesem, normály stěn a vektory k pozorovateli: ponechané a vyřazené stěny",
        hr: "Presjek tijela, normale stranica i vektori prema oku: zadržane i odbačene stranice",
    }

    /// `hsr/back-face` below the figure.
    BACK_FACE_CAPTION {
        en: "**n** looks out of the solid, **v** from the face towards the eye. With **n**·**v** < 0 a face is turned away and certainly hidden.",
        it: "**n** esce dal solido, **v** va dalla faccia verso l’osservatore. Con **n**·**v** < 0 la faccia è posteriore e certamente non visibile.",
        cs: "**n** míří ven z tělesa, **v** od stěny k pozorovateli. Při **n**·**v** < 0 je stěna odvrácená a jistě není vidět.",
        hr: "**n** gleda iz tijela, **v** od stranice prema oku. Uz **n**·**v** < 0 stranica je okrenuta od oka i sigurno se ne vidi.",
    }

    /// What becomes of a face that may be seen.
    BACK_FACE_KEPT {
        en: "kept",
        it: "tenuta",
        cs: "ponechaná",
        hr: "zadržana",
    }

    /// What becomes of a face that is turned away.
    BACK_FACE_CULLED {
        en: "culled",
        it: "eliminata",
        cs: "vyřazená",
        hr: "odbačena",
    }

    /// `hsr/zbuffer-steps` in lists.
    ZBUFFER_STEPS_SUMMARY {
        en: "Z-buffer: colour and depth of every pixel after each triangle",
        it: "Z-buffer: colore e profondità di ogni pixel dopo ciascun triangolo",
        cs: "Z-buffer: barva a hloubka každého pixelu po každém trojúhelníku",
        hr: "Z-spremnik: boja i dubina svakog piksela nakon svakog trokuta",
    }

    /// `hsr/zbuffer-steps` below the figure.
    ZBUFFER_STEPS_CAPTION {
        en: "At first every depth is the greatest, 8. A fragment is written (marked) where it is nearer than what the pixel holds. The triangles may come in any order.",
        it: "All’inizio ogni profondità è la massima, 8. Un frammento è scritto (evidenziato) dove è più vicino di ciò che il pixel contiene. L’ordine dei triangoli è libero.",
        cs: "Na začátku je každá hloubka největší, 8. Fragment se zapíše (vyznačeno) tam, kde je blíže než to, co pixel obsahuje. Na pořadí trojúhelníků nezáleží.",
        hr: "Na početku je svaka dubina najveća, 8. Fragment se upisuje (označeno) gdje je bliži od onoga što piksel sadrži. Redoslijed trokuta nije važan.",
    }

    /// `hsr/zbuffer-steps`: the upper row.
    ZBUFFER_COLOUR {
        en: "colour",
        it: "colore",
        cs: "barva",
        hr: "boja",
    }

    /// `hsr/zbuffer-steps`: the lower row.
    ZBUFFER_DEPTH {
        en: "depth *z*",
        it: "profondità *z*",
        cs: "hloubka *z*",
        hr: "dubina *z*",
    }

    /// `hsr/zbuffer-steps`: the first step.
    ZBUFFER_CLEARED {
        en: "cleared",
        it: "all’inizio",
        cs: "na začátku",
        hr: "na početku",
    }

    /// `hsr/zbuffer-steps`: the second step.
    ZBUFFER_FIRST {
        en: "*A* is drawn",
        it: "si disegna *A*",
        cs: "kreslí se *A*",
        hr: "crta se *A*",
    }

    /// `hsr/zbuffer-steps`: the third step.
    ZBUFFER_CROSSING {
        en: "*B* crosses *A*",
        it: "*B* interseca *A*",
        cs: "*B* protíná *A*",
        hr: "*B* siječe *A*",
    }

    /// `hsr/zbuffer-steps`: the fourth step.
    ZBUFFER_BEHIND {
        en: "*C* lies behind",
        it: "*C* sta dietro",
        cs: "*C* leží vzadu",
        hr: "*C* je iza",
    }

    /// `hsr/depth-precision` in lists.
    DEPTH_PRECISION_SUMMARY {
        en: "Depth step against distance: 16 bits, 24 bits, single precision, and single precision reversed",
        it: "Passo di profondità e distanza: 16 bit, 24 bit, precisione singola, e precisione singola invertita",
        cs: "Krok hloubky podle vzdálenosti: 16 bitů, 24 bitů, jednoduchá přesnost a jednoduchá přesnost obráceně",
        hr: "Korak dubine prema udaljenosti: 16 bitova, 24 bita, jednostruka preciznost i obrnuta jednostruka preciznost",
    }

    /// `hsr/depth-precision` below the figure.
    DEPTH_PRECISION_CAPTION {
        en: "Surfaces nearer to each other than the step may get the same depth. Lines are the formula, marks are measured; reversed, 1\u{a0}−\u{a0}*d* is stored.",
        it: "Superfici più vicine tra loro del passo possono avere la stessa profondità. Linee: formula; segni: misure; invertito, si memorizza 1\u{a0}−\u{a0}*d*.",
        cs: "Plochy bližší k sobě než krok mohou mít stejnou hloubku. Čáry jsou vzorec, značky měření; obráceně se ukládá 1\u{a0}−\u{a0}*d*.",
        hr: "Plohe bliže jedna drugoj od koraka mogu imati istu dubinu. Crte su formula, oznake mjerenja; obrnuto se pohranjuje 1\u{a0}−\u{a0}*d*.",
    }

    /// `hsr/depth-precision`: to the right.
    PRECISION_DISTANCE {
        en: "distance *z*",
        it: "distanza *z*",
        cs: "vzdálenost *z*",
        hr: "udaljenost *z*",
    }

    /// `hsr/depth-precision`: upwards.
    PRECISION_STEP {
        en: "depth step Δ*z*",
        it: "passo di profondità Δ*z*",
        cs: "krok hloubky Δ*z*",
        hr: "korak dubine Δ*z*",
    }

    /// `hsr/depth-precision`: a curve.
    PRECISION_16 {
        en: "16 bits",
        it: "16 bit",
        cs: "16 bitů",
        hr: "16 bitova",
    }

    /// `hsr/depth-precision`: a curve, on which that of single precision lies but for its beginning.
    PRECISION_24 {
        en: "24 bits, f32",
        it: "24 bit, f32",
        cs: "24 bitů, f32",
        hr: "24 bita, f32",
    }

    /// `hsr/depth-precision`: a curve.
    PRECISION_REVERSED {
        en: "f32 reversed",
        it: "f32 invertito",
        cs: "f32 obráceně",
        hr: "f32 obrnuto",
    }
}
