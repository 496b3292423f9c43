//! OBJ text, checked before anything is made of it.

use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;

use super::MOST_TRIANGLES;
use crate::number::as_typed;

/// Largest size of a coordinate, and of the box around an object across; the smallest is its inverse, in itself and
/// beside the largest coordinate. Beyond, what is left of an object after rounding says nothing.
const LARGEST: f64 = 1e9;

/// Reads an OBJ text.
///
/// # Errors
///
/// A sentence that says what is wrong with the text, with the number of its line where there is one.
pub fn from_obj(text: &str) -> Result<Mesh, String> {
    check(text)?;
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: false,
        ignore_points: true,
        ignore_lines: true,
    };
    // Materials do not matter here: a library that is not there is taken as empty.
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        tobj::load_mtl_buf(&mut &b""[..])
    })
    .map_err(|error| format!("is not an OBJ file that can be drawn: {error}"))?;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for model in models {
        let first =
            u32::try_from(positions.len()).map_err(|_| "has too many vertices".to_owned())?;
        let corners = model.mesh.positions.as_chunks::<3>().0;
        positions.extend(corners.iter().map(|&p| DVec3::from_array(p)));
        for triangle in model.mesh.indices.as_chunks::<3>().0 {
            triangles.push(triangle.map(|index| index.saturating_add(first)));
        }
    }
    let mesh = Mesh::new(positions, triangles).map_err(|error| error.to_string())?;
    has_extent(&mesh)?;
    Ok(mesh)
}

