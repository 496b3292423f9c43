use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// The code of clip2, given here: 1000 above, 0100 below, 0010 right, 0001 left of the window.
fn outcode(window: Window, p: DVec2) -> u8 {
    let beyond = [
        p.y > window.max.y,
        p.y < window.min.y,
        p.x > window.max.x,
        p.x < window.min.x,
    ];
    beyond
        .into_iter()
        .fold(0, |code, bit| 2 * code + u8::from(bit))
}

/// What of the segment from `a` to `b` lies in the window, by the algorithm of Cohen and Sutherland.
///
/// ```text
/// in every round, from the codes of both ends:
///   OR = 0000    the segment is inside: done
///   AND ≠ 0000   nothing is inside: done
///   else         take the first bit from the left in which the codes differ; the end that has it is replaced by the
///                intersection with the side of that bit
/// ```
///
/// The slide tests AND only before the first cut; then a segment beside a corner is never done with (erratum E22). At
/// the upper side the intersection is
///
/// ```text
/// x = x_a + (y_max − y_a) (x_b − x_a) / (y_b − y_a)      y = y_max
/// ```
///
/// and likewise at the others: the coordinate of the side is taken as it is. The answer goes the same way as a → b.
/// Call `round(a, b)` at the start of every round, with the ends as they are then. Coordinates are finite.
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn clip(
    window: Window,
    a: DVec2,
    b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    // TODO: a loop: the round, the two tests, the bit, the cut. (Write `mut a` and `mut b` to change them.)
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod clip4_cohen_sutherland {
    use super::{Window, clip};
    use assess::{Inputs, Steps, WindowCase, show_point};
    use glam::DVec2;

    type Ends = (DVec2, DVec2);

    /// The names of the bits, the first one first.
    const SIDES: [&str; 4] = ["upper", "lower", "right", "left"];

    fn bits(case: &WindowCase, p: DVec2) -> [bool; 4] {
        [
            p.y > case.max.y,
            p.y < case.min.y,
            p.x > case.max.x,
            p.x < case.min.x,
        ]
    }

    fn show(bits: [bool; 4]) -> String {
        bits.map(|bit| if bit { '1' } else { '0' }).iter().collect()
    }

    /// Whether OR is 0000 and whether AND is not.
    fn tests(case: &WindowCase, (a, b): Ends) -> (bool, bool) {
        let (a, b) = (bits(case, a), bits(case, b));
        (a == [false; 4] && b == a, (0..4).any(|i| a[i] && b[i]))
    }

    /// The answer, and the ends in each round; each round is checked.
    fn run(case: &WindowCase) -> (Option<Ends>, Vec<Ends>) {
        let mut rounds: Vec<Ends> = Vec::new();
        // Each end is cut twice at most.
        let mut steps = Steps::new(5);
        let window = Window {
            min: case.min,
            max: case.max,
        };
        let got = clip(window, case.a, case.b, &mut |a, b| {
            if let Some(&(p, q)) = rounds.last() {
                let (inside, outside) = tests(case, (p, q));
                let codes = format!("{} and {}", show(bits(case, p)), show(bits(case, q)));
                assert!(
                    !outside,
                    "{case}: a round with {} to {} had the codes {codes}: AND is not 0000, so nothing is inside, yet \
                     the loop goes on: AND is to be tested in every round, not only before the first cut (erratum E22)",
                    show_point(p),
                    show_point(q),
                );
                assert!(
                    !inside,
                    "{case}: a round had the codes {codes}: OR is 0000, yet the loop goes on"
                );
                check_cut(case, (p, q), (a, b));
            }
            steps.take("cutting");
            rounds.push((a, b));
        });
        let Some(&last) = rounds.last() else {
            panic!("{case}: `round` was never called: call it first of all in every round")
        };
        assert!(
            tests(case, last) != (false, false),
            "{case}: it ended after the round with {} to {}, whose codes {} and {} are neither inside nor outside: \
             cut, and begin the next round with the codes of the new ends",
            show_point(last.0),
            show_point(last.1),
            show(bits(case, last.0)),
            show(bits(case, last.1)),
        );
        (got, rounds)
    }

    /// From one round to the next.
    fn check_cut(case: &WindowCase, (p, q): Ends, (a, b): Ends) {
        let (code_p, code_q) = (bits(case, p), bits(case, q));
        let codes = format!("{case}: codes {} and {}", show(code_p), show(code_q));
        let differ = |i: &usize| code_p[*i] != code_q[*i];
        let Some(first) = (0..4).find(differ) else {
            panic!("{codes} do not differ")
        };
        let new = if a == p { b } else { a };
        let on = [
            new.y == case.max.y,
            new.y == case.min.y,
            new.x == case.max.x,
            new.x == case.min.x,
        ];
        assert!(
            on[first] || !(first + 1..4).filter(differ).any(|i| on[i]),
            "{codes}: cut at the {} side, of the first bit from the left in which they differ; {} is on another one",
            SIDES[first],
            show_point(new),
        );
        let (old, kept) = if code_p[first] { (q, b) } else { (p, a) };
        assert!(
            old == kept,
            "{codes}: the end whose bit is 1 lies outside and is replaced, and the other one kept; but {} became {}",
            show_point(old),
            show_point(kept),
        );
        assert!(
            on[first],
            "{codes}: the new end {} must lie on the {} side itself",
            show_point(new),
            SIDES[first],
        );
    }

    fn case(a: (f64, f64), b: (f64, f64), inside: Option<[(f64, f64); 2]>) -> WindowCase {
        WindowCase {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
            a: a.into(),
            b: b.into(),
            inside: inside.map(|[p, q]| (p.into(), q.into())),
        }
    }

    fn known(case: &WindowCase, cuts: usize) {
        let (got, rounds) = run(case);
        case.assert_right(got);
        assert!(
            rounds.len() == cuts + 1,
            "{case}: with {cuts} for the number of cuts there are {} rounds, the last one without a cut, but `round` was \
             called {}×",
            cuts + 1,
            rounds.len()
        );
    }

    #[test]
    fn two_cuts() {
        // 1000 and 0100: cut at y = 10, then at y = 0.
        let through = case(
            (2.0, 14.0),
            (8.0, -4.0),
            Some([(10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)]),
        );
        known(&through, 2);
        known(
            &case((-5.0, 5.0), (15.0, 5.0), Some([(0.0, 5.0), (10.0, 5.0)])),
            2,
        );
        known(
            &case((2.0, 3.0), (7.0, 10.0), Some([(2.0, 3.0), (7.0, 10.0)])),
            0,
        );
    }

    #[test]
    fn beside_a_corner() {
        // 1000 and 0010, then (32/3, 10) with 0010 and 0010.
        known(&case((4.0, 14.0), (14.0, 8.0), None), 1);
        known(&case((0.0, 20.0), (20.0, 0.0), Some([(10.0, 10.0); 2])), 2);
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(37);
        for _ in 0..400 {
            let case = WindowCase::crossing(&mut inputs);
            case.assert_right(run(&case).0);
        }
    }

    #[test]
    fn nothing_inside() {
        let mut inputs = Inputs::new(38);
        for _ in 0..400 {
            let case = WindowCase::passing(&mut inputs);
            case.assert_right(run(&case).0);
        }
    }

    #[test]
    fn huge_and_points() {
        known(
            &case((-1e300, 5.0), (1e300, 5.0), Some([(0.0, 5.0), (10.0, 5.0)])),
            2,
        );
        known(
            &case((5.0, 1e300), (5.0, -1e300), Some([(5.0, 10.0), (5.0, 0.0)])),
            2,
        );
        known(&case((1e300, 12.0), (-1e300, 12.0), None), 0);
        known(&case((3.0, 3.0), (3.0, 3.0), Some([(3.0, 3.0); 2])), 0);
        known(&case((3.0, 30.0), (3.0, 30.0), None), 0);
    }
}
