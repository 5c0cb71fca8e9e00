//! The file of a mask.

use crate::error::refuse;
use crate::{DecodeLimits, Error, GreyImage, ImageFault, Refusal, decode};

/// The mask of an image, where features are wanted that is not 0. `size`: width and height of the image.
///
/// # Errors
/// [`Error::UnreadableImage`], with its name; [`Error::InvalidInput`] for one of another size.
pub(crate) fn decode_mask(name: &str, bytes: &[u8], size: [usize; 2], limits: &DecodeLimits) -> Result<GreyImage, Error> {
    let mask = decode(bytes, limits)
        .map_err(|error| Error::UnreadableImage { image_fault: ImageFault::Mask { name: name.to_string(), error: Box::new(error) } })?
        .grey;
    let ([width, height], [image_width, image_height]) = ([mask.width(), mask.height()], size);
    if [width, height] == size {
        return Ok(mask);
    }
    refuse(Refusal::MaskOfImage { name: name.into(), width, height, image_width, image_height })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::write_png;

    #[test]
    fn a_mask_is_as_large_as_its_image_and_what_is_wrong_with_one_names_it() {
        let grey = GreyImage::from_fn(3, 2, |column, _| 100 * column as u8).unwrap();
        let file = write_png(grey.view(), None);
        let of = |file: &[u8], size: [usize; 2]| decode_mask("a_mask.png", file, size, &DecodeLimits::default());
        assert_eq!(of(&file, [3, 2]).unwrap(), grey);
        for (refused, words) in [(of(&file, [2, 3]), "3 x 2"), (of(b"none", [3, 2]), "a_mask.png")] {
            let said = refused.unwrap_err().to_string();
            assert!(said.contains("a_mask.png") && said.contains(words), "{said}");
        }
    }
}
