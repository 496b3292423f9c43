//! OBJ text, read and checked.
//!
//! Only `v` and `f` make an object. Names, groups, materials, normals and texture coordinates are passed over, whatever
//! they say; so are vertices that no face uses.

use core::fmt;
use std::collections::BTreeMap;

use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;

use super::statements::statements;
use super::{MOST_TRIANGLES, polygon};
use crate::number::as_typed;

/// Largest size of a coordinate, and of the box around an object across; the smallest is its inverse, in itself and
/// beside the largest coordinate. Beyond, what is left of an object after rounding says nothing.
const LARGEST: f64 = 1e9;

/// What of an OBJ text is not part of the object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// Elements `p` and `l`: they have no faces.
    pub points_and_lines: usize,
    /// Curves and surfaces: `curv`, `curv2`, `surf`.
    pub curves_and_surfaces: usize,
    /// Faces with fewer than three corners at different places.
    pub faces: usize,
    /// Statements whose keyword is not known.
    pub unknown: usize,
}

impl fmt::Display for LeftOut {
    /// `2 points or lines, 1 face of fewer than three corners`; empty when nothing is left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.points_and_lines, "point or line", "points or lines"),
            (
                self.curves_and_surfaces,
                "curve or surface",
                "curves or surfaces",
            ),
            (
                self.faces,
                "face of fewer than three corners",
                "faces of fewer than three corners",
            ),
            (self.unknown, "unknown statement", "unknown statements"),
        ];
        let some = counts.into_iter().filter(|(count, ..)| *count > 0);
        for (i, (count, one, more)) in some.enumerate() {
            let comma = if i > 0 { ", " } else { "" };
            write!(f, "{comma}{count} {}", if count == 1 { one } else { more })?;
        }
        Ok(())
    }
}

/// Reads an OBJ text: the object, and what is left out of it.
///
/// # Properties
///
/// Vertices stand in the order of the file, those without a face left out and those at the same place as one. A face
/// of more than three corners is cut into triangles along its best plane, with all its corners; a slit in it stays
/// open. A face that crosses itself keeps its border.
///
/// # Errors
///
/// A sentence that says what is wrong with the text, with the number of its line where there is one.
pub fn read_obj(text: &str) -> Result<(Mesh, LeftOut), String> {
    read(text, &mut 0)
}

/// [`read_obj`] without what is left out.
///
/// # Errors
///
/// Those of [`read_obj`].
pub fn from_obj(text: &str) -> Result<Mesh, String> {
    read_obj(text).map(|(mesh, _)| mesh)
}

/// `steps` counts the statements, the corners, and the tests that cutting into triangles takes.
fn read(text: &str, steps: &mut u64) -> Result<(Mesh, LeftOut), String> {
    let text = text.trim_start_matches('\u{feff}');
    // Padding of old systems.
    let text = text.trim_end_matches(['\0', '\u{1a}']);
    let mut found = Found::read(text, steps)?;
    let used = found.used(text)?;
    has_extent(&used, &found.vertices)?;

    let joined = joined(&found.vertices, &used);
    let faces: Vec<Vec<u32>> = found
        .faces()
        .map(|(_, face)| outline(face, &joined))
        .collect();
    let faces = faces.into_iter().filter(|face| face.len() >= 3);
    let faces: Vec<Vec<u32>> = faces.collect();
    found.left_out.faces = found.ends.len() - faces.len();
    let triangles = faces.iter().map(|face| face.len() - 2);
    let mut count = 0_usize;
    for triangles in triangles {
        count += triangles;
        if count > MOST_TRIANGLES {
            return Err(format!(
                "has more than {MOST_TRIANGLES} triangles, the most that are drawn"
            ));
        }
    }
    if count == 0 {
        return Err("has no face with three corners at different places".to_owned());
    }

    // Numbered in the order of the file.
    let mut numbers = vec![None; found.vertices.len()];
    for &vertex in faces.iter().flatten() {
        if let Some(number) = numbers.get_mut(vertex as usize) {
            *number = Some(0);
        }
    }
    let mut positions = Vec::new();
    for (number, &p) in numbers.iter_mut().zip(&found.vertices) {
        if let Some(number) = number {
            *number = positions.len() as u32;
            positions.push(p);
        }
    }
    let number = |vertex: &u32| numbers.get(*vertex as usize).copied().flatten();
    let mut triangles = Vec::with_capacity(count);
    for face in &faces {
        let corners: Vec<u32> = face.iter().filter_map(number).collect();
        *steps += corners.len() as u64;
        triangles.extend(polygon::triangles(&corners, &positions, steps));
    }
    let mesh = Mesh::new(positions, triangles).map_err(|error| error.to_string())?;
    Ok((mesh, found.left_out))
}

