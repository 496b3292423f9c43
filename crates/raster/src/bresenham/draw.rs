//! A segment into a picture: the same pixels, faster.

use ombra_math::glam::IVec2;

use super::{Pixels, clipped};

/// Sets the pixels of the segment from `a` to `b` that lie in the picture to `value`.
///
/// `pixels` holds the picture row after row, each `width` long; a last row that is not complete does not belong to it.
///
/// # Formula
///
/// ```text
/// pixels[y · width + x] = value
/// for each (x, y) of clipped(a, b, (0, 0), (width − 1, height − 1))
/// ```
///
/// # Properties
///
/// - Exactly the pixels of [`clipped`], in whichever of three ways is fastest:
///   - one by one, as [`Pixels`] come;
///   - in 64-bit fixed point: the fraction of y plus m carries out exactly where d > 0, and an addition with carry
///     is a shorter way from one pixel to the next than a comparison and a choice;
///   - for m ≤ ⅛, run after run: the lengths ⌊dx/dy⌋ and ⌊dx/dy⌋ + 1 of whole rows alternate by the same rule as E
///     and NE, one level up.
/// - Any points; no width, or none but incomplete rows, is no picture and gets nothing.
///
/// # Pitfalls
///
/// The last argument to go wrong is `width`: it counts elements of `pixels`, not bytes. Of a picture of several
/// channels, pass pixels (`as_chunks_mut::<4>().0`), not samples.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::bresenham;
///
/// let mut picture = [b'.'; 9 * 4];
/// bresenham::draw(&mut picture, 9, IVec2::ZERO, IVec2::new(8, 3), b'#');
/// assert_eq!(&picture[..9], b"##.......");
/// assert_eq!(&picture[9..18], b"..###....");
/// assert_eq!(&picture[18..27], b".....##..");
/// assert_eq!(&picture[27..], b".......##");
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo di Bresenham». J. E. Bresenham, Run length slice algorithm for incremental lines, in:
/// Fundamental Algorithms for Computer Graphics (1985).
pub fn draw<T: Copy>(pixels: &mut [T], width: usize, a: IVec2, b: IVec2, value: T) {
    let Some(height) = pixels.len().checked_div(width) else {
        return;
    };
    if height == 0 {
        return;
    }
    let max = IVec2::new(last(width), last(height));
    let inside = clipped(a, b, IVec2::ZERO, max);
    let (dx2, dy2) = (inside.after_e - inside.after_ne, inside.after_e);
    let flat = inside.east.y == 0;
    // Rows a multiple of 1 KiB apart meet in few sets of the cache, where steep stores that come faster than they
    // can be written drive one another out: there the slower way is the faster one.
    let crowded = !flat && width.wrapping_mul(size_of::<T>()).is_multiple_of(1024);
    // Divisions to begin with must pay.
    let long = inside.left >= 32;
    if long && flat && 8 * dy2 <= dx2 {
        runs(pixels, width, inside, value);
    } else if long && !crowded && dy2 < dx2 && inside.left < FIXED_POINT_LIMIT {
        fixed_point(pixels, width, inside, value);
    } else {
        one_by_one(pixels, width, inside, value);
    }
}

/// The last coordinate of a side of `size` > 0 pixels that a pixel can have.
fn last(size: usize) -> i32 {
    i32::try_from(size - 1).unwrap_or(i32::MAX)
}

/// Where `p` is in a picture of rows of `width`; where a move `p` leads, modulo the size of memory.
fn offset(p: IVec2, width: usize) -> usize {
    (p.y as usize)
        .wrapping_mul(width)
        .wrapping_add(p.x as usize)
}

fn one_by_one<T: Copy>(pixels: &mut [T], width: usize, inside: Pixels, value: T) {
    inside.for_each(|p| {
        if let Some(pixel) = pixels.get_mut(offset(p, width)) {
            *pixel = value;
        }
    });
}

/// Below this number of pixels fixed point is exact.
///
/// The fraction after i moves is cut off at 2⁻⁶⁴ at most i + 1 times. It decides rightly while that is less than the
/// 1/(4dx) that separates it from a whole: 4dx (i + 1) < 2⁶⁴, and dx < 2³².
const FIXED_POINT_LIMIT: u64 = 1 << 30;

