use glam::DVec3;

/// A triangle after projection and scan-conversion.
struct Triangle {
    /// A, B, C: x and y in pixels, z the depth: the distance from the viewer in a parallel view.
    vertices: [DVec3; 3],
    colour: char,
    /// The pixels (i, j) that it covers, all inside the picture.
    pixels: Vec<(usize, usize)>,
}

/// The frame buffer and the depth buffer, row after row: pixel (i, j) is element i + j · width.
struct Buffers {
    colour: Vec<char>,
    depth: Vec<f64>,
}

/// The picture of some triangles by the z-buffer algorithm, in the order given.
///
/// ```text
/// before:              colour '.' and depth `far` everywhere
/// for each triangle, for each of its pixels (i, j):
///     z < depth(i, j)  ⇒  depth(i, j) = z,  colour(i, j) = the triangle's
///
/// z at the pixel's centre x = i + ½, y = j + ½, on the plane of the triangle:
///
/// n = AB × AC          z = A_z − (n_x (x − A_x) + n_y (y − A_y)) / n_z
/// ```
///
/// `far` is the largest distance. At equal depth the triangle that came first stays. No triangle is edge-on: n_z ≠ 0.
/// Rounding may move z by 3·10⁻¹⁰ where all coordinates are at most 100.
///
/// Grafica 3, Algoritmo Z-Buffer.
fn draw(triangles: &[Triangle], width: usize, height: usize, far: f64) -> Buffers {
    // TODO: the two buffers as they are before; then the test at each pixel.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod hsr2_z_buffer {
    use super::{Buffers, Triangle, draw};
    use assess::{Ink, Inputs, Panel, Picture, brief, brief_number};
    use glam::{DVec2, DVec3, IVec2, IVec3};

    const WIDTH: usize = 20;
    const HEIGHT: usize = 10;
    const FAR: f64 = 100.0;

    /// A triangle whose x and y are whole quarters of a pixel and whose z are whole: what it covers, and how deep it is
    /// there, is known in whole numbers.
    #[derive(Clone, Copy)]
    struct Quarters([IVec3; 3]);

    impl Quarters {
        /// Odd quarters, so that its edges pass no centre.
        fn any(inputs: &mut Inputs) -> Self {
            loop {
                let mut odd = |max: usize| 2 * inputs.integer(0, 2 * max as i32 - 1) + 1;
                let corners = [(); 3].map(|()| (odd(WIDTH), odd(HEIGHT)));
                let triangle = Self(corners.map(|(x, y)| IVec3::new(x, y, inputs.integer(1, 99))));
                if triangle.normal().z != 0 && !triangle.pixels().is_empty() {
                    return triangle;
                }
            }
        }

        fn normal(self) -> IVec3 {
            let [a, b, c] = self.0;
            (b - a).cross(c - a)
        }

        fn covers(self, (i, j): (usize, usize)) -> bool {
            let p = IVec2::new(4 * i as i32 + 2, 4 * j as i32 + 2);
            let side = |k: usize| {
                let [a, b] = [self.0[k], self.0[(k + 1) % 3]].map(IVec3::truncate);
                (b - a).perp_dot(p - a).signum()
            };
            side(0) == side(1) && side(1) == side(2)
        }

        fn pixels(self) -> Vec<(usize, usize)> {
            let all = (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| (i, j)));
            all.filter(|&pixel| self.covers(pixel)).collect()
        }

        /// The depth at a centre as a fraction, the denominator positive.
        fn depth(self, (i, j): (usize, usize)) -> [i64; 2] {
            let [n, a] = [self.normal(), self.0[0]].map(|v| v.to_array().map(i64::from));
            let (x, y) = (4 * i as i64 + 2, 4 * j as i64 + 2);
            let numerator = a[2] * n[2] - n[0] * (x - a[0]) - n[1] * (y - a[1]);
            [numerator * n[2].signum(), n[2].abs()]
        }

        fn colour(self, colour: char) -> Triangle {
            Triangle {
                vertices: self.0.map(|v| v.as_dvec3() / DVec3::new(4.0, 4.0, 1.0)),
                colour,
                pixels: self.pixels(),
            }
        }
    }

    fn name(triangles: &[Triangle]) -> String {
        let one = |t: &Triangle| {
            let [a, b, c] = t.vertices.map(brief);
            format!("{} {a} {b} {c}", t.colour)
        };
        let first: Vec<String> = triangles.iter().take(4).map(one).collect();
        let more = if triangles.len() > 4 { ", …" } else { "" };
        format!("{}{more}", first.join(", then "))
    }

    /// The colours of a picture, a letter a pixel.
    fn panel(colours: &[char]) -> Panel {
        let mut panel = Panel::pixels();
        for (pixel, &c) in colours.iter().enumerate() {
            let (i, j) = ((pixel % WIDTH) as i32, (pixel / WIDTH) as i32);
            match c {
                'A'..='Z' => panel.pixel(i, j, Ink::Shade(c as usize - 'A' as usize)),
                '.' => {}
                _ => panel.pixel(i, j, Ink::Extra),
            }
        }
        // The corners of the picture, so that both halves have one scale.
        let all = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)];
        let corners = all.map(|(x, y)| DVec2::new(x as f64, y as f64));
        panel.polygon(&corners, Ink::Faint);
        panel
    }

    /// Fails unless the picture is the one that is wanted, wherever that is known.
    #[track_caller]
    fn compare(what: &str, got: &[char], want: &[Option<char>]) {
        let wrong = |at: &dyn Fn(usize, usize) -> usize| {
            let differs = |&pixel: &usize| {
                let there = got.get(at(pixel % WIDTH, pixel / WIDTH));
                want[pixel].is_some_and(|want| there != Some(&want))
            };
            let mut all = (0..want.len()).filter(differs);
            all.next().map(|first| (first, 1 + all.count()))
        };
        let Some((first, count)) = wrong(&|i, j| i + j * WIDTH) else {
            return;
        };
        let right: Vec<char> = want.iter().map(|c| c.unwrap_or('.')).collect();
        let _picture = Picture::beside(panel(got), panel(&right));
        assert!(
            got.iter().any(|&c| c != '.'),
            "{what}: nothing is drawn, the frame buffer holds the background alone",
        );
        assert!(
            wrong(&|i, j| i + (HEIGHT - 1 - j) * WIDTH).is_some(),
            "{what}: the picture is upside down: pixel (i, j) is element i + j · width",
        );
        assert!(
            wrong(&|i, j| j + i * HEIGHT).is_some(),
            "{what}: rows and columns are exchanged: pixel (i, j) is element i + j · width, not j + i · height",
        );
        let row = first / WIDTH * WIDTH..(first / WIDTH + 1) * WIDTH;
        let line = |colours: &[char]| colours[row.clone()].iter().collect::<String>();
        panic!(
            "{what}: {count} of {} pixels are wrong, the first is ({}, {}): the nearest there is {}, but there is {}\n{} \
             expected in this row\n{} got",
            want.len(),
            first % WIDTH,
            first / WIDTH,
            right[first],
            got[first],
            line(&right),
            line(got),
        );
    }

    fn drawn(triangles: &[Triangle], width: usize, height: usize, far: f64) -> Buffers {
        let buffers = draw(triangles, width, height, far);
        let pixels = width * height;
        assert!(
            (buffers.colour.len(), buffers.depth.len()) == (pixels, pixels),
            "the picture has {pixels} pixels, the frame buffer {} and the depth buffer {}: all are of one size",
            buffers.colour.len(),
            buffers.depth.len(),
        );
        buffers
    }

    #[test]
    fn crossing_triangles() {
        // Each is nearer than the other on a part of what they share.
        let a = Quarters([(4, 1, 10), (79, 20, 10), (4, 39, 2)].map(IVec3::from));
        let b = Quarters([(76, 1, 2), (76, 39, 10), (1, 20, 10)].map(IVec3::from));
        for (scene, order) in [
            ([a.colour('A'), b.colour('B')], "A before B"),
            ([b.colour('B'), a.colour('A')], "B before A"),
        ] {
            let buffers = drawn(&scene, WIDTH, HEIGHT, FAR);
            let want = [
                ".A................B.",
                ".AAAAA........BBBBB.",
                ".AAAAAAAAABBBBBBBBB.",
                ".AAAAABBBBBBBBBBBBB.",
                ".AAAAAAABBBBBBBBBBB.",
                ".AAAAAAAAAAABBBBBBB.",
                ".AAAAAAAAAAAAABBBBB.",
                ".AAAAAAAAABBBBBBBBB.",
                ".AAAAA........BBBBB.",
                ".A................B.",
            ]
            .concat();
            let want: Vec<_> = want.chars().map(Some).collect();
            compare(
                &format!("two crossing triangles, {order}"),
                &buffers.colour,
                &want,
            );
        }
    }

    #[test]
    fn nothing_drawn() {
        for far in [FAR, 1.0, 1e300] {
            let Buffers { colour, depth } = drawn(&[], WIDTH, HEIGHT, far);
            assert!(
                colour.iter().all(|&c| c == '.'),
                "no triangle: the background everywhere"
            );
            if let Some(z) = depth.iter().find(|&&z| z != far) {
                panic!(
                    "no triangle: the depth buffer is initialised to the far distance, {}, but holds {}: what is to be \
                     nearer than that?",
                    brief_number(far),
                    brief_number(*z),
                );
            }
        }
        drawn(&[], 0, 0, FAR);
    }

    #[test]
    fn one_triangle() {
        let mut inputs = Inputs::new(51);
        for _ in 0..150 {
            let triangle = Quarters::any(&mut inputs);
            let scene = [triangle.colour('A')];
            let Buffers { colour, depth } = drawn(&scene, WIDTH, HEIGHT, FAR);
            let what = name(&scene);
            let all = (0..WIDTH * HEIGHT).map(|pixel| (pixel % WIDTH, pixel / WIDTH));
            let want: Vec<_> = all
                .map(|at| Some(if triangle.covers(at) { 'A' } else { '.' }))
                .collect();
            compare(&what, &colour, &want);
            for pixel in 0..WIDTH * HEIGHT {
                let (i, j) = (pixel % WIDTH, pixel / WIDTH);
                let (c, z) = (colour[pixel], depth[pixel]);
                if c != 'A' {
                    continue;
                }
                assert!(
                    z != FAR,
                    "{what}: pixel ({i}, {j}) shows A, but the depth buffer still holds the far distance: whatever comes \
                     next will be taken for nearer",
                );
                let [numerator, denominator] = triangle.depth((i, j));
                let want = numerator as f64 / denominator as f64;
                // In quarters n_x is up to 2 · 98 · 80, x − A_x up to 80, and n_z 4 at least: a few roundings of that.
                let bound = 4.0 * f64::EPSILON * 2.0 * 98.0 * 80.0 * 80.0 / 4.0;
                assert!(
                    (z - want).abs() <= bound,
                    "{what}: at pixel ({i}, {j}) its plane has z = {}, the depth buffer {}, {} away: every pixel has its own \
                     depth, that at its centre, in f64",
                    brief_number(want),
                    brief_number(z),
                    brief_number((z - want).abs()),
                );
            }
        }
    }

    #[test]
    fn any_scene_in_either_order() {
        let mut inputs = Inputs::new(52);
        for count in [2, 3, 5, 8].into_iter().flat_map(|count| [count; 25]) {
            let mut triangles: Vec<_> = (0..count).map(|_| Quarters::any(&mut inputs)).collect();
            for order in ["", ", the same in the opposite order"] {
                let scene: Vec<_> = ('A'..).zip(&triangles).map(|(c, t)| t.colour(c)).collect();
                let Buffers { colour, .. } = drawn(&scene, WIDTH, HEIGHT, FAR);
                let want = |pixel: usize| {
                    let at = (pixel % WIDTH, pixel / WIDTH);
                    let nearer = |p: &Quarters, q: &Quarters| {
                        let ([n, d], [m, e]) = (p.depth(at), q.depth(at));
                        (n * e).cmp(&(m * d))
                    };
                    let here = ('A'..).zip(&triangles).filter(|(_, t)| t.covers(at));
                    let nearest = here.clone().min_by(|(_, p), (_, q)| nearer(p, q));
                    // Equal depths are for another test.
                    let equal = |t: &Quarters| nearest.is_some_and(|(_, n)| nearer(n, t).is_eq());
                    let is_tie = here.filter(|(_, t)| equal(t)).count() > 1;
                    (!is_tie).then(|| nearest.map_or('.', |(c, _)| c))
                };
                let want: Vec<_> = (0..WIDTH * HEIGHT).map(want).collect();
                compare(&format!("{}{order}", name(&scene)), &colour, &want);
                triangles.reverse();
            }
        }
    }

    #[test]
    fn ties() {
        let mut inputs = Inputs::new(53);
        for _ in 0..100 {
            // Level, so that the depth is z itself, and twice the same.
            let mut triangle = Quarters::any(&mut inputs);
            for v in &mut triangle.0 {
                v.z = 7;
            }
            let scene = [triangle.colour('A'), triangle.colour('B')];
            let Buffers { colour, depth } = drawn(&scene, WIDTH, HEIGHT, FAR);
            let what = name(&scene);
            for &(i, j) in &scene[0].pixels {
                let (c, z) = (colour[i + j * WIDTH], depth[i + j * WIDTH]);
                // Weights that add up to 1 but for a rounding are as right as the plane.
                assert!(
                    (z - 7.0).abs() <= 64.0 * f64::EPSILON * 7.0,
                    "{what}: at pixel ({i}, {j}) the depth buffer holds {} instead of 7",
                    brief_number(z),
                );
                assert!(
                    c != '.',
                    "{what}: at pixel ({i}, {j}) both are at z = 7, nearer than the far distance, but nothing is drawn",
                );
                assert!(
                    c != 'B',
                    "{what}: both are at z = 7, and pixel ({i}, {j}) shows B, which came later: a tie keeps the first, for \
                     only what is strictly nearer passes",
                );
            }
        }
    }

    /// Sides of powers of two: also weights made of areas are exact, and a level depth is that depth.
    fn level_triangle() -> Quarters {
        Quarters([(0, 0, 0), (64, 0, 0), (0, 32, 0)].map(IVec3::from))
    }

    #[test]
    fn nearer_by_next_to_nothing() {
        let level = |z, colour| {
            let mut triangle = level_triangle().colour(colour);
            for v in &mut triangle.vertices {
                v.z = z;
            }
            triangle
        };
        for z in [7.0_f64, 1e-9, -1e-300] {
            // Half as far first, which is no matter of a tolerance.
            for nearer in [z - 0.5 * z.abs(), z - 1e-3 * z.abs()] {
                let scene = [level(z, 'A'), level(nearer, 'B')];
                let Buffers { colour, .. } = drawn(&scene, WIDTH, HEIGHT, FAR);
                let (i, j) = scene[0].pixels[0];
                let got = colour[i + j * WIDTH];
                assert!(
                    got == 'B',
                    "A at z = {}, then B at z = {} over it: at pixel ({i}, {j}) B is nearest, but there is {got}",
                    brief_number(z),
                    brief_number(nearer),
                );
            }
            // Far less than any tolerance in use, far more than any formula for z rounds.
            let scene = [level(z, 'A'), level(z - 1e-12 * z.abs(), 'B')];
            let Buffers { colour, .. } = drawn(&scene, WIDTH, HEIGHT, FAR);
            let (i, j) = scene[0].pixels[0];
            assert!(
                colour[i + j * WIDTH] == 'B',
                "A at z = {}, then B nearer by a 10¹²th of that: at pixel ({i}, {j}) B is nearest, for z < depth has no \
                 tolerance, but there is {}",
                brief_number(z),
                colour[i + j * WIDTH],
            );
        }
    }

    #[test]
    fn at_the_far_distance_and_huge() {
        let mut level = level_triangle().colour('A');
        for (z, far, seen) in [
            (99.0, 100.0, true),
            (100.0, 100.0, false),
            (101.0, 100.0, false),
            (1e300, 1e301, true),
            (-1e300, 0.0, true),
            (1e300, f64::INFINITY, true),
        ] {
            for v in &mut level.vertices {
                v.z = z;
            }
            let Buffers { colour, .. } = drawn(std::slice::from_ref(&level), WIDTH, HEIGHT, far);
            let (i, j) = level.pixels[0];
            let got = colour[i + j * WIDTH] == 'A';
            let verdict = if seen {
                "nearer, and seen"
            } else {
                "not nearer, and not seen"
            };
            assert!(
                got == seen,
                "a triangle at z = {}, the far distance {}: it is {verdict}",
                brief_number(z),
                brief_number(far),
            );
        }
    }
}
