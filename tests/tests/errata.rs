//! Where a slide is wrong: each erratum as one assertion on a function, broken by what the slide has and kept by
//! what the crates compute.
//!
//! The slides' versions are typed in here as they are printed, so that whoever types them in learns from the
//! same sentence why they fail.
#![allow(clippy::expect_used, reason = "a test that cannot go on fails")]

use ombra_clip::{Segment, Window, cohen_sutherland};
use ombra_hsr::back_face::{is_front_facing, visible};
use ombra_hsr::image_space::hits;
use ombra_hsr::polygon::Polygon;
use ombra_math::camera::SightLine;
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4, IVec2, dvec3};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;
use ombra_math::solids::slide_cube;
use ombra_math::spherical::Spherical;
use ombra_math::triangle::{face_normal, normal};
use ombra_math::view::look_at;
use ombra_raster::bresenham;
use ombra_shadows::planar::{cast, ground_matrix_directional, ground_matrix_point, shadow_matrix};

type Verdict = Result<(), String>;

/// The slide's version breaks the assertion and says so with these words; ours keeps it.
fn proven(slide: Verdict, words: &str, ours: Verdict) {
    let sentence = slide.expect_err("the slide's version is wrong and was not caught");
    assert!(sentence.contains(words), "{sentence}");
    assert_eq!(ours, Ok(()));
}

/// Two numbers within 4 ε of the larger: a handful of roundings, and the slides are off in the first digit.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs())
}

fn demand(kept: bool, sentence: impl FnOnce() -> String) -> Verdict {
    if kept { Ok(()) } else { Err(sentence()) }
}

/// E1. Bologna, «Ombre su piani in WebGL»: with column vectors M = (π·L) I − L πᵀ.
fn e1(matrix: impl Fn(Plane, DVec4) -> DMat4) -> Verdict {
    let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
    let m = matrix(Plane::GROUND, light);
    let p = project(m * point(dvec3(0.0, 20.0, 0.0))).ok_or("no shadow of (0,20,0)")?;
    demand(p.y == 0.0, || {
        let transposed = if m == matrix_by_the_slide(Plane::GROUND, light) {
            ": this is the transposed matrix"
        } else {
            ""
        };
        format!("the shadow {p} of (0,20,0) is not even on the plane y = 0{transposed}")
    })?;
    demand(p == dvec3(0.0, 0.0, -25.0), || {
        format!("the shadow of (0,20,0) is {p} instead of (0,0,-25)")
    })
}

/// The printed matrix: dot · I minus the rows a·L, b·L, c·L, d·L.
fn matrix_by_the_slide(plane: Plane, light: DVec4) -> DMat4 {
    let dot = plane.coefficients().dot(light);
    let [a, b, c, d] = plane.coefficients().to_array();
    let rows = DMat4::from_cols(a * light, b * light, c * light, d * light).transpose();
    DMat4::IDENTITY * dot - rows
}

#[test]
fn e1_the_matrix_is_transposed() {
    proven(
        e1(matrix_by_the_slide),
        "not even on the plane y = 0: this is the transposed matrix",
        e1(|plane, light| shadow_matrix(plane, light).unwrap()),
    );
    let p = project(
        matrix_by_the_slide(Plane::GROUND, DVec4::new(0.0, 100.0, 100.0, 1.0))
            * point(dvec3(0.0, 20.0, 0.0)),
    );
    assert_eq!(p, Some(dvec3(0.0, -1.0 / 100.0, 0.0)));
}

/// E2. Olomouc, «Projekce na libovolnou plochu»: entry (3,2) is −L_y n_z.
fn e2(shadow: impl Fn(Plane, DVec3, DVec3) -> Option<DVec3>) -> Verdict {
    let plane = Plane {
        normal: dvec3(1.0, 2.0, 3.0),
        d: 4.0,
    };
    let p = shadow(plane, dvec3(3.0, 7.0, 2.0), DVec3::ONE).ok_or("no shadow of (1,1,1)")?;
    // Seventeenths: 17 n·P + 68 of the right point is exactly zero.
    let off = plane.normal.dot(p) + plane.d;
    demand(off.abs() <= 8.0 * f64::EPSILON * plane.d, || {
        format!("n·P + d = {off} instead of 0: the shadow is not on the plane")
    })?;
    let right = [-3.0 / 17.0, -43.0 / 17.0, 7.0 / 17.0];
    demand(
        p.to_array()
            .into_iter()
            .zip(right)
            .all(|(a, b)| close(a, b)),
        || format!("the shadow of (1,1,1) is {p} instead of (-3,-43,7)/17"),
    )
}

