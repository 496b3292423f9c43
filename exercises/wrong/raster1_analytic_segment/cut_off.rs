// rejected by any_segment: `as i32` and `floor` cut off
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    let steps = d.abs().max_element().max(1);
    let (mx, my) = (
        f64::from(d.x) / f64::from(steps),
        f64::from(d.y) / f64::from(steps),
    );
    for i in 0..=d.abs().max_element() {
        plot(
            a.x + (mx * f64::from(i)) as i32,
            a.y + (my * f64::from(i)) as i32,
        );
    }
}
