// right: each pixel by a division, no sum is kept
use glam::IVec2;

fn segment(a: IVec2, b: IVec2, plot: &mut dyn FnMut(i32, i32)) {
    let way = [(a.x, b.x), (a.y, b.y)].map(|(a, b)| i64::from(b) - i64::from(a));
    let run = way[0].abs().max(way[1].abs()).max(1);
    let last = way[0].abs().max(way[1].abs());
    for i in 0..=last {
        let [x, y] = way.map(|d| {
            let twice = 2 * i128::from(i) * i128::from(d.abs());
            let steps = (twice + i128::from(run) - 1) / (2 * i128::from(run));
            d.signum() * steps as i64
        });
        plot((i64::from(a.x) + x) as i32, (i64::from(a.y) + y) as i32);
    }
}
