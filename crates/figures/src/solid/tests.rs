use ombra_hsr::z_buffer::{Colours, Depth32F, DepthBuffer, Options, draw};
use ombra_math::camera::Camera;
use ombra_math::glam::{DVec2, DVec3};
use ombra_math::solids;
use ombra_math::view::Viewport;
use ombra_raster::buffers::{self, image::Luma};

use super::*;
use crate::drawing::{Drawing, Item, Paint};
use crate::path::Rect;
use crate::png;
use crate::style::{Size, Style};

/// Boxes, each between two corners, as one mesh.
fn boxes(corners: &[[DVec3; 2]]) -> Mesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for &[low, high] in corners {
        let first = positions.len() as u32;
        for i in 0..8 {
            let pick = |bit: u32, a: f64, b: f64| if i >> bit & 1 == 0 { a } else { b };
            positions.push(DVec3::new(
                pick(2, low.x, high.x),
                pick(1, low.y, high.y),
                pick(0, low.z, high.z),
            ));
        }
        for [a, b, c, d] in [
            [0, 1, 3, 2],
            [4, 6, 7, 5],
            [0, 4, 5, 1],
            [2, 3, 7, 6],
            [0, 2, 6, 4],
            [1, 5, 7, 3],
        ] {
            triangles.push([a, b, c].map(|i: u32| first + i));
            triangles.push([a, c, d].map(|i: u32| first + i));
        }
    }
    Mesh::new(positions, triangles).unwrap()
}

fn slab(place: DVec3, size: DVec3) -> [DVec3; 2] {
    let half = DVec3::new(0.5 * size.x, 0.0, 0.5 * size.z);
    [place - half, place + half + DVec3::Y * size.y]
}

/// What the order by the middles of faces paints wrongly, what has no order at all, and smooth solids.
fn solids() -> Vec<(&'static str, Mesh)> {
    let floor = slab(DVec3::ZERO, DVec3::new(20.0, 2.0, 20.0));
    let tower = |x, z| slab(DVec3::new(x, 2.0, z), DVec3::new(5.0, 8.0, 5.0));
    vec![
        ("tower", boxes(&[floor, tower(0.0, 0.0)])),
        ("tower in a corner", boxes(&[floor, tower(6.0, -7.0)])),
        (
            "crossing",
            boxes(&[
                [DVec3::new(-10.0, 4.0, -2.0), DVec3::new(10.0, 8.0, 2.0)],
                [DVec3::new(-2.0, 0.0, -10.0), DVec3::new(2.0, 12.0, 10.0)],
                [DVec3::new(-12.0, 1.0, -12.0), DVec3::new(-8.0, 20.0, 8.0)],
            ]),
        ),
        ("torus", solids::torus(3.0, 1.2, 40, 16).unwrap()),
        ("teapot", solids::teapot(6).unwrap()),
    ]
}

fn style() -> Style {
    Style {
        size: Size::new(1000, 1000).unwrap(),
        ..Style::default()
    }
}

fn view_of(mesh: &Mesh) -> View {
    let frame = Rect::new(DVec2::splat(100.0), DVec2::splat(900.0));
    View::fit(&mesh.positions, frame).unwrap()
}

fn drawing(draw: impl FnOnce(&mut Sheet)) -> Drawing {
    let mut sheet = Sheet::new(&style(), "").unwrap();
    draw(&mut sheet);
    sheet.finish("solid/test", "").unwrap()
}

/// The face that the z-buffer finds at each pixel of the canvas, from 1 on; 0 is none.
fn nearest(view: &View, solid: &Solid) -> Vec<u16> {
    let positions: Vec<DVec3> = solid.faces.iter().flat_map(|f| f.corners).collect();
    let (low, high) = positions
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(a, b), &p| {
            (a.min(view.depth(p)), b.max(view.depth(p)))
        });
    let triangles = (0..solid.faces.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let mesh = Mesh::new(positions, triangles.collect()).unwrap();
    let canvas = Rect::new(DVec2::ZERO, DVec2::splat(1000.0));
    let camera = Camera {
        view_projection: pixels::projection(view, canvas, [0.9 * low, 1.1 * high]),
        viewport: Viewport {
            width: 1000,
            height: 1000,
        },
    };
    let ids: Vec<Luma<u16>> = (1..=solid.faces.len()).map(|i| Luma([i as u16])).collect();
    let mut picture = buffers::new(1000, 1000, Luma([0])).unwrap();
    let mut depth: DepthBuffer<Depth32F> = DepthBuffer::new(1000, 1000).unwrap();
    let colours = Colours::PerTriangle(&ids);
    draw(
        &mesh,
        &camera,
        colours,
        Options::default(),
        &mut picture,
        &mut depth,
    )
    .unwrap();
    picture.into_raw()
}

