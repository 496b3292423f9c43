//! Four methods, one picture: object space, image space, the painter and the z-buffer see the same in the same scenes.
//!
//! The rays of image space are the reference. Where another method shows another primitive, that pixel's centre lies so
//! close to an edge, or to a line in which two primitives cross, that rounding decides; how close, and how many such
//! pixels there are, is asserted for each scene.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_hsr::object_space::visible_parts;
use ombra_hsr::picture::{Difference, IdBuffer, NOTHING, compare, paint, polygons, triangles};
use ombra_hsr::polygon::Polygon;
use ombra_hsr::{back_face, image_space, painter, z_buffer};
use ombra_math::camera::Camera;
use ombra_math::glam::{DMat3, DVec3, dvec3};
use ombra_math::solids::{cuboid, sphere, teapot};
use ombra_math::view::{Viewport, look_at, orthographic, perspective};
use ombra_raster::attributes::{linear, weights};
use ombra_raster::buffers::{self, image::Luma};
use ombra_raster::triangle::{cover, snap};
use ombra_tests::cases::Random;
use z_buffer::{Colours, Cull, DepthBuffer, Options, ReversedDepth32F};

const SIZE: u32 = 120;

struct PolygonsInView {
    name: &'static str,
    polygons: Vec<Polygon>,
    camera: Camera,
}

fn scene(name: &'static str, polygons: Vec<Polygon>, camera: Camera) -> PolygonsInView {
    PolygonsInView {
        name,
        polygons,
        camera,
    }
}

const VIEWPORT: Viewport = Viewport {
    width: SIZE,
    height: SIZE,
};

fn from(eye: DVec3, target: DVec3) -> Camera {
    let view = look_at(eye, target, DVec3::Y).unwrap();
    Camera {
        view_projection: perspective(0.9, 1.0, 0.125, 60.0).unwrap() * view,
        viewport: VIEWPORT,
    }
}

/// A parallel view that is 2·half wide.
fn along(towards_viewer: DVec3, half: f64) -> Camera {
    let view = look_at(30.0 * towards_viewer.normalize(), DVec3::ZERO, DVec3::Y).unwrap();
    let projection = orthographic(-half, half, -half, half, 1.0, 60.0).unwrap();
    Camera {
        view_projection: projection * view,
        viewport: VIEWPORT,
    }
}

fn polygon(vertices: &[(f64, f64, f64)]) -> Polygon {
    Polygon::new(vertices.iter().map(|&v| DVec3::from(v)).collect()).unwrap()
}

fn solid(min: (f64, f64, f64), max: (f64, f64, f64)) -> Vec<Polygon> {
    polygons(&cuboid(DVec3::from(min), DVec3::from(max)).unwrap())
}

/// Boxes that stand on a floor and on each other: common edges and faces, exactly.
fn boxes() -> Vec<Polygon> {
    let floor = polygon(&[
        (-6.0, 0.0, 6.0),
        (6.0, 0.0, 6.0),
        (6.0, 0.0, -6.0),
        (-6.0, 0.0, -6.0),
    ]);
    let boxes = [
        solid((-4.0, 0.0, -3.0), (-1.0, 2.0, 0.0)),
        solid((-4.0, 2.0, -3.0), (-2.0, 5.0, -1.0)),
        solid((0.0, 0.0, -4.0), (2.0, 4.0, -2.0)),
        solid((2.0, 0.0, -4.0), (5.0, 1.0, 1.0)),
    ];
    std::iter::once(floor)
        .chain(boxes.into_iter().flatten())
        .collect()
}

/// Three sticks, each over the next.
fn sticks() -> Vec<Polygon> {
    (0..3)
        .map(|k| {
            let turn = DMat3::from_rotation_z(f64::from(k) * std::f64::consts::TAU / 3.0);
            let corners = [
                (-4.0, -1.5, -1.0),
                (4.0, -1.5, 1.0),
                (4.0, -0.75, 1.0),
                (-4.0, -0.75, -1.0),
            ];
            let vertices = corners.map(|v| turn * DVec3::from(v)).to_vec();
            Polygon::new(vertices).unwrap()
        })
        .collect()
}

