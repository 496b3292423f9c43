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
    /// `shadows/why` in lists.
    WhySummary,
    /// `shadows/why` below the figure.
    WhyCaption,
    /// First panel of `shadows/why`.
    WhyWithout,
    /// Second panel of `shadows/why`.
    WhyResting,
    /// Third panel of `shadows/why`.
    WhyHovering,
    /// `shadows/planar-similar-triangles` in lists.
    SimilarTrianglesSummary,
    /// `shadows/planar-similar-triangles` below the figure.
    SimilarTrianglesCaption,
    /// `shadows/cube-point` in lists.
    CubePointSummary,
    /// `shadows/cube-point` below the figure.
    CubePointCaption,
    /// `shadows/planar-any-plane` in lists.
    AnyPlaneSummary,
    /// `shadows/planar-any-plane` below the figure.
    AnyPlaneCaption,
    /// `shadows/false-shadow` in lists.
    FalseShadowSummary,
    /// `shadows/false-shadow` below the figure.
    FalseShadowCaption,
    /// First panel of `shadows/false-shadow`.
    FalseShadowBetween,
    /// Second panel of `shadows/false-shadow`.
    FalseShadowBehindPlane,
    /// Third panel of `shadows/false-shadow`.
    FalseShadowBeyondLight,
    /// What is a shadow.
    TrueShadow,
    /// What a matrix draws where there is no shadow.
    FalseShadow,
    /// `shadows/fake` in lists.
    FakeSummary,
    /// `shadows/fake` below the figure.
    FakeCaption,
    /// An ellipse instead of a shadow.
    FakeShadow,
    /// `math/plane` in lists.
    MathPlaneSummary,
    /// `math/plane` below the figure.
    MathPlaneCaption,
    /// `math/spherical` in lists.
    MathSphericalSummary,
    /// `math/spherical` below the figure.
    MathSphericalCaption,
    /// `math/frustum` in lists.
    MathFrustumSummary,
    /// `math/frustum` below the figure.
    MathFrustumCaption,
    /// `math/frustum`: the first picture.
    FrustumBefore,
    /// `math/frustum`: the second picture.
    FrustumAfter,
    /// `raster/continuous-to-discrete` in lists.
    ContinuousToDiscreteSummary,
    /// `raster/continuous-to-discrete` below the figure.
    ContinuousToDiscreteCaption,
    /// `raster/continuous-to-discrete`: the first picture.
    Continuous,
    /// `raster/continuous-to-discrete`: the second picture.
    Discrete,
    /// `raster/segment-slopes` in lists.
    SegmentSlopesSummary,
    /// `raster/segment-slopes` below the figure.
    SegmentSlopesCaption,
    /// `raster/segment-slopes`: the first picture.
    SlopeColumns,
    /// `raster/segment-slopes`: the second picture.
    SlopeRows,
    /// `raster/dda-rounding` in lists.
    DdaRoundingSummary,
    /// `raster/dda-rounding` below the figure.
    DdaRoundingCaption,
    /// One pixel.
    Pixel,
    /// Pixels after their number, five or more or none.
    PixelsOf,
    /// `raster/bresenham-choice` in lists.
    BresenhamChoiceSummary,
    /// `raster/bresenham-choice` below the figure.
    BresenhamChoiceCaption,
    /// `raster/bresenham-increments` in lists.
    BresenhamIncrementsSummary,
    /// `raster/bresenham-increments` below the figure.
    BresenhamIncrementsCaption,
    /// After a choice: before its name.
    After,
    /// `raster/bresenham-trace` in lists.
    BresenhamTraceSummary,
    /// `raster/bresenham-trace` below the figure.
    BresenhamTraceCaption,
    /// `raster/rectangle` in lists.
    RectangleSummary,
    /// `raster/rectangle` below the figure.
    RectangleCaption,
    /// `raster/rectangle`: the first picture.
    RectangleOutline,
    /// `raster/rectangle`: the second picture.
    RectangleFilled,
    /// `raster/polygon-kinds` in lists.
    PolygonKindsSummary,
    /// `raster/polygon-kinds` below the figure.
    PolygonKindsCaption,
    /// The rule of odd winding numbers.
    EvenOdd,
    /// The rule of winding numbers that are not 0.
    NonZero,
    /// `raster/polygon-kinds`: the first kind.
    KindConvex,
    /// `raster/polygon-kinds`: the second kind.
    KindConcave,
    /// `raster/polygon-kinds`: the third kind.
    KindCrossed,
    /// `raster/polygon-kinds`: the fourth kind.
    KindSeveral,
    /// `raster/scanline` in lists.
    ScanlineSummary,
    /// `raster/scanline` below the figure.
    ScanlineCaption,
    /// Heading of the edge table.
    ScanEdge,
    /// Heading of the edge table: where an edge begins and ends.
    ScanRows,
    /// `raster/triangle-shared-edge` in lists.
    SharedEdgeSummary,
    /// `raster/triangle-shared-edge` below the figure.
    SharedEdgeCaption,
    /// `raster/triangle-shared-edge`: the first picture.
    SharedTopLeft,
    /// `raster/triangle-shared-edge`: the second picture.
    SharedClosed,
    /// `raster/triangle-shared-edge`: the third picture.
    SharedOpen,
    /// `raster/sliver` in lists.
    SliverSummary,
    /// `raster/sliver` below the figure.
    SliverCaption,
    /// Before an area.
    Area,
    /// `clip/point-window` in lists.
    PointWindowSummary,
    /// `clip/point-window` below the figure.
    PointWindowCaption,
    /// `clip/segment-cases` in lists.
    SegmentCasesSummary,
    /// `clip/segment-cases` below the figure.
    SegmentCasesCaption,
    /// `clip/outcodes` in lists.
    OutcodesSummary,
    /// `clip/outcodes` below the figure.
    OutcodesCaption,
    /// A digit of an outcode.
    Bit,
    /// `clip/cohen-sutherland-steps` in lists.
    CohenSutherlandSummary,
    /// `clip/cohen-sutherland-steps` below the figure.
    CohenSutherlandCaption,
    /// Cohen–Sutherland: the segment is inside.
    Accept,
    /// Cohen–Sutherland: the segment is outside.
    Reject,
    /// Cohen–Sutherland: before the line that cuts.
    CutAt,
    /// `clip/sutherland-hodgman-steps` in lists.
    SutherlandHodgmanSummary,
    /// `clip/sutherland-hodgman-steps` below the figure.
    SutherlandHodgmanCaption,
    /// `clip/polygon-cases` in lists.
    PolygonCasesSummary,
    /// `clip/polygon-cases` below the figure.
    PolygonCasesCaption,
    /// `clip/polygon-cases`: the first picture.
    CaseConvex,
    /// `clip/polygon-cases`: the second picture.
    CaseBridges,
    /// `clip/polygon-cases`: the third picture.
    CasePieces,
    /// `clip/polygon-cases`: the fourth picture.
    CaseClosed,
}

