use super::*;
use proptest::prelude::*;

fn pixels(vertices: &[(i32, i32)]) -> Vec<(i32, i32)> {
    let vertices: Vec<_> = vertices.iter().copied().map(IVec2::from).collect();
    outline(&vertices).map(|p| (p.x, p.y)).collect()
}

#[test]
fn a_square_has_each_pixel_once() {
    let found = pixels(&[(1, 1), (4, 1), (4, 3), (1, 3)]);
    let round = [
        (1, 1),
        (2, 1),
        (3, 1),
        (4, 1),
        (4, 2),
        (4, 3),
        (3, 3),
        (2, 3),
        (1, 3),
        (1, 2),
    ];
    assert_eq!(found, round);
}

#[test]
fn degenerate() {
    assert_eq!(pixels(&[]), []);
    assert_eq!(pixels(&[(5, -2)]), [(5, -2)]);
    assert_eq!(pixels(&[(5, -2); 4]), [(5, -2)]);
    // There and back, both ends once.
    assert_eq!(pixels(&[(0, 0), (2, 0)]), [(0, 0), (1, 0), (2, 0), (1, 0)]);
    assert_eq!(
        pixels(&[(0, 0), (0, 0), (2, 0), (2, 0)]),
        [(0, 0), (1, 0), (2, 0), (1, 0)]
    );
    let (min, max) = (i32::MIN, i32::MAX);
    let found: Vec<_> = outline(&[IVec2::new(min, min), IVec2::new(max, max)])
        .take(2)
        .collect();
    assert_eq!(found, [IVec2::splat(min), IVec2::splat(min + 1)]);
}

proptest! {
    /// A closed chain: each pixel beside the next, the last beside the first, as many as the edges' steps.
    #[test]
    fn is_a_closed_chain(vertices in prop::collection::vec([-20..20i32, -20..20], 1..8)) {
        let vertices: Vec<_> = vertices.into_iter().map(IVec2::from_array).collect();
        let chain: Vec<_> = outline(&vertices).collect();
        let steps: i32 = (0..vertices.len())
            .map(|i| (vertices[(i + 1) % vertices.len()] - vertices[i]).abs().max_element())
            .sum();
        prop_assert_eq!(chain.len(), steps.max(1) as usize);
        prop_assert_eq!(chain[0], vertices[0]);
        if chain.len() > 1 {
            for (i, pixel) in chain.iter().enumerate() {
                prop_assert_eq!((*pixel - chain[(i + 1) % chain.len()]).abs().max_element(), 1);
            }
        }
        prop_assert!(vertices.iter().all(|vertex| chain.contains(vertex)));
    }
}