#[test]
fn e2_one_entry_of_the_any_plane_matrix() {
    // A matrix for row vectors: (V, 1) M, as the slide prints its rows, misprint and all.
    let by_the_slide = |plane: Plane, l: DVec3, v: DVec3| {
        let (n, d) = (plane.normal, plane.d);
        let nl = n.dot(l);
        let rows = [
            DVec4::new(nl + d - l.x * n.x, -l.y * n.x, -l.z * n.x, -n.x),
            DVec4::new(-l.x * n.y, nl + d - l.y * n.y, -l.z * n.y, -n.y),
            DVec4::new(-l.x * n.z, -l.z * n.z, nl + d - l.z * n.z, -n.z),
            DVec4::new(-l.x * d, -l.y * d, -l.z * d, nl),
        ];
        project(v.x * rows[0] + v.y * rows[1] + v.z * rows[2] + rows[3])
    };
    let proof = |ours: Verdict| proven(e2(by_the_slide), "not on the plane", ours);
    proof(e2(|plane, l, v| cast(plane, point(l), v)));
    proof(e2(|plane, l, v| {
        project(shadow_matrix(plane, point(l)).unwrap() * point(v))
    }));
    // The slide's point and how far it is off: (−3, −28, 7)/17 and 30/17.
    let wall = Plane {
        normal: dvec3(1.0, 2.0, 3.0),
        d: 4.0,
    };
    let p = by_the_slide(wall, dvec3(3.0, 7.0, 2.0), DVec3::ONE).unwrap();
    assert_eq!(p, dvec3(-3.0 / 17.0, -28.0 / 17.0, 7.0 / 17.0));
}

const CUBE: [DVec3; 8] = [
    dvec3(0.0, 20.0, 0.0),
    dvec3(10.0, 20.0, 0.0),
    dvec3(10.0, 20.0, 10.0),
    dvec3(0.0, 20.0, 10.0),
    dvec3(0.0, 30.0, 0.0),
    dvec3(10.0, 30.0, 0.0),
    dvec3(10.0, 30.0, 10.0),
    dvec3(0.0, 30.0, 10.0),
];

/// E3. Olomouc, «Zdroj světla v bodě», example: the cube under the point light (0, 100, 100).
fn e3(shadow: impl Fn(DVec3) -> Option<DVec3>) -> Verdict {
    let (a, b, c) = (100.0 / 7.0, -300.0 / 7.0, -200.0 / 7.0);
    let right = [
        (0.0, -25.0),
        (12.5, -25.0),
        (12.5, -12.5),
        (0.0, -12.5),
        (0.0, b),
        (a, b),
        (a, c),
        (0.0, c),
    ];
    // A light at infinity in the direction (0, 1, 1) moves every corner by −V_y along z, and by nothing along x.
    let as_from_infinity = CUBE
        .iter()
        .all(|&v| shadow(v) == Some(dvec3(v.x, 0.0, v.z - v.y)));
    demand(!as_from_infinity, || {
        "this is the shadow under a light at infinity, not under a lamp at (0,100,100)".into()
    })?;
    for (v, (x, z)) in CUBE.into_iter().zip(right) {
        let p = shadow(v).ok_or_else(|| format!("no shadow of {v}"))?;
        demand(close(p.x, x) && p.y == 0.0 && close(p.z, z), || {
            format!("the shadow of {v} is {p} instead of ({x},0,{z})")
        })?;
    }
    Ok(())
}

