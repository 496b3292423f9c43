//! Shadow polygons against brute force: no point of the caster is missing from its shadow, and no point of the
//! shadow sees the light.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4, dvec3, dvec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::vector::{dot, exact};
use ombra_shadows::planar::{cast, cast_onto, cast_polygon};
use ombra_tests::cases::Random;
use ombra_tests::region::{Location, Point, blocked, combine, edge_on, locate};
use ombra_tests::shadow::{Decision, ExactShadow};

/// A convex caster, a plane and a light.
#[derive(Clone, Debug)]
struct PlaneLightCaster {
    plane: Plane,
    light: DVec4,
    caster: Vec<DVec3>,
}

/// A scene of whole numbers, at times moved next to a degenerate position or made huge or tiny.
fn scene(random: &mut Random) -> PlaneLightCaster {
    let mut whole = |size: u32| f64::from(random.below(2 * size + 1)) - f64::from(size);
    let plane = Plane {
        normal: dvec3(whole(5), whole(5), whole(5)),
        d: whole(20),
    };
    let mut light = dvec4(whole(20), whole(20), whole(20), 1.0);
    let mut caster = convex(random);
    match random.below(5) {
        0 | 1 => light.w = 0.0,
        2 => light = -light,
        3 => light.w = 2.0,
        _ => {}
    }
    // One corner nearly level with the light, or nearly on the plane: not exactly flat any more for four corners.
    if random.below(3) == 0 && caster.len() == 3 && plane.normal.y != 0.0 {
        let n = plane.normal;
        let goal = if light.w != 0.0 && random.below(2) == 0 {
            n.dot(light.truncate() / light.w)
        } else {
            -plane.d
        };
        let v = caster[0];
        let off = random.exponential(-45, -35);
        caster[0].y = (goal - n.x * v.x - n.z * v.z) / n.y * (1.0 + off);
    }
    let size = match random.below(4) {
        0 => random.power_of_two(-980, 980),
        _ => 1.0,
    };
    PlaneLightCaster {
        plane: Plane {
            normal: plane.normal,
            d: plane.d * size,
        },
        light: (light.truncate() * size).extend(light.w),
        caster: caster.iter().map(|&v| v * size).collect(),
    }
}

/// A triangle or a parallelogram of whole numbers, or a hexagon of them, all exactly flat.
fn convex(random: &mut Random) -> Vec<DVec3> {
    let mut point = || dvec3(0.0, 0.0, 0.0).map(|_| f64::from(random.below(41)) - 20.0);
    let (a, u, v) = (point(), point(), point());
    match random.below(3) {
        0 => vec![a, a + u, a + v],
        1 => vec![a, a + u, a + u + v, a + v],
        _ => vec![a + u, a + u + v, a + v, a - u, a - u - v, a - v],
    }
}

fn corners(polygon: &[DVec3]) -> Vec<Point> {
    polygon
        .iter()
        .map(|v| exact(v.extend(1.0)).unwrap())
        .collect()
}

/// Whole weights from `low` to `high` for n points, and their sum brought to 64 by one of them: positive for up to
/// twelve points and weights from 1 to 5.
fn weights(random: &mut Random, n: usize, [low, high]: [i32; 2]) -> Vec<i32> {
    let span = (high - low + 1).unsigned_abs();
    let mut weights: Vec<i32> = (0..n).map(|_| low + random.below(span) as i32).collect();
    let rest = 64 - weights.iter().sum::<i32>();
    weights[random.below(n as u32) as usize] += rest;
    weights
}

