//! The shadow matrix beside the cube: a vertex, its product, its shadow.

use ombra_math::glam::{DVec2, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_shadows::planar::shadow_matrix;

use super::setting::{ABOVE, GROUND, OBJECT, Setting, TURN, light, on_sheet};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::matrix::Matrix;
use crate::number::{as_typed, coordinates, exact};
use crate::path::Rect;
use crate::sheet::{Align, Label, Sheet};
use crate::solid::mesh;
use crate::solid::sight::Sight;
use crate::space::axes;
use crate::text::LABEL;
use crate::words::words;

/// Olomouc, Zdroj světla v bodě; Bologna, Ombre su piani, caso generale.
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/shadow-matrix",
    takes: Takes::These(&[
        VERTEX.input,
        LIGHT.input,
        GROUND.input,
        TURN.input,
        ABOVE.input,
    ]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "The shadow matrix beside the cube: a vertex, the product, its shadow",
        it: "La matrice dell’ombra accanto al cubo: un vertice, il prodotto, la sua ombra",
        cs: "Matice stínu vedle krychle: vrchol, součin, jeho stín",
        hr: "Matrica sjene uz kocku: vrh, umnožak, njegova sjena",
    }

    CAPTION {
        en: "One matrix for all vertices: the product with a vertex, divided by its last component, is the shadow.",
        it: "Una matrice per tutti i vertici: il prodotto con un vertice, diviso per l’ultima componente, è l’ombra.",
        cs: "Jedna matice pro všechny vrcholy: součin s vrcholem, dělený poslední složkou, je stín.",
        hr: "Jedna matrica za sve vrhove: umnožak s vrhom, podijeljen posljednjom komponentom, jest sjena.",
    }

    /// An input.
    VERTEX_WORD {
        en: "number of the cube’s vertex",
        it: "numero del vertice del cubo",
        cs: "číslo vrcholu krychle",
        hr: "broj vrha kocke",
    }
}

const LIGHT: Ask<DVec4> = light([0.0, 100.0, 100.0, 1.0]);
const VERTEX: Ask<i32> = Ask::whole("vertex", "*i*", VERTEX_WORD, 7, [1, 8]);
/// Between the picture and the equations, and between two of these.
const SPACE: f64 = 0.9 * LABEL;
/// Between a matrix and what follows it on its line.
const BESIDE: f64 = 16.0;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let (light, plane) = (inputs.get(&LIGHT), inputs.get(&GROUND));
    let matrix = shadow_matrix(plane, light).map_err(|error| FigureError::Scene {
        reason: format!(
            "the light {} and the plane {} have no shadow matrix: {error} (--light, --plane)",
            as_typed(&light.to_array()),
            as_typed(&plane.coefficients().to_array())
        ),
    })?;
    // The lectures’ cube always: its vertices have numbers.
    let object = inputs.get(&OBJECT);
    let setting = Setting::new(&object, light, plane)?.seen(inputs);
    let number = inputs.get(&VERTEX);
    let chosen = usize::try_from(number - 1).unwrap_or(0);
    let v = setting
        .mesh
        .positions
        .get(chosen)
        .copied()
        .unwrap_or_default();
    let product = matrix * point(v);

    let column = |v: DVec4| v.to_array().map(|x| [exact(x)]);
    let rows = matrix
        .transpose()
        .to_cols_array_2d()
        .map(|row| row.map(exact));
    let equation = Equation {
        parts: [
            (Matrix::new(sheet, &rows)?, Role::Text),
            (Matrix::new(sheet, &column(point(v)))?, Role::Occluder),
            (Matrix::new(sheet, &column(product))?, Role::Text),
        ],
        rule: "*M* = (**π** · **L**) *I* − **L** **π**^T".to_owned(),
        result: match project(product)
            .filter(|_| setting.casts.get(chosen).copied().flatten().is_some())
        {
            Some(p) => format!("*P*_{{{number}}} = {}", coordinates(p)),
            None => format!("*P*_{{{number}}}: —"),
        },
    };

    // Beside the picture, or below it on a sheet that is higher than wide.
    let frame = sheet.frame();
    let size = equation.size(sheet)?;
    if size.x > frame.size().x || size.y > 0.7 * frame.size().y {
        return Err(FigureError::Scene {
            reason: format!(
                "the matrix of the light {} and the plane {} has numbers too long to be written beside the cube",
                as_typed(&light.to_array()),
                as_typed(&plane.coefficients().to_array())
            ),
        });
    }
    let aside = frame.size().x - size.x > frame.size().y - size.y;
    let mut left = frame;
    let corner = if aside {
        left.max.x -= size.x + SPACE;
        DVec2::new(frame.max.x - size.x, frame.centre().y - 0.5 * size.y)
    } else {
        left.max.y -= size.y + SPACE;
        DVec2::new(frame.centre().x - 0.5 * size.x, frame.max.y - size.y)
    };
    draw_scene(sheet, &setting, left, (chosen, number))?;
    equation.draw(sheet, corner)
}

