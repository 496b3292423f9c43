// right: the slide's formula, the product first, four ifs
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn outcode(window: Window, p: DVec2) -> u8 {
    let mut code = 0;
    if p.y > window.max.y {
        code |= 8;
    }
    if p.y < window.min.y {
        code |= 4;
    }
    if p.x > window.max.x {
        code |= 2;
    }
    if p.x < window.min.x {
        code |= 1;
    }
    code
}

fn clip(
    window: Window,
    a: DVec2,
    b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    let (mut a, mut b) = (a, b);
    round(a, b);
    let (mut ca, mut cb) = (outcode(window, a), outcode(window, b));
    while ca | cb != 0 {
        if ca & cb != 0 {
            return None;
        }
        let mx = (b.x - a.x) / (b.y - a.y);
        let my = (b.y - a.y) / (b.x - a.x);
        let differ = ca ^ cb;
        let (bit, p) = if differ & 8 != 0 {
            (8, DVec2::new(a.x + (window.max.y - a.y) * mx, window.max.y))
        } else if differ & 4 != 0 {
            (4, DVec2::new(a.x + (window.min.y - a.y) * mx, window.min.y))
        } else if differ & 2 != 0 {
            (2, DVec2::new(window.max.x, a.y + (window.max.x - a.x) * my))
        } else {
            (1, DVec2::new(window.min.x, a.y + (window.min.x - a.x) * my))
        };
        if ca & bit != 0 {
            a = p;
            ca = outcode(window, a);
        } else {
            b = p;
            cb = outcode(window, b);
        }
        round(a, b);
    }
    Some((a, b))
}
