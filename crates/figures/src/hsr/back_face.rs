//! A solid cut across: which faces look towards the eye.

use ombra_hsr::back_face::is_front_facing;
use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::number::exact;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Label, Sheet};

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/back-face",
    takes: Takes {
        light: false,
        plane: false,
        mesh: false,
    },
    words: |_| Words {
        summary: Key::BACK_FACE_SUMMARY,
        caption: Key::BACK_FACE_CAPTION,
    },
    drawn: |sheet, _| draw(sheet),
};

const EYE: DVec2 = DVec2::new(-9.0, 1.0);
/// A prism across its faces, counter-clockwise.
const PRISM: [(f64, f64); 6] = [
    (-3.0, -1.0),
    (0.0, -3.0),
    (3.0, -2.0),
    (4.0, 1.0),
    (1.0, 3.0),
    (-2.0, 2.0),
];
/// Length of the arrows.
const ARROW: f64 = 1.5;

/// A face of the prism.
#[derive(Clone, Copy, Debug)]
struct Face {
    ends: [DVec2; 2],
    /// Out of the solid, as long as the face.
    normal: DVec2,
    /// From its middle to the eye.
    towards_eye: DVec2,
    kept: bool,
}

impl Face {
    fn middle(&self) -> DVec2 {
        let [a, b] = self.ends;
        (a + b) * 0.5
    }
}

fn faces(eye: DVec2) -> Vec<Face> {
    let corners = PRISM.map(DVec2::from);
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let face = |(&a, &b): (&DVec2, &DVec2)| {
        let (normal, towards_eye) = (-(b - a).perp(), eye - (a + b) * 0.5);
        let flat = |v: DVec2| v.extend(0.0);
        Face {
            ends: [a, b],
            normal,
            towards_eye,
            kept: is_front_facing(flat(normal), flat(towards_eye)),
        }
    };
    ends.map(face).collect()
}

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let faces = faces(EYE);
    let frame = sheet.frame();
    let room = Rect::new(
        frame.min + DVec2::new(30.0, 60.0),
        frame.max - DVec2::new(150.0, 60.0),
    );
    let mut shown = vec![EYE];
    shown.extend(
        faces
            .iter()
            .map(|face| face.middle() + ARROW * face.normal.normalize_or_zero()),
    );
    let section = Section::fit(&shown, room)?;

    let outline: Vec<DVec2> = PRISM.iter().map(|&p| section.at(p.into())).collect();
    sheet.fill(Path::polygon(&outline), Ink::of(Role::Occluder).tint(0.16));

    // Sight lines that graze it, where kept faces meet culled ones.
    let eye = section.at(EYE);
    for (one, other) in faces.iter().zip(faces.iter().cycle().skip(1)) {
        if one.kept != other.kept {
            let corner = section.at(one.ends[1]);
            let along = (corner - eye).normalize_or_zero();
            marks::ray(sheet, eye + along * 38.0, corner);
        }
    }
    for face in &faces {
        let [a, b] = face.ends.map(|p| section.at(p));
        let pen = if face.kept {
            Pen::new(Role::Chosen, EMPHASIS)
        } else {
            Pen::new(Role::Rejected, NORMAL).dashed()
        };
        sheet.line(a, b, pen);
    }
    for (i, face) in faces.iter().enumerate() {
        let from = section.at(face.middle());
        let tip = |v: DVec2| section.at(face.middle() + ARROW * v.normalize_or_zero());
        let (normal, view) = (tip(face.normal), tip(face.towards_eye));
        marks::arrow(sheet, from, view, Role::Ray, NORMAL);
        marks::normal(sheet, from, normal);
        let (sign, ink) = if face.kept {
            ("≥", Role::Chosen)
        } else {
            ("<", Role::Note)
        };
        let value = exact(face.normal.dot(face.towards_eye));
        let words = format!("**n**·**v** = {value} {sign} 0");
        let out = normal - from;
        sheet.label(Label::new(normal, words).towards(out).ink(ink).beside());
        // One of the kept ones and one of the others.
        if i % 3 == 0 {
            let aside = (from - view) + (normal - from).normalize_or_zero();
            let label = Label::new((from + normal) * 0.5, "**n**").towards(aside);
            sheet.label(label.ink(Role::Normal).beside());
            let label = Label::new(view, "**v**").towards(view - from);
            sheet.label(label.ink(Role::Ray).beside());
        }
    }
    marks::eye(sheet, eye, DVec2::X);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_hsr::back_face::visible;
    use ombra_math::glam::DVec3;
    use ombra_math::homogeneous::point;
    use ombra_math::mesh::Mesh;

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
            (EYE, vec![0, 4, 5]),
            (DVec2::new(6.0, 7.0), vec![2, 3, 4]),
            (DVec2::new(9.0, -1.0), vec![1, 2, 3]),
        ] {
            let kept: Vec<usize> = (0..6).filter(|&i| faces(eye)[i].kept).collect();
            assert_eq!(kept, expected, "{eye}");
            let of_mesh: Vec<usize> = visible(&sides(), point(eye.extend(0.0)));
            let twice: Vec<usize> = kept.iter().flat_map(|i| [2 * i, 2 * i + 1]).collect();
            assert_eq!(of_mesh, twice, "{eye}");
        }
    }
}