/// Triangles anywhere: most pass through others.
fn random(count: usize, seed: u64) -> Vec<Polygon> {
    let mut random = Random::new(seed);
    let mut point = || [(); 3].map(|()| random.between(-3.0, 3.0));
    (0..count)
        .map(|_| {
            let vertices = [(); 3].map(|()| DVec3::from(point())).to_vec();
            Polygon::new(vertices).unwrap()
        })
        .collect()
}

fn scenes() -> Vec<PolygonsInView> {
    let crossing = vec![
        polygon(&[(-3.0, -2.0, -1.0), (3.0, -2.0, 2.0), (0.0, 3.0, 1.0)]),
        polygon(&[(-3.0, 2.0, 2.0), (0.5, -3.0, -1.0), (3.0, 2.5, -2.0)]),
    ];
    let within = [
        solid((-5.0, -5.0, -5.0), (5.0, 5.0, 5.0)),
        polygons(&sphere(1.0, 12, 6).unwrap()),
    ];
    let pieces = vec![
        polygon(&[
            (-3.0, -3.0, 0.0),
            (1.0, -3.0, 0.0),
            (1.0, 1.0, 0.0),
            (-3.0, 1.0, 0.0),
        ]),
        polygon(&[
            (-1.0, -1.0, 0.0),
            (3.0, -1.0, 0.0),
            (3.0, 3.0, 0.0),
            (-1.0, 3.0, 0.0),
        ]),
        polygon(&[
            (-2.0, 2.0, 1.0),
            (-2.0, -2.0, 1.0),
            (2.0, -2.0, -1.0),
            (2.0, 2.0, -1.0),
        ]),
    ];
    let pot = polygons(&teapot(3).unwrap());
    let towards = dvec3(3.0, 4.0, 7.0);
    vec![
        scene(
            "boxes",
            boxes(),
            from(dvec3(7.0, 8.0, 11.0), dvec3(0.0, 1.0, 0.0)),
        ),
        scene("boxes, parallel", boxes(), along(towards, 7.0)),
        scene(
            "teapot",
            pot.clone(),
            from(dvec3(2.0, 5.0, 8.0), dvec3(0.0, 1.25, 0.0)),
        ),
        scene("teapot, parallel", pot, along(towards, 4.0)),
        scene(
            "crossing triangles",
            crossing.clone(),
            from(dvec3(1.0, 2.0, 9.0), DVec3::ZERO),
        ),
        scene(
            "crossing triangles, parallel",
            crossing,
            along(towards, 4.0),
        ),
        scene(
            "three sticks in a cycle",
            sticks(),
            from(dvec3(0.1, 0.3, 10.0), DVec3::ZERO),
        ),
        scene(
            "coplanar pieces and one across",
            pieces,
            from(dvec3(1.0, 2.0, 9.0), DVec3::ZERO),
        ),
        scene(
            "random triangles",
            random(30, 1),
            from(dvec3(2.0, 3.0, 8.0), DVec3::ZERO),
        ),
        scene(
            "random triangles, parallel",
            random(30, 2),
            along(towards, 4.0),
        ),
        scene(
            "the eye in a box",
            within.concat(),
            from(dvec3(-4.0, 3.0, 4.0), DVec3::ZERO),
        ),
    ]
}

fn by_z_buffer(scene: &PolygonsInView, options: Options) -> IdBuffer {
    let (mesh, sources) = triangles(&scene.polygons).unwrap();
    let colours: Vec<_> = sources
        .iter()
        .map(|&source| Luma([source as u32]))
        .collect();
    let mut picture = buffers::new(SIZE, SIZE, Luma([NOTHING])).unwrap();
    let mut depth = DepthBuffer::<ReversedDepth32F>::new(SIZE, SIZE).unwrap();
    let colours = Colours::PerTriangle(&colours);
    z_buffer::draw(
        &mesh,
        &scene.camera,
        colours,
        options,
        &mut picture,
        &mut depth,
    )
    .unwrap();
    picture
}