#[test]
fn e3_the_answer_for_a_point_light() {
    let printed = |v: DVec3| {
        let x = [0.0, 10.0, 10.0, 0.0, 0.0, 10.0, 10.0, 0.0];
        let z = [-20.0, -20.0, -10.0, -10.0, -30.0, -30.0, -20.0, -20.0];
        let corner = CUBE.iter().position(|&c| c == v)?;
        Some(dvec3(x[corner], 0.0, z[corner]))
    };
    let lamp = dvec3(0.0, 100.0, 100.0);
    let proof = |ours: Verdict| proven(e3(printed), "under a light at infinity", ours);
    proof(e3(|v| cast(Plane::GROUND, point(lamp), v)));
    proof(e3(|v| {
        project(ground_matrix_point(lamp).unwrap() * point(v))
    }));
}

/// E4. Olomouc, «Zdroj v nekonečnu», example: the shadows are places, so their w is 1.
fn e4(shadow: impl Fn(DVec3) -> DVec4) -> Verdict {
    let x = [-20.0, -10.0, -10.0, -20.0, -30.0, -20.0, -20.0, -30.0];
    let z = [-20.0, -20.0, -10.0, -10.0, -30.0, -30.0, -20.0, -20.0];
    for (corner, v) in CUBE.into_iter().enumerate() {
        let p = shadow(v);
        demand(p.w != 0.0, || {
            format!("the shadow {p} of {v} is a direction (w = 0) and not a place")
        })?;
        let right = DVec4::new(x[corner], 0.0, z[corner], 1.0);
        demand(p == right, || {
            format!("the shadow of {v} is {p} instead of {right}")
        })?;
    }
    Ok(())
}

#[test]
fn e4_the_last_row_of_the_answer() {
    // The printed S, column after column.
    let printed = |v: DVec3| {
        let x = [-20.0, -10.0, -10.0, -20.0, -30.0, -20.0, -20.0, -30.0];
        let z = [-20.0, -20.0, -10.0, -10.0, -30.0, -30.0, -20.0, -20.0];
        let corner = CUBE.iter().position(|&c| c == v).unwrap();
        DVec4::new(x[corner], 0.0, z[corner], 0.0)
    };
    let sun = DVec3::splat(10.0);
    proven(
        e4(printed),
        "is a direction (w = 0)",
        e4(|v| ground_matrix_directional(sun).unwrap() * point(v)),
    );
}

/// E5. Olomouc, «Stínová paměť hloubky», example: the light's camera stands at the light and looks at the centre
/// of the scene.
fn e5(camera: impl Fn(DVec3, DVec3) -> DMat4) -> Verdict {
    let (light, centre) = (dvec3(0.0, 30.0, -30.0), dvec3(0.0, 0.0, -20.0));
    let m = camera(light, centre);
    // Rotations and shifts of lengths up to 50: some roundings of 50 ε/2 each.
    let tolerance = 16.0 * 50.0 * f64::EPSILON;
    let eye = m * point(light);
    demand(eye.truncate().length() <= tolerance, || {
        format!("the light goes to {} instead of the origin", eye.truncate())
    })?;
    // A camera looks along −z, so the centre lies √1000 before it.
    let distance = 1000.0_f64.sqrt();
    let seen = (m * point(centre)).truncate();
    demand(
        (seen - dvec3(0.0, 0.0, -distance)).length() <= tolerance,
        || {
            format!(
                "the centre (0,0,-20) is seen at {seen} and not straight ahead, at (0,0,-√1000)"
            )
        },
    )?;
    let ahead = (m.transpose() * DVec4::new(0.0, 0.0, -1.0, 0.0)).truncate();
    let right = dvec3(0.0, -30.0, 10.0) / distance;
    demand((ahead - right).length() <= 16.0 * f64::EPSILON, || {
        format!("the view direction is {ahead} instead of (0,-30,10)/√1000")
    })
}

#[test]
fn e5_the_light_camera() {
    // The slide has two steps, −45° about x and −42.4 along z.
    let shifted = |degrees: f64, shift: f64| {
        move |_: DVec3, _: DVec3| {
            DMat4::from_translation(dvec3(0.0, 0.0, shift))
                * DMat4::from_rotation_x(degrees.to_radians())
        }
    };
    let depth = 1800.0_f64.sqrt();
    let ours = || e5(|eye, centre| look_at(eye, centre, DVec3::Y).unwrap());
    proven(e5(shifted(-45.0, -depth)), "the light goes to", ours());
    // With the angle that does take the light onto the z axis, the camera still looks past the centre.
    proven(e5(shifted(135.0, -depth)), "not straight ahead", ours());
    // What the turns do to the light, by hand.
    for (degrees, goes_to) in [
        (-45.0, dvec3(0.0, 0.0, -depth)),
        (45.0, dvec3(0.0, depth, 0.0)),
        (135.0, dvec3(0.0, 0.0, depth)),
    ] {
        let p = DMat4::from_rotation_x(f64::to_radians(degrees)) * point(dvec3(0.0, 30.0, -30.0));
        assert!((p.truncate() - goes_to).length() <= 16.0 * depth * f64::EPSILON);
    }
}

