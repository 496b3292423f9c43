// right: the slide's four cases in a match, the crossing as a weighted mean
use glam::{DVec2, DVec3};

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    let s = |p: &DVec2| line.z + line.truncate().dot(*p);
    let next = polygon.iter().cycle().skip(1);
    let put: Vec<DVec2> = polygon
        .iter()
        .zip(next)
        .flat_map(|(a, b)| {
            let (sa, sb) = (s(a), s(b));
            let crossing = (*b * sa - *a * sb) / (sa - sb);
            match (sa >= 0.0, sb >= 0.0) {
                (true, true) => vec![*b],
                (true, false) if sa > 0.0 => vec![crossing],
                (true, false) => vec![],
                (false, true) if sb > 0.0 => vec![crossing, *b],
                (false, true) => vec![*b],
                (false, false) => vec![],
            }
        })
        .collect();
    if put.len() < 3 { Vec::new() } else { put }
}

fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let Window { min, max } = window;
    [
        DVec3::new(1.0, 0.0, -min.x),
        DVec3::new(0.0, 1.0, -min.y),
        DVec3::new(-1.0, 0.0, max.x),
        DVec3::new(0.0, -1.0, max.y),
    ]
    .iter()
    .fold(polygon.to_vec(), |p, &line| clip_against_line(&p, line))
}