impl Key {
    /// Every key there is, for tests.
    pub const ALL: &'static [Key] = &[
        Key::GalleryTitle,
        Key::GalleryLicence,
        Key::CubeInfinitySummary,
        Key::CubeInfinityCaption,
        Key::WhySummary,
        Key::WhyCaption,
        Key::WhyWithout,
        Key::WhyResting,
        Key::WhyHovering,
        Key::SimilarTrianglesSummary,
        Key::SimilarTrianglesCaption,
        Key::CubePointSummary,
        Key::CubePointCaption,
        Key::AnyPlaneSummary,
        Key::AnyPlaneCaption,
        Key::FalseShadowSummary,
        Key::FalseShadowCaption,
        Key::FalseShadowBetween,
        Key::FalseShadowBehindPlane,
        Key::FalseShadowBeyondLight,
        Key::TrueShadow,
        Key::FalseShadow,
        Key::FakeSummary,
        Key::FakeCaption,
        Key::FakeShadow,
        Key::MathPlaneSummary,
        Key::MathPlaneCaption,
        Key::MathSphericalSummary,
        Key::MathSphericalCaption,
        Key::MathFrustumSummary,
        Key::MathFrustumCaption,
        Key::FrustumBefore,
        Key::FrustumAfter,
        Key::ContinuousToDiscreteSummary,
        Key::ContinuousToDiscreteCaption,
        Key::Continuous,
        Key::Discrete,
        Key::SegmentSlopesSummary,
        Key::SegmentSlopesCaption,
        Key::SlopeColumns,
        Key::SlopeRows,
        Key::DdaRoundingSummary,
        Key::DdaRoundingCaption,
        Key::Pixel,
        Key::PixelsOf,
        Key::BresenhamChoiceSummary,
        Key::BresenhamChoiceCaption,
        Key::BresenhamIncrementsSummary,
        Key::BresenhamIncrementsCaption,
        Key::After,
        Key::BresenhamTraceSummary,
        Key::BresenhamTraceCaption,
        Key::RectangleSummary,
        Key::RectangleCaption,
        Key::RectangleOutline,
        Key::RectangleFilled,
        Key::PolygonKindsSummary,
        Key::PolygonKindsCaption,
        Key::EvenOdd,
        Key::NonZero,
        Key::KindConvex,
        Key::KindConcave,
        Key::KindCrossed,
        Key::KindSeveral,
        Key::ScanlineSummary,
        Key::ScanlineCaption,
        Key::ScanEdge,
        Key::ScanRows,
        Key::SharedEdgeSummary,
        Key::SharedEdgeCaption,
        Key::SharedTopLeft,
        Key::SharedClosed,
        Key::SharedOpen,
        Key::SliverSummary,
        Key::SliverCaption,
        Key::Area,
        Key::PointWindowSummary,
        Key::PointWindowCaption,
        Key::SegmentCasesSummary,
        Key::SegmentCasesCaption,
        Key::OutcodesSummary,
        Key::OutcodesCaption,
        Key::Bit,
        Key::CohenSutherlandSummary,
        Key::CohenSutherlandCaption,
        Key::Accept,
        Key::Reject,
        Key::CutAt,
        Key::SutherlandHodgmanSummary,
        Key::SutherlandHodgmanCaption,
        Key::PolygonCasesSummary,
        Key::PolygonCasesCaption,
        Key::CaseConvex,
        Key::CaseBridges,
        Key::CasePieces,
        Key::CaseClosed,
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

            (Key::WhySummary, En) => "The same ball without shadow, resting, hovering",
            (Key::WhySummary, It) => "La stessa palla senza ombra, appoggiata, sospesa",
            (Key::WhySummary, Cs) => "Táž koule bez stínu, na zemi, nad zemí",
            (Key::WhySummary, Hr) => "Ista kugla bez sjene, na podlozi, iznad podloge",

            (Key::WhyCaption, En) => {
                "The picture of the ball is the same three times: only the shadow tells where it is."
            }
            (Key::WhyCaption, It) => {
                "L'immagine della palla è la stessa tre volte: solo l'ombra dice dove si trova."
            }
            (Key::WhyCaption, Cs) => "Obraz koule je třikrát týž: jen stín prozradí, kde je.",
            (Key::WhyCaption, Hr) => "Slika kugle triput je ista: samo sjena govori gdje je.",

            (Key::WhyWithout, En) => "no shadow",
            (Key::WhyWithout, It) => "senza ombra",
            (Key::WhyWithout, Cs) => "bez stínu",
            (Key::WhyWithout, Hr) => "bez sjene",

            (Key::WhyResting, En) => "resting",
            (Key::WhyResting, It) => "appoggiata",
            (Key::WhyResting, Cs) => "leží na zemi",
            (Key::WhyResting, Hr) => "leži na podlozi",

            (Key::WhyHovering, En) => "hovering",
            (Key::WhyHovering, It) => "sospesa",
            (Key::WhyHovering, Cs) => "vznáší se",
            (Key::WhyHovering, Hr) => "lebdi",

            (Key::SimilarTrianglesSummary, En) => {
                "Light, vertex and shadow from the side: two similar triangles"
            }
            (Key::SimilarTrianglesSummary, It) => {
                "Luce, vertice e ombra visti di lato: due triangoli simili"
            }
            (Key::SimilarTrianglesSummary, Cs) => {
                "Zdroj, vrchol a stín ze strany: dva podobné trojúhelníky"
            }
            (Key::SimilarTrianglesSummary, Hr) => {
                "Izvor, vrh i sjena sa strane: dva slična trokuta"
            }

            (Key::SimilarTrianglesCaption, En) => {
                "The shadow *P* of the vertex *V* on the plane *y* = 0 follows from two similar triangles."
            }
            (Key::SimilarTrianglesCaption, It) => {
                "L'ombra *P* del vertice *V* sul piano *y* = 0 si ricava da due triangoli simili."
            }
            (Key::SimilarTrianglesCaption, Cs) => {
                "Stín *P* vrcholu *V* v rovině *y* = 0 plyne ze dvou podobných trojúhelníků."
            }
            (Key::SimilarTrianglesCaption, Hr) => {
                "Sjena *P* vrha *V* na ravnini *y* = 0 slijedi iz dvaju sličnih trokuta."
            }