fn by_object_space(scene: &PolygonsInView) -> IdBuffer {
    let parts = visible_parts(&scene.polygons, scene.camera.eye().unwrap());
    painted(&parts, scene)
}

fn by_painter(scene: &PolygonsInView) -> IdBuffer {
    let parts = painter::order_by_cutting(&scene.polygons, scene.camera.eye().unwrap());
    painted(&parts, scene)
}

fn painted(parts: &[(usize, Polygon)], scene: &PolygonsInView) -> IdBuffer {
    let parts = parts.iter().map(|(source, part)| (*source, part));
    paint(parts, &scene.camera).unwrap()
}

fn by_rays(scene: &PolygonsInView) -> IdBuffer {
    image_space::cast(&scene.polygons, &scene.camera).unwrap()
}

fn difference(scene: &PolygonsInView, picture: &IdBuffer) -> Difference {
    compare(&by_rays(scene), picture, &scene.polygons, &scene.camera).unwrap()
}

/// Projection rounds a dozen times at some hundred pixels; a cut rounds its corners to a few ε of the scene, and is
/// seen under no less than 1/64 of a right angle.
const ROUNDED: f64 = 64.0 * 16.0 * f64::EPSILON * SIZE as f64;

/// The z-buffer moves corners to multiples of 2⁻⁸ of a pixel, by √2/512 at most; edges move no farther, and lines in which
/// two primitives cross no more than a few times as far where their slopes are alike.
const SNAPPED: f64 = 1.0 / 128.0;

#[test]
fn all_methods_give_one_picture() {
    // Differing pixels of object space, the painter and the z-buffer: none where nothing but rounding could make them, and
    // of a thousand along edges about one where corners are moved by 1/1000 of a pixel on the average.
    let expected = [
        ("boxes", [0, 0, 0]),
        ("boxes, parallel", [0, 0, 1]),
        ("teapot", [0, 0, 1]),
        ("teapot, parallel", [0, 0, 0]),
        ("crossing triangles", [0, 0, 0]),
        ("crossing triangles, parallel", [0, 0, 0]),
        ("three sticks in a cycle", [0, 0, 2]),
        // The depths of coplanar pieces, snapped apart, tie no more: the z-buffer shows either here and there.
        ("coplanar pieces and one across", [0, 0, 86]),
        ("random triangles", [0, 0, 3]),
        ("random triangles, parallel", [0, 0, 0]),
        ("the eye in a box", [0, 0, 0]),
    ];
    let scenes = scenes();
    assert_eq!(scenes.len(), expected.len());
    for (scene, (name, pixels)) in scenes.iter().zip(expected) {
        assert_eq!(scene.name, name);
        let covered = by_rays(scene).pixels().filter(|p| p.0 != [NOTHING]).count();
        assert!(covered > (SIZE * SIZE / 8) as usize, "{name}: {covered}");
        let found = [
            (by_object_space(scene), ROUNDED),
            (by_painter(scene), ROUNDED),
            (by_z_buffer(scene, Options::default()), SNAPPED),
        ]
        .map(|(picture, distance)| {
            let difference = difference(scene, &picture);
            assert!(difference.farthest <= distance, "{name}: {difference:?}");
            difference.pixels
        });
        assert_eq!(found, pixels, "{name}");
    }
}

