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
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "no faces"),
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
    // What is left out does not count.
    text.push_str(&"f 1 2\nf 1 2 2\nl 1 2 3\np 1 2 3\n".repeat(MOST_TRIANGLES));
    assert_eq!(from_obj(&text).unwrap().triangles.len(), MOST_TRIANGLES);
    text.push_str("f 1 2 3\n");
    assert!(from_obj(&text).is_err_and(|error| error.contains("100000 triangles")));
    // One face of many corners counts as its triangles.
    let face = " 1 2 3".repeat(MOST_TRIANGLES / 3 + 2);
    let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{face}\n");
    assert!(from_obj(&text).is_err_and(|error| error.contains("100000 triangles")));
    let face = " 1 2 3".repeat(MOST_TRIANGLES / 3);
    let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{face}\n");
    assert!(from_obj(&text).is_ok());
}

/// Six squares, wound outwards, for the vertices of [`CUBE`].
const SQUARES: [&str; 6] = [
    "f 1 4 3 2",
    "f 5 6 7 8",
    "f 1 2 6 5",
    "f 2 3 7 6",
    "f 3 4 8 7",
    "f 4 1 5 8",
];
const CUBE: &str = "v 3 3 3\nv 5 3 3\nv 5 5 3\nv 3 5 3\nv 3 3 5\nv 5 3 5\nv 5 5 5\nv 3 5 5\n";

/// The areas of the triangles together.
fn area(mesh: &Mesh) -> f64 {
    let corners = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
    let areas = corners.map(|[a, b, c]| (b - a).cross(c - a).length() * 0.5);
    areas.sum()
}

/// A cube with the edge 2 at (3, 3, 3), however it is written.
fn is_the_cube(text: &str) {
    let (mesh, left_out) = read_obj(text).unwrap_or_else(|error| panic!("{text:?}: {error}"));
    let bounds = [DVec3::splat(3.0), DVec3::splat(5.0)];
    assert_eq!(mesh.bounds(), Some(bounds), "{text:?}");
    assert_eq!(
        (mesh.positions.len(), mesh.triangles.len()),
        (8, 12),
        "{text:?}"
    );
    assert!(mesh.is_two_manifold(), "{text:?}");
    assert_eq!(area(&mesh), 6.0 * 4.0, "{text:?}");
    assert_eq!(mesh.positions[0], DVec3::splat(3.0), "{text:?}");
    assert_eq!(left_out, LeftOut::default(), "{text:?}");
}

#[test]
fn a_cube_is_a_cube_however_it_is_written() {
    let squares = SQUARES.join("\n");
    let plain = format!("{CUBE}{squares}\n");
    is_the_cube(&plain);
    // Line ends, a mark at the start, padding at the end.
    is_the_cube(&plain.replace('\n', "\r\n"));
    is_the_cube(&plain.replace('\n', "\r"));
    is_the_cube(&format!("\u{feff}{plain}\0\0\u{1a}"));
    is_the_cube(&plain.replace(' ', "\t ").replace('\n', "  \t\n"));
    // Joined lines, comments anywhere.
    is_the_cube(&plain.replace(' ', " \\\n"));
    is_the_cube(&plain.replace('\n', " # é ü \u{fffd} \\\n"));
    // Numbers as they come.
    is_the_cube(&plain.replace("v 3 3 3", "v +3.0 .3e1 30e-1"));
    // Faces before their vertices, indices from the end, indices of what does not matter.
    is_the_cube(&format!("{squares}\n{CUBE}"));
    let back = SQUARES.map(|face| {
        let back = face
            .split(' ')
            .skip(1)
            .map(|i| i.parse::<i32>().unwrap() - 9);
        back.fold("f".to_owned(), |face, i| format!("{face} {i}"))
    });
    is_the_cube(&format!("{CUBE}{}", back.join("\n")));
    for more in ["/7", "//-99", "/99999999999999999999/1", "/0/0", "/"] {
        let faces = squares
            .replace(' ', &format!("{more} "))
            .replace("f/", "f /");
        let faces = faces.replace(&format!("f {more}"), "f");
        is_the_cube(&format!(
            "{CUBE}{}",
            faces.replace('\n', &format!("{more}\n"))
        ));
    }
    is_the_cube(&plain.replace('f', "fo"));
    // Colours, weights, on some only, and strange ones among them.
    is_the_cube(&plain.replacen("v 3 3 3", "v 3 3 3 2", 1));
    is_the_cube(&plain.replacen("v 5 5 5", "v 5 5 5 nan 1.#IND -nan(ind)", 1));
    // What else stands in files.
    let between = "usemtl\nusemtl wood and\tpine\nmtllib no such.mtl\ns off\nvt nan\nvn 1.#IND 0 0\nvw 1 2\nbevel off\nusemap x\ntrace_obj y\n";
    let groups = SQUARES.map(|face| format!("g side\no part\n{between}{face}\n"));
    is_the_cube(&format!("{CUBE}{}", groups.concat()));
    // Vertices without a face, and each side with corners of its own.
    is_the_cube(
        &plain
            .replacen("v 3 3 3\n", "v 3 3 3\nv nan 1e300 x\nv 9 9\n", 1)
            .replace(squares.as_str(), &renumbered(1, 2)),
    );
    let corners: Vec<&str> = CUBE.lines().collect();
    let own = SQUARES.map(|face| {
        let of_face = face
            .split(' ')
            .skip(1)
            .map(|i| corners[i.parse::<usize>().unwrap() - 1]);
        format!(
            "{}\nf -4 -3 -2 -1\n",
            of_face.collect::<Vec<_>>().join("\n")
        )
    });
    is_the_cube(&own.concat());
}

