//! The planar shadow of one vertex as an exact fraction, from the geometry alone.
//!
//! With the plane π = (n, d), the homogeneous light L and the vertex V, the shadow is where the line from V to L
//! meets the plane:
//!
//! ```text
//! s = n·L + d L_w      t = n·V + d      P_j = N_j / W      N_j = s V_j − t L_j      W = s − t L_w
//! ```
//!
//! Nothing here is rounded, so the questions "which side", "how far off" and "which double is nearest" have one
//! answer each.

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::vector::{abs, dot, exact};

/// What becomes of the vertex, decided by exact signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Decision {
    /// It has a shadow, whether a double can hold it or not.
    Casts,
    /// The plane hides it from the light.
    BehindPlane,
    /// Its ray to the light is parallel to the plane: it is as far from the plane as the light.
    LevelWithLight,
    /// The light is between it and the plane.
    BeyondLight,
    /// The light is in the plane, or shines along it.
    LightAlongPlane,
}

/// The exact answer for one plane, light and vertex.
#[derive(Clone, Debug)]
pub struct ExactShadow {
    n: [Exact; 3],
    d: Exact,
    light: [Exact; 3],
    light_w: Exact,
    v: [Exact; 3],
    s: Exact,
    t: Exact,
    numerators: [Exact; 3],
    w: Exact,
}

/// The unit roundoff of doubles, ε/2, as a power of two.
const HALF_EPSILON: i64 = -53;
/// Half the smallest subnormal, as a power of two: what rounding may add near zero.
const HALF_SUBNORMAL: i64 = -1075;

impl ExactShadow {
    /// The exact answer, or `None` where there is no question: a coordinate is not finite, the plane has no
    /// normal, or the light is the zero vector.
    #[must_use]
    pub fn new(plane: Plane, light: DVec4, vertex: DVec3) -> Option<Self> {
        if plane.normal == DVec3::ZERO || light == DVec4::ZERO {
            return None;
        }
        Self::from_exact(
            exact(plane.normal)?,
            Exact::new(plane.d)?,
            exact(light.truncate())?,
            Exact::new(light.w)?,
            exact(vertex)?,
        )
    }

    /// The same for coordinates that no double holds, such as a double and a step of 10⁻²⁰⁰ beside it.
    #[must_use]
    pub fn from_exact(
        n: [Exact; 3],
        d: Exact,
        light: [Exact; 3],
        light_w: Exact,
        v: [Exact; 3],
    ) -> Option<Self> {
        let s = dot(&n, &light) + &d * &light_w;
        let t = dot(&n, &v) + &d;
        let numerators = core::array::from_fn(|j| &s * &v[j] - &t * &light[j]);
        let w = &s - &t * &light_w;
        Some(Self {
            n,
            d,
            light,
            light_w,
            v,
            s,
            t,
            numerators,
            w,
        })
    }

    /// Shadow or none, and why.
    #[must_use]
    pub fn decision(&self) -> Decision {
        // Turn the light's sign so that L_w ≥ 0, and the plane so that the light is in front of it.
        let light_turned = self.light_w.sign() == Ordering::Less;
        let signed = |x: &Exact, turn: bool| if turn { x.sign().reverse() } else { x.sign() };
        let s = signed(&self.s, light_turned);
        if s == Ordering::Equal {
            return Decision::LightAlongPlane;
        }
        let plane_turned = s == Ordering::Less;
        if signed(&self.t, plane_turned) == Ordering::Less {
            return Decision::BehindPlane;
        }
        match signed(&self.w, light_turned != plane_turned) {
            Ordering::Less => Decision::BeyondLight,
            Ordering::Equal => Decision::LevelWithLight,
            Ordering::Greater => Decision::Casts,
        }
    }

    /// Whether a relative change of the inputs by 10⁻¹² or less would reach another decision: the light nearly
    /// along the plane, the vertex nearly on it, or nearly level with the light.
    #[must_use]
    pub fn is_nearly_degenerate(&self) -> bool {
        let (n, light, v) = (abs(&self.n), abs(&self.light), abs(&self.v));
        let (d, light_w) = (self.d.abs(), self.light_w.abs());
        let light_size = dot(&n, &light);
        let vertex_size = dot(&n, &v);
        let s_size = &light_size + &d * &light_w;
        let t_size = &vertex_size + &d;
        // W = n·(L − L_w V): the plane's offset has no part in it.
        let w_size = &light_size + &light_w * &vertex_size;
        // 2⁻⁴⁰ = 0.91 · 10⁻¹².
        [(&self.s, s_size), (&self.t, t_size), (&self.w, w_size)]
            .iter()
            .any(|(x, size)| x.abs() <= size.scaled(-40))
    }

    /// The doubles nearest to the shadow's coordinates (±∞ beyond the largest), where it casts one.
    #[must_use]
    pub fn nearest(&self) -> Option<[f64; 3]> {
        if self.decision() != Decision::Casts {
            return None;
        }
        Some(self.numerators.each_ref().map(|n| n.ratio(&self.w)))
    }