/// E6. Olomouc, «Prostorové úhly»: tan φ = y/x, and the quadrant is kept.
fn e6(azimuth: impl Fn(DVec3) -> f64) -> Verdict {
    for v in octants() {
        let phi = azimuth(v);
        // The slide's own way back: x = r cos φ sin θ and y = r sin φ sin θ.
        let back = v.truncate().length() * DVec2::new(phi.cos(), phi.sin());
        demand(
            (back - v.truncate()).length() <= 16.0 * f64::EPSILON * v.length(),
            || format!("φ = {phi} of {v} leads back to x, y = {back}"),
        )?;
    }
    Ok(())
}

/// A vector in every octant, no two coordinates of one size.
fn octants() -> impl Iterator<Item = DVec3> {
    (0..8).map(|k| {
        let sign = |bit: u32| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        dvec3(3.0 * sign(0), 2.0 * sign(1), 5.0 * sign(2))
    })
}

#[test]
fn e6_the_azimuth() {
    let ours = || e6(|v| Spherical::from_cartesian(v).phi);
    proven(e6(|v| (v.x / v.y).atan()), "leads back to", ours());
    // The right quotient alone still mistakes a quadrant for the opposite one.
    proven(e6(|v| (v.y / v.x).atan()), "leads back to", ours());
    for v in octants() {
        let back = Spherical::from_cartesian(v).to_cartesian();
        assert!(
            (back - v).length() <= 16.0 * f64::EPSILON * v.length(),
            "{v} comes back as {back}"
        );
    }
}

/// E13. Grafica 3, «Ottimizzazione: Back-face Culling»: the angle is that between the normal and the direction towards
/// the viewer. The function gives the triangles of the cube that are kept, as seen from a place.
fn e13(kept: impl Fn(DVec3) -> Vec<usize>) -> Verdict {
    let eye = dvec3(30.0, 40.0, 50.0);
    let kept = kept(eye);
    demand(kept.len() == 6, || {
        format!("{} of the 12 triangles are kept, not 6", kept.len())
    })?;
    for i in kept {
        let corners = slide_cube().triangle(i).ok_or("no such triangle")?;
        // The eye is beyond x = 10, y = 30 and z = 10, the far sides of the cube 0…10, 20…30, 0…10.
        let on = |axis: usize, at: f64| corners.iter().all(|p| p[axis] == at);
        demand(on(0, 10.0) || on(1, 30.0) || on(2, 10.0), || {
            format!("{corners:?} is kept, a face at the back of the cube as seen from {eye}")
        })?;
    }
    Ok(())
}

#[test]
fn e13_towards_the_viewer() {
    let by_normals = |faces: fn(DVec3, DVec3, DVec3) -> bool| {
        move |eye: DVec3| {
            let cube = slide_cube();
            let is_kept = |&i: &usize| {
                let [a, b, c] = cube.triangle(i).unwrap();
                faces(normal(a, b, c), a, eye)
            };
            (0..cube.triangles.len()).filter(is_kept).collect()
        }
    };
    // «Direzione di vista»: from the eye to the face, the way the viewer looks; angles under 90°.
    let by_the_slide = by_normals(|n, face, eye| n.dot(face - eye) > 0.0);
    let ours = by_normals(|n, face, eye| is_front_facing(n, eye - face));
    proven(
        e13(by_the_slide),
        "a face at the back of the cube",
        e13(ours),
    );
    assert_eq!(e13(|eye| visible(&slide_cube(), point(eye))), Ok(()));
}

