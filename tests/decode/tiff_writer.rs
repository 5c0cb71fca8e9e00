//! A writer of uncompressed TIFF files with any tags.

/// A tag with its values, each of 2 or 4 bytes.
pub enum Tag {
    Short(u16, Vec<u16>),
    Long(u16, Vec<u32>),
}

impl Tag {
    /// Its number, its type, how many values it has, and their bytes.
    pub fn encoded(&self, big_endian: bool) -> (u16, u16, u32, Vec<u8>) {
        let bytes2 = |v: u16| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
        let bytes4 = |v: u32| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
        match self {
            Tag::Short(tag, values) => (*tag, 3, values.len() as u32, values.iter().flat_map(|&v| bytes2(v)).collect()),
            Tag::Long(tag, values) => (*tag, 4, values.len() as u32, values.iter().flat_map(|&v| bytes4(v)).collect()),
        }
    }
}

/// The tags of an image in one uncompressed strip of `length` bytes that begins at byte 8.
pub fn one_strip(width: u32, height: u32, bits: u16, samples: u16, photometric: u16, length: usize) -> Vec<Tag> {
    vec![
        Tag::Long(256, vec![width]),
        Tag::Long(257, vec![height]),
        Tag::Short(258, vec![bits; usize::from(samples)]),
        Tag::Short(259, vec![1]),
        Tag::Short(262, vec![photometric]),
        Tag::Long(273, vec![8]),
        Tag::Short(277, vec![samples]),
        Tag::Long(278, vec![height]),
        Tag::Long(279, vec![length as u32]),
    ]
}

/// A file of these image data, at byte 8, followed by one directory of these tags.
pub fn write(big_endian: bool, data: &[u8], mut tags: Vec<Tag>) -> Vec<u8> {
    let number2 = |v: u16| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
    let number4 = |v: u32| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
    tags.sort_by_key(|tag| tag.encoded(false).0);
    let directory = 8 + data.len().next_multiple_of(2);
    let mut file = if big_endian { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
    file.extend(number4(directory as u32));
    file.extend(data);
    file.resize(directory, 0);
    file.extend(number2(tags.len() as u16));
    let mut far = Vec::new();
    let far_start = directory + 2 + 12 * tags.len() + 4;
    for tag in &tags {
        let (tag, kind, count, mut bytes) = tag.encoded(big_endian);
        file.extend(number2(tag));
        file.extend(number2(kind));
        file.extend(number4(count));
        if bytes.len() <= 4 {
            bytes.resize(4, 0);
            file.extend(bytes);
        } else {
            file.extend(number4((far_start + far.len()) as u32));
            far.extend(bytes);
        }
    }
    file.extend(number4(0));
    file.extend(far);
    file
}
