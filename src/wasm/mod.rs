//! The only folder that names JavaScript: unpack, call the core, pack.
//!
//! Bulk data crosses as flat typed arrays of a stated stride, options and small results as plain objects. Every result is a copy.

mod about;
mod block;
mod block_files;
mod block_refinement;
mod block_scene;
mod camera;
mod convert;
mod descriptors;
mod digest;
mod draw;
mod features;
mod geometry;
mod matching;
mod orientation;
mod photo;
mod reconstruction;
mod report;
mod simulate;
mod tables;
mod verification;

/// Throws a panic as an error named `Panic`, which is a bug: a trap without one is memory that ran out.
#[wasm_bindgen(start)]
pub fn throw_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let error = js_sys::Error::new(&panic.to_string());
        error.set_name("Panic");
        wasm_bindgen::throw_val(error.into());
    }));
}