/// The squares with every index above `above` moved by `by`.
fn renumbered(above: u32, by: u32) -> String {
    let move_on = |i: &str| match i.parse::<u32>() {
        Ok(i) if i > above => (i + by).to_string(),
        _ => i.to_owned(),
    };
    SQUARES
        .map(|face| face.split(' ').map(move_on).collect::<Vec<_>>().join(" "))
        .join("\n")
}

#[test]
fn what_makes_no_faces_is_counted() {
    let squares = SQUARES.join("\n");
    let more = "l 1 2 3 4 99\np 1\np\ncurv 0 1 1 2\nf 1 2\nf 3\nf\nf 1 1 2 2\nfancy thing\n";
    let (mesh, left_out) = read_obj(&format!("{CUBE}{squares}\n{more}")).unwrap();
    assert!(mesh.is_two_manifold());
    let expected = LeftOut {
        points_and_lines: 3,
        curves_and_surfaces: 1,
        faces: 4,
        unknown: 1,
    };
    assert_eq!(left_out, expected);
    assert_eq!(
        left_out.to_string(),
        "3 points or lines, 1 curve or surface, 4 faces of fewer than three corners, 1 unknown statement"
    );
    assert_eq!(LeftOut::default().to_string(), "");
}

#[test]
fn prose_is_no_object_even_with_one_in_it() {
    let prose = "See how the square is written.\nFirst come\nthe vertices:\n\nNow the face:\nThat is all.\nFarewell.\n";
    let text = format!("{prose}v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    let error = from_obj(&text).unwrap_err();
    assert!(
        error.contains("is not an OBJ file: line 1 is 'See how"),
        "{error}"
    );
    let error = from_obj("solid cube\n facet normal 0 0 1\nf u\n").unwrap_err();
    assert!(
        error.contains("is not an OBJ file: line 1 is 'solid cube'"),
        "{error}"
    );
}

#[test]
fn a_face_open_by_a_slit_keeps_its_hole() {
    let corners = [
        (0, 0),
        (6, 0),
        (6, 6),
        (0, 6),
        (0, 0),
        (2, 2),
        (2, 4),
        (4, 4),
        (4, 2),
        (2, 2),
    ];
    // Flat, and in the plane z = 2x − y.
    for (a, b) in [(0, 0), (2, -1)] {
        let lift = |(x, y): (i32, i32)| format!("v {x} {y} {}\n", a * x + b * y);
        // As corners of their own, and as the same two vertices twice.
        let own: String = corners.map(lift).concat();
        let text = format!("{own}f 1 2 3 4 5 6 7 8 9 10\n");
        let mesh = from_obj(&text).unwrap();
        // The square less the hole, and stretched as much as the plane is steep.
        let stretch = f64::from(1 + a * a + b * b).sqrt();
        assert!(
            (area(&mesh) - 32.0 * stretch).abs() < 1e-12,
            "{}",
            area(&mesh)
        );
        assert_eq!(mesh.positions.len(), 8);
        assert_eq!(mesh.triangles.len(), 8);
        let shared = format!("{own}f 1 2 3 4 1 6 7 8 9 6\n");
        assert_eq!(from_obj(&shared).unwrap(), mesh);
    }
}

/// Twice as much text takes twice as many steps, whatever is repeated.
#[test]
fn steps_grow_with_the_text() {
    let steps = |text: &str| {
        let mut steps = 0;
        read(text, &mut steps).unwrap();
        steps
    };
    let own_corners = |n: usize| "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n".repeat(n);
    let equal = |n: usize| format!("{CUBE}{}", "f 1 2 3 4\n".repeat(n));
    let lines = |n: usize| format!("{CUBE}f 1 2 3\n{}", "l 1 2 3 4\n".repeat(n));
    let circle = |n: usize| {
        let at = |i: usize| (i as f64 / n as f64 * core::f64::consts::TAU).sin_cos();
        let places = (0..n).map(at).map(|(y, x)| format!("v {x} {y} 0\n"));
        let corners: String = (1..=n).map(|i| format!(" {i}")).collect();
        format!("{}f{corners}\n", places.collect::<String>())
    };
    let kinds: [(&str, &dyn Fn(usize) -> String); 4] = [
        ("corners of their own", &own_corners),
        ("equal faces", &equal),
        ("lines", &lines),
        ("one circle", &circle),
    ];
    for (name, text) in kinds {
        let [once, twice] = [2000, 4000].map(|n| steps(&text(n)));
        assert!(2 * twice < 5 * once, "{name}: {once}, {twice}");
    }
}
