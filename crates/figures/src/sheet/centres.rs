//! The centre points of a grid of pixels, left out below labels: a part of a point would look like a letter's.

use ombra_math::glam::{DVec2, UVec2};

use crate::colour::Role;
use crate::drawing::{Item, Pen};
use crate::path::{Path, Rect};

/// Points in rows and columns.
#[derive(Clone, Copy, Debug)]
pub struct Centres {
    /// The upper left one.
    pub first: DVec2,
    /// From one to the next.
    pub step: f64,
    /// How many to the right and down.
    pub count: UVec2,
    /// How wide each is.
    pub width: f64,
}

impl Centres {
    /// A row of points is a dotted line, begun anew behind each that a label covers.
    pub(super) fn item(&self, labels: &[Rect]) -> Item {
        let mut path = Path::new();
        for row in 0..self.count.y {
            let mut from = None;
            for column in 0..self.count.x {
                let at = self.first + self.step * DVec2::new(f64::from(column), f64::from(row));
                let around = Rect::new(at, at).grown(0.5 * self.width);
                let covered = labels.iter().any(|label| label.meets(&around));
                let last = column + 1 == self.count.x;
                if !covered {
                    from = from.or(Some(at));
                }
                // The line ends behind its last point and before the next would come.
                let to = if covered {
                    at - DVec2::new(0.8 * self.step, 0.0)
                } else {
                    at + DVec2::new(0.2 * self.step, 0.0)
                };
                if (covered || last)
                    && let Some(from) = from.take()
                {
                    path.add_polyline(&[from, to]);
                }
            }
        }
        let pen = Pen {
            dash: Some((0.01, self.step - 0.01)),
            ..Pen::new(Role::Note, self.width)
        };
        Item::Shape {
            path,
            fill: None,
            stroke: Some(pen),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sheet::{Align, Sheet};
    use crate::style::Style;

    /// The points that the dotted lines of an item make.
    fn points(item: &Item) -> Vec<DVec2> {
        let Item::Shape {
            path,
            stroke: Some(pen),
            ..
        } = item
        else {
            panic!("{item:?}");
        };
        let (dash, gap) = pen.dash.unwrap();
        let of_line = |(from, to): (DVec2, DVec2)| {
            let count = ((to - from).x / (dash + gap)).floor() as u32 + 1;
            (0..count).map(move |i| from + DVec2::new(f64::from(i) * (dash + gap), 0.0))
        };
        path.chords().into_iter().flat_map(of_line).collect()
    }

    #[test]
    fn points_below_labels_are_left_out_and_no_others() {
        let centres = Centres {
            first: DVec2::new(200.0, 300.0),
            step: 80.0,
            count: UVec2::new(4, 3),
            width: 6.0,
        };
        let at =
            |x: u32, y: u32| centres.first + centres.step * DVec2::new(f64::from(x), f64::from(y));
        // The first of a row, one within, the last; and all of a row.
        for covered in [
            vec![],
            vec![(0, 1)],
            vec![(2, 0), (1, 2)],
            vec![(3, 1)],
            vec![(0, 2), (1, 2), (2, 2), (3, 2)],
        ] {
            let mut sheet = Sheet::new(&Style::default(), "").unwrap();
            sheet.centres(centres);
            for &(x, y) in &covered {
                let text = sheet.text(at(x, y), Align::Centre, "*A*", 40.0, Role::Text);
                assert!(text.is_ok());
            }
            let drawing = sheet.finish("a/b", "").unwrap();
            let found = points(&drawing.items[0]);
            let all = (0..3).flat_map(|y| (0..4).map(move |x| (x, y)));
            let left: Vec<_> = all.filter(|p| !covered.contains(p)).collect();
            assert_eq!(found.len(), left.len(), "{covered:?}");
            for ((x, y), point) in left.into_iter().zip(found) {
                // Lengths are hundredths.
                assert!((point - at(x, y)).length() < 0.03, "{covered:?} {point}");
            }
        }
    }
}
