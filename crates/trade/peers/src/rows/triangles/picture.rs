//! The picture that shows what each contestant made of the mesh.

use ombra_hsr::z_buffer::{Depth32F, DepthBuffer};

use crate::measured::Shown;
use crate::race::Scene;

use super::euc_buffers::Buffers;
use super::mesh::{FAR, NEAR};

pub use super::euc_buffers::{BACKGROUND, FARTHEST};

/// Colour and depth, lent to each contestant.
pub struct Picture {
    pub size: u32,
    /// R, G, B and A of each pixel; empty where depth alone is drawn.
    pub colour: Vec<u8>,
    /// Window depth: 0 at the near plane, 1 at the far one.
    pub depth: Vec<f32>,
    /// euc has memory of its own for both,
    pub euc: Option<Buffers>,
    /// ours for depth.
    pub ours: Option<DepthBuffer<Depth32F>>,
    pub drawn: Drawn,
    /// What the plain form of ours makes of the mesh.
    ideal: Ideal,
}

/// Where and how a contestant left its picture.
#[derive(Clone, Copy, PartialEq)]
pub enum Drawn {
    /// As the fields of the picture say.
    Here,
    /// With 1 / w for depth, 0 where nothing is.
    InverseW,
    ByEuc,
    /// Colour here, depth in `ours`.
    ByOurs,
}

#[derive(Clone, Default)]
pub struct Ideal {
    pub colour: Vec<u8>,
    pub depth: Vec<f32>,
}

/// Depths that differ by no more are the same. Corners are moved by up to 1/512 of a pixel, or not at all; where the surface
/// runs a tenth of the way from near to far within 10 pixels, that makes 2 · 10⁻⁵.
const SAME_DEPTH: f32 = 1e-4;

impl Picture {
    pub fn new(size: u32, coloured: bool) -> Self {
        let pixels = size as usize * size as usize;
        Self {
            size,
            colour: vec![0; if coloured { 4 * pixels } else { 0 }],
            depth: vec![FARTHEST; pixels],
            euc: Some(Buffers::new(size, coloured)),
            ours: DepthBuffer::new(size, size).ok(),
            drawn: Drawn::Here,
            ideal: Ideal::default(),
        }
    }

    /// Whether there is something, for each pixel of the ideal picture.
    pub fn ideally_lit(&self) -> impl Iterator<Item = bool> {
        self.ideal.depth.iter().map(|&depth| depth < FARTHEST)
    }

    /// What lies here now is what the others have to draw.
    pub fn set_ideal(&mut self) {
        self.ideal = self.result();
    }

    fn result(&self) -> Ideal {
        let depth = match (self.drawn, &self.euc, &self.ours) {
            (Drawn::ByEuc, Some(Buffers { colour, depth, .. }), _) => {
                return Ideal {
                    colour: colour.as_ref().as_flattened().to_vec(),
                    depth: depth.as_ref().iter().map(|&ndc| 0.5 + 0.5 * ndc).collect(),
                };
            }
            (Drawn::ByOurs, _, Some(ours)) => ours.image().to_vec(),
            (Drawn::InverseW, ..) => self.depth.iter().map(|&v| of_inverse_w(v)).collect(),
            _ => self.depth.clone(),
        };
        let colour = self.colour.clone();
        Ideal { colour, depth }
    }
}

/// Window depth is a linear function of 1 / w, from 0 at the near plane to 1 at the far one.
fn of_inverse_w(inverse: f32) -> f32 {
    if inverse == 0.0 {
        return FARTHEST;
    }
    let [near, far] = [1.0 / NEAR, 1.0 / FAR];
    ((near - f64::from(inverse)) / (near - far)) as f32
}

impl Scene for Picture {
    fn clear(&mut self) {
        self.drawn = Drawn::Here;
        self.colour.fill(0);
        self.depth.fill(FARTHEST);
        if let Some(buffers) = &mut self.euc {
            buffers.clear();
        }
        if let Some(depth) = &mut self.ours {
            depth.clear();
        }
    }

    fn shows(&self) -> Vec<Shown> {
        let Ideal { colour, depth } = self.result();
        let is_lit = |depth: f32| depth < FARTHEST;
        let lit = || depth.iter().filter(|&&depth| is_lit(depth));
        let number = lit().count() as f64;
        let alike = if colour.is_empty() {
            (depth.iter().zip(&self.ideal.depth))
                .filter(|&(&own, &ours)| is_lit(ours) && (own - ours).abs() <= SAME_DEPTH)
                .count()
        } else {
            let [own, ours] = [&colour, &self.ideal.colour].map(|c| c.as_chunks::<4>().0);
            (own.iter().zip(ours).zip(self.ideally_lit()))
                .filter(|((own, ours), is_lit)| *is_lit && own == ours)
                .count()
        };
        let ideally = self.ideally_lit().filter(|&lit| lit).count().max(1);
        vec![
            Shown {
                name: "lit",
                value: number,
                within: Some(1e-3),
            },
            Shown {
                name: "share as draw_plain",
                value: alike as f64 / ideally as f64,
                within: Some(0.05),
            },
            Shown {
                name: "mean depth",
                value: lit().map(|&depth| f64::from(depth)).sum::<f64>() / number,
                within: Some(1e-4),
            },
        ]
    }
}
