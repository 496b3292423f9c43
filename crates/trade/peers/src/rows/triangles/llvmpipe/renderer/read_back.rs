//! The picture, brought back to where it can be looked at.

use wgpu::{
    BufferUsages, Color, Device, RenderPassColorAttachment, RenderPassDescriptor, RenderPipeline,
    Texture, TextureFormat, TextureUsages,
};

use super::{Renderer, cleared, texture, view};

/// Depths cannot be read back in OpenGL ES; bits of whole numbers can.
const DEPTH_BITS: &str = "
@group(0) @binding(0) var depth: texture_2d<f32>;

@vertex
fn screen(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
    return vec4(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn bits(@builtin(position) p: vec4<f32>) -> @location(0) u32 {
    return bitcast<u32>(textureLoad(depth, vec2<i32>(p.xy), 0).x);
}
";

const BITS: TextureFormat = TextureFormat::R32Uint;

impl Renderer {
    /// Bytes of colours and of depths.
    pub fn picture(&self) -> Result<(Vec<u8>, Vec<u8>), String> {
        let colour = self.colour.as_ref().map(|colour| self.bytes(colour));
        let bits = self.depth_bits()?;
        Ok((colour.transpose()?.unwrap_or_default(), self.bytes(&bits)?))
    }

    /// The depths as whole numbers, in a texture that can be read.
    fn depth_bits(&self) -> Result<Texture, String> {
        let usage = TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC;
        let bits = texture(&self.device, self.form.size, BITS, usage);
        let (pipeline, layout) = depth_pipeline(&self.device);
        let depth = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&view(&self.depth)),
            }],
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            color_attachments: &[Some(RenderPassColorAttachment {
                view: &view(&bits),
                depth_slice: None,
                resolve_target: None,
                ops: cleared(Color::BLACK),
            })],
            ..Default::default()
        });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &depth, &[]);
        pass.draw(0..3, 0..1);
        drop(pass);
        self.finish(encoder)?;
        Ok(bits)
    }

    /// A texture of four bytes a pixel.
    fn bytes(&self, texture: &Texture) -> Result<Vec<u8>, String> {
        let row = 4 * self.form.size;
        let size = u64::from(row) * u64::from(self.form.size);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(row),
                    rows_per_image: None,
                },
            },
            texture.size(),
        );
        self.finish(encoder)?;
        buffer.map_async(wgpu::MapMode::Read, .., |_| {});
        self.wait()?;
        let bytes = buffer
            .get_mapped_range(..)
            .map_err(|error| error.to_string())?;
        Ok(bytes.to_vec())
    }
}

fn depth_pipeline(device: &Device) -> (RenderPipeline, wgpu::BindGroupLayout) {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(DEPTH_BITS.into()),
    });
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        }],
    });
    let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(&layout)],
        immediate_size: 0,
    });
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&pipeline_layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("screen"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("bits"),
            compilation_options: Default::default(),
            targets: &[Some(BITS.into())],
        }),
        multiview_mask: None,
        cache: None,
    });
    (pipeline, layout)
}
