use super::*;
use crate::step::WIDEST;
use ombra_oracle::Exact;
use ombra_oracle::vector::{exact, turn};
use proptest::num::f64::ANY;
use proptest::prelude::*;

type Contours = Vec<Vec<DVec2>>;

/// A point whose coordinates are multiples of 2⁻⁶⁰.
fn on_the_grid(p: DVec2) -> [Exact; 2] {
    let p = exact(p).unwrap();
    assert!(p.iter().all(|x| x.truncated(60) == *x));
    p
}

/// The winding number of a centre, really shifted: by 2⁻⁴⁰⁰ to the right and 2⁻⁸⁰⁰ down. For coordinates that are
/// multiples of 2⁻⁶⁰ below 2⁸⁰ no edge passes between the centre and there, so nothing here can be a tie.
fn winding_oracle(contours: &[Vec<[Exact; 2]>], column: u32, row: u32) -> i64 {
    let [x, y] = exact([column, row].map(|k| f64::from(k) + 0.5)).unwrap();
    let centre = [x + Exact::power_of_two(-400), y + Exact::power_of_two(-800)];
    let y = &centre[1];
    let mut winding = 0;
    for vertices in contours {
        for (i, a) in vertices.iter().enumerate() {
            let b = &vertices[(i + 1) % vertices.len()];
            assert!(a[1] != *y && b[1] != *y);
            if (a[1] < *y) == (b[1] < *y) {
                continue;
            }
            let side = turn(a, b, &centre);
            assert!(side != 0);
            let down = b[1] > a[1];
            if (side < 0) == down {
                winding += if down { 1 } else { -1 };
            }
        }
    }
    winding
}

fn oracle(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<String> {
    let contours: Vec<Vec<_>> = contours
        .iter()
        .map(|contour| contour.iter().map(|&v| on_the_grid(v)).collect())
        .collect();
    let cell = |x, y| match rule {
        FillRule::EvenOdd => winding_oracle(&contours, x, y) % 2 != 0,
        FillRule::NonZero => winding_oracle(&contours, x, y) != 0,
    };
    let row = |y| {
        (0..width)
            .map(|x| if cell(x, y) { '#' } else { '.' })
            .collect()
    };
    (0..height).map(row).collect()
}

/// A coordinate about a picture of 8 pixels, a multiple of 2⁻⁶⁰ below 2⁸⁰: on centres, within 10⁻¹² of them, between
/// them, and far away.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-2i32..11).prop_map(|k| f64::from(k) + 0.5),
        3 => (-2i32..11, -4i32..5).prop_map(|(k, m)| f64::from(k) + 0.5 + f64::from(m) * libm::scalbn(1.0, -43)),
        2 => (-8i32..44).prop_map(|k| f64::from(k) / 4.0),
        2 => (-3.0..11.0f64).prop_map(|x| (x * libm::scalbn(1.0, 45)).floor() * libm::scalbn(1.0, -45)),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e9),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * libm::scalbn(1.0, 70)),
    ]
}

/// About a side of so many pixels, and as far beyond it at either end.
fn about(pixels: i32) -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-pixels..2 * pixels).prop_map(|k| f64::from(k) + 0.5),
        1 => (-4 * pixels..8 * pixels).prop_map(|k| f64::from(k) / 4.0),
        1 => f64::from(-pixels)..f64::from(2 * pixels),
    ]
}

fn contours(vertices: Range<usize>) -> impl Strategy<Value = Contours> {
    let vertex = [coordinate(), coordinate()].prop_map(DVec2::from_array);
    prop::collection::vec(prop::collection::vec(vertex, vertices), 0..3)
}

/// Any finite double, or one at a scale where slopes through the picture occur.
fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => ANY.prop_filter("finite", |x| x.is_finite()),
        2 => coordinate(),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e300),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e-300),
        1 => (-9i32..10, 1u64..1 << 40).prop_map(|(k, m)| f64::from(k) * libm::scalbn(1.0, 33) + m as f64),
    ]
}

fn any_contours(vertices: Range<usize>) -> impl Strategy<Value = Contours> {
    let vertex = [finite(), finite()].prop_map(DVec2::from_array);
    prop::collection::vec(prop::collection::vec(vertex, vertices), 0..3)
}

