//! What llvmpipe is told to do, through wgpu and OpenGL ES without a display.

mod read_back;

use ombra_math::glam::{Mat4, Vec3};
use pollster::block_on;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Backends, BindGroup, Buffer, BufferUsages, Color, CommandEncoder, Device, Extent3d, LoadOp,
    Operations, PollType, Queue, RenderPassColorAttachment, RenderPassDepthStencilAttachment,
    RenderPassDescriptor, RenderPipeline, StoreOp, Texture, TextureFormat, TextureUsages,
    TextureView,
};

use super::super::Form;
use super::super::mesh::Ball;
use super::super::picture::{BACKGROUND, FARTHEST};

/// The mesh is uploaded, the pipeline compiled: what remains is to draw.
pub struct Renderer {
    name: String,
    device: Device,
    queue: Queue,
    form: Form,
    pipeline: RenderPipeline,
    matrix: BindGroup,
    vertices: Buffer,
    indices: Buffer,
    corners: u32,
    colour: Option<Texture>,
    depth: Texture,
}

const SHADER: &str = "
@group(0) @binding(0) var<uniform> to_clip: mat4x4<f32>;

struct Corner {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat, either) colour: vec4<f32>,
}

@vertex
fn corner(@location(0) position: vec3<f32>, @location(1) colour: vec4<f32>) -> Corner {
    return Corner(to_clip * vec4(position, 1.0), colour);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4<f32> {
    return corner.colour;
}

@vertex
fn place(@location(0) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    return to_clip * vec4(position, 1.0);
}
";

impl Renderer {
    /// Or a sentence that says why not.
    pub fn new(form: Form) -> Result<Self, String> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = Backends::GL;
        let instance = wgpu::Instance::new(descriptor);
        let adapters = block_on(instance.enumerate_adapters(Backends::GL));
        let names: Vec<String> = adapters.iter().map(|a| a.get_info().name).collect();
        let found = adapters
            .iter()
            .zip(&names)
            .find(|(_, name)| name.contains("llvmpipe"));
        let Some((adapter, name)) = found else {
            return Err(match names.as_slice() {
                [] => "no OpenGL without a display here".to_owned(),
                names => format!("OpenGL is answered by {}", names.join(", ")),
            });
        };
        let version = adapter.get_info().driver_info;
        let (device, queue) = block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            required_limits: wgpu::Limits::downlevel_defaults(),
            ..Default::default()
        }))
        .map_err(|error| error.to_string())?;

        let ball = Ball::new();
        // As bytes: positions and colours, then indices. OpenGL ES gives a triangle the colour of its last corner.
        let vertices: Vec<u8> = (ball.positions_f32().zip(&ball.colours))
            .flat_map(|(p, colour)| p.map(f32::to_le_bytes).into_iter().chain([*colour]))
            .flatten()
            .collect();
        let indices: Vec<u8> = (ball.triangles.iter())
            .flat_map(|&[a, b, c]| [b, c, a])
            .flat_map(u32::to_le_bytes)
            .collect();
        let matrix: Vec<u8> = (depth_from_zero() * ball.to_clip.as_mat4())
            .to_cols_array()
            .into_iter()
            .flat_map(f32::to_le_bytes)
            .collect();
        let upload = |contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: None,
                contents,
                usage,
            })
        };
        let matrix = upload(&matrix, BufferUsages::UNIFORM);
        let pipeline = pipeline(&device, form);
        let usage = TextureUsages::RENDER_ATTACHMENT;
        let renderer = Self {
            name: format!("{name}, {version}"),
            matrix: device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(0),
                entries: &[wgpu::BindGroupEntry {
                    binding: 0,
                    resource: matrix.as_entire_binding(),
                }],
            }),
            vertices: upload(&vertices, BufferUsages::VERTEX),
            indices: upload(&indices, BufferUsages::INDEX),
            corners: 3 * ball.triangles.len() as u32,
            colour: (form.coloured)
                .then(|| texture(&device, form.size, COLOUR, usage | TextureUsages::COPY_SRC)),
            depth: texture(
                &device,
                form.size,
                DEPTH,
                usage | TextureUsages::TEXTURE_BINDING,
            ),
            pipeline,
            form,
            device,
            queue,
        };
        Ok(renderer)
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Clears, draws, and waits until it is done.
    pub fn draw(&self) -> Result<(), String> {
        let colour = self.colour.as_ref().map(view);
        let depth = view(&self.depth);
        let [r, g, b, a] = BACKGROUND.map(|sample| f64::from(sample) / 255.0);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let attachment = colour.as_ref().map(|view| RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: cleared(Color { r, g, b, a }),
        });
        let attachments = [attachment];
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            color_attachments: if self.form.coloured {
                &attachments
            } else {
                &[]
            },
            depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(cleared(FARTHEST)),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.matrix, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.corners, 0, 0..1);
        drop(pass);
        self.finish(encoder)
    }

    fn finish(&self, encoder: CommandEncoder) -> Result<(), String> {
        self.queue.submit([encoder.finish()]);
        self.wait()
    }

    fn wait(&self) -> Result<(), String> {
        let polled = self.device.poll(PollType::wait_indefinitely());
        polled.map(|_| ()).map_err(|error| error.to_string())
    }
}

