// right: from the end that is inside, with fma
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

fn clip(
    window: Window,
    a: DVec2,
    b: DVec2,
    round: &mut dyn FnMut(DVec2, DVec2),
) -> Option<(DVec2, DVec2)> {
    let mut ends = [a, b];
    loop {
        round(ends[0], ends[1]);
        let codes = ends.map(|p| outcode(window, p));
        if codes == [0, 0] {
            return Some((ends[0], ends[1]));
        } else if codes[0] & codes[1] > 0 {
            return None;
        }
        let bit = (0..4)
            .rev()
            .map(|k| 1 << k)
            .find(|bit| (codes[0] ^ codes[1]) & bit > 0)?;
        let out = usize::from(codes[1] & bit > 0);
        let (p, q) = (ends[1 - out], ends[out]);
        let x = |y: f64| ((q.x - p.x) / (q.y - p.y)).mul_add(y - p.y, p.x);
        let y = |x: f64| ((q.y - p.y) / (q.x - p.x)).mul_add(x - p.x, p.y);
        ends[out] = match bit {
            8 => DVec2::new(x(window.max.y), window.max.y),
            4 => DVec2::new(x(window.min.y), window.min.y),
            2 => DVec2::new(window.max.x, y(window.max.x)),
            _ => DVec2::new(window.min.x, y(window.min.x)),
        };
    }
}
