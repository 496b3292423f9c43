//! Why a segment that reaches behind the eye is clipped before the division by w.

use ombra_clip::homogeneous::clip_segment;
use ombra_math::glam::{DVec2, DVec4};

use super::board::{FIRST_END, LAST_END, window};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::exact;
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Align, Label, Sheet};
use crate::style::Language;
use crate::text::{LABEL, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/w-zero",
    takes: Takes::These(&[A.input, B.input]),
    words: WORDS,
    about: |inputs, language| {
        let [a, b] = given(inputs);
        let outcome = outcome(a, b).text(language);
        About::new(language, SUMMARY, CAPTION).and(Some(outcome))
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "A segment that reaches behind the eye: clipped before the division by *w*, and after",
        it: "Un segmento che finisce dietro l’occhio: tagliato prima della divisione per *w*, e dopo",
        cs: "Úsečka, která sahá za oko: oříznutá před dělením *w* a po něm",
        hr: "Dužina koja seže iza oka: odsječena prije dijeljenja s *w* i nakon njega",
    }

    CAPTION {
        en: "The division moves every point along its line through the eye to *w* = 1. Inside is −*w* ≤ *x* ≤ *w*, and so *w* ≥ 0.",
        it: "La divisione sposta ogni punto lungo la sua retta per l’occhio su *w* = 1. All’interno −*w* ≤ *x* ≤ *w*, dunque *w* ≥ 0.",
        cs: "Dělení posune každý bod po přímce okem na *w* = 1. Uvnitř je −*w* ≤ *x* ≤ *w*, tedy *w* ≥ 0.",
        hr: "Dijeljenje pomiče svaku točku po njezinu pravcu kroz oko na *w* = 1. Unutra je −*w* ≤ *x* ≤ *w*, dakle *w* ≥ 0.",
    }

    /// The first picture.
    CLIP_FIRST {
        en: "clip, then divide",
        it: "prima taglio, poi divisione",
        cs: "nejprve ořez, pak dělení",
        hr: "prvo rez, pa dijeljenje",
    }

    /// The second picture.
    DIVIDE_FIRST {
        en: "divide, then join",
        it: "prima divisione, poi unione",
        cs: "nejprve dělení, pak spojení",
        hr: "prvo dijeljenje, pa spajanje",
    }

    /// After the second picture's words.
    WRONG {
        en: "wrong",
        it: "sbagliato",
        cs: "špatně",
        hr: "pogrešno",
    }

    /// What comes out of it.
    THROUGH_INFINITY {
        en: "One end lies behind: the true image goes on through infinity, the two divided ends joined are the other part of the line.",
        it: "Un estremo sta dietro: l’immagine vera passa per l’infinito, gli estremi divisi e uniti danno l’altra parte della retta.",
        cs: "Jeden konec leží vzadu: pravý obraz jde přes nekonečno, spojené vydělené konce dávají druhou část přímky.",
        hr: "Jedan kraj leži iza: prava slika ide kroz beskonačnost, a spojeni podijeljeni krajevi daju drugi dio pravca.",
    }

    /// What comes out of it.
    TURNED {
        en: "Both ends lie behind: the division turns them in front of the eye.",
        it: "Entrambi gli estremi stanno dietro: la divisione li porta davanti all’occhio.",
        cs: "Oba konce leží vzadu: dělení je převrátí před oko.",
        hr: "Oba kraja leže iza: dijeljenje ih prebacuje ispred oka.",
    }

    /// What comes out of it.
    NO_QUOTIENT {
        en: "An end with *w* = 0 has no quotient.",
        it: "Un estremo con *w* = 0 non ha quoziente.",
        cs: "Konec s *w* = 0 nemá podíl.",
        hr: "Kraj s *w* = 0 nema količnika.",
    }

    /// What comes out of it.
    SAME {
        en: "Both ends lie in front: either way is right.",
        it: "Entrambi gli estremi stanno davanti: vanno bene entrambi i modi.",
        cs: "Oba konce leží vpředu: správně je obojí.",
        hr: "Oba kraja leže ispred: ispravno je oboje.",
    }

    /// Below the eye.
    BEHIND {
        en: "behind the eye: *w* < 0",
        it: "dietro l’occhio: *w* < 0",
        cs: "za okem: *w* < 0",
        hr: "iza oka: *w* < 0",
    }
}

/// As (x, w).
const A: Ask<DVec2> = Ask::point("a", "*A*", FIRST_END, [-1.0, 2.0], [[-3.0; 2], [3.0; 2]]);
const B: Ask<DVec2> = Ask::point("b", "*B*", LAST_END, [3.0, -1.0], [[-3.0; 2], [3.0; 2]]);
const LEAST: DVec2 = DVec2::new(-3.6, -1.5);
const MOST: DVec2 = DVec2::new(3.6, 2.6);

fn given(inputs: &Inputs) -> [DVec2; 2] {
    [inputs.get(&A), inputs.get(&B)]
}

