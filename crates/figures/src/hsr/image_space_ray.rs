//! A ray through a pixel, the planes it meets, and the primitive that is seen there.

use ombra_hsr::image_space::{Hit, hits};
use ombra_hsr::polygon::Polygon;
use ombra_math::camera::SightLine;
use ombra_math::glam::{DVec2, DVec3, IVec2};

use super::primitives::{AREA, PRIMITIVES};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::exact;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::space::View;
use crate::style::Language;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/image-space-ray",
    takes: Takes::These(&[
        PIXEL_ASKED.input,
        DISTANCES[0].input,
        DISTANCES[1].input,
        DISTANCES[2].input,
    ]),
    words: WORDS,
    about: |inputs, language| about(&Scene::new(inputs), language),
    drawn: |sheet, inputs| draw(sheet, &Scene::new(inputs)),
};

words! {
    SUMMARY {
        en: "A ray through a pixel: where it meets three primitives, and which of them the pixel gets",
        it: "Una semiretta per un pixel: dove incontra tre primitive, e quale di esse va al pixel",
        cs: "Paprsek pixelem: kde protíná tři plochy a kterou z nich pixel dostane",
        hr: "Zraka kroz piksel: gdje pogađa tri poligona i koji od njih dobiva piksel",
    }

    /// Where the ray meets a primitive.
    CAPTION {
        en: "The pixel gets %1, the primitive at the nearest hit.",
        it: "Il pixel riceve %1, la primitiva dell’intersezione più vicina.",
        cs: "Pixel dostane %1, plochu nejbližšího průsečíku.",
        hr: "Piksel dobiva %1, poligon najbližeg pogotka.",
    }

    /// Where it meets none.
    NOTHING {
        en: "The ray meets no primitive: the pixel keeps the background.",
        it: "La semiretta non incontra primitive: il pixel mantiene lo sfondo.",
        cs: "Paprsek neprotíná žádnou plochu: pixel si ponechá pozadí.",
        hr: "Zraka ne pogađa nijedan poligon: piksel zadržava pozadinu.",
    }

    /// Where it meets the plane of *C* before everything else, but beside *C*.
    SOONER {
        en: "The plane of *C* is met sooner, but outside *C*: that does not count.",
        it: "Il piano di *C* viene prima, ma fuori di *C*: non conta.",
        cs: "Rovinu plochy *C* paprsek protne dřív, ale mimo *C*: to se nepočítá.",
        hr: "Ravninu od *C* zraka pogađa prije, ali izvan *C*: to se ne računa.",
    }

    /// Where it meets the plane of *C* beside *C*.
    BESIDE {
        en: "The plane of *C* is met outside *C*: that does not count.",
        it: "Il piano di *C* è colpito fuori di *C*: non conta.",
        cs: "Rovinu plochy *C* paprsek protne mimo *C*: to se nepočítá.",
        hr: "Ravninu od *C* zraka pogađa izvan *C*: to se ne računa.",
    }

    /// An input.
    PIXEL_OF {
        en: "the pixel that the ray goes through, from the lower left",
        it: "il pixel per cui passa la semiretta, dal basso a sinistra",
        cs: "pixel, kterým paprsek prochází, od levého dolního rohu",
        hr: "piksel kroz koji zraka prolazi, od donjeg lijevog kuta",
    }

    /// An input.
    DISTANCE {
        en: "distance of this primitive from the eye, along the view",
        it: "distanza di questa primitiva dall’osservatore, lungo la vista",
        cs: "vzdálenost této plochy od pozorovatele ve směru pohledu",
        hr: "udaljenost ovog poligona od oka, u smjeru pogleda",
    }

    /// The ray meets a plane outside its primitive.
    OUTSIDE {
        en: "outside *C*",
        it: "fuori di *C*",
        cs: "mimo *C*",
        hr: "izvan *C*",
    }
}

