//! What stands for this folder in the tests that run as wasm. With all that it exports, the whole crate would be compiled to wasm once more
//! for a few tests.

// Drawing needs one function of it.
#[allow(dead_code)]
mod convert;
mod draw;
mod everywhere;
