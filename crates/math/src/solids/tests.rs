use super::*;
use proptest::num::f64::ANY;
use proptest::prelude::*;

const EPS: f64 = f64::EPSILON;

/// Six times the volume, as the sum of the determinants of the triangles.
fn volume(mesh: &Mesh) -> f64 {
    let corners = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
    corners.map(|[a, b, c]| a.dot(b.cross(c))).sum::<f64>() / 6.0
}

/// V − E + F.
fn euler(mesh: &Mesh) -> i64 {
    mesh.positions.len() as i64 - mesh.edges().len() as i64 + mesh.triangles.len() as i64
}

#[test]
fn the_decks_cube() {
    let cube = slide_cube();
    let expected = [
        (0, 20, 0),
        (10, 20, 0),
        (10, 20, 10),
        (0, 20, 10),
        (0, 30, 0),
        (10, 30, 0),
        (10, 30, 10),
        (0, 30, 10),
    ];
    let expected = expected.map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()));
    assert_eq!(cube.positions, expected);
    assert_eq!(volume(&cube), 1000.0);
    assert_eq!(
        cube.positions,
        cuboid(expected[0], expected[6]).unwrap().positions
    );
}

#[test]
fn faces_look_outwards() {
    let inside = DVec3::new(5.0, 25.0, 5.0);
    for (mesh, inside) in [
        (slide_cube(), inside),
        (tetrahedron(), DVec3::ZERO),
        (sphere(2.0, 7, 5).unwrap(), DVec3::ZERO),
    ] {
        assert!(mesh.is_two_manifold());
        assert_eq!(euler(&mesh), 2);
        for i in 0..mesh.triangles.len() {
            let [a, b, c] = mesh.triangle(i).unwrap();
            assert!(
                crate::triangle::normal(a, b, c).dot(a - inside) > 0.0,
                "{i}"
            );
        }
    }
    let torus = torus(3.0, 1.0, 9, 7).unwrap();
    assert!(torus.is_two_manifold());
    assert_eq!(euler(&torus), 0);
    for i in 0..torus.triangles.len() {
        let [a, b, c] = torus.triangle(i).unwrap();
        let centre = (a + b + c) / 3.0;
        let ring = centre.with_y(0.0).normalize() * 3.0;
        assert!(
            crate::triangle::normal(a, b, c).dot(centre - ring) > 0.0,
            "{i}"
        );
    }
}

#[test]
fn the_tetrahedron_is_regular() {
    let t = tetrahedron();
    for (i, p) in t.positions.iter().enumerate() {
        assert!((p.length() - 1.0).abs() <= 2.0 * EPS);
        for q in &t.positions[..i] {
            // √8/3 exactly, up to the rounding of 1/√3; and all alike.
            assert_eq!((p - q).length(), (t.positions[0] - t.positions[1]).length());
            assert!((p.dot(*q) + 1.0 / 3.0).abs() <= 2.0 * EPS);
        }
    }
}

/// The volume missing falls with the square of the parts.
#[test]
fn round_solids_tend_to_round() {
    let ball = 4.0 / 3.0 * PI * 8.0;
    let ring = 2.0 * PI * 3.0 * PI;
    let missing = |n: u32| {
        let (s, t) = (
            sphere(2.0, 2 * n, n).unwrap(),
            torus(3.0, 1.0, 2 * n, n).unwrap(),
        );
        for p in &s.positions {
            assert!((p.length() - 2.0).abs() <= 4.0 * EPS * 2.0);
        }
        for p in &t.positions {
            let tube = p.with_y(0.0).length() - 3.0;
            assert!((tube.hypot(p.y) - 1.0).abs() <= 4.0 * EPS * 4.0);
        }
        (1.0 - volume(&s) / ball, 1.0 - volume(&t) / ring)
    };
    let ((s1, t1), (s2, t2)) = (missing(24), missing(48));
    assert!(s2 > 0.0 && t2 > 0.0);
    // The next term of the series is smaller by about (π/24)² = 0.017.
    assert!(
        (s1 / s2 - 4.0).abs() < 0.1 && (t1 / t2 - 4.0).abs() < 0.1,
        "{} {}",
        s1 / s2,
        t1 / t2
    );
}

