//! How the figures of hidden surfaces tell primitives apart.

use crate::colour::Role;

/// Names and colours of primitives.
pub(super) const PRIMITIVES: [(&str, Role); 4] = [
    ("*A*", Role::Occluder),
    ("*B*", Role::Receiver),
    ("*C*", Role::Curve(3)),
    ("*D*", Role::Curve(2)),
];

/// Share of its colour in the area of a primitive.
pub(super) const AREA: f64 = 0.34;
