use glam::IVec2;

/// The outline of a rectangle: its four sides, each pixel once.
///
/// ```text
/// x_min ≤ x ≤ x_max  and  y_min ≤ y ≤ y_max,  and one of the four is an equality
/// ```
///
/// `min` and `max` are opposite corners and belong to it; a rectangle of one row, one column or one pixel is its own
/// outline. There is none where x_min > x_max or y_min > y_max. Any order of the pixels will do; `plot(x, y)` lights
/// one.
///
/// Grafica 3, Rasterizzazione di Poligoni: four times the algorithm for segments.
fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for x in min.x..=max.x {
        // One row is both sides at once.
        if min.y <= max.y {
            plot(x, min.y);
        }
        if min.y < max.y {
            plot(x, max.y);
        }
    }
    // The corners are plotted.
    for y in min.y.saturating_add(1)..max.y {
        if min.x <= max.x {
            plot(min.x, y);
        }
        if min.x < max.x {
            plot(max.x, y);
        }
    }
}

/// The filled rectangle, each pixel once.
///
/// ```text
/// x_min ≤ x ≤ x_max  and  y_min ≤ y ≤ y_max
/// ```
///
/// With the same corners as the outline.
///
/// Grafica 3, Rasterizzazione di Poligoni: a double loop.
fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            plot(x, y);
        }
    }
}

fn main() {}
