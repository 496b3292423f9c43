//! A solid cut across: which faces look towards the eye.

mod outline;

use ombra_hsr::back_face::is_front_facing;
use std::sync::Arc;

use ombra_math::glam::DVec2;

use self::outline::{Chain, Face, bounds, of_mesh, of_prism};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, FillRule, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::object::NamedMesh;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Label, Sheet};
use crate::style::Language;
use crate::text::LABEL;
use crate::words::{Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/back-face",
    takes: Takes::These(&[EYE.input, POLYGON.input, OBJECT.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| draw(sheet, &Solid::new(inputs)?),
};

words! {
    SUMMARY {
        en: "A solid cut across, the normals of its faces and the vectors to the eye: kept and culled faces",
        it: "Un solido in sezione, le normali delle facce e i vettori verso l’osservatore: facce tenute ed eliminate",
        cs: "Řez tělesem, normály stěn a vektory k pozorovateli: ponechané a vyřazené stěny",
        hr: "Presjek tijela, normale stranica i vektori prema oku: zadržane i odbačene stranice",
    }

    CAPTION {
        en: "**n** looks out of the solid, **v** from the face towards the eye. With **n**·**v** < 0 a face is turned away and certainly hidden.",
        it: "**n** esce dal solido, **v** va dalla faccia verso l’osservatore. Con **n**·**v** < 0 la faccia è posteriore e certamente non visibile.",
        cs: "**n** míří ven z tělesa, **v** od stěny k pozorovateli. Při **n**·**v** < 0 je stěna odvrácená a jistě není vidět.",
        hr: "**n** gleda iz tijela, **v** od stranice prema oku. Uz **n**·**v** < 0 stranica je okrenuta od oka i sigurno se ne vidi.",
    }

    /// An input.
    EYE_OF {
        en: "the eye, in the plane of the section",
        it: "l’osservatore, nel piano della sezione",
        cs: "pozorovatel v rovině řezu",
        hr: "oko u ravnini presjeka",
    }

    /// An input.
    POLYGON_OF {
        en: "the prism across its faces, corner by corner",
        it: "la sezione del prisma, vertice per vertice",
        cs: "řez hranolem, vrchol po vrcholu",
        hr: "presjek prizme, vrh po vrh",
    }

    /// An input.
    OBJECT_OF {
        en: "an object cut across, instead of the prism and at its size",
        it: "un oggetto in sezione, al posto del prisma e grande come esso",
        cs: "těleso v řezu místo hranolu, stejně velké",
        hr: "presječen objekt umjesto prizme, iste veličine",
    }

    /// What becomes of a face that may be seen.
    KEPT {
        en: "kept",
        it: "tenuta",
        cs: "ponechaná",
        hr: "zadržana",
    }

    /// What becomes of a face that is turned away.
    CULLED {
        en: "culled",
        it: "eliminata",
        cs: "vyřazená",
        hr: "odbačena",
    }
}

/// The eye; that of an object stands to it as it would to the prism.
const EYE: Ask<DVec2> = Ask::point("eye", "", EYE_OF, [-9.0, 1.0], [[-30.0; 2], [30.0; 2]]);
/// A prism across its faces, either way round.
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "",
    POLYGON_OF,
    &PRISM,
    [3, 12],
    [[-10.0; 2], [10.0; 2]],
);
/// An object instead of the prism.
const OBJECT: Ask<Arc<NamedMesh>> = Ask::object("mesh", "", OBJECT_OF, "prism");

/// The lecture's prism, the middle of its box and half the diagonal of it.
const PRISM: [[f64; 2]; 6] = [
    [-3.0, -1.0],
    [0.0, -3.0],
    [3.0, -2.0],
    [4.0, 1.0],
    [1.0, 3.0],
    [-2.0, 2.0],
];
const MIDDLE: DVec2 = DVec2::new(0.5, 0.0);
const RADIUS: f64 = 4.609_772_228_646_444;
/// The length of arrows, in half diagonals of the solid's box.
const ARROW: f64 = 0.33;
/// Arrows begin farther apart than this, in lengths of an arrow.
const APART: f64 = 1.1;
/// Radius of the arc between two arrows, in their length.
const ARC: f64 = 0.5;
/// Cosine of an angle, 26°, that shows no arc.
const CLOSE: f64 = 0.9;

/// A solid cut across, and the eye.
struct Solid {
    chains: Vec<Chain>,
    eye: DVec2,
    arrow: f64,
    /// Whether there are so few faces that each says what becomes of it.
    has_few: bool,
}

impl Solid {
    /// The prism or the instructor's object.
    fn new(inputs: &Inputs) -> Result<Solid, FigureError> {
        let own = inputs.has(&OBJECT);
        let object = inputs.get(&OBJECT);
        let chains = if own {
            of_mesh(&object.mesh)
        } else {
            let corners = outline::simple(&inputs.get(&POLYGON)).ok_or_else(|| FigureError::Scene {
                reason: format!(
                    "polygon: {} has to be cut into a closed outline without crossings; this one's sides cross, touch or bound no area",
                    FIGURE.id
                ),
            })?;
            vec![of_prism(&corners)]
        };
        let Some(bounds) = bounds(&chains) else {
            return Err(FigureError::Scene {
                reason: format!(
                    "--mesh {}: no face of it crosses the planes through the middle of its box along which {} cuts it",
                    object.name, FIGURE.id
                ),
            });
        };
        let radius = 0.5 * bounds.size().length();
        let mut eye = inputs.get(&EYE);
        if own {
            eye = bounds.centre() + (eye - MIDDLE) * (radius / RADIUS);
        }
        Ok(Solid {
            chains,
            eye,
            arrow: ARROW * radius,
            has_few: !own,
        })
    }

    /// Whether the eye is in it.
    fn is_inside(&self) -> bool {
        let right_of_it = |face: &&Face| {
            let [a, b] = face.ends;
            let eye = self.eye;
            (a.y > eye.y) != (b.y > eye.y) && {
                let x = a.x + (b.x - a.x) * ((eye.y - a.y) / (b.y - a.y));
                x > eye.x
            }
        };
        let closed = self.chains.iter().filter(|chain| chain.closed);
        let crossed = closed.flat_map(|chain| &chain.faces).filter(right_of_it);
        crossed.count() % 2 == 1
    }

    fn faces(&self) -> impl Iterator<Item = &Face> {
        self.chains.iter().flat_map(|chain| &chain.faces)
    }

    /// From a face towards the eye.
    fn view(&self, face: &Face) -> DVec2 {
        self.eye - face.middle()
    }

    /// The tips of a face's arrows: its normal, and towards the eye.
    fn tips(&self, face: &Face) -> [DVec2; 2] {
        let tip = |v: DVec2| face.middle() + self.arrow * v.normalize_or_zero();
        [face.normal, self.view(face)].map(tip)
    }

    fn is_kept(&self, face: &Face) -> bool {
        let flat = |v: DVec2| v.extend(0.0);
        is_front_facing(flat(face.normal), flat(self.view(face)))
    }

    /// The cosine of the angle between a face's arrows.
    fn cosine(&self, face: &Face) -> f64 {
        let unit = DVec2::normalize_or_zero;
        unit(face.normal).dot(unit(self.view(face)))
    }

    /// The faces that show their arrows: far enough from each other, the longest first.
    fn shown(&self) -> Vec<&Face> {
        let mut faces: Vec<&Face> = self.faces().collect();
        let length = |face: &Face| {
            let [a, b] = face.ends;
            a.distance(b)
        };
        faces.sort_by(|a, b| length(b).total_cmp(&length(a)));
        let mut shown: Vec<&Face> = Vec::new();
        for face in faces {
            let apart = |other: &&Face| other.middle().distance(face.middle()) > APART * self.arrow;
            if shown.iter().all(apart) {
                shown.push(face);
            }
        }
        shown
    }

    /// The stretches of one kind: faces one after the other that are all kept, or all culled.
    fn stretches(&self) -> Vec<(bool, Vec<DVec2>)> {
        let mut stretches: Vec<(bool, Vec<DVec2>)> = Vec::new();
        for Chain { faces, closed } in &self.chains {
            let kept: Vec<bool> = faces.iter().map(|face| self.is_kept(face)).collect();
            let neighbours = kept.iter().zip(kept.iter().cycle().skip(1));
            // A closed chain is begun where the kind changes.
            let change = neighbours.clone().position(|(a, b)| a != b);
            let first = change.filter(|_| *closed).map_or(0, |i| i + 1);
            let both = faces.iter().zip(kept.iter().copied());
            let order = both.clone().skip(first).chain(both.take(first));
            let mut last = None;
            for (face, kept) in order {
                let [a, b] = face.ends;
                match stretches.last_mut() {
                    Some((_, points)) if last == Some(kept) => points.push(b),
                    _ => stretches.push((kept, vec![a, b])),
                }
                last = Some(kept);
            }
        }
        stretches
    }

    /// The ends of faces that the eye sees farthest to one side and to the other.
    fn silhouette(&self) -> [DVec2; 2] {
        let ends: Vec<DVec2> = self.faces().flat_map(|face| face.ends).collect();
        let farthest = |side: f64| {
            // Of two, the one that the other lies on the inner side of.
            let outer = |a: DVec2, b: DVec2| {
                if side * (a - self.eye).perp_dot(b - self.eye) > 0.0 {
                    b
                } else {
                    a
                }
            };
            ends.iter().copied().reduce(outer).unwrap_or(self.eye)
        };
        [farthest(1.0), farthest(-1.0)]
    }
}

/// Texts beside arrows, on the side they point to; what would meet another goes where there is room.
struct Texts {
    boxes: Vec<Rect>,
    frame: Rect,
}

impl Texts {
    /// What a text beyond `tip` covers: it begins there and lies in front of the line across `along`.
    fn place(sheet: &Sheet, tip: DVec2, along: DVec2, markup: &str) -> Result<Rect, FigureError> {
        let line = sheet.lay_out(markup, LABEL)?;
        // Accents rise and tails hang: all of them count.
        let half = 0.5 * line.bounds(DVec2::ZERO).size();
        let along = along.normalize_or_zero();
        let aside = (along * STEEP).clamp(DVec2::NEG_ONE, DVec2::ONE);
        let centre = tip + along * OFF + aside * half;
        Ok(Rect::new(centre - half, centre + half))
    }

    fn put(&mut self, sheet: &mut Sheet, label: Label) -> Result<(), FigureError> {
        let place = Texts::place(sheet, label.anchor, label.towards, &label.markup)?;
        let is_free = self.boxes.iter().all(|other| !other.meets(&place));
        if is_free && self.frame.grown(HAIR).contains(&place) {
            let line = sheet.lay_out(&label.markup, LABEL)?;
            let start = place.min - line.bounds(DVec2::ZERO).min;
            let bounds = sheet.set_at(line, start, label.ink);
            self.boxes.push(bounds.grown(6.0));
        } else {
            sheet.label(Label {
                may_lead: true,
                ..label
            });
        }
        Ok(())
    }
}

/// A text's nearest corner keeps this far off the tip; the middle of its side is there where an arrow is steeper than
/// one in so many.
const OFF: f64 = 8.0;
const STEEP: f64 = 2.5;
/// What a text may reach into the margin: nothing on the canvas.
const HAIR: f64 = 0.01;
/// Room for the mark of the eye, and how far rays keep off it.
const AROUND_EYE: f64 = 30.0;
const RIM: f64 = 38.0;

/// Where texts may stand: within the frame, whatever rounding does.
fn inner(sheet: &Sheet) -> Rect {
    sheet.frame().grown(-1.0)
}

/// The section as large as it fits with what is said beyond its normals.
fn fitted(sheet: &Sheet, solid: &Solid, said: &[(&Face, String)]) -> Result<Section, FigureError> {
    let mut points = vec![solid.eye];
    points.extend(solid.faces().flat_map(|face| face.ends));
    points.extend(said.iter().flat_map(|(face, _)| solid.tips(face)));
    let frame = inner(sheet);
    let mut room = frame.grown(-AROUND_EYE);
    let mut section = Section::fit(&points, room)?;
    // What is written keeps its size while the rest shrinks, so that a few rounds find a balance.
    for _ in 0..16 {
        let (mut low, mut high) = (DVec2::ZERO, DVec2::ZERO);
        for (face, words) in said.iter().filter(|(_, words)| !words.is_empty()) {
            let [normal, _] = solid.tips(face).map(|p| section.at(p));
            let along = normal - section.at(face.middle());
            let place = Texts::place(sheet, normal, along, words)?;
            low = low.max(frame.min - place.min);
            high = high.max(place.max - frame.max);
        }
        if low.max(high).max_element() <= HAIR {
            break;
        }
        let smaller = Rect::new(room.min + low, room.max - high);
        if !smaller.size().cmpgt(frame.size() * 0.25).all() {
            break;
        }
        room = smaller;
        section = Section::fit(&points, room)?;
    }
    Ok(section)
}

fn draw(sheet: &mut Sheet, solid: &Solid) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let shown = solid.shown();
    let examples = [true, false].map(|kept| example(solid, &shown, kept));
    let said = |face: &Face| {
        let kept = solid.is_kept(face);
        if examples.contains(&Some(face)) {
            verdict(kept, language)
        } else if solid.has_few {
            word(kept).text(language).to_owned()
        } else {
            String::new()
        }
    };
    let said: Vec<(&Face, String)> = shown.iter().map(|&face| (face, said(face))).collect();
    let section = fitted(sheet, solid, &said)?;

    let mut inside = Path::new();
    for chain in solid.chains.iter().filter(|chain| chain.closed) {
        let outline: Vec<DVec2> = chain.faces.iter().map(|f| section.at(f.ends[0])).collect();
        inside.add_polygon(&outline);
    }
    let tint = Ink::of(Role::Occluder).tint(0.16);
    sheet.shape(inside, Some((tint.into(), FillRule::EvenOdd)), None);

    // Until the faces are told apart they look alike.
    for step in 1..LAST {
        sheet.step_alone(step);
        for face in solid.faces() {
            let [a, b] = face.ends.map(|p| section.at(p));
            sheet.line(a, b, Pen::new(Role::Occluder, NORMAL));
        }
    }
    let eye = section.at(solid.eye);
    sheet.step(2);
    if !solid.is_inside() {
        // Sight lines that graze it.
        for corner in solid.silhouette().map(|p| section.at(p)) {
            let along = (corner - eye).normalize_or_zero();
            if corner.distance(eye) > RIM {
                marks::ray(sheet, eye + along * RIM, corner);
            }
        }
    }
    sheet.step(LAST);
    for (kept, points) in solid.stretches() {
        let pen = if kept {
            Pen::new(Role::Chosen, EMPHASIS)
        } else {
            Pen::new(Role::Rejected, NORMAL).dashed()
        };
        let points: Vec<DVec2> = points.into_iter().map(|p| section.at(p)).collect();
        sheet.stroke(Path::polyline(&points), pen);
    }
    let mut texts = Texts {
        boxes: vec![Rect::new(eye, eye).grown(AROUND_EYE)],
        frame: inner(sheet),
    };
    for (face, words) in said {
        let at = section.at(face.middle());
        let [normal, view] = solid.tips(face).map(|p| section.at(p));
        sheet.step(2);
        marks::arrow(sheet, at, view, Role::Ray, NORMAL);
        sheet.step(1);
        marks::normal(sheet, at, normal);
        let kept = solid.is_kept(face);
        sheet.step(LAST);
        if !words.is_empty() {
            let ink = if kept { Role::Chosen } else { Role::Note };
            let label = Label::new(normal, words).towards(normal - at).ink(ink);
            texts.put(sheet, label.beside())?;
        }
        if examples.contains(&Some(face)) {
            draw_angle(sheet, &mut texts, at, [normal, view], kept)?;
        }
    }
    sheet.step(2);
    let middle = looked_at(solid);
    marks::eye(sheet, eye, section.at(middle) - eye);
    sheet.whole();
    Ok(())
}