/// E14. Olomouc, «Flat shading», second example: the mean of normals is that of unit normals, made unit again.
fn e14(face: impl Fn([DVec3; 3]) -> Option<DVec3>) -> Verdict {
    let normals = [DVec3::X, dvec3(0.5, 1.0, 0.0), dvec3(0.0, 0.5, 0.0)];
    let n = face(normals).ok_or("these three normals have a mean")?;
    demand(close(n.length(), 1.0), || {
        format!("the mean {n} is not of unit length")
    })?;
    // (1,0,0) + (1,2,0)/√5 + (0,1,0), made unit: (√5 + 1, √5 + 2, 0), of which the square is 15 + 6√5.
    let root = 5.0_f64.sqrt();
    let right = dvec3(root + 1.0, root + 2.0, 0.0) / (15.0 + 6.0 * root).sqrt();
    demand((n - right).length() <= 8.0 * f64::EPSILON, || {
        format!("{n} instead of {right}: a longer normal has no larger share")
    })?;
    demand((right - dvec3(0.6071, 0.7947, 0.0)).length() < 1e-4, || {
        "four digits".into()
    })
}

#[test]
fn e14_the_mean_of_vertex_normals() {
    let mean = |[a, b, c]: [DVec3; 3]| Some((a + b + c) / 3.0);
    let made_unit = |n: [DVec3; 3]| mean(n)?.try_normalize();
    proven(e14(mean), "not of unit length", e14(face_normal));
    proven(e14(made_unit), "no larger share", e14(face_normal));
}

/// E15. Grafica 3, «Algoritmo di Bresenham»: in integers it is 2F(M) that decides: start 2dy − dx, steps 2dy and
/// 2dy − 2dx, for 0 ≤ m ≤ 1. The function gives y at x = 0, 1, …, dx.
fn e15(rows: impl Fn(i32, i32) -> Vec<i32>) -> Verdict {
    // An even dx and an odd one, both ends of 0 ≤ m ≤ 1.
    for (dx, dy) in [(8, 3), (3, 1), (5, 3), (4, 0), (3, 3)] {
        let rows = rows(dx, dy);
        demand(rows.len() == dx as usize + 1, || {
            format!(
                "(0,0)→({dx},{dy}) has {} pixels instead of {}",
                rows.len(),
                dx + 1
            )
        })?;
        for (x, &y) in (0..).zip(&rows) {
            // |y − m x| ≤ ½, times 2dx.
            demand(2 * (dx * y - dy * x).abs() <= dx, || {
                format!(
                    "(0,0)→({dx},{dy}): at x = {x} the line passes y = {}/{dx}, \
                     more than half a pixel from {y}: the half of F(M) is lost",
                    dy * x
                )
            })?;
        }
    }
    Ok(())
}

#[test]
fn e15_the_half_in_the_decision() {
    // E for d < 0, NE for d > 0, and for d = 0 either, as the slide allows.
    let by_the_slide = |start: fn(i32, i32) -> i32, tie_goes_up: bool| {
        move |dx: i32, dy: i32| {
            let (mut y, mut d) = (0, start(dx, dy));
            let mut rows = vec![y];
            for _ in 0..dx {
                if d > 0 || (d == 0 && tie_goes_up) {
                    y += 1;
                    d += dy - dx;
                } else {
                    d += dy;
                }
                rows.push(y);
            }
            rows
        }
    };
    let ours = || {
        e15(|dx, dy| {
            bresenham::segment(IVec2::ZERO, IVec2::new(dx, dy))
                .map(|p| p.y)
                .collect()
        })
    };
    let lost = "the half of F(M) is lost";
    // F(1, 1/2) in integers.
    const HALF: i32 = 1 / 2;
    let half_is_nothing: fn(i32, i32) -> i32 = |dx, dy| dy - dx * HALF;
    // No start value on the slide: from 0.
    let from_nothing: fn(i32, i32) -> i32 = |_, _| 0;
    // dx/2 cut off to an integer: right for an even dx, and for an odd one a tie appears that is none.
    let half_cut_off: fn(i32, i32) -> i32 = |dx, dy| dy - dx / 2;
    // The start doubled and the steps not.
    let only_start_doubled: fn(i32, i32) -> i32 = |dx, dy| 2 * dy - dx;
    for start in [half_is_nothing, from_nothing, only_start_doubled] {
        for tie_goes_up in [false, true] {
            proven(e15(by_the_slide(start, tie_goes_up)), lost, ours());
        }
    }
    proven(e15(by_the_slide(half_cut_off, true)), lost, ours());
    // Start and steps doubled.
    let doubled: Vec<i64> = bresenham::trace(IVec2::ZERO, IVec2::new(8, 3))
        .map(|step| step.decision)
        .collect();
    assert_eq!(doubled, [-2, 4, -6, 0, 6, -4, 2, -8]);
}

