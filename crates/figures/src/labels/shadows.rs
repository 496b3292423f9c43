//! Words of the shadows lecture.

use super::Key;

words! {
    /// `shadows/cube-infinity` in lists.
    CUBE_INFINITY_SUMMARY {
        en: "A cube under a light at infinity, its shadow with exact coordinates",
        it: "Un cubo sotto una luce all’infinito, la sua ombra con le coordinate esatte",
        cs: "Krychle a zdroj v nekonečnu, její stín s přesnými souřadnicemi",
        hr: "Kocka i izvor u beskonačnosti, njezina sjena s točnim koordinatama",
    }

    /// `shadows/cube-infinity` below the figure.
    CUBE_INFINITY_CAPTION {
        en: "Light at infinity: every vertex moves along the same direction **L** onto the plane.",
        it: "Luce all’infinito: ogni vertice si sposta lungo la stessa direzione **L** fino al piano.",
        cs: "Zdroj v nekonečnu: každý vrchol se posune týmž směrem **L** do roviny.",
        hr: "Izvor u beskonačnosti: svaki se vrh pomiče istim smjerom **L** do ravnine.",
    }

    /// The same with an instructor's own object.
    OBJECT_INFINITY_SUMMARY {
        en: "An object under a light at infinity and its shadow",
        it: "Un oggetto sotto una luce all’infinito e la sua ombra",
        cs: "Těleso pod zdrojem v nekonečnu a jeho stín",
        hr: "Objekt pod izvorom u beskonačnosti i njegova sjena",
    }

    /// `shadows/why` in lists.
    WHY_SUMMARY {
        en: "The same ball without shadow, resting, hovering",
        it: "La stessa palla senza ombra, appoggiata, sospesa",
        cs: "Táž koule bez stínu, na zemi, nad zemí",
        hr: "Ista kugla bez sjene, na podlozi, iznad podloge",
    }

    /// `shadows/why` below the figure.
    WHY_CAPTION {
        en: "The picture of the ball is the same three times: only the shadow tells where it is.",
        it: "L’immagine della palla è la stessa tre volte: solo l’ombra dice dove si trova.",
        cs: "Obraz koule je třikrát týž: jen stín prozradí, kde je.",
        hr: "Slika kugle triput je ista: samo sjena govori gdje je.",
    }

    /// First panel of `shadows/why`.
    WHY_WITHOUT {
        en: "no shadow",
        it: "senza ombra",
        cs: "bez stínu",
        hr: "bez sjene",
    }

    /// Second panel of `shadows/why`.
    WHY_RESTING {
        en: "resting",
        it: "appoggiata",
        cs: "leží na zemi",
        hr: "leži na podlozi",
    }

    /// Third panel of `shadows/why`.
    WHY_HOVERING {
        en: "hovering",
        it: "sospesa",
        cs: "vznáší se",
        hr: "lebdi",
    }

    /// `shadows/planar-similar-triangles` in lists.
    SIMILAR_TRIANGLES_SUMMARY {
        en: "Light, vertex and shadow from the side: two similar triangles",
        it: "Luce, vertice e ombra visti di lato: due triangoli simili",
        cs: "Zdroj, vrchol a stín ze strany: dva podobné trojúhelníky",
        hr: "Izvor, vrh i sjena sa strane: dva slična trokuta",
    }

    /// `shadows/planar-similar-triangles` below the figure.
    SIMILAR_TRIANGLES_CAPTION {
        en: "The shadow *P* of the vertex *V* on the plane *y* = 0 follows from two similar triangles.",
        it: "L’ombra *P* del vertice *V* sul piano *y* = 0 si ricava da due triangoli simili.",
        cs: "Stín *P* vrcholu *V* v rovině *y* = 0 plyne ze dvou podobných trojúhelníků.",
        hr: "Sjena *P* vrha *V* na ravnini *y* = 0 slijedi iz dvaju sličnih trokuta.",
    }

    /// The same in lists with the light right above the vertex.
    VERTICAL_RAY_SUMMARY {
        en: "Light, vertex and shadow from the side: one vertical ray",
        it: "Luce, vertice e ombra visti di lato: un raggio verticale",
        cs: "Zdroj, vrchol a stín ze strany: svislý paprsek",
        hr: "Izvor, vrh i sjena sa strane: okomita zraka",
    }

    /// The same below the figure.
    VERTICAL_RAY_CAPTION {
        en: "The light is right above the vertex *V*: its shadow *P* lies straight below, and there are no triangles.",
        it: "La luce sta esattamente sopra il vertice *V*: l’ombra *P* è sulla sua verticale, e non ci sono triangoli.",
        cs: "Zdroj je přímo nad vrcholem *V*: stín *P* leží kolmo pod ním a trojúhelníky nevznikají.",
        hr: "Izvor je točno iznad vrha *V*: sjena *P* leži okomito ispod njega i nema trokuta.",
    }

    /// `shadows/cube-point` in lists.
    CUBE_POINT_SUMMARY {
        en: "A cube under a point light, its shadow with exact fractions",
        it: "Un cubo sotto una luce puntiforme, la sua ombra in frazioni esatte",
        cs: "Krychle a zdroj v bodě, její stín v přesných zlomcích",
        hr: "Kocka i točkasti izvor, njezina sjena u točnim razlomcima",
    }

    /// `shadows/cube-point` below the figure.
    CUBE_POINT_CAPTION {
        en: "Light at a place: the rays from **L** spread, so the shadow is larger than the cube.",
        it: "Luce puntiforme: i raggi da **L** divergono, perciò l’ombra è più grande del cubo.",
        cs: "Zdroj v bodě: paprsky z **L** se rozbíhají, stín je proto větší než krychle.",
        hr: "Točkasti izvor: zrake iz **L** se razilaze, pa je sjena veća od kocke.",
    }

    /// The same with an instructor's own object.
    OBJECT_POINT_SUMMARY {
        en: "An object under a point light and its shadow",
        it: "Un oggetto sotto una luce puntiforme e la sua ombra",
        cs: "Těleso pod zdrojem v bodě a jeho stín",
        hr: "Objekt pod točkastim izvorom i njegova sjena",
    }

    /// The same below the figure.
    OBJECT_POINT_CAPTION {
        en: "Light at a place: the rays from **L** spread, so the shadow is larger than the object.",
        it: "Luce puntiforme: i raggi da **L** divergono, perciò l’ombra è più grande dell’oggetto.",
        cs: "Zdroj v bodě: paprsky z **L** se rozbíhají, stín je proto větší než těleso.",
        hr: "Točkasti izvor: zrake iz **L** se razilaze, pa je sjena veća od objekta.",
    }

    /// `shadows/planar-any-plane` in lists.
    ANY_PLANE_SUMMARY {
        en: "A cube’s shadow on a slanted wall",
        it: "L’ombra di un cubo su una parete inclinata",
        cs: "Stín krychle na šikmé stěně",
        hr: "Sjena kocke na kosom zidu",
    }

    /// The same with an instructor's own object.
    OBJECT_ON_WALL_SUMMARY {
        en: "An object’s shadow on a slanted wall",
        it: "L’ombra di un oggetto su una parete inclinata",
        cs: "Stín tělesa na šikmé stěně",
        hr: "Sjena objekta na kosom zidu",
    }

    /// The same with an instructor's own plane.
    CUBE_ON_PLANE_SUMMARY {
        en: "A cube’s shadow on a plane",
        it: "L’ombra di un cubo su un piano",
        cs: "Stín krychle v rovině",
        hr: "Sjena kocke na ravnini",
    }

    /// The same with an instructor's own object and plane.
    OBJECT_ON_PLANE_SUMMARY {
        en: "An object’s shadow on a plane",
        it: "L’ombra di un oggetto su un piano",
        cs: "Stín tělesa v rovině",
        hr: "Sjena objekta na ravnini",
    }

    /// `shadows/planar-any-plane` below the figure.
    ANY_PLANE_CAPTION {
        en: "Any plane **n** · *X* + *d* = 0 receives the shadow: every vertex moves along its ray onto it.",
        it: "Ogni piano **n** · *X* + *d* = 0 riceve l’ombra: ogni vertice vi si sposta lungo il suo raggio.",
        cs: "Stín dopadá do libovolné roviny **n** · *X* + *d* = 0: každý vrchol se do ní posune po svém paprsku.",
        hr: "Sjena pada na bilo koju ravninu **n** · *X* + *d* = 0: svaki se vrh po svojoj zraci pomiče na nju.",
    }

    /// `shadows/false-shadow` in lists.
    FALSE_SHADOW_SUMMARY {
        en: "A true shadow beside two false ones: object behind the plane, object behind the light",
        it: "Un’ombra vera e due false: oggetto dietro il piano, oggetto dietro la luce",
        cs: "Skutečný stín a dva falešné: těleso za rovinou, těleso za zdrojem",
        hr: "Prava sjena i dvije neispravne: objekt iza ravnine, objekt iza izvora",
    }

    /// `shadows/false-shadow` below the figure.
    FALSE_SHADOW_CAPTION {
        en: "The matrix finds a point in all three cases; a shadow falls only where the object is between light and plane.",
        it: "La matrice trova un punto in tutti e tre i casi; l’ombra cade solo se l’oggetto è tra la luce e il piano.",
        cs: "Matice najde bod ve všech třech případech; stín vrhá jen těleso mezi zdrojem a rovinou.",
        hr: "Matrica nalazi točku u sva tri slučaja; sjenu baca samo objekt između izvora i ravnine.",
    }

    /// First panel of `shadows/false-shadow`.
    FALSE_SHADOW_BETWEEN {
        en: "*t* ≤ 0: between",
        it: "*t* ≤ 0: in mezzo",
        cs: "*t* ≤ 0: mezi nimi",
        hr: "*t* ≤ 0: između",
    }

    /// Second panel of `shadows/false-shadow`.
    FALSE_SHADOW_BEHIND_PLANE {
        en: "0 < *t* < 1: behind the plane",
        it: "0 < *t* < 1: dietro il piano",
        cs: "0 < *t* < 1: za rovinou",
        hr: "0 < *t* < 1: iza ravnine",
    }

    /// Third panel of `shadows/false-shadow`.
    FALSE_SHADOW_BEYOND_LIGHT {
        en: "*t* > 1: behind the light",
        it: "*t* > 1: dietro la luce",
        cs: "*t* > 1: za zdrojem",
        hr: "*t* > 1: iza izvora",
    }

    /// What is a shadow.
    TRUE_SHADOW {
        en: "true shadow",
        it: "ombra vera",
        cs: "skutečný stín",
        hr: "prava sjena",
    }

    /// What a matrix draws where there is no shadow.
    FALSE_SHADOW {
        en: "false shadow",
        it: "ombra falsa",
        cs: "falešný stín",
        hr: "neispravna sjena",
    }

    /// `shadows/fake` in lists.
    FAKE_SUMMARY {
        en: "A fake shadow, an ellipse, over the true one",
        it: "Un’ombra finta, un’ellisse, sopra quella vera",
        cs: "Pseudostín, elipsa, přes skutečný stín",
        hr: "Lažna sjena, elipsa, preko prave sjene",
    }

    /// `shadows/fake` below the figure.
    FAKE_CAPTION {
        en: "The ellipse has the object’s largest extents: it says where the object is, not what shape it has.",
        it: "L’ellisse ha le dimensioni massime dell’oggetto: dice dove si trova, non che forma ha.",
        cs: "Elipsa má největší rozměry tělesa: říká, kde těleso je, ne jaký má tvar.",
        hr: "Elipsa ima najveće dimenzije objekta: govori gdje je objekt, a ne kakva je oblika.",
    }

    /// An ellipse instead of a shadow.
    FAKE_SHADOW {
        en: "fake: an ellipse",
        it: "finta: un’ellisse",
        cs: "pseudostín: elipsa",
        hr: "lažna sjena: elipsa",
    }
}
