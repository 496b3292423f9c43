//! Two methods as textbooks write them, in plain doubles.

use ombra_clip::cohen_sutherland::{Outcode, outcode};
use ombra_clip::window::Side;
use ombra_clip::{Segment, Window};
use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

/// Cuts at one side after another, each time what the last cut has left.
pub fn cohen_sutherland(
    window: &Window,
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    let Segment { mut a, mut b } = segment;
    let code = |p: DVec2, work: &mut _| {
        Count::add(work, Counter::Comparisons, 4);
        outcode(window, p)
    };
    let mut codes = [code(a, work), code(b, work)];
    // Each side is cut at once for each end, or rounding leads round in circles.
    for _ in 0..=2 * Side::ALL.len() {
        if (codes[0] | codes[1]).is_inside() {
            return Some(Segment { a, b });
        }
        if !(codes[0] & codes[1]).is_inside() {
            return None;
        }
        let replaces_a = !codes[0].is_inside();
        let outside = if replaces_a { codes[0] } else { codes[1] };
        let p = cut(window, a, b, outside, work);
        if replaces_a {
            (a, codes[0]) = (p, code(p, work));
        } else {
            (b, codes[1]) = (p, code(p, work));
        }
    }
    None
}

/// The crossing of a → b with the first side that `outside` names.
fn cut(window: &Window, a: DVec2, b: DVec2, outside: Outcode, work: &mut impl Count) -> DVec2 {
    work.add(Counter::Divisions, 1);
    work.add(Counter::Multiplications, 1);
    work.add(Counter::Additions, 4);
    let at_y = |y: f64| DVec2::new(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), y);
    let at_x = |x: f64| DVec2::new(x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
    if outside.has(Side::Above) {
        at_y(window.max.y)
    } else if outside.has(Side::Below) {
        at_y(window.min.y)
    } else if outside.has(Side::Right) {
        at_x(window.max.x)
    } else {
        at_x(window.min.x)
    }
}

/// The bounds of t, rounded, and the points that they give.
pub fn liang_barsky(window: &Window, segment: Segment, work: &mut impl Count) -> Option<Segment> {
    let Segment { a, b } = segment;
    let d = b - a;
    work.add(Counter::Additions, 2);
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for (p, q) in [
        (-d.x, a.x - window.min.x),
        (d.x, window.max.x - a.x),
        (-d.y, a.y - window.min.y),
        (d.y, window.max.y - a.y),
    ] {
        work.add(Counter::Additions, 1);
        work.add(Counter::Comparisons, 1);
        if p == 0.0 {
            if q < 0.0 {
                return None;
            }
            continue;
        }
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        let t = q / p;
        if p < 0.0 {
            first = first.max(t);
        } else {
            last = last.min(t);
        }
        if first > last {
            return None;
        }
    }
    // An end that is not cut stays as it is.
    let mut at = |t: f64| {
        work.add(Counter::Multiplications, 2);
        work.add(Counter::Additions, 2);
        a + t * d
    };
    Some(Segment {
        a: if first > 0.0 { at(first) } else { a },
        b: if last < 1.0 { at(last) } else { b },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lectures_segments() {
        let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
        let s = |a: (f64, f64), b: (f64, f64)| Segment::new(a.into(), b.into());
        for (segment, left) in [
            (
                s((2.0, 14.0), (8.0, -4.0)),
                Some(s((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0))),
            ),
            (s((4.0, 14.0), (14.0, 8.0)), None),
            (
                s((-5.0, 5.0), (15.0, 5.0)),
                Some(s((0.0, 5.0), (10.0, 5.0))),
            ),
            (s((1.0, 2.0), (3.0, 4.0)), Some(s((1.0, 2.0), (3.0, 4.0)))),
            (s((-1.0, 12.0), (11.0, 12.0)), None),
            (s((f64::NAN, 1.0), (2.0, 2.0)), None),
        ] {
            let answers = [
                cohen_sutherland(&window, segment, &mut ()),
                liang_barsky(&window, segment, &mut ()),
            ];
            for answer in answers {
                if segment.a.is_nan() {
                    // Whatever it is, it ends.
                    continue;
                }
                assert_eq!(answer.is_some(), left.is_some(), "{segment:?}");
                if let (Some(answer), Some(left)) = (answer, left) {
                    // A few roundings of numbers below 16.
                    let off = (answer.a - left.a).abs().max((answer.b - left.b).abs());
                    assert!(off.max_element() <= 16.0 * f64::EPSILON * 4.0, "{answer:?}");
                }
            }
        }
    }
}
