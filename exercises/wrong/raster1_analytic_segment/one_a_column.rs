// rejected by any_segment: one pixel a column leaves gaps
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    if d.x == 0 {
        for i in 0..=d.y.abs() {
            plot(a.x, a.y + i * d.y.signum());
        }
        return;
    }
    let m = f64::from(d.y) / f64::from(d.x);
    for i in 0..=d.x.abs() {
        let x = i * d.x.signum();
        plot(a.x + x, a.y + nearest(m * f64::from(x)));
    }
}

fn nearest(offset: f64) -> i32 {
    (offset.signum() * (offset.abs() - 0.5).ceil()) as i32
}
