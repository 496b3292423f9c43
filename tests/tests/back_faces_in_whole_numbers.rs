//! Back faces in scenes with whole-number corners and cameras: against integer arithmetic.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_hsr::back_face;
use ombra_math::camera::Camera;
use ombra_math::glam::{DMat4, dmat4, dvec3, dvec4};
use ombra_math::mesh::Mesh;
use ombra_math::solids::slide_cube;
use ombra_math::view::Viewport;
use ombra_tests::cases::Random;
use ombra_tests::whole_faces::{Face, Viewer, corner, double};

#[test]
fn back_faces_by_whole_numbers() {
    let mut random = Random::new(44);
    let mut on_edge = 0;
    for _ in 0..400 {
        let faces: Vec<Face> = (0..20)
            .map(|_| Face([(); 3].map(|()| corner(&mut random, 4)).to_vec()))
            .collect();
        let positions = faces
            .iter()
            .flat_map(|face| face.0.iter().copied().map(double))
            .collect();
        let mesh = Mesh::new(
            positions,
            (0..20).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        )
        .unwrap();
        let viewer = Viewer::random(&mut random, &faces);
        let kept: Vec<usize> = (0..20).filter(|&i| viewer.side(&faces[i]) >= 0).collect();
        assert_eq!(back_face::visible(&mesh, viewer.eye()), kept);
        if !viewer.place {
            // From the other side all others are seen, and those edge-on again: halves, exactly.
            let edge_on = (0..20).filter(|&i| viewer.side(&faces[i]) == 0).count();
            let others = back_face::visible(&mesh, -viewer.eye()).len();
            assert_eq!(kept.len() + others, 20 + edge_on);
            on_edge += edge_on;
        }
    }
    assert!(on_edge > 50, "{on_edge}");
}

/// A camera of whole numbers looking along −z from a whole-number eye: clip coordinates are exact, so is the sign.
#[test]
fn object_and_screen_test_of_back_faces_agree() {
    let cube = slide_cube();
    let mut random = Random::new(45);
    let mut counts = [0; 4];
    for _ in 0..2000 {
        let eye = double(corner(&mut random, 60));
        let scale = dmat4(
            dvec4(2.0, 0.0, 0.0, 0.0),
            dvec4(0.0, 2.0, 0.0, 0.0),
            dvec4(0.0, 0.0, -1.0, -1.0),
            dvec4(0.0, 0.0, -2.0, 0.0),
        );
        let view = DMat4::from_translation(-eye);
        let camera = Camera {
            view_projection: scale * view,
            viewport: Viewport {
                width: 64,
                height: 64,
            },
        };
        assert_eq!(camera.eye(), Some(eye.extend(1.0)));
        let kept = back_face::visible(&cube, eye.extend(1.0));
        assert_eq!(back_face::visible_on_screen(&cube, &camera), kept);
        // From outside the cube one to three of its sides are turned to the eye, in its planes one more of them edge-on.
        let sides = [0, 1, 2].map(|k| {
            let [low, high] = cube.bounds().unwrap().map(|corner| corner[k]);
            usize::from(eye[k] <= low) + usize::from(eye[k] >= high)
        });
        let expected: usize = sides.iter().sum();
        assert_eq!(kept.len(), 2 * expected, "{eye}");
        counts[expected] += 1;
    }
    assert!(counts.iter().skip(1).all(|&n| n > 20), "{counts:?}");
    // A face behind the eye, and what the slide's sign of the normal alone would say (E31).
    assert!(!back_face::is_front_facing(
        dvec3(1.0, 0.0, 0.5),
        dvec3(-10.0, 0.0, 5.0)
    ));
}
