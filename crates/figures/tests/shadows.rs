//! What the figures of the shadows lecture show, against the lecture's answers and the library's results.

#![allow(clippy::unwrap_used, clippy::panic)]

use ombra_figures::colour::Role;
use ombra_figures::course::{figures, select};
use ombra_figures::drawing::{Drawing, Item, Paint};
use ombra_figures::figure::Figure;
use ombra_figures::input::Inputs;
use ombra_figures::number::exact;
use ombra_figures::path::Path;
use ombra_figures::style::{Background, Language, Style};
use ombra_figures::svg;
use ombra_figures::text::{LABEL, Line};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast;

fn inputs(figure: &Figure, light: Option<&str>, plane: Option<&str>, mesh: Option<&str>) -> Inputs {
    let mut inputs = Inputs::default();
    for (name, text) in [("light", light), ("plane", plane), ("mesh", mesh)] {
        let mut all = figure.takes.inputs().iter();
        if let (Some(text), Some(input)) = (text, all.find(|input| input.name == name)) {
            inputs = inputs.with(input, text).unwrap();
        }
    }
    inputs
}

fn drawn(id: &str, light: Option<&str>, plane: Option<&str>, mesh: Option<&str>) -> Drawing {
    let figure = select(&[id]).unwrap()[0];
    let inputs = inputs(figure, light, plane, mesh);
    figure
        .draw(&Style::default(), &inputs)
        .unwrap_or_else(|error| panic!("{id}: {error}"))
}

fn words(drawing: &Drawing) -> Vec<&str> {
    drawing
        .labels
        .iter()
        .map(|label| label.text.as_str())
        .collect()
}

fn says(drawing: &Drawing, expected: &[&str]) {
    let words = words(drawing);
    for line in expected {
        assert!(words.contains(line), "'{line}' is not among {words:?}");
    }
}

/// Shapes filled with one role's own colour.
fn filled(drawing: &Drawing, wanted: Role) -> Vec<&Path> {
    let of = |item| match item {
        &Item::Shape {
            ref path,
            fill: Some((Paint::Solid(ink), _)),
            ..
        } if ink.role == wanted && ink.share == 1.0 => Some(path),
        _ => None,
    };
    drawing.items.iter().filter_map(of).collect()
}

/// Summary, caption, labels and shapes of a figure.
fn told(id: &str, inputs: &Inputs) -> (String, String, Vec<String>, Vec<Item>) {
    let style = Style {
        caption: true,
        ..Style::default()
    };
    let figure = select(&[id]).unwrap()[0];
    let drawing = figure
        .draw(&style, inputs)
        .unwrap_or_else(|error| panic!("{id}: {error}"));
    let caption = figure.caption(inputs, Language::En);
    let labels = words(&drawing).into_iter().map(str::to_owned).collect();
    let shape = |item: &Item| matches!(item, Item::Shape { .. });
    let shapes = drawing.items.into_iter().filter(shape).collect();
    (drawing.title, caption, labels, shapes)
}

#[test]
fn the_words_follow_what_is_drawn() {
    let told = |id: &str, (light, plane, mesh)| {
        let figure = select(&[id]).unwrap()[0];
        told(id, &inputs(figure, light, plane, mesh))
    };
    let (far, near) = (Some("3,9,5,0"), Some("5,90,60,1"));
    for id in ["shadows/cube-infinity", "shadows/cube-point"] {
        for (light, kind, caption) in [
            (far, "light at infinity", "Light at infinity: "),
            (near, "point light", "Light at a place: "),
            // The same place, written with another w.
            (
                Some("-10,-180,-120,-2"),
                "point light",
                "Light at a place: ",
            ),
        ] {
            for (mesh, object) in [
                (None, "A cube"),
                (Some("cube"), "A cube"),
                (Some("torus"), "An object"),
            ] {
                let (title, said, ..) = told(id, (light, None, mesh));
                assert!(
                    title.starts_with(&format!("{object} under a {kind}")),
                    "{id}: {title}"
                );
                assert!(said.starts_with(caption), "{id}: {said}");
                assert!(
                    !(object == "An object" && said.contains("cube")),
                    "{id}: {said}"
                );
            }
        }
    }
    let id = "shadows/planar-any-plane";
    for (plane, mesh, title) in [
        (None, None, "A cube’s shadow on a slanted wall"),
        (None, Some("torus"), "An object’s shadow on a slanted wall"),
        (Some("0,1,0,5"), None, "A cube’s shadow on a plane"),
        (
            Some("0,1,0,5"),
            Some("torus"),
            "An object’s shadow on a plane",
        ),
    ] {
        assert_eq!(told(id, (None, plane, mesh)).0, title);
    }
    // Right above the vertex (8, 3) there are no triangles to speak of.
    let id = "shadows/planar-similar-triangles";
    for (light, triangles) in [("16,9,0,1", true), ("8,9,0,1", false), ("0,1,0,0", false)] {
        let (title, caption, ..) = told(id, (Some(light), None, None));
        assert_eq!(title.contains("triangles"), triangles, "{light}");
        assert_eq!(caption.contains("similar triangles"), triangles, "{light}");
    }
}

