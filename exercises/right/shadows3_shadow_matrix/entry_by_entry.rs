// right: sixteen entries by two loops over an array
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let (p, l) = (plane.to_array(), light.to_array());
    let dot: f64 = (0..4).rev().map(|i| p[i] * l[i]).sum();
    if dot == 0.0 {
        return None;
    }
    let mut columns = [[0.0; 4]; 4];
    for (j, column) in columns.iter_mut().enumerate() {
        for (i, entry) in column.iter_mut().enumerate() {
            let identity = if i == j { dot } else { 0.0 };
            *entry = (identity - l[i] * p[j]) * dot.signum();
        }
    }
    Some(DMat4::from_cols_array_2d(&columns))
}
