//! Study: triangles that share edges, their vertices snapped to fractions of a pixel.
//!
//! # What is asked
//!
//! A mesh of triangles, halves of cells of 8 × 8 pixels pulled out of shape, covers a whole picture and more. Every pixel
//! has one owner: the triangle in which its centre lies, on an edge by the top-left rule. With 16 sub-pixel bits vertices
//! stay where they are; with 12, 8, 4 and 0 they are moved to the nearest multiple of 2⁻¹², …, 1. No triangle turns
//! over, not even with 0 bits.
//!
//! | sweep | vertices | |
//! | --- | --- | --- |
//! | `bits` | multiples of 2⁻¹⁶ pixel | as a camera leaves them: hardly ever does an edge run through a centre |
//! | `halves` | multiples of ½ pixel | as drawings and menus have them: edges run through centres everywhere |
//!
//! # Error
//!
//! A pixel is wrong if it is drawn by anyone but the owner alone: by nobody (a gap), by several triangles (an overlap),
//! or by another one. Owners are found pixel by pixel in integers, with the vertices as they were given, at a centre
//! that is moved by (δ, δ²), δ → 0, and so never lies on an edge.
//!
//! # Techniques
//!
//! - `cover`: [`triangle::cover`](ombra_raster::triangle::cover), exact for any double. With 16 bits, where nothing
//!   needs to be snapped, it is the baseline. Its roundings are those of the snapping; what it works inside is not
//!   counted.
//! - `top-left`: edge functions in integers, stepped by additions through the bounding box, as graphics hardware does; the
//!   bits are what makes them fit. The rule takes 1 from the edge functions of edges that do not own their centres.
//! - `both inclusive`, `no rule`: the same without it. An edge owns its centres from both sides, or from neither.
//!
//! Snapping keeps shared vertices shared, so it makes no gap and no overlap, and only moves pixels from one triangle to its
//! neighbour.

mod advice;
mod fixed_point;
mod mesh;

use std::rc::Rc;

use ombra_math::work::{Count, Counter};
use ombra_raster::triangle::{EdgeRule, cover, snap};

use crate::case;
use crate::deviation::Measure;
use crate::study::{Case, Effort, Question, Shown, Study, Sweep, What};
use crate::triangle_subpixel::advice::advice;
use crate::triangle_subpixel::fixed_point::draw;
use crate::triangle_subpixel::mesh::{BITS, Mesh, Owners};

/// The study.
pub const STUDY: Study = Study {
    id: "triangle-subpixel",
    summary: "Triangles that share edges, snapped to sub-pixel bits",
    unit: "pixel",
    errors: &[Measure::Share("wrong pixels")],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "bits",
            what: What::Error(0),
        },
        Shown {
            sweep: "halves",
            what: What::Error(0),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

/// A mesh and the sub-pixel bits that its vertices get.
struct Snapped {
    mesh: Rc<Mesh>,
    bits: u32,
}

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let side = effort.choose(192, 512);
    let sweep = |name, vertex_bits| {
        let mesh = Rc::new(Mesh::new(side, vertex_bits));
        let cases = [BITS, 12, 8, 4, 0].into_iter().flat_map(|bits| {
            let mesh = Rc::clone(&mesh);
            cases(&Rc::new(Snapped { mesh, bits }))
        });
        let question = Question {
            inputs: format!(
                "{} triangles over {side}×{side} pixels",
                mesh.triangles.len()
            ),
            units: mesh.owners.len(),
            cases: cases.collect(),
        };
        Sweep {
            name,
            knob: "sub-pixel bits",
            questions: vec![question],
        }
    };
    vec![sweep("bits", BITS), sweep("halves", 1)]
}

fn cases(snapped: &Rc<Snapped>) -> Vec<Case> {
    let judge = |s: &Snapped, owners: &Owners| s.mesh.verdict(owners);
    let bits = f64::from(snapped.bits);
    vec![
        case!("cover", bits, snapped, |s, work| by_cover(s, work), judge),
        case!(
            "top-left",
            bits,
            snapped,
            |s, work| draw(&s.mesh, s.bits, EdgeRule::TopLeft, work),
            judge
        ),
        case!(
            "both inclusive",
            bits,
            snapped,
            |s, work| draw(&s.mesh, s.bits, EdgeRule::Closed, work),
            judge
        ),
        case!(
            "no rule",
            bits,
            snapped,
            |s, work| draw(&s.mesh, s.bits, EdgeRule::Open, work),
            judge
        ),
    ]
}

