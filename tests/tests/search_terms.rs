//! The words of the field lead to the items: each term below, typed into the search of the documentation, is the name
//! of an item or a `#[doc(alias = "…")]` directly on it.

use std::collections::BTreeMap;

use ombra_tests::sources::{Item, public_items};

/// What a reader types, and what should be found. A term of another spelling is a line of its own.
const TERMS: &[(&str, &str)] = &[
    // Segments
    ("scan conversion", "ombra_raster::polygon"),
    ("line drawing", "ombra_raster::bresenham"),
    ("midpoint", "ombra_raster::bresenham"),
    ("midpoint line algorithm", "ombra_raster::bresenham"),
    ("digital differential analyzer", "ombra_raster::dda"),
    ("decision variable", "ombra_raster::bresenham::Step"),
    // Polygons and triangles
    ("scan line", "ombra_raster::polygon"),
    ("scanline", "ombra_raster::polygon"),
    ("polygon fill", "ombra_raster::polygon::fill"),
    ("edge table", "ombra_raster::polygon::edge_table"),
    ("ET", "ombra_raster::polygon::edge_table"),
    ("active edge table", "ombra_raster::polygon::active_edges"),
    ("active edge list", "ombra_raster::polygon::active_edges"),
    ("AET", "ombra_raster::polygon::active_edges"),
    ("winding number", "ombra_raster::polygon::FillRule"),
    ("winding rule", "ombra_raster::polygon::FillRule"),
    ("fill rule", "ombra_raster::polygon::FillRule"),
    ("even-odd", "ombra_raster::polygon::FillRule::EvenOdd"),
    ("parity rule", "ombra_raster::polygon::FillRule::EvenOdd"),
    ("non-zero", "ombra_raster::polygon::FillRule::NonZero"),
    ("half-space", "ombra_raster::triangle"),
    ("top-left rule", "ombra_raster::triangle::is_top_left"),
    ("fill convention", "ombra_raster::triangle::EdgeRule"),
    ("edge function", "ombra_raster::triangle::edge_function"),
    ("sub-pixel", "ombra_raster::triangle::snap"),
    ("fixed point", "ombra_raster::triangle::snap"),
    ("interpolation", "ombra_raster::attributes"),
    ("varying", "ombra_raster::attributes"),
    (
        "barycentric coordinates",
        "ombra_raster::attributes::weights",
    ),
    (
        "perspective-correct",
        "ombra_raster::attributes::perspective",
    ),
    (
        "perspective correct interpolation",
        "ombra_raster::attributes::perspective",
    ),
    ("frame buffer", "ombra_raster::buffers::ColourBuffer"),
    ("framebuffer", "ombra_raster::buffers::ColourBuffer"),
    ("stencil", "ombra_raster::buffers::StencilBuffer"),
    // Clipping
    ("viewport clipping", "ombra_clip::window"),
    ("region code", "ombra_clip::cohen_sutherland::Outcode"),
    ("area code", "ombra_clip::cohen_sutherland::Outcode"),
    ("clip code", "ombra_clip::cohen_sutherland::Outcode"),
    (
        "trivial accept",
        "ombra_clip::cohen_sutherland::Decision::Accept",
    ),
    (
        "trivial reject",
        "ombra_clip::cohen_sutherland::Decision::Reject",
    ),
    (
        "rejection",
        "ombra_clip::cohen_sutherland::Decision::Reject",
    ),
    ("parametric clipping", "ombra_clip::liang_barsky"),
    (
        "line clipping",
        "ombra_clip::cohen_sutherland::clip_segment",
    ),
    ("convex clipping", "ombra_clip::cyrus_beck"),
    (
        "reentrant polygon clipping",
        "ombra_clip::sutherland_hodgman",
    ),
    ("polygon clipping", "ombra_clip::sutherland_hodgman"),
    ("Weiler-Atherton", "ombra_clip::pieces"),
    ("concave polygon", "ombra_clip::pieces"),
    ("near plane", "ombra_clip::homogeneous::ViewPlane::Near"),
    ("far plane", "ombra_clip::homogeneous::ViewPlane::Far"),
    ("clip space", "ombra_clip::homogeneous"),
    ("view frustum", "ombra_clip::homogeneous"),
    ("canonical view volume", "ombra_clip::homogeneous"),
    ("guard band", "ombra_clip::homogeneous::clip_polygon_to"),
    // Hidden surfaces
    ("hidden surface removal", "ombra_hsr::z_buffer"),
    ("visible surface determination", "ombra_hsr::object_space"),
    ("depth buffer", "ombra_hsr::z_buffer"),
    ("zbuffer", "ombra_hsr::z_buffer"),
    ("depth test", "ombra_hsr::z_buffer"),
    ("reversed z", "ombra_hsr::z_buffer::ReversedDepth32F"),
    ("reverse z", "ombra_hsr::z_buffer::ReversedDepth32F"),
    (
        "z-fighting",
        "ombra_hsr::z_buffer::precision::fighting_distance",
    ),
    (
        "depth resolution",
        "ombra_hsr::z_buffer::precision::depth_step",
    ),
    ("alpha blending", "ombra_hsr::z_buffer::Blend"),
    ("face culling", "ombra_hsr::z_buffer::Cull"),
    ("glCullFace", "ombra_hsr::z_buffer::Cull"),
    ("painters algorithm", "ombra_hsr::painter"),
    ("depth sort", "ombra_hsr::painter"),
    ("Newell", "ombra_hsr::painter::order_by_cutting"),
    ("cyclic overlap", "ombra_hsr::painter::Cycle"),
    ("ray casting", "ombra_hsr::image_space"),
    ("raycasting", "ombra_hsr::image_space"),
    ("ray tracing", "ombra_hsr::image_space"),
    ("intersection", "ombra_hsr::image_space::hits"),
    ("culling", "ombra_hsr::back_face"),
    ("backface", "ombra_hsr::back_face"),
    ("back-face culling", "ombra_hsr::back_face"),
    ("front face", "ombra_hsr::back_face::is_front_facing"),
    ("occlusion", "ombra_hsr::pair"),
    // Shadows
    ("projected shadow", "ombra_shadows::planar"),
    ("planar projected shadow", "ombra_shadows::planar"),
    (
        "shadow projection matrix",
        "ombra_shadows::planar::shadow_matrix",
    ),
    ("point light", "ombra_shadows::planar::ground_matrix_point"),
    (
        "directional light",
        "ombra_shadows::planar::ground_matrix_directional",
    ),
    (
        "light at infinity",
        "ombra_shadows::planar::ground_matrix_directional",
    ),
    ("sun", "ombra_shadows::planar::ground_matrix_directional"),
    ("false shadow", "ombra_shadows::planar::classify"),
    ("anti-shadow", "ombra_shadows::planar::classify"),
    ("receiver", "ombra_shadows::planar::cast_onto"),
    ("blob shadow", "ombra_shadows::fake"),
    // What all stand on
    ("lookAt", "ombra_math::view::look_at"),
    ("look at", "ombra_math::view::look_at"),
    ("gluLookAt", "ombra_math::view::look_at"),
    ("view matrix", "ombra_math::view::look_at"),
    ("glFrustum", "ombra_math::view::frustum"),
    ("projection matrix", "ombra_math::view::frustum"),
    ("infinite projection", "ombra_math::view::frustum_infinite"),
    ("gluPerspective", "ombra_math::view::perspective"),
    ("field of view", "ombra_math::view::perspective"),
    ("fov", "ombra_math::view::perspective"),
    ("glOrtho", "ombra_math::view::orthographic"),
    ("parallel projection", "ombra_math::view::orthographic"),
    ("NDC", "ombra_math::view::Viewport"),
    (
        "normalized device coordinates",
        "ombra_math::view::Viewport",
    ),
    ("viewport transform", "ombra_math::view::Viewport::to_pixel"),
    ("perspective divide", "ombra_math::homogeneous::project"),
    ("homogeneous coordinates", "ombra_math::homogeneous"),
    ("ideal point", "ombra_math::homogeneous::direction"),
    ("primary ray", "ombra_math::camera::Camera::sight_line"),
    ("unproject", "ombra_math::camera::Camera::sight_line"),
    ("half-edge", "ombra_math::mesh::Edge"),
    ("adjacency", "ombra_math::mesh::Edge"),
    ("manifold", "ombra_math::mesh::Mesh::is_two_manifold"),
    ("watertight", "ombra_math::mesh::Mesh::is_closed"),
    ("smooth normals", "ombra_math::mesh::Mesh::vertex_normals"),
    ("triangle mesh", "ombra_math::mesh::Mesh"),
    ("indexed face set", "ombra_math::mesh::Mesh"),
    ("bounding box", "ombra_math::mesh::Mesh::bounds"),
    ("AABB", "ombra_math::mesh::Mesh::bounds"),
    ("half-space", "ombra_math::plane::Plane::side"),
    (
        "point-plane distance",
        "ombra_math::plane::Plane::signed_distance",
    ),
    ("cross product", "ombra_math::triangle::normal"),
    ("surface normal", "ombra_math::triangle::normal"),
    ("areal coordinates", "ombra_math::triangle::barycentric"),
    ("polar coordinates", "ombra_math::spherical"),
    ("azimuth", "ombra_math::spherical::Spherical"),
    ("steradian", "ombra_math::spherical::solid_angle"),
    ("orientation test", "ombra_math::predicates"),
    ("counter-clockwise", "ombra_math::predicates::orient_2d"),
    ("ccw", "ombra_math::predicates::orient_2d"),
    ("Utah teapot", "ombra_math::solids::teapot"),
    ("UV sphere", "ombra_math::solids::sphere"),
    ("doughnut", "ombra_math::solids::torus"),
];

/// As the search of rustdoc takes a name: without underscores, in small letters.
fn normal(name: &str) -> String {
    name.replace('_', "").to_lowercase()
}

#[test]
fn every_term_finds_its_item() {
    let mut items: BTreeMap<String, Vec<Item>> = BTreeMap::new();
    for item in public_items() {
        for path in item.also.iter().chain([&item.path]) {
            items.entry(path.clone()).or_default().push(item.clone());
        }
    }
    let mut complaints = Vec::new();
    for &(term, path) in TERMS {
        let Some(found) = items.get(path) else {
            complaints.push(format!("{term}: there is no {path}"));
            continue;
        };
        let finds = |item: &Item| {
            let words = item.aliases.iter().map(String::as_str).chain([item.name()]);
            words.into_iter().any(|word| normal(word) == normal(term))
        };
        if !found.iter().any(finds) {
            let file = found[0].file.display();
            complaints.push(format!("{term}: not an alias of {path} in {file}"));
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(TERMS.len() >= 60, "the list of terms is cut short");
}