            (Key::CubePointSummary, En) => {
                "A cube under a point light, its shadow with exact fractions"
            }
            (Key::CubePointSummary, It) => {
                "Un cubo sotto una luce puntiforme, la sua ombra in frazioni esatte"
            }
            (Key::CubePointSummary, Cs) => "Krychle a zdroj v bodě, její stín v přesných zlomcích",
            (Key::CubePointSummary, Hr) => {
                "Kocka i točkasti izvor, njezina sjena u točnim razlomcima"
            }

            (Key::CubePointCaption, En) => {
                "Light at a place: the rays from **L** spread, so the shadow is larger than the cube."
            }
            (Key::CubePointCaption, It) => {
                "Luce puntiforme: i raggi da **L** divergono, perciò l'ombra è più grande del cubo."
            }
            (Key::CubePointCaption, Cs) => {
                "Zdroj v bodě: paprsky z **L** se rozbíhají, stín je proto větší než krychle."
            }
            (Key::CubePointCaption, Hr) => {
                "Točkasti izvor: zrake iz **L** se razilaze, pa je sjena veća od kocke."
            }

            (Key::AnyPlaneSummary, En) => "A cube's shadow on a slanted wall",
            (Key::AnyPlaneSummary, It) => "L'ombra di un cubo su una parete inclinata",
            (Key::AnyPlaneSummary, Cs) => "Stín krychle na šikmé stěně",
            (Key::AnyPlaneSummary, Hr) => "Sjena kocke na kosom zidu",

            (Key::AnyPlaneCaption, En) => {
                "Any plane **n** · *X* + *d* = 0 receives the shadow: every vertex moves along its ray onto it."
            }
            (Key::AnyPlaneCaption, It) => {
                "Ogni piano **n** · *X* + *d* = 0 riceve l'ombra: ogni vertice vi si sposta lungo il suo raggio."
            }
            (Key::AnyPlaneCaption, Cs) => {
                "Stín dopadá do libovolné roviny **n** · *X* + *d* = 0: každý vrchol se do ní posune po svém paprsku."
            }
            (Key::AnyPlaneCaption, Hr) => {
                "Sjena pada na bilo koju ravninu **n** · *X* + *d* = 0: svaki se vrh po svojoj zraci pomiče na nju."
            }

            (Key::FalseShadowSummary, En) => {
                "A true shadow beside two false ones: object behind the plane, object behind the light"
            }
            (Key::FalseShadowSummary, It) => {
                "Un'ombra vera e due false: oggetto dietro il piano, oggetto dietro la luce"
            }
            (Key::FalseShadowSummary, Cs) => {
                "Skutečný stín a dva falešné: těleso za rovinou, těleso za zdrojem"
            }
            (Key::FalseShadowSummary, Hr) => {
                "Prava sjena i dvije neispravne: objekt iza ravnine, objekt iza izvora"
            }

            (Key::FalseShadowCaption, En) => {
                "The matrix finds a point in all three cases; a shadow falls only where the object is between light and plane."
            }
            (Key::FalseShadowCaption, It) => {
                "La matrice trova un punto in tutti e tre i casi; l'ombra cade solo se l'oggetto è tra la luce e il piano."
            }
            (Key::FalseShadowCaption, Cs) => {
                "Matice najde bod ve všech třech případech; stín vrhá jen těleso mezi zdrojem a rovinou."
            }
            (Key::FalseShadowCaption, Hr) => {
                "Matrica nalazi točku u sva tri slučaja; sjenu baca samo objekt između izvora i ravnine."
            }

            (Key::FalseShadowBetween, En) => "*t* ≤ 0: between",
            (Key::FalseShadowBetween, It) => "*t* ≤ 0: in mezzo",
            (Key::FalseShadowBetween, Cs) => "*t* ≤ 0: mezi nimi",
            (Key::FalseShadowBetween, Hr) => "*t* ≤ 0: između",

            (Key::FalseShadowBehindPlane, En) => "0 < *t* < 1: behind the plane",
            (Key::FalseShadowBehindPlane, It) => "0 < *t* < 1: dietro il piano",
            (Key::FalseShadowBehindPlane, Cs) => "0 < *t* < 1: za rovinou",
            (Key::FalseShadowBehindPlane, Hr) => "0 < *t* < 1: iza ravnine",

            (Key::FalseShadowBeyondLight, En) => "*t* > 1: behind the light",
            (Key::FalseShadowBeyondLight, It) => "*t* > 1: dietro la luce",
            (Key::FalseShadowBeyondLight, Cs) => "*t* > 1: za zdrojem",
            (Key::FalseShadowBeyondLight, Hr) => "*t* > 1: iza izvora",

            (Key::TrueShadow, En) => "true shadow",
            (Key::TrueShadow, It) => "ombra vera",
            (Key::TrueShadow, Cs) => "skutečný stín",
            (Key::TrueShadow, Hr) => "prava sjena",

            (Key::FalseShadow, En) => "false shadow",
            (Key::FalseShadow, It) => "ombra falsa",
            (Key::FalseShadow, Cs) => "falešný stín",
            (Key::FalseShadow, Hr) => "neispravna sjena",

            (Key::FakeSummary, En) => "A fake shadow, an ellipse, over the true one",
            (Key::FakeSummary, It) => "Un'ombra finta, un'ellisse, sopra quella vera",
            (Key::FakeSummary, Cs) => "Pseudostín, elipsa, přes skutečný stín",
            (Key::FakeSummary, Hr) => "Lažna sjena, elipsa, preko prave sjene",

            (Key::FakeCaption, En) => {
                "The ellipse has the object's largest extents: it says where the object is, not what shape it has."
            }
            (Key::FakeCaption, It) => {
                "L'ellisse ha le dimensioni massime dell'oggetto: dice dove si trova, non che forma ha."
            }
            (Key::FakeCaption, Cs) => {
                "Elipsa má největší rozměry tělesa: říká, kde těleso je, ne jaký má tvar."
            }
            (Key::FakeCaption, Hr) => {
                "Elipsa ima najveće dimenzije objekta: govori gdje je objekt, a ne kakva je oblika."
            }

            (Key::FakeShadow, En) => "fake: an ellipse",
            (Key::FakeShadow, It) => "finta: un'ellisse",
            (Key::FakeShadow, Cs) => "pseudostín: elipsa",
            (Key::FakeShadow, Hr) => "lažna sjena: elipsa",

            (Key::MathPlaneSummary, En) => {
                "A plane by a point and its normal, and how far a point is from it"
            }
            (Key::MathPlaneSummary, It) => {
                "Un piano dato da un punto e dalla normale, e la distanza di un punto"
            }
            (Key::MathPlaneSummary, Cs) => "Rovina daná bodem a normálou a vzdálenost bodu od ní",
            (Key::MathPlaneSummary, Hr) => {
                "Ravnina zadana točkom i normalom te udaljenost točke od nje"
            }

