//! Digests, where the host computes none: browsers do so on secure pages only.

use super::convert::{Bytes, JsResult};
use sha2::{Digest, Sha256};
use wasm_bindgen::prelude::wasm_bindgen;

/// SHA-256 (FIPS 180-4) of bytes: 32 bytes.
#[wasm_bindgen]
pub fn sha256(bytes: &Bytes) -> JsResult<Vec<u8>> {
    Ok(Sha256::digest(bytes.read("bytes")?).to_vec())
}
