//! Sticks painted one over another.

use glam::{DVec2, DVec3};

use crate::{Ink, Panel, Picture};

/// Sticks as a painter paints them in `order`, beside what a viewer sees of them: at each crossing the nearer one, in a
/// view along z. Each stick has its ends; what `order` does not name is not painted.
#[track_caller]
pub fn painted_sticks(sticks: &[[DVec3; 2]], order: &[usize]) -> Picture {
    let mut yours = Panel::plane();
    let mut right = Panel::plane();
    let paint = |panel: &mut Panel, k: usize| {
        if let Some([a, b]) = sticks.get(k) {
            panel.stick(a.truncate(), b.truncate(), Ink::Shade(k));
        }
    };
    order.iter().for_each(|&k| paint(&mut yours, k));
    (0..sticks.len()).for_each(|k| paint(&mut right, k));
    for (k, [a, b]) in sticks.iter().enumerate() {
        for other in sticks {
            let Some((s, t)) = crossing([*a, *b], *other) else {
                continue;
            };
            // The nearer one once more, a short way round the crossing.
            if a.lerp(*b, s).z < other[0].lerp(other[1], t).z {
                let (at, way) = (a.lerp(*b, s).truncate(), (*b - *a).truncate());
                let short = way.normalize_or_zero() * 0.04 * longest(sticks);
                right.stick(at - short, at + short, Ink::Shade(k));
            }
        }
    }
    for (k, [a, b]) in sticks.iter().enumerate().take(12) {
        let end = b.truncate() + 0.03 * (b.truncate() - a.truncate());
        for panel in [&mut yours, &mut right] {
            panel.point(end, &k.to_string(), Ink::Shade(k));
        }
    }
    Picture::beside(yours, right)
}

fn longest(sticks: &[[DVec3; 2]]) -> f64 {
    let lengths = sticks
        .iter()
        .map(|[a, b]| a.truncate().distance(b.truncate()));
    lengths.fold(0.0, f64::max)
}

/// Where two sticks cross in the picture, as shares of both.
fn crossing([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> Option<(f64, f64)> {
    let flat = |p: DVec3| -> DVec2 { p.truncate() };
    let (u, v, between) = (flat(b - a), flat(d - c), flat(c - a));
    let across = u.perp_dot(v);
    let (s, t) = (between.perp_dot(v) / across, between.perp_dot(u) / across);
    let on_both = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    on_both.then_some((s, t))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_stick_is_painted_over_the_crossing() {
        let far = [DVec3::new(-1.0, 0.0, 5.0), DVec3::new(1.0, 0.0, 5.0)];
        let near = [DVec3::new(0.0, -1.0, 2.0), DVec3::new(0.0, 1.0, 2.0)];
        // Two sticks in each half, and one crossing in the right one.
        let sticks = |order: &[usize]| {
            let svg = painted_sticks(&[far, near], order).svg();
            svg.matches("stroke-width=\"17\"").count()
        };
        assert_eq!(sticks(&[1, 0]), 5);
        assert_eq!(sticks(&[]), 3);
        assert_eq!(sticks(&[7]), 3);
    }
}
