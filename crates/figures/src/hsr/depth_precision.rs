//! How far apart stored depths are, against distance, for four formats.

use ombra_hsr::z_buffer::precision::{depth_step, separable_distance};
use ombra_hsr::z_buffer::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};

use crate::chart::{Axis, Chart, Scale, Series};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::number::decimal;
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/depth-precision",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
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
const NEAR: f64 = 0.1;
const FAR: f64 = 10_000.0;
/// Distances shown: from a quarter beyond the near plane, at which single precision is infinitely fine.
const SHOWN: (f64, f64) = (0.125, 1000.0);
/// Points of a line, less one, and how many of them to a measurement.
const LAST: usize = 240;
const EVERY: usize = 20;
/// Half the width of a jump, as a share of its distance: well above rounding, and nothing on the canvas.
const JUMP: f64 = 1e-9;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    // Above single precision, on which it lies but for the near end; the marks of the two alternate.
    let series = vec![
        series::<Depth16>(PRECISION_16.text(language), 0),
        named_at_the_near_end(series::<Depth32F>("f32", EVERY / 2)),
        series::<Depth24>(PRECISION_24.text(language), 0),
        series::<ReversedDepth32F>(REVERSED.text(language), 0),
    ];
    let planes = format!("*n* = {} m, *f* = {} m", decimal(NEAR), decimal(FAR));
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

/// The step by the formula as a line; measured as marks, the first at the point `first` of the line.
fn series<F: DepthFormat>(name: &str, first: usize) -> Series {
    let step = |z| Some((z, depth_step::<F>(NEAR, FAR, z)?));
    let measured = |z| Some((z, separable_distance::<F>(NEAR, FAR, z)?));
    let marks = distances().skip(first).step_by(EVERY);
    Series {
        joined: false,
        line: line::<F>().into_iter().filter_map(step).collect(),
        ..Series::new(name, marks.filter_map(measured).collect())
    }
}

/// Distances of the line; where the spacing of what is stored jumps, right before and behind.
fn line<F: DepthFormat>() -> Vec<f64> {
    let powers = (1..64).map(|e| libm::scalbn(1.0, -e));
    let jumps = powers.filter(|&v| F::spacing(0.75 * v) != F::spacing(v));
    // d = f (z − n) / (z (f − n)), solved for z.
    let place = |v: f64| {
        let d = if F::REVERSED { 1.0 - v } else { v };
        FAR * NEAR / (FAR - d * (FAR - NEAR))
    };
    let beside = |z: f64| [z * (1.0 - JUMP), z * (1.0 + JUMP)];
    let mut all: Vec<f64> = jumps.map(place).flat_map(beside).collect();
    all.retain(|&z| SHOWN.0 < z && z < SHOWN.1);
    all.extend(distances());
    all.sort_by(f64::total_cmp);
    all
}

/// From one shown to the other in equal ratios.
fn distances() -> impl Iterator<Item = f64> {
    let (from, to) = SHOWN;
    (0..=LAST).map(move |i| match i {
        // Not a digit beyond.
        LAST => to,
        i => from * libm::pow(to / from, i as f64 / LAST as f64),
    })
}

/// A name stands at the last point.
fn named_at_the_near_end(mut series: Series) -> Series {
    series.points.reverse();
    series
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> [Series; 4] {
        [
            series::<Depth16>("", 0),
            series::<Depth24>("", 0),
            series::<Depth32F>("", 0),
            series::<ReversedDepth32F>("", 0),
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
            series.line.retain(|(z, _)| distances().any(|at| at == *z));
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
