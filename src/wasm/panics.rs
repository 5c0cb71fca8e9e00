//! What JavaScript gets of a panic.

use wasm_bindgen::prelude::wasm_bindgen;

/// Throws a panic as an error named `Panic`, which is a bug: a trap without one is memory that ran out.
#[wasm_bindgen(start)]
pub fn throw_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let error = js_sys::Error::new(&panic.to_string());
        error.set_name("Panic");
        wasm_bindgen::throw_val(error.into());
    }));
}
