//! What is kept of images and pairs: flat binary records that know what they belong to and whether they are whole.
//!
//! A record is little-endian: the letters TPRC; 32 bits of version; 32 bits each of the length of its head and of its number of rows;
//! SHA-256 of all that follows; the head, JSON of the key and what the kind has; its columns, one after the other.

use crate::{Document, Error, FileFault, FilePlace, json};
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

const MAGIC: &[u8; 4] = b"TPRC";
const VERSION: u32 = 3;
const HEADER: usize = 48;

/// What is kept where: the first part of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Features,
    Likeness,
    Pair,
    Windows,
}

impl Kind {
    pub(super) fn folder(self) -> &'static str {
        match self {
            Self::Features => "features",
            Self::Likeness => "likeness",
            Self::Pair => "pairs",
            Self::Windows => "windows",
        }
    }
}

/// The digest of the sources that this build was made of.
pub(super) const BUILD: &str = env!("TIEPOINT_BUILD");

/// The key of a record: of its kind, of the build that makes it, and of all that it is made from.
pub(super) fn key_of(kind: Kind, build: &str, parts: &impl Serialize) -> String {
    let text = serde_json::to_vec(&(build, parts)).expect("plain data has a JSON form");
    format!("{}/{}", kind.folder(), digest(&text))
}

/// SHA-256 (FIPS 180-4) in hexadecimal digits.
pub fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A record that was read.
pub(super) struct Record<'a, H> {
    pub head: H,
    pub rows: usize,
    /// Its columns.
    pub body: &'a [u8],
}

/// Writes a record.
pub(super) fn write_record(key: &str, head: &impl Serialize, rows: usize, columns: &[&[u8]]) -> Vec<u8> {
    let head = serde_json::to_vec(&(key, head)).expect("plain data has a JSON form");
    let mut bytes = Vec::with_capacity(HEADER + head.len() + columns.iter().map(|column| column.len()).sum::<usize>());
    bytes.extend_from_slice(MAGIC);
    for number in [VERSION, head.len() as u32, rows as u32] {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes.resize(HEADER, 0);
    bytes.extend_from_slice(&head);
    columns.iter().for_each(|column| bytes.extend_from_slice(column));
    let sum = Sha256::digest(&bytes[HEADER..]);
    bytes[16..HEADER].copy_from_slice(&sum);
    bytes
}

/// Whether the checksum of a record is right.
pub(super) fn is_whole(bytes: &[u8]) -> bool {
    bytes.split_at_checked(HEADER).is_some_and(|(front, rest)| Sha256::digest(rest)[..] == front[16..])
}

/// Reads a record whose columns have the length that its head and number of rows call for; absent where the bytes are not of this key, of
/// another version or cut off. The checksum is not looked at: that takes longer than all the rest.
pub(super) fn read_record<'a, H: DeserializeOwned>(
    key: &str,
    bytes: &'a [u8],
    body_bytes: impl Fn(&H, usize) -> usize,
) -> Option<Record<'a, H>> {
    let (front, rest) = bytes.split_at_checked(HEADER)?;
    let number = |at: usize| u32::from_le_bytes([front[at], front[at + 1], front[at + 2], front[at + 3]]);
    if &front[..4] != MAGIC || number(4) != VERSION {
        return None;
    }
    let (head, body) = rest.split_at_checked(number(8) as usize)?;
    let (own, head): (String, H) = json::from_text(str::from_utf8(head).ok()?).ok()?;
    let rows = number(12) as usize;
    (own == key && body.len() == body_bytes(&head, rows)).then_some(Record { head, rows, body })
}

/// A record that the run itself has made or found, and that must read.
pub(super) fn kept<T>(key: &str, read: Option<T>) -> Result<T, Error> {
    read.ok_or_else(|| {
        let file_place = Some(FilePlace::Path { path: key.into() });
        Error::UnreadableFile { document: Document::KeptRecord, file_place, file_fault: FileFault::RecordChanged }
    })
}

/// Numbers as a column.
pub(super) fn column<const N: usize, T: Copy>(values: impl IntoIterator<Item = T>, bytes_of: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.into_iter().flat_map(bytes_of).collect()
}

/// The rows of a column of `N` numbers of four bytes each.
pub(super) fn rows_of<const N: usize, T>(column: &[u8], number: impl Fn([u8; 4]) -> T) -> Vec<[T; N]> {
    column.as_chunks::<4>().0.as_chunks::<N>().0.iter().map(|row| row.map(&number)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_that_is_damaged_or_of_another_key_does_not_read() {
        let whole = write_record("pairs/1", &"head", 2, &[&[1; 8], &[2; 4]]);
        let reads = |key: &str, bytes: &[u8]| {
            let read = read_record::<String>(key, bytes, |_, rows| 6 * rows).filter(|_| is_whole(bytes))?;
            Some((read.head, read.rows, read.body.to_vec()))
        };
        assert_eq!(reads("pairs/1", &whole), Some(("head".into(), 2, [[1; 8].as_slice(), &[2; 4]].concat())));
        assert!(reads("pairs/2", &whole).is_none());
        for length in 0..whole.len() {
            assert!(reads("pairs/1", &whole[..length]).is_none(), "{length}");
            let mut flipped = whole.clone();
            flipped[length] ^= 1;
            // The number of rows is not part of what is summed up, but of the length.
            assert!(reads("pairs/1", &flipped).is_none(), "{length}");
        }
    }

    #[test]
    fn records_of_another_build_are_never_taken() {
        const ALL: [Kind; 4] = [Kind::Features, Kind::Likeness, Kind::Pair, Kind::Windows];
        for kind in ALL {
            let [one, other, again] = ["a", "b", "a"].map(|build| key_of(kind, build, &("content", 7)));
            assert!(one != other && one == again, "{kind:?}");
            assert!(one.starts_with(&format!("{}/", kind.folder())));
        }
        let keys: Vec<String> = ALL.iter().map(|kind| key_of(*kind, BUILD, &1)).collect();
        assert!(keys.iter().all(|key| key.len() > 64) && BUILD.len() == 64, "{keys:?}");
    }

    #[test]
    fn digests_are_those_of_the_standard() {
        assert_eq!(digest(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
