// right: shifts, and a match
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Inside,
    Outside,
    Cut,
}

fn outcode(window: Window, p: DVec2) -> u8 {
    let Window { min, max } = window;
    u8::from(p.y > max.y) << 3
        | u8::from(p.y < min.y) << 2
        | u8::from(p.x > max.x) << 1
        | u8::from(p.x < min.x)
}

fn verdict(a: u8, b: u8) -> Verdict {
    match (a & b, a | b) {
        (_, 0) => Verdict::Inside,
        (0, _) => Verdict::Cut,
        _ => Verdict::Outside,
    }
}
