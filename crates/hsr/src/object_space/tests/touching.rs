//! Faces and meshes that touch.

use super::sight_lines::inside_its_source;
use super::*;

#[test]
fn faces_that_touch_cut_nothing() {
    let eye = DVec3::new(3.0, 4.0, 5.0);
    for k in 0..300 {
        let axis = DVec3::new(1.0, f64::from(k % 7) - 3.0, 0.5).normalize();
        let (turn, shift) = (
            DQuat::from_axis_angle(axis, 0.1 * f64::from(k)),
            DVec3::splat(0.3 * f64::from(k % 5)),
        );
        let faces = cube(turn, shift);
        for w in [0.0, 1.0] {
            let seen_from = (turn * eye + w * shift).extend(w);
            // Outside, the three faces at the corner (1, 1, 1).
            let expected: Vec<_> = [1, 3, 5].map(|i| (i, faces[i].clone())).to_vec();
            let parts = visible_parts(&faces, seen_from);
            assert_eq!(parts, expected, "{k} {w}");
        }
        // Inside, all six.
        let inside = visible_parts(
            &faces,
            (turn * DVec3::new(0.3, 0.6, 0.2) + shift).extend(1.0),
        );
        assert_eq!(
            inside,
            faces.iter().cloned().enumerate().collect::<Vec<_>>()
        );
    }
}

/// The eye on the plane of a face but for the rounding of its corners: the face may be seen, at an angle of 10⁻¹⁶.
#[test]
fn faces_edge_on_but_for_rounding() {
    for k in 0..300 {
        let axis = DVec3::new(1.0, f64::from(k % 7) - 3.0, 0.5).normalize();
        let (turn, shift) = (
            DQuat::from_axis_angle(axis, 0.1 * f64::from(k)),
            DVec3::splat(0.3 * f64::from(k % 5)),
        );
        let faces = cube(turn, shift);
        let place = (turn * DVec3::new(3.0, 0.5, 1.0) + shift).extend(1.0);
        let direction = (turn * DVec3::new(1.0, 0.2, 0.0)).extend(0.0);
        for (eye, seen, hidden) in [
            (place, [5, 5], [0, 2, 3, 4]),
            (direction, [3, 5], [0, 0, 2, 4]),
        ] {
            let parts = visible_parts(&faces, eye);
            for source in seen {
                close(areas(&parts, source), 1.0, 4.0);
            }
            let angle = |p: &Polygon| {
                let away = p.centroid().unwrap() - eye.truncate();
                let ray = if eye.w == 0.0 { eye.truncate() } else { away };
                p.plane()
                    .unwrap()
                    .normal
                    .normalize()
                    .dot(ray.normalize())
                    .abs()
            };
            for (source, part) in &parts {
                // What else is seen is a face in line with the eye.
                let flat = angle(&faces[*source]) < 1e-15 * 16.0;
                assert!(seen.contains(source) || flat, "{k}: {source} {part:?}");
                assert!(
                    !hidden.contains(source) || eye.w == 0.0 && flat,
                    "{k}: {source}"
                );
            }
        }
    }
}

/// Many cuts of cuts: triangles of a mesh before another mesh.
#[test]
fn meshes_leave_no_slivers() {
    let grid = |z: f64, shift: f64, turn: f64| {
        let turn = DQuat::from_axis_angle(DVec3::new(0.1, 0.2, 1.0).normalize(), turn);
        let at = move |i: i32, j: i32| turn * DVec3::new(f64::from(i) + shift, f64::from(j), z);
        let cells = (0..36).map(move |k| (k % 6 - 3, k / 6 - 3));
        cells.flat_map(move |(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [vec![a, b, c], vec![a, c, d]].map(|vertices| Polygon { vertices })
        })
    };
    let scene: Vec<_> = grid(0.0, 0.0, 0.0).chain(grid(1.0, 0.25, 0.3)).collect();
    for eye in [DVec4::Z, place(0.1, 0.2, 9.0)] {
        let parts = visible_parts(&scene, eye);
        for (source, part) in &parts {
            inside_its_source(part, &scene[*source]);
            // Real slivers are rare here: 10⁻⁹ is far above rounding and far below the cells.
            assert!(part.area() > 1e-9, "{} {:e}", source, part.area());
        }
        let whole: f64 = parts
            .iter()
            .filter(|(i, _)| *i >= 72)
            .map(|(_, p)| p.area())
            .sum();
        close(whole, 36.0, 36.0 * 36.0);
    }
}
