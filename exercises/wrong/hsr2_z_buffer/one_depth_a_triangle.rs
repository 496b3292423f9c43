// rejected by one_triangle: every pixel has its own depth
use glam::DVec3;

struct Triangle {
    vertices: [DVec3; 3],
    colour: char,
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
        let z = (a.z + b.z + c.z) / 3.0;
        for &(i, j) in &triangle.pixels {
            let pixel = i + j * width;
            if z < depth[pixel] {
                depth[pixel] = z;
                colour[pixel] = triangle.colour;
            }
        }
    }
    Buffers { colour, depth }
}
