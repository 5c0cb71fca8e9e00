//! Files of kinds that are not decoded are refused by the name of their kind.

use super::decode;
use super::samples::{HEIGHT, WIDTH, noise, tiff};
use super::tiff_writer::{Tag, one_strip, write};
use image::ExtendedColorType;
use tiepoint::{Error, FileKind, Unsupported, refused_kind};

fn kind_of(error: Option<Error>) -> Option<FileKind> {
    match error {
        Some(Error::UnsupportedImage { unsupported: Unsupported::Kind { file_kind, .. } }) => Some(file_kind),
        Some(other) => panic!("{other}"),
        None => None,
    }
}

fn raw(ending: &str) -> Option<FileKind> {
    Some(FileKind::CameraRaw { ending: ending.into() })
}

/// A box of an ISO base media file: its brand, a version, and those that it is compatible with.
fn branded(major: &str, others: &[&str]) -> Vec<u8> {
    let length = 16 + 4 * others.len() as u32;
    let mut file = [&length.to_be_bytes(), b"ftyp".as_slice(), major.as_bytes(), &[0; 4]].concat();
    others.iter().for_each(|brand| file.extend(brand.as_bytes()));
    file.resize(200, 0);
    file
}

/// A TIFF whose samples are those of a sensor (colour filter array, 32803), as raw files keep them, with more tags.
fn of_sensor(more: Vec<Tag>) -> Vec<u8> {
    let tags = one_strip(8, 8, 16, 1, 32_803, 128);
    write(false, &[0; 128], tags.into_iter().chain(more).collect())
}

#[test]
fn a_picture_of_another_kind_is_named_by_its_content_with_what_to_do() {
    let pad = |start: &[u8]| [start, &[0; 100]].concat();
    for (file, kind) in [
        (branded("heic", &["mif1", "heic"]), FileKind::Heic),
        (branded("mif1", &["mif1", "heic"]), FileKind::Heic),
        (branded("mif1", &["mif1", "avif"]), FileKind::Avif),
        (branded("avif", &["mif1"]), FileKind::Avif),
        (branded("crx ", &["isom"]), FileKind::CameraRaw { ending: "CR3".into() }),
        (branded("isom", &["avc1"]), FileKind::Video),
        (branded("qt  ", &[]), FileKind::Video),
        (pad(b"\0\0\0\x0cJXL \x0d\x0a\x87\x0a"), FileKind::JpegXl),
        (pad(b"\xff\x0a"), FileKind::JpegXl),
        (pad(b"\0\0\0\x0cjP  \x0d\x0a\x87\x0a"), FileKind::Jpeg2000),
        (pad(b"\xff\x4f\xff\x51"), FileKind::Jpeg2000),
        (pad(b"msid"), FileKind::MrSid),
        (pad(b"8BPS\0\x01"), FileKind::Photoshop),
        (pad(b"GIF89a"), FileKind::Gif),
        (pad(b"%PDF-1.7"), FileKind::Pdf),
        (pad(b"PK\x03\x04"), FileKind::Archive),
        (pad(b"RIFF\0\0\0\0AVI LIST"), FileKind::Video),
        (pad(b"FUJIFILMCCD-RAW 0201"), FileKind::CameraRaw { ending: "RAF".into() }),
        (pad(b"IIU\0\x08\0\0\0"), FileKind::CameraRaw { ending: "RW2".into() }),
        (pad(b"IIRO\x08\0\0\0"), FileKind::CameraRaw { ending: "ORF".into() }),
    ] {
        let decoded = decode(&file).expect_err("it is not decoded");
        assert_eq!(kind_of(Some(decoded.clone())), Some(kind.clone()), "{decoded}");
        // The same by its first bytes, whatever it is called.
        assert_eq!(kind_of(refused_kind("photo.jpg", &file[..64])), Some(kind));
    }
    let text = decode(&branded("heic", &["mif1"])).unwrap_err().to_string();
    assert_eq!(
        text,
        "HEIC pictures are not read: export them as JPEG (on an iPhone, for new ones: Settings, Camera, Formats, Most Compatible); \
         allowed: JPEG, PNG, TIFF, BMP, PNM (PBM, PGM, PPM, PAM), WebP"
    );
}

#[test]
fn what_its_content_does_not_tell_its_name_does() {
    let archives = [("points.xlsx", None), ("a.zip", Some(FileKind::Archive)), ("a", Some(FileKind::Archive))]
        .map(|(name, kind)| (name, &b"PK\x03\x04"[..], kind));
    let texts =
        [("marks.csv", &b"msid,col,row"[..], None), ("marks.csv", b"MMOR_0001.JPG,1,2", None), ("list.txt", b"all_mdat of a flight", None)];
    for (name, start, kind) in archives.into_iter().chain(texts) {
        assert_eq!(kind_of(refused_kind(name, start)), kind, "{name}");
    }
    for (name, kind) in
        [("a.ECW", Some(FileKind::Ecw)), ("b.heic", Some(FileKind::Heic)), ("c.NEF", raw("NEF")), ("d.txt", None), ("heic", None)]
    {
        assert_eq!(kind_of(refused_kind(name, b"no signature at all")), kind, "{name}");
    }
    // An empty file is refused as that.
    assert_eq!(refused_kind("a.heic", &[]), None);
    // A JPEG that a telephone calls HEIC is read.
    assert_eq!(refused_kind("a.heic", &[0xff, 0xd8, 0xff, 0xe1, 0, 16]), None);
}

#[test]
fn a_raw_tiff_is_named_and_one_whose_first_image_is_read_is_read() {
    let dng = of_sensor(vec![Tag::Short(50_706, vec![1, 4])]);
    let mut cr2 = of_sensor(Vec::new());
    cr2[8..10].copy_from_slice(b"CR");
    for (file, ending) in [(&dng, "DNG"), (&cr2, "CR2")] {
        assert_eq!(kind_of(decode(file).err()), raw(ending));
        assert_eq!(kind_of(refused_kind("photo", file)), raw(ending));
    }
    // Only the name of the file says that these are raw; a TIFF of the same content is refused for its samples.
    let plain = of_sensor(Vec::new());
    assert_eq!(kind_of(refused_kind("photo.NEF", &plain)), raw("NEF"));
    assert_eq!(refused_kind("photo.tif", &plain), None);
    assert!(matches!(decode(&plain), Err(Error::UnsupportedImage { unsupported: Unsupported::TiffColours { .. } })));

    // The preview of a raw file is read by no name: it is not the photograph.
    let preview = |more: Tag| {
        let tags = one_strip(8, 8, 8, 1, 1, 64).into_iter().chain([Tag::Long(254, vec![1]), more]).collect();
        write(false, &[0; 64], tags)
    };
    let with_preview = preview(Tag::Short(50_706, vec![1, 4]));
    assert_eq!(kind_of(decode(&with_preview).err()), raw("DNG"));
    assert_eq!(kind_of(refused_kind("photo.tif", &with_preview)), raw("DNG"));
    // A smaller copy of a picture is one.
    assert!(decode(&preview(Tag::Short(274, vec![1]))).is_ok());

    let readable = tiff(&noise(1, (WIDTH * HEIGHT) as usize), ExtendedColorType::L8);
    assert_eq!(refused_kind("preview.dng", &readable), None);
    // A directory beyond the first bytes says nothing yet.
    assert_eq!(refused_kind("photo.dng", &dng[..64]), None);
}