/// The image: columns and rows, the width of a pixel, and its distance from the eye.
const SIZE: (u32, u32) = (8, 6);
const PIXEL: f64 = 0.3;
const IMAGE: f64 = 2.0;
/// The pixel looked at: its column and its row from below.
const PIXEL_ASKED: Ask<IVec2> = Ask::pixel("pixel", "", PIXEL_OF, [4, 3], [[0; 2], [7, 5]]);
/// Distances of *A*, *B* and *C* from the eye, their corners in x and y.
const DISTANCES: [Ask<f64>; 3] = [
    distance("ta", "*t*_{*A*}", 6.0),
    distance("tb", "*t*_{*B*}", 9.0),
    distance("tc", "*t*_{*C*}", 4.0),
];
const A: [(f64, f64); 4] = [(-0.7, -0.8), (1.2, -1.0), (1.3, 1.1), (-0.6, 1.3)];
const B: [(f64, f64); 4] = [(-0.9, -2.1), (3.2, -2.1), (3.2, 2.5), (-0.9, 2.5)];
const C: [(f64, f64); 3] = [(-2.3, -0.7), (-0.2, 0.3), (-1.3, 0.9)];
/// Share of a primitive's colour in the pixels that show it.
const CELL: f64 = 0.6;
/// As much of the plane of *C* as shows, and how far it reaches beyond where the ray meets it; the place of *C* among the
/// primitives.
const PLANE: [(f64, f64); 4] = [(-2.6, -1.7), (1.6, -1.7), (1.6, 1.5), (-2.6, 1.5)];
const BEYOND: f64 = 0.6;
const PLANE_OF: usize = 2;
/// Room for the mark of the eye, which is at the border of what is shown, and how far its rays keep off it.
const AROUND_EYE: DVec2 = DVec2::new(34.0, 20.0);
const RIM: f64 = 36.0;

/// A place of the scene on the stage, turned so that the eye, which looks along −z, looks to the right.
fn stage(p: DVec3) -> DVec3 {
    DVec3::new(-p.z, p.y, p.x)
}

fn upright(corners: &[(f64, f64)], depth: f64) -> Polygon {
    Polygon {
        vertices: corners
            .iter()
            .map(|&(x, y)| DVec3::new(x, y, -depth))
            .collect(),
    }
}

/// All are beyond the image.
const fn distance(name: &'static str, symbol: &'static str, default: f64) -> Ask<f64> {
    Ask::number(name, symbol, DISTANCE, default, [2.5, 12.0])
}

/// What is drawn: *A*, *B* and *C*, a pixel, and what its ray meets.
struct Scene {
    primitives: [Polygon; 3],
    distances: [f64; 3],
    looked_at: (u32, u32),
    line: SightLine,
    /// As much of the plane of *C* as shows.
    plane: Polygon,
    /// The primitives met, the nearest first.
    found: Vec<Hit>,
    /// Where the plane of *C* is met outside *C*.
    beside: Option<f64>,
}

impl Scene {
    fn new(inputs: &Inputs) -> Scene {
        let distances = DISTANCES.map(|ask| inputs.get(&ask));
        let [a, b, c] = distances;
        let primitives = [upright(&A, a), upright(&B, b), upright(&C, c)];
        let pixel = inputs.get(&PIXEL_ASKED).as_uvec2();
        let looked_at = (pixel.x, pixel.y);
        let line = sight_line(looked_at);
        let found = hits(&primitives, line);
        let is_c = |hit: &Hit| hit.primitive == PLANE_OF;
        let beside = (!found.iter().any(is_c)).then_some(c);
        let mut plane = upright(&PLANE, c);
        if let Some(t) = beside {
            let at = along(line, t).truncate();
            for (p, (x, y)) in plane.vertices.iter_mut().zip(PLANE) {
                let reach = |at: f64, to: f64| {
                    if to < 0.0 {
                        to.min(at - BEYOND)
                    } else {
                        to.max(at + BEYOND)
                    }
                };
                *p = DVec3::new(reach(at.x, x), reach(at.y, y), p.z);
            }
        }
        Scene {
            primitives,
            distances,
            looked_at,
            line,
            plane,
            found,
            beside,
        }
    }

    /// Every place where the ray meets a plane that is shown, the nearest first.
    fn stops(&self) -> Vec<f64> {
        let mut stops: Vec<f64> = self.found.iter().map(|hit| hit.t).collect();
        stops.extend(self.beside);
        stops.sort_by(f64::total_cmp);
        stops
    }

    /// The step of the build-up at which the ray comes as far as `t`: the first shows it up to the image.
    fn step(&self, t: f64) -> usize {
        2 + self.stops().iter().filter(|stop| **stop < t).count()
    }

    /// The step at which the pixel gets its colour.
    fn last(&self) -> usize {
        2 + self.stops().len()
    }
}

