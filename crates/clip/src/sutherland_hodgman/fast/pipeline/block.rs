//! Sixteen edges, four at a time in the lanes of a vector: the regions of their ends, and where they cross the border.

use fearless_simd::{
    Select, Simd, SimdBase, SimdCombine, SimdFloat, SimdInto, SimdMask, f64x2, f64x4,
};
use ombra_math::glam::DVec2;

use crate::cohen_sutherland::Outcode;
use crate::crossing::{LARGE, several_at};
use crate::window::{Side, Window};

/// So many edges are a block.
pub(super) const EDGES: usize = 16;

/// A bit for each of them.
const ALL: u32 = (1 << EDGES) - 1;

/// Their vertices: the last of a block is the first of the next.
pub(super) type Vertices = [DVec2; EDGES + 1];

/// Where the ends of a block's edges lie. A bit for each edge, the lowest for the first.
#[derive(Clone, Copy)]
pub(super) struct Regions {
    /// Sixteen bits for each side, in their order: which first ends lie beyond it, and which second ends.
    starts: u64,
    ends: u64,
    /// All second ends are finite.
    pub(super) finite: bool,
    /// The ends of some edge are equal.
    pub(super) repeats: bool,
}

impl Regions {
    /// The bits of any side.
    #[inline(always)]
    fn any(of_sides: u64) -> u32 {
        let two = of_sides | (of_sides >> 32);
        (two | (two >> 16)) as u32 & ALL
    }

    /// The edges that start outside the window.
    #[inline(always)]
    pub(super) fn start_outside(self) -> u32 {
        Self::any(self.starts)
    }

    /// The edges that end in the window.
    #[inline(always)]
    pub(super) fn end_inside(self) -> u32 {
        Self::any(self.ends) ^ ALL
    }

    /// The edges from one region to another.
    #[inline(always)]
    pub(super) fn changes(self) -> u32 {
        Self::any(self.starts ^ self.ends)
    }
}

/// Room for what is left of a block: crossings and second ends inside.
pub(super) type Room = [DVec2; 2 * EDGES];

/// What is left of a block.
pub(super) struct Remains {
    /// How many points in all.
    pub(super) length: usize,
    /// Two crossings in a row are at the same place.
    pub(super) repeats: bool,
    /// Some crossing is not certain, or is an end.
    pub(super) doubtful: bool,
    /// How many crossings there are, and a bit for each: whether it is on an upright side, and whether its edge leads
    /// beyond two sides.
    pub(super) crossings: u32,
    pub(super) upright: u32,
    pub(super) past_corner: u32,
}

/// The window, its numbers in all lanes and at 0 rather than −0.
#[derive(Clone, Copy)]
pub(super) struct Lines<S: Simd> {
    simd: S,
    min_x: f64x4<S>,
    max_x: f64x4<S>,
    min_y: f64x4<S>,
    max_y: f64x4<S>,
}

