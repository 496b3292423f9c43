// right: counts of what each hides, without a search
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
    let over: Vec<Vec<bool>> = (0..n)
        .map(|i| {
            (0..n)
                .map(|j| i != j && hides(&sticks[i], &sticks[j]))
                .collect()
        })
        .collect();
    let mut hidden: Vec<usize> = (0..n)
        .map(|i| over[i].iter().filter(|&&h| h).count())
        .collect();
    let mut ready: Vec<usize> = (0..n).filter(|&i| hidden[i] == 0).collect();
    let mut out = vec![];
    while let Some(j) = ready.pop() {
        out.push(j);
        for i in 0..n {
            if over[i][j] {
                hidden[i] -= 1;
                if hidden[i] == 0 {
                    ready.push(i);
                }
            }
        }
    }
    if out.len() == n {
        return Ok(out);
    }
    let mut at = (0..n).find(|i| !out.contains(i)).unwrap();
    let mut seen = vec![];
    while !seen.contains(&at) {
        seen.push(at);
        at = (0..n).find(|&j| over[at][j] && !out.contains(&j)).unwrap();
    }
    let start = seen.iter().position(|&k| k == at).unwrap();
    Err(seen.drain(start..).collect())
}
