//! Many edges at once: blocks in which the polygon goes in and out of the window through one side at a time.

use fearless_simd::Simd;
use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::block::{EDGES, Lines, Regions, Room, Vertices};
use super::{ABOVE, ABOVE_OR_BELOW, Pipeline, Point, RIGHT_OR_LEFT};
use crate::cohen_sutherland::{Outcode, outcode};

impl Pipeline<'_> {
    /// Follows the polygon from its first vertex on, of the region `code`, block by block. The answer is where that
    /// ends: the region of a vertex, with this vertex and those after it, too few for a block; or `None` if a coordinate
    /// is not finite.
    #[inline(always)]
    pub(in crate::sutherland_hodgman::fast) fn blocks<'p, S: Simd>(
        &mut self,
        simd: S,
        mut code: Outcode,
        polygon: &'p [DVec2],
        work: &mut impl Count,
    ) -> Option<(Outcode, &'p [DVec2])> {
        let lines = Lines::new(simd, self.window);
        let mut room = [DVec2::ZERO; 2 * EDGES];
        let mut rest = polygon;
        while let Some(vertices) = rest.first_chunk() {
            let regions = lines.regions(vertices, code);
            if !regions.finite {
                return None;
            }
            let next = outcode(self.window, vertices[EDGES]);
            if !self.block(&lines, vertices, regions, [code, next], &mut room, work) {
                self.one_by_one(code, vertices, work);
            }
            code = next;
            rest = rest.get(EDGES..).unwrap_or_default();
        }
        Some((code, rest))
    }

    /// The edges of a block, unless they want a closer look: whether it was done.
    #[inline(always)]
    fn block<S: Simd>(
        &mut self,
        lines: &Lines<S>,
        vertices: &Vertices,
        regions: Regions,
        [first, last]: [Outcode; 2],
        room: &mut Room,
        work: &mut impl Count,
    ) -> bool {
        let changes = regions.changes();
        if changes == 0 {
            // All in one region.
            if last.is_inside() {
                self.append(&vertices[1..], regions.repeats);
            }
        } else {
            let Some(before) = self.last else {
                return false;
            };
            // Where the polygon is outside it stays in one region, ...
            let outside = regions.start_outside() & !regions.end_inside();
            let out_by = before.code & RIGHT_OR_LEFT;
            if outside & changes != 0 || (out_by != 0 && out_by != first.bits() & RIGHT_OR_LEFT) {
                return false;
            }
            let remains = lines.remains(vertices, regions, room);
            // ... and comes in through the side through which it went out: ways out and in take turns.
            let entries = if first.is_inside() { 0xaaaa } else { 0x5555 };
            let turned = remains.upright ^ (remains.upright << 1 | u32::from(out_by != 0));
            let there = (1 << remains.crossings) - 1;
            if remains.doubtful || turned & entries & there != 0 {
                return false;
            }
            let points = room.get(..remains.length).unwrap_or_default();
            let again = self.out.points.last() == points.first();
            self.append(points, regions.repeats || remains.repeats || again);
            if last.bits() & ABOVE_OR_BELOW != 0 {
                let upright = remains.upright >> (remains.crossings - 1) & 1 != 0;
                self.last = Some(self.left_by(upright, last));
            }
            let compared = u64::from(remains.past_corner.count_ones());
            work.add(Counter::Comparisons, compared);
            work.add(Counter::Multiplications, 2 * compared);
            work.add(Counter::Divisions, u64::from(remains.crossings));
        }
        if last.bits() & ABOVE_OR_BELOW == 0 {
            self.last = Some(Point::vertex(vertices[EDGES], last.bits(), true));
        }
        work.add(Counter::Vertices, EDGES as u64);
        work.add(Counter::Comparisons, 4 * EDGES as u64);
        true
    }

    /// Appends points to the answer; `repeats` if some may equal the one before it.
    #[inline(always)]
    fn append(&mut self, points: &[DVec2], repeats: bool) {
        self.out.append(points, !repeats);
        if !self.out.is_settled() {
            self.settle();
        }
    }

    /// The last point in the strip between the lines above and below, when an edge has left it for the region `code`.
    fn left_by(&self, upright: bool, code: Outcode) -> Point {
        let [min, max] = [self.window.min.y, self.window.max.y];
        let above = code.bits() & ABOVE != 0;
        Point {
            code: code.bits() & if upright { RIGHT_OR_LEFT } else { 0 },
            y: if above { max } else { min } + 0.0,
            x: f64::NAN,
            along_edge: true,
        }
    }
}

#[cfg(test)]
mod tests;
