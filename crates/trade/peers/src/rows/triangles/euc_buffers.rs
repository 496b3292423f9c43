//! What is drawn on: the background of all, and the memory that euc has of its own.

use ::euc::Target;
use ::euc::buffer::Buffer2d;

/// Nothing drawn: the colour, and the depth of the far plane.
pub const BACKGROUND: [u8; 4] = [0, 0, 0, 255];
pub const FARTHEST: f32 = 1.0;

/// It draws into memory of its own.
pub struct Buffers {
    pub colour: Buffer2d<[u8; 4]>,
    /// z / w, −1 … 1.
    pub depth: Buffer2d<f32>,
    /// What stands for a colour where depth alone is drawn: takes no memory.
    pub none: Buffer2d<()>,
}

impl Buffers {
    pub fn new(size: u32, coloured: bool) -> Self {
        let size = [size as usize; 2];
        Self {
            colour: Buffer2d::new(if coloured { size } else { [0; 2] }, BACKGROUND),
            depth: Buffer2d::new(size, FARTHEST),
            none: Buffer2d::new(size, ()),
        }
    }

    pub fn clear(&mut self) {
        self.colour.clear(BACKGROUND);
        self.depth.clear(FARTHEST);
    }
}
