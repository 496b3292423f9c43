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
use crate::words::{self, words};

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/back-face",
    takes: Takes::These(&[OBJECT.input]),
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

/// An object instead of the prism.
const OBJECT: Ask<Arc<NamedMesh>> = Ask::object("mesh", "", words::OBJECT, "prism");

/// A prism across its faces, counter-clockwise.
const PRISM: [(f64, f64); 6] = [
    (-3.0, -1.0),
    (0.0, -3.0),
    (3.0, -2.0),
    (4.0, 1.0),
    (1.0, 3.0),
    (-2.0, 2.0),
];
/// From the middle of the solid to the eye, and the length of arrows, in half diagonals of its box.
const TO_EYE: DVec2 = DVec2::new(-2.06, 0.22);
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
        let (chains, name) = if own {
            (of_mesh(&object.mesh), object.name.as_str())
        } else {
            (vec![of_prism(&PRISM.map(DVec2::from))], "the prism")
        };
        let Some(bounds) = bounds(&chains) else {
            return Err(FigureError::Scene {
                reason: format!(
                    "--mesh {name}: no face of it crosses the planes through the middle of its box along which {} cuts it",
                    FIGURE.id
                ),
            });
        };
        let radius = 0.5 * bounds.size().length();
        Ok(Solid {
            chains,
            eye: bounds.centre() + radius * TO_EYE,
            arrow: ARROW * radius,
            has_few: !own,
        })
    }

    fn faces(&self) -> impl Iterator<Item = &Face> {
        self.chains.iter().flat_map(|chain| &chain.faces)
    }

    /// From a face towards the eye.
    fn view(&self, face: &Face) -> DVec2 {
        self.eye - face.middle()
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

fn draw(sheet: &mut Sheet, solid: &Solid) -> Result<(), FigureError> {
    // On the right a label below the tip of a normal juts out by half its width.
    let language = sheet.style().language;
    let mut widest = 0.0_f64;
    for kept in [true, false] {
        let label = verdict(DVec2::ZERO, kept, language);
        widest = widest.max(sheet.lay_out(&label.markup, label.size)?.width);
    }
    let frame = sheet.frame();
    let room = Rect::new(
        frame.min + DVec2::new(30.0, 60.0),
        frame.max - DVec2::new(0.5 * widest + 20.0, 60.0),
    );
    let shown = solid.shown();
    let tips = |face: &Face| {
        [face.normal, solid.view(face)].map(|v| face.middle() + solid.arrow * v.normalize_or_zero())
    };
    let mut points = vec![solid.eye];
    points.extend(solid.faces().flat_map(|face| face.ends));
    points.extend(shown.iter().flat_map(|face| tips(face)));
    let section = Section::fit(&points, room)?;

    let mut inside = Path::new();
    for chain in solid.chains.iter().filter(|chain| chain.closed) {
        let outline: Vec<DVec2> = chain.faces.iter().map(|f| section.at(f.ends[0])).collect();
        inside.add_polygon(&outline);
    }
    let tint = Ink::of(Role::Occluder).tint(0.16);
    sheet.shape(inside, Some((tint.into(), FillRule::EvenOdd)), None);

    // Sight lines that graze it.
    let eye = section.at(solid.eye);
    for corner in solid.silhouette().map(|p| section.at(p)) {
        let along = (corner - eye).normalize_or_zero();
        marks::ray(sheet, eye + along * 38.0, corner);
    }
    for (kept, points) in solid.stretches() {
        let pen = if kept {
            Pen::new(Role::Chosen, EMPHASIS)
        } else {
            Pen::new(Role::Rejected, NORMAL).dashed()
        };
        let points: Vec<DVec2> = points.into_iter().map(|p| section.at(p)).collect();
        sheet.stroke(Path::polyline(&points), pen);
    }
    let examples = [true, false].map(|kept| example(solid, &shown, kept));
    for &face in &shown {
        let at = section.at(face.middle());
        let [normal, view] = tips(face).map(|p| section.at(p));
        marks::arrow(sheet, at, view, Role::Ray, NORMAL);
        marks::normal(sheet, at, normal);
        let is_example = examples.contains(&Some(face));
        if is_example {
            draw_angle(sheet, at, [normal, view], solid.is_kept(face));
        }
        if is_example || solid.has_few {
            let label = verdict(normal, solid.is_kept(face), language);
            sheet.label(label.towards(normal - at).beside());
        }
    }
    marks::eye(sheet, eye, DVec2::X);
    Ok(())
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

/// What becomes of a face, at the tip of its normal.
fn verdict(tip: DVec2, kept: bool, language: Language) -> Label {
    let (sign, word, ink) = if kept {
        ("≥", KEPT, Role::Chosen)
    } else {
        ("<", CULLED, Role::Note)
    };
    let words = format!("**n**·**v** {sign} 0: {}", word.text(language));
    Label::new(tip, words).ink(ink)
}

/// The angle between the normal and the vector to the eye, all three with their names.
fn draw_angle(sheet: &mut Sheet, at: DVec2, [normal, view]: [DVec2; 2], kept: bool) {
    let [n, v] = [normal - at, view - at];
    let radius = ARC * n.length();
    let cosine = n.normalize_or_zero().dot(v.normalize_or_zero());
    // There is no room between arrows that lie close together.
    if cosine.abs() < CLOSE {
        let along = |i: u32| n.lerp(v, f64::from(i) / 24.0).normalize_or_zero();
        let arc: Vec<DVec2> = (0..=24).map(|i| at + radius * along(i)).collect();
        sheet.stroke(Path::polyline(&arc), Pen::new(Role::Note, THIN));
        let angle = if kept { "*θ* ≤ 90°" } else { "*θ* > 90°" };
        let label = Label::new(at + radius * along(12), angle);
        sheet.label(label.towards(along(12)).reach(2.0).beside());
    }
    for (tip, name, ink) in [(normal, "**n**", Role::Normal), (view, "**v**", Role::Ray)] {
        // On the side that the arc leaves free.
        let other = if ink == Role::Normal { v } else { n };
        let label = Label::new(at.lerp(tip, 0.75), name).towards((tip - at) * 0.3 - other);
        sheet.label(label.ink(ink).beside());
    }
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
        let level = |z: f64| PRISM.map(|(x, y)| DVec3::new(x, y, z));
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
