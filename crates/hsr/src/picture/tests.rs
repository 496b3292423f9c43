use super::*;
use ombra_math::glam::{DMat4, DVec3};
use ombra_math::solids::slide_cube;
use ombra_math::view::{Viewport, frustum, orthographic};
use ombra_math::work::Work;

fn polygon(vertices: &[(f64, f64, f64)]) -> Polygon {
    Polygon {
        vertices: vertices.iter().map(|&v| DVec3::from(v)).collect(),
    }
}

/// The picture as text: a digit for a primitive, a dot for none.
fn grid(picture: &IdBuffer) -> Vec<String> {
    picture
        .rows()
        .map(|row| {
            row.map(|p| char::from_digit(p.0[0], 10).unwrap_or('.'))
                .collect()
        })
        .collect()
}

/// World coordinates are pixel coordinates, y up; seen from z = 0 downwards to z = −10.
fn flat(width: u32, height: u32) -> Camera {
    let (right, top) = (f64::from(width), f64::from(height));
    Camera {
        view_projection: orthographic(0.0, right, 0.0, top, 0.0, 10.0).unwrap(),
        viewport: Viewport { width, height },
    }
}

#[test]
fn the_last_one_is_on_top() {
    let square = polygon(&[
        (0.0, 0.0, -1.0),
        (4.0, 0.0, -1.0),
        (4.0, 4.0, -1.0),
        (0.0, 4.0, -1.0),
    ]);
    // Its slanted side runs through the centres (2½, 4½) … (5½, 1½): the triangle is left of it and owns none.
    let triangle = polygon(&[(2.0, 1.0, -5.0), (6.0, 1.0, -5.0), (2.0, 5.0, -5.0)]);
    let camera = flat(6, 5);
    let picture = |parts: [(usize, &Polygon); 2]| grid(&paint(parts, &camera).unwrap());
    let expected = ["......", "0010..", "0011..", "00111.", "0000.."];
    assert_eq!(picture([(0, &square), (1, &triangle)]), expected);
    // Depth is nothing to a painter who is given the order.
    let expected = ["......", "0000..", "0000..", "00001.", "0000.."];
    assert_eq!(picture([(1, &triangle), (0, &square)]), expected);
    // One primitive in two parts, cut at x = 3: no gap, as if whole.
    let parts = [
        polygon(&[
            (0.0, 0.0, -1.0),
            (3.0, 0.0, -1.0),
            (3.0, 4.0, -1.0),
            (0.0, 4.0, -1.0),
        ]),
        polygon(&[
            (3.0, 0.0, -1.0),
            (4.0, 0.0, -1.0),
            (4.0, 4.0, -1.0),
            (3.0, 4.0, -1.0),
        ]),
    ];
    let whole = ["......", "3333..", "3333..", "3333..", "3333.."];
    assert_eq!(picture([(3, &parts[0]), (3, &parts[1])]), whole);
}

#[test]
fn only_the_view_volume_is_pictured() {
    let camera = Camera {
        view_projection: frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 4.0).unwrap(),
        viewport: Viewport {
            width: 8,
            height: 4,
        },
    };
    // A floor at y = −½, from far behind the eye to far beyond the far plane: in the picture from y_ndc = −½ at the
    // near plane, where it is cut, to −⅛ at the far one. Of the centres ¾, ¼, −¼ and −¾ that is the third.
    let floor = polygon(&[
        (-90.0, -0.5, 90.0),
        (90.0, -0.5, 90.0),
        (90.0, -0.5, -90.0),
        (-90.0, -0.5, -90.0),
    ]);
    let far_off = |z: f64| polygon(&[(-9.0, -9.0, z), (9.0, -9.0, z), (0.0, 20.0, z)]);
    let scene = [
        &floor,
        &far_off(-4.5),
        &far_off(-0.5),
        &far_off(2.0),
        &polygon(&[]),
        &polygon(&[(0.0, 0.0, -2.0), (1.0, 0.0, -2.0)]),
        &polygon(&[(0.0, f64::NAN, -2.0), (1.0, 0.0, -2.0), (0.0, 1.0, -2.0)]),
        &polygon(&[
            (0.0, 1e300, -2.0),
            (0.0, f64::INFINITY, -2.0),
            (0.0, 1.0, -2.0),
        ]),
    ];
    let mut work = Work::default();
    let picture = counted::paint(scene.into_iter().enumerate(), &camera, &mut work).unwrap();
    assert_eq!(
        grid(&picture),
        ["........", "........", "00000000", "........"]
    );
    assert_eq!(work.fragments, 8);
    // Beyond the picture and larger than it.
    let picture = paint([(7, &far_off(-3.0))], &camera).unwrap();
    assert!(picture.pixels().all(|p| p.0 == [7]));
}