/// A solid of many faces is a picture made of pixels, and the caption says so.
#[test]
fn a_large_solid_is_drawn_by_pixels_and_the_caption_says_so() {
    for id in [
        "shadows/cube-infinity",
        "shadows/planar-any-plane",
        "shadows/fake",
    ] {
        let figure = select(&[id]).unwrap()[0];
        for (mesh, large) in [
            (None, false),
            (Some("torus"), false),
            (Some("teapot"), true),
        ] {
            let inputs = inputs(figure, None, None, mesh);
            for (language, word) in [
                (Language::En, "z-buffer"),
                (Language::It, "z-buffer"),
                (Language::Cs, "z-bufferu"),
                (Language::Hr, "z-spremnika"),
            ] {
                let caption = figure.caption(&inputs, language);
                assert_eq!(caption.contains(word), large, "{id} {mesh:?}: {caption}");
            }
            let drawing = figure.draw(&Style::default(), &inputs).unwrap();
            let by_pixels = |item: &Item| matches!(item, Item::Picture { .. });
            assert_eq!(drawing.items.iter().any(by_pixels), large, "{id} {mesh:?}");
            let svg = svg::svg(&drawing).unwrap();
            assert_eq!(svg.contains("<image x="), large, "{id} {mesh:?}");
            assert!(svg.len() < 400_000, "{id} {mesh:?}: {} bytes", svg.len());
        }
    }
}

/// Each input that a figure takes moves its geometry; the light's and the plane's numbers are labels as well.
#[test]
fn every_input_a_figure_takes_moves_it() {
    for figure in figures() {
        let usual = told(figure.id, &Inputs::default());
        for (name, text) in [
            ("light", "-3,20,5,0"),
            ("plane", "1,3,0,8"),
            ("mesh", "torus"),
        ] {
            let mut all = figure.takes.inputs().iter();
            let Some(input) = all.find(|input| input.name == name) else {
                continue;
            };
            let moved = told(figure.id, &Inputs::default().with(input, text).unwrap());
            assert_ne!(usual.3, moved.3, "{} {name}", figure.id);
            // The object of `shadows/fake` has no labels of its own.
            let silent = figure.id == "shadows/fake" && name == "mesh";
            assert_eq!(usual.2 == moved.2, silent, "{} {name}", figure.id);
        }
    }
}

/// P_x = 100 x / (100 − y), P_z = (100 z − 100 y) / (100 − y), worked by hand (Olomouc, Zdroj světla v bodě).
#[test]
fn cube_point_shows_the_exact_fractions() {
    let drawing = drawn("shadows/cube-point", None, None, None);
    says(
        &drawing,
        &[
            "L = (0, 100, 100, 1)",
            "P1 (0, 0, −25)",
            "P2 (25/2, 0, −25)",
            "P3 (25/2, 0, −25/2)",
            "P4 (0, 0, −25/2)",
            "P5 (0, 0, −300/7)",
            "P6 (100/7, 0, −300/7)",
            "P7 (100/7, 0, −200/7)",
            "P8 (0, 0, −200/7)",
        ],
    );
}

