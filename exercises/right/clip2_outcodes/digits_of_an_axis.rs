// right: two digits an axis, AND first
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
    use std::cmp::Ordering::{Greater, Less};
    let beyond = |x: f64, min: f64, max: f64| {
        if x.total_cmp(&max) == Greater && x != max {
            2
        } else if x.total_cmp(&min) == Less && x != min {
            1
        } else {
            0
        }
    };
    beyond(p.y, min.y, max.y) << 2 | beyond(p.x, min.x, max.x)
}

fn verdict(a: u8, b: u8) -> Verdict {
    if a & b > 0 {
        return Verdict::Outside;
    }
    if a == 0 && b == 0 {
        return Verdict::Inside;
    }
    Verdict::Cut
}
