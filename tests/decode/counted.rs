//! A file that counts what is read of it.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tiepoint::FileSource;

/// Its bytes, and how many were read.
pub struct Counted(pub Vec<u8>, pub Arc<AtomicU64>);

impl FileSource for Counted {
    fn length(&self) -> u64 {
        self.0.len() as u64
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        self.1.fetch_add(into.len() as u64, Ordering::Relaxed);
        self.0.read_at(at, into)
    }
}