/// The z-buffer's picture by another way: corners moved to multiples of 2⁻⁸ of a pixel, the pixels of each triangle by
/// exact spans, the depth there as the mixture of its corners' depths. `None` where the view volume cuts a triangle.
fn by_snapped_spans(scene: &PolygonsInView) -> Option<IdBuffer> {
    let (mesh, sources) = triangles(&scene.polygons).unwrap();
    let mut picture = paint([], &scene.camera).unwrap();
    let mut nearest = vec![0.0f32; (SIZE * SIZE) as usize];
    for (triangle, &source) in mesh.triangles.iter().zip(&sources) {
        let clip = triangle.map(|i| scene.camera.to_clip(mesh.positions[i as usize]));
        if clip.iter().any(|p| p.w <= 0.0 || p.z.abs() > p.w) {
            return None;
        }
        let places = clip.map(|p| VIEWPORT.to_pixel(p.truncate() / p.w).truncate());
        let corners = places.map(|place| snap(place, 8));
        // Reversed: 1 at the near plane.
        let depths = clip.map(|p| (p.w - p.z) / (2.0 * p.w));
        for span in cover(corners, SIZE, SIZE).unwrap() {
            for pixel in span.pixels() {
                let shares = weights(corners, pixel.as_dvec2() + 0.5).unwrap();
                let depth = linear(shares, depths) as f32;
                let stored = &mut nearest[(pixel.y * SIZE + pixel.x) as usize];
                if depth > *stored {
                    *stored = depth;
                    picture.put_pixel(pixel.x, pixel.y, Luma([source as u32]));
                }
            }
        }
    }
    Some(picture)
}

/// What the z-buffer shows otherwise than the rays do comes from snapping alone.
#[test]
fn the_z_buffer_differs_by_what_snapping_moves() {
    let mut predicted = 0;
    for scene in scenes() {
        let Some(expected) = by_snapped_spans(&scene) else {
            continue;
        };
        predicted += 1;
        let found = by_z_buffer(&scene, Options::default());
        let pairs = found.pixels().zip(expected.pixels());
        let unlike = pairs.filter(|(a, b)| a != b).count();
        assert_eq!(unlike, 0, "{}", scene.name);
    }
    assert!(predicted >= 10, "{predicted}");
}

#[test]
fn many_small_scenes() {
    let mut random = Random::new(3);
    // Corners on whole numbers: many triangles then share corners, edges and planes, or touch each other.
    let whole = |polygons: Vec<Polygon>| -> Vec<Polygon> {
        let round = |p: Polygon| Polygon::new(p.vertices.iter().map(|v| v.round()).collect());
        polygons.into_iter().filter_map(|p| round(p).ok()).collect()
    };
    let (mut totals, mut covered) = ([0; 3], 0);
    for seed in 0..90 {
        let eye = 9.0 * random.direction().normalize();
        let camera = if seed % 2 == 0 {
            from(eye, DVec3::ZERO)
        } else {
            along(eye, 4.0)
        };
        let triangles = self::random(8, 100 + seed);
        let triangles = if seed % 3 == 0 {
            whole(triangles)
        } else {
            triangles
        };
        let scene = scene("random", triangles, camera);
        covered += by_rays(&scene)
            .pixels()
            .filter(|p| p.0 != [NOTHING])
            .count();
        let pictures = [
            (by_object_space(&scene), ROUNDED),
            (by_painter(&scene), ROUNDED),
            // Here some cross at slopes that are alike.
            (by_z_buffer(&scene, Options::default()), 16.0 * SNAPPED),
        ];
        for (total, (picture, distance)) in totals.iter_mut().zip(pictures) {
            let difference = difference(&scene, &picture);
            assert!(difference.farthest <= distance, "{seed}: {difference:?}");
            *total += difference.pixels;
        }
    }
    assert!(covered > 250_000, "{covered}");
    let [object_space, painter, z_buffer] = totals;
    assert_eq!((object_space, painter), (0, 0));
    // Snapping moves an edge by 1/1000 of a pixel on the average, and some 500 pixels of edges and lines are seen in a
    // scene: about half a pixel each.
    assert!((10..120).contains(&z_buffer), "{z_buffer}");
}

