//! The GNSS position that an image records, without the rest of its file.

use super::ExifPosition;
use super::fields::Fields;
use super::position;
use crate::FileSource;

/// So many bytes of a JPEG hold its EXIF, which comes before all but a header of one segment and stands in one itself: 64 KiB each. With room for a segment of
/// XMP before it.
const HEAD_BYTES: u64 = 1 << 18;

impl ExifPosition {
    /// The position that the EXIF of a file records, of which no more than that is read: of a TIFF its directories, wherever they lie; of a JPEG, PNG or WebP
    /// what stands in its first 256 KiB. Absent where none is found, and where the file cannot be read.
    pub fn of_file<S: FileSource>(file: S) -> Option<Self> {
        let mut start = [0; 2];
        file.read_at(0, &mut start).ok()?;
        if matches!(&start, b"II" | b"MM") {
            return position(&Fields::of_block(file)?).0;
        }
        let mut head = vec![0; file.length().min(HEAD_BYTES) as usize];
        file.read_at(0, &mut head).ok()?;
        position(&Fields::of(&head)?).0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ExifImage;
    use std::io;
    use std::sync::Mutex;

    /// A file of so many bytes that are 0 but for its start and another part, with how many of them were read.
    struct Sparse {
        length: u64,
        start: Vec<u8>,
        at: u64,
        part: Vec<u8>,
        read: Mutex<u64>,
    }

    impl FileSource for &Sparse {
        fn length(&self) -> u64 {
            self.length
        }

        fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
            if at.checked_add(into.len() as u64).is_none_or(|end| end > self.length) {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            *self.read.lock().unwrap() += into.len() as u64;
            for (place, byte) in (at..).zip(into) {
                let of = |from: u64, bytes: &[u8]| place.checked_sub(from).and_then(|i| bytes.get(i as usize).copied());
                *byte = of(0, &self.start).or_else(|| of(self.at, &self.part)).unwrap_or(0);
            }
            Ok(())
        }
    }

    impl Sparse {
        fn new(length: u64, start: Vec<u8>, at: u64, part: Vec<u8>) -> Self {
            Self { length, start, at, part, read: Mutex::new(0) }
        }
    }

    /// A main directory that stands there, and behind it one of GPS: 30° 15' north, 98° 30' west.
    fn directories(at: u32) -> Vec<u8> {
        let entry = |tag: u16, kind: u16, count: u32, value: [u8; 4]| {
            [&tag.to_be_bytes()[..], &kind.to_be_bytes(), &count.to_be_bytes(), &value].concat()
        };
        let gps = at + 2 + 12 + 4;
        let values = gps + 2 + 4 * 12 + 4;
        let ratios = |degrees: u32, minutes: u32| [degrees, 1, minutes, 1, 0, 1].map(u32::to_be_bytes).concat();
        let main = [&[0, 1][..], &entry(0x8825, 4, 1, gps.to_be_bytes()), &[0; 4]].concat();
        let fields = [
            entry(1, 2, 2, *b"N\0\0\0"),
            entry(2, 5, 3, values.to_be_bytes()),
            entry(3, 2, 2, *b"W\0\0\0"),
            entry(4, 5, 3, (values + 24).to_be_bytes()),
        ];
        [main, vec![0, 4], fields.concat(), vec![0; 4], ratios(30, 15), ratios(98, 30)].concat()
    }

    #[test]
    fn of_a_large_tiff_no_more_than_its_directories_is_read() {
        let at: u32 = 3_000_000_000;
        let start = [&b"MM\0*"[..], &at.to_be_bytes()].concat();
        let length = u64::from(at) + 5_000;
        let scan = Sparse::new(length, start.clone(), at.into(), directories(at));
        let found = ExifPosition::of_file(&scan).unwrap();
        assert_eq!((found.longitude_deg, found.latitude_deg, found.height_m), (-98.5, 30.25, None));
        let read = *scan.read.lock().unwrap();
        assert!(read < 1_000, "{read} bytes");
        // Without GNSS, as scans of film, cut off, and where a directory lies outside.
        let none = Sparse::new(length, start.clone(), at.into(), vec![0; 100]);
        assert_eq!((ExifPosition::of_file(&none), *none.read.lock().unwrap() < 1_000), (None, true));
        for length in [u64::from(at) + 40, u64::from(at) + 1, 8, 3, 0] {
            assert_eq!(ExifPosition::of_file(&Sparse::new(length, start.clone(), at.into(), directories(at))), None, "{length}");
        }
    }

    #[test]
    fn of_a_large_jpeg_no_more_than_its_head_is_read() {
        let position = ExifPosition { longitude_deg: 8.0, latitude_deg: 50.0, height_m: Some(120.0), error_m: None };
        let block = ExifImage { position: Some(position), ..ExifImage::default() }.block();
        let length = (2 + 6 + block.len() as u16).to_be_bytes();
        let start = [&[0xff, 0xd8, 0xff, 0xe1][..], &length, b"Exif\0\0", &block].concat();
        assert_eq!(ExifPosition::of_file(start.as_slice()), Some(position));
        let photo = Sparse::new(50_000_000, start, 0, Vec::new());
        assert_eq!(ExifPosition::of_file(&photo), Some(position));
        let read = *photo.read.lock().unwrap();
        assert!(read <= HEAD_BYTES + 2, "{read} bytes");
        assert_eq!(ExifPosition::of_file(&b"no file of a known kind"[..]), None);
    }
}