/// The vertices and faces of a text.
#[derive(Default)]
struct Found {
    /// NaN where three numbers are not there; that matters only if a face uses it.
    vertices: Vec<DVec3>,
    /// The line of each.
    lines: Vec<usize>,
    /// The corners of all faces, one after the other, as indices from 0 on; some may be beyond the last vertex.
    corners: Vec<u32>,
    /// Where each face ends in them, and its line.
    ends: Vec<(usize, usize)>,
    left_out: LeftOut,
}

/// Keywords of the specification and of common tools, besides those read.
const PASSED_OVER: &[&str] = &[
    "bevel",
    "bmat",
    "bsp",
    "bzp",
    "c_interp",
    "call",
    "cdc",
    "cdp",
    "con",
    "csh",
    "cstype",
    "ctech",
    "d_interp",
    "deg",
    "end",
    "g",
    "hole",
    "lod",
    "maplib",
    "mg",
    "mtllib",
    "o",
    "parm",
    "res",
    "s",
    "scrv",
    "sh",
    "shadow_obj",
    "sp",
    "stech",
    "step",
    "trace_obj",
    "trim",
    "usemap",
    "usemtl",
    "vn",
    "vp",
    "vt",
    "vw",
];

impl Found {
    fn read(text: &str, steps: &mut u64) -> Result<Found, String> {
        let mut found = Found::default();
        let mut known = 0_usize;
        let (mut strange, mut wrong) = (None, None);
        for (number, statement) in statements(text) {
            *steps += 1;
            let mut words = statement.split_whitespace();
            let Some(keyword) = words.next() else {
                continue;
            };
            known += 1;
            match keyword {
                "v" => {
                    found.vertices.push(vertex(words));
                    found.lines.push(number);
                }
                // The older name of the same.
                "f" | "fo" => {
                    if let Err(word) = found.face(words, number) {
                        wrong.get_or_insert_with(|| {
                            no_vertex(number, &statement, word, found.vertices.len())
                        });
                    }
                }
                "l" | "p" => found.left_out.points_and_lines += 1,
                "curv" | "curv2" | "surf" => found.left_out.curves_and_surfaces += 1,
                _ if PASSED_OVER.contains(&keyword) => {}
                _ => {
                    known -= 1;
                    found.left_out.unknown += 1;
                    strange.get_or_insert_with(|| {
                        format!(
                            "is not an OBJ file: line {number} is '{}'",
                            shortened(&statement)
                        )
                    });
                }
            }
        }
        *steps += found.corners.len() as u64;
        // Prose may have a line that begins with a keyword.
        let is_prose = found.vertices.is_empty() || found.left_out.unknown > known;
        match (strange.filter(|_| is_prose), wrong) {
            (Some(error), _) | (None, Some(error)) => Err(error),
            (None, None) if found.vertices.is_empty() => Err(
                "has no vertices: an object is at least three vertices 'v x y z' and a face"
                    .to_owned(),
            ),
            (None, None) => Ok(found),
        }
    }

