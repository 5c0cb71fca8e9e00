//! A TIFF with some declarations put in the words of the decoder.

use super::declared::tag;
use super::directory::Directory;
use crate::source::FileSource;
use std::io;

/// A file of which some bytes are read as others.
#[derive(Clone)]
pub(crate) struct Corrected<S> {
    source: S,
    /// From where on, and which.
    others: Vec<(u64, Vec<u8>)>,
}

impl<S: FileSource> Corrected<S> {
    /// The file as it is.
    pub fn none(source: S) -> Self {
        Self { source, others: Vec::new() }
    }

    /// Gives the first value of a tag another value.
    pub fn set(&mut self, tag: u64, value: u64) {
        let encoded = Directory::first(&self.source).and_then(|directory| directory.encoded(tag, value));
        self.others.extend(encoded);
    }

    /// The file with no more rows a strip than the image has: of more, as writers declare for 'all rows', the decoder overflows where addresses have 32 bits.
    pub fn rows_of_image(source: S) -> Self {
        let rows = Directory::first(&source).and_then(|directory| {
            let height = directory.value(tag::HEIGHT).unwrap_or(0);
            directory.value(tag::ROWS_PER_STRIP).filter(|rows| *rows > height).map(|_| height)
        });
        let mut corrected = Self::none(source);
        rows.into_iter().for_each(|rows| corrected.set(tag::ROWS_PER_STRIP, rows));
        corrected
    }
}

impl<S: FileSource> FileSource for Corrected<S> {
    fn length(&self) -> u64 {
        self.source.length()
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        self.source.read_at(at, into)?;
        for (from, bytes) in &self.others {
            for (place, byte) in (*from..).zip(bytes) {
                let within = place.checked_sub(at).and_then(|place| usize::try_from(place).ok());
                if let Some(own) = within.and_then(|place| into.get_mut(place)) {
                    *own = *byte;
                }
            }
        }
        Ok(())
    }
}