            (Key::MathPlaneCaption, En) => {
                "**n** is perpendicular to the plane, *Q* lies on it: *d* = −**n**·*Q*. In front of the plane the distance is positive."
            }
            (Key::MathPlaneCaption, It) => {
                "**n** è perpendicolare al piano, *Q* vi giace: *d* = −**n**·*Q*. Davanti al piano la distanza è positiva."
            }
            (Key::MathPlaneCaption, Cs) => {
                "**n** je kolmé k rovině, *Q* v ní leží: *d* = −**n**·*Q*. Před rovinou je vzdálenost kladná."
            }
            (Key::MathPlaneCaption, Hr) => {
                "**n** je okomit na ravninu, *Q* leži u njoj: *d* = −**n**·*Q*. Ispred ravnine udaljenost je pozitivna."
            }

            (Key::MathSphericalSummary, En) => "Spherical coordinates and a solid angle",
            (Key::MathSphericalSummary, It) => "Coordinate sferiche e un angolo solido",
            (Key::MathSphericalSummary, Cs) => "Sférické souřadnice a prostorový úhel",
            (Key::MathSphericalSummary, Hr) => "Sferne koordinate i prostorni kut",

            (Key::MathSphericalCaption, En) => {
                "*θ* is measured from the pole, *φ* from *x* towards *y*. The patch of the unit sphere is the solid angle d*ω*."
            }
            (Key::MathSphericalCaption, It) => {
                "*θ* si misura dal polo, *φ* da *x* verso *y*. La porzione di sfera unitaria è l'angolo solido d*ω*."
            }
            (Key::MathSphericalCaption, Cs) => {
                "*θ* se měří od pólu, *φ* od *x* k *y*. Ploška na jednotkové kouli je prostorový úhel d*ω*."
            }
            (Key::MathSphericalCaption, Hr) => {
                "*θ* se mjeri od pola, *φ* od *x* prema *y*. Djelić jedinične sfere prostorni je kut d*ω*."
            }

            (Key::MathFrustumSummary, En) => "The view frustum and the cube it becomes",
            (Key::MathFrustumSummary, It) => "Il volume di vista e il cubo che diventa",
            (Key::MathFrustumSummary, Cs) => "Pohledový objem a krychle, kterou se stane",
            (Key::MathFrustumSummary, Hr) => "Volumen pogleda i kocka u koju prelazi",

            (Key::MathFrustumCaption, En) => {
                "The plane *z* = −2*fn* / (*f* + *n*) comes to the middle of the cube: half of all depths lies before it."
            }
            (Key::MathFrustumCaption, It) => {
                "Il piano *z* = −2*fn* / (*f* + *n*) arriva al centro del cubo: metà delle profondità sta davanti."
            }
            (Key::MathFrustumCaption, Cs) => {
                "Rovina *z* = −2*fn* / (*f* + *n*) přejde do středu krychle: polovina všech hloubek leží před ní."
            }
            (Key::MathFrustumCaption, Hr) => {
                "Ravnina *z* = −2*fn* / (*f* + *n*) dolazi u sredinu kocke: polovica svih dubina leži ispred nje."
            }

            (Key::FrustumBefore, En) => "What the eye sees along\u{a0}−*z*",
            (Key::FrustumBefore, It) => "Ciò che l'occhio vede lungo\u{a0}−*z*",
            (Key::FrustumBefore, Cs) => "Co vidí oko ve směru −*z*",
            (Key::FrustumBefore, Hr) => "Što oko vidi uzduž −*z*",

            (Key::FrustumAfter, En) => "After the matrix and the division by\u{a0}*w*",
            (Key::FrustumAfter, It) => "Dopo la matrice e la divisione per\u{a0}*w*",
            (Key::FrustumAfter, Cs) => "Po násobení maticí a dělení\u{a0}*w*",
            (Key::FrustumAfter, Hr) => "Nakon matrice i dijeljenja s\u{a0}*w*",

            (Key::ContinuousToDiscreteSummary, En) => {
                "A segment and a polygon, and the pixels that stand for them"
            }
            (Key::ContinuousToDiscreteSummary, It) => {
                "Un segmento e un poligono, e i pixel che li rappresentano"
            }
            (Key::ContinuousToDiscreteSummary, Cs) => {
                "Úsečka a polygon a pixely, které je zastupují"
            }
            (Key::ContinuousToDiscreteSummary, Hr) => {
                "Dužina i poligon te pikseli koji ih predstavljaju"
            }

            (Key::ContinuousToDiscreteCaption, En) => {
                "On the left points of the plane, on the right pixels: samples at whole places, of no size of their own."
            }
            (Key::ContinuousToDiscreteCaption, It) => {
                "A sinistra punti del piano, a destra pixel: campioni in posizioni intere, senza dimensione propria."
            }
            (Key::ContinuousToDiscreteCaption, Cs) => {
                "Vlevo body roviny, vpravo pixely: vzorky v celočíselných místech, bez vlastní velikosti."
            }
            (Key::ContinuousToDiscreteCaption, Hr) => {
                "Lijevo točke ravnine, desno pikseli: uzorci na cjelobrojnim mjestima, bez vlastite veličine."
            }

            (Key::Continuous, En) => "continuous",
            (Key::Continuous, It) => "continuo",
            (Key::Continuous, Cs) => "spojité",
            (Key::Continuous, Hr) => "kontinuirano",

            (Key::Discrete, En) => "discrete: pixels",
            (Key::Discrete, It) => "discreto: pixel",
            (Key::Discrete, Cs) => "diskrétní: pixely",
            (Key::Discrete, Hr) => "diskretno: pikseli",

            (Key::SegmentSlopesSummary, En) => {
                "Gentle segments have a pixel a column, steep ones a pixel a row"
            }
            (Key::SegmentSlopesSummary, It) => {
                "Un pixel per colonna nei segmenti poco inclinati, uno per riga in quelli ripidi"
            }
            (Key::SegmentSlopesSummary, Cs) => {
                "Pozvolné úsečky mají pixel v každém sloupci, strmé v každém řádku"
            }
            (Key::SegmentSlopesSummary, Hr) => {
                "Blage dužine imaju piksel u svakom stupcu, strme u svakom retku"
            }

            (Key::SegmentSlopesCaption, En) => {
                "One step along the longer axis, one pixel: no gaps and no doubles."
            }
            (Key::SegmentSlopesCaption, It) => {
                "Un passo lungo l'asse maggiore, un pixel: niente buchi né doppioni."
            }
            (Key::SegmentSlopesCaption, Cs) => {
                "Jeden krok podél delší osy, jeden pixel: žádné mezery ani dvojice."
            }
            (Key::SegmentSlopesCaption, Hr) => {
                "Jedan korak uzduž dulje osi, jedan piksel: bez rupa i bez dvostrukih."
            }

