//! What hostile files cost: the most memory that decoding holds at any time, counted at the allocator.
#![cfg(not(target_arch = "wasm32"))]

#[path = "decode/headers.rs"]
mod headers;
#[path = "decode/jpeg_writer.rs"]
mod jpeg_writer;
#[path = "decode/tiff_writer.rs"]
mod tiff_writer;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};
use std::time::{Duration, Instant};

use tiepoint::{DecodeLimits, Decoded, Error, ExifImage};

/// Counts what is held.
struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);
/// One measurement at a time.
static MEASURING: Mutex<()> = Mutex::new(());

// SAFETY: every call goes to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(HELD.fetch_add(layout.size(), SeqCst) + layout.size(), SeqCst);
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(HELD.fetch_add(layout.size(), SeqCst) + layout.size(), SeqCst);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), SeqCst);
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The result of a call, the most memory it held beside what was held before, and the time it took.
fn cost<T>(call: impl FnOnce() -> T) -> (T, usize, Duration) {
    let before = HELD.load(SeqCst);
    MOST.store(before, SeqCst);
    let begun = Instant::now();
    let result = call();
    (result, MOST.load(SeqCst) - before, begun.elapsed())
}

fn decode(file: &[u8]) -> Result<Decoded, Error> {
    tiepoint::decode(file, &DecodeLimits::default())
}

const MB: usize = 1 << 20;

#[test]
fn a_header_that_declares_gigabytes_costs_no_memory() {
    let _alone = MEASURING.lock();
    for (format, file) in headers::headers(16_000, 15_000) {
        let (result, most, time) = cost(|| decode(&file));
        let error = result.expect_err(format);
        println!("{format} of {} bytes: {most} bytes, {time:?}", file.len());
        assert_eq!(error.code(), "unreadable-image", "{format}: {error}");
        assert!(most < MB && time < Duration::from_millis(100), "{format}: {most} bytes, {time:?}");
    }
}

#[test]
fn a_file_that_is_just_long_enough_is_not_refused_for_its_length() {
    let _alone = MEASURING.lock();
    // The smoothest image of each format: one colour.
    let (width, height) = (3_000, 2_000);
    let flat = image::DynamicImage::ImageLuma8(image::GrayImage::from_pixel(width, height, image::Luma([90])));
    for format in [image::ImageFormat::Png, image::ImageFormat::Bmp, image::ImageFormat::Tiff, image::ImageFormat::Pnm] {
        let mut file = std::io::Cursor::new(Vec::new());
        flat.write_to(&mut file, format).unwrap();
        let (result, most, _) = cost(|| decode(file.get_ref()));
        assert!(result.unwrap().grey.data().iter().all(|&v| v == 90), "{format:?}");
        assert!(most < 40 * MB, "{format:?}: {most} bytes");
    }
    let mut lossless = std::io::Cursor::new(Vec::new());
    flat.to_rgb8().write_to(&mut lossless, image::ImageFormat::WebP).unwrap();
    assert!(decode(lossless.get_ref()).is_ok(), "a WebP of {} bytes", lossless.get_ref().len());
    for progressive in [false, true] {
        let jpeg = jpeg_writer::Jpeg { progressive, ..jpeg_writer::Jpeg::baseline(width as u16, height as u16, &[(1, 1, 1)]) };
        assert!(decode(&jpeg.write(|_, _, _| 90)).is_ok());
    }
}

/// Deflated zeros in one block of fixed codes: 258 bytes a match of 13 bits.
fn deflated_zeros(matches: usize) -> Vec<u8> {
    let (mut bytes, mut pending, mut count) = (vec![0x78, 0x01], 0u32, 0);
    let mut push = |value: u32, length: u32| {
        for bit in 0..length {
            pending |= (value >> bit & 1) << count;
            count += 1;
            if count == 8 {
                bytes.push(pending as u8);
                (pending, count) = (0, 0);
            }
        }
    };
    // The last block, of fixed codes; a literal 0 (00110000), then matches of length 258 (11000101) at distance 1 (00000), then the end.
    push(0b011, 3);
    push(0b0000_1100, 8);
    for _ in 0..matches {
        push(0b1010_0011, 8);
        push(0, 5);
    }
    push(0, 7 + 7);
    bytes.extend([0; 4]);
    bytes
}

fn png_chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(name);
    checksum.update(data);
    [&(data.len() as u32).to_be_bytes()[..], name, data, &checksum.finalize().to_be_bytes()].concat()
}

