// rejected by any_segment: the last pixel is missing
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.x.unsigned_abs().max(d.y.unsigned_abs());
    for i in 0..steps {
        let part = |d: i32| (f64::from(d) * f64::from(i) / f64::from(steps)).abs();
        let near = |d: i32| d.signum() * (part(d) - 0.5).ceil() as i32;
        plot(a.x + near(d.x), a.y + near(d.y));
    }
}
