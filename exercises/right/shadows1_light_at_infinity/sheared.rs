// right: a shear of the identity, filled in column by column
use glam::{DMat4, DVec3};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    let mut m = DMat4::IDENTITY;
    m.y_axis.x -= light.x / light.y;
    m.y_axis.y = 0.0;
    m.y_axis.z -= light.z / light.y;
    (light.y != 0.0).then_some(m)
}