#[test]
fn a_png_profile_or_text_that_inflates_to_gigabytes_is_ignored() {
    let _alone = MEASURING.lock();
    let mut png = std::io::Cursor::new(Vec::new());
    image::GrayImage::from_fn(64, 48, |x, y| image::Luma([(x * 3 + y) as u8])).write_to(&mut png, image::ImageFormat::Png).unwrap();
    let png = png.into_inner();
    let whole = decode(&png).unwrap();
    let zeros = deflated_zeros(700_000);
    for (name, head) in [(b"iCCP", &b"a\0\0"[..]), (b"zTXt", b"a\0\0"), (b"iTXt", b"a\0\x01\0\0\0")] {
        let chunk = png_chunk(name, &[head, &zeros].concat());
        // After the header of 33 bytes.
        let file = [&png[..33], &chunk, &png[33..]].concat();
        let (result, most, time) = cost(|| decode(&file));
        println!("{name:?} of {} bytes that inflates to {} MB: {most} bytes, {time:?}", chunk.len(), 258 * 700_000 / MB);
        assert_eq!(result.unwrap().grey, whole.grey);
        assert!(most < MB && time < Duration::from_millis(500), "{most} bytes, {time:?}");
    }
}

/// An entry of an EXIF directory.
fn entry(tag: u16, kind: u16, count: u32, value: u32) -> Vec<u8> {
    [&tag.to_le_bytes()[..], &kind.to_le_bytes(), &count.to_le_bytes(), &value.to_le_bytes()].concat()
}

/// A JPEG with this EXIF block.
fn with_exif(block: &[u8]) -> Vec<u8> {
    let mut file = vec![0xff, 0xd8];
    jpeg_writer::segment(&mut file, 0xe1, &[b"Exif\0\0", block].concat());
    file.extend(&jpeg_writer::Jpeg::baseline(16, 16, &[(1, 1, 1)]).write(|_, _, _| 99)[2..]);
    file
}

#[test]
fn nested_and_overlapping_exif_directories_cost_little() {
    let _alone = MEASURING.lock();
    let entries = 3_000u32;
    let block = |entry_of: &dyn Fn(u32) -> Vec<u8>| {
        let count = (entries as u16).to_le_bytes();
        [b"II*\0\x08\0\0\0".to_vec(), count.to_vec(), (0..entries).flat_map(entry_of).collect(), vec![0; 4]].concat()
    };
    // Each entry leads to the whole directory, or to a directory that begins inside it; or has a text of all bytes.
    let same = block(&|_| entry(0x8769, 4, 1, 8));
    let overlapping = block(&|i| entry([0x8769, 0x8825][i as usize % 2], 4, 1, 10 + 12 * i));
    let texts = block(&|i| entry([0x010f, 0x0110][i as usize % 2], 2, 12 * entries, 8));
    for (name, block) in [("the same", same), ("overlapping", overlapping), ("texts", texts)] {
        let file = with_exif(&block);
        let (result, most, time) = cost(|| decode(&file).map(|decoded| (decoded, ExifImage::read(&file, 16, 16))));
        println!("{name}: {} bytes of EXIF, {most} bytes, {time:?}", block.len());
        assert!(result.is_ok(), "{name}");
        assert!(most < MB && time < Duration::from_millis(200), "{name}: {most} bytes, {time:?}");
    }
    // A TIFF whose maker is all of a large file.
    let length = 50_000_000;
    let tiff = [b"II*\0\x08\0\0\0\x01\0", entry(0x010f, 2, length, 26).as_slice(), &vec![0; length as usize + 4]].concat();
    let (_, most, time) = cost(|| ExifImage::read(&tiff, 16, 16));
    assert!(most < MB && time < Duration::from_millis(200), "{most} bytes, {time:?}");
}

#[test]
fn megabytes_of_xmp_cost_little() {
    let _alone = MEASURING.lock();
    let attributes: String = (0..60_000).map(|k| format!(" a{k}=\"\" xmlns:b{k}=\"http://pix4d.com/camera/1.0\"")).collect();
    let packets = [
        "<drone-dji:Yaw>".repeat(200_000).into_bytes(),
        format!("<x{attributes}>").into_bytes(),
        "<a b='".repeat(200_000).into_bytes(),
        "&a;".repeat(400_000).into_bytes(),
        vec![0xff; 4 << 20],
        [b"<Camera:Yaw>".to_vec(), vec![b'9'; 4 << 20]].concat(),
        [b"<Camera:Yaw>".to_vec(), b"<rdf:li>1</rdf:li>".repeat(200_000)].concat(),
    ];
    for packet in packets {
        // A TIFF sets no limit to a packet's length.
        let tiff = [b"II*\0\x08\0\0\0\x01\0", entry(700, 1, packet.len() as u32, 26).as_slice(), &[0; 4], &packet].concat();
        let (read, most, time) = cost(|| ExifImage::read(&tiff, 16, 16));
        assert_eq!(read, ExifImage::default());
        // The text of the first megabyte, of which a byte that is none takes three.
        assert!(most < 8 * MB && time < Duration::from_millis(500), "{:?}: {most} bytes, {time:?}", &packet[..20]);
    }
}
