//! Which primitives lead to each other, each hiding part of the next: of these no order by pairs is one.

/// The number of the ring each node is in: nodes that lead to each other have the same. Of two rings
/// of which one leads to the other, that one has the lower number.
///
/// S. R. Kosaraju's way: from the node that was done last, going backwards reaches what also leads to it.
pub(crate) fn rings(next: &[Vec<usize>]) -> Vec<usize> {
    let mut before = vec![Vec::new(); next.len()];
    for (i, next) in next.iter().enumerate() {
        for &j in next {
            before[j].push(i);
        }
    }
    let mut done = Vec::with_capacity(next.len());
    let mut is_met = vec![false; next.len()];
    for start in 0..next.len() {
        walk(next, start, &mut is_met, |node| done.push(node));
    }
    let mut ring = vec![0; next.len()];
    is_met.fill(false);
    for (number, &start) in done.iter().rev().enumerate() {
        walk(&before, start, &mut is_met, |node| ring[node] = number);
    }
    ring
}

/// Walks depth first from `start` to all nodes not met yet; says of each when all after it are done.
fn walk(next: &[Vec<usize>], start: usize, is_met: &mut [bool], mut done: impl FnMut(usize)) {
    if core::mem::replace(&mut is_met[start], true) {
        return;
    }
    let mut path = vec![(start, next[start].iter())];
    while let Some((node, rest)) = path.last_mut() {
        match rest.find(|&&other| !is_met[other]) {
            Some(&other) => {
                is_met[other] = true;
                path.push((other, next[other].iter()));
            }
            None => {
                done(*node);
                path.pop();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By reaching: i and j are in one ring if each leads to the other.
    #[test]
    fn rings_are_what_leads_to_each_other() {
        let mut state = 12_345u64;
        for n in [0, 1, 2, 5, 9].into_iter().cycle().take(200) {
            let mut next = vec![Vec::new(); n];
            for (i, next) in next.iter_mut().enumerate() {
                for j in 0..n {
                    state = state
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1);
                    if j != i && state >> 61 == 0 {
                        next.push(j);
                    }
                }
            }
            let mut leads: Vec<Vec<bool>> = (0..n)
                .map(|i| (0..n).map(|j| i == j || next[i].contains(&j)).collect())
                .collect();
            for k in 0..n {
                for i in 0..n {
                    for j in 0..n {
                        leads[i][j] |= leads[i][k] && leads[k][j];
                    }
                }
            }
            let rings = rings(&next);
            for i in 0..n {
                for j in 0..n {
                    assert_eq!(rings[i] == rings[j], leads[i][j] && leads[j][i], "{next:?}");
                }
            }
        }
    }
}