/// What dividing first makes of two ends.
fn outcome(a: DVec2, b: DVec2) -> crate::words::Word {
    match (a.y, b.y) {
        _ if a.y == 0.0 || b.y == 0.0 => NO_QUOTIENT,
        _ if a.y > 0.0 && b.y > 0.0 => SAME,
        _ if a.y < 0.0 && b.y < 0.0 => TURNED,
        _ => THROUGH_INFINITY,
    }
}

/// What is kept of a b before the division.
fn kept(a: DVec2, b: DVec2) -> Option<[DVec2; 2]> {
    let point = |p: DVec2| DVec4::new(p.x, 0.0, 0.0, p.y);
    let kept = clip_segment([point(a), point(b)])?;
    Some(kept.map(|p| DVec2::new(p.x, p.w)))
}

/// x/w on the line w = 1; none for what is at infinity.
fn divided(p: DVec2) -> Option<DVec2> {
    (p.y != 0.0).then(|| DVec2::new(p.x / p.y, 1.0))
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let [a, b] = given(inputs);
    let mut second = DIVIDE_FIRST.text(language).to_owned();
    if outcome(a, b) != SAME {
        second = format!("{second}: {}", WRONG.text(language));
    }
    let lines = [CLIP_FIRST.text(language), &second];
    let reach = LEAST.min(a - 0.4).min(b - 0.4);
    let shown = window(
        reach.x,
        reach.y,
        MOST.x,
        MOST.y.max(a.y + 0.4).max(b.y + 0.4),
    );
    let size = shown.max - shown.min;
    let panels = panels(sheet, &lines, size.y / size.x)?;
    for (i, panel) in panels.into_iter().enumerate() {
        sheet.panel(i, panel);
        let section = Section::fit(&[shown.min, shown.max], panel)?;
        let plane = Plane {
            place: Rect::new(
                section.at(DVec2::new(shown.min.x, shown.max.y)),
                section.at(DVec2::new(shown.max.x, shown.min.y)),
            ),
            section,
        };
        plane.draw(sheet, language)?;
        match i {
            0 => plane.clip_first(sheet, a, b),
            _ => plane.divide_first(sheet, a, b),
        }
        for (p, name, other) in [(a, "*A*", b), (b, "*B*", a)] {
            let out = (p - other).normalize_or_zero();
            let label = Label::new(plane.at(p), name).towards(DVec2::new(out.x, -out.y));
            sheet.label(label.beside());
        }
    }
    sheet.whole();
    Ok(())
}

/// The plane of x and w on the canvas.
struct Plane {
    section: Section,
    place: Rect,
}

impl Plane {
    fn at(&self, p: DVec2) -> DVec2 {
        self.section.at(p)
    }

    /// A line, as far as it is shown.
    fn line(&self, sheet: &mut Sheet, from: DVec2, to: DVec2, pen: Pen) {
        if let Some((from, to)) = self.place.cut(self.at(from), self.at(to)) {
            sheet.line(from, to, pen);
        }
    }

    /// Inside, behind, the two planes of the sides, the line of images, the eye.
    fn draw(&self, sheet: &mut Sheet, language: Language) -> Result<(), FigureError> {
        let [low, high] = [self.place.min, self.place.max];
        let eye = self.at(DVec2::ZERO);
        let top = (eye.y - low.y) / self.section.scale();
        let wedge = [DVec2::ZERO, DVec2::splat(top), DVec2::new(-top, top)];
        let wedge = wedge.map(|p| self.at(p));
        sheet.fill(Path::polygon(&wedge), Role::Ground);
        let behind = [
            DVec2::new(low.x, eye.y),
            DVec2::new(high.x, eye.y),
            high,
            DVec2::new(low.x, high.y),
        ];
        let hatches = Path::hatching(&behind, 30.0);
        sheet.stroke_unmarked(hatches, Pen::new(Role::Grid, THIN));
        let side = Pen::new(Role::Receiver, NORMAL);
        for (tip, name) in [(wedge[1], "*x* = *w*"), (wedge[2], "*x* = −*w*")] {
            sheet.line(eye, tip, side.clone());
            // Beside the line, near its upper end.
            let at = eye + (tip - eye) * 0.88;
            let out = DVec2::new((tip.x - eye.x).signum(), 0.3);
            let label = Label::new(at, name).towards(out).size(NOTE);
            sheet.label(label.ink(Role::Note).beside());
        }
        let axis = DVec2::new(0.0, eye.y);
        sheet.stroke_unmarked(
            Path::line(axis.with_x(low.x), axis.with_x(high.x)),
            Pen::new(Role::Axis, THIN),
        );
        let screen = self.at(DVec2::Y).y;
        sheet.line(
            DVec2::new(low.x, screen),
            DVec2::new(high.x, screen),
            Pen::new(Role::Axis, THIN),
        );
        let note = DVec2::new(high.x, screen - 0.6 * LABEL);
        sheet.text(note, Align::Right, "*w* = 1", NOTE, Role::Axis)?;
        let note = DVec2::new(low.x + 8.0, high.y - 0.6 * LABEL);
        sheet.text(note, Align::Left, BEHIND.text(language), NOTE, Role::Note)?;
        sheet.fill(Path::circle(eye, 30.0), Role::Paper);
        marks::eye(sheet, eye, DVec2::NEG_Y);
        Ok(())
    }

