// right: Liang–Barsky: latest entry, earliest exit
use glam::DVec2;

/// A window.
#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let d = b - a;
    let (mut t0, mut t1) = (0.0, 1.0);
    let (mut p, mut q) = (a, b);
    for axis in 0..2 {
        let (low, high) = (window.min[axis], window.max[axis]);
        if d[axis] == 0.0 {
            if a[axis] < low || a[axis] > high {
                return None;
            }
            continue;
        }
        let (near, far) = if d[axis] > 0.0 {
            (low, high)
        } else {
            (high, low)
        };
        let (tn, tf) = ((near - a[axis]) / d[axis], (far - a[axis]) / d[axis]);
        if tn > t0 {
            t0 = tn;
            p = a + tn * d;
            p[axis] = near;
        }
        if tf < t1 {
            t1 = tf;
            q = a + tf * d;
            q[axis] = far;
        }
    }
    (t0 <= t1).then_some((p, q))
}
