use super::*;
use crate::view::{frustum, frustum_infinite, look_at, orthographic, perspective};
use ombra_oracle::Exact;
use proptest::num::f64::ANY;
use proptest::prelude::*;

const VIEWPORT: Viewport = Viewport {
    width: 640,
    height: 480,
};

fn camera(projection: DMat4, eye: DVec3) -> Camera {
    let view = look_at(eye, DVec3::new(1.0, 2.0, -3.0), DVec3::Y).unwrap();
    Camera {
        view_projection: projection * view,
        viewport: VIEWPORT,
    }
}

#[test]
fn degenerate() {
    let perspective = perspective(1.0, 4.0 / 3.0, 0.1, 100.0).unwrap();
    let good = camera(perspective, DVec3::new(5.0, 4.0, 6.0));
    let line_of = |camera: Camera| camera.sight_line(DVec2::new(320.5, 240.5));
    assert!(good.eye().is_some() && line_of(good).is_some());
    for matrix in [
        DMat4::ZERO,
        DMat4::NAN,
        DMat4::from_diagonal(DVec4::new(1.0, 0.0, 1.0, 1.0)),
        DMat4::from_diagonal(DVec4::splat(f64::INFINITY)),
        perspective * f64::MAX,
    ] {
        let bad = Camera {
            view_projection: matrix,
            ..good
        };
        assert_eq!((bad.eye(), line_of(bad)), (None, None), "{matrix}");
    }
    let empty = Camera {
        viewport: Viewport {
            width: 0,
            height: 480,
        },
        ..good
    };
    assert_eq!(line_of(empty), None);
    for pixel in [DVec2::NAN, DVec2::INFINITY] {
        assert_eq!(good.sight_line(pixel), None);
    }
    // Behind the eye, and in the plane of the eye.
    assert_eq!(good.to_pixel(DVec3::new(9.0, 6.0, 15.0)), None);
    assert_eq!(good.to_pixel(good.eye().unwrap().truncate()), None);
    assert_eq!(good.to_pixel(DVec3::NAN), None);
}

/// The products on the way to such an eye are beyond the doubles, the eye is not.
#[test]
fn eyes_far_away_are_found() {
    let projection = frustum(-1.0, 1.0, -1.0, 1.0, 1e240, 1e260).unwrap();
    for (far, factor) in [(1e250, 1e50), (1e250, 1e-50), (1e300, 1.0), (1e307, 1.0)] {
        let eye = DVec3::new(far, 0.5 * far, 0.25 * far);
        let view = look_at(eye, DVec3::ZERO, DVec3::Y).unwrap();
        let scale = DMat4::from_diagonal(DVec4::new(1e-240, 1e-240, 1.0, 1.0));
        let camera = Camera {
            view_projection: scale * projection * view * factor,
            viewport: VIEWPORT,
        };
        let found = camera.eye().unwrap().truncate();
        assert!(
            ((found - eye) / far).length() <= 32.0 * f64::EPSILON,
            "{far:e}: {found}"
        );
    }
}

#[test]
fn a_parallel_view_looks_along_one_direction() {
    let projection = orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 50.0).unwrap();
    let at = DVec3::new(5.0, 4.0, 6.0);
    let camera = camera(projection, at);
    let eye = camera.eye().unwrap();
    let back = (at - DVec3::new(1.0, 2.0, -3.0)).normalize();
    assert_eq!(eye.w, 0.0);
    // Three roundings a coordinate in the view matrix, a dozen in the cross product.
    assert!((eye.truncate() - back).length() <= 16.0 * f64::EPSILON);
    for pixel in [DVec2::new(0.5, 0.5), DVec2::new(600.0, 13.0)] {
        let line = camera.sight_line(pixel).unwrap();
        assert!((line.direction + back).length() <= 16.0 * f64::EPSILON);
    }
}

