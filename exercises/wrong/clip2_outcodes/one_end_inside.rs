// rejected by any_verdict: one end at least lies outside, so it is not inside
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
    let mut code = 0;
    if p.y > max.y {
        code |= 8;
    }
    if p.y < min.y {
        code |= 4;
    }
    if p.x > max.x {
        code |= 2;
    }
    if p.x < min.x {
        code |= 1;
    }
    code
}

fn verdict(a: u8, b: u8) -> Verdict {
    if a == 0 || b == 0 {
        Verdict::Inside
    } else if a & b != 0 {
        Verdict::Outside
    } else {
        Verdict::Cut
    }
}
