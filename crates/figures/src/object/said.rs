//! What is said of an object below its figure: that it is open, wound inwards, tiny or huge.

use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;

use super::NamedMesh;
use crate::words::{Word, words};

/// Below this size across, a twentieth of the lectures' cube, an object is tiny; the lights stand 100 away.
pub const TINY_BELOW: f64 = 1.0;
/// Above this size across, ten times the lectures' cube, an object is huge: the lights are inside its box.
pub const HUGE_ABOVE: f64 = 200.0;

words! {
    /// An edge has one face, or three.
    OPEN {
        en: "The object is open: it has edges with a face on one side only.",
        it: "L’oggetto è aperto: ha spigoli con una faccia da un solo lato.",
        cs: "Těleso je otevřené: má hrany se stěnou jen z jedné strany.",
        hr: "Objekt je otvoren: ima bridove sa stranicom samo s jedne strane.",
    }

    /// No edge ends a face, but faces beside one run along it the same way.
    DISAGREES {
        en: "Neighbouring faces of the object disagree on which side is outside.",
        it: "Facce vicine dell’oggetto non concordano su quale lato sia esterno.",
        cs: "Sousední stěny tělesa se neshodují v tom, která strana je vnější.",
        hr: "Susjedne stranice objekta ne slažu se koja je strana vanjska.",
    }

    /// Closed, and its volume is negative.
    INWARDS {
        en: "The object’s faces are wound inwards: their fronts look inside.",
        it: "Le facce dell’oggetto sono orientate verso l’interno.",
        cs: "Stěny tělesa jsou orientovány dovnitř.",
        hr: "Stranice objekta orijentirane su prema unutra.",
    }

    /// Smaller across than [`TINY_BELOW`].
    TINY {
        en: "The object is tiny beside the lectures’ cube.",
        it: "L’oggetto è minuscolo rispetto al cubo delle lezioni.",
        cs: "Těleso je proti krychli z přednášek nepatrné.",
        hr: "Objekt je sićušan prema kocki s predavanja.",
    }

    /// Larger across than [`HUGE_ABOVE`].
    HUGE {
        en: "The object is huge beside the lectures’ cube.",
        it: "L’oggetto è enorme rispetto al cubo delle lezioni.",
        cs: "Těleso je proti krychli z přednášek obrovské.",
        hr: "Objekt je golem prema kocki s predavanja.",
    }
}

/// What is to be known of an object before its figure is trusted, a sentence each; nothing of the lectures' cube.
///
/// # Properties
///
/// The winding is told of a closed object only: which side of an open one is outside is not settled.
#[must_use]
pub fn said(object: &NamedMesh) -> Vec<Word> {
    let mesh = &object.mesh;
    let mut said = Vec::new();
    match border(mesh) {
        Border::Open => said.push(OPEN),
        Border::Disagreeing => said.push(DISAGREES),
        Border::None if is_inwards(mesh) => said.push(INWARDS),
        Border::None => {}
    }
    let across = mesh.bounds().map(|[low, high]| (high - low).length());
    match across {
        Some(across) if across < TINY_BELOW => said.push(TINY),
        Some(across) if across > HUGE_ABOVE => said.push(HUGE),
        _ => {}
    }
    said
}

enum Border {
    /// Closed.
    None,
    /// An even number of faces at each edge, but not as many one way as the other.
    Disagreeing,
    Open,
}

fn border(mesh: &Mesh) -> Border {
    let edges = mesh.edges();
    let mut border = Border::None;
    for records in edges.chunk_by(|a, b| (a.from, a.to) == (b.from, b.to)) {
        let sides = records.iter().flat_map(|edge| [edge.left, edge.right]);
        let faces = sides.flatten().count();
        if faces % 2 == 1 {
            return Border::Open;
        }
        if faces != 2 * records.len() {
            border = Border::Disagreeing;
        }
    }
    border
}

/// Whether the volume is negative, beyond rounding.
fn is_inwards(mesh: &Mesh) -> bool {
    let [low, high] = mesh.bounds().unwrap_or_default();
    // From the middle of the box, so that no product is larger than it need be.
    let (middle, reach) = (low.midpoint(high), (high - low).length());
    let triangles = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
    let sixfold: f64 = triangles
        .map(|corners| {
            let [a, b, c]: [DVec3; 3] = corners.map(|p| p - middle);
            a.dot(b.cross(c))
        })
        .sum();
    // Each product is below reach³ and a dozen roundings off; their sum, once more for each.
    let count = mesh.triangles.len() as f64;
    sixfold < -(12.0 + count) * count * f64::EPSILON * reach * reach * reach
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::SOLIDS;
    use ombra_math::solids::{slide_cube, tetrahedron};

    fn of(mesh: Mesh) -> Vec<Word> {
        let name = "own.obj".to_owned();
        said(&NamedMesh { name, mesh })
    }

    fn scaled(by: f64) -> Mesh {
        let mut mesh = slide_cube();
        for p in &mut mesh.positions {
            *p *= by;
        }
        mesh
    }

    #[test]
    fn what_is_said_of_cubes() {
        assert_eq!(of(slide_cube()), []);
        assert_eq!(of(tetrahedron()).iter().filter(|w| **w != TINY).count(), 0);
        let mut lid_off = slide_cube();
        lid_off.triangles.pop();
        assert_eq!(of(lid_off.clone()), [OPEN]);
        let mut inward = slide_cube();
        inward.triangles.iter_mut().for_each(|t| t.reverse());
        assert_eq!(of(inward), [INWARDS]);
        // Far from the origin the volume is no less certain.
        let mut far = slide_cube();
        for p in &mut far.positions {
            *p += DVec3::splat(1e9);
        }
        assert_eq!(of(far.clone()), []);
        far.triangles.iter_mut().for_each(|t| t.reverse());
        assert_eq!(of(far), [INWARDS]);
        let mut one_turned = slide_cube();
        one_turned.triangles[3].reverse();
        assert_eq!(of(one_turned), [DISAGREES]);
        // The cube is 17.3 across.
        assert_eq!(of(scaled(0.05)), [TINY]);
        assert_eq!(of(scaled(0.06)), []);
        assert_eq!(of(scaled(11.5)), []);
        assert_eq!(of(scaled(11.6)), [HUGE]);
        // Both, and what has neither faces nor points.
        lid_off.positions.iter_mut().for_each(|p| *p *= 0.01);
        assert_eq!(of(lid_off), [OPEN, TINY]);
        assert_eq!(of(Mesh::default()), []);
    }

    #[test]
    fn a_flat_sheet_seen_from_both_sides_is_not_inwards() {
        let corners = vec![DVec3::ZERO, DVec3::X * 10.0, DVec3::Y * 10.0];
        let sheet = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 1]]).unwrap();
        assert_eq!(of(sheet), []);
    }

    #[test]
    fn of_the_solids_only_the_teapot_is_open() {
        for name in SOLIDS.split(", ") {
            let expected: &[Word] = if name == "teapot" { &[OPEN] } else { &[] };
            assert_eq!(said(&name.parse().unwrap()), expected, "{name}");
        }
    }
}
