// right: the front stick is looked for, the order filled from its end
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
struct Stick {
    a: DVec3,
    b: DVec3,
}

fn hides(front: &Stick, back: &Stick) -> bool {
    assess::counted("hides");
    let (u, v) = (front.b - front.a, back.b - back.a);
    let across = u.truncate().perp_dot(v.truncate());
    let between = (back.a - front.a).truncate();
    let t = between.perp_dot(v.truncate()) / across;
    let t_back = between.perp_dot(u.truncate()) / across;
    let on_both = across != 0.0 && (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&t_back);
    on_both && front.a.z + t * u.z < back.a.z + t_back * v.z
}

fn order(sticks: &[Stick]) -> Result<Vec<usize>, Vec<usize>> {
    let n = sticks.len();
    let mut left: Vec<usize> = (0..n).rev().collect();
    let mut out = std::collections::VecDeque::new();
    while !left.is_empty() {
        let Some(at) = left
            .iter()
            .rposition(|&i| left.iter().all(|&j| !hides(&sticks[j], &sticks[i])))
        else {
            let mut c = vec![left[0]];
            loop {
                let first = c[0];
                let above = *left
                    .iter()
                    .find(|&&j| hides(&sticks[j], &sticks[first]))
                    .unwrap();
                if let Some(e) = c.iter().position(|&k| k == above) {
                    c.truncate(e + 1);
                    c.rotate_right(1);
                    return Err(c);
                }
                c.insert(0, above);
            }
        };
        out.push_front(left.remove(at));
    }
    Ok(out.into())
}
