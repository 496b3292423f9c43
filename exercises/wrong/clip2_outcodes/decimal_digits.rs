// rejected by nine_regions: the slide's 1000 is 0b1000 in Rust
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
    let mut code = 0u16;
    if p.y > max.y {
        code |= 1000;
    }
    if p.y < min.y {
        code |= 100;
    }
    if p.x > max.x {
        code |= 10;
    }
    if p.x < min.x {
        code |= 1;
    }
    code as u8
}

fn verdict(a: u8, b: u8) -> Verdict {
    if a | b == 0 {
        Verdict::Inside
    } else if a & b != 0 {
        Verdict::Outside
    } else {
        Verdict::Cut
    }
}