    /// An image on the line w = 1, with the line through the eye that leads to it.
    fn image(&self, sheet: &mut Sheet, p: DVec2, name: &str, role: Role) -> Option<DVec2> {
        let image = divided(p)?;
        self.line(sheet, p, image, Pen::new(Role::Ray, THIN).dashed());
        if p.y < 0.0 {
            // Through the eye and out in front.
            self.line(
                sheet,
                DVec2::ZERO,
                image,
                Pen::new(Role::Ray, THIN).dashed(),
            );
        }
        let at = self.at(image);
        if self.place.contains(&Rect::new(at, at)) {
            marks::point(sheet, at, role);
            let label = Label::new(at, format!("{name} = {}", exact(image.x)));
            let out = DVec2::new(0.3 * image.x.signum(), -1.0);
            sheet.label(label.towards(out).ink(role).beside());
        }
        Some(image)
    }

    fn clip_first(&self, sheet: &mut Sheet, a: DVec2, b: DVec2) {
        self.line(sheet, a, b, Pen::new(Role::Rejected, THIN).dashed());
        for p in [a, b] {
            marks::hollow_point(sheet, self.at(p), Role::Undecided);
        }
        let Some([from, to]) = kept(a, b) else {
            return;
        };
        self.line(sheet, from, to, Pen::new(Role::Chosen, EMPHASIS));
        // A new end that is no end has a name of its own.
        let ends = [(from, a, "*A*", "*C*"), (to, b, "*B*", "*C*")];
        let images = ends.map(|(end, given, name, new)| {
            let name = if end == given { name } else { new };
            marks::point(sheet, self.at(end), Role::Chosen);
            if end != given {
                let label = Label::new(self.at(end), name)
                    .towards(DVec2::X)
                    .ink(Role::Chosen);
                sheet.label(label.beside());
            }
            self.image(sheet, end, &format!("{name}′"), Role::Chosen)
        });
        if let [Some(from), Some(to)] = images {
            self.line(sheet, from, to, Pen::new(Role::Chosen, EMPHASIS));
        }
    }

    fn divide_first(&self, sheet: &mut Sheet, a: DVec2, b: DVec2) {
        self.line(sheet, a, b, Pen::new(Role::Undecided, NORMAL));
        let right = outcome(a, b) == SAME;
        let role = if right { Role::Chosen } else { Role::Undecided };
        for p in [a, b] {
            marks::point(sheet, self.at(p), Role::Undecided);
        }
        let images = [(a, "*A*′"), (b, "*B*′")].map(|(p, name)| self.image(sheet, p, name, role));
        let [Some(from), Some(to)] = images else {
            return;
        };
        let Some((from, to)) = self.place.cut(self.at(from), self.at(to)) else {
            return;
        };
        if right {
            sheet.line(from, to, Pen::new(Role::Chosen, EMPHASIS));
            return;
        }
        // What is wrong: a hatched band, crossed out.
        let half = DVec2::new(0.0, 11.0);
        let band = [from - half, to - half, to + half, from + half];
        sheet.fill(Path::polygon(&band), Ink::of(Role::Rejected).tint(0.25));
        sheet.stroke_unmarked(Path::hatching(&band, 10.0), Pen::new(Role::Rejected, THIN));
        let middle = (from + to) * 0.5;
        for arm in [DVec2::new(22.0, 22.0), DVec2::new(22.0, -22.0)] {
            sheet.line(
                middle - arm,
                middle + arm,
                Pen::new(Role::Undecided, EMPHASIS),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = −1 + 4t and w = 2 − 3t meet x = w at t = 3/7.
    #[test]
    fn clipped_first_the_image_ends_at_the_side_it_leaves_by() {
        let [a, b] = given(&Inputs::default());
        let [from, to] = kept(a, b).unwrap();
        assert_eq!((from, to), (a, DVec2::splat(5.0 / 7.0)));
        assert_eq!(divided(from), Some(DVec2::new(-0.5, 1.0)));
        assert_eq!(divided(to), Some(DVec2::ONE));
        // Divided first, the other end is on the wrong side.
        assert_eq!(divided(b), Some(DVec2::new(-3.0, 1.0)));
        assert_eq!(outcome(a, b), THROUGH_INFINITY);
        assert_eq!(kept(b, DVec2::new(0.0, -1.0)), None);
        assert_eq!(divided(DVec2::X), None);
        assert_eq!(outcome(a, DVec2::X), NO_QUOTIENT);
        assert_eq!(outcome(a, DVec2::Y), SAME);
        assert_eq!(outcome(-a, b), TURNED);
    }
}