/// Whether the points of the faces are far enough apart to be drawn.
fn has_extent(mesh: &Mesh) -> Result<(), String> {
    let corners = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = corners
        .flatten()
        .fold(none, |(low, high), p| (low.min(p), high.max(p)));
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

/// What tobj lets through: prose, numbers that are not finite, faces of two corners, indices of nothing; and faces
/// counted before any memory is spent on them.
fn check(text: &str) -> Result<(), String> {
    const KEYWORDS: [&str; 22] = [
        "v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl", "mg", "cstype",
        "deg", "curv", "curv2", "surf", "parm", "trim", "end", "lod",
    ];
    let (mut vertices, mut triangles) = (0_usize, 0_usize);
    for (number, line) in text.lines().enumerate() {
        let number = number + 1;
        let line = line.split('#').next().unwrap_or("");
        let mut words = line.split_whitespace();
        let Some(keyword) = words.next() else {
            continue;
        };
        match keyword {
            "v" => {
                let coordinates: Vec<&str> = words.collect();
                let finite = |word: &str| word.parse().ok().filter(|x: &f64| x.is_finite());
                let numbers: Option<Vec<f64>> = coordinates.into_iter().map(finite).collect();
                let Some([x, y, z, ..]) = numbers.as_deref() else {
                    return Err(format!(
                        "line {number}, '{}', is not a vertex: it is v and three finite numbers",
                        shortened(line)
                    ));
                };
                if let Some(far) = [x, y, z].into_iter().find(|x| x.abs() > LARGEST) {
                    return Err(format!(
                        "line {number} has the coordinate {far:?}: they are drawn from {:e} to {LARGEST:e}",
                        -LARGEST
                    ));
                }
                vertices += 1;
            }
            "f" => {
                let mut corners = 0_usize;
                for word in words {
                    let index = word
                        .split('/')
                        .next()
                        .and_then(|index| index.parse::<i64>().ok());
                    let in_range = index.is_some_and(|index| {
                        let most = i64::try_from(vertices).unwrap_or(i64::MAX);
                        (1..=most).contains(&index) || (-most..=-1).contains(&index)
                    });
                    if !in_range {
                        return Err(format!(
                            "line {number}, '{}', names a vertex '{word}' that is not among the {vertices} before it",
                            shortened(line)
                        ));
                    }
                    corners += 1;
                }
                if corners < 3 {
                    return Err(format!(
                        "line {number}, '{}', is not a face: a face has at least three vertices",
                        shortened(line)
                    ));
                }
                triangles += corners - 2;
                if triangles > MOST_TRIANGLES {
                    return Err(format!(
                        "has more than {MOST_TRIANGLES} triangles, the most that are drawn"
                    ));
                }
            }
            _ if KEYWORDS.contains(&keyword) => {}
            _ => {
                return Err(format!(
                    "is not an OBJ file: line {number} is '{}'",
                    shortened(line)
                ));
            }
        }
    }
    match (vertices, triangles) {
        (0, _) => Err(
            "has no vertices: an object is at least three vertices 'v x y z' and a face".to_owned(),
        ),
        (_, 0) => Err("has no faces: an object is at least one face 'f 1 2 3'".to_owned()),
        _ => Ok(()),
    }
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
mod tests {
    use super::*;

    const QUAD: &str = "# a square\nmtllib none.mtl\no square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3 4\n";

    #[test]
    fn a_square_is_two_triangles() {
        let mesh = from_obj(QUAD).unwrap();
        assert_eq!(mesh.positions.len(), 4);
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn several_objects_become_one() {
        let text =
            format!("{QUAD}o second\nv 0 0 5\nv 1 0 5\nv 1 1 5\nf -3 -2 -1\nf 1/1/1 2/2/2 7//3\n");
        let mesh = from_obj(&text).unwrap();
        assert_eq!(mesh.triangles.len(), 4);
        let corner = |t: usize, c: usize| mesh.positions[mesh.triangles[t][c] as usize];
        assert_eq!(corner(2, 0), DVec3::new(0.0, 0.0, 5.0));
        assert_eq!(corner(3, 0), DVec3::ZERO);
        assert_eq!(corner(3, 2), DVec3::new(1.0, 1.0, 5.0));
    }

    #[test]
    fn what_is_no_object_says_why() {
        for (text, says) in [
            ("", "no vertices"),
            ("# only a comment\n", "no vertices"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no faces"),
            (
                "Dear students, this is prose.\n",
                "line 1 is 'Dear students",
            ),
            ("v 0 0 NaN\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "'v 0 0 NaN'"),
            ("v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n", "line 2"),
            ("v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1"),
            (
                "v 0 0 0\nv 1 0 1e300\nv 0 1 0\nf 1 2 3\n",
                "line 2 has the coordinate 1e300: they are drawn from -1e9 to 1e9",
            ),
            (
                "v 1 2.5 -3\nv 1 2.5 -3\nv 1 2.5 -3\nf 1 2 3\n",
                "has all points of its faces at (1,2.5,-3)",
            ),
            // A point of no face gives no extent.
            (
                "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 1 1 1\nf 1 2 3\n",
                "at (0,0,0)",
            ),
            (
                "v 1e8 0 0\nv 1e8 0 0\nv 1e8 0.01 0\nf 1 2 3\n",
                "within 0.01 of (100000000,0,0)",
            ),
            ("v 0 0 0\nv 1e-300 0 0\nv 0 0 0\nf 1 2 3\n", "within 1e-300"),
            ("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "'f 1 2'"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "'4'"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "'0'"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "'-4'"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf a b c\n", "'a'"),
        ] {
            let error = from_obj(text).unwrap_err();
            assert!(error.contains(says), "{text:?}: {error}");
        }
    }

    #[test]
    fn too_many_triangles_are_refused_while_counting() {
        let mut text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned();
        text.push_str(&"f 1 2 3\n".repeat(MOST_TRIANGLES));
        assert!(check(&text).is_ok());
        text.push_str("f 1 2 3\n");
        assert!(from_obj(&text).unwrap_err().contains("100000 triangles"));
        // One face of many corners counts as its triangles.
        let fan = format!("v 0 0 0\nf{}\n", " 1".repeat(MOST_TRIANGLES + 3));
        assert!(from_obj(&fan).unwrap_err().contains("100000 triangles"));
    }
}
