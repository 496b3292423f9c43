//! What of a segment lies in a rectangle, in a box, in the view volume; what of a polygon lies in the view volume; areas:
//! in exact numbers.

use ombra_math::glam::{DVec2, DVec3, DVec4};

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

/// The part of a segment on which all of `sides`, linear from the first value to the second, are not negative.
fn part(sides: &[[Dyadic; 2]]) -> Option<[Parameter; 2]> {
    let (mut first, mut last) = (Parameter::whole(0)?, Parameter::whole(1)?);
    for [s, e] in sides {
        let difference = s - e;
        if difference.is_zero() {
            if s.sign().is_lt() {
                return None;
            }
            continue;
        }
        let falls = difference.sign().is_gt();
        let zero = Parameter {
            numerator: if falls { s.clone() } else { -s },
            denominator: difference.abs(),
        };
        if falls && last.exceeds(&zero) {
            last = zero;
        } else if !falls && zero.exceeds(&first) {
            first = zero;
        }
    }
    (!first.exceeds(&last)).then_some([first, last])
}

/// The part of the segment from `a` to `b` in the box from `min` to `max`, by six inequalities in t: as [`of_segment`].
#[must_use]
pub fn in_box([min, max]: [DVec3; 2], [a, b]: [DVec3; 2]) -> Option<[DVec3; 2]> {
    let mut sides = Vec::new();
    for k in 0..3 {
        let [a, b, min, max] = [a[k], b[k], min[k], max[k]].map(Dyadic::new);
        let (a, b, min, max) = (a?, b?, min?, max?);
        sides.push([&a - &min, &b - &min]);
        sides.push([&max - &a, &max - &b]);
    }
    let [first, last] = part(&sides)?;
    let point = |t: &Parameter| -> Option<DVec3> {
        let at = |k: usize| t.between(&Dyadic::new(a[k])?, &Dyadic::new(b[k])?);
        Some(DVec3::new(at(0)?, at(1)?, at(2)?))
    };
    Some([point(&first)?, point(&last)?])
}

/// w and a coordinate, of which the sum or the difference is not negative in the view volume: `axis` 0 to 2, the sign of
/// the coordinate.
pub type ViewSide = (usize, f64);

/// The six sides of the view volume −w ≤ x, y, z ≤ w.
pub const VIEW_SIDES: [ViewSide; 6] = [
    (0, 1.0),
    (0, -1.0),
    (1, 1.0),
    (1, -1.0),
    (2, 1.0),
    (2, -1.0),
];

/// w ± the coordinate; `None` if one is not finite.
fn view_side(p: DVec4, (axis, sign): ViewSide) -> Option<Dyadic> {
    Some(&Dyadic::new(p.w)? + &Dyadic::new(sign * p[axis])?)
}

/// The part of the homogeneous segment (1 − t) a + t b in the view volume, to the nearest doubles. Of (0, 0, 0, 0), which
/// is no point, only the other end is left, be it 0 by rounding; `None` if nothing is, or an end is no point or not finite.
#[must_use]
pub fn in_view_volume([a, b]: [DVec4; 2]) -> Option<[DVec4; 2]> {
    if a == DVec4::ZERO || b == DVec4::ZERO {
        return None;
    }
    let sides: Option<Vec<_>> = (VIEW_SIDES.iter())
        .map(|&side| Some([view_side(a, side)?, view_side(b, side)?]))
        .collect();
    let [first, last] = part(&sides?)?;
    let exact = |k: usize| Some([Dyadic::new(a[k])?, Dyadic::new(b[k])?]);
    let point = |t: &Parameter| -> Option<DVec4> {
        let at = |k: usize| exact(k).and_then(|[a, b]| t.between(&a, &b));
        Some(DVec4::new(at(0)?, at(1)?, at(2)?, at(3)?))
    };
    let (c, d) = (point(&first)?, point(&last)?);
    match [c, d].map(|p| p == DVec4::ZERO) {
        [false, false] => Some([c, d]),
        [true, false] => Some([d, d]),
        [false, true] => Some([c, c]),
        [true, true] => None,
    }
}

