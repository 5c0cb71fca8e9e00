//! Integration tests that give the same to the last bit natively and as wasm. As wasm they are tests of the crate itself, so that it is
//! compiled and linked once for all of them.

#[path = "../../tests/adjustment_everywhere.rs"]
mod adjustment;
#[path = "../../tests/decode_everywhere.rs"]
mod decode;
#[path = "../../tests/sample.rs"]
mod sample;
#[path = "../../tests/simulate.rs"]
mod simulate;
