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
    let mut colour = vec!['.'; width * height];
    let mut depth = vec![far; width * height];
    for triangle in triangles {
        let [a, b, c] = triangle.vertices;
        let n = (b - a).cross(c - a);
        for &(i, j) in &triangle.pixels {
            let (x, y) = (i as f64 + 0.5, j as f64 + 0.5);
            let z = a.z - (n.x * (x - a.x) + n.y * (y - a.y)) / n.z;
            let pixel = i + j * width;
            if z < depth[pixel] {
                depth[pixel] = z;
                colour[pixel] = triangle.colour;
            }
        }
    }
    Buffers { colour, depth }
}

fn main() {}