/// E21. Olomouc, «Zdroj světla v bodě»: w = L_y − V_y is positive for a true shadow, so that clipping keeps it.
fn e21(matrix: impl Fn(DVec3) -> DMat4) -> Verdict {
    let p = matrix(dvec3(0.0, 100.0, 100.0)) * point(dvec3(10.0, 20.0, 10.0));
    demand(project(p) == Some(dvec3(12.5, 0.0, -12.5)), || {
        format!("the shadow of (10,20,10) is {p} instead of (12.5,0,-12.5)")
    })?;
    demand(p.w > 0.0, || {
        format!(
            "w = {} is negative: clipping throws this true shadow away",
            p.w
        )
    })?;
    demand(p.w == 80.0, || {
        format!("w = {} instead of L_y - V_y = 80", p.w)
    })
}

#[test]
fn e21_the_sign_of_w() {
    // The slide's rows: (−y_L, x_L, 0, 0), 0, (0, z_L, −y_L, 0), (0, 1, 0, −y_L).
    let by_the_slide = |l: DVec3| {
        DMat4::from_cols(
            DVec4::new(-l.y, 0.0, 0.0, 0.0),
            DVec4::new(l.x, 0.0, l.z, 1.0),
            DVec4::new(0.0, 0.0, -l.y, 0.0),
            DVec4::new(0.0, 0.0, 0.0, -l.y),
        )
    };
    let proof = |ours: Verdict| proven(e21(by_the_slide), "w = -80 is negative", ours);
    proof(e21(|l| ground_matrix_point(l).unwrap()));
    proof(e21(|l| shadow_matrix(Plane::GROUND, point(l)).unwrap()));
}

type Clipped = Result<Option<Segment>, String>;

/// E22. Grafica 3, «Algoritmo Cohen-Sutherland»: each iteration tests OR and AND.
fn e22(clip: impl Fn(&Window, Segment) -> Clipped) -> Verdict {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).map_err(|e| e.to_string())?;
    let across = Segment::new(DVec2::new(2.0, 14.0), DVec2::new(8.0, -4.0));
    let inside = Segment::new(DVec2::new(10.0 / 3.0, 10.0), DVec2::new(20.0 / 3.0, 0.0));
    let found = clip(&window, across)?;
    // Two cuts of some roundings each.
    let near = |p: DVec2, q: DVec2| close(p.x, q.x) && close(p.y, q.y);
    let both = found.is_some_and(|s| near(s.a, inside.a) && near(s.b, inside.b));
    demand(both, || {
        format!("{across:?} gives {found:?} instead of {inside:?}")
    })?;
    let beside = Segment::new(DVec2::new(4.0, 14.0), DVec2::new(14.0, 8.0));
    let found = clip(&window, beside)?;
    demand(found.is_none(), || {
        format!("{beside:?} passes the corner (10,10) outside, and {found:?} is left of it")
    })
}

