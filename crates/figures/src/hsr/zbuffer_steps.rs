//! Three triangles drawn one after another: colour and depth after each.

use ombra_hsr::picture::{IdBuffer, NOTHING};
use ombra_hsr::z_buffer::{Colours, Depth32F, DepthBuffer, Options, draw};
use ombra_math::camera::Camera;
use ombra_math::glam::{DVec2, DVec3, IVec2};
use ombra_math::mesh::Mesh;
use ombra_math::view::{Viewport, orthographic};
use ombra_raster::buffers::{self, image::Luma};
use ombra_raster::rectangle::fill;

use super::primitives::PRIMITIVES;
use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::number::decimal;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::style::Language;
use crate::text::{LABEL, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/zbuffer-steps",
    takes: Takes::These(&[
        CORNERS_A.input,
        CORNERS_B.input,
        CORNERS_C.input,
        DEPTHS_A.input,
        DEPTHS_B.input,
        DEPTHS_C.input,
        ORDER.input,
    ]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| draw_steps(sheet, &triangles(inputs)),
};

words! {
    SUMMARY {
        en: "Z-buffer: colour and depth of every pixel after each triangle",
        it: "Z-buffer: colore e profondità di ogni pixel dopo ciascun triangolo",
        cs: "Z-buffer: barva a hloubka každého pixelu po každém trojúhelníku",
        hr: "Z-spremnik: boja i dubina svakog piksela nakon svakog trokuta",
    }

    CAPTION {
        en: "At first every depth is the greatest, 8. A fragment is written (marked) where it is nearer than what the pixel holds. The triangles may come in any order.",
        it: "All’inizio ogni profondità è la massima, 8. Un frammento è scritto (evidenziato) dove è più vicino di ciò che il pixel contiene. L’ordine dei triangoli è libero.",
        cs: "Na začátku je každá hloubka největší, 8. Fragment se zapíše (vyznačeno) tam, kde je blíže než to, co pixel obsahuje. Na pořadí trojúhelníků nezáleží.",
        hr: "Na početku je svaka dubina najveća, 8. Fragment se upisuje (označeno) gdje je bliži od onoga što piksel sadrži. Redoslijed trokuta nije važan.",
    }

    /// The upper row.
    COLOUR {
        en: "colour",
        it: "colore",
        cs: "barva",
        hr: "boja",
    }

    /// The lower row.
    DEPTH {
        en: "depth *z*",
        it: "profondità *z*",
        cs: "hloubka *z*",
        hr: "dubina *z*",
    }

    /// The first step.
    CLEARED {
        en: "cleared",
        it: "all’inizio",
        cs: "na začátku",
        hr: "na početku",
    }

    /// A step: where nothing was drawn before.
    DRAWN {
        en: "%1 is drawn",
        it: "si disegna %1",
        cs: "kreslí se %1",
        hr: "crta se %1",
    }

    /// A step: nearer in some pixels of one other, farther in others.
    CROSSING {
        en: "%1 crosses %2",
        it: "%1 interseca %2",
        cs: "%1 protíná %2",
        hr: "%1 siječe %2",
    }

    /// A step: farther wherever something was drawn before.
    BEHIND {
        en: "%1 lies behind",
        it: "%1 sta dietro",
        cs: "%1 leží vzadu",
        hr: "%1 je iza",
    }

    /// A step: nearer wherever something was drawn before.
    IN_FRONT {
        en: "%1 lies in front",
        it: "%1 sta davanti",
        cs: "%1 leží vpředu",
        hr: "%1 je ispred",
    }

    /// A step: nearer than some of the others, farther than others.
    BETWEEN {
        en: "%1 lies between",
        it: "%1 sta in mezzo",
        cs: "%1 leží mezi nimi",
        hr: "%1 je između",
    }

    /// An input.
    CORNERS {
        en: "corners of this triangle, in pixels from the upper left",
        it: "vertici di questo triangolo, in pixel dall’angolo in alto a sinistra",
        cs: "vrcholy tohoto trojúhelníku, v pixelech od levého horního rohu",
        hr: "vrhovi ovog trokuta, u pikselima od gornjeg lijevog kuta",
    }

    /// An input.
    DEPTHS {
        en: "depths of this triangle’s plane in the first and the last column",
        it: "profondità del piano di questo triangolo nella prima e nell’ultima colonna",
        cs: "hloubky roviny tohoto trojúhelníku v prvním a posledním sloupci",
        hr: "dubine ravnine ovog trokuta u prvom i posljednjem stupcu",
    }

    /// An input.
    ORDER_OF {
        en: "the order in which the triangles are drawn",
        it: "l’ordine in cui si disegnano i triangoli",
        cs: "pořadí, v němž se trojúhelníky kreslí",
        hr: "redoslijed kojim se trokuti crtaju",
    }
}

/// Pixels across and down.
const SIZE: u32 = 6;
/// The far plane's distance; the near plane's is 0.
const FAR: f64 = 8.0;

/// Two that cross, and one behind both. Corners in eighths of a pixel stay where they are when they are snapped.
const CORNERS_A: Ask<Vec<DVec2>> =
    corners("a", "*A*", &[[0.125, 0.125], [0.125, 3.75], [5.875, 2.25]]);
const CORNERS_B: Ask<Vec<DVec2>> =
    corners("b", "*B*", &[[5.875, 0.625], [5.875, 5.125], [0.25, 3.25]]);
const CORNERS_C: Ask<Vec<DVec2>> = corners(
    "c",
    "*C*",
    &[[0.125, 5.875], [5.875, 5.875], [3.375, 0.125]],
);
const DEPTHS_A: Ask<DVec2> = depths("za", "*z*_{*A*}", [1.0, 6.0]);
const DEPTHS_B: Ask<DVec2> = depths("zb", "*z*_{*B*}", [6.0, 1.0]);
const DEPTHS_C: Ask<DVec2> = depths("zc", "*z*_{*C*}", [7.0, 7.0]);
const ORDER: Ask<&str> = Ask::choice(
    "order",
    "",
    ORDER_OF,
    "abc",
    &["abc", "acb", "bac", "bca", "cab", "cba"],
);

const fn corners(
    name: &'static str,
    symbol: &'static str,
    default: &'static [[f64; 2]; 3],
) -> Ask<Vec<DVec2>> {
    let side = SIZE as f64;
    Ask::polygon(
        name,
        symbol,
        CORNERS,
        default,
        [3, 3],
        [[0.0; 2], [side; 2]],
    )
}

/// From 1 to 7, a triangle lies between the near and the far plane wherever its corners are.
const fn depths(name: &'static str, symbol: &'static str, default: [f64; 2]) -> Ask<DVec2> {
    Ask::point(name, symbol, DEPTHS, default, [[1.0; 2], [7.0; 2]])
}

/// A triangle of the picture, y down, with its distance z = `at_left` + `slope` (x − ½): `at_left` in the first column.
#[derive(Clone, Copy)]
struct Triangle {
    corners: [DVec2; 3],
    at_left: f64,
    slope: f64,
}

/// The triangles with their numbers, in the order they are drawn.
fn triangles(inputs: &Inputs) -> Vec<(u32, Triangle)> {
    let all = [
        (&CORNERS_A, &DEPTHS_A),
        (&CORNERS_B, &DEPTHS_B),
        (&CORNERS_C, &DEPTHS_C),
    ];
    let places = inputs
        .get(&ORDER)
        .bytes()
        .map(|letter| letter.wrapping_sub(b'a'));
    let triangle = |i: u8| {
        let (corners, depths) = all.get(usize::from(i))?;
        let (corners, depths) = (inputs.get(corners), inputs.get(depths));
        let triangle = Triangle {
            corners: corners.try_into().ok()?,
            at_left: depths.x,
            slope: (depths.y - depths.x) / f64::from(SIZE - 1),
        };
        Some((u32::from(i), triangle))
    };
    places.filter_map(triangle).collect()
}

impl Triangle {
    /// In the world: x to the right, y up, the eye looking along −z.
    fn mesh(&self) -> Result<Mesh, FigureError> {
        let positions = self.corners.map(|p| {
            let z = self.at_left + self.slope * (p.x - 0.5);
            DVec3::new(p.x, f64::from(SIZE) - p.y, -z)
        });
        Mesh::new(positions.to_vec(), vec![[0, 1, 2]]).map_err(scene)
    }
}

/// What both buffers hold after a step, and the pixels it wrote.
struct Step {
    picture: IdBuffer,
    depth: DepthBuffer<Depth32F>,
    written: Vec<IVec2>,
}

impl Step {
    /// The cleared buffers.
    fn first() -> Result<Step, FigureError> {
        Ok(Step {
            picture: buffers::new(SIZE, SIZE, Luma([NOTHING])).map_err(scene)?,
            depth: DepthBuffer::new(SIZE, SIZE).map_err(scene)?,
            written: Vec::new(),
        })
    }

    /// The buffers after one more triangle.
    fn after(&self, id: u32, triangle: &Triangle) -> Result<Step, FigureError> {
        let side = f64::from(SIZE);
        let camera = Camera {
            view_projection: orthographic(0.0, side, 0.0, side, 0.0, FAR).map_err(scene)?,
            viewport: Viewport {
                width: SIZE,
                height: SIZE,
            },
        };
        let (mesh, colour) = (triangle.mesh()?, Colours::One(Luma([id])));
        let (mut picture, mut depth) = (self.picture.clone(), self.depth.clone());
        let options = Options::default();
        draw(&mesh, &camera, colour, options, &mut picture, &mut depth).map_err(scene)?;
        let written = seen(&picture, id);
        Ok(Step {
            picture,
            depth,
            written,
        })
    }
}

/// The cleared buffers, and what they hold after each of `triangles`, numbered as they are.
fn steps(triangles: &[(u32, Triangle)]) -> Result<Vec<Step>, FigureError> {
    let mut last = Step::first()?;
    let mut steps = Vec::with_capacity(triangles.len() + 1);
    for (id, triangle) in triangles {
        let next = last.after(*id, triangle)?;
        steps.push(core::mem::replace(&mut last, next));
    }
    steps.push(last);
    Ok(steps)
}

fn scene(error: impl ToString) -> FigureError {
    FigureError::Scene {
        reason: error.to_string(),
    }
}

fn pixels() -> impl Iterator<Item = IVec2> {
    fill(IVec2::ZERO, IVec2::splat(SIZE as i32 - 1))
}

/// Where a triangle is seen.
fn seen(picture: &IdBuffer, id: u32) -> Vec<IVec2> {
    let at = |p: IVec2| picture.get_pixel_checked(p.x as u32, p.y as u32);
    pixels()
        .filter(|&p| at(p).is_some_and(|found| found.0 == [id]))
        .collect()
}

/// Which triangle a pixel shows.
fn shown(picture: &IdBuffer, p: IVec2) -> Option<u32> {
    let found = picture.get_pixel_checked(p.x as u32, p.y as u32)?.0;
    let [id] = found;
    (id != NOTHING).then_some(id)
}

/// Name and colour of a triangle.
fn looks(id: u32) -> (&'static str, Role) {
    let known = usize::try_from(id).ok().and_then(|i| PRIMITIVES.get(i));
    known.copied().unwrap_or(("", Role::Note))
}

/// What a step comes to: how the triangle lies to those drawn before, in the pixels that it covers.
fn line(
    before: &Step,
    after: &Step,
    id: u32,
    triangle: &Triangle,
    language: Language,
) -> Result<String, FigureError> {
    let covered = Step::first()?.after(id, triangle)?.written;
    let drawn_before: Vec<(IVec2, u32)> = covered
        .iter()
        .filter_map(|&p| Some((p, shown(&before.picture, p)?)))
        .collect();
    let wins = |(p, _): &&(IVec2, u32)| after.written.contains(p);
    let won = drawn_before.iter().filter(wins).count();
    let first = drawn_before.first().map(|&(_, other)| other);
    let of_one = drawn_before.iter().all(|&(_, other)| Some(other) == first);
    let word = match (won, drawn_before.len()) {
        (_, 0) => DRAWN,
        (0, _) => BEHIND,
        (won, all) if won == all => IN_FRONT,
        _ if of_one => CROSSING,
        _ => BETWEEN,
    };
    let other = first.map_or("", |other| looks(other).0);
    let line = word.text(language).replace("%1", looks(id).0);
    Ok(line.replace("%2", other))
}

/// Height of the words above a buffer, and free space between the two.
const HEAD: f64 = 1.5 * NOTE;
const GAP: f64 = 16.0;
/// Of a cell: the height of what stands in it, and the most that it may be wide.
const HIGH: f64 = 0.62;
const WIDE: f64 = 0.84;

fn draw_steps(sheet: &mut Sheet, triangles: &[(u32, Triangle)]) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let steps = steps(triangles)?;
    let mut lines = vec![CLEARED.text(language).to_owned()];
    for ((before, after), (id, triangle)) in steps.iter().zip(steps.iter().skip(1)).zip(triangles) {
        lines.push(line(before, after, *id, triangle, language)?);
    }
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let panels = panels(sheet, &lines, 2.3)?;
    for (i, (panel, step)) in panels.into_iter().zip(&steps).enumerate() {
        sheet.panel(i, panel);
        let half = 0.5 * (panel.size().y - GAP);
        let parts = [panel.min.y, panel.min.y + half + GAP].map(|top| {
            let corner = DVec2::new(panel.min.x, top + HEAD);
            let room = Rect::new(corner, DVec2::new(panel.max.x, top + half));
            let last = IVec2::splat(SIZE as i32 - 1);
            Grid::fit(IVec2::ZERO, last, Orientation::Picture, room)
        });
        if i == 0 {
            for (grid, word) in parts.iter().zip([COLOUR, DEPTH]) {
                let at = grid.bounds().min - DVec2::new(0.0, 0.5 * HEAD);
                sheet.text(at, Align::Left, word.text(language), NOTE, Role::Text)?;
            }
        }
        let [colour, depth] = parts;
        draw_colour(sheet, &colour, step)?;
        if let Some((_, triangle)) = i.checked_sub(1).and_then(|i| triangles.get(i)) {
            colour.polygon(sheet, &triangle.corners);
        }
        draw_depth(sheet, &depth, step)?;
    }
    Ok(())
}

