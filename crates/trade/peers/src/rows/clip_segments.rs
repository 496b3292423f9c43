//! Segments clipped against a rectangle.

use line_clipping::cohen_sutherland::clip_line;
use lyon_geom::{Box2D, LineSegment, point};
use ombra_clip::{Segment, Window, cohen_sutherland, direct, liang_barsky};
use ombra_math::glam::DVec2;
use parry2d_f64::bounding_volume::Aabb;

use crate::measured::{Against, Goal, Measured, Shown};
use crate::race::{Race, Rounds, Scene};
use crate::random::SplitMix;

const SEGMENTS: usize = 1_000_000;
const WINDOW: Window = Window {
    min: DVec2::ZERO,
    max: DVec2::ONE,
};

type Lyon = LineSegment<f64>;
type Theirs = line_clipping::LineSegment;

/// What is kept, each crate in its own type; all but one are empty.
struct Kept {
    ours: Vec<Segment>,
    lyon: Vec<Lyon>,
    theirs: Vec<Theirs>,
}

impl Scene for Kept {
    fn clear(&mut self) {
        self.ours.clear();
        self.lyon.clear();
        self.theirs.clear();
    }

    fn shows(&self) -> Vec<Shown> {
        let lengths = (self.ours.iter().map(|s| s.a.distance(s.b)))
            .chain(self.lyon.iter().map(|s| s.length()))
            .chain((self.theirs.iter()).map(|s| (s.p2.x - s.p1.x).hypot(s.p2.y - s.p1.y)));
        let (mut kept, mut length) = (0, 0.0);
        for each in lengths {
            kept += 1;
            length += each;
        }
        vec![
            // Rounding may decide otherwise at a corner, on one of 10⁵.
            Shown {
                name: "kept",
                value: f64::from(kept),
                within: Some(1e-5),
            },
            Shown {
                name: "length",
                value: length,
                within: Some(1e-9),
            },
        ]
    }
}

/// `outside` per cent of the segments miss the window.
pub fn row(name: &str, outside: usize, rounds: Rounds) -> Measured {
    let segments = segments(outside);
    let lyon: Vec<Lyon> = segments.iter().map(|s| to_lyon(*s)).collect();
    let theirs: Vec<Theirs> = segments.iter().map(|s| to_theirs(*s)).collect();
    let (lyon_window, their_window) = (
        lyon_window(),
        line_clipping::Window::new(0.0, 1.0, 0.0, 1.0),
    );

    let kept = Kept {
        ours: Vec::with_capacity(SEGMENTS),
        lyon: Vec::with_capacity(SEGMENTS),
        theirs: Vec::with_capacity(SEGMENTS),
    };
    let goals = [Goal {
        at_least: 1.5,
        against: Against::FastestPeer,
    }];
    let work = format!("10⁶ segments against a rectangle, {outside} % of them outside");
    Race::new(name, work, SEGMENTS as f64, "segments", kept)
        .limit("memcpy", |kept: &mut Kept| {
            kept.ours.clear();
            kept.ours.extend_from_slice(&segments);
        })
        .peer("lyon_geom", |kept| {
            kept.lyon.clear();
            for segment in &lyon {
                if let Some(inside) = segment.clipped(&lyon_window) {
                    kept.lyon.push(inside);
                }
            }
        })
        .peer("line-clipping", |kept| {
            kept.theirs.clear();
            for &segment in &theirs {
                if let Some(inside) = clip_line(segment, their_window) {
                    kept.theirs.push(inside);
                }
            }
        })
        .ours("cohen_sutherland", &goals, |kept| {
            kept.ours.clear();
            for &segment in &segments {
                if let Some(inside) = cohen_sutherland::clip_segment(&WINDOW, segment) {
                    kept.ours.push(inside);
                }
            }
        })
        .ours("liang_barsky", &[], |kept| {
            kept.ours.clear();
            for &segment in &segments {
                if let Some(inside) = liang_barsky::clip_segment(&WINDOW, segment) {
                    kept.ours.push(inside);
                }
            }
        })
        .ours("direct", &[], |kept| {
            kept.ours.clear();
            for &segment in &segments {
                if let Some(inside) = direct::clip_segment(&WINDOW, segment) {
                    kept.ours.push(inside);
                }
            }
        })
        .note(parry2d(&segments))
        .run(rounds)
}

/// The share of segments that miss the window, by lyon_geom's word, spread evenly among the others.
fn segments(outside: usize) -> Vec<Segment> {
    let mut random = SplitMix(0xc11b);
    let mut segments = Vec::with_capacity(SEGMENTS);
    let window = lyon_window();
    // 37 has no factor in common with 100: each residue comes once in a hundred.
    while segments.len() < SEGMENTS {
        let mut end = || DVec2::new(random.real(-1.0, 2.0), random.real(-1.0, 2.0));
        let segment = Segment::new(end(), end());
        let is_outside = to_lyon(segment).clipped(&window).is_none();
        if is_outside == (segments.len() * 37 % 100 < outside) {
            segments.push(segment);
        }
    }
    segments
}

fn lyon_window() -> Box2D<f64> {
    Box2D::new(point(0.0, 0.0), point(1.0, 1.0))
}

fn to_lyon(s: Segment) -> Lyon {
    LineSegment {
        from: point(s.a.x, s.a.y),
        to: point(s.b.x, s.b.y),
    }
}

fn to_theirs(s: Segment) -> Theirs {
    let point = |p: DVec2| line_clipping::Point::new(p.x, p.y);
    line_clipping::LineSegment::new(point(s.a), point(s.b))
}

/// Why parry2d does not race.
fn parry2d(segments: &[Segment]) -> String {
    let vector = parry2d_f64::math::Vector::new;
    let window = Aabb::new(vector(0.0, 0.0), vector(1.0, 1.0));
    let wrong = (segments.iter())
        .filter(|s| {
            let kept = window.clip_segment(vector(s.a.x, s.a.y), vector(s.b.x, s.b.y));
            kept.is_some() != to_lyon(**s).clipped(&lyon_window()).is_some()
        })
        .count();
    let short = window.clip_segment(vector(-2.0, 0.5), vector(-1.0, 0.5));
    let short = short.map_or("nothing".to_owned(), |s| {
        format!("({}, {})→({}, {})", s.a.x, s.a.y, s.b.x, s.b.y)
    });
    format!(
        "not raced: parry2d, which decides otherwise than lyon_geom on {wrong} of the 10⁶ segments; \
         of (−2, 0.5)→(−1, 0.5), outside the unit square, it keeps {short}"
    )
}
