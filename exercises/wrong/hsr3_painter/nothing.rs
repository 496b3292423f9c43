// rejected by level_sticks: the order [] has to name each of them once
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
    let _ = sticks;
    Ok(vec![])
}
