// rejected by known_segment: no pixel is plotted
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let d = b - a;
    // From the smaller to the larger index, whichever that is.
    for x in a.x..a.x {
        plot(x, a.y + d.y);
    }
}
