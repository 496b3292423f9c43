// rejected by any_segment: d starts with F at a
use glam::IVec2;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Choice {
    E,
    NE,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Step {
    pixel: IVec2,
    decision: i64,
    choice: Choice,
}

fn trace(a: IVec2, b: IVec2, take: &mut dyn FnMut(Step)) {
    let (dx, dy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let mut pixel = a;
    let mut decision = 0;
    for _ in 0..dx {
        if decision > 0 {
            take(Step {
                pixel,
                decision,
                choice: Choice::NE,
            });
            decision += 2 * dy - 2 * dx;
            pixel += IVec2::ONE;
        } else {
            take(Step {
                pixel,
                decision,
                choice: Choice::E,
            });
            decision += 2 * dy;
            pixel += IVec2::X;
        }
    }
}
