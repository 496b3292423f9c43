use super::*;
use std::collections::BTreeMap;

const EPS: f64 = f64::EPSILON;

/// The published patches, z up, one of each reflected set, with their control points written out.
#[rustfmt::skip]
const PUBLISHED: [[[f64; 3]; 16]; 10] = [
    // rim
    [
        [1.4, 0.0, 2.4], [1.4, -0.784, 2.4], [0.784, -1.4, 2.4], [0.0, -1.4, 2.4],
        [1.3375, 0.0, 2.53125], [1.3375, -0.749, 2.53125], [0.749, -1.3375, 2.53125], [0.0, -1.3375, 2.53125],
        [1.4375, 0.0, 2.53125], [1.4375, -0.805, 2.53125], [0.805, -1.4375, 2.53125], [0.0, -1.4375, 2.53125],
        [1.5, 0.0, 2.4], [1.5, -0.84, 2.4], [0.84, -1.5, 2.4], [0.0, -1.5, 2.4],
    ],
    // upper body
    [
        [1.5, 0.0, 2.4], [1.5, -0.84, 2.4], [0.84, -1.5, 2.4], [0.0, -1.5, 2.4],
        [1.75, 0.0, 1.875], [1.75, -0.98, 1.875], [0.98, -1.75, 1.875], [0.0, -1.75, 1.875],
        [2.0, 0.0, 1.35], [2.0, -1.12, 1.35], [1.12, -2.0, 1.35], [0.0, -2.0, 1.35],
        [2.0, 0.0, 0.9], [2.0, -1.12, 0.9], [1.12, -2.0, 0.9], [0.0, -2.0, 0.9],
    ],
    // lower body
    [
        [2.0, 0.0, 0.9], [2.0, -1.12, 0.9], [1.12, -2.0, 0.9], [0.0, -2.0, 0.9],
        [2.0, 0.0, 0.45], [2.0, -1.12, 0.45], [1.12, -2.0, 0.45], [0.0, -2.0, 0.45],
        [1.5, 0.0, 0.225], [1.5, -0.84, 0.225], [0.84, -1.5, 0.225], [0.0, -1.5, 0.225],
        [1.5, 0.0, 0.15], [1.5, -0.84, 0.15], [0.84, -1.5, 0.15], [0.0, -1.5, 0.15],
    ],
    // knob
    [
        [0.0, 0.0, 3.15], [0.0, 0.0, 3.15], [0.0, 0.0, 3.15], [0.0, 0.0, 3.15],
        [0.8, 0.0, 3.15], [0.8, -0.45, 3.15], [0.45, -0.8, 3.15], [0.0, -0.8, 3.15],
        [0.0, 0.0, 2.85], [0.0, 0.0, 2.85], [0.0, 0.0, 2.85], [0.0, 0.0, 2.85],
        [0.2, 0.0, 2.7], [0.2, -0.112, 2.7], [0.112, -0.2, 2.7], [0.0, -0.2, 2.7],
    ],
    // lid
    [
        [0.2, 0.0, 2.7], [0.2, -0.112, 2.7], [0.112, -0.2, 2.7], [0.0, -0.2, 2.7],
        [0.4, 0.0, 2.55], [0.4, -0.224, 2.55], [0.224, -0.4, 2.55], [0.0, -0.4, 2.55],
        [1.3, 0.0, 2.55], [1.3, -0.728, 2.55], [0.728, -1.3, 2.55], [0.0, -1.3, 2.55],
        [1.3, 0.0, 2.4], [1.3, -0.728, 2.4], [0.728, -1.3, 2.4], [0.0, -1.3, 2.4],
    ],
    // base
    [
        [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0],
        [0.0, -1.425, 0.0], [0.798, -1.425, 0.0], [1.425, -0.798, 0.0], [1.425, 0.0, 0.0],
        [0.0, -1.5, 0.075], [0.84, -1.5, 0.075], [1.5, -0.84, 0.075], [1.5, 0.0, 0.075],
        [0.0, -1.5, 0.15], [0.84, -1.5, 0.15], [1.5, -0.84, 0.15], [1.5, 0.0, 0.15],
    ],
    // upper half of the handle
    [
        [-1.6, 0.0, 2.025], [-1.6, -0.3, 2.025], [-1.5, -0.3, 2.25], [-1.5, 0.0, 2.25],
        [-2.3, 0.0, 2.025], [-2.3, -0.3, 2.025], [-2.5, -0.3, 2.25], [-2.5, 0.0, 2.25],
        [-2.7, 0.0, 2.025], [-2.7, -0.3, 2.025], [-3.0, -0.3, 2.25], [-3.0, 0.0, 2.25],
        [-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8],
    ],
    // lower half of the handle
    [
        [-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8],
        [-2.7, 0.0, 1.575], [-2.7, -0.3, 1.575], [-3.0, -0.3, 1.35], [-3.0, 0.0, 1.35],
        [-2.5, 0.0, 1.125], [-2.5, -0.3, 1.125], [-2.65, -0.3, 0.9375], [-2.65, 0.0, 0.9375],
        [-2.0, 0.0, 0.9], [-2.0, -0.3, 0.9], [-1.9, -0.3, 0.6], [-1.9, 0.0, 0.6],
    ],
    // lower half of the spout
    [
        [1.7, 0.0, 1.425], [1.7, -0.66, 1.425], [1.7, -0.66, 0.6], [1.7, 0.0, 0.6],
        [2.6, 0.0, 1.425], [2.6, -0.66, 1.425], [3.1, -0.66, 0.825], [3.1, 0.0, 0.825],
        [2.3, 0.0, 2.1], [2.3, -0.25, 2.1], [2.4, -0.25, 2.025], [2.4, 0.0, 2.025],
        [2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4],
    ],
    // upper half of the spout
    [
        [2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4],
        [2.8, 0.0, 2.475], [2.8, -0.25, 2.475], [3.525, -0.25, 2.49375], [3.525, 0.0, 2.49375],
        [2.9, 0.0, 2.475], [2.9, -0.15, 2.475], [3.45, -0.15, 2.5125], [3.45, 0.0, 2.5125],
        [2.8, 0.0, 2.4], [2.8, -0.15, 2.4], [3.2, -0.15, 2.4], [3.2, 0.0, 2.4],
    ],
];