#[test]
fn e22_and_in_each_iteration() {
    // The slide's order: above, below, right, left.
    let code = |w: &Window, p: DVec2| [p.y > w.max.y, p.y < w.min.y, p.x > w.max.x, p.x < w.min.x];
    let written = |code: [bool; 4]| {
        code.map(|bit| if bit { '1' } else { '0' })
            .iter()
            .collect::<String>()
    };
    let crossing = |w: &Window, s: Segment, bit: usize| {
        let d = s.b - s.a;
        let across = |y: f64| DVec2::new(s.a.x + (y - s.a.y) * d.x / d.y, y);
        let upright = |x: f64| DVec2::new(x, s.a.y + (x - s.a.x) * d.y / d.x);
        match bit {
            0 => across(w.max.y),
            1 => across(w.min.y),
            2 => upright(w.max.x),
            _ => upright(w.min.x),
        }
    };
    let by_the_slide = |w: &Window, given: Segment| -> Clipped {
        let mut s = given;
        if (0..4).any(|bit| code(w, s.a)[bit] && code(w, s.b)[bit]) {
            return Ok(None);
        }
        loop {
            let (a, b) = (code(w, s.a), code(w, s.b));
            if (0..4).all(|bit| !a[bit] && !b[bit]) {
                return Ok(Some(s));
            }
            let Some(bit) = (0..4).find(|&bit| a[bit] != b[bit]) else {
                return Err(format!(
                    "cut to {} → {}, with codes {} and {}: not inside, and no bit differs",
                    s.a,
                    s.b,
                    written(a),
                    written(b)
                ));
            };
            let p = crossing(w, s, bit);
            if a[bit] { s.a = p } else { s.b = p }
        }
    };
    let ours = || e22(|window, s| Ok(cohen_sutherland::clip_segment(window, s)));
    proven(
        e22(by_the_slide),
        "codes 0010 and 0010: not inside, and no bit differs",
        ours(),
    );
    // A loop that then cuts at whatever bit is set, with no AND either, keeps a part that is not there.
    let whatever_bit = |w: &Window, given: Segment| -> Clipped {
        let mut s = given;
        for _ in 0..4 {
            for bit in 0..4 {
                if code(w, s.a)[bit] {
                    s.a = crossing(w, s, bit);
                }
                if code(w, s.b)[bit] {
                    s.b = crossing(w, s, bit);
                }
            }
        }
        Ok(Some(s))
    };
    proven(
        e22(whatever_bit),
        "passes the corner (10,10) outside",
        ours(),
    );
    // Where the slide's loop stands still.
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let last = cohen_sutherland::trace(
        &window,
        Segment::new(DVec2::new(4.0, 14.0), DVec2::new(14.0, 8.0)),
    );
    let last = last.last().unwrap();
    assert_eq!(last.segment.a, DVec2::new(32.0 / 3.0, 10.0));
    assert_eq!(last.codes.map(|code| code.to_string()), ["0010", "0010"]);
    assert_eq!(last.decision, cohen_sutherland::Decision::Reject);
}

/// E23. Grafica 3, «Approccio Image-Space»: of the intersections with the primitives' planes, the nearest that is inside
/// its primitive and in front of the eye.
fn e23(nearest: impl Fn(&[Polygon], SightLine) -> Option<usize>) -> Verdict {
    let triangle = |x: f64, z: f64| Polygon {
        vertices: vec![dvec3(x, 0.0, z), dvec3(x + 4.0, 0.0, z), dvec3(x, 4.0, z)],
    };
    // One beside the line, one behind the eye, and two that are met, the farther one first.
    let scene = [
        triangle(5.0, -1.0),
        triangle(0.0, 0.5),
        triangle(0.0, -7.0),
        triangle(0.0, -3.0),
    ];
    let line = SightLine {
        origin: dvec3(1.0, 1.0, 0.0),
        direction: -DVec3::Z,
    };
    let seen = nearest(&scene, line).ok_or("the line meets two triangles, and none is seen")?;
    demand(seen != 1, || {
        "triangle 1 is seen, which lies behind the eye".into()
    })?;
    demand(seen != 0, || {
        "triangle 0 is seen, of which the line meets only the plane".into()
    })?;
    demand(seen == 3, || {
        format!("triangle {seen} is seen, but 3 is nearer")
    })
}

#[test]
fn e23_inside_and_in_front() {
    let ours = || e23(|scene, line| hits(scene, line).first().map(|hit| hit.primitive));
    // The intersection with the plane of each primitive; the one at the least distance from the centre of projection.
    let by_the_slide = |in_front: bool| {
        move |scene: &[Polygon], line: SightLine| {
            let t = |polygon: &Polygon| {
                let plane = polygon.plane().unwrap();
                -plane.coefficients().dot(point(line.origin)) / plane.normal.dot(line.direction)
            };
            let met = (0..scene.len()).map(|i| (i, t(&scene[i])));
            let met = met.filter(|&(_, t)| !in_front || t >= 0.0);
            let least = met.min_by(|(_, t), (_, u)| t.abs().total_cmp(&u.abs()));
            least.map(|(i, _)| i)
        }
    };
    proven(
        e23(by_the_slide(false)),
        "which lies behind the eye",
        ours(),
    );
    proven(e23(by_the_slide(true)), "only the plane", ours());
}