fn fixed_point<T: Copy>(pixels: &mut [T], width: usize, inside: Pixels, value: T) {
    // A decision lies in (2dy − 2dx, 2dy]. Its distance from the lower end, as a share of 2dx, grows by m with each
    // move and passes 1 exactly where 2d > 0; half a unit less keeps equality (the tie) below 1.
    let (dx2, dy2) = (
        (inside.after_e - inside.after_ne) as u128,
        inside.after_e as u128,
    );
    let above = (inside.decision() - inside.after_ne) as u128;
    let mut fraction = (((2 * above - 1) << 63) / dx2) as u64;
    let m = ((dy2 << 64) / dx2) as u64;

    let mut at = offset(inside.pixel, width);
    let east = offset(inside.east, width);
    let north_east = east.wrapping_add(offset(inside.north, width));
    for _ in 0..inside.left {
        if let Some(pixel) = pixels.get_mut(at) {
            *pixel = value;
        }
        let (sum, carry) = fraction.overflowing_add(m);
        fraction = sum;
        at = at.wrapping_add(if carry { north_east } else { east });
    }
}

/// Row after row, for segments with more columns than rows.
fn runs<T: Copy>(pixels: &mut [T], width: usize, inside: Pixels, value: T) {
    let (dx2, dy2) = (inside.after_e - inside.after_ne, inside.after_e);
    let rightwards = inside.east.x > 0;
    let up = offset(inside.north, width);
    let mut at = offset(inside.pixel, width);
    let mut left = inside.left;

    // The first run: E until the decision, raised by 2dy each time, exceeds 0. A level segment never gets there.
    let (mut length, mut d) = (left, 0);
    if dy2 > 0 {
        let moves_e = if inside.decision() > 0 {
            0
        } else {
            -inside.decision() / dy2 + 1
        };
        length = moves_e as u64 + 1;
        d = inside.decision() + dy2 * moves_e;
    }
    // The decision that ends a run lies in (0, 2dy]; it says how long the next one is.
    let (whole, rest) = (
        dx2.checked_div(dy2).unwrap_or(0),
        dx2.checked_rem(dy2).unwrap_or(0),
    );
    while left > 0 {
        let n = length.min(left) as usize;
        let first = if rightwards {
            at
        } else {
            at.wrapping_sub(n - 1)
        };
        if let Some(run) = pixels.get_mut(first..first.wrapping_add(n)) {
            run.fill(value);
        }
        left -= n as u64;
        let beyond = if rightwards {
            at.wrapping_add(n)
        } else {
            at.wrapping_sub(n)
        };
        at = beyond.wrapping_add(up);
        let longer = d <= rest;
        length = whole as u64 + u64::from(longer);
        d += if longer { dy2 - rest } else { -rest };
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::glam::Vec2Swizzles;
    use proptest::prelude::*;

    use super::*;
    use crate::bresenham::segment;

    /// The plain form: the whole segment, pixel after pixel.
    fn plainly(pixels: &mut [u8], width: usize, a: IVec2, b: IVec2) {
        let height = pixels.len() / width;
        for p in segment(a, b) {
            let (x, y) = (p.x as usize, p.y as usize);
            if p.x >= 0 && p.y >= 0 && x < width && y < height {
                pixels[y * width + x] = 1;
            }
        }
    }

    fn compare(width: usize, height: usize, a: IVec2, b: IVec2) {
        let mut fast = vec![0_u8; width * height];
        let mut plain = fast.clone();
        draw(&mut fast, width, a, b, 1);
        plainly(&mut plain, width, a, b);
        assert_eq!(fast, plain, "{a} to {b} in {width}×{height}");
    }

    #[test]
    fn every_short_segment_over_a_small_picture() {
        for i in 0..13_i32.pow(4) {
            let at = |n: i32| i / 13_i32.pow(n as u32) % 13 - 3;
            compare(7, 6, IVec2::new(at(0), at(1)), IVec2::new(at(2), at(3)));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// Wide enough for fixed point and long runs; every second width crowds the cache.
        #[test]
        fn draws_the_pixels_of_the_segment(
            width in prop::sample::select(vec![1_usize, 37, 300, 512, 1024]),
            height in 1..300_usize,
            a in prop::array::uniform2(-900..1900_i32),
            b in prop::array::uniform2(-900..1900_i32),
            flatten in 1..30_i32,
            turn: bool,
        ) {
            let flat = |p: [i32; 2]| IVec2::new(p[0], p[1] / flatten);
            let turned = |p: IVec2| if turn { p.yx() } else { p };
            compare(width, height, turned(flat(a)), turned(flat(b)));
        }

        /// Far ends: compared with the pixels that `clipped` gives, which has tests of its own.
        #[test]
        fn draws_what_is_inside_of_the_longest(
            a: [i32; 2], through in prop::array::uniform2(0..200_i32), stretch in 1..1 << 24, flatten in 0..31_u32,
        ) {
            let through = IVec2::from(through);
            let a = IVec2::new(a[0], a[1] >> flatten);
            let beyond = through.saturating_add((through.saturating_sub(a) / 128).saturating_mul(IVec2::splat(stretch)));
            for (a, b) in [(a, beyond), (a.yx(), beyond.yx())] {
                let mut fast = vec![0_u8; 200 * 190];
                let mut plain = fast.clone();
                draw(&mut fast, 200, a, b, 1);
                for p in clipped(a, b, IVec2::ZERO, IVec2::new(199, 189)) {
                    plain[p.y as usize * 200 + p.x as usize] = 1;
                }
                prop_assert_eq!(&fast, &plain);
            }
        }
    }

    /// 1/m modulo n, if there is one.
    fn inverse(m: i64, n: i64) -> Option<i64> {
        let (mut r, mut t) = ((n, m), (0, 1));
        while r.1 != 0 {
            let q = r.0 / r.1;
            (r, t) = ((r.1, r.0 - q * r.1), (t.1, t.0 - q * t.1));
        }
        (r.0 == 1).then(|| t.0.rem_euclid(n))
    }

    proptest! {
        /// A tie or the least that is above one, 1/(2dx), in the middle of the picture and far from both ends.
        #[test]
        fn fixed_point_decides_the_closest_calls(
            i in 1_000_000_i64..1 << 30, half in (1_i64 << 29) + 300..1 << 30, rise in any::<i64>(), tie: bool,
        ) {
            // 2 dy i = 1 modulo dx, both odd: dy i / dx = k + ½ + 1/(2dx). With dx = 2i and dy odd: k + ½.
            let dx = if tie { 2 * i } else { 2 * half + 1 };
            let dy = if tie { rise.rem_euclid(i) | 1 } else {
                let Some(dy) = inverse(2 * i % dx, dx) else { return Ok(()) };
                dy
            };
            let k = dy * i / dx;
            let a = IVec2::new((300 - i) as i32, (300 - k) as i32);
            let b = IVec2::new((300 - i + dx) as i32, (300 - k + dy) as i32);
            let mut picture = vec![0_u8; 600 * 600];
            draw(&mut picture, 600, a, b, 1);
            let above = i64::from(!tie) * 600;
            prop_assert_eq!(picture[(300 * 600 + 300 + above) as usize], 1, "{} to {}", a, b);
            let mut plain = vec![0_u8; 600 * 600];
            for p in clipped(a, b, IVec2::ZERO, IVec2::splat(599)) {
                plain[p.y as usize * 600 + p.x as usize] = 1;
            }
            prop_assert_eq!(picture, plain);
        }
    }

    #[test]
    fn diagonals() {
        for (x, y) in [(0, 0), (99, 0), (0, 99), (99, 99), (-40, 0), (99, 150)] {
            for length in [98, 99, 100, 300] {
                let a = IVec2::new(x, y);
                for towards in [
                    IVec2::ONE,
                    IVec2::NEG_ONE,
                    IVec2::new(1, -1),
                    IVec2::new(-1, 1),
                ] {
                    compare(100, 100, a, a + towards * length);
                }
            }
        }
    }

    #[test]
    fn extremes() {
        let whole = (IVec2::MIN, IVec2::MAX);
        draw(&mut [0_u8; 0], 0, whole.0, whole.1, 1);
        draw(&mut [0_u8; 0], 5, whole.0, whole.1, 1);
        let mut no_rows = [0; 5];
        draw(&mut no_rows, 0, IVec2::ZERO, IVec2::ONE, 1);
        draw(&mut no_rows, 6, IVec2::ZERO, IVec2::ONE, 1);
        draw(&mut no_rows, usize::MAX, IVec2::ZERO, IVec2::ONE, 1);
        assert_eq!(no_rows, [0; 5]);

        let mut incomplete = [0; 8];
        draw(&mut incomplete, 3, IVec2::new(0, 0), IVec2::new(0, 9), 1);
        assert_eq!(incomplete, [1, 0, 0, 1, 0, 0, 0, 0]);

        let mut diagonal = [0; 9];
        draw(&mut diagonal, 3, whole.0, whole.1, 1);
        assert_eq!(diagonal, [1, 0, 0, 0, 1, 0, 0, 0, 1]);
        draw(
            &mut diagonal,
            3,
            IVec2::new(i32::MIN, 1),
            IVec2::new(i32::MAX, 1),
            2,
        );
        draw(
            &mut diagonal,
            3,
            IVec2::new(2, i32::MAX),
            IVec2::new(2, i32::MIN),
            3,
        );
        assert_eq!(diagonal, [1, 0, 3, 2, 2, 3, 0, 0, 3]);

        // Nothing to store, and more of it than memory has bytes.
        let mut nothing = vec![(); usize::MAX];
        draw(
            &mut nothing,
            1 << 20,
            IVec2::new(i32::MIN, 7),
            IVec2::new(i32::MAX, 7),
            (),
        );
        draw(
            &mut nothing,
            1 << 20,
            IVec2::new(3, 5),
            IVec2::new(1 << 10, 1 << 20),
            (),
        );
    }
}
