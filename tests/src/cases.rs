//! Random planes, lights and vertices, the same ones on every machine.
//!
//! Uniform coordinates find nothing: exponents are spread over the whole range, a share of the numbers is
//! subnormal, and a third of the cases lies within 10⁻¹² of a degenerate one.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;

/// A small generator with a fixed course (Steele, Lea and Flood, 2014: SplitMix64).
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The sequence of `seed`.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`, for small n.
    pub fn below(&mut self, n: u32) -> u32 {
        ((u64::from(n) * (self.bits() >> 32)) >> 32) as u32
    }

    /// A number in [a, b), uniformly.
    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * ((self.bits() >> 11) as f64 * (f64::EPSILON / 2.0))
    }

    /// A mantissa in ±[1, 2), times 2^e with the exponent uniform from `low` to `high`.
    pub fn exponential(&mut self, low: i32, high: i32) -> f64 {
        let sign = if self.bits().is_multiple_of(2) {
            1.0
        } else {
            -1.0
        };
        sign * self.between(1.0, 2.0) * self.power_of_two(low, high)
    }

    /// 2^e with the exponent uniform from `low` to `high`, both among those of the doubles.
    pub fn power_of_two(&mut self, low: i32, high: i32) -> f64 {
        let span = u32::try_from(high - low + 1).unwrap_or(1);
        Exact::power_of_two(i64::from(low) + i64::from(self.below(span))).nearest()
    }

    /// A direction of three coordinates in [−1, 1).
    pub fn direction(&mut self) -> DVec3 {
        DVec3::from_array(core::array::from_fn(|_| self.between(-1.0, 1.0)))
    }
}

/// One question: the shadow of `vertex` on `plane` from `light`.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The receiving plane.
    pub plane: Plane,
    /// The homogeneous light.
    pub light: DVec4,
    /// The vertex that may cast a shadow.
    pub vertex: DVec3,
}

/// The largest exponent of the cases: 10³⁰⁰ is just below 2⁹⁹⁷.
const LARGEST: i32 = 996;
/// The smallest exponent of a subnormal.
const SMALLEST: i32 = -1074;

/// A random case.
pub fn case(random: &mut Random) -> Case {
    let mut case = match random.below(8) {
        0 | 1 => scattered(random),
        2 => whole_numbers(random),
        _ => in_scale(random),
    };
    // Directions are as frequent as places, and places may be given as −L.
    match random.below(4) {
        0 | 1 => case.light.w = 0.0,
        2 => case.light = -case.light,
        _ => {}
    }
    if random.below(2) == 0 {
        nearly_degenerate(random, &mut case);
    }
    case
}

/// Eleven numbers of independent size, one in eight of them zero or subnormal.
fn scattered(random: &mut Random) -> Case {
    let mut number = || match random.below(16) {
        0 => 0.0,
        1 => random.exponential(SMALLEST, -1023),
        _ => random.exponential(-LARGEST, LARGEST),
    };
    from_numbers(core::array::from_fn(|_| number()))
}

/// Small whole numbers times one power of two a group: exact ties, exact zeros.
fn whole_numbers(random: &mut Random) -> Case {
    let mut numbers: [f64; 11] = core::array::from_fn(|_| f64::from(random.below(9)) - 4.0);
    let scales = scales(
        random.power_of_two(-300, 300),
        random.power_of_two(-300, 300),
        random.power_of_two(-300, 300),
    );
    for (x, scale) in numbers.iter_mut().zip(scales) {
        *x *= scale;
    }
    from_numbers(numbers)
}

/// A scene of one size, anywhere in the range, so that no part drowns the others; now and then one coordinate
/// is of another size.
fn in_scale(random: &mut Random) -> Case {
    // d is length times normal and the light's place is length times w, so that these stay inside the range.
    let (length, normal, w) = match random.below(3) {
        0 => (
            random.exponential(-480, 480),
            random.exponential(-480, 480),
            random.exponential(-480, 480),
        ),
        // Coordinates near both ends of the range.
        1 => (
            random.exponential(900, 1010),
            random.exponential(-1000, 0),
            random.exponential(-1000, 0),
        ),
        _ => (
            random.exponential(-1060, -900),
            random.exponential(0, 900),
            random.exponential(0, 900),
        ),
    };
    let spread = [0, 4, 40][random.below(3) as usize];
    let mut numbers = scales(length, normal, w).map(|scale| scale * random.exponential(-spread, 0));
    if random.below(4) == 0 {
        let odd_one = random.below(11) as usize;
        if let Some(x) = numbers.get_mut(odd_one) {
            *x = random.exponential(-LARGEST, LARGEST);
        }
    }
    from_numbers(numbers)
}

/// The size of each of the eleven numbers in a scene of the given sizes.
fn scales(length: f64, normal: f64, w: f64) -> [f64; 11] {
    let (place, offset) = (length * w, length * normal);
    let (n, v) = (normal, length);
    [n, n, n, offset, place, place, place, w, v, v, v]
}

fn from_numbers([a, b, c, d, lx, ly, lz, lw, vx, vy, vz]: [f64; 11]) -> Case {
    Case {
        plane: Plane {
            normal: DVec3::new(a, b, c),
            d,
        },
        light: DVec4::new(lx, ly, lz, lw),
        vertex: DVec3::new(vx, vy, vz),
    }
}

/// Moves the light nearly along the plane, or the vertex nearly to the light's height or nearly onto the plane,
/// by a relative distance from 0 to 10⁻¹².
fn nearly_degenerate(random: &mut Random, case: &mut Case) {
    let n = case.plane.normal;
    let axis = random.below(3) as usize;
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let off = match random.below(4) {
        0 => 0.0,
        _ => random.exponential(-64, -41),
    };
    // Solve n·X = goal for one coordinate of X, then move that by `off`.
    let solved = |x: DVec3, goal: f64| {
        let value = (goal - (n[i] * x[i] + n[j] * x[j])) / n[axis];
        value * (1.0 + off)
    };
    match random.below(3) {
        0 => {
            let value = solved(case.light.truncate(), -case.plane.d * case.light.w);
            if value.is_finite() {
                case.light[axis] = value;
            }
        }
        1 => {
            let light = case.light;
            let goal = n.dot(light.truncate() / light.w);
            let value = solved(case.vertex, goal);
            if value.is_finite() {
                case.vertex[axis] = value;
            } else {
                // A direction has no height: a small w gives it one, far away.
                case.light.w = random.exponential(-1000, -900);
            }
        }
        _ => {
            let value = solved(case.vertex, -case.plane.d);
            if value.is_finite() {
                case.vertex[axis] = value;
            }
        }
    }
}

/// A number of one of five kinds: on the grid of a window 0…8, halves, doubles about it, within two ulps of the grid,
/// and of any size.
fn near_grid(random: &mut Random, kind: u32) -> f64 {
    let grid = f64::from(random.below(17)) - 4.0;
    match kind {
        0 => grid,
        1 => grid + 0.5,
        2 => random.between(-4.0, 12.0),
        3 => [
            grid.next_up(),
            grid.next_down(),
            grid.next_up().next_up(),
            grid,
        ][random.below(4) as usize],
        _ => match random.below(3) {
            0 => random.exponential(-1074, 1022),
            1 => [f64::MAX, -f64::MAX, 5e-324, -0.0][random.below(4) as usize],
            _ => random.between(-4.0, 12.0),
        },
    }
}

/// A point of such numbers, mostly of one kind, now and then of another.
pub fn point_near_grid(random: &mut Random, kind: u32) -> DVec2 {
    let mut one = || {
        let kind = if random.below(8) == 0 {
            random.below(5)
        } else {
            kind
        };
        near_grid(random, kind)
    };
    DVec2::new(one(), one())
}

#[cfg(test)]
mod tests {
    use super::{Random, case};

    // The course of the generator is part of what the tests are: first outputs of seed 1234567, as published
    // with the algorithm's reference implementation.
    #[test]
    fn the_published_course() {
        let mut random = Random::new(1_234_567);
        assert_eq!(random.bits(), 6_457_827_717_110_365_317);
        assert_eq!(random.bits(), 3_203_168_211_198_807_973);
        assert_eq!(random.bits(), 9_817_491_932_198_370_423);
    }

    #[test]
    fn reaches_both_ends_of_the_range() {
        let mut random = Random::new(1);
        let (mut subnormal, mut huge, mut finite) = (0, 0, 0);
        for _ in 0..10_000 {
            let case = case(&mut random);
            let numbers = [
                case.plane.normal.to_array().to_vec(),
                case.light.to_array().to_vec(),
                case.vertex.to_array().to_vec(),
                vec![case.plane.d],
            ]
            .concat();
            subnormal += usize::from(numbers.iter().any(|x| x.is_subnormal()));
            huge += usize::from(numbers.iter().any(|x| x.abs() > 1e290));
            finite += usize::from(numbers.iter().all(|x| x.is_finite()));
        }
        assert_eq!(finite, 10_000);
        assert!(subnormal > 500 && huge > 500, "{subnormal} {huge}");
    }
}