    /// Adds a face; the error is a word that is no index.
    fn face<'a>(
        &mut self,
        words: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), &'a str> {
        for word in words {
            let index = word.split('/').next().unwrap_or_default();
            // Those of texture coordinates and normals do not matter.
            let index = match index.parse::<i64>() {
                Ok(index @ 1..) => u32::try_from(index - 1).ok(),
                Ok(index @ ..0) => i64::try_from(self.vertices.len())
                    .ok()
                    .and_then(|count| count.checked_add(index))
                    .and_then(|index| u32::try_from(index).ok()),
                Ok(0) | Err(_) => None,
            };
            self.corners.push(index.ok_or(word)?);
        }
        self.ends.push((self.corners.len(), line));
        Ok(())
    }

    /// The line and the corners of each face.
    fn faces(&self) -> impl Iterator<Item = (usize, &[u32])> {
        let starts = core::iter::once(0).chain(self.ends.iter().map(|&(end, _)| end));
        let ends = starts.zip(&self.ends);
        ends.map(|(start, &(end, line))| (line, self.corners.get(start..end).unwrap_or_default()))
    }

    /// Whether each vertex is one of a face of at least three corners; all that are, are numbers that can be drawn.
    fn used(&self, text: &str) -> Result<Vec<bool>, String> {
        let statement = |line: usize| {
            let statement = statements(text).find(|(number, _)| *number == line);
            statement
                .map(|(_, statement)| statement)
                .unwrap_or_default()
        };
        let mut used = vec![false; self.vertices.len()];
        for (line, face) in self.faces() {
            for &corner in face {
                let Some(vertex) = used.get_mut(corner as usize) else {
                    let statement = statement(line);
                    let word = (u64::from(corner) + 1).to_string();
                    return Err(no_vertex(line, &statement, &word, self.vertices.len()));
                };
                *vertex |= face.len() >= 3;
            }
        }
        if !used.contains(&true) {
            return Err(
                "has no faces: an object is at least one face of three vertices, 'f 1 2 3'"
                    .to_owned(),
            );
        }
        let places = self.vertices.iter().zip(&self.lines).zip(&used);
        for ((p, &line), _) in places.filter(|(_, used)| **used) {
            if !p.is_finite() {
                return Err(format!(
                    "line {line}, '{}', is not a vertex: it is v and three finite numbers",
                    shortened(&statement(line))
                ));
            }
            if let Some(far) = p.to_array().into_iter().find(|x| x.abs() > LARGEST) {
                return Err(format!(
                    "line {line} has the coordinate {far:?}: they are drawn from {:e} to {LARGEST:e}",
                    -LARGEST
                ));
            }
        }
        Ok(used)
    }
}

/// The first three numbers; what follows, a weight or a colour, does not matter.
fn vertex<'a>(words: impl Iterator<Item = &'a str>) -> DVec3 {
    let mut numbers = words.map(|word| word.parse().unwrap_or(f64::NAN));
    let mut next = || numbers.next().unwrap_or(f64::NAN);
    DVec3::new(next(), next(), next())
}

fn no_vertex(line: usize, statement: &str, word: &str, vertices: usize) -> String {
    format!(
        "line {line}, '{}', names a vertex '{}' that is not among the {vertices}: they are numbered from 1 on, or back from -1",
        shortened(statement),
        shortened(word)
    )
}

/// For each vertex the first of those that are used at its place.
fn joined(vertices: &[DVec3], used: &[bool]) -> Vec<u32> {
    let mut first = BTreeMap::new();
    let places = (0..).zip(vertices.iter().zip(used));
    let first = places.map(|(i, (p, used))| match used {
        // 0 and −0 are one place.
        true => *first
            .entry(p.to_array().map(|x| (x + 0.0).to_bits()))
            .or_insert(i),
        false => i,
    });
    first.collect()
}

/// The corners of a face by the first vertex at their place, without repetitions.
fn outline(face: &[u32], joined: &[u32]) -> Vec<u32> {
    let corners = face.iter().filter_map(|&i| joined.get(i as usize));
    let mut corners: Vec<u32> = corners.copied().collect();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    corners
}

/// Whether the points of the faces are far enough apart to be drawn.
fn has_extent(used: &[bool], vertices: &[DVec3]) -> Result<(), String> {
    let corners = vertices.iter().zip(used).filter(|(_, used)| **used);
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = corners.fold(none, |(low, high), (&p, _)| (low.min(p), high.max(p)));
    let largest = low.abs().max(high.abs()).max_element();
    // The longest side of their box: unlike the diagonal it does not vanish when it is squared.
    let across = (high - low).max_element();
    if across >= largest.max(1.0) / LARGEST {
        return Ok(());
    }
    let place = as_typed(&low.to_array());
    Err(match across {
        0.0 => format!("has all points of its faces at ({place}): an object has points apart"),
        _ => format!(
            "has all points of its faces within {across:?} of ({place}): too close together to be drawn"
        ),
    })
}

fn shortened(line: &str) -> String {
    let clean = |c: char| if c.is_control() { ' ' } else { c };
    let mut short: String = line.trim().chars().take(40).map(clean).collect();
    if line.trim().chars().count() > 40 {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests;
