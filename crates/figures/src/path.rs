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

/// More lines than this are no hatching.
const MOST_HATCHES: f64 = 2000.0;
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

    /// Its lines, curves taken by their chords.
    pub fn chords(&self) -> Vec<(DVec2, DVec2)> {
        let mut chords = Vec::with_capacity(self.segments.len());
        let (mut start, mut last) = (DVec2::ZERO, DVec2::ZERO);
        for &segment in &self.segments {
            let to = match segment {
                Segment::Move(p) => {
                    (start, last) = (p, p);
                    continue;
                }
                Segment::Line(p) | Segment::Quad(_, p) | Segment::Cubic(_, _, p) => p,
                Segment::Close => start,
            };
            chords.push((last, to));
            last = to;
        }
        chords
    }

    /// The least rectangle around every point it names; none for an empty path.
    pub fn bounds(&self) -> Option<Rect> {
        let around = |p| Rect::new(p, p);
        self.points()
            .map(around)
            .reduce(|a, b| Rect::new(a.min.min(b.min), a.max.max(b.max)))
    }

    /// Slanted lines `distance` apart that fill a polygon; what overlaps an odd number of times is inside.
    pub fn hatching(polygon: &[DVec2], distance: f64) -> Path {
        // Along these lines x + y is constant; on each, places are told apart by x.
        let height = |p: DVec2| p.x + p.y;
        let heights = polygon.iter().map(|&p| height(p));
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| {
            (low.min(h), high.max(h))
        });
        let step = distance * core::f64::consts::SQRT_2;
        let (first, last) = ((low / step).ceil(), (high / step).floor());
        let mut path = Path::new();
        if !(step > 0.0 && last - first < MOST_HATCHES) {
            return path;
        }
        let count = (last - first).max(-1.0) as u32;
        for i in 0..=count {
            let level = (first + f64::from(i)) * step;
            let ends = polygon.iter().cycle().skip(1);
            let mut crossings: Vec<DVec2> = Vec::new();
            for (&a, &b) in polygon.iter().zip(ends) {
                let (from, to) = (height(a) - level, height(b) - level);
                // An end on the line counts with one of its two edges only.
                if (from < 0.0) != (to < 0.0) {
                    crossings.push(a + (b - a) * (from / (from - to)));
                }
            }
            crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
            for pair in crossings.as_chunks::<2>().0 {
                path.add_polyline(pair);
            }
        }
        path
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
        self.cut(a, b).map_or(0.0, |(a, b)| a.distance(b))
    }

    /// The part of a−b that lies within; none for less than a line.
    pub fn cut(&self, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
        let d = b - a;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (start, step, low, high) in [
            (a.x, d.x, self.min.x, self.max.x),
            (a.y, d.y, self.min.y, self.max.y),
        ] {
            if step == 0.0 {
                if start < low || start > high {
                    return None;
                }
            } else {
                let (enter, leave) = ((low - start) / step, (high - start) / step);
                from = from.max(enter.min(leave));
                to = to.min(enter.max(leave));
            }
        }
        (to > from).then(|| (a + d * from, a + d * to))
    }
}

/// To hundredths, with −0 and what is not finite made 0.
pub fn round(p: DVec2) -> DVec2 {
    DVec2::new(round_length(p.x), round_length(p.y))
}

/// To hundredths, with −0 and what is not finite made 0.
pub fn round_length(length: f64) -> f64 {
    let rounded = (length * 100.0).round() / 100.0;
    if rounded.is_finite() {
        rounded + 0.0
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hatching_stays_inside_and_its_density_is_the_distance() {
        let square = [(0.0, 0.0), (300.0, 0.0), (300.0, 300.0), (0.0, 300.0)];
        let square = square.map(|(x, y)| DVec2::new(x, y));
        let lines = Path::hatching(&square, 10.0).chords();
        let bounds = Path::polygon(&square).bounds().unwrap().grown(1e-9);
        assert!(
            lines
                .iter()
                .all(|&(a, b)| bounds.contains(&Rect::new(a.min(b), a.max(b))))
        );
        // Lines 10 apart cover an area A with a length of A / 10, but for the corners.
        let length: f64 = lines.iter().map(|(a, b)| a.distance(*b)).sum();
        assert!((length - 9000.0).abs() < 0.02 * 9000.0, "{length}");
    }

    #[test]
    fn a_line_is_cut_at_the_rectangle() {
        let at = DVec2::new;
        let rect = Rect::new(at(0.0, 0.0), at(10.0, 5.0));
        assert_eq!(
            rect.cut(at(-5.0, 1.0), at(15.0, 1.0)),
            Some((at(0.0, 1.0), at(10.0, 1.0)))
        );
        assert_eq!(
            rect.cut(at(1.0, 1.0), at(3.0, 4.0)),
            Some((at(1.0, 1.0), at(3.0, 4.0)))
        );
        assert_eq!(rect.cut(at(-5.0, 6.0), at(15.0, 6.0)), None);
        assert_eq!(rect.cut(at(-2.0, 4.0), at(4.0, 10.0)), None);
        assert_eq!(rect.length_within(at(5.0, -8.0), at(5.0, 8.0)), 5.0);
        assert_eq!(rect.cut(at(f64::NAN, 0.0), at(1.0, f64::INFINITY)), None);
    }

    #[test]
    fn hatching_leaves_a_notch_free() {
        let m = [
            (0.0, 0.0),
            (100.0, 90.0),
            (200.0, 0.0),
            (200.0, 100.0),
            (0.0, 100.0),
        ];
        let m = m.map(|(x, y)| DVec2::new(x, y));
        for (a, b) in Path::hatching(&m, 7.0).chords() {
            let middle = (a + b) * 0.5;
            assert!(
                middle.y > 90.0 - 0.9 * (middle.x - 100.0).abs() - 1e-9,
                "{middle}"
            );
        }
    }

    #[test]
    fn nonsense_gives_no_hatching() {
        for wrong in [f64::NAN, f64::INFINITY, 1e300] {
            let polygon = [DVec2::ZERO, DVec2::X * wrong, DVec2::Y];
            assert_eq!(Path::hatching(&polygon, 5.0), Path::new(), "{wrong}");
        }
        assert_eq!(Path::hatching(&[], 5.0), Path::new());
        assert_eq!(
            Path::hatching(&[DVec2::ZERO, DVec2::X, DVec2::Y], 0.0),
            Path::new()
        );
    }
}