    /// What [`cast`](https://docs.rs/ombra-shadows) has to answer: the nearest doubles, or `None` where there is
    /// no shadow or a coordinate is beyond the largest double.
    #[must_use]
    pub fn answer(&self) -> Option<DVec3> {
        let p = DVec3::from_array(self.nearest()?);
        p.is_finite().then_some(p)
    }

    /// N_j and W of coordinate `j`: the exact coordinate is their quotient.
    #[must_use]
    pub fn fraction(&self, j: usize) -> (&Exact, &Exact) {
        (&self.numerators[j], &self.w)
    }

    /// Σᵢ |∂P_j/∂xᵢ · xᵢ| over the eleven inputs, times W²: how far the exact coordinate moves when every input
    /// moves by a relative unit.
    ///
    /// With A = L − L_w V the quotient rule collapses, because V − P = t A/W and L − L_w P = s A/W:
    ///
    /// ```text
    /// W² ∂P_j/∂n_k  = −A_j N_k              W² ∂P_j/∂d   = −A_j W
    /// W² ∂P_j/∂L_k  = t (A_j n_k − δ_jk W)   W² ∂P_j/∂L_w = t (A_j d + N_j)
    /// W² ∂P_j/∂V_k  = −s (A_j n_k − δ_jk W)
    /// ```
    #[must_use]
    pub fn condition_times_w_squared(&self, j: usize) -> Exact {
        (self.inputs().into_iter().zip(self.derivatives(j)))
            .map(|(input, derivative)| (input * derivative).abs())
            .sum()
    }

    /// The eleven inputs: n, d, the light's x, y, z, w, the vertex.
    fn inputs(&self) -> [&Exact; 11] {
        let [a, b, c] = &self.n;
        let [lx, ly, lz] = &self.light;
        let [vx, vy, vz] = &self.v;
        [a, b, c, &self.d, lx, ly, lz, &self.light_w, vx, vy, vz]
    }

    /// W² ∂P_j/∂xᵢ in the order of the inputs.
    fn derivatives(&self, j: usize) -> [Exact; 11] {
        let a_j = &self.light[j] - &self.light_w * &self.v[j];
        let lever = |k: usize| {
            let product = &a_j * &self.n[k];
            if j == k { product - &self.w } else { product }
        };
        let levers: [Exact; 3] = core::array::from_fn(lever);
        let by_n = |k: usize| -(&a_j * &self.numerators[k]);
        let by_l = |k: usize| &self.t * &levers[k];
        let by_v = |k: usize| -(&self.s * &levers[k]);
        let by_w = &self.t * (&a_j * &self.d + &self.numerators[j]);
        [
            by_n(0),
            by_n(1),
            by_n(2),
            -(&a_j * &self.w),
            by_l(0),
            by_l(1),
            by_l(2),
            by_w,
            by_v(0),
            by_v(1),
            by_v(2),
        ]
    }

    /// Whether |computed − P_j| ≤ (ε/2) Σᵢ |∂P_j/∂xᵢ · xᵢ| + half the smallest subnormal, without rounding.
    #[must_use]
    pub fn within_condition(&self, computed: f64, j: usize) -> bool {
        let Some(computed) = Exact::new(computed) else {
            return false;
        };
        // All times W²: |computed·W − N_j| |W| ≤ (ε/2) C_j + (η/2) W².
        let off = (&computed * &self.w - &self.numerators[j]) * &self.w;
        let bound = self.condition_times_w_squared(j).scaled(HALF_EPSILON)
            + self.w.squared().scaled(HALF_SUBNORMAL);
        off.abs() <= bound
    }

    /// Whether |n·P + d| ≤ (ε/2) Σ |n_j P_j| + (half the smallest subnormal) Σ |n_j| for the computed point P.
    #[must_use]
    pub fn on_plane(&self, computed: DVec3) -> bool {
        let Some(p) = exact(computed) else {
            return false;
        };
        let off = dot(&self.n, &p) + &self.d;
        let n = abs(&self.n);
        let total: Exact = n.iter().sum();
        let bound = dot(&n, &abs(&p)).scaled(HALF_EPSILON) + total.scaled(HALF_SUBNORMAL);
        off.abs() <= bound
    }
}

#[cfg(test)]
mod tests {
    use super::{Decision, ExactShadow};
    use crate::cases::Random;
    use ombra_math::glam::{DVec3, DVec4};
    use ombra_math::plane::Plane;
    use ombra_oracle::Exact;

    const POINT_LIGHT: DVec4 = DVec4::new(0.0, 100.0, 100.0, 1.0);

    fn ground(light: DVec4, v: DVec3) -> ExactShadow {
        ExactShadow::new(Plane::GROUND, light, v).unwrap()
    }