/// A window beside the axis of view, seen from (1, 2, 3) along −z: the lines by hand.
#[test]
fn a_window_beside_the_axis() {
    let eye = DVec3::new(1.0, 2.0, 3.0);
    let view = look_at(eye, eye - DVec3::Z, DVec3::Y).unwrap();
    let viewport = Viewport {
        width: 4,
        height: 2,
    };
    for projection in [
        frustum(1.0, 3.0, -1.0, 0.0, 2.0, 10.0),
        frustum_infinite(1.0, 3.0, -1.0, 0.0, 2.0),
    ] {
        let camera = Camera {
            view_projection: projection.unwrap() * view,
            viewport,
        };
        assert_eq!(camera.eye(), Some(eye.extend(1.0)));
        for (pixel, to) in [
            ((0.0, 0.0), (1.0, 0.0)),
            ((4.0, 0.0), (3.0, 0.0)),
            ((0.0, 2.0), (1.0, -1.0)),
            ((2.0, 1.0), (2.0, -0.5)),
            // Beside the picture is a line too.
            ((-2.0, 3.0), (0.0, -1.5)),
        ] {
            let line = camera.sight_line(pixel.into()).unwrap();
            let way = DVec3::new(to.0, to.1, -2.0);
            // Sums and products of three numbers below 16.
            let tolerance = 16.0 * 4.0 * f64::EPSILON;
            assert!(
                (line.origin - (eye + way)).length() <= tolerance,
                "{pixel:?} {line:?}"
            );
            assert!(
                (line.direction - way.normalize()).length() <= tolerance,
                "{pixel:?} {line:?}"
            );
            let seen = camera.to_pixel(eye + 3.0 * way).unwrap();
            assert!(
                (seen.truncate() - DVec2::from(pixel)).length() <= tolerance,
                "{pixel:?} {seen}"
            );
        }
    }
}

/// One pixel that shows a box beside the axis from above: right is +x, up is −z.
#[test]
fn a_picture_of_one_pixel() {
    let eye = DVec3::new(0.0, 10.0, 0.0);
    let view = look_at(eye, DVec3::ZERO, DVec3::NEG_Z).unwrap();
    let projection = orthographic(0.0, 8.0, 0.0, 6.0, 1.0, 9.0).unwrap();
    let camera = Camera {
        view_projection: projection * view,
        viewport: Viewport {
            width: 1,
            height: 1,
        },
    };
    assert_eq!(camera.eye(), Some(DVec4::Y));
    let line = camera.sight_line(DVec2::splat(0.5)).unwrap();
    let expected = SightLine {
        origin: DVec3::new(4.0, 9.0, -3.0),
        direction: DVec3::NEG_Y,
    };
    assert!(
        (line.origin - expected.origin).length() <= 16.0 * 4.0 * f64::EPSILON,
        "{line:?}"
    );
    assert_eq!(line.direction, expected.direction);
    let corner = camera.to_pixel(DVec3::new(8.0, 1.0, 0.0)).unwrap();
    assert!(
        (corner - DVec3::ONE).length() <= 8.0 * f64::EPSILON,
        "{corner}"
    );
}

#[test]
fn a_multiple_of_a_matrix_is_the_same_camera() {
    let pixel = DVec2::new(17.5, 400.5);
    for projection in [
        frustum(-0.3, 0.5, -0.4, 0.2, 0.5, 100.0).unwrap(),
        orthographic(-4.0, 5.0, -3.0, 2.0, 1.0, 50.0).unwrap(),
    ] {
        let camera = camera(projection, DVec3::new(5.0, 4.0, 6.0));
        let (eye, line) = (camera.eye().unwrap(), camera.sight_line(pixel).unwrap());
        for exponent in [-900, -300, -100, 100, 300, 900] {
            let factor = libm::scalbn(1.0, exponent);
            let multiple = Camera {
                view_projection: camera.view_projection * factor,
                ..camera
            };
            assert_eq!(multiple.eye(), Some(eye), "2^{exponent}");
            assert_eq!(multiple.sight_line(pixel), Some(line), "2^{exponent}");
        }
    }
}

