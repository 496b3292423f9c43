// rejected by any_segment: side itself: y = y_min
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
/// Call `round(a, b)` at the start of every round, with the ends as they are then. Coordinates are finite.
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn clip(
    window: Window,
    mut a: DVec2,
    mut b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    loop {
        round(a, b);
        let (code_a, code_b) = (outcode(window, a), outcode(window, b));
        if code_a | code_b == 0 {
            return Some((a, b));
        }
        if code_a & code_b != 0 {
            return None;
        }
        let differ = code_a ^ code_b;
        let bit = [0b1000, 0b0100, 0b0010, 0b0001]
            .into_iter()
            .find(|bit| differ & bit != 0)?;
        let d = b - a;
        let at_y = |y: f64| a + (y - a.y) / d.y * d;
        let at_x = |x: f64| a + (x - a.x) / d.x * d;
        let cut = match bit {
            0b1000 => at_y(window.max.y),
            0b0100 => at_y(window.min.y),
            0b0010 => at_x(window.max.x),
            _ => at_x(window.min.x),
        };
        if code_a & bit != 0 {
            a = cut;
        } else {
            b = cut;
        }
    }
}
