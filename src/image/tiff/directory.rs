//! The first image directory of a TIFF file: enough of it to know what the file declares.

/// The types of values in the file.
const ASCII: u64 = 2;
const DOUBLE: u64 = 12;

/// The first image directory of a classic or a big TIFF.
pub(crate) struct Directory<'a> {
    bytes: &'a [u8],
    little_endian: bool,
    big: bool,
    /// Where the entries begin, and how many there are.
    start: usize,
    pub entries: usize,
}

impl<'a> Directory<'a> {
    /// Finds the directory; absent where the file ends before it does.
    pub fn first(bytes: &'a [u8]) -> Option<Self> {
        let mut directory = Self { bytes, little_endian: *bytes.first()? == b'I', big: false, start: 0, entries: 0 };
        directory.big = directory.unsigned(2, 2)? == 43;
        let (at, count_size) = if directory.big { (directory.unsigned(8, 8)?, 8) } else { (directory.unsigned(4, 4)?, 2) };
        let at = usize::try_from(at).ok()?;
        directory.entries = usize::try_from(directory.unsigned(at, count_size)?).ok()?;
        directory.start = at.checked_add(count_size)?;
        let end = directory.start.checked_add(directory.entries.checked_mul(directory.entry_size())?)?;
        (end <= bytes.len()).then_some(directory)
    }

    /// The first value of a tag of unsigned numbers.
    pub fn value(&self, tag: u64) -> Option<u64> {
        let (at, size, count) = self.values(tag)?;
        (count > 0).then(|| self.unsigned(at, size))?
    }

    /// All values of a tag of numbers in double precision.
    pub fn doubles(&self, tag: u64) -> Option<Vec<f64>> {
        let (at, count) = self.values_of(tag, DOUBLE, 8)?;
        (0..count).map(|i| self.unsigned(at + 8 * i, 8).map(f64::from_bits)).collect()
    }

    /// The text of a tag, without what follows its end.
    pub fn text(&self, tag: u64) -> Option<String> {
        let (at, count) = self.values_of(tag, ASCII, 1)?;
        let bytes = self.bytes[at..at + count].split(|byte| *byte == 0).next()?;
        Some(String::from_utf8_lossy(bytes).trim().into())
    }

    /// All values of a tag of unsigned numbers that fit into 16 bits.
    pub fn all_shorts(&self, tag: u64) -> Option<Vec<u16>> {
        let (_, _, count) = self.values(tag)?;
        self.shorts(tag, count)
    }

    /// The first values of a tag of unsigned numbers, where there are so many and each fits.
    pub fn shorts(&self, tag: u64, wanted: usize) -> Option<Vec<u16>> {
        let (at, size, _) = self.values(tag).filter(|(_, _, count)| *count >= wanted)?;
        (0..wanted).map(|i| u16::try_from(self.unsigned(at + i * size, size)?).ok()).collect()
    }

    /// Each tag with the number of its values.
    pub fn counts(&self) -> impl Iterator<Item = (u64, u64)> {
        let room = if self.big { 8 } else { 4 };
        self.places().filter_map(move |at| Some((self.unsigned(at, 2)?, self.unsigned(at + 4, room)?)))
    }

    /// Where the entries stand.
    fn places(&self) -> impl Iterator<Item = usize> {
        (0..self.entries).map(|i| self.start + i * self.entry_size())
    }

    /// Where the first value of a tag stands, and the bytes that a new value has there.
    pub fn encoded(&self, tag: u64, value: u64) -> Option<(usize, Vec<u8>)> {
        let (at, size, _) = self.values(tag)?;
        let bytes = if self.little_endian { value.to_le_bytes()[..size].to_vec() } else { value.to_be_bytes()[8 - size..].to_vec() };
        Some((at, bytes))
    }

    /// Where the values of a tag stand, the bytes of one, and how many the file holds.
    fn values(&self, tag: u64) -> Option<(usize, usize, usize)> {
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
    fn values_of(&self, tag: u64, kind: u64, size: usize) -> Option<(usize, usize)> {
        let entry = self.entry(tag).filter(|&entry| self.unsigned(entry + 2, 2) == Some(kind))?;
        self.held(entry, size)
    }

    fn entry(&self, tag: u64) -> Option<usize> {
        self.places().find(|&at| self.unsigned(at, 2) == Some(tag))
    }

    /// Where the values of an entry stand, of which each takes `size` bytes, and how many: none that the file does not hold.
    fn held(&self, entry: usize, size: usize) -> Option<(usize, usize)> {
        let room = if self.big { 8 } else { 4 };
        let count = usize::try_from(self.unsigned(entry + 4, room)?).ok()?;
        let inline = entry + 4 + room;
        let length = count.checked_mul(size)?;
        let at = if length <= room { inline } else { usize::try_from(self.unsigned(inline, room)?).ok()? };
        (at.checked_add(length)? <= self.bytes.len()).then_some((at, count))
    }

    /// An unsigned number of 1, 2, 4 or 8 bytes.
    fn unsigned(&self, at: usize, size: usize) -> Option<u64> {
        let bytes = self.bytes.get(at..at.checked_add(size)?)?;
        let append = |n: u64, byte: &u8| n << 8 | u64::from(*byte);
        Some(if self.little_endian { bytes.iter().rev().fold(0, append) } else { bytes.iter().fold(0, append) })
    }

    fn entry_size(&self) -> usize {
        if self.big { 20 } else { 12 }
    }
}