            (Key::SlopeColumns, En) => "\\|*m*\\|\u{a0}≤\u{a0}1: a pixel a column",
            (Key::SlopeColumns, It) => "\\|*m*\\|\u{a0}≤\u{a0}1: un pixel per colonna",
            (Key::SlopeColumns, Cs) => "\\|*m*\\|\u{a0}≤\u{a0}1: pixel v každém sloupci",
            (Key::SlopeColumns, Hr) => "\\|*m*\\|\u{a0}≤\u{a0}1: piksel u svakom stupcu",

            (Key::SlopeRows, En) => "\\|*m*\\|\u{a0}>\u{a0}1: a pixel a row",
            (Key::SlopeRows, It) => "\\|*m*\\|\u{a0}>\u{a0}1: un pixel per riga",
            (Key::SlopeRows, Cs) => "\\|*m*\\|\u{a0}>\u{a0}1: pixel v každém řádku",
            (Key::SlopeRows, Hr) => "\\|*m*\\|\u{a0}>\u{a0}1: piksel u svakom retku",

            (Key::DdaRoundingSummary, En) => {
                "DDA: the points of the line and the pixels they are rounded to"
            }
            (Key::DdaRoundingSummary, It) => {
                "DDA: i punti della retta e i pixel a cui si arrotondano"
            }
            (Key::DdaRoundingSummary, Cs) => "DDA: body přímky a pixely, na které se zaokrouhlí",
            (Key::DdaRoundingSummary, Hr) => "DDA: točke pravca i pikseli na koje se zaokružuju",

            (Key::DdaRoundingCaption, En) => {
                "*y*_{i+1} = *y*_i + *m* with *m* = 3/8. The nearest pixel is lit; the tie 3/2 goes to the lower one."
            }
            (Key::DdaRoundingCaption, It) => {
                "*y*_{i+1} = *y*_i + *m* con *m* = 3/8. Si accende il pixel più vicino; la parità 3/2 va al più basso."
            }
            (Key::DdaRoundingCaption, Cs) => {
                "*y*_{i+1} = *y*_i + *m*, *m* = 3/8. Rozsvítí se nejbližší pixel; shoda 3/2 patří nižšímu."
            }
            (Key::DdaRoundingCaption, Hr) => {
                "*y*_{i+1} = *y*_i + *m*, *m* = 3/8. Pali se najbliži piksel; jednakost 3/2 ide nižem."
            }

            (Key::Pixel, En) => "pixel",
            (Key::Pixel, It) => "pixel",
            (Key::Pixel, Cs) => "pixel",
            (Key::Pixel, Hr) => "piksel",

            (Key::PixelsOf, En) => "pixels",
            (Key::PixelsOf, It) => "pixel",
            (Key::PixelsOf, Cs) => "pixelů",
            (Key::PixelsOf, Hr) => "piksela",

            (Key::BresenhamChoiceSummary, En) => {
                "Bresenham: E or NE, by the side of the midpoint on which the line passes"
            }
            (Key::BresenhamChoiceSummary, It) => {
                "Bresenham: E o NE, secondo il lato del punto di mezzo da cui passa la retta"
            }
            (Key::BresenhamChoiceSummary, Cs) => {
                "Bresenham: E nebo NE podle toho, kde přímka míjí prostřední bod"
            }
            (Key::BresenhamChoiceSummary, Hr) => {
                "Bresenham: E ili NE, prema tome s koje strane polovišta prolazi pravac"
            }

            (Key::BresenhamChoiceCaption, En) => {
                "*Q* below *M*: E is nearer. *Q* above *M*: NE is nearer. For *d* = 0 both are equally near, and E is taken."
            }
            (Key::BresenhamChoiceCaption, It) => {
                "*Q* sotto *M*: è più vicino E. *Q* sopra *M*: è più vicino NE. Con *d* = 0 è indifferente, e si prende E."
            }
            (Key::BresenhamChoiceCaption, Cs) => {
                "*Q* pod *M*: blíž je E. *Q* nad *M*: blíž je NE. Při *d* = 0 jsou stejně daleko a bere se E."
            }
            (Key::BresenhamChoiceCaption, Hr) => {
                "*Q* ispod *M*: bliži je E. *Q* iznad *M*: bliži je NE. Za *d* = 0 jednako su daleko i uzima se E."
            }

            (Key::BresenhamIncrementsSummary, En) => {
                "Bresenham: the next midpoint after E and after NE"
            }
            (Key::BresenhamIncrementsSummary, It) => {
                "Bresenham: il punto di mezzo successivo dopo E e dopo NE"
            }
            (Key::BresenhamIncrementsSummary, Cs) => "Bresenham: další prostřední bod po E a po NE",
            (Key::BresenhamIncrementsSummary, Hr) => {
                "Bresenham: sljedeće polovište nakon E i nakon NE"
            }

            (Key::BresenhamIncrementsCaption, En) => {
                "The decision at the next midpoint *M*′ is an addition away: *dy* after E, *dy* − *dx* after NE."
            }
            (Key::BresenhamIncrementsCaption, It) => {
                "La decisione nel punto di mezzo successivo *M*′ costa un'addizione: *dy* dopo E, *dy* − *dx* dopo NE."
            }
            (Key::BresenhamIncrementsCaption, Cs) => {
                "K rozhodnutí v dalším prostředním bodě *M*′ stačí sčítání: *dy* po E, *dy* − *dx* po NE."
            }
            (Key::BresenhamIncrementsCaption, Hr) => {
                "Do odluke u sljedećem polovištu *M*′ dovoljno je zbrajanje: *dy* nakon E, *dy* − *dx* nakon NE."
            }

            (Key::After, En) => "after",
            (Key::After, It) => "dopo",
            (Key::After, Cs) => "po",
            (Key::After, Hr) => "nakon",

            (Key::BresenhamTraceSummary, En) => {
                "Bresenham: a whole segment with the decision of every move"
            }
            (Key::BresenhamTraceSummary, It) => {
                "Bresenham: un intero segmento con la decisione di ogni passo"
            }
            (Key::BresenhamTraceSummary, Cs) => {
                "Bresenham: celá úsečka s rozhodnutím v každém kroku"
            }
            (Key::BresenhamTraceSummary, Hr) => {
                "Bresenham: cijela dužina s odlukom u svakom koraku"
            }