fn about(scene: &Scene, language: Language) -> About {
    let first = scene.found.first();
    let mut about = About::new(language, SUMMARY, CAPTION);
    about.caption = match first {
        None => NOTHING.text(language).to_owned(),
        Some(hit) => {
            let name = PRIMITIVES.get(hit.primitive).map_or("", |&(name, _)| name);
            CAPTION.text(language).replace("%1", name)
        }
    };
    let beside = scene.beside.map(|t| match first {
        Some(hit) if t < hit.t => SOONER,
        _ => BESIDE,
    });
    about.and(beside.map(|word| word.text(language)))
}

/// The place (column, row) in the image, whole numbers at the corners of pixels.
fn on_image(column: f64, row: f64) -> DVec3 {
    let (columns, rows) = SIZE;
    let centred = |at: f64, of: u32| PIXEL * (at - 0.5 * f64::from(of));
    DVec3::new(centred(column, columns), centred(row, rows), -IMAGE)
}

/// The corners of the image.
fn image() -> [DVec3; 4] {
    let (columns, rows) = (f64::from(SIZE.0), f64::from(SIZE.1));
    [(0.0, 0.0), (columns, 0.0), (columns, rows), (0.0, rows)].map(|(x, y)| on_image(x, y))
}

/// The corners of a pixel.
fn cell((column, row): (u32, u32)) -> [DVec3; 4] {
    let (x, y) = (f64::from(column), f64::from(row));
    [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)].map(|(x, y)| on_image(x, y))
}

/// From the eye through the centre of a pixel; t is the distance along the view.
fn sight_line((column, row): (u32, u32)) -> SightLine {
    let centre = on_image(f64::from(column) + 0.5, f64::from(row) + 0.5);
    SightLine {
        origin: DVec3::ZERO,
        direction: centre / IMAGE,
    }
}

/// Where in space a sight line is at t.
fn along(line: SightLine, t: f64) -> DVec3 {
    line.origin + t * line.direction
}

fn draw(sheet: &mut Sheet, scene: &Scene) -> Result<(), FigureError> {
    let Scene {
        line, plane, found, ..
    } = scene;
    let line = *line;
    let mut shown = vec![DVec3::ZERO];
    shown.extend(image());
    shown.extend(&plane.vertices);
    shown.extend(
        scene
            .primitives
            .iter()
            .flat_map(|polygon| &polygon.vertices),
    );
    let shown: Vec<DVec3> = shown.into_iter().map(stage).collect();
    let frame = sheet.frame();
    let room = Rect::new(frame.min + AROUND_EYE, frame.max - AROUND_EYE);
    let picture = Picture {
        view: View::fit(&shown, room)?,
    };

    // From the farthest to the eye, each stretch of the ray behind what it meets next.
    let mut order: Vec<(usize, f64)> = scene.distances.into_iter().enumerate().collect();
    order.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let stops = scene.stops();
    for (i, _) in order {
        let (Some(polygon), Some(&(name, role))) = (scene.primitives.get(i), PRIMITIVES.get(i))
        else {
            continue;
        };
        sheet.whole();
        let mut met = found.iter().find(|hit| hit.primitive == i).map(|hit| hit.t);
        if i == PLANE_OF {
            let outline = picture.contour(&plane.vertices);
            sheet.fill(outline.clone(), Ink::of(Role::Ground).alpha(0.5));
            sheet.stroke(outline, Pen::new(role, THIN).dashed());
            met = met.or(scene.beside);
        }
        picture.draw_primitive(sheet, polygon, name, role);
        if let Some(t) = met {
            let before = stops.iter().copied().rfind(|&stop| stop < t);
            let seen_before = found.first().is_some_and(|nearest| nearest.t < t);
            let [from, to] = [before.unwrap_or(IMAGE), t].map(|t| picture.at(along(line, t)));
            sheet.step(scene.step(t));
            if seen_before {
                marks::stopped_ray(sheet, from, to);
            } else {
                marks::ray(sheet, from, to);
            }
        }
    }
    for (i, hit) in found.iter().enumerate() {
        sheet.step(scene.step(hit.t));
        let role = if i == 0 { Role::Chosen } else { Role::Rejected };
        let at = picture.at(along(line, hit.t));
        marks::point(sheet, at, role);
        name_hit(sheet, at, exact(hit.t), role);
    }
    let outside = OUTSIDE.text(sheet.style().language);
    if let Some(t) = scene.beside {
        sheet.step(scene.step(t));
        let at = picture.at(along(line, t));
        marks::hollow_point(sheet, at, Role::Rejected);
        name_hit(
            sheet,
            at,
            format!("{}\n{outside}", exact(t)),
            Role::Rejected,
        );
    }

    picture.draw_image(sheet, scene);
    let [eye, centre] = [line.origin, along(line, IMAGE)].map(|p| picture.at(p));
    let rim = eye + (centre - eye).normalize_or_zero() * RIM;
    sheet.step(1);
    marks::ray(sheet, rim, centre);
    sheet.whole();
    marks::eye(sheet, eye, centre - eye);
    Ok(())
}