/// Spans in order, not empty, in the picture, and none touching the next.
fn are_in_form(spans: &[Span], width: u32, height: u32) -> bool {
    let each = spans
        .iter()
        .all(|span| !span.is_empty() && span.x.end <= width && span.y < height);
    each && spans
        .windows(2)
        .all(|pair| (pair[0].y, pair[0].x.end) < (pair[1].y, pair[1].x.start))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn agrees_with_a_real_shift(contours in contours(0..9)) {
        for rule in RULES {
            let found = grid(&contours, rule, 8, 8);
            prop_assert_eq!(found, oracle(&contours, rule, 8, 8), "{:?}", rule);
        }
    }

    #[test]
    fn forms_agree_at_every_scale(contours in any_contours(0..9), width in 0..20u32, height in 0..20u32) {
        for rule in RULES {
            let fast = spans(&contours, rule, width, height);
            let plain = plain(&contours, rule, width, height);
            prop_assert!(are_in_form(&fast, width, height));
            prop_assert_eq!(fast, plain);
        }
    }

    /// Right of the first centre and inside the picture both forms do the same work, but for what is exact.
    #[test]
    fn the_work_is_that_of_the_plain_form(contours in prop::collection::vec(prop::collection::vec(prop::array::uniform2(3..38i32), 0..9), 0..3)) {
        let vertex = |[x, y]: [i32; 2]| DVec2::new(f64::from(x), f64::from(y)) / 4.0;
        let contours: Contours = contours.into_iter().map(|c| c.into_iter().map(vertex).collect()).collect();
        for rule in RULES {
            let (mut fast, mut plain) = (Work::default(), Work::default());
            counted::fill(&contours, rule, 10, 10, &mut fast).unwrap().for_each(drop);
            fill_plain(&contours, rule, 10, 10, &mut plain, drop).unwrap();
            fast.exact_fallbacks = 0;
            prop_assert_eq!(fast, plain);
        }
    }

    /// The crossing is the double nearest to it: neither neighbour is nearer.
    #[test]
    fn a_crossing_is_the_nearest_double(a in [finite(), finite()], b in [finite(), finite()], row in 0..9u32) {
        prop_assume!(a[1] != b[1]);
        let [ax, ay, bx, by, y] = [a[0], a[1], b[0], b[1], f64::from(row) + 0.5].map(|x| Exact::new(x).unwrap());
        let exact = (&ax * (&by - &y) + &bx * (&y - &ay)).over(&(&by - &ay)).unwrap();
        let (top, bottom) = (DVec2::from_array(a), DVec2::from_array(b));
        let x = Edge { top, bottom, winding: 1, rows: 0..9 }.x(row);
        let distance = |x: f64| Some((Exact::new(x)? - &exact).abs());
        if let Some(found) = distance(x) {
            for neighbour in [x.next_down(), x.next_up()].into_iter().filter_map(distance) {
                prop_assert!(found <= neighbour);
            }
        } else {
            let beyond = if x > 0.0 { exact > f64::MAX } else { exact < -f64::MAX };
            prop_assert!(beyond);
        }
    }

    /// Neither the vertex a contour begins with, nor the order of contours, nor all directions turned count.
    #[test]
    fn only_the_contours_count(contours in contours(1..9), turn in 0..9usize) {
        let mut other = contours.clone();
        other.reverse();
        for contour in &mut other {
            let turn = turn % contour.len();
            contour.rotate_left(turn);
            contour.reverse();
        }
        for rule in RULES {
            prop_assert_eq!(spans(&contours, rule, 8, 8), spans(&other, rule, 8, 8));
        }
    }

    /// A picture further right and down is the same, moved: the corner of the largest picture.
    #[test]
    fn moves_with_the_picture(vertices in prop::collection::vec([0..40i32, 0..40], 3..8)) {
        let at = |offset: f64| -> Contours {
            vec![vertices.iter().map(|&[x, y]| DVec2::new(f64::from(x), f64::from(y)) / 4.0 + offset).collect()]
        };
        const FAR: u32 = u32::MAX - 10;
        for rule in RULES {
            let near = spans(&at(0.0), rule, 10, 10);
            let far = spans(&at(f64::from(FAR)), rule, u32::MAX, u32::MAX);
            let moved: Vec<_> = far
                .iter()
                .map(|span| Span { y: span.y - FAR, x: span.x.start - FAR..span.x.end - FAR })
                .collect();
            prop_assert_eq!(near, moved);
        }
    }

    /// Records that nobody checked: their fields are public.
    #[test]
    fn any_records_are_taken(ends in prop::collection::vec([ANY, ANY, ANY, ANY], 0..90), winding: i32, y: u32, width: u32) {
        let table: Vec<_> = ends
            .into_iter()
            .map(|[a, b, c, d]| Edge { top: DVec2::new(a, b), bottom: DVec2::new(c, d), winding, rows: 0..u32::MAX })
            .collect();
        let crossings = active_edges(&table, y, width);
        prop_assert_eq!(crossings.len(), if y < u32::MAX { table.len() } else { 0 });
        prop_assert!(crossings.iter().all(|crossing| crossing.column <= width));
        for rule in RULES {
            let spans = spans_between(&crossings, rule, width);
            prop_assert!(spans.iter().all(|span| span.start < span.end && span.end <= width));
        }
    }

    #[test]
    fn never_panics(vertices in prop::collection::vec([ANY, ANY], 0..12), width in any::<u32>(), height in 0..3000u32) {
        let contours = [vertices.into_iter().map(DVec2::from_array).collect::<Vec<_>>()];
        for rule in RULES {
            match fill(&contours, rule, width, height) {
                Ok(spans) => {
                    let spans: Vec<_> = spans.take(20).collect();
                    prop_assert!(are_in_form(&spans, width, height));
                }
                Err(PolygonError::NotFinite { contour, vertex, .. }) => {
                    prop_assert!(!contours[contour][vertex].is_finite());
                    prop_assert!(contours[contour][..vertex].iter().all(|v| v.is_finite()));
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// So many edges that they are stepped side by side, in pictures where columns out of order are marked, sorted or either;
    /// in the widest, few at a time.
    #[test]
    fn forms_agree_with_many_edges(contours in any_contours(20..60), scale in prop_oneof![Just(1.0), Just(9.7)],
                                   width in prop::sample::select(vec![83, 3000, WIDEST, WIDEST + 1])) {
        let contours: Contours = contours.iter().map(|c| c.iter().map(|&v| v * scale).collect()).collect();
        prop_assume!(contours.iter().flatten().all(|v| v.is_finite()));
        for rule in RULES {
            let fast = spans(&contours, rule, width, 90);
            let plain = plain(&contours, rule, width, 90);
            prop_assert!(are_in_form(&fast, width, 90));
            prop_assert_eq!(fast, plain);
        }
    }

    /// The same about the picture: most vertices on centres, so that edges meet centres, and many beyond its sides. So many
    /// rows that edges out of order are sorted again.
    #[test]
    fn forms_agree_in_many_rows(vertices in prop::collection::vec([about(83), about(200)], 16..60)) {
        let contours = [vertices.into_iter().map(DVec2::from_array).collect::<Vec<_>>()];
        for rule in RULES {
            let fast = spans(&contours, rule, 83, 200);
            let plain = plain(&contours, rule, 83, 200);
            prop_assert!(are_in_form(&fast, 83, 200));
            prop_assert_eq!(fast, plain);
        }
    }

    /// Teeth round a point, whose edges never cross: a pair begins or ends every few rows, and all others keep their places.
    #[test]
    fn forms_agree_on_stars(teeth in 8..60u32, radii in prop::array::uniform2(5.0..110.0f64), turn in 0.0..1.0f64) {
        let star: Vec<_> = (0..2 * teeth).zip(radii.into_iter().cycle()).map(|(i, radius)| {
            let angle = std::f64::consts::TAU * (f64::from(i) + turn) / f64::from(2 * teeth);
            let (sin, cos) = libm::sincos(angle);
            DVec2::new(100.0 + radius * cos, 100.0 + radius * sin)
        }).collect();
        for rule in RULES {
            let fast = spans(std::slice::from_ref(&star), rule, 180, 200);
            let plain = plain(std::slice::from_ref(&star), rule, 180, 200);
            prop_assert!(are_in_form(&fast, 180, 200));
            prop_assert_eq!(fast, plain);
        }
    }

    /// Edges that pass a column of centres at a distance that fixed point cannot tell, on either side or across.
    #[test]
    fn forms_agree_along_a_column(vertices in prop::collection::vec((-200i32..201, -20.0..110.0f64), 24..60)) {
        let vertex = |(m, y)| DVec2::new(40.5 + f64::from(m) * libm::scalbn(1.0, -26), y);
        let contours = [vertices.into_iter().map(vertex).collect::<Vec<_>>()];
        for rule in RULES {
            let fast = spans(&contours, rule, 83, 90);
            let plain = plain(&contours, rule, 83, 90);
            prop_assert_eq!(fast, plain);
        }
    }
}
