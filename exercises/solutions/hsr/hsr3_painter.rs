use glam::DVec3;

/// A stick, from A to B: x and y in the picture, z the distance from the viewer (a parallel view along z).
#[derive(Clone, Copy, Debug)]
struct Stick {
    a: DVec3,
    b: DVec3,
}

/// Whether `front` hides a piece of `back`: they cross in the picture, and there `front` is nearer.
///
/// ```text
/// A + t (B − A) = A' + t' (B' − A')  in x and y,   0 ≤ t, t' ≤ 1          z < z'
/// ```
///
/// Given; nothing is to be done here. Its calls are counted, so that a loop without an end is stopped.
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

/// An order in which a painter can paint the sticks, each over those before it, or why there is none.
///
/// - `Ok`: the index of every stick once, back to front: whatever hides a stick comes after it.
/// - `Err`: a cycle: some of the sticks, each named once, each of which hides the next, and the last hides the first.
///   Whichever of them is painted first will be covered by the one that it should hide.
///
/// The slide sorts by the distance from the viewer. One number a stick is not enough: a long one may be nearer than another as
/// a whole and yet pass behind it.
///
/// Grafica 3, Algoritmo del Pittore (depth-sort), with its question: is there always an order?
fn order(sticks: &[Stick]) -> Result<Vec<usize>, Vec<usize>> {
    let mut left: Vec<usize> = (0..sticks.len()).collect();
    let mut painted = Vec::new();
    while !left.is_empty() {
        // What hides none of the others is behind them all.
        let hides_none = |&i: &usize| !left.iter().any(|&j| hides(&sticks[i], &sticks[j]));
        let Some(at) = left.iter().position(hides_none) else {
            // Every stick left hides another one: follow them until one comes again.
            let mut path = vec![left[0]];
            loop {
                let last = path[path.len() - 1];
                let hidden = left.iter().find(|&&j| hides(&sticks[last], &sticks[j]));
                let next = *hidden.expect("each of those left hides another one");
                if let Some(start) = path.iter().position(|&i| i == next) {
                    return Err(path.split_off(start));
                }
                path.push(next);
            }
        };
        painted.push(left.remove(at));
    }
    Ok(painted)
}

fn main() {}
