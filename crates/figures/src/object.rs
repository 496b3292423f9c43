//! The object a figure shows: a built-in solid or an instructor's own OBJ file, checked before anything is drawn.

mod obj;

pub use obj::from_obj;

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
#[derive(Clone, Debug, Default, PartialEq)]
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

    /// A built-in solid by name, in small or capital letters, in the place of the lectures' cube; or the file of that
    /// path.
    fn from_str(name: &str) -> Result<Self, FigureError> {
        let built_in = |solid: Result<Mesh, solids::SolidError>| {
            let mesh = solid.map_err(|error| FigureError::Object {
                file: name.to_owned(),
                reason: error.to_string(),
            })?;
            Ok(in_place_of_the_cube(mesh))
        };
        let small = name.to_ascii_lowercase();
        let solid = SOLIDS.split(", ").find(|&solid| solid == small);
        let name = solid.unwrap_or(name);
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

#[cfg(test)]
mod tests {
    use super::*;

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
