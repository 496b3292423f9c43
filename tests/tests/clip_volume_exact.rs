//! Clipping in space against exact numbers: segments in a box and in the view volume, polygons with attributes in the
//! view volume, over the whole range of exponents, a third of the cases within 10⁻¹² of a degenerate one.

use std::collections::BTreeSet;

use ombra_clip::box3::{self, Box3};
use ombra_clip::homogeneous::{
    Vertex, ViewPlane, clip_polygon, clip_polygon_to, clip_segment, contains,
};
use ombra_math::glam::{DVec3, DVec4};
use ombra_tests::cases::Random;
use ombra_tests::clipping::{VIEW_SIDES, ViewSide, in_box, in_view_volume, polygon_in_view_volume};

/// `x`, or within 10⁻¹² of it: often by an ulp or two.
fn near(random: &mut Random, x: f64) -> f64 {
    match random.below(6) {
        0 | 1 => x,
        2 => x.next_up(),
        3 => x.next_down(),
        _ => x + x * random.exponential(-52, -41),
    }
}

fn finite<const N: usize>(x: [f64; N]) -> [f64; N] {
    x.map(|x| x.clamp(-f64::MAX, f64::MAX))
}

/// Of one size, anywhere in the range; now and then one number is of any other size, or 0.
fn in_scale<const N: usize>(random: &mut Random, scale: f64) -> [f64; N] {
    // Small whole numbers meet sides, edges and corners exactly.
    let whole = random.below(4) == 0;
    let mut x: [f64; N] = core::array::from_fn(|_| {
        let x = random.between(-2.0, 2.0);
        scale * if whole { (2.0 * x).round() / 2.0 } else { x }
    });
    match random.below(6) {
        0 => x[random.below(N as u32) as usize] = random.exponential(-1074, 1022),
        1 => x[random.below(N as u32) as usize] = 0.0,
        _ => {}
    }
    finite(x)
}

/// One size in three near either end of the range.
fn scale(random: &mut Random) -> f64 {
    match random.below(6) {
        0 => random.power_of_two(1000, 1022),
        1 => random.power_of_two(-1074, -1000),
        _ => random.power_of_two(-1000, 1000),
    }
}

/// A homogeneous point of that size.
fn position(random: &mut Random, scale: f64) -> DVec4 {
    let mut p: [f64; 4] = in_scale(random, scale);
    // In front of the eye, two times in three.
    if random.below(3) > 0 {
        p[3] = p[3].abs();
    }
    if random.below(3) == 0 {
        // On a plane, or next to it.
        let sign = [1.0, -1.0][random.below(2) as usize];
        p[random.below(3) as usize] = sign * near(random, p[3]);
    }
    DVec4::from(finite(p))
}

/// The other end: anywhere, or so that the segment passes through a corner, an edge or a face of the volume, or through
/// (0, 0, 0, 0), or next to that.
fn other_end(random: &mut Random, scale: f64, a: DVec4) -> DVec4 {
    let through = match random.below(9) {
        0 => DVec4::ZERO,
        1 | 2 => {
            let side = |random: &mut Random| {
                if random.below(3) == 0 {
                    random.between(-1.0, 1.0)
                } else {
                    [1.0, -1.0][random.below(2) as usize]
                }
            };
            let [x, y, z] = core::array::from_fn(|_| side(random));
            DVec4::new(x, y, z, 1.0) * scale * random.between(0.5, 1.0)
        }
        _ => return position(random, scale),
    };
    // a at 1 − t and b at t give the point that it is to pass: t = ½.
    let b = (through - a * 0.5) * 2.0;
    let b = DVec4::from(finite(b.to_array().map(|x| near(random, x))));
    if b.is_finite() { b } else { -a }
}

#[test]
fn homogeneous_segments() {
    let mut random = Random::new(61);
    let (mut left, mut cut, mut single) = (0, 0, 0);
    for _ in 0..20_000 {
        let size = scale(&mut random);
        let a = position(&mut random, size);
        let b = other_end(&mut random, size, a);
        let clipped = clip_segment([a, b]);
        assert_eq!(clipped, in_view_volume([a, b]), "{a:?} {b:?}");
        let Some([c, d]) = clipped else { continue };
        assert!(contains(c) && contains(d), "{a:?} {b:?}: {c:?} {d:?}");
        assert!(!contains(a) || c == a || a == DVec4::ZERO);
        assert!(!contains(b) || d == b || b == DVec4::ZERO);
        assert_eq!(clip_segment([c, d]), Some([c, d]), "{a:?} {b:?}");
        assert_eq!(clip_segment([b, a]), Some([d, c]), "{a:?} {b:?}");
        left += 1;
        cut += usize::from(c != a) + usize::from(d != b);
        single += usize::from(c == d);
    }
    assert!(
        left > 5_000 && cut > 5_000 && single > 150,
        "{left} {cut} {single}"
    );
}

