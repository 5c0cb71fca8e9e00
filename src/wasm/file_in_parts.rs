//! Files that JavaScript reads in parts.

use super::convert::{JsResult, bytes_of, kind_of, thrown};
use crate::{Error, FileSource};
use js_sys::Uint8Array;
use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Mutex, PoisonError};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A file that is read in parts: `read` gives so many bytes from a place on, at once. In a worker of a browser a `FileReaderSync` does that, in Node `fs.readSync`. */
export interface FileInParts {
    /** Its length in bytes. */
    readonly size: number;
    read(at: number, length: number): Uint8Array;
}
"#;

#[wasm_bindgen]
extern "C" {
    type FileInParts;

    #[wasm_bindgen(method, getter)]
    fn size(this: &FileInParts) -> f64;

    #[wasm_bindgen(method, catch)]
    fn read(this: &FileInParts, at: f64, length: f64) -> Result<Uint8Array, JsValue>;
}

/// Small reads are answered from blocks of so many bytes, of which so many are kept: directories are read number by number.
const BLOCK: u64 = 1 << 16;
const BLOCKS: usize = 16;

/// A file of JavaScript.
struct HostFile {
    file: FileInParts,
    length: u64,
    /// Blocks by their number, the one that was read last in front.
    blocks: Mutex<VecDeque<(u64, Arc<Vec<u8>>)>>,
}

impl HostFile {
    fn ask(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        let words = |thrown: JsValue| thrown.dyn_ref::<js_sys::Error>().map_or_else(String::new, |error| error.message().into());
        let bytes = self.file.read(at as f64, into.len() as f64).map_err(|thrown| io::Error::other(words(thrown)))?;
        if bytes.length() as usize != into.len() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        bytes.copy_to(into);
        Ok(())
    }

    fn block(&self, number: u64) -> io::Result<Arc<Vec<u8>>> {
        let mut blocks = self.blocks.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(place) = blocks.iter().position(|(of, _)| *of == number)
            && let Some(found) = blocks.remove(place)
        {
            blocks.push_front(found);
        } else {
            let at = number * BLOCK;
            let mut bytes = vec![0; (self.length - at).min(BLOCK) as usize];
            self.ask(at, &mut bytes)?;
            blocks.truncate(BLOCKS - 1);
            blocks.push_front((number, Arc::new(bytes)));
        }
        Ok(Arc::clone(&blocks[0].1))
    }
}

impl FileSource for HostFile {
    fn length(&self) -> u64 {
        self.length
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        let end = at.checked_add(into.len() as u64).filter(|end| *end <= self.length).ok_or(io::ErrorKind::UnexpectedEof)?;
        if into.len() as u64 >= BLOCK {
            return self.ask(at, into);
        }
        let mut place = at;
        while place < end {
            let block = self.block(place / BLOCK)?;
            let from = (place % BLOCK) as usize;
            let count = (block.len() - from).min((end - place) as usize);
            let to = (place - at) as usize;
            into[to..to + count].copy_from_slice(&block[from..from + count]);
            place += count as u64;
        }
        Ok(())
    }
}

/// All bytes of a file, or a file that is read in parts.
pub fn file_source(file: &JsValue) -> JsResult<Arc<dyn FileSource>> {
    if let Some(bytes) = bytes_of(file) {
        return Ok(Arc::new(bytes));
    }
    let file: FileInParts = file.clone().unchecked_into();
    let length = if file.is_object() { file.size() } else { f64::NAN };
    if !(length >= 0.0 && length.fract() == 0.0 && length < 9e15) {
        let allowed = "Uint8Array, ArrayBuffer, or an object with size and read".to_string();
        let got = if length.is_nan() { kind_of(&file) } else { format!("a size of {length}") };
        return Err(thrown(Error::InvalidArgument { what: "file", got, wanted: allowed }));
    }
    Ok(Arc::new(HostFile { file, length: length as u64, blocks: Mutex::default() }))
}
