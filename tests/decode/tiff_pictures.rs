//! A writer of uncompressed TIFF files of several pictures, in tiles or strips.

use super::tiff_writer::Tag;

/// A tag as it is written: number, type, how many values, their bytes.
pub type Encoded = (u16, u16, u32, Vec<u8>);

/// A picture of a file: its tags but for those of its tiles or strips.
pub struct Picture {
    pub tags: Vec<Tag>,
    pub chunks: Vec<Vec<u8>>,
    pub tiled: bool,
    /// Tags of bytes and texts, as they are written.
    pub more: Vec<Encoded>,
}

/// A file of these pictures: the directories one after the other in front, then what they hold.
pub fn directories(pictures: &[Picture]) -> Vec<u8> {
    let mut file = b"II*\0".to_vec();
    file.extend(8_u32.to_le_bytes());
    let encoded: Vec<Vec<Encoded>> = pictures.iter().map(|picture| picture.encoded(&mut 0)).collect();
    let length =
        |tags: &[Encoded]| 2 + 12 * tags.len() + 4 + tags.iter().map(|tag| if tag.3.len() > 4 { tag.3.len() } else { 0 }).sum::<usize>();
    let mut data = 8 + encoded.iter().map(|tags| length(tags)).sum::<usize>();
    for (k, picture) in pictures.iter().enumerate() {
        let tags = picture.encoded(&mut data);
        let (start, end) = (file.len(), file.len() + length(&tags));
        file.extend((tags.len() as u16).to_le_bytes());
        let mut far = Vec::new();
        for (tag, kind, count, mut bytes) in tags.iter().cloned() {
            file.extend(tag.to_le_bytes());
            file.extend(kind.to_le_bytes());
            file.extend(count.to_le_bytes());
            if bytes.len() > 4 {
                file.extend(((start + 2 + 12 * tags.len() + 4 + far.len()) as u32).to_le_bytes());
                far.extend(bytes);
            } else {
                bytes.resize(4, 0);
                file.extend(bytes);
            }
        }
        file.extend((if k + 1 < pictures.len() { end as u32 } else { 0 }).to_le_bytes());
        file.extend(far);
    }
    pictures.iter().flat_map(|picture| &picture.chunks).for_each(|chunk| file.extend(chunk));
    file
}

impl Picture {
    /// Its tags in order; its tiles or strips begin at this byte, which becomes that after the last.
    fn encoded(&self, at: &mut usize) -> Vec<Encoded> {
        let lengths: Vec<u32> = self.chunks.iter().map(|chunk| chunk.len() as u32).collect();
        let offsets = self.chunks.iter().map(|chunk| {
            *at += chunk.len();
            (*at - chunk.len()) as u32
        });
        let [offsets_tag, lengths_tag] = if self.tiled { [324, 325] } else { [273, 279] };
        let own = [Tag::Long(offsets_tag, offsets.collect()), Tag::Long(lengths_tag, lengths)];
        let mut tags: Vec<_> = self.tags.iter().chain(&own).map(|tag| tag.encoded(false)).collect();
        tags.extend(self.more.iter().cloned());
        tags.sort_by_key(|tag| tag.0);
        tags
    }
}