/// De Casteljau: between neighbours, again and again.
fn casteljau(mut p: [DVec3; 4], t: f64) -> DVec3 {
    for left in (1..4).rev() {
        for i in 0..left {
            p[i] = p[i].lerp(p[i + 1], t);
        }
    }
    p[0]
}

#[test]
fn the_published_patches() {
    for n in [2, 3, 5, 8] {
        let pot = teapot(n).unwrap();
        for patch in PUBLISHED {
            let points = patch.map(|[x, y, z]| DVec3::new(x, z, -y));
            let row = |i: usize, u: f64| casteljau([0, 1, 2, 3].map(|j| points[4 * i + j]), u);
            for (k, l) in (0..=n).flat_map(|k| (0..=n).map(move |l| (k, l))) {
                let (u, v) = (f64::from(k) / f64::from(n), f64::from(l) / f64::from(n));
                let p = casteljau([0, 1, 2, 3].map(|i| row(i, u)), v);
                // A dozen roundings at coordinates up to 3.6.
                let near = pot
                    .positions
                    .iter()
                    .any(|q| (p - q).abs().max_element() <= 12.0 * EPS * 4.0);
                assert!(near, "{n}: {p} is no vertex");
            }
        }
    }
}

/// The loops of open edges, each as the vertices in the order of its faces.
fn border(mesh: &Mesh) -> Vec<Vec<DVec3>> {
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for e in mesh.edges() {
        match (e.left, e.right) {
            (Some(_), None) => assert_eq!(next.insert(e.from, e.to), None),
            (None, Some(_)) => assert_eq!(next.insert(e.to, e.from), None),
            _ => {}
        }
    }
    let mut loops = Vec::new();
    while let Some((&start, _)) = next.first_key_value() {
        let mut found = Vec::new();
        let mut at = start;
        while let Some(to) = next.remove(&at) {
            found.push(mesh.positions[at as usize]);
            at = to;
        }
        assert_eq!(at, start);
        loops.push(found);
    }
    loops
}

