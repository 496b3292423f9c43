// right: depth first, a stick after all that it hides
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
    fn visit(
        i: usize,
        sticks: &[Stick],
        state: &mut [u8],
        path: &mut Vec<usize>,
        out: &mut Vec<usize>,
    ) -> Result<(), Vec<usize>> {
        match state[i] {
            2 => return Ok(()),
            1 => {
                let at = path.iter().position(|&k| k == i).unwrap();
                return Err(path[at..].to_vec());
            }
            _ => {}
        }
        state[i] = 1;
        path.push(i);
        for j in 0..sticks.len() {
            if j != i && hides(&sticks[i], &sticks[j]) {
                visit(j, sticks, state, path, out)?;
            }
        }
        path.pop();
        state[i] = 2;
        out.push(i);
        Ok(())
    }
    let mut state = vec![0; sticks.len()];
    let (mut path, mut out) = (vec![], vec![]);
    for i in 0..sticks.len() {
        visit(i, sticks, &mut state, &mut path, &mut out)?;
    }
    Ok(out)
}