/// The cube, its shadow, one vertex with its ray.
fn draw_scene(
    sheet: &mut Sheet,
    setting: &Setting,
    frame: Rect,
    (chosen, number): (usize, i32),
) -> Result<(), FigureError> {
    let stage = setting.stage(frame, &[])?;
    let view = &stage.view;
    stage.patch.draw(sheet, view);
    sheet.step(4);
    setting.draw_shadow(sheet, &stage);
    setting.draw_edges_in_shadow(sheet, &stage);
    sheet.step(0);
    mesh(sheet, view, &setting.shown, Role::Occluder)?;
    let sight = Sight::new(view, &setting.shown);
    axes(sheet, view, &sight, stage.patch.axis());
    setting.draw_light(sheet, view, &sight);
    let v = setting
        .mesh
        .positions
        .get(chosen)
        .copied()
        .unwrap_or_default();
    if let Some(at) = on_sheet(sheet, view, v) {
        marks::point(sheet, at, Role::Occluder);
        let label = Label::new(at, format!("*V*_{{{number}}}")).ink(Role::Occluder);
        sheet.label(label.towards(DVec2::new(1.0, -1.0)));
    }
    if let Some(p) = setting.casts.get(chosen).copied().flatten() {
        sheet.step(4);
        for (a, b) in sight.visible(v, p) {
            if let Some((a, b)) = view.segment(a, b)
                && let Some((a, b)) = sheet.frame().cut(a, b)
            {
                marks::stopped_ray(sheet, a, b);
            }
        }
        if let Some(at) = on_sheet(sheet, view, p) {
            marks::point(sheet, at, Role::Shadow);
            let label = Label::new(at, format!("*P*_{{{number}}}")).ink(Role::Shadow);
            sheet.label(label.towards(DVec2::new(-1.0, 1.0)));
        }
        sheet.step(0);
    }
    Ok(())
}

/// The rule, the product written out, and the point.
struct Equation {
    parts: [(Matrix, Role); 3],
    rule: String,
    result: String,
}

impl Equation {
    fn size(&self, sheet: &Sheet) -> Result<DVec2, FigureError> {
        let rule = sheet.lay_out(&self.rule, LABEL)?;
        let result = sheet.lay_out(&self.result, LABEL)?;
        let equals = sheet.lay_out("=", LABEL)?.width;
        let sizes = self.parts.each_ref().map(|(matrix, _)| matrix.size());
        let across = sizes.iter().map(|size| size.x).sum::<f64>() + 3.0 * BESIDE + equals;
        let down = sizes.iter().map(|size| size.y).fold(0.0, f64::max);
        let texts = [&rule, &result].map(|line| line.ascent + line.descent);
        Ok(DVec2::new(
            across.max(rule.width).max(result.width),
            down + texts.iter().sum::<f64>() + 2.0 * SPACE,
        ))
    }

    /// The rule with step 1, the matrix with 2, the vertex and the product with 3, the point with 4.
    fn draw(self, sheet: &mut Sheet, corner: DVec2) -> Result<(), FigureError> {
        let Equation {
            parts,
            rule,
            result,
        } = self;
        sheet.step(1);
        let line = sheet.lay_out(&rule, LABEL)?;
        let mut top = corner.y + line.ascent + line.descent + SPACE;
        let at = DVec2::new(corner.x, corner.y + line.ascent);
        sheet.set_at(line, at, Role::Text.into());

        let tallest = parts
            .iter()
            .map(|(matrix, _)| matrix.size().y)
            .fold(0.0, f64::max);
        let middle = top + 0.5 * tallest;
        let mut left = corner.x;
        for (i, (matrix, role)) in parts.into_iter().enumerate() {
            sheet.step(if i == 0 { 2 } else { 3 });
            if i == 2 {
                let bounds = sheet.text(
                    DVec2::new(left, middle),
                    Align::Left,
                    "=",
                    LABEL,
                    Role::Text,
                )?;
                left += bounds.size().x + BESIDE;
            }
            let size = matrix.size();
            matrix.draw(sheet, DVec2::new(left, middle - 0.5 * size.y), role);
            left += size.x + BESIDE;
        }
        top += tallest + SPACE;
        sheet.step(4);
        let line = sheet.lay_out(&result, LABEL)?;
        let at = DVec2::new(corner.x, top + line.ascent);
        sheet.set_at(line, at, Role::Shadow.into());
        sheet.step(0);
        Ok(())
    }
}
