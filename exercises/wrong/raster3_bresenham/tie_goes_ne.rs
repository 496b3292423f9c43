// rejected by any_segment: d = 0 is a tie
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
    let mut decision = 2 * dy - dx;
    while pixel.x < b.x {
        let choice = if decision < 0 { Choice::E } else { Choice::NE };
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
