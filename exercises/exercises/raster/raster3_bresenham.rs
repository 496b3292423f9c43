use glam::IVec2;

/// Where the next pixel lies.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Choice {
    /// East: (x + 1, y).
    E,
    /// North-east: (x + 1, y + 1). y points down here, so in a picture it lies below E; the slide draws y upwards.
    NE,
}

/// A decision of the algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Step {
    /// The pixel P where it is taken.
    pixel: IVec2,
    /// 2F(M), M the midpoint of E and NE.
    decision: i64,
    /// The choice that it leads to.
    choice: Choice,
}

/// The decisions of Bresenham's algorithm for the segment from `a` to `b` in the octant of the slide, 0 ≤ dy ≤ dx.
///
/// ```text
/// F(x, y) = dy (x − x_a) − dx (y − y_a)          M = (x_P + 1, y_P + ½)
///
/// d = 2F(M):   at a        d = 2dy − dx
///              d ≤ 0:  E,  then d grows by 2dy
///              d > 0:  NE, then d grows by 2dy − 2dx
/// ```
///
/// F holds a half, so its double is kept and everything stays whole; the slide has neither the double nor the start
/// (erratum E15). d = 0 is a tie, indifferent on the slide; E is the pixel nearer the start.
///
/// `take` gets one step for each move, none for the pixel b. dx fits an `i32`, 2F does not.
///
/// Grafica 3, Algoritmo di Bresenham.
fn trace(a: IVec2, b: IVec2, take: &mut dyn FnMut(Step)) {
    // TODO: d at the start, then for each move the choice and the next d.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod raster3_bresenham {
    use super::Choice::{E, NE};
    use super::{Step, trace};
    use assess::{Grid, Inputs, Segment, calls_within, first_calls, watched};
    use glam::IVec2;

    fn steps(a: IVec2, b: IVec2) -> Vec<Step> {
        let what = Segment::new(a, b).show();
        watched(&what.clone(), move || {
            calls_within(&what, (b.x - a.x) as usize + 8, |take| trace(a, b, take))
        })
    }

    fn any(inputs: &mut Inputs) -> (IVec2, IVec2) {
        let a = IVec2::new(inputs.integer(-100, 100), inputs.integer(-100, 100));
        let dx = inputs.integer(3, 60);
        (a, a + IVec2::new(dx, inputs.integer(0, dx)))
    }

    /// Compares each d with 2F, worked out anew from the pixel.
    fn check(a: IVec2, b: IVec2, steps: &[Step]) {
        let way = |to: IVec2| (i64::from(to.x - a.x), i64::from(to.y - a.y));
        let (dx, dy) = way(b);
        let segment = Segment::new(a, b);
        assert!(
            dx == 0 || !steps.is_empty(),
            "{}: no step is handed to `take`, but dx = {dx} moves lead from a to b",
            segment.show(),
        );
        let drawn: Vec<_> = steps.iter().map(|step| step.pixel.into()).collect();
        // The last pixel has no step of its own.
        let is_whole = steps.len() as i64 == dx;
        let end = is_whole.then_some(b.into());
        let _picture = segment.picture(&drawn.into_iter().chain(end).collect::<Vec<_>>());
        let mut pixel = a;
        for (i, step) in steps.iter().enumerate() {
            let what = format!(
                "{}, move {i}: d {}, {:?} at ({}, {})",
                Segment::new(a, b).show(),
                step.decision,
                step.choice,
                step.pixel.x,
                step.pixel.y,
            );
            assert!(
                step.pixel == pixel,
                "{what}: the moves so far lead to ({}, {})",
                pixel.x,
                pixel.y
            );
            let (x, y) = way(pixel);
            let want = 2 * dy * (x + 1) - dx * (2 * y + 1);
            let of_the_other = match i
                .checked_sub(1)
                .map(|before| (steps[before], step.decision))
            {
                Some((before, d)) if before.choice == E => d == before.decision + 2 * dy - 2 * dx,
                Some((before, d)) => d == before.decision + 2 * dy,
                None => false,
            };
            assert!(
                step.decision == want || !of_the_other,
                "{what}: the two steps of d are exchanged: 2dy belongs to E, 2dy − 2dx to NE",
            );
            // A tiny 2F does not tell these two mistakes apart.
            let start = (i == 0 && want.abs() > 2).then_some(step.decision);
            assert!(
                start != Some(0),
                "{what}: d starts with F at a, which is 0, but it is 2F at the first midpoint, 2dy − dx = {want}",
            );
            assert!(
                start.is_none_or(|d| (2 * d - want).abs() > 1),
                "{what}: d starts with F itself, which loses its half where dx is odd: keep 2F, here {want}, and \
                 double the two steps as well",
            );
            assert!(
                step.decision == want,
                "{what}: 2F at the midpoint is {want}"
            );
            assert!(
                want != 0 || step.choice == E,
                "{what}: d = 0 is a tie: the line passes through the midpoint, and the pixel nearer the start is E",
            );
            let choice = if want > 0 { NE } else { E };
            assert!(
                step.choice == choice,
                "{what}: F > 0 where the line passes above the midpoint, as the slide draws it: choose {choice:?}",
            );
            pixel += IVec2::new(1, if choice == NE { 1 } else { 0 });
        }
    }

    #[test]
    fn known_segment() {
        let b = IVec2::new(8, 3);
        let steps = steps(IVec2::ZERO, b);
        let decisions: Vec<_> = steps.iter().map(|step| step.decision).collect();
        let choices: Vec<_> = steps.iter().map(|step| step.choice).collect();
        // 2dy − dx = −2; E adds 6, NE adds 6 − 16 = −10.
        let want = [-2, 4, -6, 0, 6, -4, 2, -8];
        assert!(
            decisions == want,
            "(0, 0) to (8, 3): 2F is {want:?}, got {decisions:?}"
        );
        let want = [E, NE, E, E, NE, E, NE, E];
        assert!(
            choices == want,
            "(0, 0) to (8, 3): the choices are {want:?}, got {choices:?}"
        );
        let pixels = steps.iter().map(|step| step.pixel).chain([b]);
        Grid::of(9, 4, pixels.map(Into::into)).assert_is(
            "(0, 0) to (8, 3)",
            &["##.......", "..###....", ".....##..", ".......##"],
        );
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(25);
        for _ in 0..300 {
            let (a, b) = any(&mut inputs);
            let steps = steps(a, b);
            check(a, b, &steps);
            let (count, dx) = (steps.len() as i32, b.x - a.x);
            assert!(
                count == dx,
                "{}: {count} steps, but there are dx = {dx} moves, and none at the last pixel",
                Segment::new(a, b).show(),
            );
        }
    }

    #[test]
    fn rims_of_the_octant() {
        let a = IVec2::new(3, -4);
        assert!(
            steps(a, a).is_empty(),
            "a = b: there is no move, so no step"
        );
        for (dy, decision, choice) in [(0, -20, E), (20, 20, NE)] {
            for step in steps(a, a + IVec2::new(20, dy)) {
                assert!(
                    (step.decision, step.choice) == (decision, choice),
                    "dx 20, dy {dy}: 2F is {decision} all the way, so always {choice:?}; got {step:?}",
                );
            }
        }
    }

    #[test]
    fn long_segments() {
        for b in [
            IVec2::new(i32::MAX, i32::MAX),
            IVec2::new(i32::MAX, 2_000_000_011),
            IVec2::new(2_000_000_011, 1),
        ] {
            let steps =
                first_calls(300, |take| trace(IVec2::ZERO, b, take)).unwrap_or_else(|said| {
                    panic!(
                        "{}: {said}: 2F is as large as 4·10⁹ here, beyond an i32",
                        Segment::new(IVec2::ZERO, b).show(),
                    )
                });
            check(IVec2::ZERO, b, &steps);
        }
    }
}
