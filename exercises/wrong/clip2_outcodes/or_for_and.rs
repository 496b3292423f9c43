// rejected by any_verdict: AND = 0000, so it is not outside
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
    let sides = [
        (0b1000, p.y > window.max.y),
        (0b0100, p.y < window.min.y),
        (0b0010, p.x > window.max.x),
        (0b0001, p.x < window.min.x),
    ];
    sides
        .iter()
        .map(|&(bit, beyond)| if beyond { bit } else { 0 })
        .sum()
}

fn verdict(a: u8, b: u8) -> Verdict {
    if a | b == 0 {
        Verdict::Inside
    } else if a != 0 && b != 0 {
        Verdict::Outside
    } else {
        Verdict::Cut
    }
}
