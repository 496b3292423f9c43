// right: the slopes of the depth, from another corner
use glam::DVec3;

struct Triangle {
    /// A, B, C: x and y in pixels, z the depth: the distance from the viewer in a parallel view.
    vertices: [DVec3; 3],
    colour: char,
    /// The pixels (i, j) that it covers, all inside the picture.
    pixels: Vec<(usize, usize)>,
}

struct Buffers {
    colour: Vec<char>,
    depth: Vec<f64>,
}

fn draw(triangles: &[Triangle], width: usize, height: usize, far: f64) -> Buffers {
    let mut colour = vec!['.'; width * height];
    let mut depth = vec![far; width * height];
    for triangle in triangles {
        let [a, b, c] = triangle.vertices;
        let n = (b - a).cross(c - a);
        for &(i, j) in &triangle.pixels {
            let (x, y) = (i as f64 + 0.5, j as f64 + 0.5);
            let z = c.z + (-n.x / n.z) * (x - c.x) + (-n.y / n.z) * (y - c.y);
            let pixel = i + j * width;
            if z < depth[pixel] {
                depth[pixel] = z;
                colour[pixel] = triangle.colour;
            }
        }
    }
    Buffers { colour, depth }
}