    // By hand: Bologna's example light over the ground, and the five things that can happen on its vertical line.
    #[test]
    fn known_answers() {
        let p = ground(POINT_LIGHT, DVec3::new(0.0, 20.0, 0.0)).nearest();
        assert_eq!(p, Some([0.0, 0.0, -25.0]));
        let p = ground(POINT_LIGHT, DVec3::new(10.0, 30.0, 0.0)).nearest();
        assert_eq!(p, Some([100.0 / 7.0, 0.0, -300.0 / 7.0]));
        for (y, decision) in [
            (-1.0, Decision::BehindPlane),
            (0.0, Decision::Casts),
            (99.0, Decision::Casts),
            (100.0, Decision::LevelWithLight),
            (101.0, Decision::BeyondLight),
        ] {
            let v = DVec3::new(3.0, y, 4.0);
            assert_eq!(ground(POINT_LIGHT, v).decision(), decision, "y = {y}");
            // −L is the same place, and a plane turned round the same plane.
            assert_eq!(ground(-POINT_LIGHT, v).decision(), decision, "y = {y}");
            let turned = Plane {
                normal: -DVec3::Y,
                d: 0.0,
            };
            let turned = ExactShadow::new(turned, POINT_LIGHT, v).unwrap();
            assert_eq!(turned.decision(), decision, "y = {y}");
            assert_eq!(turned.nearest(), ground(-POINT_LIGHT, v).nearest());
        }
        let along = ground(DVec4::new(1.0, 0.0, 0.0, 0.0), DVec3::Y);
        assert_eq!(along.decision(), Decision::LightAlongPlane);
        // From below: a direction towards a light under the ground sees what is under the ground.
        let below = DVec4::new(0.0, -1.0, 0.0, 0.0);
        assert_eq!(ground(below, DVec3::Y).decision(), Decision::BehindPlane);
        assert_eq!(ground(below, -DVec3::Y).decision(), Decision::Casts);
    }

    /// The derivatives against exact difference quotients: one input moved by h = 2⁻²⁰⁰ changes the coordinate
    /// by h ∂P/∂x + O(h²), so the quotient agrees with the derivative to about 2⁻²⁰⁰ of the condition.
    #[test]
    fn derivatives_agree_with_difference_quotients() {
        let mut random = Random::new(11);
        let mut compared = 0;
        for _ in 0..200 {
            let x: [f64; 11] = core::array::from_fn(|_| random.between(-8.0, 8.0));
            let build = |x: &[Exact; 11]| {
                let three = |i: usize| core::array::from_fn(|k| x[i + k].clone());
                ExactShadow::from_exact(three(0), x[3].clone(), three(4), x[7].clone(), three(8))
            };
            let x = x.map(|x| Exact::new(x).unwrap());
            let shadow = build(&x).unwrap();
            for j in 0..3 {
                for (i, derivative) in shadow.derivatives(j).into_iter().enumerate() {
                    let h = Exact::power_of_two(-200);
                    let mut moved = x.clone();
                    moved[i] += h;
                    let moved = build(&moved).unwrap();
                    // (P(x + h) − P(x)) / h as a fraction: (N′ W − N W′) / (h W W′).
                    let ((n, w), (n1, w1)) = (shadow.fraction(j), moved.fraction(j));
                    let rise = (n1 * w - n * w1).scaled(200);
                    // Minus the derivative D/W², all over W² W′: rise · W − D · W′.
                    let off = rise * w - &derivative * w1;
                    // Second derivatives over the first are below 2⁶⁰ for these inputs unless W nearly vanishes.
                    let scale = shadow.condition_times_w_squared(j) * w1;
                    let bound = scale.abs().scaled(-140);
                    assert!(off.abs() <= bound, "∂P_{j}/∂x_{i}");
                    compared += usize::from(!derivative.is_zero());
                }
            }
        }
        // Every derivative of a random case is different from zero.
        assert_eq!(compared, 200 * 33);
    }

    #[test]
    fn bounds_reject_what_is_off() {
        // x of this shadow is 100/7; its condition is 100 · (a small number), so 2⁻⁴⁵ relative is too much.
        let shadow = ground(POINT_LIGHT, DVec3::new(10.0, 30.0, 0.0));
        let x: f64 = 100.0 / 7.0;
        assert!(shadow.within_condition(x, 0));
        assert!(!shadow.within_condition(x * (1.0 + 1e-14), 0));
        assert!(!shadow.within_condition(f64::NAN, 0));
        assert!(shadow.on_plane(DVec3::new(1.0, 0.0, 3.0)));
        assert!(!shadow.on_plane(DVec3::new(1.0, 1e-300, 3.0)));
        // The condition itself, by hand. s = 100, t = 30, W = 70, A = (−10, 70, 100), N = (1000, 0, −3000).
        // n: |A_x n_y N_y| = 0; L: x is 0, y: 30·100·|−10| = 30000; w: 30·1000 = 30000;
        // V: x: 100·10·|0 − 70| = 70000, y: 100·30·10 = 30000. In all 160000, over W² = 4900.
        let condition = shadow.condition_times_w_squared(0);
        assert_eq!(condition, 160_000);
    }
}
