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
    use assess::{Inputs, show, show_number};
    use glam::{DVec3, IVec2, IVec3};

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
            let [a, b, c] = t.vertices.map(show);
            format!("{} {a} {b} {c}", t.colour)
        };
        triangles
            .iter()
            .map(one)
            .collect::<Vec<_>>()
            .join(", then ")
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
            let rows = buffers
                .colour
                .chunks(WIDTH)
                .map(|row| row.iter().collect::<String>());
            let got = rows.collect::<Vec<_>>().join("\n");
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
            .join("\n");
            assert!(
                got == want,
                "two crossing triangles, {order}: expected\n{want}\ngot\n{got}",
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
                    show_number(far),
                    show_number(*z),
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
            for pixel in 0..WIDTH * HEIGHT {
                let (i, j) = (pixel % WIDTH, pixel / WIDTH);
                let (c, z) = (colour[pixel], depth[pixel]);
                if !triangle.covers((i, j)) {
                    assert!(
                        c == '.',
                        "{what}: it does not cover pixel ({i}, {j}), and there is {c:?}"
                    );
                    continue;
                }
                assert!(
                    c == 'A',
                    "{what}: it covers pixel ({i}, {j}) alone, and there is {c:?}"
                );
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
                    "{what}: at pixel ({i}, {j}) its plane has z = {want}, the depth buffer {z}: every pixel has its own \
                     depth, that at its centre",
                );
            }
        }
    }

    #[test]
    fn any_scene_in_either_order() {
        let mut inputs = Inputs::new(52);
        for count in [2, 3, 5, 8].into_iter().cycle().take(100) {
            let mut triangles: Vec<_> = (0..count).map(|_| Quarters::any(&mut inputs)).collect();
            for order in ["", ", the same in the opposite order"] {
                let scene: Vec<_> = ('A'..).zip(&triangles).map(|(c, t)| t.colour(c)).collect();
                let Buffers { colour, .. } = drawn(&scene, WIDTH, HEIGHT, FAR);
                for (pixel, &got) in colour.iter().enumerate() {
                    let at = (pixel % WIDTH, pixel / WIDTH);
                    let nearer = |p: &Quarters, q: &Quarters| {
                        let ([n, d], [m, e]) = (p.depth(at), q.depth(at));
                        (n * e).cmp(&(m * d))
                    };
                    let here = ('A'..).zip(&triangles).filter(|(_, t)| t.covers(at));
                    let nearest = here.clone().min_by(|(_, p), (_, q)| nearer(p, q));
                    let want = nearest.map_or('.', |(c, _)| c);
                    // Equal depths are for another test.
                    let equal = |t: &Quarters| nearest.is_some_and(|(_, n)| nearer(n, t).is_eq());
                    if here.filter(|(_, t)| equal(t)).count() < 2 {
                        assert!(
                            got == want,
                            "{}{order}: at pixel {at:?} the nearest is {want}, but there is {got}",
                            name(&scene),
                        );
                    }
                }
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
                assert!(
                    z == 7.0,
                    "{what}: at pixel ({i}, {j}) the depth buffer holds {z} instead of 7"
                );
                assert!(
                    c != 'B',
                    "{what}: both are at z = 7, and pixel ({i}, {j}) shows B, which came later: a tie keeps the first, for \
                     only what is strictly nearer passes",
                );
            }
        }
    }

    #[test]
    fn nearer_by_next_to_nothing() {
        let level = |z, colour| {
            let mut triangle =
                Quarters([(1, 1, 0), (79, 1, 0), (1, 39, 0)].map(IVec3::from)).colour(colour);
            for v in &mut triangle.vertices {
                v.z = z;
            }
            triangle
        };
        for z in [7.0, 1e-9, -1e-300] {
            // Far less than any tolerance in use, far more than any formula for z rounds.
            let scene = [level(z, 'A'), level(z - 1e-12 * z.abs(), 'B')];
            let Buffers { colour, .. } = drawn(&scene, WIDTH, HEIGHT, FAR);
            let (i, j) = scene[0].pixels[0];
            assert!(
                colour[i + j * WIDTH] == 'B',
                "A at z = {}, then B nearer by a 10¹²th of that: at pixel ({i}, {j}) B is nearest, for z < depth has no \
                 tolerance, but there is {}",
                show_number(z),
                colour[i + j * WIDTH],
            );
        }
    }

    #[test]
    fn at_the_far_distance_and_huge() {
        let mut level = Quarters([(1, 1, 0), (79, 1, 0), (1, 39, 0)].map(IVec3::from)).colour('A');
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
                show_number(z),
                show_number(far),
            );
        }
    }
}
