// rejected by any_segment: the sum itself was rounded
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.abs().max_element();
    let step = d.as_dvec2() / f64::from(steps.max(1));
    let (mut x, mut y) = (f64::from(a.x), f64::from(a.y));
    for _ in 0..=steps {
        plot(x as i32, y as i32);
        x = add(x, step.x).round();
        y = add(y, step.y).round();
    }
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
