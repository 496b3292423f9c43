//! The object a figure shows: a built-in solid or an instructor's own OBJ file, checked before anything is drawn.

use core::str::FromStr;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;
use ombra_math::solids;

use crate::error::FigureError;

/// Most triangles an object may have.
pub const MOST_TRIANGLES: usize = 100_000;
/// Largest OBJ file that is read at all: 64 MiB.
pub const MOST_BYTES: u64 = 64 << 20;
/// Most vertices that are still labelled one by one.
pub const LABELLED: usize = 16;

/// An object with the name it was asked for by.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedMesh {
    /// `cube`, `teapot`, or the file's path.
    pub name: String,
    /// Its triangles. A solid and a file of more than [`LABELLED`] vertices stand in the place of the lectures' cube; a
    /// smaller file, whose coordinates the figure shows, stays where it is.
    pub mesh: Mesh,
}

/// Diagonal of the box of an object that stands in for the lectures' cube, whose own is 17.3.
pub const ACROSS: f64 = 20.0;

/// The names of the built-in solids.
pub const SOLIDS: &str = "cube, teapot, sphere, torus";

impl FromStr for NamedMesh {
    type Err = FigureError;

    /// A built-in solid by name, in the place of the lectures' cube, or the file of that path.
    fn from_str(name: &str) -> Result<Self, FigureError> {
        let built_in = |solid: Result<Mesh, solids::SolidError>| {
            let mesh = solid.map_err(|error| FigureError::Object {
                file: name.to_owned(),
                reason: error.to_string(),
            })?;
            Ok(in_place_of_the_cube(mesh))
        };
        let mesh = match name {
            "cube" => solids::slide_cube(),
            "teapot" => built_in(solids::teapot(12))?,
            "sphere" => built_in(solids::sphere(1.0, 48, 24))?,
            "torus" => built_in(solids::torus(3.0, 1.2, 64, 24))?,
            _ => match from_file(name)? {
                mesh if mesh.positions.len() > LABELLED => in_place_of_the_cube(mesh),
                mesh => mesh,
            },
        };
        Ok(NamedMesh {
            name: name.to_owned(),
            mesh,
        })
    }
}

/// Moved and scaled alike in all directions, so that it stands on the middle of the base of the lectures' cube, its
/// box as large across as [`ACROSS`].
pub fn in_place_of_the_cube(mut mesh: Mesh) -> Mesh {
    const BASE: DVec3 = DVec3::new(5.0, 20.0, 5.0);
    if let Some([low, high]) = mesh.bounds() {
        let scale = ACROSS / (high - low).length();
        let base = DVec3::new((low.x + high.x) * 0.5, low.y, (low.z + high.z) * 0.5);
        if scale.is_finite() && base.is_finite() {
            for p in &mut mesh.positions {
                *p = (*p - base) * scale + BASE;
            }
        }
    }
    mesh
}

fn from_file(name: &str) -> Result<Mesh, FigureError> {
    let wrong = |reason: String| FigureError::Object {
        file: name.to_owned(),
        reason,
    };
    let path = Path::new(name);
    let about = std::fs::metadata(path).map_err(|error| {
        wrong(format!(
            "cannot be read ({error}); it is an OBJ file or one of {SOLIDS}"
        ))
    })?;
    if !about.is_file() {
        return Err(wrong(format!(
            "is not a file; it is an OBJ file or one of {SOLIDS}"
        )));
    }
    let too_long = || {
        wrong(format!(
            "has more than {MOST_BYTES} bytes, the most that are read"
        ))
    };
    if about.len() > MOST_BYTES {
        return Err(too_long());
    }
    // The limit holds for a file that grows while it is read, too.
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes))
        .map_err(|error| wrong(format!("cannot be read ({error})")))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(too_long());
    }
    let text = core::str::from_utf8(&bytes)
        .map_err(|_| wrong("is not an OBJ file: it is not text".to_owned()))?;
    from_obj(text).map_err(wrong)
}

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
    Mesh::new(positions, triangles).map_err(|error| error.to_string())
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
                let finite = |word: &str| word.parse::<f64>().is_ok_and(f64::is_finite);
                if coordinates.len() < 3 || !coordinates.iter().all(|word| finite(word)) {
                    return Err(format!(
                        "line {number}, '{}', is not a vertex: it is v and three finite numbers",
                        shortened(line)
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

    #[test]
    fn solids_stand_where_the_cube_stands() {
        for name in SOLIDS.split(", ") {
            let named: NamedMesh = name.parse().unwrap();
            assert!(named.mesh.triangles.len() <= MOST_TRIANGLES);
            let [low, high] = named.mesh.bounds().unwrap();
            // Within rounding of coordinates below 32: a few of their ulps.
            let near = |a: f64, b: f64| (a - b).abs() <= 32.0 * 4.0 * f64::EPSILON;
            assert!(
                near(low.y, 20.0) && near(low.x + high.x, 10.0) && near(low.z + high.z, 10.0),
                "{name}"
            );
            assert!(
                name == "cube" || near((high - low).length(), ACROSS),
                "{name}"
            );
        }
        // What has no size stays as it is.
        let point = Mesh::new(vec![DVec3::ONE; 3], vec![[0, 1, 2]]).unwrap();
        assert_eq!(in_place_of_the_cube(point.clone()), point);
    }

    #[test]
    fn what_is_no_file_says_so() {
        let folder = std::env::temp_dir();
        let error = folder
            .to_string_lossy()
            .parse::<NamedMesh>()
            .unwrap_err()
            .to_string();
        assert!(error.contains("is not a file"), "{error}");
        let error = "no-such-file.obj"
            .parse::<NamedMesh>()
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("--mesh no-such-file.obj: cannot be read")
                && error.contains("teapot"),
            "{error}"
        );
    }
}
