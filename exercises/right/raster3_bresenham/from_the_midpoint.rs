// right: 2F worked out anew at each midpoint, no increments
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
    let mut rows = 0;
    for column in 0..dx {
        let decision = 2 * dy * (column + 1) - dx * (2 * rows + 1);
        let pixel = a + IVec2::new(column as i32, rows as i32);
        let choice = [Choice::E, Choice::NE][usize::from(decision > 0)];
        rows += i64::from(decision > 0);
        take(Step {
            pixel,
            decision,
            choice,
        });
    }
}
