//! Clipping, culling, colours, counts, errors.

use ombra_math::glam::{DMat3, DMat4, DVec2};
use ombra_math::solids;
use ombra_math::work::Work;
use proptest::num::f64::ANY;

use super::*;

/// Depth and shares of the corners at a place of the picture, straight from clip coordinates: no clipping, no snapping.
/// An error where the triangle is not seen: which of its three sides, of near and far plane the place is beyond.
fn cast(camera: &Camera, triangle: [DVec3; 3], pixel: DVec2) -> Result<(f64, DVec3), [bool; 5]> {
    let p = triangle.map(|v| camera.to_clip(v));
    let size = DVec2::new(
        f64::from(camera.viewport.width),
        f64::from(camera.viewport.height),
    );
    let ndc = (2.0 * pixel / size - 1.0) * DVec2::new(1.0, -1.0);
    // The shares s with Σ sᵢ (xᵢ, yᵢ, wᵢ) = w (x, y, 1).
    let matrix = DMat3::from_cols_array_2d(&p.map(|p| [p.x, p.y, p.w]));
    let shares = matrix.inverse() * ndc.extend(1.0);
    // With w = 1.
    let z = shares.dot(DVec3::from(p.map(|p| p.z)));
    let [a, b, c] = shares.to_array().map(|share| share < 0.0);
    match [a, b, c, z < -1.0, z > 1.0] {
        [false, false, false, false, false] => Ok((0.5 + 0.5 * z, shares / shares.element_sum())),
        beyond => Err(beyond),
    }
}

fn triangles() -> impl Strategy<Value = [DVec3; 3]> {
    let position = prop::array::uniform3(-2.0..2.0f64).prop_map(DVec3::from);
    prop::array::uniform3(position)
}