/// Exact spans of the snapped triangles.
fn by_cover(snapped: &Snapped, work: &mut impl Count) -> Owners {
    let (mesh, bits) = (&snapped.mesh, snapped.bits);
    let vertices: Vec<_> = if bits < BITS {
        work.add(Counter::Roundings, 2 * mesh.vertices.len() as u64);
        mesh.vertices.iter().map(|&v| snap(v, bits)).collect()
    } else {
        mesh.vertices.clone()
    };
    let mut owners = Owners::nobody(mesh.side);
    for (i, corners) in mesh.corners(&vertices) {
        // All vertices are finite.
        for span in cover(corners, mesh.side, mesh.side).into_iter().flatten() {
            work.add(Counter::Fragments, u64::from(span.len()));
            owners.draw(span.y, span.x, i);
        }
    }
    owners
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::lines;
    use crate::run::judged::{Judged, judged};

    fn faults(row: &Judged) -> [u64; 3] {
        ["gaps", "overlaps", "other owner"].map(|kind| {
            let fault = row.faults.iter().find(|(name, _)| *name == kind);
            fault.unwrap().1
        })
    }

    #[test]
    fn one_rule_leaves_no_gap_and_no_overlap() {
        let rows = judged(&STUDY);
        assert_eq!(rows.len(), 2 * 5 * 4);
        let pixels = 192 * 192;
        for row in &rows {
            let [gaps, overlaps, others] = faults(row);
            let (work, context) = (row.work, row.context());
            assert_eq!(row.deviation.asked, pixels, "{context}");
            assert_eq!(gaps + overlaps + others, row.deviation.wrong as u64);
            let fragments = pixels as u64 - gaps;
            match row.technique {
                "cover" | "top-left" => {
                    assert_eq!((gaps, overlaps), (0, 0), "{context}");
                    assert_eq!(work.fragments, fragments, "{context}");
                }
                "both inclusive" => {
                    assert_eq!(gaps, 0, "{context}");
                    assert!(work.fragments >= fragments + overlaps, "{context}");
                }
                _ => {
                    assert_eq!(overlaps, 0, "{context}");
                    assert_eq!(work.fragments, fragments, "{context}");
                }
            }
        }
    }

    #[test]
    fn bits_move_edges_and_rules_decide_on_them() {
        let (halves, rows): (Vec<_>, Vec<_>) = judged(&STUDY)
            .into_iter()
            .partition(|row| row.sweep == "halves");
        let find = |technique, bits: f64| {
            let mut rows = rows.iter();
            rows.find(|row| row.technique == technique && row.setting == bits)
                .unwrap()
        };
        // As given, nothing is wrong; `cover` and edge functions agree at any number of bits.
        for bits in [0.0, 4.0, 8.0, 12.0, 16.0] {
            let (cover, top_left) = (find("cover", bits), find("top-left", bits));
            assert_eq!(cover.deviation, top_left.deviation);
            assert_eq!(cover.faults, top_left.faults);
            let (wrong, context) = (cover.deviation.wrong, cover.context());
            assert!(
                if bits < 12.0 { wrong > 0 } else { wrong < 10 },
                "{context}"
            );
            assert!(bits < 16.0 || wrong == 0, "{context}");
            // Who is neither in nor out is what both rules disagree on.
            let (twice, never) = (find("both inclusive", bits), find("no rule", bits));
            assert_eq!(faults(twice)[1], faults(never)[0], "{bits}");
        }
        // An edge moves by half a unit at most, a quarter of one on average, and 16 times less with 4 bits more.
        let wrong = |bits| find("cover", bits).deviation.wrong as f64;
        assert!((8.0..32.0).contains(&(wrong(0.0) / wrong(4.0))));
        assert!((8.0..32.0).contains(&(wrong(4.0) / wrong(8.0))));
        assert!(faults(find("both inclusive", 4.0))[1] > 0);
        for row in halves.iter().filter(|row| row.setting >= 4.0) {
            // Halves stay where they are. Both ends of an edge on centres, or a slope of 1, are no rare thing.
            let (share, context) = (row.deviation.wrong_share(), row.context());
            match row.technique {
                "cover" | "top-left" => assert_eq!(share, 0.0, "{context}"),
                _ => assert!(share > 0.02, "{context}"),
            }
        }
    }

    #[test]
    fn the_study_says_what_a_bit_costs() {
        let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        let said = lines(&report.advice);
        let rule = "no gap, no overlap | top-left | any bits | ";
        assert!(
            said.iter().any(|line| line.starts_with(rule)
                && line.ends_with("| no pixel drawn twice or left out")),
            "{said:?}"
        );
        assert!(
            report
                .csv()
                .lines()
                .next()
                .unwrap()
                .contains(",gaps,overlaps,other owner,")
        );
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 2);
    }
}
