//! The Pareto front of a chart: the points that nothing beats in both directions, as a staircase.

use ombra_math::glam::DVec2;

use super::Chart;
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::marks::DOT;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::text::NOTE;

/// A point of the front with its name.
pub(super) type Named = (String, (f64, f64));

impl Chart {
    /// The front from the cheapest on.
    pub(super) fn front(&self) -> Vec<Named> {
        let mut front = self.pareto.clone().unwrap_or_default();
        front.sort_by(|a, b| a.1.0.total_cmp(&b.1.0).then(b.1.1.total_cmp(&a.1.1)));
        front
    }
}

/// The staircase, broad and pale, for curves to lie above.
pub(super) fn draw_steps(sheet: &mut Sheet, steps: &[DVec2]) {
    let corners = steps
        .iter()
        .zip(steps.iter().skip(1))
        .flat_map(|(a, b)| [*a, DVec2::new(b.x, a.y)]);
    let mut staircase: Vec<DVec2> = corners.collect();
    staircase.extend(steps.last());
    let pen = Pen::new(Ink::of(Role::Chosen).tint(0.5), EMPHASIS);
    sheet.stroke(Path::polyline(&staircase), pen);
}

/// A ring around each point and its name.
///
/// A name that finds no place in `area` is left out: the list of names says what is lost at each point.
pub(super) fn name_points(sheet: &mut Sheet, front: &[Named], steps: &[DVec2], area: Rect) {
    for ((name, _), &at) in front.iter().zip(steps) {
        sheet.stroke(Path::circle(at, 1.9 * DOT), Pen::new(Role::Chosen, NORMAL));
        let label = Label::new(at, name.as_str()).reach(1.9 * DOT).size(NOTE);
        if !name.is_empty() {
            let label = label.within(area).optional();
            sheet.label(label.towards(DVec2::new(-1.0, 1.0)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::{Axis, Scale, Series};
    use crate::drawing::Item;
    use crate::style::Style;

    #[test]
    fn the_front_is_a_staircase_from_the_cheapest_on() {
        let named = |name: &str, at| (name.to_owned(), at);
        let chart = Chart {
            id: "trade/test".to_owned(),
            title: "Test".to_owned(),
            x: Axis::new("cost", "ns", Scale::Linear),
            y: Axis::new("error", "", Scale::Linear),
            series: vec![Series::new(
                "curve",
                vec![(1.0, 9.0), (3.0, 3.0), (5.0, 1.0)],
            )],
            pareto: Some(vec![
                named("c", (5.0, 1.0)),
                named("a", (1.0, 9.0)),
                named("b", (3.0, 3.0)),
            ]),
            settings: String::new(),
        };
        let drawing = chart.draw(&Style::default()).unwrap();
        let front = drawing.items.iter().find_map(|item| match item {
            Item::Shape {
                path,
                stroke: Some(pen),
                ..
            } if pen.width == EMPHASIS => Some(path.clone()),
            _ => None,
        });
        let points: Vec<DVec2> = front.unwrap().points().collect();
        assert_eq!(points.len(), 5);
        for pair in points.windows(2) {
            let step = pair[1] - pair[0];
            assert!(
                (step.x > 0.0 && step.y == 0.0) || (step.x == 0.0 && step.y > 0.0),
                "{step}"
            );
        }
        for name in ["a", "b", "c"] {
            assert!(drawing.labels.iter().any(|label| label.text == name));
        }
    }
}