/// The last step: the faces are told apart.
const LAST: usize = 3;

/// What the eye looks at.
fn looked_at(solid: &Solid) -> DVec2 {
    bounds(&solid.chains).map_or(solid.eye, |bounds| bounds.centre())
}

/// Of the faces kept, or of those culled, the one whose angle is nearest to 60°, or to 120°; of faces much alike the
/// outer one, with room for its label.
fn example<'a>(solid: &Solid, shown: &[&'a Face], kept: bool) -> Option<&'a Face> {
    let clearest = if kept { 0.5 } else { -0.5 };
    let away = |face: &Face| solid.view(face).length() / solid.arrow;
    let outer = |face: &Face| if kept { away(face) } else { -away(face) };
    let off = |face: &Face| (solid.cosine(face) - clearest).abs() + 0.02 * outer(face);
    let faces = shown.iter().filter(|face| solid.is_kept(face) == kept);
    faces.copied().min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// What becomes of a face.
fn word(kept: bool) -> Word {
    if kept { KEPT } else { CULLED }
}

/// What becomes of a face, and why.
fn verdict(kept: bool, language: Language) -> String {
    let sign = if kept { "≥" } else { "<" };
    format!("**n**·**v** {sign} 0: {}", word(kept).text(language))
}

/// The angle between the normal and the vector to the eye, all three with their names.
fn draw_angle(
    sheet: &mut Sheet,
    texts: &mut Texts,
    at: DVec2,
    [normal, view]: [DVec2; 2],
    kept: bool,
) -> Result<(), FigureError> {
    let [n, v] = [normal - at, view - at];
    let radius = ARC * n.length();
    let cosine = n.normalize_or_zero().dot(v.normalize_or_zero());
    // There is no room between arrows that lie close together.
    if cosine.abs() < CLOSE {
        let along = |i: u32| n.lerp(v, f64::from(i) / 24.0).normalize_or_zero();
        let arc: Vec<DVec2> = (0..=24).map(|i| at + radius * along(i)).collect();
        sheet.stroke(Path::polyline(&arc), Pen::new(Role::Note, THIN));
        let angle = if kept { "*θ* ≤ 90°" } else { "*θ* > 90°" };
        let label = Label::new(at + radius * along(12), angle).towards(along(12));
        texts.put(sheet, label.reach(2.0).beside())?;
    }
    // Each on the side that the arc leaves free, that of the vector to the eye at its tip, off the face.
    for (step, arrow, other, share, name, ink) in [
        (1, n, v, 0.7, "**n**", Role::Normal),
        (2, v, n, 1.0, "**v**", Role::Ray),
    ] {
        sheet.step(step);
        let along = arrow.normalize_or_zero();
        let across = along.perp();
        let away = if across.dot(other) > 0.0 {
            -across
        } else {
            across
        };
        let towards = if share < 1.0 {
            away
        } else {
            along + 0.4 * away
        };
        let label = Label::new(at + share * arrow, name).towards(towards);
        texts.put(sheet, label.ink(ink).beside())?;
    }
    sheet.step(LAST);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::drawn::drawn;
    use super::*;
    use crate::object::{NamedMesh, SOLIDS, from_obj};
    use ombra_hsr::back_face::visible;
    use ombra_math::glam::DVec3;
    use ombra_math::homogeneous::point;
    use ombra_math::mesh::Mesh;

    fn prism(eye: DVec2) -> Solid {
        let chains = vec![of_prism(&PRISM.map(DVec2::from))];
        Solid {
            chains,
            eye,
            arrow: 1.5,
            has_few: true,
        }
    }

    fn solid(named: &str) -> Solid {
        let inputs = Inputs::default().with(&OBJECT.input, named).unwrap();
        Solid::new(&inputs).unwrap()
    }

    fn of_text(text: &str) -> Result<Solid, FigureError> {
        let mesh = from_obj(text).unwrap();
        let name = "own.obj".to_owned();
        Solid::new(&Inputs::default().with_object(&OBJECT, NamedMesh { name, mesh }))
    }

    /// The sides of the prism itself, two triangles each, in the order of its faces.
    fn sides() -> Mesh {
        let level = |z: f64| PRISM.map(|[x, y]| DVec3::new(x, y, z));
        let n = PRISM.len() as u32;
        let triangles = (0..n).flat_map(|i| {
            let (j, up) = ((i + 1) % n, n);
            [[i, j, j + up], [i, j + up, i + up]]
        });
        Mesh::new([level(-1.0), level(1.0)].concat(), triangles.collect()).unwrap()
    }

    #[test]
    fn the_faces_kept_are_those_the_solid_shows() {
        // In front, from above to the right, from behind: what is kept turns with the eye.
        for (eye, expected) in [
            (DVec2::new(-9.0, 1.0), vec![0, 4, 5]),
            (DVec2::new(6.0, 7.0), vec![2, 3, 4]),
            (DVec2::new(9.0, -1.0), vec![1, 2, 3]),
        ] {
            let solid = prism(eye);
            let faces: Vec<&Face> = solid.faces().collect();
            let kept: Vec<usize> = (0..6).filter(|&i| solid.is_kept(faces[i])).collect();
            assert_eq!(kept, expected, "{eye}");
            let of_mesh: Vec<usize> = visible(&sides(), point(eye.extend(0.0)));
            let twice: Vec<usize> = kept.iter().flat_map(|i| [2 * i, 2 * i + 1]).collect();
            assert_eq!(of_mesh, twice, "{eye}");
        }
    }

    /// A convex solid shows one stretch of its outline, between the two sight lines that graze it.
    #[test]
    fn the_kept_stretch_lies_between_the_sight_lines() {
        for solid in [prism(DVec2::new(-9.0, 1.0)), solid("cube"), solid("sphere")] {
            let stretches = solid.stretches();
            assert_eq!(stretches.len(), 2);
            let (_, kept) = stretches.iter().find(|(kept, _)| *kept).unwrap();
            let mut ends = [kept[0], *kept.last().unwrap()];
            let mut grazed = solid.silhouette();
            for pair in [&mut ends, &mut grazed] {
                pair.sort_by(|a, b| a.y.total_cmp(&b.y));
            }
            assert_eq!(ends, grazed);
        }
    }

    /// The prism as a mesh, cut across, is the prism.
    #[test]
    fn a_mesh_is_cut_into_its_outline() {
        let [cut] = &of_mesh(&sides())[..] else {
            panic!("one outline")
        };
        assert!(cut.closed);
        // Each side is two triangles; both give a half of it.
        assert_eq!(cut.faces.len(), 12);
        let prism = of_prism(&PRISM.map(DVec2::from));
        for face in &cut.faces {
            let [a, b] = face.ends;
            let on = |side: &&Face| {
                let [p, q] = side.ends;
                // Sums and products of a few numbers below 8, halves among them: exact.
                [a, b].iter().all(|&end| (q - p).perp_dot(end - p) == 0.0)
            };
            let side = prism.faces.iter().find(on).unwrap();
            let unit = DVec2::normalize_or_zero;
            assert!((unit(side.normal) - unit(face.normal)).length() < 1e-15);
            // The solid on the left.
            assert!((b - a).perp_dot(face.normal) < 0.0);
        }
    }

    #[test]
    fn a_polygon_that_bounds_no_area_is_refused_and_its_direction_does_not_matter() {
        let of = |text: &str| Solid::new(&Inputs::default().with(&POLYGON.input, text).unwrap());
        for text in [
            "0,0 4,0 0,4 4,4",
            "0,0 4,0 8,0",
            "1,1 1,1 1,1",
            "0,0 4,0 4,4 4,2 4,6",
            "0,0 4,0 2,0 2,3",
        ] {
            let error = of(text).err().map(|error| error.to_string());
            assert!(
                error.is_some_and(|error| error.contains("polygon")),
                "{text}"
            );
        }
        // From the left of a square the eye sees its left side.
        for text in ["0,-2 4,-2 4,2 0,2", "0,2 4,2 4,-2 0,-2"] {
            let solid = of(text).unwrap();
            let kept: Vec<&Face> = solid.faces().filter(|face| solid.is_kept(face)).collect();
            assert_eq!(kept.len(), 1, "{text}");
            assert_eq!(kept[0].middle(), DVec2::ZERO, "{text}");
        }
    }

    /// From inside every face is turned away, and no sight line grazes any.
    #[test]
    fn an_eye_inside_sees_no_face() {
        let inputs = Inputs::default().with(&EYE.input, "0,0").unwrap();
        let solid = Solid::new(&inputs).unwrap();
        assert!(solid.is_inside() && solid.faces().all(|face| !solid.is_kept(face)));
        let drawing = drawn(|sheet| draw(sheet, &solid));
        assert!(
            !drawing
                .labels
                .iter()
                .any(|label| label.text.contains("kept"))
        );
    }

    /// A verdict stands wholly outside the convex prism, in every language.
    #[test]
    fn what_becomes_of_a_face_is_said_outside_the_solid() {
        for &language in Language::ALL {
            for (width, height) in [(1920, 1080), (1024, 768)] {
                let style = crate::style::Style {
                    language,
                    size: crate::style::Size::new(width, height).unwrap(),
                    ..crate::style::Style::default()
                };
                let drawing = FIGURE.draw(&style, &Inputs::default()).unwrap();
                // The solid is the only area with its tint.
                let tint = Ink::of(Role::Occluder).tint(0.16);
                let areas = super::super::drawn::fills(&drawing);
                let area = areas.iter().find(|(ink, _)| *ink == tint).unwrap().1;
                let corners: Vec<DVec2> = area.points().collect();
                let words = [KEPT, CULLED].map(|word| word.text(language));
                let said = |text: &str| words.iter().any(|word| text.ends_with(word));
                let mut count = 0;
                for label in drawing.labels.iter().filter(|label| said(&label.text)) {
                    count += 1;
                    let Rect { min, max } = label.bounds;
                    let of_label = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
                    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
                    let mut sides =
                        ends.map(|(&a, &b)| of_label.map(|p| (b - a).perp_dot(p - a) > 0.0));
                    // y points down: the solid is on the right of its sides.
                    assert!(
                        sides.any(|outside| outside == [true; 4]),
                        "{language} {}",
                        label.text
                    );
                }
                let all: Vec<&str> = drawing
                    .labels
                    .iter()
                    .map(|label| label.text.as_str())
                    .collect();
                assert_eq!(
                    count, 6,
                    "{language} {width}: {all:?}, over: {:?}",
                    drawing.over
                );
            }
        }
    }

    #[test]
    fn every_solid_is_cut_into_closed_outlines_and_drawn() {
        for name in SOLIDS.split(", ") {
            let solid = solid(name);
            let outlines = solid.chains.iter().filter(|chain| chain.closed).count();
            // A ring is cut twice; the teapot is open: its lid lies on its body, its handle and spout end in it.
            match name {
                "torus" => assert_eq!((outlines, solid.chains.len()), (2, 2)),
                "teapot" => assert!(!solid.chains.is_empty()),
                _ => assert_eq!((outlines, solid.chains.len()), (1, 1), "{name}"),
            }
            let drawing = drawn(|sheet| draw(sheet, &solid));
            for word in ["n·v ≥ 0: kept", "n·v < 0: culled"] {
                assert!(drawing.labels.iter().any(|label| label.text == word));
            }
        }
    }

    #[test]
    fn open_and_flat_objects_are_cut_or_refused() {
        let triangle = of_text("v 0 0 0\nv 10 0 0\nv 0 20 5\nf 1 2 3\n").unwrap();
        assert_eq!(triangle.faces().count(), 1);
        assert!(!triangle.chains[0].closed);
        drawn(|sheet| draw(sheet, &triangle));
        // Across z nothing is cut, across x it is.
        let flat = of_text("v 0 0 3\nv 4 0 3\nv 0 4 3\nf 1 2 3\n").unwrap();
        assert_eq!(flat.faces().count(), 1);
        // Two triangles, each beyond all planes through the middle.
        let apart = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 8 9 9\nv 9 8 9\nf 1 2 3\nf 4 5 6\n";
        let error = of_text(apart).err().unwrap().to_string();
        assert!(
            error.contains("own.obj") && error.contains("hsr/back-face"),
            "{error}"
        );
    }
}
