// right: the sums as an iterator of successors
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.x.unsigned_abs().max(d.y.unsigned_abs());
    let m = d.as_dvec2() / f64::from(steps.max(1));
    let sums = std::iter::successors(Some((0.0, 0.0)), |&(x, y)| Some((add(x, m.x), add(y, m.y))));
    for (x, y) in sums.take(steps as usize + 1) {
        let round = |v: f64| (v.abs() - 0.5).ceil().copysign(v) as i32;
        plot(a.x + round(x), a.y + round(y));
    }
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0_f32, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
