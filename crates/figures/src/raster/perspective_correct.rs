//! A chequered wall in perspective, its texture interpolated linearly and with 1/w.

use ombra_math::glam::{DVec2, DVec3};
use ombra_raster::attributes::{linear, perspective};

use super::columns::{filled, inline};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
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
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/perspective-correct",
    takes: Takes::These(&[NEAR.input, FAR.input]),
    words: WORDS,
    about,
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Linear and perspective-correct interpolation along a wall",
        it: "Interpolazione lineare e prospetticamente corretta lungo una parete",
        cs: "Lineární a perspektivně správná interpolace podél stěny",
        hr: "Linearna i perspektivno točna interpolacija uzduž zida",
    }

    CAPTION {
        en: "The middle of the span on the screen shows the wall at *u* = %2, not at %1: *u*/*w* and 1/*w* are linear on the screen, *u* is not.",
        it: "Il punto di mezzo dell’intervallo sullo schermo mostra la parete in *u* = %2, non in %1: sono lineari sullo schermo *u*/*w* e 1/*w*, non *u*.",
        cs: "Střed úseku na obrazovce ukazuje stěnu v *u* = %2, ne v %1: na obrazovce jsou lineární *u*/*w* a 1/*w*, ne *u*.",
        hr: "Sredina raspona na zaslonu prikazuje zid na *u* = %2, a ne na %1: na zaslonu su linearni *u*/*w* i 1/*w*, a *u* nije.",
    }

    /// The caption where both ends are equally far.
    LEVEL {
        en: "Both ends are equally far from the eye: *u* itself is linear on the screen.",
        it: "I due estremi sono alla stessa distanza dall’occhio: sullo schermo è lineare *u* stessa.",
        cs: "Oba konce jsou od oka stejně daleko: na obrazovce je lineární samo *u*.",
        hr: "Oba su kraja jednako daleko od oka: na zaslonu je linearan sam *u*.",
    }

    /// The first picture.
    ABOVE {
        en: "seen from above",
        it: "vista dall’alto",
        cs: "pohled shora",
        hr: "pogled odozgo",
    }

    /// The second picture.
    LINEAR {
        en: "*u* linear",
        it: "*u* lineare",
        cs: "*u* lineárně",
        hr: "*u* linearno",
    }

    /// The third picture.
    CORRECT {
        en: "*u*/*w* and 1/*w* linear",
        it: "*u*/*w* e 1/*w* lineari",
        cs: "*u*/*w* a 1/*w* lineárně",
        hr: "*u*/*w* i 1/*w* linearno",
    }

    /// Beside the line of the picture plane.
    SCREEN {
        en: "screen",
        it: "schermo",
        cs: "obrazovka",
        hr: "zaslon",
    }

    /// An input.
    NEAR_WORD {
        en: "w, the depth, of the left end A",
        it: "w, la profondità, dell’estremo sinistro A",
        cs: "w, hloubka, levého konce A",
        hr: "w, dubina, lijevog kraja A",
    }

    /// An input.
    FAR_WORD {
        en: "w, the depth, of the right end B",
        it: "w, la profondità, dell’estremo destro B",
        cs: "w, hloubka, pravého konce B",
        hr: "w, dubina, desnog kraja B",
    }
}

const NEAR: Ask<f64> = Ask::number("wa", "*w*_A", NEAR_WORD, 1.0, [1.0, 6.0]);
const FAR: Ask<f64> = Ask::number("wb", "*w*_B", FAR_WORD, 3.0, [1.0, 6.0]);
/// Squares of the texture along the wall and up.
const SQUARES: (u32, u32) = (8, 4);
/// Half the angle of view: at depth w the wall's ends are this times w off the middle.
const HALF: f64 = 0.5;
/// Where the screen stands, in the nearer depth.
const SCREEN_AT: f64 = 0.6;
/// Weights of the ends at the middle of the span, on the screen.
const MIDDLE: DVec3 = DVec3::new(0.5, 0.5, 0.0);

/// The depths of both ends of the wall.
#[derive(Clone, Copy)]
struct Wall {
    w: [f64; 2],
}

impl Wall {
    fn of(inputs: &Inputs) -> Wall {
        let w = [inputs.get(&NEAR), inputs.get(&FAR)];
        Wall { w }
    }

    /// u at the middle of the span: linear, and correct.
    fn middle(self) -> [f64; 2] {
        let [a, b] = self.w;
        let u = [0.0, 1.0, 0.0];
        // Depths are positive, so there is always an answer.
        let correct = perspective(MIDDLE, u, [a, b, 1.0]).unwrap_or_default();
        [linear(MIDDLE, u), correct]
    }

    /// The wall from above: x to the right, depth up.
    fn plan(self) -> [DVec2; 2] {
        let [a, b] = self.w;
        [DVec2::new(-HALF * a, a), DVec2::new(HALF * b, b)]
    }

