// rejected by nothing_inside: test AND in every round
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn outcode(window: Window, p: DVec2) -> u8 {
    let beyond = [
        p.y > window.max.y,
        p.y < window.min.y,
        p.x > window.max.x,
        p.x < window.min.x,
    ];
    beyond
        .into_iter()
        .fold(0, |code, bit| 2 * code + u8::from(bit))
}

fn cut(window: Window, a: DVec2, b: DVec2, bit: u8) -> DVec2 {
    let d = b - a;
    let at_y = |y| DVec2::new(a.x + (y - a.y) / d.y * d.x, y);
    let at_x = |x| DVec2::new(x, a.y + (x - a.x) / d.x * d.y);
    match bit {
        0b1000 => at_y(window.max.y),
        0b0100 => at_y(window.min.y),
        0b0010 => at_x(window.max.x),
        _ => at_x(window.min.x),
    }
}

fn clip(
    window: Window,
    mut a: DVec2,
    mut b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    if outcode(window, a) & outcode(window, b) != 0 {
        round(a, b);
        return None;
    }
    loop {
        round(a, b);
        let (code_a, code_b) = (outcode(window, a), outcode(window, b));
        if code_a | code_b == 0 {
            return Some((a, b));
        }
        let differ = if code_a == code_b {
            code_a
        } else {
            code_a ^ code_b
        };
        let bit = 1 << differ.ilog2();
        let p = cut(window, a, b, bit);
        if code_a & bit != 0 {
            a = p;
        } else {
            b = p;
        }
    }
}
