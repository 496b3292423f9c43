// rejected by one_pixel: m = 0 / 0 is not a number
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    if d.x.abs() >= d.y.abs() {
        let m = f64::from(d.y) / f64::from(d.x);
        for i in 0..=d.x.abs() {
            let x = a.x + i * d.x.signum();
            plot(x, nearest(m * f64::from(x - a.x) + f64::from(a.y), a.y));
        }
    } else {
        for i in 0..=d.y.abs() {
            let y = a.y + i * d.y.signum();
            let x = f64::from(d.x) / f64::from(d.y) * f64::from(y - a.y) + f64::from(a.x);
            plot(nearest(x, a.x), y);
        }
    }
}

fn nearest(value: f64, start: i32) -> i32 {
    if value > f64::from(start) {
        (value - 0.5).ceil() as i32
    } else {
        (value + 0.5).floor() as i32
    }
}
