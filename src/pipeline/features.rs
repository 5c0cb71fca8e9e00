//! Features of an image, where its mask lets them be, as they are kept.

use super::mask_file::decode_mask;
use super::records::{column, digest, is_whole, kept, read_record, rows_of, write_record};
use super::task::FeatureTask;
use crate::{DESCRIPTOR_BYTES, DecodeLimits, Decoded, Error, ExifImage, GreyImage, decode, features as find};
use serde::{Deserialize, Serialize};

/// Bytes of a feature's position, and of its shape: scale, direction and weight.
const POSITION: usize = 8;
const SHAPE: usize = 12;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct FeatureHead {
    pub width_px: u32,
    pub height_px: u32,
    pub exif: ExifImage,
}

/// A record of features.
pub(super) struct Features<'a> {
    pub head: FeatureHead,
    pub count: usize,
    positions: &'a [u8],
    shapes: &'a [u8],
    pub descriptors: &'a [[u8; DESCRIPTOR_BYTES]],
}

impl<'a> Features<'a> {
    pub fn read(key: &str, bytes: &'a [u8]) -> Option<Self> {
        let record = read_record::<FeatureHead>(key, bytes, |_, rows| rows * (POSITION + SHAPE + DESCRIPTOR_BYTES))?;
        let (positions, rest) = record.body.split_at(POSITION * record.rows);
        let (shapes, descriptors) = rest.split_at(SHAPE * record.rows);
        Some(Self { head: record.head, count: record.rows, positions, shapes, descriptors: descriptors.as_chunks().0 })
    }

    pub fn kept(key: &str, bytes: &'a [u8]) -> Result<Self, Error> {
        kept(key, Self::read(key, bytes).filter(|_| is_whole(bytes)))
    }

    /// x and y in px.
    pub fn positions(&self) -> Vec<[f32; 2]> {
        rows_of(self.positions, f32::from_le_bytes)
    }

    /// A digest of all features, which images of the same pixels share, whatever else their files hold; absent where there are none.
    pub fn digest(&self) -> Option<String> {
        let all = [self.positions, self.shapes, self.descriptors.as_flattened()].concat();
        (self.count > 0).then(|| digest(&all))
    }

    /// Scale in px, direction in rad and weight.
    pub fn shapes(&self) -> Vec<[f32; 3]> {
        rows_of(self.shapes, f32::from_le_bytes)
    }
}

/// The image is decoded once, and let go with the job.
pub(super) fn execute(task: &FeatureTask, image: &[u8], mask: Option<&[u8]>) -> Result<Vec<u8>, Error> {
    let Decoded { grey, .. } = decode(image, &DecodeLimits::default())?;
    let mask = mask
        .zip(task.mask.as_deref())
        .map(|(bytes, name)| decode_mask(name, bytes, [grey.width(), grey.height()], &DecodeLimits::default()))
        .transpose()?;
    let found = find(grey.view(), mask.as_ref().map(GreyImage::view), &task.options)?;
    let (width, height) = (grey.width(), grey.height());
    let exif = ExifImage::read(image, width as u64, height as u64);
    let head = FeatureHead { width_px: width as u32, height_px: height as u32, exif };
    let bytes = |value: f64| (value as f32).to_le_bytes();
    let positions = column(found.iter().flat_map(|f| [f.point.x, f.point.y]), bytes);
    let shapes = column(found.iter().flat_map(|f| [f.point.scale_px, f.orientation_rad, f.point.weight]), bytes);
    let descriptors: Vec<u8> = found.iter().flat_map(|f| f.descriptor).collect();
    Ok(write_record(&task.key, &head, found.len(), &[&positions, &shapes, &descriptors]))
}
