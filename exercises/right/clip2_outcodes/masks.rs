// right: masks of vector comparisons, digit by digit
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
    let above = p.cmpgt(max).bitmask() as u8;
    let below = p.cmplt(min).bitmask() as u8;
    (above >> 1) << 3 | (below >> 1) << 2 | (above & 1) << 1 | below & 1
}

fn verdict(a: u8, b: u8) -> Verdict {
    if (0..4).any(|k| a >> k & b >> k & 1 == 1) {
        Verdict::Outside
    } else if a + b > 0 {
        Verdict::Cut
    } else {
        Verdict::Inside
    }
}
