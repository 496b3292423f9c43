use ombra_math::camera::Camera;
use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;
use ombra_math::view::{Viewport, frustum, look_at, orthographic};
use ombra_raster::buffers::image::{Luma, Rgba};
use ombra_raster::buffers::{self};
use proptest::prelude::*;

use super::*;

mod drawing;
mod exact;
mod levels;
mod order;
mod precision;

/// The forms of the z-buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Plain,
    Fast,
    Threads,
}

fn drawn<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    (picture, depth): (&mut Picture<P>, &mut DepthBuffer<F>),
    form: Form,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    match form {
        Form::Plain => draw_plain(mesh, camera, colours, options, picture, depth, work),
        Form::Fast => counted::draw(mesh, camera, colours, options, picture, depth, work),
        Form::Threads => draw(mesh, camera, colours, options, picture, depth),
    }
}

fn depth_drawn<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
    form: Form,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    match form {
        Form::Plain => {
            let (width, height) = depth.dimensions();
            let mut picture = buffers::new(width, height, Luma([0u8])).unwrap();
            let options = Options {
                cull,
                ..Options::default()
            };
            let one = Colours::One(Luma([1]));
            draw_plain(mesh, camera, one, options, &mut picture, depth, work)
        }
        Form::Fast => counted::draw_depth(mesh, camera, cull, depth, work),
        Form::Threads => draw_depth(mesh, camera, cull, depth),
    }
}

fn viewport(width: u32, height: u32) -> Viewport {
    Viewport { width, height }
}

/// Views whose near plane often cuts what is drawn.
fn cameras() -> impl Strategy<Value = Camera> {
    (0..5, 1..40u32, 1..30u32, prop::array::uniform3(-2.0..2.0)).prop_map(
        |(kind, width, height, eye)| {
            let eye = DVec3::from(eye) + DVec3::new(0.0, 0.0, 1.5);
            let view = look_at(eye, DVec3::new(0.1, 0.2, -0.3), DVec3::Y).unwrap();
            let projection = match kind {
                0 => frustum(-0.5, 0.5, -0.4, 0.4, 0.5, 4.0),
                1 => frustum(-1e-3, 1e-3, -1e-3, 1e-3, 1e-3, 1e6),
                2 => frustum(-1e-9, 1e-9, -1e-9, 1e-9, 1e-9, 1.0),
                3 => orthographic(-1.0, 1.0, -1.0, 1.0, 0.0, 3.0),
                // Corners far beyond the picture.
                _ => frustum(-1e-6, 1e-6, -1e-6, 1e-6, 0.1, 10.0),
            }
            .unwrap();
            Camera {
                view_projection: projection * view,
                viewport: viewport(width, height),
            }
        },
    )
}

/// Small and large triangles; coordinates on a grid meet and tie.
fn meshes() -> impl Strategy<Value = Mesh> {
    let coordinate = prop_oneof![
        -2.0..2.0f64,
        (-4..5).prop_map(|i| f64::from(i) / 2.0),
        -0.2..0.2f64
    ];
    let position = prop::array::uniform3(coordinate).prop_map(DVec3::from);
    (3..20usize)
        .prop_flat_map(move |n| {
            let index = 0..n as u32;
            let triangle = prop::array::uniform3(index);
            (
                prop::collection::vec(position.clone(), n),
                prop::collection::vec(triangle, 0..30),
            )
        })
        .prop_map(|(positions, triangles)| Mesh::new(positions, triangles).unwrap())
}

fn options() -> impl Strategy<Value = Options> {
    (0..3usize, any::<bool>()).prop_map(|(cull, over)| Options {
        cull: [Cull::Nothing, Cull::Back, Cull::Front][cull],
        blend: if over { Blend::Over } else { Blend::Replace },
    })
}

fn both_forms_agree<F: DepthFormat + PartialEq>(
    mesh: &Mesh,
    camera: &Camera,
    options: Options,
) -> Result<(), TestCaseError> {
    let Viewport { width, height } = camera.viewport;
    let fresh = DepthBuffer::<F>::new(width, height).unwrap();
    let n = mesh.triangles.len().max(mesh.positions.len());
    let many: Vec<_> = (0..n)
        .map(|i| Rgba([i as u8, (i * 7) as u8, 200, (i * 50) as u8]))
        .collect();
    for colours in [
        Colours::One(Rgba([1, 2, 3, 100])),
        Colours::PerTriangle(&many[..mesh.triangles.len()]),
        Colours::PerVertex(&many[..mesh.positions.len()]),
    ] {
        let picture = buffers::new(width, height, Rgba([9, 9, 9, 255])).unwrap();
        let (mut plain, mut plain_depth) = (picture.clone(), fresh.clone());
        let target = (&mut plain, &mut plain_depth);
        drawn(mesh, camera, colours, options, target, Form::Plain, &mut ()).unwrap();
        let (mut fast, mut fast_depth) = (picture, fresh.clone());
        let target = (&mut fast, &mut fast_depth);
        drawn(
            mesh,
            camera,
            colours,
            options,
            target,
            Form::Threads,
            &mut (),
        )
        .unwrap();
        prop_assert_eq!(&plain_depth, &fast_depth);
        prop_assert_eq!(plain, fast);
        let mut alone = fresh.clone();
        draw_depth(mesh, camera, options.cull, &mut alone).unwrap();
        prop_assert_eq!(&plain_depth, &alone);
    }
    let id = |i| Luma([i as u32]);
    let ids: Vec<_> = (0..mesh.triangles.len()).map(id).collect();
    let picture = buffers::new(width, height, Luma([u32::MAX])).unwrap();
    let (mut plain, mut plain_depth) = (picture.clone(), fresh.clone());
    let colours = Colours::PerTriangle(&ids);
    let target = (&mut plain, &mut plain_depth);
    drawn(mesh, camera, colours, options, target, Form::Plain, &mut ()).unwrap();
    let (mut fast, mut fast_depth) = (picture, fresh.clone());
    draw(mesh, camera, colours, options, &mut fast, &mut fast_depth).unwrap();
    prop_assert_eq!(plain, fast);
    Ok(())
}

proptest! {
    #[test]
    fn the_fast_form_is_the_plain_one_bit_for_bit(mesh in meshes(), camera in cameras(), options in options()) {
        both_forms_agree::<Depth16>(&mesh, &camera, options)?;
        both_forms_agree::<Depth24>(&mesh, &camera, options)?;
        both_forms_agree::<Depth32F>(&mesh, &camera, options)?;
        both_forms_agree::<ReversedDepth32F>(&mesh, &camera, options)?;
    }
}