/// Every pixel with the name and in the colour of the triangle seen there.
fn draw_colour(sheet: &mut Sheet, grid: &Grid, step: &Step) -> Result<(), FigureError> {
    grid.draw_cells(sheet);
    for id in (0..).take(PRIMITIVES.len()) {
        grid.fill(sheet, &seen(&step.picture, id), Ink::of(looks(id).1));
    }
    let size = (HIGH * grid.cell()).min(LABEL);
    for pixel in pixels() {
        if let Some(id) = shown(&step.picture, pixel) {
            let (name, _) = looks(id);
            sheet.text(grid.centre(pixel), Align::Centre, name, size, Role::Text)?;
        }
    }
    grid.draw_centres(sheet);
    Ok(())
}

/// A pixel's distance, in tenths.
fn distance(step: &Step, pixel: IVec2) -> Option<String> {
    let p = pixel.as_uvec2();
    let depth = step.depth.depth(p.x, p.y)?;
    Some(decimal((10.0 * FAR * depth).round() / 10.0))
}

/// The distance of every pixel; those just written are marked.
fn draw_depth(sheet: &mut Sheet, grid: &Grid, step: &Step) -> Result<(), FigureError> {
    grid.draw_cells(sheet);
    sheet.fill_unmarked(
        grid.cells(&step.written),
        Ink::of(Role::Chosen).tint(0.2),
        Pen::new(Role::Chosen, THIN),
    );
    let all = || pixels().filter_map(|p| Some((p, distance(step, p)?)));
    let mut size = (HIGH * grid.cell()).min(LABEL);
    for (_, text) in all() {
        let width = sheet.lay_out(&text, size)?.width;
        if width > WIDE * grid.cell() {
            size *= WIDE * grid.cell() / width;
        }
    }
    for (pixel, text) in all() {
        let role = if step.written.contains(&pixel) {
            Role::Text
        } else {
            Role::Note
        };
        sheet.text(grid.centre(pixel), Align::Centre, &text, size, role)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use ombra_math::predicates::orient_2d;

    use super::super::drawn::drawn;
    use super::*;

    fn numbered() -> Vec<(u32, Triangle)> {
        triangles(&Inputs::default())
    }

    fn covers(triangle: &Triangle, pixel: IVec2) -> bool {
        let [a, b, c] = triangle.corners;
        let p = pixel.as_dvec2() + 0.5;
        let side = |a, b| orient_2d(a, b, p).unwrap();
        let sides = [side(a, b), side(b, c), side(c, a)];
        // No centre lies on a side, so no rule decides.
        assert!(!sides.contains(&Ordering::Equal), "{pixel}");
        sides.iter().all(|&s| s == sides[0])
    }

    /// The nearest of the planes over a pixel's centre, whole numbers each.
    fn nearest(triangles: &[(u32, Triangle)], pixel: IVec2) -> (f64, u32) {
        let over = triangles
            .iter()
            .filter(|(_, triangle)| covers(triangle, pixel));
        let depths = over
            .map(|(id, triangle)| (triangle.at_left + triangle.slope * f64::from(pixel.x), *id));
        depths.fold((FAR, NOTHING), |a, b| if b.0 < a.0 { b } else { a })
    }

    #[test]
    fn every_step_holds_the_nearest_so_far() {
        let all = numbered();
        for (count, step) in steps(&all).unwrap().iter().enumerate() {
            for pixel in pixels() {
                let (depth, id) = nearest(&all[..count], pixel);
                let p = pixel.as_uvec2();
                // The depths are eighths, which single precision holds.
                let found = step.depth.depth(p.x, p.y).map(|d| FAR * d);
                assert_eq!(found, Some(depth), "{count} {pixel}");
                assert_eq!(step.picture.get_pixel(p.x, p.y).0, [id], "{count} {pixel}");
            }
        }
    }

    #[test]
    fn any_order_ends_alike_and_the_figure_shows_each_case() {
        let all = numbered();
        let last = |order: [usize; 3]| steps(&order.map(|i| all[i])).unwrap().pop().unwrap();
        let drawn = last([0, 1, 2]);
        for order in [[2, 1, 0], [1, 2, 0], [0, 2, 1]] {
            let other = last(order);
            assert_eq!(
                (&other.picture, &other.depth),
                (&drawn.picture, &drawn.depth)
            );
        }
        // B wins some of A's pixels and loses others; C loses to both and is seen.
        let [(_, a), (_, b), (_, c)] = all[..] else {
            panic!("three")
        };
        let both = |p: &IVec2| covers(&a, *p) && covers(&b, *p);
        let steps = steps(&all).unwrap();
        let won = pixels()
            .filter(both)
            .filter(|p| steps[2].written.contains(p));
        let won = won.count();
        assert!(0 < won && won < pixels().filter(both).count());
        assert!(!drawn.written.is_empty());
        for other in [a, b] {
            let lost = pixels().filter(|p| covers(&c, *p) && covers(&other, *p));
            assert!(lost.into_iter().any(|p| !drawn.written.contains(&p)));
        }
    }

    fn lines(typed: &[(&crate::input::Input, &str)]) -> Vec<String> {
        let inputs = typed
            .iter()
            .fold(Inputs::default(), |inputs, (input, text)| {
                inputs.with(input, text).unwrap()
            });
        let all = triangles(&inputs);
        let steps = steps(&all).unwrap();
        let pairs = steps.iter().zip(&steps[1..]).zip(&all);
        let line = |((before, after), (id, triangle)): ((&Step, &Step), &(u32, Triangle))| {
            line(before, after, *id, triangle, Language::En).unwrap()
        };
        pairs.map(line).collect()
    }

    #[test]
    fn the_lines_say_how_the_triangles_then_lie() {
        let usual = ["*A* is drawn", "*B* crosses *A*", "*C* lies behind"];
        assert_eq!(lines(&[]), usual);
        // C first: A lies before it, B before it and partly behind A.
        let order = [(&ORDER.input, "cab")];
        assert_eq!(
            lines(&order),
            ["*C* is drawn", "*A* lies in front", "*B* lies between"].map(str::to_owned)
        );
        // C level, nearer than the far ends of A and B and farther than their near ends.
        let level = [
            (&DEPTHS_C.input, "3.5,3.5"),
            (&DEPTHS_A.input, "1,2"),
            (&DEPTHS_B.input, "6,5"),
        ];
        assert_eq!(
            lines(&level),
            ["*A* is drawn", "*B* lies behind", "*C* lies between"].map(str::to_owned)
        );
    }

    /// What every pixel says is the library's answer, whatever is asked for: letters above, tenths below.
    #[test]
    fn moved_triangles_are_named_in_the_pixels_they_win() {
        let inputs = Inputs::default()
            .with(&CORNERS_C.input, "0.375,0.125 5.875,0.375 2.125,5.875")
            .unwrap();
        let inputs = inputs.with(&DEPTHS_C.input, "2.5,3").unwrap();
        let all = triangles(&inputs);
        let drawing = drawn(|sheet| draw_steps(sheet, &all));
        for (id, name) in (0..).zip(["A", "B", "C"]) {
            let wins = |count: usize| {
                let first = &all[..count];
                pixels().filter(|&p| nearest(first, p).1 == id).count()
            };
            let found = drawing.labels.iter().filter(|label| label.text == name);
            assert_eq!(found.count(), wins(1) + wins(2) + wins(3), "{name}");
        }
        let wins = |p: &IVec2| nearest(&all, *p).1 == 2;
        let tenths = pixels().filter(wins).map(|p| 25 + p.x);
        for tenth in tenths {
            let text = decimal(f64::from(tenth) / 10.0);
            assert!(
                drawing.labels.iter().any(|label| label.text == text),
                "{text}"
            );
        }
    }
}