fn plane_of((axis, sign): ViewSide) -> ViewPlane {
    match (axis, sign > 0.0) {
        (0, true) => ViewPlane::Left,
        (0, false) => ViewPlane::Right,
        (1, true) => ViewPlane::Below,
        (1, false) => ViewPlane::Above,
        (2, true) => ViewPlane::Near,
        _ => ViewPlane::Far,
    }
}

fn numbers(polygon: &[Vertex<2>]) -> Vec<[f64; 6]> {
    let all = |v: &Vertex<2>| {
        let [p, q] = v.attributes;
        let [x, y, z, w] = v.position.to_array();
        [x, y, z, w, p, q]
    };
    polygon.iter().map(all).collect()
}

#[test]
fn homogeneous_polygons() {
    let mut random = Random::new(62);
    let (mut left, mut corners, mut whole) = (0, 0, 0);
    for _ in 0..8_000 {
        let size = scale(&mut random);
        let mut polygon: Vec<Vertex<2>> = Vec::new();
        for _ in 0..3 + random.below(3) {
            let position = match polygon.last() {
                Some(last) => other_end(&mut random, size, last.position),
                None => position(&mut random, size),
            };
            let attributes = match random.below(3) {
                0 => [random.exponential(-1074, 1022), random.between(0.0, 1.0)],
                1 => [random.between(-1.0, 1.0), 0.0],
                _ => [random.between(0.0, 255.0), random.between(-8.0, 8.0)],
            };
            polygon.push(Vertex {
                position,
                attributes,
            });
        }
        if polygon.iter().any(|v| v.position == DVec4::ZERO) {
            assert_eq!(clip_polygon(&polygon), []);
            continue;
        }
        // Any sides in any order, now and then one twice.
        let sides: Vec<ViewSide> = (0..random.below(8))
            .map(|_| VIEW_SIDES[random.below(6) as usize])
            .collect();
        let planes: Vec<ViewPlane> = sides.iter().map(|&side| plane_of(side)).collect();
        let expected = polygon_in_view_volume(&numbers(&polygon), &sides).unwrap();
        assert_eq!(
            numbers(&clip_polygon_to(&polygon, &planes)),
            expected,
            "{planes:?} {polygon:?}"
        );

        let all = [4, 5, 0, 1, 2, 3].map(|i: usize| VIEW_SIDES[i]);
        let expected = polygon_in_view_volume(&numbers(&polygon), &all).unwrap();
        let clipped = clip_polygon(&polygon);
        assert_eq!(numbers(&clipped), expected, "{polygon:?}");
        assert!(clipped.iter().all(|v| contains(v.position)), "{polygon:?}");
        assert_eq!(clip_polygon(&clipped), clipped, "{polygon:?}");
        left += usize::from(!clipped.is_empty());
        corners += clipped.len();
        whole += usize::from(clipped == polygon);
    }
    assert!(
        left > 1_500 && corners > 5 * left / 2 && whole < left / 2,
        "{left} {corners} {whole}"
    );
}

/// Attributes that say of which mixture of the given corners a point is: every corner that comes out is that mixture.
///
/// Six planes cut one after another; each crossing rounds every number once, by ½ ε of the largest that goes in, 1 for
/// shares and L for coordinates, and mixes what earlier ones have left: 6 · ½ ε · L for the position itself, and as much
/// from each of the three shares.
#[test]
fn attributes_are_the_mixture_of_the_corners() {
    let mut random = Random::new(63);
    let (mut left, mut largest) = (0, 0.0_f64);
    for _ in 0..20_000 {
        let positions: [DVec4; 3] = core::array::from_fn(|_| {
            DVec4::new(
                random.between(-3.0, 3.0),
                random.between(-3.0, 3.0),
                random.between(-3.0, 3.0),
                random.between(-1.0, 3.0),
            )
        });
        let shares = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangle: [Vertex<3>; 3] = core::array::from_fn(|k| Vertex {
            position: positions[k],
            attributes: shares[k],
        });
        let clipped = clip_polygon(&triangle);
        left += usize::from(!clipped.is_empty());
        for v in clipped {
            let [p, q, r] = v.attributes;
            let sum = p + q + r;
            assert!(
                (sum - 1.0).abs() <= 4.0 * 6.0 * 0.5 * f64::EPSILON,
                "{triangle:?}: {v:?}"
            );
            let mixture = positions[0] * p + positions[1] * q + positions[2] * r;
            let off = (mixture - v.position).abs().max_element();
            // And three products and two sums here.
            assert!(
                off <= (4.0 * 6.0 * 0.5 + 5.0) * f64::EPSILON * 3.0,
                "{triangle:?}: {v:?}"
            );
            largest = largest.max(off);
        }
    }
    // Rounding is there to be seen.
    assert!(
        left > 5_000 && largest > 0.5 * f64::EPSILON,
        "{left} {largest:e}"
    );
}