const COLOUR: TextureFormat = TextureFormat::Rgba8Unorm;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;

fn texture(device: &Device, size: u32, format: TextureFormat, usage: TextureUsages) -> Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: Extent3d {
            width: size,
            height: size,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

fn view(texture: &Texture) -> TextureView {
    texture.create_view(&Default::default())
}

fn cleared<V>(value: V) -> Operations<V> {
    Operations {
        load: LoadOp::Clear(value),
        store: StoreOp::Store,
    }
}

/// wgpu wants 0 ≤ z ≤ w.
fn depth_from_zero() -> Mat4 {
    Mat4::from_translation(Vec3::new(0.0, 0.0, 0.5)) * Mat4::from_scale(Vec3::new(1.0, 1.0, 0.5))
}

fn pipeline(device: &Device, form: Form) -> RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(SHADER.into()),
    });
    let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Unorm8x4];
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(if form.coloured { "corner" } else { "place" }),
            compilation_options: Default::default(),
            buffers: &[Some(wgpu::VertexBufferLayout {
                array_stride: 16,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &attributes,
            })],
        },
        primitive: wgpu::PrimitiveState {
            front_face: wgpu::FrontFace::Ccw,
            cull_mode: form.cull.then_some(wgpu::Face::Back),
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: form.coloured.then_some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options: Default::default(),
            targets: &[Some(COLOUR.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

#[cfg(test)]
mod tests {
    use rayon::ThreadPoolBuilder;

    use super::*;
    use crate::measured::Shown;
    use crate::race::Scene;
    use crate::rows::triangles::ours::Ours;
    use crate::rows::triangles::picture::{Drawn, Picture};

    /// Where it is installed: what comes back is what ours draws.
    #[test]
    fn it_draws_what_ours_draw() {
        let threads = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        for (coloured, cull) in [(true, false), (false, true)] {
            let form = Form {
                size: 256,
                coloured,
                cull,
            };
            let renderer = match Renderer::new(form) {
                Ok(renderer) => renderer,
                Err(sentence) => {
                    assert!(sentence.contains("OpenGL"), "{sentence}");
                    return;
                }
            };
            let mut picture = Picture::new(form.size, coloured);
            Ours::new(&Ball::new(), form, &threads).draw_plain(&mut picture);
            picture.set_ideal();
            let ideal = picture.shows();
            picture.clear();
            renderer.draw().unwrap();
            let (colour, depth) = renderer.picture().unwrap();
            picture.colour = colour;
            picture.depth = (depth.as_chunks().0.iter())
                .map(|&b| f32::from_le_bytes(b))
                .collect();
            picture.drawn = Drawn::Here;
            let shown = picture.shows();
            assert!(
                Shown::agree(&shown, &ideal),
                "{form:?}: {shown:?} is not {ideal:?}"
            );
        }
    }
}
