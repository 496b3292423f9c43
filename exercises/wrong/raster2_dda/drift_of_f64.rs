// rejected by any_drift: so little comes from sums in f64
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.abs().max_element();
    let step = d.as_dvec2() / f64::from(steps.max(1));
    let mut offset = 0.0 * step;
    for _ in 0..=steps {
        plot(a.x + nearest(offset.x), a.y + nearest(offset.y));
        offset.x = add(offset.x, step.x);
        offset.y = add(offset.y, step.y);
    }
}

fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}

fn drift(m: f32, n: u32) -> f64 {
    let m = f64::from(m);
    let mut y = 0.0;
    for _ in 0..n {
        y += m;
    }
    y - f64::from(n) * m
}
