use super::*;

const WORD: Word = Word::english("something");

fn read(kind: Kind, text: &str) -> Option<Value> {
    let (name, symbol, about) = ("x", "*x*", WORD);
    let input = Input {
        name,
        symbol,
        about,
        kind,
    };
    let value = input.read(text);
    if let Err(error) = &value {
        let said = error.to_string();
        assert!(
            said.contains(&format!("'{text}'")) && said.contains(&kind.allowed()),
            "{said}"
        );
    }
    value.ok()
}

#[test]
fn numbers_are_finite_and_within_their_range() {
    let kind = Kind::Number {
        default: 30.0,
        range: [0.0, 180.0],
    };
    assert_eq!(read(kind, " 12.5"), Some(Value::Number(12.5)));
    assert_eq!(read(kind, "180"), Some(Value::Number(180.0)));
    for wrong in ["", "x", "-1", "180.5", "NaN", "inf", "1,2", "1e400"] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
    let kind = Kind::Whole {
        default: 3,
        range: [1, 9],
    };
    assert_eq!(read(kind, "9"), Some(Value::Whole(9)));
    for wrong in ["0", "10", "3.0", "", "99999999999"] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
}

#[test]
fn points_pixels_places_and_polygons() {
    let range = [[-4.0, -2.0], [4.0, 2.0]];
    let kind = Kind::Point {
        default: [0.0, 1.0],
        range,
    };
    assert_eq!(
        read(kind, "-4, 2"),
        Some(Value::Point(DVec2::new(-4.0, 2.0)))
    );
    for wrong in ["1", "1,2,3", "1,2.5", "5,0", "NaN,0", ",", "1;2"] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
    let kind = Kind::Pixel {
        default: [0, 0],
        range: [[0, 0], [12, 8]],
    };
    assert_eq!(read(kind, "8,3"), Some(Value::Pixel(IVec2::new(8, 3))));
    for wrong in ["8.0,3", "13,0", "0,-1", "8", "8,3,1"] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
    let kind = Kind::Place {
        default: [0.0; 3],
        range: [-9.0, 9.0],
    };
    assert_eq!(
        read(kind, "1,2,-9"),
        Some(Value::Place(DVec3::new(1.0, 2.0, -9.0)))
    );
    assert_eq!(read(kind, "1,2,-9.5"), None);
    let kind = Kind::Polygon {
        default: &[[0.0, 0.0]],
        corners: [3, 4],
        range,
    };
    let triangle = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
    assert_eq!(
        read(kind, "0,0 1,0  0,1"),
        Some(Value::Polygon(triangle.clone()))
    );
    assert_eq!(read(kind, "0,0;1,0;0,1"), Some(Value::Polygon(triangle)));
    for wrong in ["0,0 1,0", "0,0 1,0 0,1 1,1 2,2", "0,0 1,0 0,9", "0,0 1 0,1"] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
}

#[test]
fn lights_planes_and_choices() {
    let kind = Kind::Light {
        default: [0.0, 1.0, 0.0, 0.0],
    };
    let light = DVec4::new(1.0, -2.0, 300.0, 0.0);
    assert_eq!(read(kind, " 1, -2 ,3e2,0"), Some(Value::Light(light)));
    for wrong in [
        "",
        "1,2,3",
        "1,2,3,4,5",
        "1,2,3,x",
        "NaN,0,0,1",
        "inf,0,0,1",
        "0,0,0,0",
        "0,-0,0,0",
        "1,,2,3",
    ] {
        assert_eq!(read(kind, wrong), None, "{wrong}");
    }
    let kind = Kind::Plane {
        default: [0.0, 1.0, 0.0, 0.0],
    };
    assert!(matches!(read(kind, "0,1,0,-5"), Some(Value::Plane(plane)) if plane.d == -5.0));
    assert_eq!(read(kind, "0,0,0,1"), None);
    let kind = Kind::Choice {
        default: "even-odd",
        of: &["even-odd", "non-zero"],
    };
    assert_eq!(read(kind, "Non-Zero"), Some(Value::Choice("non-zero")));
    assert_eq!(read(kind, "zero"), None);
}

#[test]
fn what_is_typed_is_read_back_and_the_default_is_no_change() {
    const A: Ask<DVec2> = Ask::point("a", "*A*", WORD, [2.0, 14.0], [[-20.0; 2], [20.0; 2]]);
    const SIDE: Ask<f64> = Ask::number("side", "", WORD, 3.0, [0.0, 9.0]);
    let inputs = Inputs::default();
    assert_eq!(inputs.get(&A), DVec2::new(2.0, 14.0));
    assert!(inputs.is_default() && !inputs.has(&A) && inputs.typed().is_empty());
    let same = inputs.clone().with(&A.input, "2,14").unwrap();
    assert_eq!(same, inputs);
    let moved = inputs.with(&A.input, "0.25,-3").unwrap();
    let moved = moved.with(&SIDE.input, "4").unwrap();
    assert_eq!(moved.get(&A), DVec2::new(0.25, -3.0));
    assert_eq!(moved.typed(), "a=0.25,-3 side=4");
    // What has no symbol is not said.
    let said = moved.said(&[A.input, SIDE.input]).unwrap();
    assert_eq!(said, format!("*A* = ({}, {}).", inline(0.25), inline(-3.0)));
    assert!(
        moved
            .clone()
            .with(&A.input, "2,14")
            .unwrap()
            .with(&SIDE.input, "3")
            .unwrap()
            .is_default()
    );
}