#[test]
fn what_cannot_be_painted() {
    let triangle = polygon(&[(0.0, 0.0, -1.0), (1.0, 0.0, -1.0), (0.0, 1.0, -1.0)]);
    let good = flat(3, 3);
    let highest = NOTHING as usize - 1;
    assert!(paint([(highest, &triangle)], &good).is_ok());
    for id in [highest + 1, usize::MAX] {
        let error = paint([(id, &triangle)], &good).unwrap_err();
        assert_eq!(error, PictureError::TooMany { id });
        assert!(error.to_string().contains(&id.to_string()), "{error}");
    }
    for matrix in [
        DMat4::ZERO,
        DMat4::NAN,
        DMat4::from_cols_array(&[f64::INFINITY; 16]),
    ] {
        let camera = Camera {
            view_projection: matrix,
            ..good
        };
        let error = paint([], &camera).unwrap_err();
        assert!(matches!(error, PictureError::NoEye { .. }));
        assert!(error.to_string().contains("has no eye"), "{error}");
    }
    for (matrix, sentence) in [
        (
            DMat4::from_diagonal(DVec4::new(1.0, f64::NAN, 1.0, 1.0)),
            "the camera's matrix, with [0.0, NaN, 0.0, 0.0] in row 1, has no eye; it must be finite and invertible",
        ),
        (
            DMat4::from_diagonal(DVec4::new(1.0, 0.0, 1.0, 1e-300)),
            "the camera's matrix, with [0.0, 0.0, 0.0, 1e-300] in row 3, has no eye; it must be finite and invertible",
        ),
    ] {
        let camera = Camera {
            view_projection: matrix,
            ..good
        };
        let error = paint([], &camera).unwrap_err();
        assert_eq!(error.to_string(), sentence);
    }
    let error = paint([], &flat(u32::MAX, u32::MAX)).unwrap_err();
    assert!(error.to_string().contains("4294967295"), "{error}");
    let [small, large] = [3, 4].map(|size| paint([], &flat(size, 3)).unwrap());
    let error = compare(&small, &large, &[], &good).unwrap_err();
    let expected =
        "one picture has [3, 3] columns and rows, the other [4, 3]; they must be of one size";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn a_mesh_of_polygons_and_back() {
    let cube = slide_cube();
    let faces = polygons(&cube);
    let (mesh, sources) = triangles(&faces).unwrap();
    assert_eq!(polygons(&mesh), faces);
    assert_eq!(sources, (0..12).collect::<Vec<_>>());
    let scene = [
        polygon(&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]),
        polygon(&[
            (0.0, 0.0, 0.0),
            (2.0, 0.0, 0.0),
            (3.0, 1.0, 0.0),
            (2.0, 2.0, 0.0),
            (0.0, 2.0, 0.0),
        ]),
        polygon(&[]),
        polygon(&[(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (0.0, 1.0, 1.0)]),
    ];
    let (mesh, sources) = triangles(&scene).unwrap();
    assert_eq!(sources, [1, 1, 1, 3]);
    assert_eq!(mesh.triangles, [[2, 3, 4], [2, 4, 5], [2, 5, 6], [7, 8, 9]]);
    // The fan covers what the polygon covers.
    let camera = flat(4, 4);
    let fan = polygons(&mesh);
    let parts = sources.iter().copied().zip(&fan);
    let whole = scene.iter().enumerate();
    assert_eq!(
        paint(parts, &camera).unwrap(),
        paint(whole, &camera).unwrap()
    );
    assert!(triangles(&[polygon(&[(f64::NAN, 0.0, 0.0)])]).is_err());
    let missing = Mesh {
        positions: vec![DVec3::ZERO],
        triangles: vec![[0, 0, 1]],
    };
    assert_eq!(polygons(&missing), [Polygon::default()]);
}

#[test]
fn differences_are_counted_and_measured() {
    let square = |right: f64| {
        polygon(&[
            (2.0, 2.0, -1.0),
            (right, 2.0, -1.0),
            (right, 8.0, -1.0),
            (2.0, 8.0, -1.0),
        ])
    };
    let camera = flat(20, 10);
    let picture = |polygon: &Polygon| paint([(0, polygon)], &camera).unwrap();
    let (narrow, wide) = (square(7.0), square(9.0));
    let none = Difference::default();
    assert_eq!(
        compare(&picture(&wide), &picture(&wide), &[], &camera),
        Ok(none)
    );
    // Two columns of six, 7½ and 8½: seen from the narrow one's border at 7, and inside the wide one 1½ and ½ from 9.
    for (scene, farthest) in [(&narrow, 1.5), (&wide, 1.5)] {
        let found = compare(
            &picture(&narrow),
            &picture(&wide),
            std::slice::from_ref(scene),
            &camera,
        );
        let Difference {
            pixels,
            farthest: measured,
        } = found.unwrap();
        assert_eq!(pixels, 12);
        // A few roundings at 20 pixels.
        assert!(
            (measured - farthest).abs() <= 16.0 * 20.0 * f64::EPSILON,
            "{measured}"
        );
    }
    // Beyond a corner: 5 from it, (4, 3) away, though 3 from the line of its lower edge.
    let corner = polygon(&[
        (4.5, 6.5, -1.0),
        (0.0, 6.5, -1.0),
        (0.0, 10.0, -1.0),
        (4.5, 10.0, -1.0),
    ]);
    let mut dot = paint([], &camera).unwrap();
    dot.put_pixel(8, 6, Luma([0]));
    let found = compare(&dot, &paint([], &camera).unwrap(), &[corner], &camera).unwrap();
    assert!(
        found.pixels == 1 && (found.farthest - 5.0).abs() <= 16.0 * 20.0 * f64::EPSILON,
        "{found:?}"
    );
    // Where there are no polygons there are no edges.
    let nobody = paint([(5, &wide)], &camera).unwrap();
    let found = compare(&nobody, &paint([], &camera).unwrap(), &[], &camera).unwrap();
    assert_eq!((found.pixels, found.farthest), (42, f64::INFINITY));
}

#[test]
fn primitives_that_cross_differ_about_their_line() {
    // Two slanted walls that cross in the plane x = 10, each from z = −2 to z = −8, and the same two interchanged from
    // x = 13 on: three columns of wrong depth, the farthest centre 2½ from the line.
    let wall = |left: f64, right: f64| {
        polygon(&[
            (0.0, 0.0, left),
            (20.0, 0.0, right),
            (20.0, 10.0, right),
            (0.0, 10.0, left),
        ])
    };
    let scene = [wall(-2.0, -8.0), wall(-8.0, -2.0)];
    for camera in [
        flat(20, 10),
        Camera {
            view_projection: flat(20, 10).view_projection
                * DMat4::from_scale(DVec3::new(1.0, 1.0, 0.5)),
            ..flat(20, 10)
        },
    ] {
        let parted = |at: u32| {
            let mut picture = paint([], &camera).unwrap();
            for (x, _, pixel) in picture.enumerate_pixels_mut() {
                pixel.0 = [u32::from(x >= at)];
            }
            picture
        };
        let found = compare(&parted(10), &parted(13), &scene, &camera).unwrap();
        assert_eq!(found.pixels, 30);
        // The inverse and the planes round some dozen times at 20 pixels.
        assert!(
            (found.farthest - 2.5).abs() <= 64.0 * 20.0 * f64::EPSILON,
            "{}",
            found.farthest
        );
    }
    // Coplanar: they cross everywhere.
    let twins = [scene[0].clone(), scene[0].clone()];
    let camera = flat(20, 10);
    let [a, b] = [0, 1].map(|i| paint([(i, &twins[i])], &camera).unwrap());
    let found = compare(&a, &b, &twins, &camera).unwrap();
    assert_eq!((found.pixels, found.farthest), (200, 0.0));
}