/// 12 : 8 = 9 : 6 at first; the others by P_x = (L_y V_x − L_x V_y) / (L_y − V_y) and V_x − (V_y / L_y) L_x.
#[test]
fn similar_triangles_follow_the_light() {
    let id = "shadows/planar-similar-triangles";
    let legs = ["Ly", "Vy", "Ly − Vy", "Lx − Vx", "Lx − Px"];
    let usual = drawn(id, None, None, None);
    says(&usual, &["V (8, 3)", "P (4, 0)", "L = (16, 9, 0, 1)"]);
    says(&usual, &legs);
    assert!(words(&usual).iter().any(|line| {
        line.starts_with("(Lx − Px)/(Lx − Vx) = Ly/(Ly − Vy)") && line.ends_with("= 4")
    }));

    // The other side: 72/6 + 12/6.
    let left = drawn(id, Some("-4,9,2,1"), None, None);
    says(&left, &["V (8, 3)", "P (14, 0)", "Px − Lx", "Vx − Lx"]);
    // Twenty times as high and homogeneous: V is (80, 30).
    let high = drawn(id, Some("0,-200,0,-2"), None, None);
    says(&high, &["V (80, 30)", "P (800/7, 0)"]);
    // At infinity: 8 − (3/8) 3.
    let far = drawn(id, Some("3,8,7,0"), None, None);
    says(&far, &["V (8, 3)", "P (55/8, 0)", "Lx", "Ly", "Vx − Px"]);
    // Right above there are no triangles, but a shadow.
    let above = drawn(id, Some("8,9,0,1"), None, None);
    says(&above, &["P (8, 0)"]);
    assert!(!words(&above).contains(&"Lx − Px"));

    for wrong in ["16,0,0,1", "16,-9,0,1", "1e9,9,0,1", "1,0,0,0"] {
        let figure = select(&[id]).unwrap()[0];
        let inputs = inputs(figure, Some(wrong), None, None);
        let error = figure.draw(&Style::default(), &inputs).unwrap_err();
        assert!(error.to_string().contains("--light"), "{error}");
    }
}

/// From L = (10, 60, 50) to V = (0, 20, 10) it is (−10, −40, −40); y + 2 z + 20 falls by 120 on that way and is 60 at V, so
/// P = V + (−10, −40, −40) / 2.
#[test]
fn any_plane_shows_the_equation_and_a_point_on_it() {
    let id = "shadows/planar-any-plane";
    says(
        &drawn(id, None, None, None),
        &["y + 2z + 20 = 0", "n", "V (0, 20, 10)", "P (−5, 0, −10)"],
    );
    let other = drawn(id, None, Some("1,1,2,10"), None);
    says(&other, &["x + y + 2z + 10 = 0"]);
    let light = DVec4::new(15.0, 45.0, 35.0, 1.0);
    let plane = Plane {
        normal: DVec3::new(1.0, 1.0, 2.0),
        d: 10.0,
    };
    let other = drawn(id, Some("15,45,35,1"), Some("1,1,2,10"), None);
    let named = words(&other)
        .into_iter()
        .find_map(|line| line.strip_prefix("P ").map(str::to_owned))
        .unwrap();
    // The point shown is the library's shadow of one of the corners.
    let shown = |p: DVec3| {
        let markup = format!("({}, {}, {})", exact(p.x), exact(p.y), exact(p.z));
        Line::new(&markup, LABEL).unwrap().plain
    };
    let corners = ombra_math::solids::slide_cube().positions;
    assert!(
        corners
            .iter()
            .any(|&v| shown(cast(plane, light, v).unwrap()) == named),
        "{named}"
    );
}

#[test]
fn one_shadow_is_true_and_two_are_false() {
    let drawing = drawn("shadows/false-shadow", None, None, None);
    says(&drawing, &["t = −1", "t = 1/3", "t = 3"]);
    let count = |word| words(&drawing).iter().filter(|line| **line == word).count();
    assert_eq!((count("true shadow"), count("false shadow")), (1, 2));
    // The order of the panels: case and number agree.
    let at = |word: &str| {
        let label = drawing
            .labels
            .iter()
            .find(|label| label.text.starts_with(word));
        label.unwrap().bounds.centre().x
    };
    assert!(at("t = −1") < at("t = 1/3") && at("t = 1/3") < at("t = 3"));
    for (number, case) in [
        ("t = −1", "t ≤ 0:"),
        ("t = 1/3", "0 < t < 1:"),
        ("t = 3", "t > 1:"),
    ] {
        assert!((at(number) - at(case)).abs() < 300.0, "{number} {case}");
    }
}

#[test]
fn the_ball_is_the_same_three_times_and_the_shadow_is_not() {
    let drawing = drawn("shadows/why", None, None, None);
    let balls: Vec<(f64, f64, f64)> = drawing
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Shape {
                path,
                fill: Some((Paint::Radial { .. }, _)),
                ..
            } => {
                let bounds = path.bounds()?;
                Some((bounds.centre().x, bounds.centre().y, bounds.size().x))
            }
            _ => None,
        })
        .collect();
    let [a, b, c] = balls[..] else {
        panic!("{balls:?}")
    };
    // Equal to the hundredths of the display list, in panels equally far apart.
    for (one, other) in [(a, b), (b, c)] {
        assert!((one.1 - other.1).abs() < 0.02 && (one.2 - other.2).abs() < 0.02);
    }
    assert!(((b.0 - a.0) - (c.0 - b.0)).abs() < 0.03);

    let shadows = filled(&drawing, Role::Umbra);
    let [resting, hovering] = shadows[..] else {
        panic!("{} shadows", shadows.len())
    };
    let (resting, hovering) = (resting.bounds().unwrap(), hovering.bounds().unwrap());
    // Of equal size, as the light is at infinity; one touches the ball, the other is well below it.
    assert!((resting.size() - hovering.size()).length() < 0.1);
    let bottom = a.1 + 0.5 * a.2;
    assert!(resting.min.y < bottom && hovering.min.y > bottom);
}

