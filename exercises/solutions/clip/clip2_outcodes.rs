use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// What the codes of two ends say about a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    /// It lies in the window.
    Inside,
    /// It lies beyond one of the sides.
    Outside,
    /// The codes do not tell: it must be cut.
    Cut,
}

/// The code of the region in which a point lies: four binary digits, read from left to right.
///
/// ```text
/// 1001 │ 1000 │ 1010          1st  1000   above the upper side    y > y_max
/// ─────┼──────┼─────          2nd  0100   below the lower side    y < y_min
/// 0001 │ 0000 │ 0010          3rd  0010   right of the right side x > x_max
/// ─────┼──────┼─────          4th  0001   left of the left side   x < x_min
/// 0101 │ 0100 │ 0110
/// ```
///
/// In a window y points up. The border is inside. Coordinates are not NaN.
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn outcode(window: Window, p: DVec2) -> u8 {
    let mut code = 0;
    if p.y > window.max.y {
        code |= 0b1000;
    }
    if p.y < window.min.y {
        code |= 0b0100;
    }
    if p.x > window.max.x {
        code |= 0b0010;
    }
    if p.x < window.min.x {
        code |= 0b0001;
    }
    code
}

/// What the codes of its two ends say about a segment.
///
/// ```text
/// OR of the codes = 0000     inside: no end lies beyond any side
/// AND of the codes ≠ 0000    outside: both ends lie beyond the same side
/// else                       cut
/// ```
///
/// Grafica 3, Algoritmo Cohen-Sutherland.
fn verdict(a: u8, b: u8) -> Verdict {
    if a | b == 0 {
        Verdict::Inside
    } else if a & b != 0 {
        Verdict::Outside
    } else {
        Verdict::Cut
    }
}

fn main() {}