/// What a shadow polygon must and must not hold, sampled. `cast_under_test` is put to it, so that wrong ones can
/// be as well; the answer is the first flaw.
fn flaw(
    random: &mut Random,
    scene: &PlaneLightCaster,
    seen: &mut [usize; 3],
    cast_under_test: impl Fn(Plane, DVec4, &[DVec3]) -> Vec<DVec4>,
) -> Option<String> {
    let PlaneLightCaster {
        plane,
        light,
        caster,
    } = scene;
    if plane.normal == DVec3::ZERO || edge_on(caster, *light) {
        return None;
    }
    let shadow = cast_under_test(*plane, *light, caster);
    let Some(shadow) = shadow
        .into_iter()
        .map(exact)
        .collect::<Option<Vec<Point>>>()
    else {
        return Some("a corner that is not finite".into());
    };
    let at_caster = corners(caster);
    for _ in 0..12 {
        // A point of the caster, and its exact shadow.
        let x = combine(&at_caster, &weights(random, caster.len(), [1, 5]));
        let [x, y, z, _] = x.map(|c| c.scaled(-6));
        let exact_shadow = shadow_of(*plane, *light, [x, y, z])?;
        if exact_shadow.decision() == Decision::Casts {
            let place = place(&exact_shadow);
            match locate(&shadow, plane.normal, &place) {
                Location::Outside => {
                    return Some(format!("a point of the caster is missing from {shadow:?}"));
                }
                Location::Inside => seen[0] += 1,
                Location::Border => seen[2] += 1,
            }
        }
    }
    for _ in 0..12 {
        if shadow.len() < 3 {
            break;
        }
        // A point of the shadow, and what is between it and the light.
        let p = combine(&shadow, &weights(random, shadow.len(), [1, 5]));
        if p[3].sign() != Ordering::Greater {
            continue;
        }
        match blocked(&p, *light, caster)? {
            Location::Outside => {
                return Some(format!("a point of the shadow sees the light: {p:?}"));
            }
            Location::Inside => seen[1] += 1,
            Location::Border => seen[2] += 1,
        }
    }
    None
}

fn shadow_of(plane: Plane, light: DVec4, v: [Exact; 3]) -> Option<ExactShadow> {
    ExactShadow::from_exact(
        exact(plane.normal)?,
        Exact::new(plane.d)?,
        exact(light.truncate())?,
        Exact::new(light.w)?,
        v,
    )
}

/// The exact shadow as a homogeneous point with w > 0.
fn place(shadow: &ExactShadow) -> Point {
    let [x, y, z] = [0, 1, 2].map(|j| shadow.fraction(j).0.clone());
    let w = shadow.fraction(0).1.clone();
    let p = [x, y, z, w];
    if p[3].sign() == Ordering::Less {
        p.map(|x| -&x)
    } else {
        p
    }
}

#[test]
fn no_shadow_is_false_and_none_is_missing() {
    let mut random = Random::new(31);
    let mut seen = [0; 3];
    for _ in 0..3000 {
        let scene = scene(&mut random);
        let flaw = flaw(&mut random, &scene, &mut seen, cast_polygon);
        assert_eq!(flaw, None, "{scene:?}");
    }
    let [in_shadow, blocked, border] = seen;
    assert!(
        in_shadow > 5000 && blocked > 5000 && border * 20 < in_shadow + blocked,
        "{seen:?}"
    );
}

/// The check itself, put to polygons that are wrong in one way each.
#[test]
fn wrong_polygons_are_caught() {
    type OnPlane = dyn Fn(Plane, DVec4, &[DVec3]) -> Vec<DVec4>;
    let caught = |words: &str, wrong: &OnPlane| {
        let mut random = Random::new(32);
        let found = (0..500).find_map(|_| {
            let scene = scene(&mut random);
            flaw(&mut random, &scene, &mut [0; 3], wrong)
        });
        assert!(found.is_some_and(|flaw| flaw.contains(words)), "{words}");
    };
    // Every corner through the matrix, none clipped: the slides' way.
    caught("sees the light", &|plane, light, polygon| {
        let m = ombra_shadows::planar::shadow_matrix(plane, light);
        m.map_or(Vec::new(), |m| {
            let project = |v: &DVec3| ombra_math::homogeneous::project(m * v.extend(1.0));
            polygon
                .iter()
                .filter_map(project)
                .map(|p| p.extend(1.0))
                .collect()
        })
    });
    // Corners without a shadow left out instead of cut off.
    caught("missing", &|plane, light, polygon| {
        let corners = polygon.iter().filter_map(|&v| cast(plane, light, v));
        corners.map(|p| p.extend(1.0)).collect()
    });
    // No shadow at all.
    caught("missing", &|_, _, _| Vec::new());
    // Infinity forgotten: directions taken for places.
    caught("", &|plane, light, polygon| {
        let shadow = cast_polygon(plane, light, polygon);
        shadow.iter().map(|p| p.truncate().extend(1.0)).collect()
    });
}

