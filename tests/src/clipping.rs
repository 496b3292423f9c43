//! What of a segment lies in a rectangle, in a box, in the view volume; what of a polygon lies in the view volume; areas:
//! in exact numbers.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_oracle::Exact;
use ombra_oracle::interval::{between, not_negative};
use ombra_oracle::vector::{self, exact, minus};

/// The part of the segment from `a` to `b` in the rectangle from `min` to `max`, by the four inequalities in t: ends
/// inside as they are, others to the nearest double. `None` if nothing is left, or a coordinate is not finite.
#[must_use]
pub fn of_segment([min, max]: [DVec2; 2], [a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    let ends = in_range([exact(min)?, exact(max)?], [exact(a)?, exact(b)?])?;
    Some(ends.map(DVec2::from))
}

/// The part of the segment from `a` to `b` in the box from `min` to `max`, by six inequalities in t: as [`of_segment`].
#[must_use]
pub fn in_box([min, max]: [DVec3; 2], [a, b]: [DVec3; 2]) -> Option<[DVec3; 2]> {
    let ends = in_range([exact(min)?, exact(max)?], [exact(a)?, exact(b)?])?;
    Some(ends.map(DVec3::from))
}

fn in_range<const N: usize>(
    [min, max]: [[Exact; N]; 2],
    ends: [[Exact; N]; 2],
) -> Option<[[f64; N]; 2]> {
    let above = ends.each_ref().map(|p| minus(p, &min));
    let below = ends.each_ref().map(|p| minus(&max, p));
    let sides: Vec<_> = ([above, below].iter())
        .flat_map(|[a, b]| a.iter().cloned().zip(b.iter().cloned()).map(Into::into))
        .collect();
    Some(not_negative(&sides)?.map(|t| nearest_at(&t, &ends)))
}

/// The doubles nearest to the point (1 − t) a + t b.
fn nearest_at<const N: usize>(t: &Exact, [a, b]: &[[Exact; N]; 2]) -> [f64; N] {
    core::array::from_fn(|k| between(t, &a[k], &b[k]).nearest())
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
fn view_side(p: DVec4, (axis, sign): ViewSide) -> Option<Exact> {
    Some(Exact::new(p.w)? + Exact::new(sign * p[axis])?)
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
    let ends = [exact(a)?, exact(b)?];
    let [c, d] = not_negative(&sides?)?.map(|t| DVec4::from(nearest_at(&t, &ends)));
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
        if values.iter().all(|s| *s >= 0) {
            continue;
        }
        if values.iter().all(|s| *s <= 0) {
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
                kept.push(nearest_at(&s.over(&(s - e))?, &[exact(*a)?, exact(*b)?]));
            }
            if *e >= 0 {
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

/// The edges of a polygon, the last one back to the first corner.
pub fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// Twice the signed area of a polygon, positive counter-clockwise with y upwards; `None` if a coordinate is not
/// finite.
#[must_use]
pub fn doubled_area(polygon: &[DVec2]) -> Option<Exact> {
    let polygon: Option<Vec<_>> = polygon.iter().map(|&p| exact(p)).collect();
    Some(vector::doubled_area(&polygon?))
}

#[cfg(test)]
mod tests {
    use super::{
        VIEW_SIDES, doubled_area, in_box, in_view_volume, of_segment, polygon_in_view_volume,
    };
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
        assert_eq!(doubled_area(&triangle).unwrap(), 16);
        assert_eq!(doubled_area(&[]).unwrap(), 0);
        assert_eq!(doubled_area(&[DVec2::NAN]), None);
    }
}
