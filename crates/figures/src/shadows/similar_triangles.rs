//! Light, vertex and shadow from the side, and the proportion between the triangles.

use ombra_math::glam::{DVec2, DVec4};
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast;

use super::setting::light;
use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, exact, round_step};
use crate::path::Path;
use crate::section::{Section, axes, ground};
use crate::sheet::{Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

/// Bologna, Ombre su piani, caso speciale.
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/planar-similar-triangles",
    takes: Takes::These(&[LIGHT.input, VERTEX.input]),
    words: WORDS,
    about: |inputs, language| match Proof::of(inputs) {
        Ok(proof) if !proof.leans() => {
            About::new(language, VERTICAL_RAY_SUMMARY, VERTICAL_RAY_CAPTION)
        }
        _ => About::new(
            language,
            SIMILAR_TRIANGLES_SUMMARY,
            SIMILAR_TRIANGLES_CAPTION,
        ),
    },
    drawn: |sheet, inputs| Proof::of(inputs)?.draw(sheet),
};

words! {
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

    /// An input.
    VERTEX_WORD {
        en: "the vertex; as it is, it keeps below the light",
        it: "il vertice; quello iniziale resta sotto la luce",
        cs: "vrchol; výchozí zůstává pod zdrojem",
        hr: "vrh; početni ostaje ispod izvora",
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
}

const LIGHT: Ask<DVec4> = light([16.0, 9.0, 0.0, 1.0]);

const USUAL: [f64; 2] = [8.0, 3.0];
const VERTEX: Ask<DVec2> = Ask::point("v", "*V*", VERTEX_WORD, USUAL, [[-40.0, 0.1], [40.0, 40.0]]);
/// A section wider or higher than this many times the other side is not drawn.
const SLENDER: f64 = 8.0;
/// Where the two columns of heights stand beside the light.
const INNER: f64 = 58.0;
const OUTER: f64 = 310.0;

/// The section z = 0: the shadow's x does not depend on z.
struct Proof {
    light: DVec4,
    v: DVec2,
    p: DVec2,
    /// The light, or where the arrow of its direction from the vertex ends.
    top: DVec2,
}

impl Proof {
    fn of(inputs: &Inputs) -> Result<Proof, FigureError> {
        let own = inputs.has(&VERTEX).then(|| inputs.get(&VERTEX));
        Proof::new(inputs.get(&LIGHT), own)
    }

    fn new(light: DVec4, own: Option<DVec2>) -> Result<Proof, FigureError> {
        let light = if light.w < 0.0 { -light } else { light };
        let refused = |why: &str| FigureError::Scene {
            reason: format!("--light {} {why}", as_typed(&light.to_array())),
        };
        if light.y <= 0.0 {
            return Err(refused(
                "casts no shadow on the ground y = 0: its y must be positive",
            ));
        }
        let place = if light.w == 0.0 {
            light.truncate()
        } else {
            light.truncate() / light.w
        };
        // The vertex (8, 3), larger or smaller by a round factor so that it is at most half as high as the light.
        let usual = DVec2::from(USUAL) * largest_step(place.y / 6.0);
        let v = own.unwrap_or(usual);
        if light.w != 0.0 && v.y >= place.y {
            return Err(FigureError::Scene {
                reason: format!(
                    "the vertex {} is not below the light {}: it casts no shadow on the ground (v, --light)",
                    as_typed(&v.to_array()),
                    as_typed(&light.to_array())
                ),
            });
        }
        let slender =
            || refused("is too low or too far aside for its triangles to be drawn in one picture");
        let p = cast(Plane::GROUND, light, v.extend(0.0)).ok_or_else(slender)?;
        let p = DVec2::new(p.x, 0.0);
        let top = if light.w == 0.0 {
            v + place.truncate()
        } else {
            place.truncate()
        };
        let size = top.max(v).max(p) - top.min(v).min(p);
        if size.x <= SLENDER * size.y && size.is_finite() {
            Ok(Proof { light, v, p, top })
        } else {
            Err(slender())
        }
    }

    fn at_infinity(&self) -> bool {
        self.light.w == 0.0
    }

    /// Whether the light is neither right above the vertex nor right above the shadow: then there are triangles.
    fn leans(&self) -> bool {
        self.top.x != self.v.x && self.v.x != self.p.x
    }

    /// The proportion and what follows from it; differences are taken so that they are lengths.
    fn formula(&self) -> Vec<String> {
        let value = exact(self.p.x);
        let (proportion, result) = if self.at_infinity() {
            (
                format!(
                    "{{{}|{}}} = {{*V*_y|*L*_y}}",
                    self.ground_leg(),
                    self.level_leg()
                ),
                "*P*_x = *V*_x − {*V*_y|*L*_y} *L*_x",
            )
        } else {
            (
                format!(
                    "{{{}|{}}} = {{*L*_y|*L*_y − *V*_y}}",
                    self.ground_leg(),
                    self.level_leg()
                ),
                "*P*_x = {*L*_y *V*_x − *L*_x *V*_y|*L*_y − *V*_y}",
            )
        };
        if self.leans() {
            vec![proportion, format!("⇒   {result} = {value}")]
        } else {
            vec![format!("{result} = {value}")]
        }
    }

    /// The horizontal leg on the ground.
    fn ground_leg(&self) -> &'static str {
        match (self.at_infinity(), self.p.x < self.v.x) {
            (false, true) => "*L*_x − *P*_x",
            (false, false) => "*P*_x − *L*_x",
            (true, true) => "*V*_x − *P*_x",
            (true, false) => "*P*_x − *V*_x",
        }
    }

    /// The horizontal leg at the height of the vertex.
    fn level_leg(&self) -> &'static str {
        match (self.at_infinity(), self.p.x < self.v.x) {
            (false, true) => "*L*_x − *V*_x",
            (false, false) => "*V*_x − *L*_x",
            (true, true) => "*L*_x",
            (true, false) => "−*L*_x",
        }
    }

    fn draw(&self, sheet: &mut Sheet) -> Result<(), FigureError> {
        let Proof { v, p, top, .. } = *self;
        let whole = sheet.frame();
        // The proportion and what follows from it, on one line if that is wide enough.
        let parts = self.formula();
        let one = sheet.lay_out(&parts.join("   "), LABEL)?;
        let lines = if one.width <= whole.size().x {
            vec![one]
        } else {
            let part = |part: &String| sheet.lay_out(part, LABEL);
            parts.iter().map(part).collect::<Result<Vec<_>, _>>()?
        };
        let mut bottom = whole.max.y;
        sheet.step(3);
        for line in lines.into_iter().rev() {
            let start = DVec2::new(whole.centre().x - 0.5 * line.width, bottom - line.descent);
            bottom -= line.ascent + line.descent + 0.3 * LABEL;
            sheet.set_at(line, start, Role::Text.into());
        }

        sheet.step(0);
        let foot = DVec2::new(top.x, 0.0);
        let mut shown = vec![v, p, top, foot];
        let extent = (top - p).abs().max_element();
        let origin = p.x.abs() <= extent;
        if origin {
            shown.push(DVec2::ZERO);
        }
        // The heights stand on the light's side.
        let outwards = if top.x < p.x { DVec2::NEG_X } else { DVec2::X };
        let mut frame = whole;
        frame.min += DVec2::new(90.0, marks::SUN + 12.0);
        frame.max = DVec2::new(whole.max.x - 90.0, bottom - 130.0);
        if outwards.x > 0.0 {
            frame.max.x -= OUTER;
        } else {
            frame.min.x += OUTER;
        }
        let section = Section::fit(&shown, frame)?;
        let at = |point: DVec2| section.at(point);
        let line = at(DVec2::ZERO).y;
        let (left, right) = (DVec2::new(whole.min.x, line), DVec2::new(whole.max.x, line));
        ground(sheet, left, right);

        let corner = DVec2::new(top.x, v.y);
        let below = DVec2::new(v.x, 0.0);
        let (large, small) = if self.at_infinity() {
            ([v, corner, top], [p, below, v])
        } else {
            ([p, foot, top], [v, corner, top])
        };
        sheet.step(2);
        let pale = Ink::of(Role::Light).tint(0.16);
        sheet.fill(Path::polygon(&large.map(at)), pale);
        let hatch = Pen::new(Ink::of(Role::Occluder).tint(0.5), THIN);
        sheet.stroke_unmarked(Path::hatching(&small.map(at), 18.0), hatch);
        let side = |sheet: &mut Sheet, a, b| sheet.line(at(a), at(b), Pen::new(Role::Note, THIN));
        side(sheet, v, corner);
        side(sheet, foot, top);
        if self.at_infinity() {
            side(sheet, v, below);
        }
        sheet.step(0);
        if origin {
            axes(sheet, &section, 64.0);
        }

        sheet.step(1);
        if self.at_infinity() {
            marks::ray(sheet, at(top), at(v));
        } else {
            marks::ray_from_sun(sheet, at(top), at(v));
        }
        marks::stopped_ray(sheet, at(v), at(p));
        sheet.step(2);
        self.name_legs(sheet, &section, outwards);
        sheet.step(0);
        self.draw_light(sheet, at(top), at(v));
        let towards = DVec2::new(-outwards.x, -1.0);
        for (point, name, role, step) in
            [(v, "*V*", Role::Occluder, 0), (p, "*P*", Role::Shadow, 1)]
        {
            sheet.step(step);
            marks::point(sheet, at(point), role);
            let text = format!("{name} ({}, {})", exact(point.x), exact(point.y));
            sheet.label(Label::new(at(point), text).towards(towards));
        }
        Ok(())
    }

    fn name_legs(&self, sheet: &mut Sheet, section: &Section, outwards: DVec2) {
        let Proof { v, p, top, .. } = *self;
        let at = |x: f64, y: f64| section.at(DVec2::new(x, y));
        let mut leg = |a: DVec2, b: DVec2, aside: DVec2, name: &str| {
            let middle = marks::dimension(sheet, a, b, aside);
            sheet.label(Label::new(middle, name).towards(aside).beside());
        };
        let below = DVec2::new(0.0, 58.0);
        if self.leans() {
            leg(
                at(p.x, 0.0),
                at(if self.at_infinity() { v.x } else { top.x }, 0.0),
                below,
                self.ground_leg(),
            );
        }
        if self.at_infinity() {
            leg(at(top.x, v.y), at(top.x, top.y), outwards * INNER, "*L*_y");
            leg(at(v.x, 0.0), at(v.x, v.y), outwards * INNER, "*V*_y");
        } else {
            leg(at(top.x, 0.0), at(top.x, top.y), outwards * OUTER, "*L*_y");
            leg(
                at(top.x, v.y),
                at(top.x, top.y),
                outwards * INNER,
                "*L*_y − *V*_y",
            );
            leg(at(top.x, 0.0), at(top.x, v.y), outwards * INNER, "*V*_y");
        }
        // This leg is a line of the figure already.
        if self.leans() {
            let middle = at(0.5 * (v.x + top.x), v.y);
            let label = Label::new(middle, self.level_leg());
            sheet.label(label.towards(DVec2::Y).beside());
        }
    }

    fn draw_light(&self, sheet: &mut Sheet, top: DVec2, v: DVec2) {
        let l = self.light;
        let name = format!(
            "**L** = ({}, {}, {}, {})",
            exact(l.x),
            exact(l.y),
            exact(l.z),
            exact(l.w)
        );
        let label = if self.at_infinity() {
            let aside = (top - v).normalize_or_zero().perp() * 30.0;
            let end = top + (v - top) * 0.4;
            let arrows = [-1.0, 0.0, 1.0].map(|k| (top + aside * k, end + aside * k));
            marks::bundle(sheet, &arrows);
            Label::new(top, name).reach(34.0)
        } else {
            marks::sun(sheet, top);
            Label::new(top, name).reach(marks::SUN + 4.0)
        };
        sheet.label(label.towards(v - top).towards(DVec2::new(v.x - top.x, 0.0)));
    }
}

/// The largest of 1, 2, 5 times a power of ten that is at most `length`; 0 where there is none.
fn largest_step(length: f64) -> f64 {
    // The next step below is half of the next above, or two fifths of a 5.
    [1.0, 2.0, 2.5]
        .map(|part| round_step(length / part))
        .into_iter()
        .find(|step| *step <= length)
        .unwrap_or(0.0)
}
