// rejected by any_rectangle: x and y are exchanged
use glam::IVec2;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for x in min.x..=max.x {
        // One row is both sides at once.
        if min.y <= max.y {
            plot(min.y, x);
        }
        if min.y < max.y {
            plot(max.y, x);
        }
    }
    // The corners are plotted.
    for y in min.y.saturating_add(1)..max.y {
        if min.x <= max.x {
            plot(y, min.x);
        }
        if min.x < max.x {
            plot(y, max.x);
        }
    }
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            plot(y, x);
        }
    }
}