#[test]
fn boxes_of_all_sizes() {
    for size in [1e-200, 1e-30, 1e30, 1e200] {
        let projection = orthographic(-size, size, -size, size, size, 3.0 * size).unwrap();
        let camera = Camera {
            view_projection: projection,
            viewport: Viewport {
                width: 4,
                height: 4,
            },
        };
        assert_eq!(camera.eye(), Some(DVec4::Z), "{size:e}");
        let line = camera.sight_line(DVec2::ONE).unwrap();
        let off = line.origin / size - DVec3::new(-0.5, 0.5, -1.0);
        assert!(off.length() <= 16.0 * f64::EPSILON, "{size:e}: {line:?}");
        assert_eq!(line.direction, DVec3::NEG_Z, "{size:e}");
    }
}

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// x, y, z or w of the point on three planes by Leibniz' formula, and the sum of the magnitudes of its six products.
fn exact_minor(planes: [DVec4; 3], left_out: usize) -> (Exact, Exact) {
    let [a, b, c] = planes.map(|plane| {
        let kept = (0..4).filter(|&i| i != left_out);
        kept.map(|i| exact(plane[i])).collect::<Vec<_>>()
    });
    let mut sums = (Exact::ZERO, Exact::ZERO);
    for [i, j, k] in [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [1, 0, 2],
        [2, 1, 0],
    ] {
        let product = &a[i] * &b[j] * &c[k];
        sums.1 += product.abs();
        let is_even = (i + 1) % 3 == j;
        if is_even == left_out.is_multiple_of(2) {
            sums.0 += product;
        } else {
            sums.0 -= product;
        }
    }
    sums
}

proptest! {
    /// Points of the sight line come out at the pixel it was asked for, the first at depth 0; seen from a place, it
    /// passes through the eye.
    #[test]
    fn sight_lines_meet_their_pixel(
        eye in prop::array::uniform3(2.0..9.0),
        pixel in (0.0..640.0, 0.0..480.0),
        t in 0.0..20.0,
        kind in 0..3,
    ) {
        let projection = match kind {
            0 => perspective(1.0, 4.0 / 3.0, 0.5, 100.0),
            1 => frustum_infinite(-0.2, 0.5, -0.3, 0.4, 0.5),
            _ => orthographic(-4.0, 4.0, -3.0, 3.0, 0.5, 50.0),
        }.unwrap();
        let (eye, pixel) = (DVec3::from(eye), DVec2::from(pixel));
        let camera = camera(projection, eye);
        let line = camera.sight_line(pixel).unwrap();
        // A few dozen roundings, seen at 640 pixels.
        let tolerance = 64.0 * f64::EPSILON * 640.0;
        let near = camera.to_pixel(line.origin).unwrap();
        let found = camera.to_pixel(line.at(t)).unwrap();
        prop_assert!((near.truncate() - pixel).length() < tolerance, "{near}");
        prop_assert!((found.truncate() - pixel).length() < tolerance, "{found}");
        prop_assert!(near.z.abs() < tolerance && found.z >= near.z);
        let place = camera.eye().unwrap();
        prop_assert_eq!(place.w == 1.0, kind < 2);
        if kind < 2 {
            prop_assert!((place.truncate() - eye).length() < 256.0 * f64::EPSILON * eye.length());
            let off = (line.origin - eye).normalize() - line.direction;
            prop_assert!(off.length() < tolerance, "{off}");
        }
    }

    /// The eye against the exact solution of the same three equations.
    #[test]
    fn the_eye_is_where_the_matrix_says(
        eye in prop::array::uniform3(-1.0..1.0f64),
        decades in 0..7i32,
        window in prop::array::uniform4(0.1..2.0f64),
        beside in -3.0..3.0f64,
    ) {
        let eye = DVec3::from(eye) * 10f64.powi(decades);
        let [l, r, b, t] = window;
        let projection = frustum(beside - l, beside + r, -b, t, 0.5, 100.0).unwrap();
        let camera = camera(projection, eye);
        let [x, y, _, w] = camera.rows();
        let found = camera.eye().unwrap();
        prop_assert_eq!(found.w, 1.0);
        let (bottom, bottom_size) = exact_minor([x, y, w], 3);
        for i in 0..3 {
            let (top, top_size) = exact_minor([x, y, w], i);
            let coordinate = exact(found[i]);
            // Each minor is off by some four roundings of its products, and the quotient by one more.
            let bound = (top_size + coordinate.abs() * &bottom_size) * exact(4.0 * f64::EPSILON);
            let off = (coordinate * &bottom - top).abs();
            prop_assert!(off <= bound, "{i}: {found}");
        }
    }

    #[test]
    fn never_panics(m in prop::array::uniform16(ANY), p in prop::array::uniform3(ANY)) {
        let camera = Camera { view_projection: DMat4::from_cols_array(&m), viewport: VIEWPORT };
        let p = DVec3::from(p);
        let _ = (camera.eye(), camera.to_pixel(p), camera.sight_line(p.truncate()));
    }
}
