// rejected by any_segment: max(|dx|, |dy|) steps lead from a to b
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = (b - a).as_dvec2();
    let steps = d.length().round();
    let step = d / steps.max(1.0);
    let mut offset = 0.0 * d;
    for _ in 0..=steps as i32 {
        plot(a.x + nearest(offset.x), a.y + nearest(offset.y));
        offset.x = add(offset.x, step.x);
        offset.y = add(offset.y, step.y);
    }
}

fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
