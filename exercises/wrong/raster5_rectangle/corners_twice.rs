// rejected by any_rectangle: two sides meet there, and one has it
use glam::IVec2;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    if min.x == max.x || min.y == max.y {
        return fill(min, max, plot);
    }
    if min.x > max.x || min.y > max.y {
        return;
    }
    for x in min.x..=max.x {
        plot(x, min.y);
        plot(x, max.y);
    }
    for y in min.y..=max.y {
        plot(min.x, y);
        plot(max.x, y);
    }
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            plot(x, y);
        }
    }
}
