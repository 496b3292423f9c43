//! How far apart stored depths are, against distance, for four formats.

use ombra_hsr::z_buffer::precision::{depth_step, separable_distance};
use ombra_hsr::z_buffer::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};

use crate::chart::{Axis, Chart, Scale, Series};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::number::decimal;
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/depth-precision",
    takes: Takes::These(&[NEAR.input, FAR.input, FROM.input, TO.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| draw(sheet, &View::new(inputs)?),
};

words! {
    SUMMARY {
        en: "Depth step against distance: 16 bits, 24 bits, single precision, and single precision reversed",
        it: "Passo di profondità e distanza: 16 bit, 24 bit, precisione singola, e precisione singola invertita",
        cs: "Krok hloubky podle vzdálenosti: 16 bitů, 24 bitů, jednoduchá přesnost a jednoduchá přesnost obráceně",
        hr: "Korak dubine prema udaljenosti: 16 bitova, 24 bita, jednostruka preciznost i obrnuta jednostruka preciznost",
    }

    CAPTION {
        en: "Surfaces nearer to each other than the step may get the same depth. Lines are the formula, marks are measured; reversed, 1\u{a0}−\u{a0}*d* is stored.",
        it: "Superfici più vicine tra loro del passo possono avere la stessa profondità. Linee: formula; segni: misure; invertito, si memorizza 1\u{a0}−\u{a0}*d*.",
        cs: "Plochy bližší k sobě než krok mohou mít stejnou hloubku. Čáry jsou vzorec, značky měření; obráceně se ukládá 1\u{a0}−\u{a0}*d*.",
        hr: "Plohe bliže jedna drugoj od koraka mogu imati istu dubinu. Crte su formula, oznake mjerenja; obrnuto se pohranjuje 1\u{a0}−\u{a0}*d*.",
    }

    /// An input.
    NEAR_OF {
        en: "distance of the near plane, in metres",
        it: "distanza del piano vicino, in metri",
        cs: "vzdálenost přední roviny, v metrech",
        hr: "udaljenost prednje ravnine, u metrima",
    }

    /// An input.
    FAR_OF {
        en: "distance of the far plane, in metres",
        it: "distanza del piano lontano, in metri",
        cs: "vzdálenost zadní roviny, v metrech",
        hr: "udaljenost stražnje ravnine, u metrima",
    }

    /// An input.
    FROM_OF {
        en: "the least distance shown; without it a quarter beyond the near plane",
        it: "la minima distanza mostrata; senza, un quarto oltre il piano vicino",
        cs: "nejmenší zobrazená vzdálenost; bez ní čtvrtina za přední rovinou",
        hr: "najmanja prikazana udaljenost; bez nje četvrtina iza prednje ravnine",
    }

    /// An input.
    TO_OF {
        en: "the greatest distance shown; without it a tenth of the far plane’s",
        it: "la massima distanza mostrata; senza, un decimo di quella del piano lontano",
        cs: "největší zobrazená vzdálenost; bez ní desetina vzdálenosti zadní roviny",
        hr: "najveća prikazana udaljenost; bez nje desetina udaljenosti stražnje ravnine",
    }

    /// to the right.
    DISTANCE {
        en: "distance *z*",
        it: "distanza *z*",
        cs: "vzdálenost *z*",
        hr: "udaljenost *z*",
    }

    /// upwards.
    STEP {
        en: "depth step Δ*z*",
        it: "passo di profondità Δ*z*",
        cs: "krok hloubky Δ*z*",
        hr: "korak dubine Δ*z*",
    }

    /// a curve.
    PRECISION_16 {
        en: "16 bits",
        it: "16 bit",
        cs: "16 bitů",
        hr: "16 bitova",
    }

    /// a curve, on which that of single precision lies but for its beginning.
    PRECISION_24 {
        en: "24 bits, f32",
        it: "24 bit, f32",
        cs: "24 bitů, f32",
        hr: "24 bita, f32",
    }

    /// a curve.
    REVERSED {
        en: "f32 reversed",
        it: "f32 invertito",
        cs: "f32 obráceně",
        hr: "f32 obrnuto",
    }
}

/// Planes of the view, in metres.
const NEAR: Ask<f64> = Ask::number("near", "*n*", NEAR_OF, 0.1, [0.001, 100.0]);
const FAR: Ask<f64> = Ask::number("far", "*f*", FAR_OF, 10_000.0, [1.0, 1_000_000.0]);
/// Distances shown: from a quarter beyond the near plane, at which single precision is infinitely fine.
const FROM: Ask<f64> = Ask::number("from", "", FROM_OF, 0.125, [0.001, 1_000_000.0]);
const TO: Ask<f64> = Ask::number("to", "", TO_OF, 1000.0, [0.001, 1_000_000.0]);
/// Points of a line, less one, and how many of them to a measurement.
const LAST: usize = 240;
const EVERY: usize = 20;
/// Half the width of a jump, as a share of its distance: well above rounding, and nothing on the canvas.
const JUMP: f64 = 1e-9;

/// The planes and the distances shown.
#[derive(Clone, Copy)]
struct View {
    near: f64,
    far: f64,
    shown: (f64, f64),
}

impl View {
    fn new(inputs: &Inputs) -> Result<View, FigureError> {
        let (near, far) = (inputs.get(&NEAR), inputs.get(&FAR));
        let or = |ask: &Ask<f64>, usual: f64| match inputs.has(ask) {
            true => inputs.get(ask),
            false => usual,
        };
        let wrong = |reason: String| Err(FigureError::Scene { reason });
        if near >= far {
            return wrong(format!(
                "near = {near}, far = {far}: the far plane must lie beyond the near plane"
            ));
        }
        // As 0.125 m and 1000 m are of 0.1 m and 10 km, both exact; no distance shown lies beyond the far plane.
        let from = or(&FROM, 1.25 * near);
        let usual = if far / 10.0 > from { far / 10.0 } else { far };
        let to = or(&TO, usual);
        if from <= near {
            return wrong(format!(
                "from = {from}: the distances shown must begin beyond the near plane, near = {near}"
            ));
        }
        if to <= from || to > far {
            return wrong(format!(
                "to = {to}: the distances shown must end beyond from = {from} and no farther than far = {far}"
            ));
        }
        let shown = (from, to);
        Ok(View { near, far, shown })
    }

    /// From one shown to the other in equal ratios.
    fn distances(self) -> impl Iterator<Item = f64> {
        let (from, to) = self.shown;
        (0..=LAST).map(move |i| match i {
            // Not a digit beyond.
            LAST => to,
            i => from * libm::pow(to / from, i as f64 / LAST as f64),
        })
    }

    /// Distances of the line; where the spacing of what is stored jumps, right before and behind.
    fn line<F: DepthFormat>(self) -> Vec<f64> {
        let View { near, far, shown } = self;
        let powers = (1..64).map(|e| libm::scalbn(1.0, -e));
        let jumps = powers.filter(|&v| F::spacing(0.75 * v) != F::spacing(v));
        // d = f (z − n) / (z (f − n)), solved for z.
        let place = |v: f64| {
            let d = if F::REVERSED { 1.0 - v } else { v };
            far * near / (far - d * (far - near))
        };
        let beside = |z: f64| [z * (1.0 - JUMP), z * (1.0 + JUMP)];
        let mut all: Vec<f64> = jumps.map(place).flat_map(beside).collect();
        all.retain(|&z| shown.0 < z && z < shown.1);
        all.extend(self.distances());
        all.sort_by(f64::total_cmp);
        all
    }

    /// The step by the formula as a line; measured as marks, the first at the point `first` of the line.
    fn series<F: DepthFormat>(self, name: &str, first: usize) -> Series {
        let View { near, far, .. } = self;
        // What is infinitely fine has no place on a chart of ratios.
        let is_shown = |step: &f64| *step > 0.0;
        let step = |z| Some((z, depth_step::<F>(near, far, z).filter(is_shown)?));
        let measured = |z| Some((z, separable_distance::<F>(near, far, z).filter(is_shown)?));
        let marks = self.distances().skip(first).step_by(EVERY);
        Series {
            joined: false,
            line: self.line::<F>().into_iter().filter_map(step).collect(),
            ..Series::new(name, marks.filter_map(measured).collect())
        }
    }
}

fn draw(sheet: &mut Sheet, view: &View) -> Result<(), FigureError> {
    let language = sheet.style().language;
    // Above single precision, on which it lies but for the near end; the marks of the two alternate.
    let series = vec![
        view.series::<Depth16>(PRECISION_16.text(language), 0),
        named_at_the_near_end(view.series::<Depth32F>("f32", EVERY / 2)),
        view.series::<Depth24>(PRECISION_24.text(language), 0),
        view.series::<ReversedDepth32F>(REVERSED.text(language), 0),
    ];
    let planes = format!(
        "*n* = {} m, *f* = {} m",
        decimal(view.near),
        decimal(view.far)
    );
    let chart = Chart {
        id: FIGURE.id.to_owned(),
        title: SUMMARY.text(language).to_owned(),
        x: Axis::new(DISTANCE.text(language), "m", Scale::Log),
        y: Axis::new(STEP.text(language), "m", Scale::Log),
        series,
        pareto: None,
        settings: planes,
    };
    chart.draw_on(sheet)
}

/// A name stands at the last point.
fn named_at_the_near_end(mut series: Series) -> Series {
    series.points.reverse();
    series
}

#[cfg(test)]
mod tests {
    use super::*;

    fn usual() -> View {
        View::new(&Inputs::default()).unwrap()
    }

    fn given(typed: &[(&Ask<f64>, &str)]) -> Result<View, FigureError> {
        let with = |inputs: Inputs, (ask, text): &(&Ask<f64>, &str)| {
            inputs.with(&ask.input, text).unwrap()
        };
        View::new(&typed.iter().fold(Inputs::default(), with))
    }

    #[test]
    fn distances_lie_between_the_planes_or_are_refused_by_name() {
        assert_eq!(usual().shown, (0.125, 1000.0));
        let moved = given(&[(&NEAR, "1"), (&FAR, "100")]).unwrap();
        assert_eq!(moved.shown, (1.25, 10.0));
        // Δz = δ z² (f − n) / (f n) = (100 · 99) / (100 · 65535) at 10 m.
        let (z, step) = *moved.series::<Depth16>("", 0).line.last().unwrap();
        assert!(
            z == 10.0 && (step * 65_535.0 / 99.0 - 1.0).abs() < 1e-14,
            "{step}"
        );
        for (typed, says) in [
            (vec![(&NEAR, "100"), (&FAR, "50")], "near = 100, far = 50"),
            (vec![(&FROM, "0.1")], "from = 0.1:"),
            (vec![(&FROM, "5"), (&TO, "2")], "to = 2:"),
            (vec![(&TO, "20000")], "to = 20000:"),
        ] {
            let error = given(&typed).err().unwrap().to_string();
            assert!(error.contains(says), "{error}");
        }
    }

    fn all() -> [Series; 4] {
        let view = usual();
        [
            view.series::<Depth16>("", 0),
            view.series::<Depth24>("", 0),
            view.series::<Depth32F>("", 0),
            view.series::<ReversedDepth32F>("", 0),
        ]
    }

    /// Δz = δ z² (f − n) / (f n), in metres at 1000 m: δ (10⁶ · 9999.9) / 1000 = 9 999 900 δ.
    #[test]
    fn curves_end_where_the_formula_does() {
        let [b16, b24, float, reversed] = all().map(|series| *series.line.last().unwrap());
        let whole = 9_999_900.0;
        // A few roundings of a double.
        let is = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-14 * wanted;
        assert!(is(b16.1, whole / 65_535.0), "{b16:?}");
        assert!(is(b24.1, whole / 16_777_215.0), "{b24:?}");
        // d is just below 1: 2⁻²⁴ apart.
        assert!(is(float.1, whole / 16_777_216.0), "{float:?}");
        // 1 − d = 9 · 10⁻⁵ lies between 2⁻¹⁴ and 2⁻¹³.
        assert!(is(reversed.1, whole / 137_438_953_472.0), "{reversed:?}");
        for (z, _) in [b16, b24, float, reversed] {
            assert_eq!(z, 1000.0);
        }
    }

    /// An interval between two borders holds about a step; in floating point the stored value beside a power of two has
    /// half of it on one side, and the step varies by z² within it where it is wide.
    #[test]
    fn marks_lie_on_their_lines() {
        for series in all() {
            assert_eq!(series.points.len(), 13);
            for mark in &series.points {
                let line = series.line.iter().find(|line| line.0 == mark.0).unwrap();
                let ratio = mark.1 / line.1;
                assert!((0.7..1.4).contains(&ratio), "{mark:?} {line:?}");
            }
        }
    }

    /// Between 0.125 m and 1000 m d passes ½ and ¼ (z = 0.2 m and 0.133 m), and 1 − d the powers from ½ to 2⁻¹³.
    #[test]
    fn steps_of_floating_point_jump_upright() {
        let mut jumps = Vec::new();
        for series in all() {
            let pairs = series.line.windows(2);
            let apart = pairs.clone().filter(|pair| pair[0].0 >= pair[1].0).count();
            assert_eq!(apart, 0);
            let factor = |pair: &&[(f64, f64)]| pair[1].1 / pair[0].1;
            let jump = |pair: &&[(f64, f64)]| !(0.8..1.25).contains(&factor(pair));
            let found: Vec<_> = pairs.filter(jump).collect();
            for pair in &found {
                assert!(pair[1].0 / pair[0].0 - 1.0 < 3e-9, "{pair:?}");
                let factor = factor(pair);
                // A power of two but for the change of z.
                let is = |wanted: f64| (factor / wanted - 1.0).abs() < 1e-8;
                assert!(is(2.0) || is(0.5), "{pair:?}");
            }
            jumps.push(found.len());
        }
        assert_eq!(jumps, [0, 0, 2, 13]);
    }

    /// What the figure is drawn for.
    #[test]
    fn only_reversed_keeps_its_digits_far_away() {
        let [b16, b24, float, reversed] = all();
        // Where the line has no jump: at the same distances for all.
        let [b16, b24, float, reversed] = [b16, b24, float, reversed].map(|mut series| {
            series
                .line
                .retain(|(z, _)| usual().distances().any(|at| at == *z));
            series
        });
        for (a, b) in b16.line.iter().zip(&b24.line) {
            assert!(a.1 > 200.0 * b.1);
        }
        // Past twice the near plane d > ½, so single precision is as coarse as 24 bits.
        for (a, b) in b24.line.iter().zip(&float.line).filter(|(a, _)| a.0 > 0.21) {
            assert!((a.1 / b.1 - 1.0).abs() < 1e-6, "{a:?} {b:?}");
        }
        assert!(b24.line[0].1 > 3.0 * float.line[0].1);
        for (z, step) in reversed.line {
            let relative = step / z * 16_777_216.0;
            assert!((0.8..2.2).contains(&relative), "{z} {relative}");
        }
    }
}
