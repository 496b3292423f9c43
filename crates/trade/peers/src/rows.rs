//! The rows: one for each work and form of it.

mod clip_polygon;
mod clip_segments;
mod fill;
mod segments;
pub mod triangles;

use crate::measured::Measured;
use crate::race::Rounds;

pub struct Row {
    pub name: &'static str,
    pub measure: fn(&str, Rounds) -> Measured,
}

pub fn all() -> Vec<Row> {
    let row = |name, measure| Row { name, measure };
    vec![
        row("segments-u32", |name, rounds| {
            segments::row(name, |i| i, rounds)
        }),
        row("segments-u8", |name, rounds| {
            segments::row(name, |i| (i % 255 + 1) as u8, rounds)
        }),
        row("fill-smooth-rgba", |name, rounds| {
            fill::rgba(name, fill::smooth(), rounds)
        }),
        row("fill-star-rgba", |name, rounds| {
            fill::rgba(name, fill::star(), rounds)
        }),
        row("fill-crossing-rgba", |name, rounds| {
            fill::rgba(name, fill::crossing(), rounds)
        }),
        row("fill-smooth-mask", |name, rounds| {
            fill::mask(name, fill::smooth(), rounds)
        }),
        row("fill-star-mask", |name, rounds| {
            fill::mask(name, fill::star(), rounds)
        }),
        row("fill-crossing-mask", |name, rounds| {
            fill::mask(name, fill::crossing(), rounds)
        }),
        row("clip-segments-0", |name, rounds| {
            clip_segments::row(name, 0, rounds)
        }),
        row("clip-segments-25", |name, rounds| {
            clip_segments::row(name, 25, rounds)
        }),
        row("clip-segments-50", |name, rounds| {
            clip_segments::row(name, 50, rounds)
        }),
        row("clip-segments-75", |name, rounds| {
            clip_segments::row(name, 75, rounds)
        }),
        row("clip-segments-100", |name, rounds| {
            clip_segments::row(name, 100, rounds)
        }),
        row("clip-polygon-wave", |name, rounds| {
            clip_polygon::row(name, clip_polygon::wave(), rounds)
        }),
        row("clip-polygon-star", |name, rounds| {
            clip_polygon::row(name, clip_polygon::star(), rounds)
        }),
        row("clip-polygon-comb", |name, rounds| {
            clip_polygon::row(name, clip_polygon::comb(), rounds)
        }),
        row("triangles", |name, rounds| {
            triangles::row(name, triangles::COLOURED, 1, rounds)
        }),
        row("triangles-culled", |name, rounds| {
            triangles::row(name, triangles::COLOURED.culled(), 1, rounds)
        }),
        row("triangles-2-threads", |name, rounds| {
            triangles::row(name, triangles::COLOURED, 2, rounds)
        }),
        row("shadow-map", |name, rounds| {
            triangles::row(name, triangles::SHADOW_MAP, 1, rounds)
        }),
        row("shadow-map-culled", |name, rounds| {
            triangles::row(name, triangles::SHADOW_MAP.culled(), 1, rounds)
        }),
        row("shadow-map-2-threads", |name, rounds| {
            triangles::row(name, triangles::SHADOW_MAP, 2, rounds)
        }),
    ]
}
