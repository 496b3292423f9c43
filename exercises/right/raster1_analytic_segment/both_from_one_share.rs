// right: both coordinates from the share of the way, rounded towards the start by `round_ties`
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b.as_dvec2() - a.as_dvec2();
    let steps = d.abs().max_element() as i64;
    for i in 0..=steps {
        let share = |d: f64| {
            let exact = if steps == 0 {
                0.0
            } else {
                d * i as f64 / steps as f64
            };
            let (low, high) = (exact.trunc(), exact.trunc() + exact.signum());
            if (exact - low).abs() <= (high - exact).abs() {
                low
            } else {
                high
            }
        };
        plot(
            (f64::from(a.x) + share(d.x)) as i32,
            (f64::from(a.y) + share(d.y)) as i32,
        );
    }
}
