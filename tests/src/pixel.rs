//! Which pixels belong to a segment and to a triangle, by definition: every pixel for itself, in exact numbers.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_oracle::vector::{exact, turn};

/// The pixels of the segment from `a` to `b`: in each column, or row if it is steep, the one nearest to the line; of
/// two as near, the one nearer `a`.
#[must_use]
pub fn of_segment(a: IVec2, b: IVec2) -> Vec<IVec2> {
    let (run, rise) = run_and_rise(a, b);
    (0..=run)
        .map(|i| at(a, b, lower_half(rise, run, i), i))
        .collect()
}

/// Whether the segment from `a` to `b` passes midway between two pixels after `i` moves.
#[must_use]
pub fn is_tie(a: IVec2, b: IVec2, i: i128) -> bool {
    let (run, rise) = run_and_rise(a, b);
    run > 0 && (2 * rise * i).rem_euclid(2 * run) == run
}

/// How many moves lead from `a` to the column or row of `p`.
#[must_use]
pub fn moves_to(a: IVec2, b: IVec2, p: IVec2) -> i128 {
    let d = difference(a, b);
    let along = usize::from(d[0].abs() < d[1].abs());
    difference(a, p)[along].abs()
}

/// Twice the distance, along the shorter axis, from `p` to the line through `a` and `b`, in units of 1/run: a pixel
/// is half a pixel off or less where this is at most the run, the larger of |dx| and |dy|.
#[must_use]
pub fn doubled_offset(a: IVec2, b: IVec2, p: IVec2) -> (i128, i128) {
    let ([dx, dy], [px, py]) = (difference(a, b), difference(a, p));
    (2 * (dx * py - dy * px).abs(), dx.abs().max(dy.abs()))
}

fn difference(a: IVec2, b: IVec2) -> [i128; 2] {
    [0, 1].map(|k| i128::from(b[k]) - i128::from(a[k]))
}

fn run_and_rise(a: IVec2, b: IVec2) -> (i128, i128) {
    let [dx, dy] = difference(a, b).map(i128::abs);
    (dx.max(dy), dx.min(dy))
}

/// rise · i / run, rounded to the nearest integer, halves down.
fn lower_half(rise: i128, run: i128, i: i128) -> i128 {
    if run == 0 {
        return 0;
    }
    // The least k with k ≥ rise · i / run − ½.
    -(run - 2 * rise * i).div_euclid(2 * run)
}

/// The pixel `i` moves along the longer axis from `a` and `k` along the other.
fn at(a: IVec2, b: IVec2, k: i128, i: i128) -> IVec2 {
    let d = difference(a, b);
    let steep = d[0].abs() < d[1].abs();
    let moves = if steep { [k, i] } else { [i, k] };
    // Between a and b, so inside i32.
    let place = |axis: usize| i128::from(a[axis]) + moves[axis] * d[axis].signum();
    IVec2::from_array([0, 1].map(|axis| i32::try_from(place(axis)).unwrap_or(0)))
}

/// Whether the centre of pixel (`x`, `y`) lies in the triangle, taken a little to the right and a very little
/// further down, (x + ½ + δ, y + ½ + δ²) with δ → 0, where no centre lies on an edge. `None` for corners that are not
/// finite.
#[must_use]
pub fn in_triangle(triangle: [DVec2; 3], x: u32, y: u32) -> Option<bool> {
    let [a, b, c] = triangle;
    let p = exact([x, y].map(|k| f64::from(k) + 0.5))?;
    let mut sides = [Ordering::Equal; 3];
    for (side, (from, to)) in sides.iter_mut().zip([(a, b), (b, c), (c, a)]) {
        let (a, b) = (exact(from)?, exact(to)?);
        // E(P) = dx (p_y − a_y) − dy (p_x − a_x); moving P adds −dy δ + dx δ².
        *side = turn(&a, &b, &p)
            .sign()
            .then(a[1].cmp(&b[1]))
            .then(b[0].cmp(&a[0]));
    }
    Some(sides[0] != Ordering::Equal && sides.iter().all(|&side| side == sides[0]))
}

#[cfg(test)]
mod tests {
    use super::{in_triangle, is_tie, of_segment};
    use ombra_math::glam::{DVec2, IVec2};

    // By hand: y = 3x/8 is 3/8, 6/8, 9/8, 12/8 (a tie), 15/8, 18/8, 21/8, 3.
    #[test]
    fn a_segment_by_hand() {
        let (a, b) = (IVec2::ZERO, IVec2::new(8, 3));
        let y: Vec<i32> = of_segment(a, b).iter().map(|p| p.y).collect();
        assert_eq!(y, [0, 0, 1, 1, 1, 2, 2, 3, 3]);
        let ties: Vec<i128> = (0..=8).filter(|&i| is_tie(a, b, i)).collect();
        assert_eq!(ties, [4]);
        // Downwards and steep: counted from the start.
        let x: Vec<i32> = of_segment(b, IVec2::new(5, -5))
            .iter()
            .map(|p| p.x)
            .collect();
        assert_eq!(x, [8, 8, 7, 7, 7, 6, 6, 5, 5]);
        assert_eq!(of_segment(a, a), [a]);
    }

    // The square's diagonal runs through two centres, each in one half alone.
    #[test]
    fn halves_of_a_square() {
        let [a, b, c, d] = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(DVec2::from);
        let owned = |triangle| {
            let pixels = [(0, 0), (1, 0), (0, 1), (1, 1)];
            pixels.map(|(x, y)| in_triangle(triangle, x, y).unwrap())
        };
        assert_eq!(owned([a, b, c]), [true, true, false, true]);
        assert_eq!(owned([c, b, a]), [true, true, false, true]);
        assert_eq!(owned([a, c, d]), [false, false, true, false]);
        assert_eq!(owned([a, c, c]), [false; 4]);
        assert_eq!(in_triangle([a, b, DVec2::NAN], 0, 0), None);
    }
}
