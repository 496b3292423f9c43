//! What there is without the feature `llvmpipe`: nothing, and a sentence that says so.

use super::super::Form;

pub enum Renderer {}

impl Renderer {
    pub fn new(_: Form) -> Result<Self, String> {
        Err("the bench was built without the feature of that name".to_owned())
    }

    pub fn name(&self) -> &str {
        match *self {}
    }

    pub fn draw(&self) -> Result<(), String> {
        match *self {}
    }

    pub fn picture(&self) -> Result<(Vec<u8>, Vec<u8>), String> {
        match *self {}
    }
}
