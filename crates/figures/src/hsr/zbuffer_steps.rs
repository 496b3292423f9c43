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
use crate::number::decimal;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/zbuffer-steps",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw_steps(sheet),
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

    /// The second step.
    FIRST {
        en: "*A* is drawn",
        it: "si disegna *A*",
        cs: "kreslí se *A*",
        hr: "crta se *A*",
    }

    /// The third step.
    CROSSING {
        en: "*B* crosses *A*",
        it: "*B* interseca *A*",
        cs: "*B* protíná *A*",
        hr: "*B* siječe *A*",
    }

    /// The fourth step.
    BEHIND {
        en: "*C* lies behind",
        it: "*C* sta dietro",
        cs: "*C* leží vzadu",
        hr: "*C* je iza",
    }
}

/// Pixels across and down.
const SIZE: u32 = 6;
/// The far plane's distance; the near plane's is 0.
const FAR: f64 = 8.0;

/// A triangle of the picture, y down, with its distance z = `at_left` + `slope` (x − ½): `at_left` in the first column.
/// Corners in eighths of a pixel stay where they are when they are snapped.
#[derive(Clone, Copy)]
struct Triangle {
    corners: [(f64, f64); 3],
    at_left: f64,
    slope: f64,
    /// The pixel of its own in which its name stands.
    named_in: (i32, i32),
}

/// In the order they are drawn: two that cross, and one behind both.
const TRIANGLES: [Triangle; 3] = [
    Triangle {
        corners: [(0.125, 0.125), (0.125, 3.75), (5.875, 2.25)],
        at_left: 1.0,
        slope: 1.0,
        named_in: (1, 1),
    },
    Triangle {
        corners: [(5.875, 0.625), (5.875, 5.125), (0.25, 3.25)],
        at_left: 6.0,
        slope: -1.0,
        named_in: (5, 2),
    },
    Triangle {
        corners: [(0.125, 5.875), (5.875, 5.875), (3.375, 0.125)],
        at_left: 7.0,
        slope: 0.0,
        named_in: (2, 4),
    },
];

impl Triangle {
    /// In the world: x to the right, y up, the eye looking along −z.
    fn mesh(&self) -> Result<Mesh, FigureError> {
        let positions = self.corners.map(|(x, y)| {
            let z = self.at_left + self.slope * (x - 0.5);
            DVec3::new(x, f64::from(SIZE) - y, -z)
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

/// The triangles with their numbers.
fn numbered() -> Vec<(u32, Triangle)> {
    (0..).zip(TRIANGLES).collect()
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

/// Height of the words above a buffer, and free space between the two.
const HEAD: f64 = 1.5 * NOTE;
const GAP: f64 = 16.0;

fn draw_steps(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [CLEARED, FIRST, CROSSING, BEHIND].map(|word| word.text(language));
    let panels = panels(sheet, &lines, 2.3)?;
    for (i, (panel, step)) in panels.into_iter().zip(steps(&numbered())?).enumerate() {
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
        draw_colour(sheet, &colour, &step)?;
        if let Some(triangle) = i.checked_sub(1).and_then(|i| TRIANGLES.get(i)) {
            colour.polygon(sheet, &triangle.corners.map(DVec2::from));
        }
        draw_depth(sheet, &depth, &step)?;
    }
    Ok(())
}

/// Every pixel in the colour of the triangle seen there; each triangle named.
fn draw_colour(sheet: &mut Sheet, grid: &Grid, step: &Step) -> Result<(), FigureError> {
    grid.draw_cells(sheet);
    let named = (0..).zip(&TRIANGLES).zip(PRIMITIVES);
    for ((id, triangle), (name, role)) in named {
        let on = seen(&step.picture, id);
        if on.is_empty() {
            continue;
        }
        grid.fill(sheet, &on, Ink::of(role));
        let at = grid.centre(triangle.named_in.into());
        sheet.text(at, Align::Centre, name, LABEL, Role::Text)?;
    }
    grid.draw_centres(sheet);
    Ok(())
}

/// The distance of every pixel; those just written are marked.
fn draw_depth(sheet: &mut Sheet, grid: &Grid, step: &Step) -> Result<(), FigureError> {
    grid.draw_cells(sheet);
    sheet.fill_unmarked(
        grid.cells(&step.written),
        Ink::of(Role::Chosen).tint(0.2),
        Pen::new(Role::Chosen, THIN),
    );
    for pixel in pixels() {
        let p = pixel.as_uvec2();
        let Some(depth) = step.depth.depth(p.x, p.y) else {
            continue;
        };
        let role = if step.written.contains(&pixel) {
            Role::Text
        } else {
            Role::Note
        };
        let size = (0.62 * grid.cell()).min(LABEL);
        let text = decimal(FAR * depth);
        sheet.text(grid.centre(pixel), Align::Centre, &text, size, role)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use ombra_math::predicates::orient_2d;

    use super::*;

    fn covers(triangle: &Triangle, pixel: IVec2) -> bool {
        let [a, b, c] = triangle.corners.map(DVec2::from);
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
        let [a, b, c] = TRIANGLES;
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
}
