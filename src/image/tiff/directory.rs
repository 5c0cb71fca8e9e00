//! An image directory of a TIFF file: enough of it to know what the file declares.

use crate::source::FileSource;

/// The types of values in the file.
const ASCII: u64 = 2;
const UNDEFINED: u64 = 7;
const DOUBLE: u64 = 12;

/// An image directory of a classic or a big TIFF.
pub(crate) struct Directory<S> {
    source: S,
    little_endian: bool,
    big: bool,
    /// Where the entries begin, and how many there are.
    start: u64,
    pub entries: usize,
}

/// No text and no table that is read is longer.
const MOST_BYTES: usize = 1 << 16;

impl<S: FileSource> Directory<S> {
    /// Finds the first one; absent where the file ends before it does.
    pub fn first(source: S) -> Option<Self> {
        let mut order = [0];
        source.read_at(0, &mut order).ok()?;
        let mut directory = Self { source, little_endian: order[0] == b'I', big: false, start: 0, entries: 0 };
        directory.big = directory.unsigned(2, 2)? == 43;
        let at = if directory.big { directory.unsigned(8, 8)? } else { directory.unsigned(4, 4)? };
        directory.at(at)
    }

    /// The one after it; absent after the last.
    pub fn next(&self) -> Option<Self>
    where
        S: Clone,
    {
        let at = self.unsigned(self.end()?, if self.big { 8 } else { 4 }).filter(|&at| at != 0)?;
        Self { source: self.source.clone(), ..*self }.at(at)
    }

    fn at(mut self, at: u64) -> Option<Self> {
        let count_size: u8 = if self.big { 8 } else { 2 };
        self.entries = usize::try_from(self.unsigned(at, count_size.into())?).ok()?;
        self.start = at.checked_add(count_size.into())?;
        (self.end()? <= self.source.length()).then_some(self)
    }

    /// Where the entries end.
    fn end(&self) -> Option<u64> {
        self.start.checked_add((self.entries as u64).checked_mul(self.entry_size())?)
    }

    /// Of the file, in bytes.
    pub fn length(&self) -> u64 {
        self.source.length()
    }

    /// The first value of a tag of unsigned numbers.
    pub fn value(&self, tag: u64) -> Option<u64> {
        let (at, size, count) = self.values(tag)?;
        (count > 0).then(|| self.unsigned(at, size))?
    }

    /// All values of a tag of numbers in double precision.
    pub fn doubles(&self, tag: u64) -> Option<Vec<f64>> {
        let (at, count) = self.values_of(tag, DOUBLE, 8)?;
        (0..count as u64).map(|i| self.unsigned(at + 8 * i, 8).map(f64::from_bits)).collect()
    }

    /// The text of a tag, without what follows its end.
    pub fn text(&self, tag: u64) -> Option<String> {
        let bytes = self.bytes_of(tag, ASCII)?;
        let text = bytes.split(|byte| *byte == 0).next()?;
        Some(String::from_utf8_lossy(text).trim().into())
    }

    /// All values of a tag of unsigned numbers that fit into 16 bits.
    pub fn all_shorts(&self, tag: u64) -> Option<Vec<u16>> {
        let (_, _, count) = self.values(tag)?;
        self.shorts(tag, count)
    }

    /// The first values of a tag of unsigned numbers, where there are so many and each fits.
    pub fn shorts(&self, tag: u64, wanted: usize) -> Option<Vec<u16>> {
        let (at, size, _) = self.values(tag).filter(|(_, _, count)| *count >= wanted)?;
        (0..wanted as u64).map(|i| u16::try_from(self.unsigned(at + i * size as u64, size)?).ok()).collect()
    }

    /// All values of a tag of unsigned numbers.
    pub fn numbers(&self, tag: u64) -> Option<Vec<u64>> {
        let (at, size, count) = self.values(tag)?;
        let mut bytes = vec![0; count.checked_mul(size)?];
        self.source.read_at(at, &mut bytes).ok()?;
        Some(bytes.chunks_exact(size).map(|bytes| self.number(bytes)).collect())
    }

    /// The bytes of a tag that means them to itself.
    pub fn bytes(&self, tag: u64) -> Option<Vec<u8>> {
        self.bytes_of(tag, UNDEFINED)
    }

    fn bytes_of(&self, tag: u64, kind: u64) -> Option<Vec<u8>> {
        let (at, count) = self.values_of(tag, kind, 1).filter(|(_, count)| *count < MOST_BYTES)?;
        let mut bytes = vec![0; count];
        self.source.read_at(at, &mut bytes).ok()?;
        Some(bytes)
    }

    /// Each tag with the number of its values.
    pub fn counts(&self) -> impl Iterator<Item = (u64, u64)> {
        let room = if self.big { 8 } else { 4 };
        self.places().filter_map(move |at| Some((self.unsigned(at, 2)?, self.unsigned(at + 4, room)?)))
    }

    /// Where the entries stand.
    fn places(&self) -> impl Iterator<Item = u64> {
        (0..self.entries as u64).map(|i| self.start + i * self.entry_size())
    }

    /// Where the first value of a tag stands, and the bytes that a new value has there.
    pub fn encoded(&self, tag: u64, value: u64) -> Option<(u64, Vec<u8>)> {
        let (at, size, _) = self.values(tag)?;
        let bytes = if self.little_endian { value.to_le_bytes()[..size].to_vec() } else { value.to_be_bytes()[8 - size..].to_vec() };
        Some((at, bytes))
    }

    /// Where the values of a tag stand, the bytes of one, and how many the file holds.
    fn values(&self, tag: u64) -> Option<(u64, usize, usize)> {
        let entry = self.entry(tag)?;
        let size = match self.unsigned(entry + 2, 2)? {
            1 => 1,
            3 => 2,
            4 => 4,
            16 => 8,
            _ => return None,
        };
        let (at, count) = self.held(entry, size)?;
        Some((at, size, count))
    }

    /// Where the values of a tag of this type stand, and how many.
    fn values_of(&self, tag: u64, kind: u64, size: usize) -> Option<(u64, usize)> {
        let entry = self.entry(tag).filter(|&entry| self.unsigned(entry + 2, 2) == Some(kind))?;
        self.held(entry, size)
    }

    fn entry(&self, tag: u64) -> Option<u64> {
        self.places().find(|&at| self.unsigned(at, 2) == Some(tag))
    }

    /// Where the values of an entry stand, of which each takes `size` bytes, and how many: none that the file does not hold.
    fn held(&self, entry: u64, size: usize) -> Option<(u64, usize)> {
        let room: u8 = if self.big { 8 } else { 4 };
        let count = self.unsigned(entry + 4, room.into())?;
        let inline = entry + 4 + u64::from(room);
        let length = count.checked_mul(size as u64)?;
        let at = if length <= room.into() { inline } else { self.unsigned(inline, room.into())? };
        (at.checked_add(length)? <= self.source.length()).then_some((at, usize::try_from(count).ok()?))
    }

    /// An unsigned number of 1, 2, 4 or 8 bytes.
    fn unsigned(&self, at: u64, size: usize) -> Option<u64> {
        let mut room = [0; 8];
        let bytes = &mut room[..size];
        self.source.read_at(at, bytes).ok()?;
        Some(self.number(bytes))
    }

    fn number(&self, bytes: &[u8]) -> u64 {
        let append = |n: u64, byte: &u8| n << 8 | u64::from(*byte);
        if self.little_endian { bytes.iter().rev().fold(0, append) } else { bytes.iter().fold(0, append) }
    }

    fn entry_size(&self) -> u64 {
        if self.big { 20 } else { 12 }
    }
}