#[test]
fn segments_in_a_box() {
    let mut random = Random::new(64);
    let (mut left, mut cut, mut single) = (0, 0, 0);
    for _ in 0..20_000 {
        let size = scale(&mut random);
        let [p, q]: [DVec3; 2] =
            core::array::from_fn(|_| DVec3::from(in_scale(&mut random, 0.5 * size)));
        let bounds = Box3::new(p.min(q), p.max(q)).unwrap();
        let a = DVec3::from(in_scale(&mut random, size));
        let b = if random.below(2) == 0 {
            DVec3::from(in_scale(&mut random, size))
        } else {
            // Through a corner, an edge, a face; or next to it. Or along a side.
            let through: [f64; 3] = core::array::from_fn(|k| match random.below(5) {
                0 => random.between(0.0, 1.0).mul_add(0.5 * p[k], 0.5 * q[k]),
                1 | 2 => bounds.min[k],
                _ => bounds.max[k],
            });
            let t = random.between(1.0, 3.0);
            let b: [f64; 3] = core::array::from_fn(|k| {
                let b = if random.below(8) == 0 {
                    a[k]
                } else {
                    a[k] + t * (through[k] - a[k])
                };
                near(&mut random, b)
            });
            DVec3::from(finite(b))
        };
        let clipped = box3::clip_segment(&bounds, [a, b]);
        let exact = in_box([bounds.min, bounds.max], [a, b]);
        assert_eq!(clipped, exact, "{bounds:?} {a} {b}");
        let Some([c, d]) = clipped else { continue };
        assert!(bounds.contains(c) && bounds.contains(d));
        assert_eq!(box3::clip_segment(&bounds, [c, d]), Some([c, d]));
        assert_eq!(box3::clip_segment(&bounds, [b, a]), Some([d, c]));
        left += 1;
        cut += usize::from(c != a) + usize::from(d != b);
        single += usize::from(c == d);
    }
    assert!(
        left > 3_000 && cut > 3_000 && single > 30,
        "{left} {cut} {single}"
    );
}

/// Two triangles on either side of an edge, in the view volume: an attribute that is 0 at the edge's ends and 1 at the
/// third corner is 0 at the vertices on what is left of the edge, and these are the same in both, bit for bit.
#[test]
fn no_cracks_along_a_shared_edge() {
    let mut random = Random::new(313);
    let mut seams = 0;
    for _ in 0..20_000 {
        let whole = random.below(2) == 0;
        let mut corner = || {
            let mut p = DVec4::from_array([0; 4].map(|_| random.between(-2.0, 2.0)));
            if whole {
                p = p.round();
            }
            p.w += 0.5;
            p
        };
        let [p, q, r, s] = [0; 4].map(|_| corner());
        let seam = |triangle: [(DVec4, f64); 3]| -> Option<BTreeSet<[u64; 4]>> {
            let triangle = triangle.map(|(position, off)| Vertex {
                position,
                attributes: [off],
            });
            let inside = clip_polygon(&triangle);
            assert!(
                inside
                    .iter()
                    .all(|v| contains(v.position) && v.position.w > 0.0),
                "{triangle:?}"
            );
            let on_edge = inside.iter().filter(|v| v.attributes == [0.0]);
            (!inside.is_empty()).then(|| {
                on_edge
                    .map(|v| v.position.to_array().map(f64::to_bits))
                    .collect()
            })
        };
        let one = seam([(p, 0.0), (q, 0.0), (r, 1.0)]);
        let other = seam([(q, 0.0), (p, 0.0), (s, 1.0)]);
        if let (Some(one), Some(other)) = (one, other) {
            assert_eq!(one, other, "{p} {q} {r} {s}");
            seams += usize::from(one.len() == 2);
        }
    }
    assert!(seams > 1000, "{seams}");
}
