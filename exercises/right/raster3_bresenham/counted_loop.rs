// right: a loop over the moves, the increments worked out before it
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
    let dx = i64::from(b.x) - i64::from(a.x);
    let dy = i64::from(b.y) - i64::from(a.y);
    let (east, north_east) = (2 * dy, 2 * (dy - dx));
    let (mut decision, mut y) = (east - dx, a.y);
    for x in a.x..b.x {
        let pixel = IVec2::new(x, y);
        if decision <= 0 {
            take(Step {
                pixel,
                decision,
                choice: Choice::E,
            });
            decision += east;
        } else {
            take(Step {
                pixel,
                decision,
                choice: Choice::NE,
            });
            decision += north_east;
            y += 1;
        }
    }
}