            (Key::BresenhamTraceCaption, En) => {
                "2*F* is an integer: 2*dy* − *dx* = −2 at the start, + 6 after E, − 10 after NE. Above 0 the next pixel is NE, else E."
            }
            (Key::BresenhamTraceCaption, It) => {
                "2*F* è intero: 2*dy* − *dx* = −2 all'inizio, + 6 dopo E, − 10 dopo NE. Se è positivo si va a NE, altrimenti a E."
            }
            (Key::BresenhamTraceCaption, Cs) => {
                "2*F* je celé číslo: na začátku 2*dy* − *dx* = −2, + 6 po E, − 10 po NE. Je-li kladné, následuje NE, jinak E."
            }
            (Key::BresenhamTraceCaption, Hr) => {
                "2*F* je cijeli broj: na početku 2*dy* − *dx* = −2, + 6 nakon E, − 10 nakon NE. Ako je pozitivan, slijedi NE, inače E."
            }

            (Key::RectangleSummary, En) => "A rectangle along the axes, its outline and filled",
            (Key::RectangleSummary, It) => "Un rettangolo parallelo agli assi, vuoto e pieno",
            (Key::RectangleSummary, Cs) => "Obdélník rovnoběžný s osami, obrys a výplň",
            (Key::RectangleSummary, Hr) => "Pravokutnik usporedan s osima, obris i ispuna",

            (Key::RectangleCaption, En) => {
                "Both corners are pixels of the rectangle: columns 2 to 6 are five columns, not four."
            }
            (Key::RectangleCaption, It) => {
                "I due vertici sono pixel del rettangolo: le colonne da 2 a 6 sono cinque, non quattro."
            }
            (Key::RectangleCaption, Cs) => {
                "Oba rohy jsou pixely obdélníku: sloupce 2 až 6 jsou pět sloupců, ne čtyři."
            }
            (Key::RectangleCaption, Hr) => {
                "Oba su kuta pikseli pravokutnika: od stupca 2 do 6 ima ih pet, a ne četiri."
            }

            (Key::RectangleOutline, En) => "outline",
            (Key::RectangleOutline, It) => "vuoto",
            (Key::RectangleOutline, Cs) => "obrys",
            (Key::RectangleOutline, Hr) => "obris",

            (Key::RectangleFilled, En) => "filled",
            (Key::RectangleFilled, It) => "pieno",
            (Key::RectangleFilled, Cs) => "výplň",
            (Key::RectangleFilled, Hr) => "ispuna",

            (Key::PolygonKindsSummary, En) => {
                "Four kinds of polygon under the even-odd and the non-zero rule"
            }
            (Key::PolygonKindsSummary, It) => {
                "Quattro tipi di poligono con la regola pari-dispari e con quella non-zero"
            }
            (Key::PolygonKindsSummary, Cs) => {
                "Čtyři druhy polygonů podle pravidla sudá-lichá a nenulového pravidla"
            }
            (Key::PolygonKindsSummary, Hr) => {
                "Četiri vrste poligona po pravilu par-nepar i po pravilu različito od nule"
            }

            (Key::PolygonKindsCaption, En) => {
                "Inside is where the contours wind round an odd number of times, or not 0 times. Arrows say the direction."
            }
            (Key::PolygonKindsCaption, It) => {
                "È interno ciò attorno a cui i contorni girano un numero dispari di volte, o non zero volte. Le frecce dicono il verso."
            }
            (Key::PolygonKindsCaption, Cs) => {
                "Uvnitř je to, co obrysy obíhají lichým počtem otočení, nebo nenulovým. Šipky udávají směr."
            }
            (Key::PolygonKindsCaption, Hr) => {
                "Unutra je ono što konture obilaze neparan broj puta, ili broj puta različit od nule. Strelice pokazuju smjer."
            }

            (Key::EvenOdd, En) => "even-odd",
            (Key::EvenOdd, It) => "pari-dispari",
            (Key::EvenOdd, Cs) => "sudá-lichá",
            (Key::EvenOdd, Hr) => "par-nepar",

            (Key::NonZero, En) => "non-zero",
            (Key::NonZero, It) => "non-zero",
            (Key::NonZero, Cs) => "nenulová",
            (Key::NonZero, Hr) => "različito od nule",

            (Key::KindConvex, En) => "convex",
            (Key::KindConvex, It) => "convesso",
            (Key::KindConvex, Cs) => "konvexní",
            (Key::KindConvex, Hr) => "konveksan",

            (Key::KindConcave, En) => "concave",
            (Key::KindConcave, It) => "concavo",
            (Key::KindConcave, Cs) => "nekonvexní",
            (Key::KindConcave, Hr) => "konkavan",

            (Key::KindCrossed, En) => "self-crossing",
            (Key::KindCrossed, It) => "intrecciato",
            (Key::KindCrossed, Cs) => "překřížený",
            (Key::KindCrossed, Hr) => "samosijekući",

            (Key::KindSeveral, En) => "several contours",
            (Key::KindSeveral, It) => "a contorni multipli",
            (Key::KindSeveral, Cs) => "více obrysů",
            (Key::KindSeveral, Hr) => "više kontura",

            (Key::ScanlineSummary, En) => {
                "One scan line: edge table, active edges and the spans between them"
            }
            (Key::ScanlineSummary, It) => {
                "Una scan-line: tabella dei lati, lati attivi e gli intervalli tra loro"
            }
            (Key::ScanlineSummary, Cs) => {
                "Jeden řádek: tabulka hran, aktivní hrany a úseky mezi nimi"
            }
            (Key::ScanlineSummary, Hr) => {
                "Jedan redak: tablica bridova, aktivni bridovi i rasponi među njima"
            }

            (Key::ScanlineCaption, En) => {
                "The active edges cross the row at the places *X*. Between the first and the second, the third and the fourth, centres are inside."
            }
            (Key::ScanlineCaption, It) => {
                "I lati attivi incrociano la riga nei punti *X*. Tra il primo e il secondo, tra il terzo e il quarto, i centri sono interni."
            }
            (Key::ScanlineCaption, Cs) => {
                "Aktivní hrany protínají řádek v místech *X*. Mezi prvním a druhým, třetím a čtvrtým leží středy uvnitř."
            }
            (Key::ScanlineCaption, Hr) => {
                "Aktivni bridovi sijeku redak na mjestima *X*. Između prvog i drugog, trećeg i četvrtog središta su unutra."
            }

            (Key::ScanEdge, En) => "edge",
            (Key::ScanEdge, It) => "lato",
            (Key::ScanEdge, Cs) => "hrana",
            (Key::ScanEdge, Hr) => "brid",

