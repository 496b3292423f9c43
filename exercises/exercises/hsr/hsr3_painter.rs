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
    // TODO: which stick can be painted first? and when can none?
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod hsr3_painter {
    use super::{Stick, order};
    use assess::{Inputs, brief, painted_sticks, watched, within_calls};
    use glam::DVec3;

    fn stick(a: (f64, f64, f64), b: (f64, f64, f64)) -> Stick {
        Stick {
            a: DVec3::from(a),
            b: DVec3::from(b),
        }
    }

    fn name(sticks: &[Stick]) -> String {
        let each = sticks.iter().enumerate().take(6);
        let each = each.map(|(i, s)| format!("{i}: {} to {}", brief(s.a), brief(s.b)));
        let each = each.collect::<Vec<_>>().join(", ");
        match sticks.len() {
            0..=6 => format!("sticks {each}"),
            all => format!("{all} sticks, {each}, …"),
        }
    }

    /// The first of some indices.
    fn few(indices: &[usize]) -> String {
        let first: Vec<String> = indices.iter().take(12).map(usize::to_string).collect();
        let more = if indices.len() > 12 { ", …" } else { "" };
        format!("[{}{more}]", first.join(", "))
    }

    /// The answer. Looking at each pair once for each stick painted, and for a cycle, is n³ + n² calls of `hides`.
    fn ordered(sticks: &[Stick]) -> Result<Vec<usize>, Vec<usize>> {
        let n = sticks.len();
        let because = "Where sticks hide each other in a ring there is no order, and the search for one has to end.";
        let all = sticks.to_vec();
        watched(&name(sticks), move || {
            within_calls(8 * n * n * n + 1000, because, || order(&all))
        })
    }

    fn picture(sticks: &[Stick], painted: &[usize]) -> assess::Picture {
        let ends: Vec<_> = sticks.iter().map(|s| [s.a, s.b]).collect();
        painted_sticks(&ends, painted)
    }

    /// A level stick at the depth z whose ends lie on two sides of a square about the origin: any two of them cross or not.
    fn level(inputs: &mut Inputs, z: f64) -> Stick {
        let mut at = || f64::from(inputs.integer(-19, 19));
        let [s, t] = [at(), at() + 0.5];
        let (a, b) = if s as i32 % 2 == 0 {
            ((s, -20.0), (t, 20.0))
        } else {
            ((-20.0, s), (20.0, t))
        };
        stick((a.0, a.1, z), (b.0, b.1, z))
    }

    /// Whether i hides j, as z = n/d with a common d: worked out apart from the function above the line.
    fn is_over(i: &Stick, j: &Stick) -> bool {
        let flat = |p: DVec3, q: DVec3, r: DVec3| (q - p).truncate().perp_dot((r - p).truncate());
        // Each stick's ends on two sides of the other.
        let (c, d) = (flat(i.a, i.b, j.a), flat(i.a, i.b, j.b));
        let (e, f) = (flat(j.a, j.b, i.a), flat(j.a, j.b, i.b));
        if c * d > 0.0 || e * f > 0.0 || c == d {
            return false;
        }
        // Weighted with the distances of the ends from the other stick; both weights add up to the same.
        let (front, back) = (
            (i.a.z * f - i.b.z * e) / (f - e),
            (j.a.z * d - j.b.z * c) / (d - c),
        );
        front < back
    }

    /// Fails unless `painted` has each stick once; tells the first two in the wrong order.
    fn first_mistake(sticks: &[Stick], painted: &[usize]) -> Option<(usize, usize)> {
        let mut sorted = painted.to_vec();
        sorted.sort_unstable();
        assert!(
            sorted == (0..sticks.len()).collect::<Vec<_>>(),
            "{}: the order {} has to name each of them once",
            name(sticks),
            few(painted),
        );
        let pairs = (0..painted.len()).flat_map(|q| (0..q).map(move |p| (painted[p], painted[q])));
        pairs
            .into_iter()
            .find(|&(early, late)| is_over(&sticks[early], &sticks[late]))
    }

    fn painted(sticks: &[Stick]) -> Vec<usize> {
        ordered(sticks).unwrap_or_else(|cycle| {
            panic!(
                "{}: these can be painted, but got the cycle {}",
                name(sticks),
                few(&cycle)
            )
        })
    }

    /// Two level sticks that cross: is the nearer one painted last?
    fn is_back_to_front() -> bool {
        let cross = [
            stick((-1.0, 0.0, 2.0), (1.0, 0.0, 2.0)),
            stick((0.0, -1.0, 5.0), (0.0, 1.0, 5.0)),
        ];
        painted(&cross) == [1, 0]
    }

    /// A short stick, and a long one that is nearer on the whole and passes behind it: at x = 9 of 0 … 10.
    fn looks_at_the_crossing(inputs: &mut Inputs) -> Result<(), String> {
        let by = inputs.whole_vector(-50, 50);
        let short = stick((9.0, -1.0, 8.0), (9.0, 1.0, 8.0));
        let long = stick((0.0, 0.0, 0.0), (10.0, 0.0, 10.0));
        let moved = [short, long].map(|s| Stick {
            a: s.a + by,
            b: s.b + by,
        });
        let got = painted(&moved);
        if got == [1, 0] || !is_back_to_front() {
            return Ok(());
        }
        Err(format!(
            "{}: got {got:?}. 1 has the smaller mean distance, but where they cross it is at z = {}, behind 0 at {}: what \
             counts is the depth at the crossing, not one number for a whole stick",
            name(&moved),
            9.0 + by.z,
            8.0 + by.z,
        ))
    }

    fn check_cycle(sticks: &[Stick], inputs: &mut Inputs) {
        let what = name(sticks);
        let cycle = match ordered(sticks) {
            Err(cycle) => cycle,
            Ok(got) => {
                if let Err(mistake) = looks_at_the_crossing(inputs) {
                    panic!("{mistake}");
                }
                let _picture = picture(sticks, &got);
                panic!(
                    "{what}: no order exists, for they hide each other in a ring, but got {}",
                    few(&got)
                );
            }
        };
        assert!(
            cycle.len() > 1 && cycle.iter().all(|&i| i < sticks.len()),
            "{what}: {} is no cycle of these sticks",
            few(&cycle)
        );
        let _picture = picture(sticks, &cycle);
        let mut named = cycle.clone();
        named.sort_unstable();
        named.dedup();
        assert!(
            named.len() == cycle.len(),
            "{what}: got {}, but a cycle names each of its sticks once: it ends before the first comes again",
            few(&cycle),
        );
        let hides_next = |cycle: &[usize]| {
            let next = cycle.iter().cycle().skip(1);
            cycle
                .iter()
                .zip(next)
                .all(|(&i, &j)| is_over(&sticks[i], &sticks[j]))
        };
        let turned: Vec<usize> = cycle.iter().rev().copied().collect();
        assert!(
            !hides_next(&turned) || hides_next(&cycle),
            "{what}: got the cycle {} back to front: each must hide the next, here each is hidden by it",
            few(&cycle),
        );
        for (k, &i) in cycle.iter().enumerate() {
            let next = cycle[(k + 1) % cycle.len()];
            assert!(
                is_over(&sticks[i], &sticks[next]),
                "{what}: got the cycle {}, but {i} does not hide {next}: a cycle names those alone of which each hides \
                 the next, not all that are left, and in that order",
                few(&cycle),
            );
        }
    }

    /// n sticks round a regular figure, each from under the one before to over the one after.
    fn ring(n: usize) -> Vec<Stick> {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            DVec3::new(10.0 * angle.cos(), 10.0 * angle.sin(), 0.0)
        };
        let side = |k: usize| {
            let (p, q) = (corner(k), corner(k + 1));
            // A quarter longer at both ends; farther at its start, where the one before lies over it.
            let over = 0.25 * (q - p);
            Stick {
                a: p - over + DVec3::Z,
                b: q + over - DVec3::Z,
            }
        };
        (0..n).map(side).collect()
    }

    #[test]
    fn three_sticks_in_a_cycle() {
        let sticks = [
            stick((0.0, 0.0, 3.0), (12.0, 0.0, 1.0)),
            stick((10.0, -2.0, 3.0), (4.0, 10.0, 1.0)),
            stick((8.0, 10.0, 3.0), (2.0, -2.0, 1.0)),
        ];
        // Corners (9,0), (6,6), (3,0): 0 is over 1 at the first, 1 over 2, 2 over 0.
        let mut inputs = Inputs::new(61);
        check_cycle(&sticks, &mut inputs);
        for missing in 0..3 {
            let mut two = sticks.to_vec();
            two.remove(missing);
            let got = painted(&two);
            let what = name(&two);
            if let Err(mistake) = looks_at_the_crossing(&mut inputs) {
                panic!("{mistake}");
            }
            if let Some((early, late)) = first_mistake(&two, &got) {
                let _picture = picture(&two, &got);
                panic!(
                    "{what}: without the third there is an order, but in {} stick {early} hides {late} and comes first",
                    few(&got)
                );
            }
        }
    }

    #[test]
    fn level_sticks() {
        let mut inputs = Inputs::new(62);
        for count in [2, 3, 5, 9].into_iter().flat_map(|count| [count; 25]) {
            let sticks: Vec<_> = (0..count)
                .map(|_| {
                    let z = f64::from(inputs.integer(1, 1000));
                    level(&mut inputs, z)
                })
                .collect();
            let got = painted(&sticks);
            if let Some((early, late)) = first_mistake(&sticks, &got) {
                let what = name(&sticks);
                let _picture = picture(&sticks, &got);
                let got = few(&got);
                assert!(
                    is_back_to_front(),
                    "{what}: got {got}, but {early} hides {late}. The painter goes back to front: the farthest is painted \
                     first, so that the nearer ones cover it",
                );
                panic!("{what}: got {got}, but {early} hides {late} and is painted before it");
            }
        }
    }

    #[test]
    fn not_by_one_distance() {
        let mut inputs = Inputs::new(63);
        for _ in 0..20 {
            if let Err(mistake) = looks_at_the_crossing(&mut inputs) {
                panic!("{mistake}");
            }
        }
    }

    #[test]
    fn slanted_sticks() {
        let mut inputs = Inputs::new(64);
        for count in [2, 4, 8].into_iter().flat_map(|count| [count; 50]) {
            let mut sticks: Vec<_> = (0..count).map(|_| level(&mut inputs, 0.0)).collect();
            for stick in &mut sticks {
                stick.a.z = inputs.real(0.0, 100.0);
                stick.b.z = inputs.real(0.0, 100.0);
            }
            match ordered(&sticks) {
                Err(_) => check_cycle(&sticks, &mut inputs),
                Ok(got) => {
                    let mistake = first_mistake(&sticks, &got);
                    if mistake.is_some()
                        && is_back_to_front()
                        && let Err(mistake) = looks_at_the_crossing(&mut inputs)
                    {
                        panic!("{mistake}");
                    }
                    if let Some((early, late)) = mistake {
                        let _picture = picture(&sticks, &got);
                        panic!(
                            "{}: got {}, but stick {early} hides {late} and comes before it",
                            name(&sticks),
                            few(&got)
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_cycle_among_others() {
        let mut inputs = Inputs::new(65);
        for n in [3, 4, 5, 6].into_iter().flat_map(|n| [n; 10]) {
            let mut sticks = ring(n);
            // One in front of all and one behind all: painted last and first, and no part of the cycle.
            let z = f64::from(inputs.integer(20, 90));
            sticks.insert(0, stick((-30.0, 0.5, -z), (30.0, 0.25, -z)));
            sticks.push(stick((-30.0, 0.75, z), (30.0, -0.5, z)));
            let turned = inputs.integer(0, sticks.len() as i32 - 1) as usize;
            sticks.rotate_left(turned);
            check_cycle(&sticks, &mut inputs);
        }
    }

    #[test]
    fn none_and_one_and_many() {
        assert!(
            ordered(&[]) == Ok(vec![]),
            "no stick: an empty order, got {:?}",
            order(&[])
        );
        let one = [stick((0.0, 0.0, 1.0), (1.0, 1.0, 1.0))];
        assert!(
            ordered(&one) == Ok(vec![0]),
            "one stick: it alone, got {:?}",
            order(&one)
        );
        let apart: Vec<_> = (0..60)
            .map(|i| stick((0.0, f64::from(i), 1.0), (1.0, f64::from(i), 1.0)))
            .collect();
        assert!(first_mistake(&apart, &painted(&apart)).is_none());
        check_cycle(&ring(60), &mut Inputs::new(66));
    }
}