/// The scene as we see it.
struct Picture {
    view: View,
}

impl Picture {
    fn at(&self, p: DVec3) -> DVec2 {
        // All that is shown lies well in front of us.
        self.view.project(stage(p)).unwrap_or_default()
    }

    fn contour(&self, points: &[DVec3]) -> Path {
        let points: Vec<DVec2> = points.iter().map(|&p| self.at(p)).collect();
        Path::polygon(&points)
    }

    fn draw_primitive(&self, sheet: &mut Sheet, polygon: &Polygon, name: &str, role: Role) {
        let outline = self.contour(&polygon.vertices);
        sheet.fill(outline.clone(), Ink::of(role).tint(AREA));
        sheet.stroke(outline, Pen::new(role, NORMAL));
        let corners = polygon.vertices.iter().map(|&p| self.at(p));
        if let Some(highest) = corners.min_by(|p, q| p.y.total_cmp(&q.y)) {
            let label = Label::new(highest, name).towards(DVec2::NEG_Y).ink(role);
            sheet.label(label.beside());
        }
    }

    /// The image: what the rays of all pixels find.
    fn draw_image(&self, sheet: &mut Sheet, scene: &Scene) {
        sheet.whole();
        sheet.fill(self.contour(&image()), Role::Paper);
        let (columns, rows) = SIZE;
        sheet.step(scene.last());
        for pixel in (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y))) {
            let nearest = hits(&scene.primitives, sight_line(pixel)).first().copied();
            if let Some(&(_, role)) = nearest.and_then(|hit| PRIMITIVES.get(hit.primitive)) {
                sheet.fill(self.contour(&cell(pixel)), Ink::of(role).tint(CELL));
            }
        }
        sheet.whole();
        let mut grid = Path::new();
        let (width, height) = (f64::from(columns), f64::from(rows));
        for x in (0..=columns).map(f64::from) {
            grid.add_polyline(&[on_image(x, 0.0), on_image(x, height)].map(|p| self.at(p)));
        }
        for y in (0..=rows).map(f64::from) {
            grid.add_polyline(&[on_image(0.0, y), on_image(width, y)].map(|p| self.at(p)));
        }
        sheet.stroke(grid, Pen::new(Role::Note, THIN));
        let looked_at = self.contour(&cell(scene.looked_at));
        sheet.stroke(looked_at, Pen::new(Role::Chosen, NORMAL));
    }
}

/// A label beside a hit.
fn name_hit(sheet: &mut Sheet, at: DVec2, t: String, role: Role) {
    let label = Label::new(at, format!("*t* = {t}")).towards(DVec2::Y);
    sheet.label(label.ink(role).reach(12.0));
}

#[cfg(test)]
mod tests {
    use super::super::drawn::{areas, drawn, fills, shapes};
    use super::*;
    use crate::drawing::Drawing;
    use ombra_hsr::image_space::cast;
    use ombra_math::camera::Camera;
    use ombra_math::view::{self, Viewport};

    #[test]
    fn the_ray_meets_the_plane_of_c_first_and_c_not_at_all() {
        let usual = at(4, 3);
        let (scene, line) = (usual.primitives, usual.line);
        // Half a pixel right of the middle and up: 0.15 in 2.
        assert_eq!(line.direction, DVec3::new(0.075, 0.075, -1.0));
        let found = hits(&scene, line);
        let hit = |primitive, t| Hit { primitive, t };
        assert_eq!(found, [hit(0, 6.0), hit(1, 9.0)]);
        assert_eq!(hits(&[usual.plane], line), [hit(0, 4.0)]);
        // To the left of the ray, C lies where the ray of another pixel looks.
        assert_eq!(hits(&scene, sight_line((2, 3))), [hit(2, 4.0)]);
    }

    fn at(column: u32, row: u32) -> Scene {
        let pixel = format!("{column},{row}");
        Scene::new(&Inputs::default().with(&PIXEL_ASKED.input, &pixel).unwrap())
    }

