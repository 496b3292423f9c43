//! Outlines on the canvas, and the few shapes that figures are made of.

use ombra_math::glam::DVec2;

/// One step of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Starts a contour.
    Move(DVec2),
    /// A straight line.
    Line(DVec2),
    /// A quadratic curve: control point, end.
    Quad(DVec2, DVec2),
    /// A cubic curve: two control points, end.
    Cubic(DVec2, DVec2, DVec2),
    /// Back to the contour's start.
    Close,
}

/// Contours of lines and curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Its steps, in order.
    pub segments: Vec<Segment>,
}

/// Control distance of a quarter circle of radius 1: 4 (√2 − 1) / 3.
const QUARTER: f64 = 0.552_284_749_830_793_4;

impl Path {
    /// Nothing yet.
    pub fn new() -> Path {
        Path::default()
    }

    /// Straight lines through `points`.
    pub fn polyline(points: &[DVec2]) -> Path {
        let mut path = Path::new();
        path.add_polyline(points);
        path
    }

    /// A closed contour through `points`.
    pub fn polygon(points: &[DVec2]) -> Path {
        let mut path = Path::new();
        path.add_polygon(points);
        path
    }

    /// A line from `a` to `b`.
    pub fn line(a: DVec2, b: DVec2) -> Path {
        Path::polyline(&[a, b])
    }

    /// A circle.
    pub fn circle(centre: DVec2, radius: f64) -> Path {
        Path::ellipse(centre, DVec2::splat(radius))
    }

    /// An ellipse along the axes.
    pub fn ellipse(centre: DVec2, radii: DVec2) -> Path {
        let at = |x: f64, y: f64| centre + radii * DVec2::new(x, y);
        let mut path = Path::new();
        path.segments.push(Segment::Move(at(1.0, 0.0)));
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
            // A quarter turn takes (x, y) to (−y, x).
            path.segments.push(Segment::Cubic(
                at(x - y * QUARTER, y + x * QUARTER),
                at(-y + x * QUARTER, x + y * QUARTER),
                at(-y, x),
            ));
        }
        path.segments.push(Segment::Close);
        path
    }

    /// A rectangle with round corners.
    pub fn rounded(min: DVec2, max: DVec2, radius: f64) -> Path {
        let (r, k) = (radius, radius * (1.0 - QUARTER));
        let (a, b) = (min, max);
        let at = DVec2::new;
        Path {
            segments: vec![
                Segment::Move(at(a.x + r, a.y)),
                Segment::Line(at(b.x - r, a.y)),
                Segment::Cubic(at(b.x - k, a.y), at(b.x, a.y + k), at(b.x, a.y + r)),
                Segment::Line(at(b.x, b.y - r)),
                Segment::Cubic(at(b.x, b.y - k), at(b.x - k, b.y), at(b.x - r, b.y)),
                Segment::Line(at(a.x + r, b.y)),
                Segment::Cubic(at(a.x + k, b.y), at(a.x, b.y - k), at(a.x, b.y - r)),
                Segment::Line(at(a.x, a.y + r)),
                Segment::Cubic(at(a.x, a.y + k), at(a.x + k, a.y), at(a.x + r, a.y)),
                Segment::Close,
            ],
        }
    }

    /// Appends a closed contour.
    pub fn add_polygon(&mut self, points: &[DVec2]) {
        self.add_polyline(points);
        if !points.is_empty() {
            self.segments.push(Segment::Close);
        }
    }

    /// Appends an open contour.
    pub fn add_polyline(&mut self, points: &[DVec2]) {
        for (i, &point) in points.iter().enumerate() {
            self.segments.push(if i == 0 {
                Segment::Move(point)
            } else {
                Segment::Line(point)
            });
        }
    }

    /// Every point put through `map`.
    pub fn map(&self, mut map: impl FnMut(DVec2) -> DVec2) -> Path {
        let segments = self
            .segments
            .iter()
            .map(|&segment| match segment {
                Segment::Move(p) => Segment::Move(map(p)),
                Segment::Line(p) => Segment::Line(map(p)),
                Segment::Quad(c, p) => Segment::Quad(map(c), map(p)),
                Segment::Cubic(c, d, p) => Segment::Cubic(map(c), map(d), map(p)),
                Segment::Close => Segment::Close,
            })
            .collect();
        Path { segments }
    }

    /// Every point it names, control points included.
    pub fn points(&self) -> impl Iterator<Item = DVec2> {
        self.segments.iter().flat_map(|&segment| {
            let (n, points) = match segment {
                Segment::Move(p) | Segment::Line(p) => (1, [p; 3]),
                Segment::Quad(c, p) => (2, [c, p, p]),
                Segment::Cubic(c, d, p) => (3, [c, d, p]),
                Segment::Close => (0, [DVec2::ZERO; 3]),
            };
            points.into_iter().take(n)
        })
    }
}

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Upper left corner.
    pub min: DVec2,
    /// Lower right corner.
    pub max: DVec2,
}

impl Rect {
    /// From two opposite corners in order.
    pub const fn new(min: DVec2, max: DVec2) -> Rect {
        Rect { min, max }
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// Its middle.
    pub fn centre(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Larger by `by` on every side.
    pub fn grown(&self, by: f64) -> Rect {
        Rect::new(self.min - DVec2::splat(by), self.max + DVec2::splat(by))
    }

    /// Whether the two share more than a border.
    pub fn meets(&self, other: &Rect) -> bool {
        self.min.cmplt(other.max).all() && other.min.cmplt(self.max).all()
    }

    /// Whether `other` lies within.
    pub fn contains(&self, other: &Rect) -> bool {
        self.min.cmple(other.min).all() && self.max.cmpge(other.max).all()
    }

    /// Length of the part of a−b that lies within.
    pub fn length_within(&self, a: DVec2, b: DVec2) -> f64 {
        let d = b - a;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (start, step, low, high) in [
            (a.x, d.x, self.min.x, self.max.x),
            (a.y, d.y, self.min.y, self.max.y),
        ] {
            if step == 0.0 {
                if start < low || start > high {
                    return 0.0;
                }
            } else {
                let (enter, leave) = ((low - start) / step, (high - start) / step);
                from = from.max(enter.min(leave));
                to = to.min(enter.max(leave));
            }
        }
        if to > from {
            d.length() * (to - from)
        } else {
            0.0
        }
    }
}
