// right: the outline is what the filled one has on a side
use glam::IVec2;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    fill(min, max, &mut |x, y| {
        if x == min.x || x == max.x || y == min.y || y == max.y {
            plot(x, y);
        }
    });
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let columns = min.x..=max.x;
    (min.y..=max.y).for_each(|y| columns.clone().for_each(|x| plot(x, y)));
}