            (Key::ScanRows, En) => "rows",
            (Key::ScanRows, It) => "righe",
            (Key::ScanRows, Cs) => "řádky",
            (Key::ScanRows, Hr) => "redci",

            (Key::SharedEdgeSummary, En) => {
                "Two triangles with a common edge: one owner a pixel, and what comes without the rule"
            }
            (Key::SharedEdgeSummary, It) => {
                "Due triangoli con un lato comune: un solo proprietario per pixel, e che cosa succede senza regola"
            }
            (Key::SharedEdgeSummary, Cs) => {
                "Dva trojúhelníky se společnou hranou: každý pixel má jednoho vlastníka, a co nastane bez pravidla"
            }
            (Key::SharedEdgeSummary, Hr) => {
                "Dva trokuta sa zajedničkim bridom: svaki piksel ima jednog vlasnika, i što biva bez pravila"
            }

            (Key::SharedEdgeCaption, En) => {
                "The edge runs through six centres. A centre on an edge belongs to the triangle for which the edge is a top or a left one."
            }
            (Key::SharedEdgeCaption, It) => {
                "Il lato passa per sei centri. Un centro su un lato appartiene al triangolo per cui quel lato è in alto o a sinistra."
            }
            (Key::SharedEdgeCaption, Cs) => {
                "Hrana prochází šesti středy. Střed na hraně patří trojúhelníku, pro který je hrana horní nebo levá."
            }
            (Key::SharedEdgeCaption, Hr) => {
                "Brid prolazi kroz šest središta. Središte na bridu pripada trokutu kojemu je taj brid gornji ili lijevi."
            }

            (Key::SharedTopLeft, En) => "top-left rule: one owner each",
            (Key::SharedTopLeft, It) => "alto-sinistra: un solo proprietario",
            (Key::SharedTopLeft, Cs) => "vlevo-nahoře: jeden vlastník",
            (Key::SharedTopLeft, Hr) => "gore-lijevo: jedan vlasnik",

            (Key::SharedClosed, En) => "edges count as inside: drawn twice",
            (Key::SharedClosed, It) => "lati compresi: disegnati due volte",
            (Key::SharedClosed, Cs) => "hrany patří dovnitř: kresleno dvakrát",
            (Key::SharedClosed, Hr) => "bridovi unutra: crtano dvaput",

            (Key::SharedOpen, En) => "edges count as outside: gaps",
            (Key::SharedOpen, It) => "lati esclusi: buchi",
            (Key::SharedOpen, Cs) => "hrany patří ven: mezery",
            (Key::SharedOpen, Hr) => "bridovi izvan: rupe",

            (Key::SliverSummary, En) => "A long thin triangle: pixels found against area",
            (Key::SliverSummary, It) => "Un triangolo stretto e lungo: pixel trovati e area",
            (Key::SliverSummary, Cs) => "Dlouhý úzký trojúhelník: nalezené pixely a obsah",
            (Key::SliverSummary, Hr) => "Dug i uzak trokut: nađeni pikseli i površina",

            (Key::SliverCaption, En) => {
                "The same triangle three times, each time an eighth of a pixel lower. Only centres count, so its pixels depend on where it lies."
            }
            (Key::SliverCaption, It) => {
                "Lo stesso triangolo tre volte, ogni volta un ottavo di pixel più in basso. Contano solo i centri: i pixel dipendono da dove sta."
            }
            (Key::SliverCaption, Cs) => {
                "Týž trojúhelník třikrát, pokaždé o osminu pixelu níž. Počítají se jen středy, a tak pixely závisejí na jeho poloze."
            }
            (Key::SliverCaption, Hr) => {
                "Isti trokut tri puta, svaki put za osminu piksela niže. Broje se samo središta, pa pikseli ovise o tome gdje leži."
            }

            (Key::Area, En) => "area",
            (Key::Area, It) => "area",
            (Key::Area, Cs) => "obsah",
            (Key::Area, Hr) => "površina",

            (Key::PointWindowSummary, En) => "A point and the window: four inequalities",
            (Key::PointWindowSummary, It) => {
                "Un punto e il rettangolo di clipping: quattro disuguaglianze"
            }
            (Key::PointWindowSummary, Cs) => "Bod a okno: čtyři nerovnosti",
            (Key::PointWindowSummary, Hr) => "Točka i prozor: četiri nejednakosti",

            (Key::PointWindowCaption, En) => {
                "A point is inside when all four hold; the border belongs to the window."
            }
            (Key::PointWindowCaption, It) => {
                "Un punto è interno se valgono tutte e quattro; il bordo appartiene al rettangolo."
            }
            (Key::PointWindowCaption, Cs) => {
                "Bod leží uvnitř, platí-li všechny čtyři; hranice patří k oknu."
            }
            (Key::PointWindowCaption, Hr) => {
                "Točka je unutra ako vrijede sve četiri; rub pripada prozoru."
            }

            (Key::SegmentCasesSummary, En) => {
                "Where the ends of a segment can lie, and what is kept of it"
            }
            (Key::SegmentCasesSummary, It) => {
                "Dove possono stare gli estremi di un segmento e che cosa ne resta"
            }
            (Key::SegmentCasesSummary, Cs) => "Kde mohou ležet konce úsečky a co z ní zůstane",
            (Key::SegmentCasesSummary, Hr) => "Gdje mogu ležati krajevi dužine i što od nje ostaje",

            (Key::SegmentCasesCaption, En) => {
                "*G*′ and *H*′ lie on sides of the window; *I*′ and *J*′ only on the lines through them: nothing of *IJ* is kept."
            }
            (Key::SegmentCasesCaption, It) => {
                "*G*′ e *H*′ stanno sui lati del rettangolo; *I*′ e *J*′ solo sulle rette su cui giacciono i lati: di *IJ* non resta nulla."
            }
            (Key::SegmentCasesCaption, Cs) => {
                "*G*′ a *H*′ leží na stranách okna; *I*′ a *J*′ jen na přímkách stran: z *IJ* nezůstane nic."
            }
            (Key::SegmentCasesCaption, Hr) => {
                "*G*′ i *H*′ leže na stranicama prozora; *I*′ i *J*′ samo na pravcima stranica: od *IJ* ne ostaje ništa."
            }

            (Key::OutcodesSummary, En) => "The nine regions around a window and their codes",
            (Key::OutcodesSummary, It) => {
                "Le nove regioni intorno al rettangolo di clipping e i loro codici"
            }
            (Key::OutcodesSummary, Cs) => "Devět oblastí kolem okna a jejich kódy",
            (Key::OutcodesSummary, Hr) => "Devet područja oko prozora i njihovi kodovi",

