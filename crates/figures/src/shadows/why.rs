//! One picture of a ball three times: only the shadow says where it is.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast_onto;

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Paint, Pen, THIN};
use crate::figure::{About, Figure, Takes};
use crate::input::Ask;
use crate::panels::panels;
use crate::patch::Patch;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::space::View;
use crate::words::words;

/// Bologna, Funzioni dell'ombra; Olomouc, Stíny; Croatian 8.4, uloga sjene u percepciji.
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/why",
    takes: Takes::These(&[HEIGHT.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| {
        let language = sheet.style().language;
        let lines = [WITHOUT, RESTING, HOVERING].map(|word| word.text(language));
        let frames = panels(sheet, &lines, 0.85)?;

        // From far away nothing shrinks with distance, so a ball that moves along the sight line keeps its picture.
        let resting = DVec3::new(0.0, 1.0, 0.0);
        let hovering = resting + View::towards_eye() * inputs.get(&HEIGHT);
        let balls = [None, Some(resting), Some(hovering)];
        let shadows = balls.map(|ball| ball.map(outline_shadow).unwrap_or_default());
        let ground = Patch::with_cells(Plane::GROUND, &shadows.concat(), Some(0.8))?;
        let receiver = ground.corners();
        let mut shown = receiver.to_vec();
        shown.extend([resting - DVec3::X, resting + DVec3::Y * 1.2]);

        for (i, (frame, ball)) in frames.into_iter().zip(balls).enumerate() {
            sheet.panel(i, frame);
            let view = View::fit_from_afar(&shown, frame)?;
            ground.draw(sheet, &view);
            if let Some(ball) = ball {
                let shadow = cast_onto(&receiver, LIGHT, &outline(ball));
                if let Some(contour) = view.contour(&shadow) {
                    let pen = Pen::new(Role::Shadow, THIN);
                    sheet.fill_unmarked(Path::polygon(&contour), Role::Umbra, pen);
                }
            }
            let middle = ball.unwrap_or(resting);
            let aside = View::towards_eye().cross(DVec3::Y).normalize_or_zero();
            if let (Some(centre), Some(side)) = (view.project(middle), view.project(middle + aside))
            {
                draw_ball(sheet, centre, centre.distance(side));
            }
        }
        Ok(())
    },
};

words! {
    SUMMARY {
        en: "The same ball without shadow, resting, hovering",
        it: "La stessa palla senza ombra, appoggiata, sospesa",
        cs: "Táž koule bez stínu, na zemi, nad zemí",
        hr: "Ista kugla bez sjene, na podlozi, iznad podloge",
    }

    CAPTION {
        en: "The picture of the ball is the same three times: only the shadow tells where it is.",
        it: "L’immagine della palla è la stessa tre volte: solo l’ombra dice dove si trova.",
        cs: "Obraz koule je třikrát týž: jen stín prozradí, kde je.",
        hr: "Slika kugle triput je ista: samo sjena govori gdje je.",
    }

    /// An input.
    HEIGHT_WORD {
        en: "how far the ball hovers, in its radii, towards the eye",
        it: "quanto la palla è sospesa, in raggi, verso l’osservatore",
        cs: "jak daleko se koule vznáší, v jejích poloměrech, směrem k pozorovateli",
        hr: "koliko daleko kugla lebdi, u njezinim polumjerima, prema oku",
    }

    /// First panel of `shadows/why`.
    WITHOUT {
        en: "no shadow",
        it: "senza ombra",
        cs: "bez stínu",
        hr: "bez sjene",
    }

    /// Second panel of `shadows/why`.
    RESTING {
        en: "resting",
        it: "appoggiata",
        cs: "leží na zemi",
        hr: "leži na podlozi",
    }

    /// Third panel of `shadows/why`.
    HOVERING {
        en: "hovering",
        it: "sospesa",
        cs: "vznáší se",
        hr: "lebdi",
    }
}

/// From above, a little from the left of the picture.
const LIGHT: DVec4 = DVec4::new(-0.40, 1.0, -0.26, 0.0);
/// How far the hovering ball of radius 1 is from the resting one, towards the eye.
const HEIGHT: Ask<f64> = Ask::number("height", "*h*", HEIGHT_WORD, 2.0, [0.2, 4.0]);
/// Corners of its outline.
const CORNERS: u32 = 72;

/// The circle on a ball of radius 1 where the light touches it: its shadow is the ball's.
fn outline(centre: DVec3) -> Vec<DVec3> {
    let light = LIGHT.truncate().normalize_or_zero();
    let (u, v) = light.any_orthonormal_pair();
    (0..CORNERS)
        .map(|i| {
            let angle = core::f64::consts::TAU * f64::from(i) / f64::from(CORNERS);
            centre + u * libm::cos(angle) + v * libm::sin(angle)
        })
        .collect()
}

fn outline_shadow(centre: DVec3) -> Vec<DVec3> {
    let cast = |p: DVec3| ombra_shadows::planar::cast(Plane::GROUND, LIGHT, p);
    outline(centre).into_iter().filter_map(cast).collect()
}

/// Lit from the light's side; a gradient until there is a renderer.
fn draw_ball(sheet: &mut Sheet, centre: DVec2, radius: f64) {
    let ink = |share| Ink::of(Role::Occluder).tint(share);
    let stops = match sheet.style().theme {
        crate::style::Theme::Light => [(0.0, ink(0.18)), (0.45, ink(0.62)), (1.0, ink(1.0))],
        crate::style::Theme::Dark => [(0.0, ink(1.0)), (0.45, ink(0.72)), (1.0, ink(0.3))],
    };
    let paint = Paint::Radial {
        centre: centre + DVec2::new(-0.30, -0.48) * radius,
        radius: 1.5 * radius,
        stops: stops.to_vec(),
    };
    let circle = Path::circle(centre, radius);
    sheet.fill(circle.clone(), paint);
    sheet.stroke(circle, Pen::new(Role::Occluder, NORMAL));
}
