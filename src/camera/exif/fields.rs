//! The fields of EXIF, read where they stand: a hostile block costs no memory, and time for three directories at most.

use super::blocks::exif_block;

/// Directories hold some dozens of entries; more than these are not read.
const MOST_ENTRIES: usize = 1_000;
/// Text is cut there.
const MOST_TEXT_BYTES: usize = 1_000;

/// The directories that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Directory {
    Main,
    Exif,
    Gps,
}

/// A field: its directory and number.
pub type Tag = (Directory, u16);

const EXIF_DIRECTORY: Tag = (Directory::Main, 0x8769);
const GPS_DIRECTORY: Tag = (Directory::Main, 0x8825);

/// Types of values.
const BYTE: u16 = 1;
const TEXT: u16 = 2;
const SHORT: u16 = 3;
const LONG: u16 = 4;
const RATIONAL: u16 = 5;
const UNDEFINED: u16 = 7;
const SIGNED_RATIONAL: u16 = 10;
const FLOAT: u16 = 11;
const DOUBLE: u16 = 12;

/// The EXIF of a file: a TIFF structure of a main directory and those of EXIF and GPS that it points to, each entered once.
pub struct Fields<'a> {
    block: &'a [u8],
    little_endian: bool,
    main: usize,
}

/// The values of a field.
struct Values<'a> {
    kind: u16,
    bytes: &'a [u8],
}

impl<'a> Fields<'a> {
    /// Finds the EXIF of a JPEG, PNG, TIFF or WebP file.
    pub fn of(file: &'a [u8]) -> Option<Self> {
        let block = exif_block(file)?;
        let little_endian = match block {
            [b'I', b'I', 42, 0, ..] => true,
            [b'M', b'M', 0, 42, ..] => false,
            _ => return None,
        };
        let mut fields = Self { block, little_endian, main: 0 };
        fields.main = fields.unsigned::<4>(block.get(4..)?)? as usize;
        Some(fields)
    }

    /// The first number of a field.
    pub fn number(&self, tag: Tag) -> Option<f64> {
        let Values { kind, bytes } = self.values(tag)?;
        Some(match kind {
            BYTE => f64::from(*bytes.first()?),
            SHORT => self.unsigned::<2>(bytes)? as f64,
            LONG => self.unsigned::<4>(bytes)? as f64,
            RATIONAL => self.ratio(bytes)?,
            SIGNED_RATIONAL => {
                let part = |at: usize| Some(f64::from(self.unsigned::<4>(bytes.get(at..)?)? as u32 as i32));
                part(0)? / part(4)?
            }
            // Not what the standard asks for, but written by software that rescales images.
            FLOAT => f64::from(f32::from_bits(self.unsigned::<4>(bytes)? as u32)),
            DOUBLE => f64::from_bits(self.unsigned::<8>(bytes)?),
            _ => return None,
        })
    }

    /// The first number of a field, where it is finite and above 0.
    pub fn positive(&self, tag: Tag) -> Option<f64> {
        self.number(tag).filter(|n| n.is_finite() && *n > 0.0)
    }

    /// Three ratios; those that the field lacks are 0.
    pub fn three_ratios(&self, tag: Tag) -> Option<[f64; 3]> {
        let values = self.values(tag).filter(|values| values.kind == RATIONAL)?;
        Some([0, 8, 16].map(|at| values.bytes.get(at..).and_then(|bytes| self.ratio(bytes)).unwrap_or(0.0)))
    }

    /// The first line of a text, without white space around it; absent where nothing is left.
    pub fn text(&self, tag: Tag) -> Option<String> {
        let values = self.values(tag).filter(|values| values.kind == TEXT)?;
        let line = values.bytes.split(|&byte| byte == 0).next()?;
        let line = String::from_utf8_lossy(&line[..line.len().min(MOST_TEXT_BYTES)]);
        let text = line.trim();
        (!text.is_empty()).then(|| text.to_owned())
    }

    /// The bytes of a field of single bytes.
    pub fn bytes(&self, tag: Tag) -> Option<&'a [u8]> {
        self.values(tag).filter(|values| values.kind == BYTE || values.kind == UNDEFINED).map(|values| values.bytes)
    }

    fn values(&self, (directory, number): Tag) -> Option<Values<'a>> {
        let at = match directory {
            Directory::Main => self.main,
            Directory::Exif => self.number(EXIF_DIRECTORY)? as usize,
            Directory::Gps => self.number(GPS_DIRECTORY)? as usize,
        };
        let directory = self.block.get(at..)?;
        let entries = self.unsigned::<2>(directory)? as usize;
        directory[2..]
            .chunks_exact(12)
            .take(entries.min(MOST_ENTRIES))
            .filter(|entry| self.unsigned::<2>(entry) == Some(number.into()))
            .find_map(|entry| self.values_of(entry))
    }

    /// The values of an entry: in its last four bytes, or where these say.
    fn values_of(&self, entry: &'a [u8]) -> Option<Values<'a>> {
        let kind = self.unsigned::<2>(&entry[2..])? as u16;
        let size = match kind {
            BYTE | TEXT | UNDEFINED => 1,
            SHORT => 2,
            LONG | FLOAT => 4,
            RATIONAL | SIGNED_RATIONAL | DOUBLE => 8,
            _ => return None,
        };
        let length = usize::try_from(self.unsigned::<4>(&entry[4..])?).ok()?.checked_mul(size)?;
        let place = if length <= 4 { &entry[8..] } else { self.block.get(self.unsigned::<4>(&entry[8..])? as usize..)? };
        Some(Values { kind, bytes: place.get(..length)? })
    }

    fn ratio(&self, bytes: &[u8]) -> Option<f64> {
        Some(self.unsigned::<4>(bytes)? as f64 / self.unsigned::<4>(bytes.get(4..)?)? as f64)
    }

    /// An unsigned number of `N` bytes.
    fn unsigned<const N: usize>(&self, bytes: &[u8]) -> Option<u64> {
        let bytes: &[u8; N] = bytes.first_chunk()?;
        let append = |n: u64, byte: &u8| n << 8 | u64::from(*byte);
        Some(if self.little_endian { bytes.iter().rev().fold(0, append) } else { bytes.iter().fold(0, append) })
    }
}
