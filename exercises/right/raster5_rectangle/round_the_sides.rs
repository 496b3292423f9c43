// right: once round, each side without its last corner, in i64
use glam::IVec2;

fn outline(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let (x0, y0) = (i64::from(min.x), i64::from(min.y));
    let (x1, y1) = (i64::from(max.x), i64::from(max.y));
    if x0 > x1 || y0 > y1 {
        return;
    }
    let mut put = |x: i64, y: i64| plot(x as i32, y as i32);
    if x0 == x1 {
        return (y0..=y1).for_each(|y| put(x0, y));
    }
    if y0 == y1 {
        return (x0..=x1).for_each(|x| put(x, y0));
    }
    (x0..x1).for_each(|x| put(x, y0));
    (y0..y1).for_each(|y| put(x1, y));
    (x0 + 1..=x1).rev().for_each(|x| put(x, y1));
    (y0 + 1..=y1).rev().for_each(|y| put(x0, y));
}

fn fill(min: IVec2, max: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let mut y = i64::from(min.y);
    while y <= i64::from(max.y) {
        let mut x = i64::from(min.x);
        while x <= i64::from(max.x) {
            plot(x as i32, y as i32);
            x += 1;
        }
        y += 1;
    }
}