/// What all this would catch: the order of distances to the middle is another picture, off by many pixels far from edges.
#[test]
fn one_distance_a_primitive_is_no_order() {
    for (name, least) in [
        ("three sticks in a cycle", 100),
        ("crossing triangles", 100),
        ("boxes", 100),
    ] {
        let scene = scenes()
            .into_iter()
            .find(|scene| scene.name == name)
            .unwrap();
        let eye = scene.camera.eye().unwrap().truncate();
        let distance = |p: &Polygon| p.centroid().unwrap().distance(eye);
        let mut order: Vec<_> = scene.polygons.iter().cloned().enumerate().collect();
        order.sort_by(|(_, p), (_, q)| distance(q).total_cmp(&distance(p)));
        let found = difference(&scene, &painted(&order, &scene));
        assert!(
            found.pixels >= least && found.farthest > 2.0,
            "{name}: {found:?}"
        );
    }
}

#[test]
fn culling_changes_nothing_outside_closed_solids() {
    let solids: Vec<Polygon> = [
        solid((-4.0, 0.0, -3.0), (-1.0, 2.0, 0.0)),
        polygons(&sphere(1.5, 16, 8).unwrap()),
        solid((0.0, 0.0, -4.0), (2.0, 4.0, -2.0)),
    ]
    .concat();
    let (mesh, _) = triangles(&solids).unwrap();
    for camera in [
        from(dvec3(7.0, 8.0, 11.0), DVec3::ZERO),
        from(dvec3(-6.0, 1.0, 7.0), DVec3::ZERO),
        along(dvec3(3.0, 4.0, 7.0), 6.0),
    ] {
        let kept = back_face::visible(&mesh, camera.eye().unwrap());
        assert!((solids.len() / 3..2 * solids.len() / 3).contains(&kept.len()));
        // What is left out becomes an empty polygon, so that numbers stay.
        let culled: Vec<_> = (0..solids.len())
            .map(|i| {
                if kept.contains(&i) {
                    solids[i].clone()
                } else {
                    Polygon::default()
                }
            })
            .collect();
        let all = scene("solids", solids.clone(), camera);
        let front = scene("front faces", culled, camera);
        assert_eq!(by_rays(&all), by_rays(&front));
        assert_eq!(by_object_space(&all), by_object_space(&front));
        let back = Options {
            cull: Cull::Back,
            ..Options::default()
        };
        assert_eq!(
            by_z_buffer(&all, Options::default()),
            by_z_buffer(&all, back)
        );
    }
    // From inside, what would be left out is all there is.
    let inside = from(dvec3(-3.0, 1.0, -1.0), dvec3(-2.0, 1.25, -2.0));
    let walls = solid((-4.0, 0.0, -3.0), (-1.0, 2.0, 0.0));
    let (mesh, _) = triangles(&walls).unwrap();
    assert_eq!(back_face::visible(&mesh, inside.eye().unwrap()), []);
    let walls = scene("walls", walls, inside);
    assert!(by_rays(&walls).pixels().all(|p| p.0 != [NOTHING]));
}

#[test]
fn nothing_and_one_and_all_behind_the_eye() {
    let camera = from(dvec3(0.0, 0.0, 9.0), DVec3::ZERO);
    let one = polygon(&[(-3.0, -2.0, 0.0), (3.0, -2.0, 0.0), (0.0, 3.0, 0.0)]);
    let behind = polygon(&[(-3.0, -2.0, 12.0), (3.0, -2.0, 12.0), (0.0, 3.0, 12.0)]);
    let edge_on = polygon(&[(-3.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 0.0, -3.0)]);
    for (polygons, covered) in [
        (vec![], false),
        (vec![one.clone()], true),
        (vec![behind.clone(), behind.clone()], false),
        (vec![edge_on.clone()], false),
        (vec![edge_on, one, behind], true),
    ] {
        let scene = scene("few", polygons, camera);
        let reference = by_rays(&scene);
        assert_eq!(reference.pixels().any(|p| p.0 != [NOTHING]), covered);
        assert_eq!(by_object_space(&scene), reference);
        assert_eq!(by_painter(&scene), reference);
        assert_eq!(by_z_buffer(&scene, Options::default()), reference);
    }
}
