// right: recursion, the side by ilog2
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn outcode(window: Window, p: DVec2) -> u8 {
    assess::counted("outcode");
    u8::from(p.y > window.max.y) << 3
        | u8::from(p.y < window.min.y) << 2
        | u8::from(p.x > window.max.x) << 1
        | u8::from(p.x < window.min.x)
}

fn clip(
    window: Window,
    a: DVec2,
    b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    round(a, b);
    let codes = (outcode(window, a), outcode(window, b));
    match codes {
        (0, 0) => return Some((a, b)),
        (p, q) if p & q != 0 => return None,
        _ => {}
    }
    let bit = 1 << (codes.0 ^ codes.1).ilog2();
    let (axis, side) = match bit {
        8 => (1, window.max.y),
        4 => (1, window.min.y),
        2 => (0, window.max.x),
        _ => (0, window.min.x),
    };
    let t = (side - b[axis]) / (a[axis] - b[axis]);
    let mut p = b + t * (a - b);
    p[axis] = side;
    if codes.0 & bit != 0 {
        clip(window, p, b, round)
    } else {
        clip(window, a, p, round)
    }
}
