// right: a before the loop, then a step and a pixel in turn
use glam::IVec2;

fn add(x: f64, m: f64) -> f64 {
    assess::sum(x, m)
}

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    plot(a.x, a.y);
    let d = b.as_dvec2() - a.as_dvec2();
    let steps = d.abs().max_element();
    let (mx, my) = (d.x / steps, d.y / steps);
    let (mut x, mut y, mut i) = (0.0, 0.0, 0.0);
    while i < steps {
        x = add(x, mx);
        y = add(y, my);
        i += 1.0;
        plot(
            (f64::from(a.x) + half_to_zero(x)) as i32,
            (f64::from(a.y) + half_to_zero(y)) as i32,
        );
    }
}

fn half_to_zero(v: f64) -> f64 {
    if v < 0.0 {
        (v - 0.5)
            .ceil()
            .max((v + 0.5).floor())
            .min(-(-v - 0.5).ceil())
    } else {
        (v - 0.5).ceil()
    }
}

fn drift(m: f32, n: u32) -> f64 {
    let y = (0..n).fold(0.0_f32, |y, _| y + m);
    f64::from(y) - f64::from(n) * f64::from(m)
}