/// Where an edge of the caster enters the plane, the shadow begins in that very point: within 4 ε of the larger
/// coordinate of the edge's ends, however small the angle.
#[test]
fn shadows_begin_where_casters_enter_the_plane() {
    let mut random = Random::new(34);
    let mut entered = 0;
    for round in 0..4000 {
        let plane = Plane {
            normal: random.direction(),
            d: random.between(-1.0, 1.0),
        };
        let light = plane.normal.extend(0.0);
        let mut caster: Vec<DVec3> = (0..3).map(|_| random.direction() * 8.0).collect();
        if round % 2 == 0 {
            // Two corners close to the plane, so that the edge between them is nearly along it.
            for v in &mut caster[..2] {
                let height = plane.normal.dot(*v) + plane.d + random.exponential(-50, -20);
                *v -= plane.normal * (height / plane.normal.length_squared());
            }
        }
        let shadow = cast_polygon(plane, light, &caster);
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (caster[a], caster[b]);
            let [at_a, at_b] = [a, b].map(|v| height_above(plane, v));
            if at_a.sign() == Ordering::Equal || at_a.sign() != at_b.sign().reverse() {
                continue;
            }
            entered += 1;
            let larger = a.abs().max(b.abs()).max_element();
            let bound = Exact::new(4.0 * f64::EPSILON * larger).unwrap();
            let across = &at_a - &at_b;
            // C = (t_a b − t_b a) / (t_a − t_b), compared without the division.
            let is_there = |p: &DVec4| {
                (0..3).all(|k| {
                    let [a, b, p] = exact([a[k], b[k], p[k]]).unwrap();
                    let off = p * &across - (&at_a * b - &at_b * a);
                    off.abs() <= &bound * across.abs()
                })
            };
            assert!(
                shadow.iter().any(is_there),
                "{plane:?} {caster:?}: {a} to {b} in {shadow:?}"
            );
        }
    }
    assert!(entered > 2000, "{entered}");
}

/// t = n·V + d without rounding.
fn height_above(plane: Plane, v: DVec3) -> Exact {
    let [pi, v] = [plane.coefficients(), v.extend(1.0)].map(|v| exact(v).unwrap());
    dot(&pi, &v)
}

/// What falls on a receiver is what is inside it and blocked: sampled inside and around it.
fn flaw_on_receiver(
    random: &mut Random,
    light: DVec4,
    caster: &[DVec3],
    receiver: &[DVec3],
    seen: &mut [usize; 2],
    cast_under_test: impl Fn(&[DVec3], DVec4, &[DVec3]) -> Vec<DVec3>,
) -> Option<String> {
    let on_receiver = corners(&cast_under_test(receiver, light, caster));
    let at_receiver = corners(receiver);
    let [a, b, c, ..] = receiver else { return None };
    let normal = (b - a).cross(c - a);
    for _ in 0..24 {
        let p = combine(&at_receiver, &weights(random, receiver.len(), [-4, 7]));
        let inside = locate(&at_receiver, normal, &p);
        let in_shadow = blocked(&p, light, caster)?;
        let found = locate(&on_receiver, normal, &p);
        let expected = match (inside, in_shadow) {
            (Location::Inside, Location::Inside) => Location::Inside,
            (Location::Outside, _) | (_, Location::Outside) => Location::Outside,
            _ => continue,
        };
        match (expected, found) {
            (Location::Inside, Location::Outside) => {
                return Some("a shadowed point is missing".into());
            }
            (Location::Outside, Location::Inside) => {
                return Some("a lit or outer point is in".into());
            }
            (Location::Inside, _) => seen[0] += 1,
            _ => seen[1] += 1,
        }
    }
    // Points of the answer itself: none may be outside the receiver or see the light.
    for _ in 0..6 {
        if on_receiver.len() < 3 {
            break;
        }
        let p = combine(&on_receiver, &weights(random, on_receiver.len(), [1, 5]));
        if locate(&on_receiver, normal, &p) != Location::Inside {
            continue;
        }
        let outside = locate(&at_receiver, normal, &p) == Location::Outside;
        if outside || blocked(&p, light, caster)? == Location::Outside {
            return Some("a lit or outer point is in".into());
        }
        seen[0] += 1;
    }
    None
}