#[test]
fn the_ellipse_lies_over_the_true_shadow() {
    let id = "shadows/fake";
    let usual = drawn(id, None, None, None);
    says(&usual, &["true shadow", "fake: an ellipse"]);
    let shadow = |drawing: &Drawing| filled(drawing, Role::Umbra)[0].bounds().unwrap();
    for mesh in ["cube", "teapot", "torus"] {
        let drawing = drawn(id, None, None, Some(mesh));
        let ellipse = drawing.items.iter().find_map(|item| match item {
            Item::Shape {
                path,
                fill: None,
                stroke: Some(pen),
            } if path.segments.len() > 70 && pen.paint == Paint::from(Role::Chosen) => {
                path.bounds()
            }
            _ => None,
        });
        assert!(ellipse.unwrap().meets(&shadow(&drawing)), "{mesh}");
    }
    let moved = drawn(id, Some("1,9,4,0"), None, None);
    assert_ne!(shadow(&usual), shadow(&moved));
}

#[test]
fn a_moved_plane_and_another_object_change_the_picture() {
    for id in [
        "shadows/cube-infinity",
        "shadows/cube-point",
        "shadows/planar-any-plane",
    ] {
        let usual = svg::svg(&drawn(id, None, None, None)).unwrap();
        for (plane, mesh) in [(Some("0,1,0,5"), None), (None, Some("torus"))] {
            let other = drawn(id, None, plane, mesh);
            assert_ne!(usual, svg::svg(&other).unwrap(), "{id}");
        }
    }
    let low = drawn("shadows/cube-infinity", None, Some("0,1,0,5"), None);
    says(&low, &["P2 (−15, −5, −25)"]);
}

#[test]
fn lights_far_and_near_leave_the_sun_on_the_canvas() {
    for light in [
        "0,100,100,1",
        "-60,40,30,1",
        "40,35,-30,1",
        "5,31,5,1",
        "5,60,5,1",
        "90,90,-90,1",
        "1000,3000,500,1",
        "-3,20,5,0",
    ] {
        for id in ["shadows/cube-point", "shadows/fake"] {
            let drawing = drawn(id, Some(light), None, None);
            for item in &drawing.items {
                if let Item::Shape { path, .. } = item {
                    let inside = |p: ombra_math::glam::DVec2| {
                        p.cmpge(DVec3::ZERO.truncate()).all() && p.cmple(drawing.canvas).all()
                    };
                    assert!(path.points().all(inside), "{id} {light}");
                }
            }
        }
    }
}

/// A rim of paper is drawn only around letters that lie over something: on a transparent background it would show.
#[test]
fn letters_on_nothing_have_no_rim() {
    let style = Style {
        background: Background::Transparent,
        ..Style::default()
    };
    let id = "shadows/planar-similar-triangles";
    let drawing = select(&[id]).unwrap()[0]
        .draw(&style, &Inputs::default())
        .unwrap();
    let rim_of = |word: &str| {
        drawing.items.iter().find_map(|item| match item {
            Item::Text { line, halo, .. } if line.plain == word => Some(*halo),
            _ => None,
        })
    };
    assert_eq!(rim_of("V (8, 3)"), Some(false));
    assert_eq!(rim_of("Ly"), Some(false));
    let cube = drawn("shadows/cube-infinity", None, None, None);
    let over_the_cube = cube
        .items
        .iter()
        .any(|item| matches!(item, Item::Text { line, halo: true, .. } if line.plain == "V8"));
    assert!(over_the_cube);
}

/// Every shadow drawn is one path; a mesh's own triangles leave no seams.
#[test]
fn a_meshs_shadow_is_one_path() {
    for mesh in ["teapot", "torus", "sphere"] {
        let drawing = drawn("shadows/planar-any-plane", None, None, Some(mesh));
        assert_eq!(filled(&drawing, Role::Umbra).len(), 1, "{mesh}");
    }
}
