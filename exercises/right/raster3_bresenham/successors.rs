// right: states as an iterator of successors
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
    let step = |pixel: IVec2, decision: i64| Step {
        pixel,
        decision,
        choice: if decision > 0 { Choice::NE } else { Choice::E },
    };
    let next = |last: &Step| match last.choice {
        Choice::E => Some(step(last.pixel + IVec2::X, last.decision + 2 * dy)),
        Choice::NE => Some(step(
            last.pixel + IVec2::ONE,
            last.decision + 2 * dy - 2 * dx,
        )),
    };
    let all = std::iter::successors(Some(step(a, 2 * dy - dx)), next);
    all.take(dx as usize).for_each(take);
}
