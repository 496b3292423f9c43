// rejected by any_segment: `add` is not called
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.x.unsigned_abs().max(d.y.unsigned_abs());
    let step = d.as_dvec2() / f64::from(steps.max(1));
    for i in 0..=steps {
        let i = f64::from(i);
        plot(a.x + nearest(i * step.x), a.y + nearest(i * step.y));
    }
}

fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0_f32, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