#[test]
fn degenerate() {
    use SolidError as E;
    let (inf, max, tiny) = (f64::INFINITY, f64::MAX, 5e-324);
    let unit = DVec3::ONE;
    let cases = [
        (
            "flat",
            cuboid(unit, unit.with_x(2.0)),
            E::Extent {
                axis: 'y',
                min: 1.0,
                max: 1.0,
            },
        ),
        (
            "upside down",
            cuboid(unit, DVec3::ZERO),
            E::Extent {
                axis: 'x',
                min: 1.0,
                max: 0.0,
            },
        ),
        (
            "no end",
            cuboid(unit, unit * inf),
            E::Extent {
                axis: 'x',
                min: 1.0,
                max: inf,
            },
        ),
        (
            "radius 0",
            sphere(0.0, 8, 8),
            E::Radius {
                what: "radius",
                value: 0.0,
            },
        ),
        (
            "radius ∞",
            sphere(inf, 8, 8),
            E::Radius {
                what: "radius",
                value: inf,
            },
        ),
        (
            "two slices",
            sphere(1.0, 2, 8),
            E::Parts {
                what: "slices",
                value: 2,
                least: 3,
            },
        ),
        (
            "one stack",
            sphere(1.0, 8, 1),
            E::Parts {
                what: "stacks",
                value: 1,
                least: 2,
            },
        ),
        (
            "no stack",
            sphere(1.0, 8, 0),
            E::Parts {
                what: "stacks",
                value: 0,
                least: 2,
            },
        ),
        (
            "all memory",
            sphere(1.0, u32::MAX, u32::MAX),
            E::TooManyTriangles {
                triangles: 2 * 4_294_967_295 * 4_294_967_294,
            },
        ),
        (
            "horn",
            torus(1.0, 1.0, 8, 8),
            E::Tube {
                major: 1.0,
                minor: 1.0,
            },
        ),
        (
            "beyond",
            torus(max, max / 2.0, 8, 8),
            E::Tube {
                major: max,
                minor: max / 2.0,
            },
        ),
        (
            "tube 0",
            torus(1.0, -0.0, 8, 8),
            E::Radius {
                what: "minor",
                value: 0.0,
            },
        ),
        (
            "two around",
            torus(2.0, 1.0, 2, 8),
            E::Parts {
                what: "around",
                value: 2,
                least: 3,
            },
        ),
        (
            "two across",
            torus(2.0, 1.0, 8, 2),
            E::Parts {
                what: "across",
                value: 2,
                least: 3,
            },
        ),
        (
            "too many",
            torus(2.0, 1.0, 4096, 2049),
            E::TooManyTriangles {
                triangles: 2 * 4096 * 2049,
            },
        ),
        (
            "one division",
            teapot(1),
            E::Parts {
                what: "divisions",
                value: 1,
                least: 2,
            },
        ),
        (
            "513 divisions",
            teapot(513),
            E::TooManyTriangles {
                triangles: 64 * 513 * 513 - 8 * 513,
            },
        ),
        (
            "the most divisions",
            teapot(u32::MAX),
            E::TooManyTriangles {
                triangles: 64 * 4_294_967_295 * 4_294_967_295 - 8 * 4_294_967_295,
            },
        ),
    ];
    for (name, found, expected) in cases {
        assert_eq!(found, Err(expected), "{name}");
        assert!(!expected.to_string().is_empty());
    }
    for result in [
        sphere(tiny, 8, 8),
        torus(1.0, tiny, 8, 8),
        torus(tiny * 2.0, tiny, 8, 8),
    ] {
        let error = result.unwrap_err();
        assert!(matches!(error, E::Collapsed { .. }) && !error.to_string().is_empty());
    }
    for radius in [1e-300, max] {
        assert!(
            sphere(radius, 64, 32)
                .unwrap()
                .positions
                .iter()
                .all(|p| p.is_finite())
        );
    }
    let whole = cuboid(DVec3::splat(-max), DVec3::splat(max)).unwrap();
    assert!(whole.is_two_manifold());
}

proptest! {
    #[test]
    fn never_panics(x in ANY, y in ANY, z in ANY, w in ANY, i in 0..40u32, j in 0..40u32) {
        let results = [
            cuboid(DVec3::new(x, y, z), DVec3::new(y, z, w)),
            sphere(x, i, j),
            torus(x.abs(), y.abs(), i, j),
        ];
        for mesh in results.into_iter().flatten() {
            prop_assert!(mesh.is_two_manifold());
            prop_assert!(Mesh::new(mesh.positions, mesh.triangles).is_ok());
        }
    }
}
