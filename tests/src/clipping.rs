//! What of a segment lies in a rectangle, and the area of a polygon, in exact numbers.

use ombra_math::glam::DVec2;

use crate::dyadic::{Dyadic, nearest_double};

/// A parameter t = `numerator` / `denominator`, the denominator positive.
#[derive(Clone, Debug)]
struct Parameter {
    numerator: Dyadic,
    denominator: Dyadic,
}

impl Parameter {
    fn whole(t: i64) -> Option<Self> {
        Some(Self {
            numerator: Dyadic::new(t as f64)?,
            denominator: Dyadic::power_of_two(0),
        })
    }

    fn exceeds(&self, other: &Self) -> bool {
        let left = &self.numerator * &other.denominator;
        left.compare(&(&other.numerator * &self.denominator))
            .is_gt()
    }

    /// a + t (b − a), to the nearest double.
    fn between(&self, a: &Dyadic, b: &Dyadic) -> Option<f64> {
        let numerator = &(a * &self.denominator) + &(&self.numerator * &(b - a));
        nearest_double(&numerator, &self.denominator)
    }
}

/// The part of the segment from `a` to `b` in the rectangle from `min` to `max`, by the four inequalities in t: ends
/// inside as they are, others to the nearest double. `None` if nothing is left, or a coordinate is not finite.
#[must_use]
pub fn of_segment([min, max]: [DVec2; 2], [a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    let exact = |p: DVec2| Some([Dyadic::new(p.x)?, Dyadic::new(p.y)?]);
    let (a, b, min, max) = (exact(a)?, exact(b)?, exact(min)?, exact(max)?);
    let (mut first, mut last) = (Parameter::whole(0)?, Parameter::whole(1)?);
    for k in 0..2 {
        let d = &b[k] - &a[k];
        if d.is_zero() {
            if a[k].compare(&min[k]).is_lt() || a[k].compare(&max[k]).is_gt() {
                return None;
            }
            continue;
        }
        let towards = |side: &Dyadic| {
            let distance = side - &a[k];
            let turned = d.sign().is_lt();
            Parameter {
                numerator: if turned { -&distance } else { distance },
                denominator: d.abs(),
            }
        };
        let (entry, exit) = if d.sign().is_lt() {
            (towards(&max[k]), towards(&min[k]))
        } else {
            (towards(&min[k]), towards(&max[k]))
        };
        if entry.exceeds(&first) {
            first = entry;
        }
        if last.exceeds(&exit) {
            last = exit;
        }
    }
    if first.exceeds(&last) {
        return None;
    }
    let point = |t: &Parameter| {
        Some(DVec2::new(
            t.between(&a[0], &b[0])?,
            t.between(&a[1], &b[1])?,
        ))
    };
    Some([point(&first)?, point(&last)?])
}

/// Twice the signed area of a polygon, positive counter-clockwise with y upwards; `None` if a coordinate is not
/// finite.
#[must_use]
pub fn doubled_area(polygon: &[DVec2]) -> Option<Dyadic> {
    let mut sum = Dyadic::zero();
    for (p, q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let cross =
            &(&Dyadic::new(p.x)? * &Dyadic::new(q.y)?) - &(&Dyadic::new(p.y)? * &Dyadic::new(q.x)?);
        sum = &sum + &cross;
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::{doubled_area, of_segment};
    use crate::dyadic::Dyadic;
    use ombra_math::glam::DVec2;

    #[test]
    fn by_hand() {
        let window = [DVec2::ZERO, DVec2::splat(10.0)];
        let segment = |ax, ay, bx, by| [DVec2::new(ax, ay), DVec2::new(bx, by)];
        let cases = [
            (
                segment(2.0, 14.0, 8.0, -4.0),
                Some(segment(10.0 / 3.0, 10.0, 20.0 / 3.0, 0.0)),
            ),
            (segment(4.0, 14.0, 14.0, 8.0), None),
            // Through a corner, and one least step beside it.
            (
                segment(-5.0, 5.0, 5.0, -5.0),
                Some(segment(0.0, 0.0, 0.0, 0.0)),
            ),
            (segment(-5.0, 5.0, 5.0, -5.0_f64.next_up()), None),
            (
                segment(3.0, 3.0, 3.0, 3.0),
                Some(segment(3.0, 3.0, 3.0, 3.0)),
            ),
            (segment(11.0, -1.0, 11.0, 20.0), None),
            (segment(f64::NAN, 1.0, 1.0, 1.0), None),
        ];
        for (given, inside) in cases {
            assert_eq!(of_segment(window, given), inside, "{given:?}");
        }
    }

    #[test]
    fn the_area_of_half_a_square() {
        let triangle = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)].map(DVec2::from);
        let area = doubled_area(&triangle).unwrap();
        assert!(area.compare(&Dyadic::new(16.0).unwrap()).is_eq());
        assert!(doubled_area(&[]).unwrap().is_zero());
    }
}