proptest! {
    /// Where the picture is the same within a hundredth of a pixel all round, the pixel is covered or not as it should
    /// be, also when the triangle reaches behind the eye; and depth and colour are right.
    #[test]
    fn clipped_triangles_come_out_where_they_are(triangle in triangles(), camera in cameras()) {
        let Viewport { width, height } = camera.viewport;
        let mesh = Mesh::new(triangle.to_vec(), vec![[0, 1, 2]]).unwrap();
        let colours = [[1.0f32, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(image_rgb);
        let mut picture = buffers::new(width, height, image_rgb([0.0; 3])).unwrap();
        let mut depth = DepthBuffer::<Depth32F>::new(width, height).unwrap();
        let colours = Colours::PerVertex(&colours);
        draw(&mesh, &camera, colours, Options::default(), &mut picture, &mut depth).unwrap();
        for (x, y, pixel) in picture.enumerate_pixels() {
            let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let around = [(0.0, 0.0), (0.01, 0.01), (-0.01, 0.01), (0.01, -0.01), (-0.01, -0.01)]
                .map(|offset| cast(&camera, triangle, centre + DVec2::from(offset)));
            let found = f64::from(depth.stored(x, y).unwrap());
            // All beyond one line of the picture, so that nothing of a thin triangle comes between them.
            if (0..5).any(|line| around.iter().all(|at| at.is_err_and(|beyond| beyond[line]))) {
                prop_assert_eq!(found, 1.0, "{} {}", x, y);
            } else if let [Ok(at), Ok(a), Ok(b), Ok(c), Ok(d)] = around {
                let near_far = [a.0, b.0, c.0, d.0];
                let least = near_far.into_iter().fold(at.0, f64::min);
                let greatest = near_far.into_iter().fold(at.0, f64::max);
                // The rounding to f32; that of the oracle's inverse is far below unless it is nearly singular.
                let slack = f64::from(f32::EPSILON) + 1e-6 * (greatest - least);
                prop_assert!(found >= least - slack && found <= greatest + slack, "{} {}: {} in {}..{}", x, y, found, least, greatest);
                let colour = DVec3::from(pixel.0.map(f64::from));
                if found < 1.0 {
                    let spread = [a, b, c, d].map(|(_, s)| (s - at.1).abs().max_element());
                    let spread = spread.into_iter().fold(0.0, f64::max);
                    let error = (colour - at.1).abs().max_element();
                    prop_assert!(error <= spread + 1e-6, "{} {}: {} is {}", x, y, colour, at.1);
                }
            }
        }
    }

    /// Nothing panics; input that cannot be drawn is refused.
    #[test]
    fn never_panics(
        matrix in prop::array::uniform16(ANY),
        positions in prop::collection::vec(prop::array::uniform3(ANY), 0..5),
        triangles in prop::collection::vec(prop::array::uniform3(0..5u32), 0..6),
        finite in any::<bool>(),
    ) {
        let tame = |x: f64| if finite && !x.is_finite() { 1.0 } else { x };
        let mesh = Mesh { positions: positions.iter().map(|&p| DVec3::from(p.map(tame))).collect(), triangles };
        let camera = Camera { view_projection: DMat4::from_cols_array(&matrix.map(tame)), viewport: viewport(5, 4) };
        let mut depth = DepthBuffer::<Depth16>::new(5, 4).unwrap();
        let _ = draw_depth(&mesh, &camera, Cull::Nothing, &mut depth);
        let mut plain = DepthBuffer::<Depth16>::new(5, 4).unwrap();
        let _ = depth_drawn(&mesh, &camera, Cull::Nothing, &mut plain, Form::Plain, &mut ());
        prop_assert_eq!(depth.image(), plain.image());
    }
}

fn image_rgb(channels: [f32; 3]) -> buffers::image::Rgb<f32> {
    buffers::image::Rgb(channels)
}

fn looking_at_the_origin(size: u32) -> Camera {
    let view = look_at(DVec3::new(1.0, 2.0, 4.0), DVec3::ZERO, DVec3::Y).unwrap();
    let projection = frustum(-0.3, 0.3, -0.3, 0.3, 1.0, 10.0).unwrap();
    Camera {
        view_projection: projection * view,
        viewport: viewport(size, size),
    }
}

#[test]
fn culling_halves_the_work_and_changes_no_picture_of_a_solid() {
    let mesh = solids::sphere(1.0, 40, 20).unwrap();
    let camera = looking_at_the_origin(64);
    let run = |cull| {
        let mut depth = DepthBuffer::<Depth24>::new(64, 64).unwrap();
        let mut work = Work::default();
        counted::draw_depth(&mesh, &camera, cull, &mut depth, &mut work).unwrap();
        (depth, work)
    };
    let ((all, all_work), (front, front_work), (back, back_work)) =
        (run(Cull::Nothing), run(Cull::Back), run(Cull::Front));
    assert_eq!(all.image(), front.image());
    assert_ne!(all.image(), back.image());
    assert_eq!(
        front_work.fragments + back_work.fragments,
        all_work.fragments
    );
    // A closed surface covers each pixel as often from the front as from the back: no pixel is lost or drawn twice.
    assert_eq!(front_work.fragments, back_work.fragments);
    assert!(front_work.fragments > 500);
    assert_eq!(all_work.depth_tests, all_work.fragments);
    assert_eq!(all_work.vertices, mesh.positions.len() as u64);
}

#[test]
fn counts() {
    // Half of a square of 4 × 4 pixels: the diagonal's four pixels go to one of the halves.
    let corners =
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let camera = Camera {
        view_projection: DMat4::IDENTITY,
        viewport: viewport(4, 4),
    };
    let count = |triangles: &[[u32; 3]]| {
        let mesh = Mesh::new(corners.to_vec(), triangles.to_vec()).unwrap();
        let mut depth = DepthBuffer::<Depth16>::new(4, 4).unwrap();
        let mut work = Work::default();
        counted::draw_depth(&mesh, &camera, Cull::Nothing, &mut depth, &mut work).unwrap();
        let mut picture = buffers::new(4, 4, Luma([0u8])).unwrap();
        let mut again = Work::default();
        let mut depth = DepthBuffer::<Depth16>::new(4, 4).unwrap();
        let colours = Colours::One(Luma([1]));
        counted::draw(
            &mesh,
            &camera,
            colours,
            Options::default(),
            &mut picture,
            &mut depth,
            &mut again,
        )
        .unwrap();
        assert_eq!(work, again);
        work
    };
    let both = count(&[[0, 1, 2], [0, 2, 3]]);
    assert_eq!(both.to_string(), "16 fragments, 16 depth tests, 4 vertices");
    assert_eq!(
        count(&[[0, 1, 2]]).fragments + count(&[[0, 2, 3]]).fragments,
        16
    );
    // Hidden fragments are tested as well.
    assert_eq!(
        count(&[[0, 1, 2], [0, 2, 3], [0, 1, 2], [0, 2, 3]]).fragments,
        32
    );
    assert_eq!(count(&[]).to_string(), "4 vertices");
}

/// What lies beyond near and far is no fragment; what is cut gets new vertices; every form counts alike.
#[test]
fn what_is_cut_is_counted() {
    let camera = Camera {
        view_projection: DMat4::IDENTITY,
        viewport: viewport(4, 4),
    };
    // A square of four columns, its depth rising from left to right. Each plane crosses two sides of each half: two new
    // corners. Of a column's four centres one is on the diagonal, a left side of the first half.
    for (slope, z, first, both) in [
        // The middle two columns are in range.
        (2.0, 0.0, "5 fragments, 5 depth tests, 7 vertices", 12),
        // The left two, up to the far plane; the right two, from the near plane on.
        (1.0, 1.0, "3 fragments, 3 depth tests, 5 vertices", 8),
        (1.0, -1.0, "7 fragments, 7 depth tests, 5 vertices", 8),
    ] {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| DVec3::new(x, y, slope * x + z));
        for form in [Form::Plain, Form::Fast] {
            let count = |corners: &[DVec3], triangles: &[[u32; 3]]| {
                let mesh = Mesh::new(corners.to_vec(), triangles.to_vec()).unwrap();
                let mut depth = DepthBuffer::<Depth32F>::new(4, 4).unwrap();
                let mut work = Work::default();
                depth_drawn(&mesh, &camera, Cull::Nothing, &mut depth, form, &mut work).unwrap();
                work
            };
            let half = count(&corners[..3], &[[0, 1, 2]]);
            assert_eq!(half.to_string(), first, "{form:?}");
            let whole = count(&corners, &[[0, 1, 2], [0, 2, 3]]);
            assert_eq!((whole.fragments, whole.vertices), (8, both), "{form:?}");
        }
    }
}

/// Corners farther away than the guard band are cut off, in each direction at its own distance; those on it are not.
#[test]
fn corners_stay_within_the_guard_band() {
    // 2¹⁶ pixels are 2¹³ half widths of 8 pixels, and 2⁸ half heights of 256.
    let camera = Camera {
        view_projection: DMat4::IDENTITY,
        viewport: viewport(16, 512),
    };
    let limit = 1 << 24;
    for (far, cut) in [
        (DVec2::new(8192.0, 0.0), false),
        (DVec2::new(0.0, 256.0), false),
        (DVec2::new(-8192.0, -256.0), false),
        (DVec2::new(8193.0, 0.0), true),
        (DVec2::new(0.0, -257.0), true),
        (DVec2::new(9e4, 0.0), true),
        (DVec2::new(0.0, 9e4), true),
        (DVec2::new(-1e12, 1e12), true),
    ] {
        let corner = far.extend(0.0);
        let positions = vec![
            DVec3::new(-0.5, 0.5, 0.0),
            DVec3::new(0.5, 0.25, 0.0),
            corner,
        ];
        let mesh = Mesh::new(positions, vec![[0, 1, 2]]).unwrap();
        let projected = Projected::new::<Depth24>(&mesh, &camera, &mut ()).unwrap();
        let mut pieces = Pieces::default();
        let mut work = Work::default();
        let found: Vec<_> = projected.pieces(0, &mut pieces, &mut work).iter().collect();
        assert_eq!(work.vertices > 0, cut, "{far}");
        for corner in found.iter().flat_map(|(corners, _)| corners) {
            let from_the_middle = [corner.x - 8 * 256, corner.y - 256 * 256];
            assert!(
                from_the_middle.iter().all(|c| c.abs() <= limit),
                "{far}: {corner:?}"
            );
        }
    }
}

#[test]
fn colours_of_vertices_are_interpolated_in_space() {
    // A floor from distance 1 to 2.
    let at = |x: f64, z: f64| DVec3::new(x, -1.0, -z);
    let mesh = Mesh::new(
        vec![at(-9.0, 1.0), at(9.0, 1.0), at(9.0, 2.0), at(-9.0, 2.0)],
        vec![[0, 1, 2], [0, 2, 3]],
    )
    .unwrap();
    let camera = Camera {
        view_projection: frustum(-1.0, 1.0, -1.0, 0.0, 1.0, 10.0).unwrap(),
        viewport: viewport(1, 2),
    };
    let colours = [0.0f32, 0.0, 1.0, 1.0].map(|v| Luma([v]));
    let mut picture = buffers::new(1, 2, Luma([9.0f32])).unwrap();
    let mut depth = DepthBuffer::<Depth24>::new(1, 2).unwrap();
    draw(
        &mesh,
        &camera,
        Colours::PerVertex(&colours),
        Options::default(),
        &mut picture,
        &mut depth,
    )
    .unwrap();
    // The lower pixel's centre is at y = −3/4 w: w = 4/3, a third of the way. The upper one's at −1/4: w = 4, beyond.
    assert_eq!(picture.as_raw()[0], 9.0);
    assert!((picture.as_raw()[1] - 1.0 / 3.0).abs() <= f32::EPSILON);
}

#[test]
fn refused() {
    let good = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]).unwrap();
    let camera = Camera {
        view_projection: DMat4::IDENTITY,
        viewport: viewport(3, 2),
    };
    let run = |mesh: &Mesh, camera: &Camera, colours: Colours<'_, Luma<u8>>, size: (u32, u32)| {
        let mut picture = buffers::new(size.0, size.1, Luma([7])).unwrap();
        let mut depth = DepthBuffer::<Depth16>::new(3, 2).unwrap();
        let result = draw(
            mesh,
            camera,
            colours,
            Options::default(),
            &mut picture,
            &mut depth,
        );
        if result.is_err() {
            assert!(picture.iter().all(|&v| v == 7) && depth == DepthBuffer::new(3, 2).unwrap());
        }
        result
    };
    let one = Colours::One(Luma([1]));
    let with = |position| Mesh {
        positions: vec![DVec3::ZERO, DVec3::X, position],
        ..good.clone()
    };
    let huge = DVec3::splat(f64::MAX);
    let nan = DVec3::new(0.0, f64::NAN, 0.0);
    let mut matrix = DMat4::IDENTITY;
    matrix.x_axis.z = f64::INFINITY;
    let bad_matrix = Camera {
        view_projection: matrix,
        ..camera
    };
    let doubling = Camera {
        view_projection: DMat4::from_scale(DVec3::splat(2.0)),
        ..camera
    };
    let index = Mesh {
        triangles: vec![[0, 1, 2], [2, 3, 0]],
        ..good.clone()
    };
    let long = Camera {
        viewport: viewport(MAX_SIDE + 1, 1),
        ..camera
    };
    let cases = [
        (run(&good, &camera, one, (3, 2)), "drawn"),
        (
            run(&with(nan), &camera, one, (3, 2)),
            "vertex 2 is at [0, NaN, 0]; its coordinates must be finite numbers",
        ),
        (
            run(&with(huge), &doubling, one, (3, 2)),
            &format!("vertex 2 at {huge} has clip coordinates beyond the largest double"),
        ),
        (
            run(&good, &bad_matrix, one, (3, 2)),
            "the camera's matrix has inf in row 2, column 0; all its numbers must be finite",
        ),
        (
            run(&index, &camera, one, (3, 2)),
            "triangle 1 names vertex 3, but there are 3, numbered from 0",
        ),
        (
            run(&good, &camera, one, (2, 3)),
            "the buffer has 2 × 3 pixels, but the camera's viewport has 3 × 2",
        ),
        (
            run(&good, &camera, Colours::PerTriangle(&[]), (3, 2)),
            "the number of colours is 0, but that of the mesh's triangles is 1; each needs one",
        ),
        (
            run(&good, &camera, Colours::PerVertex(&[Luma([1])]), (3, 2)),
            "the number of colours is 1, but that of the mesh's vertices is 3; each needs one",
        ),
        (
            run(&good, &long, one, (MAX_SIDE + 1, 1)),
            "a picture of 32769 × 1 pixels is too large to draw: a side has at most 32768",
        ),
    ];
    let tall = Camera {
        viewport: viewport(1, MAX_SIDE + 1),
        ..camera
    };
    let mut depth = DepthBuffer::<Depth16>::new(1, MAX_SIDE + 1).unwrap();
    let result = draw_depth(&good, &tall, Cull::Nothing, &mut depth);
    assert_eq!(
        result.unwrap_err().to_string(),
        "a picture of 1 × 32769 pixels is too large to draw: a side has at most 32768"
    );
    // The depth buffer's size is asked as well as the picture's.
    let other = Err(DrawError::Size {
        found: (2, 3),
        viewport: (3, 2),
    });
    let mut picture = buffers::new(3, 2, Luma([7u8])).unwrap();
    let mut depth = DepthBuffer::<Depth16>::new(2, 3).unwrap();
    let options = Options::default();
    assert_eq!(
        draw(&good, &camera, one, options, &mut picture, &mut depth),
        other
    );
    assert_eq!(draw_depth(&good, &camera, Cull::Nothing, &mut depth), other);
    for (result, expected) in cases {
        assert_eq!(
            result.map_or_else(|e| e.to_string(), |()| "drawn".to_owned()),
            expected
        );
    }
}

