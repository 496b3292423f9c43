// right: four sides into a set, which keeps each pixel once
use glam::IVec2;
use std::collections::BTreeSet;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let mut pixels = BTreeSet::new();
    if min.y <= max.y {
        pixels.extend((min.x..=max.x).flat_map(|x| [(x, min.y), (x, max.y)]));
    }
    if min.x <= max.x {
        pixels.extend((min.y..=max.y).flat_map(|y| [(min.x, y), (max.x, y)]));
    }
    for (x, y) in pixels {
        plot(x, y);
    }
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for x in min.x..=max.x {
        for y in min.y..=max.y {
            plot(x, y);
        }
    }
}