/// E30. Olomouc, «Prostorové úhly»: θ is the polar angle, from the z axis, 0 to π.
fn e30(theta: impl Fn(DVec3) -> f64) -> Verdict {
    use std::f64::consts::{FRAC_PI_2, PI};
    for (v, right) in [
        (DVec3::Z, 0.0),
        (DVec3::X, FRAC_PI_2),
        (-DVec3::Z, PI),
        (dvec3(0.0, 3.0, -3.0), 3.0 * PI / 4.0),
    ] {
        let computed = theta(v);
        demand(close(computed, right), || {
            format!("θ of {v} is {computed} instead of {right}, the angle from the z axis")
        })?;
    }
    for v in octants() {
        // The slide's own way back: z = r cos θ.
        let z = v.length() * theta(v).cos();
        demand((z - v.z).abs() <= 16.0 * f64::EPSILON * v.length(), || {
            format!("θ = {} of {v} leads back to z = {z}", theta(v))
        })?;
    }
    Ok(())
}

#[test]
fn e30_the_polar_angle() {
    let ours = || e30(|v| Spherical::from_cartesian(v).theta);
    let elevation = |v: DVec3| v.z.atan2(v.truncate().length());
    proven(e30(elevation), "the angle from the z axis", ours());
    // tan θ = √(x² + y²)/z, as printed, loses what is below the xy plane.
    let tangent = |v: DVec3| (v.truncate().length() / v.z).atan();
    proven(e30(tangent), "the angle from the z axis", ours());
}

/// E31. Grafica 3, «Back Face Culling»: where the viewer is decides, not the sign of the normal's z. The function tells
/// for a face with this normal at this place, in eye coordinates, whether it may be seen.
fn e31(faces: impl Fn(DVec3, DVec3) -> bool) -> Verdict {
    // (face, normal, n·v by hand, v = −face)
    for (face, n, product) in [
        (dvec3(10.0, 0.0, -5.0), dvec3(1.0, 0.0, 0.5), -7.5),
        (dvec3(10.0, 0.0, -5.0), dvec3(-1.0, 0.0, -0.5), 7.5),
        (dvec3(0.0, -4.0, -1.0), dvec3(0.0, -1.0, 2.0), -2.0),
        (dvec3(0.0, 0.0, -5.0), DVec3::Z, 5.0),
    ] {
        demand(n.dot(-face) == product, || "n·v by hand".into())?;
        let (seen, side) = (product > 0.0, if product > 0.0 { "front" } else { "back" });
        demand(faces(n, face) == seen, || {
            format!(
                "the face at {face} with the normal {n} shows its {side} to the eye at 0, n·v = {product}, though \
                 the normal's z is {}",
                n.z
            )
        })?;
    }
    Ok(())
}

#[test]
fn e31_the_sign_of_z() {
    let ours = || e31(|n, face| is_front_facing(n, -face));
    let words = "shows its back to the eye at 0, n·v = -7.5, though the normal's z is 0.5";
    proven(e31(|n, _| n.z > 0.0), words, ours());
    // After the projection the sign is that of the triangle's own normal, x to the right and y up: its signed area. The
    // normal taken along as a plane, π M⁻¹, points to where OpenGL's z is less, so its z is negative for a front face.
    let projection = ombra_math::view::frustum(-3.0, 3.0, -3.0, 3.0, 1.0, 10.0).unwrap();
    let taken_along = |n: DVec3, face: DVec3| {
        let plane = Plane::through(face, n).unwrap().coefficients();
        (projection.inverse().transpose() * plane).z
    };
    proven(
        e31(|n, face| taken_along(n, face) > 0.0),
        "n·v = -7.5",
        ours(),
    );
    assert_eq!(e31(|n, face| taken_along(n, face) < 0.0), Ok(()));
}
