// rejected by ties: the line passes halfway between two pixels
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.abs().max_element();
    let step = d.as_dvec2() / f64::from(steps.max(1));
    let mut p = a.as_dvec2();
    for _ in 0..=steps {
        plot(p.x.round() as i32, p.y.round() as i32);
        p.x = add(p.x, step.x);
        p.y = add(p.y, step.y);
    }
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
