//! The ground floor of the course: points, planes, meshes and views that every lecture shares.
//!
//! Geometry is `f64` on [`glam`]'s types, right-handed, with column vectors. A point is homogeneous where a
//! light or a projection asks for it: w = 1 is a place, w = 0 a direction ([`homogeneous`]). A sign that
//! decides comes from exact arithmetic ([`exact`], [`predicates`]).
//!
//! | module | what it answers |
//! | --- | --- |
//! | [`homogeneous`] | places, directions, division by w |
//! | [`plane`] | n·X + d = 0, distance, exact side |
//! | [`triangle`] | normal, area, barycentric coordinates |
//! | [`spherical`] | r, θ, φ and solid angles |
//! | [`view`] | look-at, frustum and its limit, orthographic, viewport |
//! | [`camera`] | eye, sight lines and pixels of one matrix |
//! | [`mesh`] | indexed triangles, edges with their faces, vertex normals |
//! | [`solids`] | the lectures' cube, tetrahedron, sphere, torus, teapot |
//! | [`predicates`] | orientation of points, exact at every exponent |
//! | [`exact`] | sums of products without rounding |
//! | [`double_double`] | 106 bits, with error bounds |
//! | [`scaling`] | powers of two against overflow and underflow |
//! | [`work`] | counted work |

pub use glam;

pub mod camera;
pub mod double_double;
pub mod exact;
pub mod homogeneous;
pub mod mesh;
pub mod plane;
pub mod predicates;
pub mod scaling;
pub mod solids;
pub mod spherical;
pub mod triangle;
pub mod view;
pub mod work;