            (Key::OutcodesCaption, En) => {
                "Each bit stands for one side: 1 where a point lies beyond it. Inside all are 0."
            }
            (Key::OutcodesCaption, It) => {
                "Ogni bit sta per un lato: 1 dove il punto è oltre. All'interno sono tutti 0."
            }
            (Key::OutcodesCaption, Cs) => {
                "Každý bit patří jedné straně: 1, leží-li bod za ní. Uvnitř jsou všechny 0."
            }
            (Key::OutcodesCaption, Hr) => {
                "Svaki bit pripada jednoj stranici: 1 ako je točka iza nje. Unutra su svi 0."
            }

            (Key::Bit, En) => "bit",
            (Key::Bit, It) => "bit",
            (Key::Bit, Cs) => "bit",
            (Key::Bit, Hr) => "bit",

            (Key::CohenSutherlandSummary, En) => {
                "Cohen–Sutherland: a segment cut twice, with its codes at every step"
            }
            (Key::CohenSutherlandSummary, It) => {
                "Cohen–Sutherland: un segmento tagliato due volte, con i codici a ogni passo"
            }
            (Key::CohenSutherlandSummary, Cs) => {
                "Cohen–Sutherland: úsečka dvakrát oříznutá, s kódy v každém kroku"
            }
            (Key::CohenSutherlandSummary, Hr) => {
                "Cohen–Sutherland: dužina dvaput odsječena, s kodovima u svakom koraku"
            }

            (Key::CohenSutherlandCaption, En) => {
                "OR = 0000 accepts, AND ≠ 0000 rejects. Otherwise the first bit that differs says where to cut, and both are tested again."
            }
            (Key::CohenSutherlandCaption, It) => {
                "OR = 0000 accetta, AND ≠ 0000 rifiuta. Altrimenti il primo bit discordante dice dove tagliare, e si ripetono i due test."
            }
            (Key::CohenSutherlandCaption, Cs) => {
                "OR = 0000 přijímá, AND ≠ 0000 zamítá. Jinak první odlišný bit určí řez a oba testy se opakují."
            }
            (Key::CohenSutherlandCaption, Hr) => {
                "OR = 0000 prihvaća, AND ≠ 0000 odbacuje. Inače prvi različiti bit kaže gdje rezati i obje se provjere ponavljaju."
            }

            (Key::Accept, En) => "accepted",
            (Key::Accept, It) => "accettato",
            (Key::Accept, Cs) => "přijato",
            (Key::Accept, Hr) => "prihvaćeno",

            (Key::Reject, En) => "rejected",
            (Key::Reject, It) => "rifiutato",
            (Key::Reject, Cs) => "zamítnuto",
            (Key::Reject, Hr) => "odbačeno",

            (Key::CutAt, En) => "cut at",
            (Key::CutAt, It) => "taglio a",
            (Key::CutAt, Cs) => "řez na",
            (Key::CutAt, Hr) => "rez na",

            (Key::SutherlandHodgmanSummary, En) => {
                "Sutherland–Hodgman: a concave polygon after each of the four lines"
            }
            (Key::SutherlandHodgmanSummary, It) => {
                "Sutherland–Hodgman: un poligono concavo dopo ognuna delle quattro rette"
            }
            (Key::SutherlandHodgmanSummary, Cs) => {
                "Sutherland–Hodgman: nekonvexní polygon po každé ze čtyř přímek"
            }
            (Key::SutherlandHodgmanSummary, Hr) => {
                "Sutherland–Hodgman: konkavni poligon nakon svakog od četiri pravca"
            }

            (Key::SutherlandHodgmanCaption, En) => {
                "Each line keeps what lies on its inner side; what is left goes on to the next."
            }
            (Key::SutherlandHodgmanCaption, It) => {
                "Ogni retta conserva ciò che sta dalla sua parte interna; ciò che resta passa alla successiva."
            }
            (Key::SutherlandHodgmanCaption, Cs) => {
                "Každá přímka ponechá, co leží na její vnitřní straně; zbytek jde k další."
            }
            (Key::SutherlandHodgmanCaption, Hr) => {
                "Svaki pravac zadržava što je na njegovoj unutarnjoj strani; ostatak ide na sljedeći."
            }

            (Key::PolygonCasesSummary, En) => {
                "What clipping makes of a polygon: one, several pieces, always closed"
            }
            (Key::PolygonCasesSummary, It) => {
                "Che cosa diventa un poligono: uno, più componenti, sempre chiusi"
            }
            (Key::PolygonCasesSummary, Cs) => {
                "Co se stane s polygonem: jeden, více částí, vždy uzavřené"
            }
            (Key::PolygonCasesSummary, Hr) => {
                "Što postaje od poligona: jedan, više dijelova, uvijek zatvoreni"
            }

            (Key::PolygonCasesCaption, En) => {
                "A bridge edge runs back and forth along the border between two pieces. In C the thick edges alone would be loose; the border closes them."
            }
            (Key::PolygonCasesCaption, It) => {
                "Un lato ponte percorre il bordo avanti e indietro tra due componenti. In C i lati spessi da soli sarebbero sconnessi; il bordo li chiude."
            }
            (Key::PolygonCasesCaption, Cs) => {
                "Spojovací hrana běží mezi dvěma částmi po hranici tam a zpět. V C by samy tlusté hrany byly volné; uzavírá je hranice."
            }
            (Key::PolygonCasesCaption, Hr) => {
                "Spojni brid ide rubom između dvaju dijelova naprijed i natrag. U C bi sami debeli bridovi bili slobodni; rub ih zatvara."
            }

            (Key::CaseConvex, En) => "A convex: one polygon",
            (Key::CaseConvex, It) => "A convesso: un poligono",
            (Key::CaseConvex, Cs) => "A konvexní: jeden polygon",
            (Key::CaseConvex, Hr) => "A konveksan: jedan poligon",

            (Key::CaseBridges, En) => "B concave: a bridge edge",
            (Key::CaseBridges, It) => "B concavo: un lato ponte",
            (Key::CaseBridges, Cs) => "B nekonvexní: spojovací hrana",
            (Key::CaseBridges, Hr) => "B konkavan: spojni brid",

            (Key::CasePieces, En) => "B: separate pieces",
            (Key::CasePieces, It) => "B: componenti separate",
            (Key::CasePieces, Cs) => "B: oddělené části",
            (Key::CasePieces, Hr) => "B: odvojeni dijelovi",

            (Key::CaseClosed, En) => "C: closed, not loose segments",
            (Key::CaseClosed, It) => "C: chiuso, non segmenti sconnessi",
            (Key::CaseClosed, Cs) => "C: uzavřený, ne volné úsečky",
            (Key::CaseClosed, Hr) => "C: zatvoren, ne slobodne dužine",
        }
    }
}
