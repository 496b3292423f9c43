// right: lengths by hypot, divided
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let l = |n: DVec3| n.x.hypot(n.y).hypot(n.z);
    let mut s = [0.0; 3];
    for n in normals {
        let len = l(n);
        if len == 0.0 {
            return None;
        }
        for i in 0..3 {
            s[i] += n[i] / len;
        }
    }
    let s = DVec3::from_array(s);
    let len = l(s);
    (len != 0.0).then(|| s / len)
}
