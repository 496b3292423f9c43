// rejected by any_rectangle: its last row and column are missing
use glam::IVec2;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for y in min.y..max.y {
        for x in min.x..max.x {
            if x == min.x || y == min.y || x == max.x - 1 || y == max.y - 1 {
                plot(x, y);
            }
        }
    }
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for y in min.y..max.y {
        for x in min.x..max.x {
            plot(x, y);
        }
    }
}