    /// B comes nearest, then C, whose plane is met behind it: what the ray finds is said.
    #[test]
    fn the_caption_says_what_the_pixel_gets() {
        let caption = |typed: &[(usize, &str)], pixel: &str| {
            let inputs = Inputs::default().with(&PIXEL_ASKED.input, pixel).unwrap();
            let with = |inputs: Inputs, &(i, text): &(usize, &str)| {
                inputs.with(&DISTANCES[i].input, text).unwrap()
            };
            about(&Scene::new(&typed.iter().fold(inputs, with)), Language::En).caption
        };
        let usual = caption(&[], "4,3");
        assert!(usual.starts_with("The pixel gets *A*") && usual.contains("met sooner"));
        let moved = caption(&[(1, "3")], "4,3");
        assert!(moved.starts_with("The pixel gets *B*") && moved.contains("is met outside *C*"));
        assert!(caption(&[(1, "12")], "7,5").starts_with("The ray meets no primitive"));
        assert!(!caption(&[], "2,3").contains("outside"));
    }

    /// The plane of C is drawn as far as the ray meets it.
    #[test]
    fn the_plane_reaches_every_ray() {
        for (column, row) in [(0, 0), (7, 0), (7, 5), (0, 5), (4, 3)] {
            let pixel = format!("{column},{row}");
            let inputs = Inputs::default().with(&PIXEL_ASKED.input, &pixel).unwrap();
            let inputs = inputs.with(&DISTANCES[PLANE_OF].input, "12").unwrap();
            let scene = Scene::new(&inputs);
            let met = hits(core::slice::from_ref(&scene.plane), scene.line);
            assert_eq!(met.len(), 1, "{pixel}");
        }
    }

    fn words(drawing: &Drawing) -> Vec<&str> {
        drawing
            .labels
            .iter()
            .map(|label| label.text.as_str())
            .collect()
    }

    /// Which primitive the image shows: a cell a pixel that sees one, in its colour.
    #[test]
    fn the_image_is_the_picture_of_all_rays() {
        let (columns, rows) = SIZE;
        let camera = Camera {
            view_projection: view::frustum(-1.2, 1.2, -0.9, 0.9, IMAGE, 100.0).unwrap(),
            viewport: Viewport {
                width: columns,
                height: rows,
            },
        };
        let picture = cast(&at(4, 3).primitives, &camera).unwrap();
        let drawing = drawn(|sheet| draw(sheet, &at(4, 3)));
        for (i, (_, role)) in (0..).zip(PRIMITIVES) {
            let pixels = picture.pixels().filter(|pixel| pixel.0 == [i]).count();
            assert_eq!(areas(&drawing, Ink::of(role).tint(CELL)), pixels, "{i}");
        }
        // All three are seen somewhere.
        let seen = |i| picture.pixels().any(|pixel| pixel.0 == [i]);
        assert!((0..3).all(seen));
    }

    #[test]
    fn another_pixel_has_other_hits() {
        // Names from the farthest to the nearest, then the hits.
        let usual = drawn(|sheet| draw(sheet, &at(4, 3)));
        let hits = ["B", "A", "C", "t = 6", "t = 9", "t = 4, outside C"];
        assert_eq!(words(&usual), hits);
        // The nearer of the two points, farther left, is the one chosen.
        let across = |role| {
            let fills = fills(&usual).into_iter();
            let mut points = fills.filter(|(ink, _)| *ink == Ink::of(role));
            let (_, point) = points.next().unwrap();
            assert!(points.next().is_none());
            point.bounds().unwrap().centre().x
        };
        assert!(across(Role::Chosen) < across(Role::Rejected));
        // Through C there is nothing beside it, and nothing behind.
        let through_c = drawn(|sheet| draw(sheet, &at(2, 3)));
        assert_eq!(words(&through_c), ["B", "A", "C", "t = 4"]);
        assert_ne!(shapes(&usual), shapes(&through_c));
        // Beside A: the plane of C, then B, which is seen.
        let beside_a = drawn(|sheet| draw(sheet, &at(4, 1)));
        let hits = ["B", "A", "C", "t = 9", "t = 4, outside C"];
        assert_eq!(words(&beside_a), hits);
        let nowhere = drawn(|sheet| draw(sheet, &at(7, 3)));
        assert_eq!(words(&nowhere), ["B", "A", "C", "t = 4, outside C"]);
    }
}
