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
    let (dx, dy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let mut pixel = a;
    let mut decision = 2 * dy - dx;
    while pixel.x < b.x {
        let choice = if decision > 0 { Choice::NE } else { Choice::E };
        take(Step {
            pixel,
            decision,
            choice,
        });
        pixel.x += 1;
        decision += 2 * dy;
        if choice == Choice::NE {
            pixel.y += 1;
            decision -= 2 * dx;
        }
    }
}

fn main() {}