/// Whether the straight contours of a path wind around `p`.
fn winds(path: &Path, p: DVec2) -> bool {
    let mut turns = 0;
    for (a, b) in path.chords() {
        let left = (b - a).perp_dot(p - a);
        if a.y <= p.y && b.y > p.y && left > 0.0 {
            turns += 1;
        } else if a.y > p.y && b.y <= p.y && left < 0.0 {
            turns -= 1;
        }
    }
    turns != 0
}

/// At each place of a grid the tint painted last is that of the face which the z-buffer finds nearest, except within
/// two pixels of where two faces meet.
#[test]
fn what_is_painted_last_is_what_the_z_buffer_finds() {
    for (name, mesh) in solids() {
        let view = view_of(&mesh);
        let solid = Solid::new(&view, &mesh, Role::Occluder, Theme::Light);
        let ids = nearest(&view, &solid);
        let drawing = drawing(|sheet| painted::draw(sheet, &view, &solid));
        let areas: Vec<(Ink, &Path, Rect)> = drawing
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Shape {
                    path,
                    fill: Some((Paint::Solid(ink), _)),
                    ..
                } => Some((*ink, path, path.bounds()?)),
                _ => None,
            })
            .collect();
        let mut compared = 0;
        for y in (2..998).step_by(11) {
            for x in (2..998).step_by(11) {
                let at = |i: usize, j: usize| ids[(y + j - 2) * 1000 + x + i - 2];
                let id = at(2, 2);
                if (0..25).any(|k| at(k % 5, k / 5) != id) {
                    continue;
                }
                let p = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let here = Rect::new(p, p);
                let over = |(_, path, bounds): &&(Ink, &Path, Rect)| {
                    bounds.contains(&here) && winds(path, p)
                };
                let painted = areas.iter().rev().find(over).map(|(ink, ..)| *ink);
                let expected = usize::from(id).checked_sub(1).map(|i| solid.faces[i].ink);
                assert_eq!(painted, expected, "{name} at {p}");
                compared += usize::from(id > 0);
            }
        }
        assert!(compared > 150, "{name}: only {compared} places");
    }
}

/// A place on an edge is drawn where no face stands between it and the eye: by a ray to each.
#[test]
fn the_edges_drawn_are_those_that_rays_reach() {
    let (mut seen, mut hidden) = (0, 0);
    for (name, mesh) in solids() {
        let view = view_of(&mesh);
        let solid = Solid::new(&view, &mesh, Role::Occluder, Theme::Light);
        let drawn = edges::visible(&view, &solid).chords();
        let on_a_line = |p: DVec2| {
            drawn.iter().any(|&(a, b)| {
                let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                p.distance(a.lerp(b, t)) < 1e-6
            })
        };
        for &[a, b] in &solid.edges {
            for t in [0.17, 0.5, 0.83] {
                let p = a.lerp(b, t);
                // How far beyond the nearest face the place is, in distances from the eye; none within rounding.
                let before = solid
                    .faces
                    .iter()
                    .map(|face| stands_before(view.eye(), p, face));
                let before = before.fold(0.0, f64::max);
                if (1e-12..1e-6).contains(&before) {
                    continue;
                }
                let reached = before < 1e-12;
                let found = on_a_line(view.project(p).unwrap());
                // Another edge may be drawn over a hidden one.
                if reached {
                    assert!(found, "{name}: {p} is seen");
                    seen += 1;
                } else {
                    hidden += usize::from(!found);
                }
            }
        }
    }
    assert!(seen > 500 && hidden > 100, "{seen} seen, {hidden} hidden");
}

