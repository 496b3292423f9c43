//! Edge functions in integers, stepped through a triangle's bounding box: what sub-pixel bits are for.

use ombra_math::work::{Count, Counter};
use ombra_raster::triangle::EdgeRule;

use super::mesh::{BITS, Mesh, Owners};

/// All triangles of a mesh with their vertices snapped to `bits`.
pub fn draw(mesh: &Mesh, bits: u32, rule: EdgeRule, work: &mut impl Count) -> Owners {
    // In halves of the unit, so that centres are integers too.
    let unit = f64::from(1_u32 << bits.min(BITS));
    let snapped = |x: f64| 2 * (x * unit + 0.5).floor() as i64;
    work.add(Counter::Roundings, 2 * mesh.vertices.len() as u64);
    let vertices: Vec<_> = mesh
        .vertices
        .iter()
        .map(|v| [snapped(v.x), snapped(v.y)])
        .collect();
    let mut owners = Owners::nobody(mesh.side);
    for (i, corners) in mesh.corners(&vertices) {
        draw_one(
            corners,
            2 << bits.min(BITS),
            mesh.side,
            rule,
            work,
            |x, y| {
                owners.draw(y, x..x + 1, i);
            },
        );
    }
    owners
}

/// One triangle, whose edge functions are positive inside, in units of which `one` are a pixel.
fn draw_one(
    [a, b, c]: [[i64; 2]; 3],
    one: i64,
    side: u32,
    rule: EdgeRule,
    work: &mut impl Count,
    mut pixel: impl FnMut(u32, u32),
) {
    // Pixels whose centres lie between the outermost corners.
    let range = |x: [i64; 3]| {
        let [low, high] = [
            x.into_iter().fold(i64::MAX, i64::min),
            x.into_iter().fold(i64::MIN, i64::max),
        ];
        let first = (low - one / 2 + one - 1).div_euclid(one);
        let last = (high - one / 2).div_euclid(one);
        let end = i64::from(side);
        first.clamp(0, end) as u32..(last + 1).clamp(0, end) as u32
    };
    let (columns, rows) = (range([a[0], b[0], c[0]]), range([a[1], b[1], c[1]]));
    let centre = [columns.start, rows.start].map(|i| i64::from(i) * one + one / 2);
    let mut edges = [(a, b), (b, c), (c, a)].map(|(a, b)| Edge::new(a, b, centre, one, rule, work));
    for y in rows {
        let mut along = edges.map(|edge| edge.at);
        for x in columns.clone() {
            work.add(Counter::Additions, 3);
            work.add(Counter::Comparisons, 1);
            // No sign bit in any of the three.
            if along[0] | along[1] | along[2] >= 0 {
                work.add(Counter::Fragments, 1);
                pixel(x, y);
            }
            for (at, edge) in along.iter_mut().zip(&edges) {
                *at += edge.right;
            }
        }
        work.add(Counter::Additions, 3);
        for edge in &mut edges {
            edge.at += edge.down;
        }
    }
}

/// An edge function, less 1 where the edge does not own its points: in where it is not negative.
#[derive(Clone, Copy)]
struct Edge {
    /// At the first centre of the row.
    at: i64,
    /// What a step to the right and one down add.
    right: i64,
    down: i64,
}

impl Edge {
    fn new(
        [ax, ay]: [i64; 2],
        [bx, by]: [i64; 2],
        [x, y]: [i64; 2],
        one: i64,
        rule: EdgeRule,
        work: &mut impl Count,
    ) -> Self {
        let (dx, dy) = (bx - ax, by - ay);
        let owns = match rule {
            EdgeRule::TopLeft => dy < 0 || (dy == 0 && dx > 0),
            EdgeRule::Closed => true,
            EdgeRule::Open => false,
        };
        work.add(Counter::Additions, 6);
        work.add(Counter::Multiplications, 4);
        work.add(Counter::Comparisons, 2);
        Self {
            at: dx * (y - ay) - dy * (x - ax) - i64::from(!owns),
            right: -dy * one,
            down: dx * one,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_math::glam::DVec2;
    use ombra_math::work::Work;
    use ombra_raster::triangle::cover_plain;

    #[test]
    fn the_rules_are_those_of_the_plain_form() {
        let one = 8;
        for corners in [
            [[0, 0], [32, 0], [32, 32]],
            [[0, 0], [32, 32], [0, 32]],
            [[4, 4], [44, 12], [12, 36]],
            [[-7, 3], [61, -9], [20, 70]],
            [[4, 4], [36, 4], [4, 20]],
        ] {
            for rule in [EdgeRule::TopLeft, EdgeRule::Closed, EdgeRule::Open] {
                let mut found = Vec::new();
                draw_one(corners, one, 6, rule, &mut (), |x, y| found.push((x, y)));
                let in_pixels = |[x, y]: [i64; 2]| DVec2::new(x as f64, y as f64) / one as f64;
                let mut expected = Vec::new();
                cover_plain(corners.map(in_pixels), rule, 6, 6, &mut (), |p| {
                    expected.push((p.x, p.y));
                })
                .unwrap();
                assert_eq!(found, expected, "{corners:?} {rule:?}");
            }
        }
    }

    #[test]
    fn work_grows_with_the_bounding_box() {
        let mut work = Work::default();
        let mut fragments = 0;
        let corners = [[0, 0], [32, 0], [0, 32]];
        draw_one(corners, 8, 100, EdgeRule::Open, &mut work, |_, _| {
            fragments += 1
        });
        // 4 × 4 centres, of which 6 are above the diagonal: 3 sums each, 3 a row, 6 an edge.
        assert_eq!((work.fragments, fragments), (6, 6));
        assert_eq!(work.additions, 3 * 16 + 3 * 4 + 3 * 6);
        assert_eq!((work.multiplications, work.comparisons), (12, 16 + 6));
    }
}
