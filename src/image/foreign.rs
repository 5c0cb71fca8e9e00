//! Files that people give as photographs and that are not decoded: which kind they are, so that the refusal says what to do.

use super::layout::Format;
use super::tiff::Directory;
use crate::source::FileSource;
use crate::{Error, FileKind, Unsupported};

/// Endings of raw files of cameras.
const RAW: [&str; 18] =
    ["dng", "cr2", "cr3", "crw", "nef", "nrw", "arw", "srf", "sr2", "raf", "orf", "rw2", "pef", "srw", "3fr", "iiq", "rwl", "x3f"];

/// Brands of the ISO base media file format (ISO/IEC 14496-12, 23008-12).
const HEIC: [&[u8]; 10] = [b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"hevm", b"hevs", b"mif1", b"msf1"];
const AVIF: [&[u8]; 2] = [b"avif", b"avis"];

/// Smaller bytes stand in no text: beside a length or a version the letters of a signature are one.
const CONTROL: u8 = 0x20;

/// The version of DNG; what the picture is, of which the lowest bit says a smaller copy; directories beside the first one; the maker of the camera.
const DNG_VERSION: u64 = 50_706;
const SUBFILE_TYPE: u64 = 254;
const SUB_DIRECTORIES: u64 = 330;
const MAKE: u64 = 271;

/// The refusal of a kind.
pub(super) fn refused(file_kind: FileKind) -> Error {
    Unsupported::Kind { file_kind, formats: Format::ALL }.into_error()
}

/// The kind that the first bytes name.
pub(super) fn by_content(start: &[u8]) -> Option<FileKind> {
    match start {
        [0..CONTROL, _, _, _, b'f', b't', b'y', b'p', brands @ ..] => Some(of_brands(brands)),
        [0, 0, 0, 12, b'J', b'X', b'L', b' ', ..] | [0xff, 0x0a, ..] => Some(FileKind::JpegXl),
        [0, 0, 0, 12, b'j', b'P', b' ', b' ', ..] | [0xff, 0x4f, 0xff, 0x51, ..] => Some(FileKind::Jpeg2000),
        [b'm', b's', b'i', b'd', 0..CONTROL, ..] => Some(FileKind::MrSid),
        [b'8', b'B', b'P', b'S', ..] => Some(FileKind::Photoshop),
        [b'G', b'I', b'F', b'8', b'7' | b'9', b'a', ..] => Some(FileKind::Gif),
        [b'%', b'P', b'D', b'F', ..] => Some(FileKind::Pdf),
        [b'P', b'K', 3, 4, ..] | [b'7', b'z', 0xbc, 0xaf, ..] | [b'R', b'a', b'r', b'!', ..] => Some(FileKind::Archive),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'A', b'V', b'I', b' ', ..] | [0x1a, 0x45, 0xdf, 0xa3, ..] => Some(FileKind::Video),
        // Films of QuickTime of before brands.
        [0..CONTROL, _, _, _, b'm', b'o', b'o', b'v', ..] | [0..CONTROL, _, _, _, b'm', b'd', b'a', b't', ..] => Some(FileKind::Video),
        _ if start.starts_with(b"FUJIFILMCCD-RAW") => Some(raw("raf")),
        _ if start.starts_with(b"IIU\0") => Some(raw("rw2")),
        [b'I', b'I', b'R', b'O' | b'S', 0..CONTROL, ..] | [b'M', b'M', b'O', b'R', 0..CONTROL, ..] => Some(raw("orf")),
        [b'F', b'O', b'V', b'b', 0..CONTROL, ..] => Some(raw("x3f")),
        _ => None,
    }
}

/// By the major brand, then by those that the file says it is compatible with: a `mif1` may hold either codec.
fn of_brands(brands: &[u8]) -> FileKind {
    let (listed, _) = brands.as_chunks::<4>();
    // Between the first one and the others stands a version.
    let mut named = listed.iter().enumerate().filter(|(at, _)| *at != 1).map(|(_, brand)| brand.as_slice()).take(8);
    match listed.first().map(<[u8; 4]>::as_slice) {
        Some(b"crx ") => raw("cr3"),
        Some(b"jxl ") => FileKind::JpegXl,
        Some(b"jp2 " | b"jpx ") => FileKind::Jpeg2000,
        Some(first) if HEIC.contains(&first) || AVIF.contains(&first) => {
            if named.any(|brand| AVIF.contains(&brand)) {
                FileKind::Avif
            } else {
                FileKind::Heic
            }
        }
        _ => FileKind::Video,
    }
}

/// The kind of raw file whose first picture is a preview of it, some hundred pixels wide: it is not the photograph.
pub(super) fn raw_with_preview<S: FileSource + Copy>(source: S) -> Option<FileKind> {
    let subfile_type = Directory::first(source)?.value(SUBFILE_TYPE)?;
    (subfile_type & 1 == 1).then(|| raw_tiff(source)).flatten()
}

/// The kind of raw file that a TIFF with this first directory is. Asked where what that declares is not decoded.
pub(super) fn raw_tiff<S: FileSource>(source: S) -> Option<FileKind> {
    let mut start = [0; 10];
    if source.read_at(0, &mut start).is_ok() && start.ends_with(b"CR") {
        return Some(raw("cr2"));
    }
    let directory = Directory::first(source)?;
    if directory.value(DNG_VERSION).is_some() {
        return Some(raw("dng"));
    }
    directory.value(SUB_DIRECTORIES)?;
    let make = directory.text(MAKE)?.to_ascii_uppercase();
    [("NIKON", "nef"), ("SONY", "arw"), ("PENTAX", "pef")]
        .into_iter()
        .find(|(maker, _)| make.starts_with(maker))
        .map(|(_, ending)| raw(ending))
}

fn raw(ending: &str) -> FileKind {
    FileKind::CameraRaw { ending: ending.to_ascii_uppercase() }
}

/// The same of raw files alone.
pub(super) fn raw_by_ending(ending: &str) -> Option<FileKind> {
    RAW.contains(&ending).then(|| raw(ending))
}

/// Whether files with this ending are archives, too, but of no pictures that anybody would unpack.
pub(super) fn is_zipped_document(ending: &str) -> bool {
    ["docx", "xlsx", "pptx", "odt", "ods", "odp", "kmz", "qgz"].contains(&ending)
}

/// The kind that the ending of a name says, in small letters.
pub(super) fn by_ending(ending: &str) -> Option<FileKind> {
    match ending {
        "heic" | "heif" | "hif" => Some(FileKind::Heic),
        "avif" => Some(FileKind::Avif),
        "jxl" => Some(FileKind::JpegXl),
        "jp2" | "j2k" | "jpf" | "jpx" | "j2c" => Some(FileKind::Jpeg2000),
        "ecw" => Some(FileKind::Ecw),
        "sid" => Some(FileKind::MrSid),
        "psd" | "psb" => Some(FileKind::Photoshop),
        "gif" => Some(FileKind::Gif),
        "pdf" => Some(FileKind::Pdf),
        "mp4" | "mov" | "m4v" | "avi" | "mkv" | "mts" | "m2ts" | "webm" => Some(FileKind::Video),
        "zip" | "7z" | "rar" => Some(FileKind::Archive),
        _ => raw_by_ending(ending),
    }
}