/// A light, a caster, and a receiver across the caster's way, so that something falls on it more often than by
/// chance: as large as the caster and up to twice as far from the light.
fn receiving(random: &mut Random) -> (DVec4, Vec<DVec3>, Vec<DVec3>) {
    let PlaneLightCaster { light, caster, .. } = scene(random);
    let mut receiver = convex(random);
    let size = caster.iter().fold(0.0_f64, |size, v| {
        size.max((*v - caster[0]).abs().max_element())
    });
    let scale =
        Exact::power_of_two(i64::from((size.to_bits() >> 52) as i32 - 1023)).nearest() / 16.0;
    let from = caster.iter().sum::<DVec3>() / caster.len() as f64;
    let away = if light.w == 0.0 {
        -light.truncate()
    } else {
        from - light.truncate() / light.w
    };
    let away = away * (size / away.abs().max_element().max(f64::MIN_POSITIVE));
    // Moved by few bits, so that the receiver stays exactly flat.
    let centre = receiver.iter().sum::<DVec3>() / receiver.len() as f64;
    let shift = ((from + away * random.between(0.25, 1.5)) / scale - centre).round();
    for v in &mut receiver {
        *v = (*v + shift) * scale;
    }
    (light, caster, receiver)
}

#[test]
fn what_falls_on_a_receiver() {
    let mut random = Random::new(33);
    let mut seen = [0; 2];
    for _ in 0..3000 {
        let (light, caster, receiver) = receiving(&mut random);
        if edge_on(&caster, light) || edge_on(&receiver, light) {
            continue;
        }
        let flaw = flaw_on_receiver(&mut random, light, &caster, &receiver, &mut seen, cast_onto);
        assert_eq!(
            flaw, None,
            "light {light:?}\ncaster {caster:?}\nreceiver {receiver:?}"
        );
    }
    assert!(seen.iter().all(|&n| n > 5000), "{seen:?}");
}

#[test]
fn wrong_receivers_are_caught() {
    type OnReceiver = dyn Fn(&[DVec3], DVec4, &[DVec3]) -> Vec<DVec3>;
    let caught = |words: &str, wrong: &OnReceiver| {
        let mut random = Random::new(33);
        let found = (0..500).find_map(|_| {
            let (light, caster, receiver) = receiving(&mut random);
            if edge_on(&caster, light) || edge_on(&receiver, light) {
                return None;
            }
            flaw_on_receiver(&mut random, light, &caster, &receiver, &mut [0; 2], wrong)
        });
        assert_eq!(found.as_deref(), Some(words));
    };
    // The whole receiver, nothing, and the shadow without its receiver.
    caught("a lit or outer point is in", &|receiver, _, _| {
        receiver.to_vec()
    });
    caught("a shadowed point is missing", &|_, _, _| Vec::new());
    caught("a lit or outer point is in", &|receiver, light, caster| {
        let plane = Plane::of_triangle(receiver[0], receiver[1], receiver[2]).unwrap();
        let shadow = cast_polygon(plane, light, caster);
        shadow
            .iter()
            .filter_map(|&p| ombra_math::homogeneous::project(p))
            .collect()
    });
}