/// The share of the way from the eye to `p` that is left where the face stands on it; 0 where it does not.
fn stands_before(eye: DVec3, p: DVec3, face: &Face) -> f64 {
    let ([a, b, c], way) = (face.corners, p - eye);
    let normal = (b - a).cross(c - a);
    let t = normal.dot(a - eye) / normal.dot(way);
    let hit = eye + way * t;
    let inside = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        (to - from).cross(hit - from).dot(normal) > 1e-9 * normal.length_squared()
    });
    if inside == [true; 3] { 1.0 - t } else { 0.0 }
}

/// The picture by pixels and the painted one differ where edges of faces run through pixels, and nowhere else.
#[test]
fn both_ways_make_one_picture() {
    for (name, mesh) in solids() {
        let view = view_of(&mesh);
        let solid = Solid::new(&view, &mesh, Role::Occluder, Theme::Light);
        let both = [
            drawing(|sheet| {
                painted::draw(sheet, &view, &solid);
                let edges = edges::visible(&view, &solid);
                sheet.stroke(edges, Pen::new(Role::Occluder, NORMAL));
            }),
            drawing(|sheet| {
                let edges = pixels::draw(sheet, &view, &solid).unwrap();
                sheet.stroke(edges, Pen::new(Role::Occluder, NORMAL));
            }),
        ];
        let [one, two] = both.map(|drawing| {
            let file = png::png(&drawing).unwrap();
            tiny_skia::Pixmap::decode_png(&file).unwrap().take()
        });
        let inked = one.chunks(4).filter(|pixel| pixel[..3] != [255; 3]).count();
        let far = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 24);
        let different = one
            .chunks(4)
            .zip(two.chunks(4))
            .filter(|&pair| far(pair))
            .count();
        assert!(inked > 20_000, "{name}: {inked} pixels");
        assert!(
            different * 250 < inked,
            "{name}: {different} of {inked} pixels"
        );
    }
}

#[test]
fn the_matrix_of_a_view_does_what_the_view_does() {
    let mesh = solids::teapot(3).unwrap();
    let view = view_of(&mesh);
    let [across, down, along] = view.rows();
    for &p in &mesh.positions {
        let [x, y, depth] = [across, down, along].map(|row| row.dot(p.extend(1.0)));
        let at = view.project(p).unwrap();
        assert!(at.distance(DVec2::new(x, y) / depth) < 1e-9, "{p}");
        assert!((view.depth(p) - depth).abs() < 1e-12, "{p}");
    }
}

/// Faces that lie one on the other are one face with one border, in space and in the picture.
#[test]
fn what_lies_double_is_drawn_once() {
    let once = solids::tetrahedron();
    let mut often = once.clone();
    for _ in 0..1000 {
        often.triangles.extend_from_slice(&once.triangles);
    }
    let view = view_of(&once);
    let draw = |mesh: &Mesh| {
        let solid = Solid::new(&view, mesh, Role::Occluder, Theme::Light);
        (
            solid.faces.len(),
            solid.edges.len(),
            solid.back.chords().len(),
        )
    };
    assert_eq!(draw(&often), draw(&once));
    assert_eq!(meetings(&often), 6);
    assert_eq!(creases(&often), creases(&once));
    // The same with a face away, so that it is open.
    let lid_off = |mut mesh: Mesh| {
        mesh.triangles
            .retain(|t| unordered(*t) != unordered(once.triangles[0]));
        draw(&mesh)
    };
    assert_eq!(lid_off(often.clone()), lid_off(once.clone()));
}

/// The solids are painted, and what crosses itself everywhere is not, however few its faces.
#[test]
fn what_would_be_cut_to_pieces_is_not_painted() {
    for name in crate::object::SOLIDS.split(", ") {
        let mesh = name.parse::<NamedMesh>().unwrap().mesh;
        assert_eq!(
            is_painted(&mesh),
            mesh.triangles.len() <= MOST_PAINTED,
            "{name}"
        );
    }
    // Slats through one middle, each at an angle of its own.
    let slats = |n: u32| {
        let corners = (0..n).flat_map(|i| {
            let across = DVec2::from_angle(f64::from(i) * 0.1) * 10.0;
            [
                across.extend(-1.0),
                across.extend(1.0),
                (-across).extend(0.0),
            ]
        });
        let triangles = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        Mesh::new(corners.collect(), triangles.collect()).unwrap()
    };
    assert!(is_painted(&slats(100)));
    assert!(!is_painted(&slats(1000)));
}
