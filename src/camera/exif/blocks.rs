//! Where a file holds its EXIF and its XMP.

/// The TIFF structure that holds the EXIF of a JPEG, PNG, TIFF or WebP file.
pub fn exif_block(file: &[u8]) -> Option<&[u8]> {
    match kind_of(file)? {
        Kind::Tiff => Some(file),
        Kind::Jpeg(segments) => application_segment(segments, b"Exif\0\0"),
        Kind::Png(chunks) => chunk_of(chunks, png_chunk, |name, data| (name == b"eXIf").then_some(data)),
        Kind::WebP(chunks) => chunk_of(chunks, webp_chunk, |name, data| (name == b"EXIF").then_some(data)),
    }
}

/// The XMP packet of a JPEG, PNG or WebP file: the standard one. What is too long for it stands in extended packets, as maps of depth do;
/// nothing that is read here is so long. That of a TIFF file is a field.
///
/// # Source
/// Adobe 2020, XMP Specification Part 3, sections 1.1.3 (JPEG), 1.1.5 (PNG); the container format of WebP.
pub fn xmp_packet(file: &[u8]) -> Option<&[u8]> {
    match kind_of(file)? {
        Kind::Tiff => None,
        Kind::Jpeg(segments) => application_segment(segments, b"http://ns.adobe.com/xap/1.0/\0"),
        // Not compressed, without a language.
        Kind::Png(chunks) => {
            chunk_of(chunks, png_chunk, |name, data| data.strip_prefix(b"XML:com.adobe.xmp\0\0\0\0\0").filter(|_| name == b"iTXt"))
        }
        Kind::WebP(chunks) => chunk_of(chunks, webp_chunk, |name, data| (name == b"XMP ").then_some(data)),
    }
}

/// A file by what follows its signature.
enum Kind<'a> {
    Tiff,
    Jpeg(&'a [u8]),
    Png(&'a [u8]),
    WebP(&'a [u8]),
}

fn kind_of(file: &[u8]) -> Option<Kind<'_>> {
    match file {
        [b'I', b'I', ..] | [b'M', b'M', ..] => Some(Kind::Tiff),
        [0xff, 0xd8, segments @ ..] => Some(Kind::Jpeg(segments)),
        [0x89, b'P', b'N', b'G', _, _, _, _, chunks @ ..] => Some(Kind::Png(chunks)),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', chunks @ ..] => Some(Kind::WebP(chunks)),
        _ => None,
    }
}

/// A chunk: its name, its data, and all that follows it.
type Chunk<'a> = (&'a [u8; 4], &'a [u8], &'a [u8]);

fn png_chunk(chunk: &[u8]) -> Option<Chunk<'_>> {
    let (length, chunk) = chunk.split_first_chunk()?;
    let (name, data) = chunk.split_first_chunk()?;
    let (data, rest) = data.split_at_checked(u32::from_be_bytes(*length) as usize)?;
    // A checksum follows.
    Some((name, data, rest.get(4..).unwrap_or_default()))
}

fn webp_chunk(chunk: &[u8]) -> Option<Chunk<'_>> {
    let (name, chunk) = chunk.split_first_chunk()?;
    let (length, data) = chunk.split_first_chunk()?;
    let length = u32::from_le_bytes(*length) as usize;
    let (data, rest) = data.split_at_checked(length)?;
    Some((name, data, rest.get(length & 1..).unwrap_or_default()))
}

/// What is wanted of the first chunk that has it.
fn chunk_of<'a>(
    mut chunks: &'a [u8],
    read: fn(&'a [u8]) -> Option<Chunk<'a>>,
    wanted: impl Fn(&[u8; 4], &'a [u8]) -> Option<&'a [u8]>,
) -> Option<&'a [u8]> {
    loop {
        let (name, data, rest) = read(chunks)?;
        if let Some(found) = wanted(name, data) {
            return Some(found);
        }
        chunks = rest;
    }
}

/// The first application segment 1 of a JPEG that begins so, without that.
fn application_segment<'a>(mut rest: &'a [u8], signature: &[u8]) -> Option<&'a [u8]> {
    loop {
        rest = &rest[rest.iter().position(|&byte| byte == 0xff)?..];
        rest = &rest[rest.iter().position(|&byte| byte != 0xff)?..];
        let (&marker, after) = rest.split_first()?;
        rest = after;
        match marker {
            // A stuffed byte, or a marker that stands alone.
            0x00 | 0x01 | 0xd0..=0xd7 => continue,
            0xd8 | 0xd9 => return None,
            _ => {}
        }
        let length = usize::from(u16::from_be_bytes(*rest.first_chunk()?));
        let (segment, after) = rest.split_at_checked(length)?;
        if marker == 0xe1
            && let Some(block) = segment.get(2..).and_then(|body| body.strip_prefix(signature))
        {
            return Some(block);
        }
        rest = after;
    }
}
