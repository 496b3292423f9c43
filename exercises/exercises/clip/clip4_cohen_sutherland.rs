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
    // So that the tests can stop a loop without an end.
    assess::counted("outcode");
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
/// Call `round(a, b)` at the start of every round, with the ends as they are then. Coordinates are finite, and so is
/// b − a.
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
    use assess::{Inputs, SIDES, Steps, WindowCase, short_point, watched, within_calls};
    use glam::DVec2;

    type Ends = (DVec2, DVec2);

    /// Each end is cut twice at most.
    const MOST_ROUNDS: usize = 5;

    /// In a round the codes of both ends, and a few more to choose by.
    const MOST_CODES: usize = 20 * MOST_ROUNDS;

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
        let case = *case;
        watched(&case.to_string(), move || cut(&case))
    }

    fn cut(case: &WindowCase) -> (Option<Ends>, Vec<Ends>) {
        let mut rounds: Vec<Ends> = Vec::new();
        let mut steps = Steps::new(MOST_ROUNDS);
        let window = Window {
            min: case.min,
            max: case.max,
        };
        let mut round = |a: DVec2, b: DVec2| {
            let _picture = case.picture(Some((a, b)));
            match rounds.last() {
                None => check_first(case, (a, b)),
                Some(&before) => check_round(case, before, (a, b)),
            }
            steps.take("cutting");
            rounds.push((a, b));
        };
        let got = within_calls(
            MOST_CODES,
            "Each cut replaces an end, and the codes are those of the new ends.",
            || clip(window, case.a, case.b, &mut round),
        );
        let _picture = case.picture(got);
        let Some(&last) = rounds.last() else {
            panic!("{case}: `round` was never called: call it first of all in every round")
        };
        let (inside, outside) = tests(case, last);
        if let (Some((p, q)), true) = (got, outside) {
            panic!(
                "{case}: the last round had the codes {} and {}: AND is not 0000, so nothing is inside, but got {} to {}",
                show(bits(case, last.0)),
                show(bits(case, last.1)),
                short_point(p),
                short_point(q),
            );
        }
        if !inside && !outside {
            let codes = format!(
                "the last round had {} to {}, with the codes {} and {}",
                short_point(last.0),
                short_point(last.1),
                show(bits(case, last.0)),
                show(bits(case, last.1)),
            );
            assert!(
                got.is_some(),
                "{case}: {codes}: AND is 0000 and OR is not, so the segment must be cut, but got None",
            );
            // Where nothing but a hair lies outside, the plain cases were right.
            let hair = 1e-3 * (case.max - case.min);
            let grown = WindowCase {
                min: case.min - hair,
                max: case.max + hair,
                ..*case
            };
            assert!(
                !tests(&grown, last).0,
                "{case}: {codes}, and got an answer, as if it were inside: it is not, by however little; ask the codes, \
                 without a tolerance",
            );
            panic!("{case}: {codes}: cut, and begin the next round with the codes of the new ends");
        }
        assert!(
            !inside || got.is_some(),
            "{case}: the last round had the codes 0000 and 0000: inside, {} to {} is the answer, but got None",
            short_point(last.0),
            short_point(last.1),
        );
        (got, rounds)
    }

    /// The first round has the ends as given.
    fn check_first(case: &WindowCase, (a, b): Ends) {
        assert!(
            (a, b) == (case.a, case.b),
            "{case}: the first round has {} to {}: call `round(a, b)` at its start, before any cut",
            short_point(a),
            short_point(b),
        );
    }

    /// From one round to the next.
    fn check_round(case: &WindowCase, (p, q): Ends, (a, b): Ends) {
        let (inside, outside) = tests(case, (p, q));
        let (code_p, code_q) = (bits(case, p), bits(case, q));
        let codes = format!("codes {} and {}", show(code_p), show(code_q));
        assert!(
            !outside,
            "{case}: a round with {} to {} had the {codes}: AND is not 0000, so nothing is inside, yet the loop goes on: \
             work out the codes and test AND in every round, not only before the first cut (erratum E22)",
            short_point(p),
            short_point(q),
        );
        assert!(
            !inside,
            "{case}: a round had the {codes}: OR is 0000, so the segment is inside, yet the loop goes on"
        );
        let differ = |i: &usize| code_p[*i] != code_q[*i];
        let Some(first) = (0..4).find(differ) else {
            return;
        };
        assert!(
            a.is_finite() && b.is_finite(),
            "{case}: {codes}: the next round has {} to {}, no points of the plane: does the cut divide by y_b − y_a at the upper and \
             the lower side, by x_b − x_a at the right and the left one?",
            short_point(a),
            short_point(b),
        );
        assert!(
            (a, b) != (p, q),
            "{case}: {codes}: the next round has the same ends, so it would go on for ever: replace the end whose bit is 1 \
             by the intersection",
        );
        assert!(
            (a, b) != (q, p),
            "{case}: {codes}: the next round has the ends exchanged and none of them cut"
        );
        assert!(
            a == p || b == q,
            "{case}: {codes}: both ends changed, to {} and {}: one cut a round, at the first bit that differs",
            short_point(a),
            short_point(b),
        );
        let (old, new) = if a == p { (q, b) } else { (p, a) };
        let on = [
            new.y == case.max.y,
            new.y == case.min.y,
            new.x == case.max.x,
            new.x == case.min.x,
        ];
        let replaced = if a == p { code_q } else { code_p };
        let cut_at = (0..4).filter(differ).find(|&i| on[i]);
        assert!(
            !on[first] || replaced[first],
            "{case}: {codes}: {} became {} on the {} side, but its bit is 0 there: the end whose bit is 1 lies outside and \
             is replaced, and the other one kept",
            short_point(old),
            short_point(new),
            SIDES[first],
        );
        assert!(
            on[first] || !cut_at.is_some_and(|side| replaced[side]),
            "{case}: {codes}: cut at the {} side, of the first bit from the left in which they differ; {} is on another \
             one",
            SIDES[first],
            short_point(new),
        );
        let sides = ["y = y_max", "y = y_min", "x = x_max", "x = x_min"];
        assert!(
            on[first],
            "{case}: {codes}: the new end {} must lie on the {} side itself: {}",
            short_point(new),
            SIDES[first],
            sides[first],
        );
        let d = q - p;
        let off = d.normalize_or_zero().perp_dot(new - p).abs();
        let across = if first < 2 { d.y } else { d.x };
        assert!(
            off <= 1e-9 * (1.0 + d.length()) || across.abs() > 1e100,
            "{case}: {codes}: the new end {} lies on the {} side, but not on the segment from {} to {}, as it is in this \
             round",
            short_point(new),
            SIDES[first],
            short_point(p),
            short_point(q),
        );
    }

    #[track_caller]
    fn known(case: &WindowCase, cuts: usize) {
        let (got, rounds) = run(case);
        case.check(got);
        assert!(
            rounds.len() == cuts + 1,
            "{case}: {cuts} cuts make {} rounds, the last one without a cut, but `round` was called {}×",
            cuts + 1,
            rounds.len()
        );
    }

    #[test]
    fn two_cuts() {
        known(
            &WindowCase::known((2.0, 3.0), (7.0, 10.0), Some([(2.0, 3.0), (7.0, 10.0)])),
            0,
        );
        known(
            &WindowCase::known((2.0, 3.0), (12.0, 8.0), Some([(2.0, 3.0), (10.0, 7.0)])),
            1,
        );
        known(
            &WindowCase::known((-5.0, 5.0), (15.0, 5.0), Some([(0.0, 5.0), (10.0, 5.0)])),
            2,
        );
        // 1000 and 0100: cut at y = 10, then at y = 0.
        let ends = [(10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)];
        known(&WindowCase::known((2.0, 14.0), (8.0, -4.0), Some(ends)), 2);
    }

    #[test]
    fn beside_a_corner() {
        // 1000 and 0010, then (32/3, 10) with 0010 and 0010.
        known(&WindowCase::known((4.0, 14.0), (14.0, 8.0), None), 1);
        let corner = Some([(10.0, 10.0); 2]);
        known(&WindowCase::known((0.0, 20.0), (20.0, 0.0), corner), 2);
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(37);
        for case in WindowCase::many(400, &mut inputs, WindowCase::crossing) {
            case.check(run(&case).0);
        }
        for case in WindowCase::many(100, &mut inputs, WindowCase::rounded) {
            case.check(run(&case).0);
        }
    }

    #[test]
    fn nothing_inside() {
        let mut inputs = Inputs::new(38);
        for case in WindowCase::many(400, &mut inputs, WindowCase::passing) {
            case.check(run(&case).0);
        }
    }

    #[test]
    fn a_hair_outside() {
        WindowCase::check_hairs(|case| run(case).0);
    }

    #[test]
    fn huge_and_points() {
        let inside = Some([(3.0, 3.0); 2]);
        known(&WindowCase::known((3.0, 3.0), (3.0, 3.0), inside), 0);
        known(&WindowCase::known((3.0, 30.0), (3.0, 30.0), None), 0);
        let across = Some([(0.0, 5.0), (10.0, 5.0)]);
        known(&WindowCase::known((-1e300, 5.0), (1e300, 5.0), across), 2);
        let down = Some([(5.0, 10.0), (5.0, 0.0)]);
        known(&WindowCase::known((5.0, 1e300), (5.0, -1e300), down), 2);
        known(&WindowCase::known((1e300, 12.0), (-1e300, 12.0), None), 0);
    }
}