/// What of a polygon, `N` numbers a corner of which the first four are x, y, z, w, lies in the view volume, side after
/// side: a corner where an edge crosses a side is made of the nearest doubles to the crossing of that edge.
#[must_use]
pub fn polygon_in_view_volume<const N: usize>(
    polygon: &[[f64; N]],
    sides: &[ViewSide],
) -> Option<Vec<[f64; N]>> {
    let mut corners = polygon.to_vec();
    for &side in sides {
        let position = |c: &[f64; N]| match c.as_slice() {
            [x, y, z, w, ..] => Some(DVec4::new(*x, *y, *z, *w)),
            _ => None,
        };
        let values: Option<Vec<_>> = (corners.iter())
            .map(|c| view_side(position(c)?, side))
            .collect();
        let values = values?;
        let any = |order: fn(core::cmp::Ordering) -> bool| values.iter().any(|s| order(s.sign()));
        if !any(core::cmp::Ordering::is_lt) {
            continue;
        }
        if !any(core::cmp::Ordering::is_gt) {
            return Some(Vec::new());
        }
        let mut kept = Vec::new();
        let before = values.len() - 1..values.len();
        let before = before.chain(0..values.len() - 1);
        for (i, j) in before.zip(0..) {
            let (Some(s), Some(e), Some(a), Some(b)) =
                (values.get(i), values.get(j), corners.get(i), corners.get(j))
            else {
                continue;
            };
            if s.sign() != e.sign() && !s.is_zero() && !e.is_zero() {
                let t = Parameter {
                    numerator: s.abs(),
                    denominator: (s - e).abs(),
                };
                let mut corner = *a;
                for (x, (a, b)) in corner.iter_mut().zip(a.iter().zip(b)) {
                    *x = t.between(&Dyadic::new(*a)?, &Dyadic::new(*b)?)?;
                }
                kept.push(corner);
            }
            if !e.sign().is_lt() {
                kept.push(*b);
            }
        }
        kept.dedup();
        while kept.len() > 1 && kept.first() == kept.last() {
            kept.pop();
        }
        corners = kept;
    }
    corners.retain(|c| c.iter().take(4).any(|&x| x != 0.0));
    Some(if corners.len() < 3 {
        Vec::new()
    } else {
        corners
    })
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
    use super::{
        VIEW_SIDES, doubled_area, in_box, in_view_volume, of_segment, polygon_in_view_volume,
    };
    use crate::dyadic::Dyadic;
    use ombra_math::glam::{DVec2, DVec3, DVec4};

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
    fn in_space_by_hand() {
        let p = DVec3::new;
        let cube = [DVec3::ZERO, DVec3::splat(10.0)];
        let clipped = Some([p(10.0 / 3.0, 10.0, 5.0), p(20.0 / 3.0, 0.0, 5.0)]);
        assert_eq!(
            in_box(cube, [p(2.0, 14.0, 5.0), p(8.0, -4.0, 5.0)]),
            clipped
        );
        assert_eq!(in_box(cube, [p(4.0, 14.0, 5.0), p(14.0, 8.0, 5.0)]), None);
        assert_eq!(in_box(cube, [p(5.0, 5.0, 11.0); 2]), None);
        let corner = [DVec3::splat(10.0); 2];
        assert_eq!(
            in_box(cube, [p(5.0, 15.0, 10.0), p(15.0, 5.0, 10.0)]),
            Some(corner)
        );
        assert_eq!(
            in_box(cube, [p(5.0, 15.0, 10.0), p(15.0, 5.0_f64.next_up(), 10.0)]),
            None
        );

        let v = DVec4::new;
        let (a, b) = (v(0.0, 0.0, 1.0, 2.0), v(0.0, 4.0, -4.0, -2.0));
        // On y = w after a quarter of the way.
        assert_eq!(in_view_volume([a, b]), Some([a, v(0.0, 1.0, -0.25, 1.0)]));
        assert_eq!(in_view_volume([DVec4::W, -DVec4::W]), Some([DVec4::W; 2]));
        assert_eq!(in_view_volume([-DVec4::W; 2]), None);
        assert_eq!(in_view_volume([DVec4::W, DVec4::ZERO]), None);

        // Half a square, its corner behind the eye cut off a quarter of the way along both edges.
        let triangle = [
            [-1.0, 0.0, 0.0, 2.0],
            [1.0, 0.0, 0.0, 2.0],
            [0.0, 0.0, -4.0, -2.0],
        ];
        let front = [
            [-0.75, 0.0, -1.0, 1.0],
            [-1.0, 0.0, 0.0, 2.0],
            [1.0, 0.0, 0.0, 2.0],
            [0.75, 0.0, -1.0, 1.0],
        ];
        assert_eq!(
            polygon_in_view_volume(&triangle, &VIEW_SIDES).unwrap(),
            front
        );
        assert!(polygon_in_view_volume(&[[f64::NAN; 4]; 3], &VIEW_SIDES).is_none());
    }

    #[test]
    fn the_area_of_half_a_square() {
        let triangle = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)].map(DVec2::from);
        let area = doubled_area(&triangle).unwrap();
        assert!(area.compare(&Dyadic::new(16.0).unwrap()).is_eq());
        assert!(doubled_area(&[]).unwrap().is_zero());
    }
}
