//! Polygons of 10⁵ vertices clipped against a rectangle.

use std::f64::consts::TAU;

use clipper2_rust::{Path64, Paths64, Point64, Rect64, rect_clip_64};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use line_clipping::sutherland_hodgman;
use ombra_clip::{Window, pieces};
use ombra_math::glam::DVec2;

use crate::measured::{Against, Goal, Measured, Shown};
use crate::race::{Race, Rounds, Scene};

const VERTICES: usize = 100_000;
const WINDOW: Window = Window {
    min: DVec2::ZERO,
    max: DVec2::ONE,
};
/// clipper2-rust clips integers; this many stand for 1.
const SCALE: f64 = (1_u64 << 40) as f64;

pub struct Polygon {
    name: &'static str,
    points: Vec<DVec2>,
}

/// Goes in and out at long intervals, 80 times.
pub fn wave() -> Polygon {
    Polygon {
        name: "wavy polygon, few crossings, one piece",
        points: around(|_, angle| 0.6 + 0.2 * (20.0 * angle).sin()),
    }
}

/// Every edge crosses the border.
pub fn star() -> Polygon {
    Polygon {
        name: "star, every edge crosses, one piece",
        points: around(|i, _| if i % 2 == 0 { 0.9 } else { 0.3 }),
    }
}

/// Teeth that hang into the window from above: each a piece.
pub fn comb() -> Polygon {
    let teeth = VERTICES / 4;
    let tooth = |i: usize| {
        let [left, right] = [0.0, 0.5].map(|part| (i as f64 + part) / teeth as f64);
        [(left, 1.5), (left, 0.5), (right, 0.5), (right, 1.5)]
    };
    let back = [(1.0, 2.0), (0.0, 2.0)];
    Polygon {
        name: "comb, half of all edges cross, 25 000 pieces",
        points: (0..teeth)
            .flat_map(tooth)
            .chain(back)
            .map(DVec2::from)
            .collect(),
    }
}

fn around(radius: impl Fn(usize, f64) -> f64) -> Vec<DVec2> {
    (0..VERTICES)
        .map(|i| {
            let angle = TAU * i as f64 / VERTICES as f64;
            DVec2::splat(0.5) + radius(i, angle) * DVec2::from_angle(angle)
        })
        .collect()
}

/// What is left, each crate in its own type; all but one are empty.
#[derive(Default)]
struct Left {
    ours: Vec<Vec<DVec2>>,
    line_clipping: Vec<line_clipping::Point>,
    clipper: Paths64,
    overlay: Vec<Vec<Vec<[f64; 2]>>>,
}

impl Scene for Left {
    fn clear(&mut self) {
        *self = Self::default();
    }

    fn shows(&self) -> Vec<Shown> {
        let mut contours = self.ours.clone();
        contours.push(
            self.line_clipping
                .iter()
                .map(|p| DVec2::new(p.x, p.y))
                .collect(),
        );
        contours.extend((self.clipper.iter()).map(|path| {
            let point = |p: &Point64| DVec2::new(p.x as f64, p.y as f64) / SCALE;
            path.iter().map(point).collect()
        }));
        contours
            .extend((self.overlay.iter().flatten()).map(|c| c.iter().map(|&p| p.into()).collect()));
        contours.retain(|contour| !contour.is_empty());
        let vertices: usize = contours.iter().map(Vec::len).sum();
        // Signed: holes are subtracted.
        let area: f64 = contours.iter().map(|contour| area(contour)).sum();
        vec![
            Shown {
                name: "area",
                value: area.abs(),
                within: Some(1e-6),
            },
            Shown {
                name: "pieces",
                value: contours.len() as f64,
                within: None,
            },
            Shown {
                name: "vertices",
                value: vertices as f64,
                within: None,
            },
        ]
    }
}

fn area(contour: &[DVec2]) -> f64 {
    let next = contour.iter().cycle().skip(1);
    let centre = DVec2::splat(0.5);
    let doubled: f64 = contour
        .iter()
        .zip(next)
        .map(|(&p, &q)| (p - centre).perp_dot(q - centre))
        .sum();
    doubled / 2.0
}

pub fn row(name: &str, polygon: Polygon, rounds: Rounds) -> Measured {
    let Polygon {
        name: shape,
        points,
    } = polygon;
    let theirs = line_clipping::Polygon::from(
        (points.iter().map(|p| line_clipping::Point::new(p.x, p.y))).collect::<Vec<_>>(),
    );
    let their_window = line_clipping::Window::new(0.0, 1.0, 0.0, 1.0);
    let scaled = |v: f64| (v * SCALE).round() as i64;
    let path: Path64 = points
        .iter()
        .map(|p| Point64::new(scaled(p.x), scaled(p.y)))
        .collect();
    let paths = vec![path];
    let rectangle = Rect64::new(0, 0, scaled(1.0), scaled(1.0));
    let subject: Vec<[f64; 2]> = points.iter().map(|&p| p.into()).collect();
    let clip = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    let work = format!("{} vertices against a rectangle: {shape}", points.len());
    let goals = [Goal {
        at_least: 1.5,
        against: Against::FastestPeer,
    }];
    let goals_of_pieces = [Goal {
        at_least: 1.0,
        against: Against::Peer("clipper2-rust rect_clip"),
    }];
    Race::new(name, work, points.len() as f64, "vertices", Left::default())
        .limit("memcpy", |left: &mut Left| left.ours = vec![points.clone()])
        .peer("line-clipping", |left| {
            left.line_clipping = sutherland_hodgman::clip_polygon(&theirs, their_window).vertices;
        })
        .peer("clipper2-rust rect_clip", |left| {
            left.clipper = rect_clip_64(&rectangle, &paths)
        })
        .peer("i_overlay", |left| {
            left.overlay = subject.overlay(&clip, OverlayRule::Intersect, FillRule::EvenOdd);
        })
        .ours("sutherland_hodgman", &goals, |left| {
            left.ours = vec![ombra_clip::sutherland_hodgman::clip_polygon(
                &WINDOW, &points,
            )];
        })
        .ours("pieces", &goals_of_pieces, |left| {
            left.ours = pieces::clip_polygon(&WINDOW, &points)
        })
        .run(rounds)
}