    /// The wall's corners on the screen, x and y from −1 to 1: lower left, lower right, upper right, upper left.
    fn on_screen(self) -> [DVec2; 4] {
        let nearest = self.w[0].min(self.w[1]);
        let [left, right] = self.w.map(|w| nearest / w);
        [(-1.0, -left), (1.0, -right), (1.0, right), (-1.0, left)].map(DVec2::from)
    }
}

fn about(inputs: &Inputs, language: Language) -> About {
    let wall = Wall::of(inputs);
    let [linear, correct] = wall.middle().map(|u| inline(&exact(u)));
    let caption = if wall.w[0] == wall.w[1] {
        LEVEL.text(language).to_owned()
    } else {
        filled(CAPTION, language, &[&linear, &correct])
    };
    let summary = SUMMARY.text(language).to_owned();
    About { summary, caption }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let wall = Wall::of(inputs);
    let lines = [ABOVE, LINEAR, CORRECT].map(|word| word.text(language));
    let panels = panels(sheet, &lines, 1.35)?;
    let [linear, correct] = wall.middle();
    let wrong = if linear == correct {
        Role::Chosen
    } else {
        Role::Undecided
    };
    for (i, panel) in panels.into_iter().enumerate() {
        sheet.panel(i, panel);
        match i {
            0 => draw_plan(sheet, panel, wall)?,
            1 => draw_wall(sheet, panel, wall, (linear, wrong), affine)?,
            _ => draw_wall(sheet, panel, wall, (correct, Role::Chosen), in_perspective)?,
        }
    }
    Ok(())
}

/// Eye, screen and wall; what the middle of the screen shows.
fn draw_plan(sheet: &mut Sheet, panel: Rect, wall: Wall) -> Result<(), FigureError> {
    let [a, b] = wall.plan();
    let depth = SCREEN_AT * a.y.min(b.y);
    let (left, right) = (
        DVec2::new(-HALF * depth, depth),
        DVec2::new(HALF * depth, depth),
    );
    // Room for names and the eye.
    let frame = Rect::new(
        panel.min + DVec2::new(190.0_f64.min(0.28 * panel.size().x), 80.0),
        panel.max - DVec2::new(70.0, 45.0),
    );
    let section = Section::fit(&[DVec2::ZERO, a, b], frame)?;
    let at = |p: DVec2| section.at(p);
    let [_, correct] = wall.middle();
    let hit = a.lerp(b, correct);
    for end in [a, b, hit] {
        marks::ray(sheet, at(DVec2::ZERO), at(end));
    }
    sheet.line(at(left), at(right), Pen::new(Role::Receiver, NORMAL));
    sheet.line(at(a), at(b), Pen::new(Role::Occluder, NORMAL));
    // Quarters of the wall.
    for quarter in [0.25, 0.5, 0.75] {
        let p = at(a.lerp(b, quarter));
        let across = (at(b) - at(a)).normalize_or_zero().perp() * 11.0;
        sheet.line(p - across, p + across, Pen::new(Role::Occluder, THIN));
    }
    marks::eye(sheet, at(DVec2::ZERO), DVec2::NEG_Y);
    marks::point(sheet, at(DVec2::new(0.0, depth)), Role::Text);
    marks::point(sheet, at(hit), Role::Chosen);
    let named = format!("*u* = {}", exact(correct));
    sheet.label(
        Label::new(at(hit), named)
            .towards(DVec2::new(-1.0, -1.0))
            .beside()
            .ink(Role::Chosen),
    );
    for (name, end, w, towards) in [
        ("A", a, wall.w[0], DVec2::NEG_X),
        ("B", b, wall.w[1], DVec2::X),
    ] {
        marks::point(sheet, at(end), Role::Occluder);
        let name = format!("*w*_{name} = {}", exact(w));
        let label = Label::new(at(end), name).towards(towards + DVec2::NEG_Y);
        sheet.label(label.beside());
    }
    let word = SCREEN.text(sheet.style().language);
    sheet.label(Label::new(at(right), word).towards(DVec2::X).beside());
    Ok(())
}