impl<S: Simd> Lines<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, window: &Window) -> Self {
        let all = |x: f64| f64x4::splat(simd, x + 0.0);
        Self {
            simd,
            min_x: all(window.min.x),
            max_x: all(window.max.x),
            min_y: all(window.min.y),
            max_y: all(window.max.y),
        }
    }

    /// x and y of four points.
    #[inline(always)]
    fn four(&self, [p, q, r, s]: [DVec2; 4]) -> [f64x4<S>; 2] {
        let two = |p: DVec2| -> f64x2<S> { [p.x, p.y].simd_into(self.simd) };
        let [p, q, r, s] = [two(p), two(q), two(r), two(s)];
        [
            p.zip_low(q).combine(r.zip_low(s)),
            p.zip_high(q).combine(r.zip_high(s)),
        ]
    }

    /// Where the ends lie; `first` is the region of the first vertex.
    #[inline(always)]
    pub(super) fn regions(&self, vertices: &Vertices, first: Outcode) -> Regions {
        let zero = f64x4::splat(self.simd, 0.0);
        let (mut ends, mut repeats, mut zeros) = (0, 0, zero);
        let mut before = [vertices[0].x, vertices[0].y].map(|x| f64x4::splat(self.simd, x));
        for at in (0..EDGES).step_by(4) {
            let [x, y] = self.four([
                vertices[at + 1],
                vertices[at + 2],
                vertices[at + 3],
                vertices[at + 4],
            ]);
            let beyond = self.max_y.simd_lt(y).to_bitmask()
                | y.simd_lt(self.min_y).to_bitmask() << EDGES
                | self.max_x.simd_lt(x).to_bitmask() << (2 * EDGES)
                | x.simd_lt(self.min_x).to_bitmask() << (3 * EDGES);
            ends |= beyond << at;
            let same = before[0].slide::<3>(x).simd_eq(x) & before[1].slide::<3>(y).simd_eq(y);
            repeats |= same.to_bitmask();
            before = [x, y];
            // 0, however it is rounded; NaN of a number that is not finite.
            zeros = x.mul_add(zero, zeros);
            zeros = y.mul_add(zero, zeros);
        }
        let [above, below, right, left] = Side::ALL.map(|side| u64::from(first.has(side)));
        let first = above | below << EDGES | right << (2 * EDGES) | left << (3 * EDGES);
        Regions {
            starts: (ends & 0x7fff_7fff_7fff_7fff) << 1 | first,
            ends,
            finite: zeros.simd_eq(zero).to_bitmask() == 0b1111,
            repeats: repeats != 0,
        }
    }

    /// Puts what is left into `points`, in its order, if all edges that change their region have one end in the window.
    #[inline(always)]
    pub(super) fn remains(
        &self,
        vertices: &Vertices,
        regions: Regions,
        points: &mut Room,
    ) -> Remains {
        let (changes, end_inside) = (regions.changes(), regions.end_inside());
        let crossings = changes.count_ones() as usize;
        let (mut upright, mut past_corner, mut doubtful, mut equal) = (0, 0, 0, 0);
        let mut before = f64x4::splat(self.simd, f64::NAN);
        let mut edges = changes;
        for at in (0..EDGES).step_by(4) {
            if at >= crossings {
                break;
            }
            // The next edge that crosses and the place of its crossing, after those before and the ends inside before;
            // when there is none left, anything, past the end.
            let mut next = |number: usize| {
                let edge = edges.trailing_zeros() as usize % EDGES;
                let before = (edges & edges.wrapping_neg()).wrapping_sub(1);
                let place = number + (end_inside & before).count_ones() as usize;
                edges &= edges.wrapping_sub(1);
                (edge, place % (2 * EDGES))
            };
            let [(i, i_place), (j, j_place)] = [next(at), next(at + 1)];
            let [(k, k_place), (l, l_place)] = [next(at + 2), next(at + 3)];
            let p = [vertices[i], vertices[j], vertices[k], vertices[l]];
            let q = [
                vertices[i + 1],
                vertices[j + 1],
                vertices[k + 1],
                vertices[l + 1],
            ];
            let four = self.cross(self.four(p), self.four(q));
            let (x, y): ([f64; 4], [f64; 4]) = (four.x.into(), four.y.into());
            points[i_place] = DVec2::new(x[0], y[0]);
            points[j_place] = DVec2::new(x[1], y[1]);
            points[k_place] = DVec2::new(x[2], y[2]);
            points[l_place] = DVec2::new(x[3], y[3]);
            upright |= four.upright << at;
            past_corner |= four.past_corner << at;
            doubtful |= four.doubtful << at;
            let same = before.slide::<3>(four.along).simd_eq(four.along);
            equal |= (same.to_bitmask() as u32) << at;
            before = four.along;
        }
        // Second ends inside, each after those before it and all crossings up to its edge's.
        let (mut rest, mut number) = (end_inside, 0);
        while rest != 0 {
            let up_to_here = rest ^ (rest - 1);
            let place = number + (changes & up_to_here).count_ones() as usize;
            points[place % (2 * EDGES)] = vertices[rest.trailing_zeros() as usize % EDGES + 1];
            rest &= rest - 1;
            number += 1;
        }
        let there = (1 << crossings) - 1;
        Remains {
            length: crossings + number,
            repeats: equal & there != 0,
            doubtful: doubtful & there != 0,
            crossings: crossings as u32,
            upright: upright & there,
            past_corner: past_corner & there,
        }
    }

    /// Where four edges, each with one end in the window, cross the border.
    #[inline(always)]
    fn cross(&self, [px, py]: [f64x4<S>; 2], [qx, qy]: [f64x4<S>; 2]) -> Four<S> {
        let right = self.max_x.simd_lt(px.max(qx));
        let above = self.max_y.simd_lt(py.max(qy));
        let beyond_x = right | px.min(qx).simd_lt(self.min_x);
        let beyond_y = above | py.min(qy).simd_lt(self.min_y);
        let x = right.select(self.max_x, self.min_x);
        let y = above.select(self.max_y, self.min_y);
        let past_corner = beyond_x & beyond_y;
        let (mut upright, mut doubtful) = (beyond_x, 0);
        if past_corner.any_true() {
            // Both lines are crossed; the side's is the one that is nearer to the inner end.
            let within_x = px.simd_ge(self.min_x) & px.simd_le(self.max_x);
            let inner = within_x & py.simd_ge(self.min_y) & py.simd_le(self.max_y);
            let (to_x, to_y) = (
                (x - inner.select(px, qx)).abs(),
                (y - inner.select(py, qy)).abs(),
            );
            let (to_x, to_y) = (to_x * (qy - py).abs(), to_y * (qx - px).abs());
            let size = to_x + to_y;
            // Each product has three roundings, and their difference one.
            let certain = (to_x - to_y).abs().simd_gt(size * (4.0 * f64::EPSILON))
                & size.simd_gt(1.0 / LARGE);
            upright = past_corner.select(to_x.simd_lt(to_y), beyond_x);
            doubtful = (past_corner & !certain).to_bitmask() as u32;
        }
        let c = upright.select(x, y);
        let across = [upright.select(px, py), upright.select(qx, qy)];
        let ends = [upright.select(py, px), upright.select(qy, qx)];
        let (along, certain) = several_at(c, across, ends);
        let at_end = c.simd_eq(across[0]) | c.simd_eq(across[1]);
        Four {
            x: upright.select(c, along),
            y: upright.select(along, c),
            along,
            upright: upright.to_bitmask() as u32,
            past_corner: past_corner.to_bitmask() as u32,
            doubtful: doubtful | (!certain | at_end).to_bitmask() as u32,
        }
    }
}

/// Four crossings; of the rest a bit for each, as in [`Remains`].
struct Four<S: Simd> {
    x: f64x4<S>,
    y: f64x4<S>,
    /// The place along its side.
    along: f64x4<S>,
    upright: u32,
    past_corner: u32,
    doubtful: u32,
}
