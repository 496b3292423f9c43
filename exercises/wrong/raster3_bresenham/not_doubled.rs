// rejected by any_segment: d starts with F itself
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
    let mut decision = dy - dx / 2;
    while pixel.x < b.x {
        let choice = if decision > 0 { Choice::NE } else { Choice::E };
        take(Step {
            pixel,
            decision,
            choice,
        });
        pixel.x += 1;
        decision += dy;
        if choice == Choice::NE {
            pixel.y += 1;
            decision -= dx;
        }
    }
}
