//! The formula of precision against what is stored and what is drawn.

use ombra_oracle::Exact;

use super::*;
use crate::z_buffer::precision::{depth_at, depth_step, fighting_distance, separable_distance};

fn r(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn quotient(x: &Exact, y: &Exact) -> Exact {
    x.over(y).unwrap()
}

/// 1 + `roundings` ε.
fn about_1(roundings: f64) -> Exact {
    Exact::from(1) + r(roundings * f64::EPSILON)
}

/// A perspective view without rounding; 1 / far, which may be 0.
#[derive(Debug)]
struct Volume {
    near: Exact,
    inverse_far: Exact,
}

impl Volume {
    fn new(near: f64, far: f64) -> Self {
        let inverse_far =
            Exact::new(far).map_or(Exact::ZERO, |far| quotient(&Exact::from(1), &far));
        let near = r(near);
        Self { near, inverse_far }
    }

    /// (f − n) / f.
    fn share(&self) -> Exact {
        Exact::from(1) - &self.near * &self.inverse_far
    }

    fn depth(&self, distance: &Exact) -> Exact {
        quotient(
            &(Exact::from(1) - quotient(&self.near, distance)),
            &self.share(),
        )
    }

    fn value<F: DepthFormat>(&self, distance: &Exact) -> Exact {
        let depth = self.depth(distance);
        if F::REVERSED {
            Exact::from(1) - depth
        } else {
            depth
        }
    }

    /// The step where stored values are `spacing` apart.
    fn step(&self, distance: &Exact, spacing: &Exact) -> Exact {
        quotient(&(spacing * distance.squared() * self.share()), &self.near)
    }

    /// The spacings that a value within 2½ ε of the true one may have: two beside a power of two.
    fn spacings<F: DepthFormat>(&self, distance: &Exact) -> [Exact; 2] {
        let value = self.value::<F>(distance);
        // 24 bits are 24 ones below; f32 is all powers of two.
        let bits = match F::NAME {
            "16 bits" => Some(16),
            "24 bits" => Some(24),
            _ => None,
        };
        [-3.0, 3.0].map(|roundings| match bits {
            Some(bits) => quotient(&Exact::from(1), &Exact::from((1 << bits) - 1)),
            None => r(F::spacing((&value * about_1(roundings)).nearest())),
        })
    }
}

/// `bound` in ε, and half of the smallest double.
fn is_within(found: f64, exact: &Exact, bound: f64) -> bool {
    let slack = exact.abs() * r(bound * f64::EPSILON) + Exact::power_of_two(-1075);
    found.is_finite() && (r(found) - exact).abs() <= slack
}

/// Near and far planes and a distance between: volumes a rounding thick and without end, of all sizes.
fn volumes() -> impl Strategy<Value = [f64; 3]> {
    let near = (1.0..2.0f64, -1074..1020).prop_map(|(m, e)| libm::scalbn(m, e));
    let ratio = prop_oneof![
        (1..9u64).prop_map(|k| 1.0 + k as f64 * f64::EPSILON),
        (1.0..2.0f64, -52..0).prop_map(|(m, e)| 1.0 + libm::scalbn(m, e)),
        (1.0..2.0f64, 0..1000).prop_map(|(m, e)| libm::scalbn(m, e)),
        Just(f64::INFINITY),
    ];
    let place = (0..4, 0.0..=1.0f64, 0..52i32);
    (near, ratio, place).prop_map(|(near, ratio, (kind, share, e))| {
        let far = (near * ratio).max(near.next_up());
        let [least, greatest] = [near, far.min(f64::MAX)];
        let distance = match kind {
            0 => least * (1.0 + libm::scalbn(share, -e)),
            1 => greatest * (1.0 - libm::scalbn(share, -e)),
            2 => least + share * (greatest - least),
            // Between them in size.
            _ => libm::pow(greatest / 2.0, share) * libm::pow(least, 1.0 - share),
        };
        [near, far, distance.clamp(least, greatest)]
    })
}

fn check_step<F: DepthFormat>([near, far, distance]: [f64; 3]) -> Result<(), TestCaseError> {
    let exact = Volume::new(near, far);
    let z = r(distance);
    let found = depth_step::<F>(near, far, distance).unwrap();
    let fits = exact.spacings::<F>(&z).iter().any(|spacing| {
        let step = exact.step(&z, spacing);
        is_within(found, &step, 3.5) || (step > f64::MAX && found == f64::INFINITY)
    });
    prop_assert!(fits, "{}: {:e}", F::NAME, found);
    Ok(())
}

/// Before the answer no step is as large as the gap, and there one is: for a gap a few roundings off.
fn check_fight<F: DepthFormat>([near, far, _]: [f64; 3], gap: f64) -> Result<(), TestCaseError> {
    let exact = Volume::new(near, far);
    let greatest_step = |z: &Exact| {
        let steps = exact
            .spacings::<F>(z)
            .map(|spacing| exact.step(z, &spacing));
        steps.into_iter().max().unwrap()
    };
    let name = F::NAME;
    let found = fighting_distance::<F>(near, far, gap);
    let nearly = |gap: f64, roundings: f64| r(gap) * about_1(roundings);
    // The step grows with the distance; only reversed it falls by half where the value falls below a power of two. There,
    // before `end`, it may be the greatest: the two powers for which it is, by rounded logarithms.
    let turns = |end: &Exact| -> Vec<Exact> {
        let mut powers: Vec<i32> = (-149..0).filter(|_| F::REVERSED).collect();
        let at = |e: i32| {
            let value = r(libm::scalbn(1.0, e));
            let depth = Exact::from(1) - &value;
            quotient(
                &exact.near,
                &(value + depth * &exact.near * &exact.inverse_far),
            )
        };
        let end_log = libm::log2(end.nearest());
        let log = |e: i32| libm::log2(near) - libm::log2(libm::scalbn(1.0, e) + near / far);
        powers.retain(|&e| log(e) < end_log);
        powers.sort_by(|&a, &b| {
            let key = |e: i32| f64::from(e.max(-126)) + 2.0 * log(e);
            key(b).total_cmp(&key(a))
        });
        let places = powers.into_iter().take(2).map(at);
        let places = places.flat_map(|z| [-6.0, 6.0].map(|k| &z * about_1(k)));
        let before = places.filter(|z| *z >= exact.near && z < end);
        before.chain([end.clone()]).collect()
    };
    let end = match found {
        Some(z) => {
            prop_assert!((near..=far).contains(&z));
            let places = [-5.0, 0.0, 5.0].map(|k| r(z) * about_1(k));
            let greatest = places.iter().map(greatest_step).max().unwrap();
            prop_assert!(greatest >= nearly(gap, -12.0), "{}: not at {:e}", name, z);
            (r(z) * about_1(-5.0)).max(exact.near.clone())
        }
        None if far < f64::INFINITY => r(far) * about_1(-5.0),
        None => r(f64::MAX),
    };
    if end <= exact.near {
        return Ok(());
    }
    for z in turns(&end) {
        let least = exact
            .spacings::<F>(&z)
            .map(|spacing| exact.step(&z, &spacing));
        let least = least.into_iter().min().unwrap();
        prop_assert!(
            least <= nearly(gap, 12.0),
            "{}: {:?}, but at {:?}",
            name,
            found,
            z.nearest()
        );
    }
    Ok(())
}

proptest! {
    #[test]
    fn depths_keep_their_digits_in_every_volume(volume in volumes()) {
        let [near, far, distance] = volume;
        let exact = Volume::new(near, far).depth(&r(distance));
        let found = depth_at(near, far, distance).unwrap();
        prop_assert!(is_within(found, &exact, 2.5), "{:e}", found);
        prop_assert!((0.0..=1.0).contains(&found));
    }

    #[test]
    fn steps_keep_their_digits_in_every_volume(volume in volumes()) {
        check_step::<Depth16>(volume)?;
        check_step::<Depth24>(volume)?;
        check_step::<Depth32F>(volume)?;
        check_step::<ReversedDepth32F>(volume)?;
    }

    #[test]
    fn fights_begin_where_the_step_is_the_gap(volume in volumes(), e in -40..3i32, any in -1000..1000i32, free in any::<bool>()) {
        let [near, far, distance] = volume;
        let gap = if free { libm::scalbn(1.37, any) } else { libm::scalbn(distance, e).max(f64::from_bits(1)) };
        if gap < f64::INFINITY && near.is_normal() {
            check_fight::<Depth16>([near, far, distance], gap)?;
            check_fight::<Depth24>([near, far, distance], gap)?;
            check_fight::<Depth32F>([near, far, distance], gap)?;
            check_fight::<ReversedDepth32F>([near, far, distance], gap)?;
        }
    }
}

/// A volume of a millionth of a millionth of its distance, seen at its far plane and in its middle.
#[test]
fn thin_volumes() {
    let (near, far) = (0.1, 0.1 * (1.0 + 1e-12));
    assert_eq!(depth_at(near, far, far), Some(1.0));
    assert_eq!(depth_at(near, f64::INFINITY, f64::MAX), Some(1.0));
    let middle = 0.5 * (near + far);
    let found = depth_at(near, far, middle).unwrap();
    let exact = Volume::new(near, far).depth(&r(middle));
    assert!(is_within(found, &exact, 2.5), "{found}");
    // 65 535 steps from end to end.
    let step = depth_step::<Depth16>(near, far, middle).unwrap();
    assert!(
        (65_535.0 * step / (far - near) - 1.0).abs() <= 1e-11,
        "{step}"
    );
}

/// The measured step is the formula's, to second order, where it is neither cut off by a plane nor at a power of two.
fn step_is_found<F: DepthFormat>(near: f64, far: f64, distance: f64) {
    let step = depth_step::<F>(near, far, distance).unwrap();
    let found = separable_distance::<F>(near, far, distance).unwrap();
    // z changes by a step from end to end, and Δz with its square; doubles resolve n / z to ε.
    let slack = 2.0 * step / distance + 8.0 * f64::EPSILON * distance / step;
    let name = F::NAME;
    assert!(
        (found / step - 1.0).abs() <= slack,
        "{name} {near} {far} {distance}: {found}, {step}"
    );
}

#[test]
fn the_formula_is_measured() {
    for (near, far) in [(0.1, 1000.0), (1.0, 50.0), (1e-3, 10.0)] {
        for share in [0.013, 0.11, 0.37, 0.71, 0.93] {
            let distance = near + share * (far - near);
            if depth_step::<Depth16>(near, far, distance).unwrap() < 0.05 * (far - distance) {
                step_is_found::<Depth16>(near, far, distance);
            }
            step_is_found::<Depth24>(near, far, distance);
            step_is_found::<Depth32F>(near, far, distance);
            step_is_found::<ReversedDepth32F>(near, far, distance);
        }
    }
}

fn fights_from_there_on<F: DepthFormat>(near: f64, far: f64, gap: f64) {
    let name = F::NAME;
    let value = |z: f64| {
        let depth = depth_at(near, far, z).unwrap();
        if F::REVERSED {
            (near / z - near / far) / (1.0 - near / far)
        } else {
            depth
        }
    };
    let tie = |z: f64| F::encode(value(z)) == F::encode(value(z + gap));
    let first = fighting_distance::<F>(near, far, gap);
    let end = first.unwrap_or(far).min(far - gap);
    let at = |i: u32, from: f64, to: f64| from + (to - from) * f64::from(i) / 20_000.0;
    // The step grows by 2 gap / z within the gap.
    let safe = near + (end - near) * (1.0 - 2.0 * gap / end);
    assert!(
        !(0..20_000).any(|i| tie(at(i, near, safe))),
        "{name}: before {end}"
    );
    if let Some(first) = first.filter(|z| z * 1.2 < far) {
        // Steps of 1.1² gaps: a sixth of all places tie.
        let ties = (0..20_000)
            .filter(|&i| tie(at(i, first * 1.1, first * 1.12)))
            .count();
        assert!(
            (1000..10_000).contains(&ties),
            "{name}: {ties} after {first}"
        );
    }
}

#[test]
fn surfaces_fight_from_the_predicted_distance_on() {
    fights_from_there_on::<Depth16>(0.1, 1000.0, 0.01);
    fights_from_there_on::<Depth24>(0.1, 1000.0, 0.01);
    fights_from_there_on::<Depth32F>(0.1, 1000.0, 0.01);
    fights_from_there_on::<ReversedDepth32F>(0.1, 1000.0, 0.01);
    assert_eq!(
        fighting_distance::<ReversedDepth32F>(0.1, 1000.0, 0.01),
        None
    );
    // Too near to each other even there.
    let first = fighting_distance::<ReversedDepth32F>(0.1, 1000.0, 2e-5).unwrap();
    assert!((100.0..400.0).contains(&first), "{first}");
    assert_eq!(fighting_distance::<Depth16>(1.0, 10.0, 1e-9), Some(1.0));
}

/// In a picture: a floor, and a second one a little below it, drawn first. It shows only where the two can tie.
#[test]
fn fighting_is_seen_in_the_picture() {
    let (near, far, size) = (0.1, 1000.0, 64);
    let floor = |y: f64| {
        [(-900.0, 0.2), (900.0, 0.2), (900.0, 900.0), (-900.0, 900.0)]
            .map(|(x, z)| DVec3::new(x, y, -z))
    };
    let mesh = Mesh::new(
        [floor(-1.001), floor(-1.0)].concat(),
        vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
    )
    .unwrap();
    let camera = Camera {
        view_projection: frustum(-0.1, 0.1, -0.1, 0.0, near, far).unwrap(),
        viewport: viewport(size, size),
    };
    let ids = [0u32, 0, 1, 1].map(|i| Luma([i]));
    let mut picture = buffers::new(size, size, Luma([9])).unwrap();
    let mut depth = DepthBuffer::<Depth16>::new(size, size).unwrap();
    draw(
        &mesh,
        &camera,
        Colours::PerTriangle(&ids),
        Options::default(),
        &mut picture,
        &mut depth,
    )
    .unwrap();
    let mut fought = 0;
    for y in 0..size {
        // Row y looks down by (y + ½) / size: the floors are met at 1 and 1.001 times its inverse.
        let distance = f64::from(size) / (f64::from(y) + 0.5);
        let wrong = (0..size)
            .filter(|&x| picture.get_pixel(x, y).0[0] == 0)
            .count();
        let gap = 0.001 * distance;
        let step = depth_step::<Depth16>(near, far, distance + gap).unwrap();
        // Snapping may move the floors by another 2⁻⁹ of a pixel, a hundredth of the gap at the most.
        assert!(
            wrong == 0 || step >= 0.9 * gap,
            "row {y}: {wrong}, {step} of {gap}"
        );
        fought += wrong;
    }
    assert!(fought > size as usize * 4, "{fought}");
}

/// Near and far at 10⁻⁶ and 10⁶, the camera turned: squares a few steps apart are told apart wherever they are.
#[test]
fn reversed_depth_keeps_its_digits_in_a_turned_view() {
    let (near, far, size) = (1e-6, 1e6, 24);
    for (eye, target) in [
        (DVec3::ZERO, DVec3::new(0.3, -0.7, -1.0)),
        (DVec3::new(3.0, 1.0, -2.0), DVec3::new(-1.0, 0.5, 2.0)),
        (DVec3::new(40.0, -50.0, 60.0), DVec3::ZERO),
    ] {
        let view = look_at(eye, target, DVec3::Y).unwrap();
        let camera = Camera {
            view_projection: frustum(-1e-6, 1e-6, -1e-6, 1e-6, near, far).unwrap() * view,
            viewport: viewport(size, size),
        };
        let to_world = view.inverse();
        let stored = |distance: f64| {
            let corner =
                |x: f64, y: f64| to_world.transform_point3(DVec3::new(x, y, -1.0) * distance);
            let positions = vec![corner(-2.0, -2.0), corner(5.0, -2.0), corner(-2.0, 5.0)];
            let mesh = Mesh::new(positions, vec![[0, 1, 2]]).unwrap();
            let mut depth = DepthBuffer::<ReversedDepth32F>::new(size, size).unwrap();
            draw_depth(&mesh, &camera, Cull::Nothing, &mut depth).unwrap();
            depth.into_image().into_raw()
        };
        for distance in [1.0, 1e3, 1e5, 3e5] {
            let step = depth_step::<ReversedDepth32F>(near, far, distance).unwrap();
            let (first, second) = (stored(distance), stored(distance + 4.0 * step));
            assert!(
                first.iter().zip(&second).all(|(a, b)| a > b && *b > 0.0),
                "{eye} {distance}"
            );
            // The planes that the rounded matrix stands for: each coefficient of ½ (m₄ − m₃) within ε, times
            // coordinates of 3 distances and an eye within 100, beside the near distance; and the rounding to f32.
            let exact = (near / distance - near / far) / (1.0 - near / far);
            let moved = 4.0 * f64::EPSILON * (3.0 * distance + 100.0) / near;
            for &found in &first {
                let error = (f64::from(found) / exact - 1.0).abs();
                assert!(
                    error <= f64::from(f32::EPSILON) + moved,
                    "{eye} {distance}: {found} is {exact}"
                );
            }
        }
    }
}

#[test]
fn refused() {
    for (near, far, distance) in [
        (0.0, 1.0, 0.5),
        (-1.0, 1.0, 0.5),
        (2.0, 1.0, 1.5),
        (1.0, 1.0, 1.0),
        (1.0, 2.0, 0.9),
        (1.0, 2.0, 2.1),
        (f64::NAN, 2.0, 1.0),
        (1.0, f64::NAN, 1.0),
        (1.0, 2.0, f64::NAN),
        (1.0, f64::INFINITY, f64::INFINITY),
        (f64::INFINITY, f64::INFINITY, 1.0),
    ] {
        assert_eq!(
            depth_at(near, far, distance),
            None,
            "{near} {far} {distance}"
        );
        assert_eq!(depth_step::<Depth16>(near, far, distance), None);
        assert_eq!(separable_distance::<Depth16>(near, far, distance), None);
    }
    for gap in [0.0, -1.0, f64::NAN] {
        assert_eq!(fighting_distance::<Depth24>(1.0, 2.0, gap), None);
    }
    assert_eq!(fighting_distance::<Depth24>(1.0, 2.0, f64::INFINITY), None);
    // Beyond the far plane, which rounding of 1 − near / far does not bring nearer.
    assert_eq!(fighting_distance::<Depth16>(1e-3, 1e14, 1e30), None);
}