#[test]
fn degenerate() {
    let empty = Mesh::default();
    let triangle = Mesh::new(
        vec![-DVec3::ONE, DVec3::X, DVec3::Y],
        vec![[0, 1, 2], [0, 0, 0], [1, 2, 1]],
    )
    .unwrap();
    for (width, height) in [(0, 0), (0, 9), (9, 0), (1, 1), (MAX_SIDE, 1), (1, MAX_SIDE)] {
        let camera = Camera {
            view_projection: DMat4::IDENTITY,
            viewport: viewport(width, height),
        };
        for mesh in [&empty, &triangle] {
            let (mut fast, mut plain) = (
                DepthBuffer::<Depth24>::new(width, height).unwrap(),
                DepthBuffer::<Depth24>::new(width, height).unwrap(),
            );
            draw_depth(mesh, &camera, Cull::Nothing, &mut fast).unwrap();
            depth_drawn(
                mesh,
                &camera,
                Cull::Nothing,
                &mut plain,
                Form::Plain,
                &mut (),
            )
            .unwrap();
            assert_eq!(fast.image(), plain.image());
        }
    }
    // All behind the eye; the zero vector for every point; everything on the far plane, which is not nearer than it.
    let camera = looking_at_the_origin(8);
    let behind = Mesh {
        positions: triangle
            .positions
            .iter()
            .map(|p| *p + DVec3::new(2.0, 4.0, 8.0))
            .collect(),
        ..triangle.clone()
    };
    let far = Camera {
        view_projection: DMat4::from_translation(DVec3::Z),
        viewport: viewport(8, 8),
    };
    let flat = Mesh {
        positions: [-DVec3::ONE, DVec3::X, DVec3::Y]
            .map(|p| p * DVec3::new(1.0, 1.0, 0.0))
            .to_vec(),
        ..triangle.clone()
    };
    let nowhere = Camera {
        view_projection: DMat4::ZERO,
        viewport: viewport(8, 8),
    };
    for (mesh, camera) in [(&behind, camera), (&triangle, nowhere), (&flat, far)] {
        let mut depth = DepthBuffer::<Depth16>::new(8, 8).unwrap();
        draw_depth(mesh, &camera, Cull::Nothing, &mut depth).unwrap();
        assert_eq!(depth, DepthBuffer::new(8, 8).unwrap());
    }
}