/// The wall on the screen, its texture put there by `map`; u at the middle is `middle`.
fn draw_wall(
    sheet: &mut Sheet,
    panel: Rect,
    wall: Wall,
    (middle, role): (f64, Role),
    map: fn(Wall, DVec2) -> DVec2,
) -> Result<(), FigureError> {
    // Room for names below.
    let frame = Rect::new(
        panel.min + DVec2::new(20.0, 10.0),
        panel.max - DVec2::new(20.0, 120.0),
    );
    let half = 0.5
        * frame
            .size()
            .min(DVec2::new(frame.size().x, 1.15 * frame.size().x));
    let at = |p: DVec2| frame.centre() + half * DVec2::new(p.x, -p.y);
    let (across, up) = SQUARES;
    let mut dark = Path::new();
    for i in 0..across {
        for j in 0..up {
            if (i + j) % 2 == 0 {
                continue;
            }
            let corner = |i: u32, j: u32| {
                DVec2::new(
                    f64::from(i) / f64::from(across),
                    f64::from(j) / f64::from(up),
                )
            };
            let square = [
                corner(i, j),
                corner(i + 1, j),
                corner(i + 1, j + 1),
                corner(i, j + 1),
            ];
            // In two parts, each of one triangle of the wall.
            for part in [below_diagonal(&square), above_diagonal(&square)] {
                let part: Vec<DVec2> = part.into_iter().map(|uv| at(map(wall, uv))).collect();
                dark.add_polygon(&part);
            }
        }
    }
    let corners = wall.on_screen().map(at);
    sheet.fill(dark, Ink::of(Role::Occluder).tint(0.75));
    sheet.stroke(Path::polygon(&corners), Pen::new(Role::Occluder, NORMAL));

    // The middle of the lower span.
    let [a, b, c, d] = corners;
    let (low, high) = (a.lerp(b, 0.5), d.lerp(c, 0.5));
    sheet.line(low, high, Pen::new(Role::Text, NORMAL).dashed());
    if role == Role::Chosen {
        marks::point(sheet, low, role);
    } else {
        marks::hollow_point(sheet, low, role);
    }
    // Names below the wall, the corners' on their side of it.
    let inwards = DVec2::new(14.0, 0.0);
    for (corner, name) in [(a + inwards, "*A*"), (b - inwards, "*B*")] {
        let at = corner + DVec2::new(0.0, 0.9 * LABEL);
        sheet.text(at, Align::Centre, name, LABEL, Role::Occluder)?;
    }
    let named = format!("*u* = {}", exact(middle));
    sheet.label(Label::new(low, named).towards(DVec2::Y).beside().ink(role));
    Ok(())
}

/// Where linear interpolation puts a point of the texture: in the triangle below the texture's diagonal or above it.
fn affine(wall: Wall, uv: DVec2) -> DVec2 {
    let [a, b, c, d] = wall.on_screen();
    if uv.y <= uv.x {
        a + uv.x * (b - a) + uv.y * (c - b)
    } else {
        a + uv.y * (d - a) + uv.x * (c - d)
    }
}

/// Where it lies in perspective.
fn in_perspective(wall: Wall, uv: DVec2) -> DVec2 {
    let [a, b] = wall.w;
    let w = a + uv.x * (b - a);
    let x = -a + uv.x * (a + b);
    let nearest = a.min(b);
    DVec2::new(x, nearest * (2.0 * uv.y - 1.0)) / w
}

/// The part of a convex polygon with v ≤ u.
fn below_diagonal(polygon: &[DVec2]) -> Vec<DVec2> {
    let mut part = Vec::new();
    let height = |p: DVec2| p.y - p.x;
    for (&p, &q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (height(p), height(q));
        if from <= 0.0 {
            part.push(p);
        }
        if (from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0) {
            part.push(p.lerp(q, from / (from - to)));
        }
    }
    part
}

/// The part with v ≥ u.
fn above_diagonal(polygon: &[DVec2]) -> Vec<DVec2> {
    let exchanged: Vec<DVec2> = polygon.iter().map(|p| DVec2::new(p.y, p.x)).collect();
    let part = below_diagonal(&exchanged).into_iter();
    part.map(|p| DVec2::new(p.y, p.x)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ray through the middle of the screen meets the wall where the correct u says.
    #[test]
    fn the_middle_of_the_screen_shows_what_the_plan_shows() {
        for w in [[1.0, 3.0], [1.0, 1.0], [6.0, 1.0], [2.5, 4.0]] {
            let wall = Wall { w };
            let [linear, correct] = wall.middle();
            assert_eq!(linear, 0.5);
            let [a, b] = wall.plan();
            assert!(a.lerp(b, correct).x.abs() < 1e-15, "{w:?}");
            let seen = in_perspective(wall, DVec2::new(correct, 0.0));
            assert!(seen.x.abs() < 1e-15, "{w:?}");
        }
        assert_eq!(Wall { w: [1.0, 3.0] }.middle(), [0.5, 0.25]);
    }

    /// Both ways put the texture's corners on the wall's; linear u is linear along each side.
    #[test]
    fn both_ways_agree_at_the_corners() {
        for w in [[1.0, 3.0], [6.0, 1.0], [2.0, 2.0]] {
            let wall = Wall { w };
            let texture = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
            for (uv, corner) in texture.into_iter().zip(wall.on_screen()) {
                assert!((affine(wall, uv) - corner).length() < 1e-15);
                assert!((in_perspective(wall, uv) - corner).length() < 1e-15);
            }
            assert!(affine(wall, DVec2::new(0.5, 0.0)).x.abs() < 1e-15);
        }
    }

    #[test]
    fn a_square_is_cut_at_the_diagonal() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
        assert_eq!(below_diagonal(&square), [DVec2::ZERO, DVec2::X, DVec2::ONE]);
        assert_eq!(above_diagonal(&square), [DVec2::ZERO, DVec2::ONE, DVec2::Y]);
        assert!(below_diagonal(&square.map(|p| p + DVec2::new(0.0, 2.0))).is_empty());
    }
}
