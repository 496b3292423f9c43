//! A ray through a pixel, the planes it meets, and the primitive that is seen there.

use ombra_hsr::image_space::{Hit, hits};
use ombra_hsr::polygon::Polygon;
use ombra_math::camera::SightLine;
use ombra_math::glam::{DVec2, DVec3};

use super::primitives::{AREA, PRIMITIVES};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::space::View;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/image-space-ray",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet, LOOKED_AT),
};

words! {
    SUMMARY {
        en: "A ray through a pixel: its hits, the nearest one, and a plane met beside its primitive",
        it: "Una semiretta per un pixel: le intersezioni, la più vicina e un piano colpito fuori della sua primitiva",
        cs: "Paprsek pixelem: jeho průsečíky, nejbližší z nich a rovina protnutá vedle své plochy",
        hr: "Zraka kroz piksel: njezini pogoci, najbliži od njih i ravnina pogođena pokraj svojeg poligona",
    }

    CAPTION {
        en: "The pixel gets the primitive at the nearest hit. The plane of *C* is met sooner, but outside *C*: that does not count.",
        it: "Il pixel riceve la primitiva dell’intersezione più vicina. Il piano di *C* viene prima, ma fuori di *C*: non conta.",
        cs: "Pixel dostane plochu nejbližšího průsečíku. Rovinu plochy *C* paprsek protne dřív, ale mimo *C*: to se nepočítá.",
        hr: "Piksel dobiva poligon najbližeg pogotka. Ravninu od *C* zraka pogađa prije, ali izvan *C*: to se ne računa.",
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
const LOOKED_AT: (u32, u32) = (4, 3);
/// Distances of *A*, *B* and *C* from the eye, their corners in x and y.
const DEPTHS: [f64; 3] = [6.0, 9.0, 4.0];
const A: [(f64, f64); 4] = [(-0.7, -0.8), (1.2, -1.0), (1.3, 1.1), (-0.6, 1.3)];
const B: [(f64, f64); 4] = [(-0.9, -2.1), (3.2, -2.1), (3.2, 2.5), (-0.9, 2.5)];
const C: [(f64, f64); 3] = [(-2.3, -0.7), (-0.2, 0.3), (-1.3, 0.9)];
/// Share of a primitive's colour in the pixels that show it.
const CELL: f64 = 0.6;
/// As much of the plane of *C* as shows where the ray meets it; the place of *C* among the primitives.
const PLANE: [(f64, f64); 4] = [(-2.6, -1.7), (1.6, -1.7), (1.6, 1.5), (-2.6, 1.5)];
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

/// *A*, *B* and *C*.
fn scene() -> [Polygon; 3] {
    let [a, b, c] = DEPTHS;
    [upright(&A, a), upright(&B, b), upright(&C, c)]
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

fn draw(sheet: &mut Sheet, looked_at: (u32, u32)) -> Result<(), FigureError> {
    let scene = scene();
    let line = sight_line(looked_at);
    let found = hits(&scene, line);
    // The plane of C goes on beside C.
    let plane = upright(&PLANE, DEPTHS[PLANE_OF]);
    let mut beside = hits(core::slice::from_ref(&plane), line);
    beside.retain(|_| found.iter().all(|hit| hit.primitive != PLANE_OF));

    let mut shown = vec![DVec3::ZERO];
    shown.extend(image());
    shown.extend(&plane.vertices);
    shown.extend(scene.iter().flat_map(|polygon| &polygon.vertices));
    let shown: Vec<DVec3> = shown.into_iter().map(stage).collect();
    let frame = sheet.frame();
    let room = Rect::new(frame.min + AROUND_EYE, frame.max - AROUND_EYE);
    let picture = Picture {
        view: View::fit(&shown, room)?,
    };

    // From the farthest to the eye, each stretch of the ray behind what it meets next.
    let mut order: Vec<usize> = (0..scene.len()).collect();
    let depth = |i: &usize| DEPTHS.get(*i).copied().unwrap_or_default();
    order.sort_by(|i, j| depth(j).total_cmp(&depth(i)));
    let mut stops: Vec<f64> = found.iter().chain(&beside).map(|hit| hit.t).collect();
    stops.sort_by(f64::total_cmp);
    for i in order {
        let (Some(polygon), Some(&(name, role))) = (scene.get(i), PRIMITIVES.get(i)) else {
            continue;
        };
        let mut met = found.iter().find(|hit| hit.primitive == i);
        if i == PLANE_OF {
            let outline = picture.contour(&plane.vertices);
            sheet.fill(outline.clone(), Ink::of(Role::Ground).alpha(0.5));
            sheet.stroke(outline, Pen::new(role, THIN).dashed());
            met = met.or(beside.first());
        }
        picture.draw_primitive(sheet, polygon, name, role);
        if let Some(&Hit { t, .. }) = met {
            let before = stops.iter().copied().rfind(|&stop| stop < t);
            let seen_before = found.first().is_some_and(|nearest| nearest.t < t);
            let [from, to] = [before.unwrap_or(IMAGE), t].map(|t| picture.at(along(line, t)));
            if seen_before {
                marks::stopped_ray(sheet, from, to);
            } else {
                marks::ray(sheet, from, to);
            }
        }
    }
    for (i, hit) in found.iter().enumerate() {
        let role = if i == 0 { Role::Chosen } else { Role::Rejected };
        let at = picture.at(along(line, hit.t));
        marks::point(sheet, at, role);
        name_hit(sheet, at, exact(hit.t), role);
    }
    let outside = OUTSIDE.text(sheet.style().language);
    for hit in &beside {
        let at = picture.at(along(line, hit.t));
        marks::hollow_point(sheet, at, Role::Rejected);
        name_hit(
            sheet,
            at,
            format!("{}\n{outside}", exact(hit.t)),
            Role::Rejected,
        );
    }

    picture.draw_image(sheet, &scene, looked_at);
    let [eye, centre] = [line.origin, along(line, IMAGE)].map(|p| picture.at(p));
    let rim = eye + (centre - eye).normalize_or_zero() * RIM;
    marks::ray(sheet, rim, centre);
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
    fn draw_image(&self, sheet: &mut Sheet, scene: &[Polygon], looked_at: (u32, u32)) {
        sheet.fill(self.contour(&image()), Role::Paper);
        let (columns, rows) = SIZE;
        for pixel in (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y))) {
            let nearest = hits(scene, sight_line(pixel)).first().copied();
            if let Some(&(_, role)) = nearest.and_then(|hit| PRIMITIVES.get(hit.primitive)) {
                sheet.fill(self.contour(&cell(pixel)), Ink::of(role).tint(CELL));
            }
        }
        let mut grid = Path::new();
        let (width, height) = (f64::from(columns), f64::from(rows));
        for x in (0..=columns).map(f64::from) {
            grid.add_polyline(&[on_image(x, 0.0), on_image(x, height)].map(|p| self.at(p)));
        }
        for y in (0..=rows).map(f64::from) {
            grid.add_polyline(&[on_image(0.0, y), on_image(width, y)].map(|p| self.at(p)));
        }
        sheet.stroke(grid, Pen::new(Role::Note, THIN));
        let looked_at = self.contour(&cell(looked_at));
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
        let (scene, line) = (scene(), sight_line(LOOKED_AT));
        // Half a pixel right of the middle and up: 0.15 in 2.
        assert_eq!(line.direction, DVec3::new(0.075, 0.075, -1.0));
        let found = hits(&scene, line);
        let hit = |primitive, t| Hit { primitive, t };
        assert_eq!(found, [hit(0, 6.0), hit(1, 9.0)]);
        let plane = upright(&PLANE, DEPTHS[PLANE_OF]);
        assert_eq!(hits(&[plane], line), [hit(0, 4.0)]);
        // To the left of the ray, C lies where the ray of another pixel looks.
        assert_eq!(hits(&scene, sight_line((2, 3))), [hit(2, 4.0)]);
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
        let picture = cast(&scene(), &camera).unwrap();
        let drawing = drawn(|sheet| draw(sheet, LOOKED_AT));
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
        let usual = drawn(|sheet| draw(sheet, LOOKED_AT));
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
        let through_c = drawn(|sheet| draw(sheet, (2, 3)));
        assert_eq!(words(&through_c), ["B", "A", "C", "t = 4"]);
        assert_ne!(shapes(&usual), shapes(&through_c));
        // Beside A: the plane of C, then B, which is seen.
        let beside_a = drawn(|sheet| draw(sheet, (4, 1)));
        let hits = ["B", "A", "C", "t = 9", "t = 4, outside C"];
        assert_eq!(words(&beside_a), hits);
        let nowhere = drawn(|sheet| draw(sheet, (7, 3)));
        assert_eq!(words(&nowhere), ["B", "A", "C"]);
    }
}