#[test]
fn open_where_the_original_is_and_nowhere_else() {
    for n in [2, 3, 6] {
        let pot = teapot(n).unwrap();
        let loops = border(&pot);
        let n = n as usize;
        // A point of each in the published data (here y up), and how many edges.
        let expected = [
            ("rim", DVec3::new(1.4, 2.4, 0.0), 4 * n),
            ("lid", DVec3::new(0.0, 2.4, 1.3), 4 * n),
            (
                "upper end of the handle",
                DVec3::new(-1.5, 2.25, 0.0),
                2 * n,
            ),
            ("lower end of the handle", DVec3::new(-2.0, 0.9, 0.0), 2 * n),
            ("foot of the spout", DVec3::new(1.7, 0.6, 0.0), 2 * n),
            ("mouth of the spout", DVec3::new(3.2, 2.4, 0.0), 2 * n),
        ];
        assert_eq!(loops.len(), expected.len());
        for (name, p, edges) in expected {
            let lengths: Vec<_> = loops
                .iter()
                .filter(|l| l.contains(&p))
                .map(Vec::len)
                .collect();
            assert_eq!(lengths, [edges], "{name}");
        }
        for (height, radius) in [(2.4, 1.4), (2.4, 1.3)] {
            let flat = loops.iter().any(|l| {
                l.len() == 4 * n
                    && l.iter().all(|p| {
                        let across = p.with_y(0.0).length();
                        // The cubic quarter bulges by less than 0.6 %.
                        p.y == height && across >= radius * (1.0 - EPS) && across < radius * 1.006
                    })
            });
            assert!(flat, "{radius}");
        }
    }
}

/// With its loops stopped by fans, each piece is closed, and encloses a positive volume only if it looks outwards.
#[test]
fn every_piece_looks_outwards() {
    let mut pot = teapot(6).unwrap();
    for found in border(&pot) {
        let middle = pot.positions.len() as u32;
        let index = |p: &DVec3| pot.positions.iter().rposition(|q| q == p).unwrap() as u32;
        // The touching point of handle and pot is there twice; the border's is the handle's, the later one.
        let ring: Vec<_> = found.iter().map(index).collect();
        for (i, &v) in ring.iter().enumerate() {
            pot.triangles.push([ring[(i + 1) % ring.len()], v, middle]);
        }
        pot.positions
            .push(found.iter().sum::<DVec3>() / found.len() as f64);
    }
    assert!(pot.is_two_manifold());
    let vertices = pot.positions.len();
    let mut piece: Vec<usize> = (0..vertices).collect();
    for _ in 0..vertices {
        let before = piece.clone();
        for t in &pot.triangles {
            let least = t.iter().map(|&v| piece[v as usize]).min().unwrap();
            t.iter().for_each(|&v| piece[v as usize] = least);
        }
        if piece == before {
            break;
        }
    }
    let mut volumes: BTreeMap<usize, f64> = BTreeMap::new();
    for (i, t) in pot.triangles.iter().enumerate() {
        let [a, b, c] = pot.triangle(i).unwrap();
        *volumes.entry(piece[t[0] as usize]).or_default() += a.dot(b.cross(c)) / 6.0;
    }
    assert_eq!(volumes.len(), 4);
    assert!(volumes.values().all(|&v| v > 0.0), "{volumes:?}");
    // The pot between the cylinders of radius 1.4 and 2.02 about its height of 2.5.
    let body = volumes.values().copied().fold(0.0, f64::max);
    assert!(body > 15.0 && body < 32.0, "{body}");
}

#[test]
fn shape() {
    for n in [2, 3, 7] {
        let pot = teapot(n).unwrap();
        assert_eq!(pot.triangles.len() as u32, 64 * n * n - 8 * n);
        for i in 0..pot.triangles.len() {
            let [a, b, c] = pot.triangle(i).unwrap();
            assert!(crate::triangle::area(a, b, c) > 0.0, "{n}: {i}");
        }
        let has = |p: DVec3| pot.positions.contains(&p);
        assert!(pot.positions.iter().all(|&p| has(p.with_z(-p.z))), "{n}");
        let [low, high] = pot.bounds().unwrap();
        assert_eq!(
            (low, high.y, high.z),
            (DVec3::new(-3.0, 0.0, -2.0), 3.15, 2.0)
        );
        assert!(high.x > 3.3 && high.x < 3.525);
        // Each place once, but for the point where the handle touches the pot.
        let mut places: Vec<_> = pot
            .positions
            .iter()
            .map(|p| p.to_array().map(|x| (x + 0.0).to_bits()))
            .collect();
        places.sort_unstable();
        let again: Vec<_> = places
            .windows(2)
            .filter(|w| w[0] == w[1])
            .map(|w| w[0].map(f64::from_bits))
            .collect();
        assert_eq!(again, [[-2.0, 0.9, 0.0]]);
    }
}
