//! The depth sort in its plain form: every pair is compared before anything is painted.

use ombra_math::glam::DVec4;
use ombra_math::work::{Count, Counter};

use super::cycle::{Cycle, ring_on};
use super::extent::View;
use crate::pair::{Pair, Seen, compare_seen};
use crate::polygon::Polygon;

/// Which primitive hides part of which: `[front, back]` for each such pair, sorted.
///
/// # Properties
///
/// Two that cross stand there both ways round. Of two at the same depth the one submitted first hides the other.
/// An order back to front puts every back before its front.
///
/// # Examples
///
/// ```
/// use ombra_hsr::painter::hiding_pairs;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let square = |z: f64| Polygon {
///     vertices: [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, z)).to_vec(),
/// };
/// // Seen from above, the second lies over the first.
/// assert_eq!(hiding_pairs(&[square(0.0), square(2.0)], DVec4::Z), [[1, 0]]);
/// ```
///
/// # References
///
/// Grafica 3, «Rimozione delle Superfici Nascoste»: nearer objects hide farther ones, in whole or in part.
#[must_use]
pub fn hiding_pairs(polygons: &[Polygon], eye: DVec4) -> Vec<[usize; 2]> {
    hiding_pairs_counted(polygons, eye, &mut ())
}

/// [`hiding_pairs`], counting the pairs compared: k (k − 1) / 2.
#[must_use]
pub fn hiding_pairs_counted(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Vec<[usize; 2]> {
    let seen: Vec<_> = polygons.iter().map(|p| Seen::new(p, eye)).collect();
    let mut pairs = Vec::new();
    for (i, first) in seen.iter().enumerate() {
        for (j, second) in seen.iter().enumerate().skip(i + 1) {
            work.add(Counter::Pairs, 1);
            let pair = first.as_ref().zip(second.as_ref());
            match pair.map_or(Pair::Apart, |(first, second)| compare_seen(first, second)) {
                Pair::Apart => {}
                Pair::FirstNearer | Pair::Coplanar => pairs.push([i, j]),
                Pair::SecondNearer => pairs.push([j, i]),
                Pair::Crossing => pairs.extend([[i, j], [j, i]]),
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// [`order`](super::order) in its plain form, that compares every pair.
///
/// # Errors
///
/// As for [`order`](super::order).
pub fn order_plain(polygons: &[Polygon], eye: DVec4) -> Result<Vec<usize>, Cycle> {
    order_plain_counted(polygons, eye, &mut ())
}

/// [`order_plain`], counting the pairs compared: k (k − 1) / 2.
///
/// # Errors
///
/// As for [`order`](super::order).
pub fn order_plain_counted(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Result<Vec<usize>, Cycle> {
    let view = View::of(eye);
    let distances: Vec<f64> = polygons.iter().map(|p| view.distance(p)).collect();
    // Farther first; a stable sort leaves equal ones as they were submitted.
    let mut sorted: Vec<usize> = (0..polygons.len()).collect();
    sorted.sort_by(|&a, &b| distances[b].total_cmp(&distances[a]));

    let mut hidden_by = vec![Vec::new(); polygons.len()];
    for [front, back] in hiding_pairs_counted(polygons, eye, work) {
        hidden_by[front].push(back);
    }
    for hidden in &mut hidden_by {
        hidden.sort_by(|&a, &b| distances[b].total_cmp(&distances[a]).then(a.cmp(&b)));
    }

    let mut order = Vec::with_capacity(polygons.len());
    let mut is_painted = vec![false; polygons.len()];
    // What is next in the sort, and after it what has to be painted before because the one before hides it.
    let mut path: Vec<usize> = Vec::new();
    for &farthest in sorted.iter() {
        if !is_painted[farthest] {
            path.push(farthest);
        }
        while let Some(&last) = path.last() {
            match hidden_by[last].iter().find(|&&b| !is_painted[b]) {
                None => {
                    is_painted[last] = true;
                    order.push(last);
                    path.pop();
                }
                Some(&back) => match path.iter().position(|&p| p == back) {
                    None => path.push(back),
                    Some(start) => {
                        return Err(Cycle::of(ring_on(&path[start..], |p| &hidden_by[p])));
                    }
                },
            }
        }
    }
    Ok(order)
}
