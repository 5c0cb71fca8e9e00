//! The fields of EXIF, read where they stand: a hostile block costs no memory, and time for three directories at most.

use super::blocks::exif_block;
use crate::FileSource;

/// Directories hold some dozens of entries; more than these are not read.
const MOST_ENTRIES: u64 = 1_000;
/// Text is cut there.
const MOST_TEXT_BYTES: u64 = 1_000;

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
pub struct Fields<S> {
    block: S,
    little_endian: bool,
    main: u64,
}

/// The values of a field: where they stand.
struct Values {
    kind: u16,
    at: u64,
    length: u64,
}

impl<'a> Fields<&'a [u8]> {
    /// Finds the EXIF of a JPEG, PNG, TIFF or WebP file.
    pub fn of(file: &'a [u8]) -> Option<Self> {
        Self::of_block(exif_block(file)?)
    }

    /// The bytes of a field of single bytes.
    pub fn bytes(&self, tag: Tag) -> Option<&'a [u8]> {
        let Values { at, length, .. } = self.values(tag).filter(|values| values.kind == BYTE || values.kind == UNDEFINED)?;
        self.block.get(at as usize..)?.get(..length as usize)
    }
}

impl<S: FileSource> Fields<S> {
    /// Of the TIFF structure itself, which a TIFF file is.
    pub fn of_block(block: S) -> Option<Self> {
        let mut start = [0; 4];
        block.read_at(0, &mut start).ok()?;
        let little_endian = match &start {
            [b'I', b'I', 42, 0] => true,
            [b'M', b'M', 0, 42] => false,
            _ => return None,
        };
        let mut fields = Self { block, little_endian, main: 0 };
        fields.main = fields.unsigned::<4>(4)?;
        Some(fields)
    }

    /// The first number of a field.
    pub fn number(&self, tag: Tag) -> Option<f64> {
        let values = self.values(tag)?;
        Some(match values.kind {
            BYTE => self.part::<1>(&values, 0)? as f64,
            SHORT => self.part::<2>(&values, 0)? as f64,
            LONG => self.part::<4>(&values, 0)? as f64,
            RATIONAL => self.ratio(&values, 0)?,
            SIGNED_RATIONAL => {
                let part = |from: u64| Some(f64::from(self.part::<4>(&values, from)? as u32 as i32));
                part(0)? / part(4)?
            }
            // Not what the standard asks for, but written by software that rescales images.
            FLOAT => f64::from(f32::from_bits(self.part::<4>(&values, 0)? as u32)),
            DOUBLE => f64::from_bits(self.part::<8>(&values, 0)?),
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
        Some([0, 8, 16].map(|from| self.ratio(&values, from).unwrap_or(0.0)))
    }

    /// The first line of a text, without white space around it; absent where nothing is left.
    pub fn text(&self, tag: Tag) -> Option<String> {
        let Values { at, length, .. } = self.values(tag).filter(|values| values.kind == TEXT)?;
        let mut bytes = vec![0; length.min(MOST_TEXT_BYTES) as usize];
        self.block.read_at(at, &mut bytes).ok()?;
        let line = String::from_utf8_lossy(bytes.split(|&byte| byte == 0).next()?);
        let text = line.trim();
        (!text.is_empty()).then(|| text.to_owned())
    }

    fn values(&self, (directory, number): Tag) -> Option<Values> {
        let at = match directory {
            Directory::Main => self.main,
            Directory::Exif => self.number(EXIF_DIRECTORY)? as u64,
            Directory::Gps => self.number(GPS_DIRECTORY)? as u64,
        };
        let entries = self.unsigned::<2>(at)?.min(MOST_ENTRIES);
        let places = (0..entries).map(|entry| at + 2 + 12 * entry);
        // An entry that is cut off is none.
        let whole = places.take_while(|&entry| entry + 12 <= self.block.length());
        whole.filter(|&entry| self.unsigned::<2>(entry) == Some(number.into())).find_map(|entry| self.values_of(entry))
    }

    /// The values of an entry: in its last four bytes, or where these say.
    fn values_of(&self, entry: u64) -> Option<Values> {
        let kind = self.unsigned::<2>(entry + 2)? as u16;
        let size = match kind {
            BYTE | TEXT | UNDEFINED => 1,
            SHORT => 2,
            LONG | FLOAT => 4,
            RATIONAL | SIGNED_RATIONAL | DOUBLE => 8,
            _ => return None,
        };
        let length = self.unsigned::<4>(entry + 4)? * size;
        let at = if length <= 4 { entry + 8 } else { self.unsigned::<4>(entry + 8)? };
        (at + length <= self.block.length()).then_some(Values { kind, at, length })
    }

    fn ratio(&self, values: &Values, from: u64) -> Option<f64> {
        Some(self.part::<4>(values, from)? as f64 / self.part::<4>(values, from + 4)? as f64)
    }

    /// An unsigned number of `N` bytes within the values of a field.
    fn part<const N: usize>(&self, values: &Values, from: u64) -> Option<u64> {
        (from + N as u64 <= values.length).then(|| self.unsigned::<N>(values.at + from))?
    }

    /// An unsigned number of `N` bytes.
    fn unsigned<const N: usize>(&self, at: u64) -> Option<u64> {
        let mut bytes = [0; N];
        self.block.read_at(at, &mut bytes).ok()?;
        let append = |n: u64, byte: &u8| n << 8 | u64::from(*byte);
        Some(if self.little_endian { bytes.iter().rev().fold(0, append) } else { bytes.iter().fold(0, append) })
    }
}
