// rejected by ties: the line passes halfway between two pixels
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    if a == b {
        return plot(a.x, a.y);
    }
    let d = (b - a).as_dvec2();
    let steps = (b - a).abs().max_element();
    for i in 0..=steps {
        let t = f64::from(i) / f64::from(steps);
        plot(
            a.x + (d.x * t).round() as i32,
            a.y + (d.y * t).round() as i32,
        );
    }
}
