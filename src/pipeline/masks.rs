//! Which mask belongs to which image, by their names.

use crate::error::refuse;
use crate::{Error, Refusal};
use std::collections::BTreeMap;

/// The mask of each image, and the names of masks that belong to none.
///
/// A mask has the name of its image, whatever its ending, perhaps with `_mask` behind it, or the whole name of the image with its own
/// ending behind it: `IMG_1.png`, `IMG_1_mask.png` and `IMG_1.jpg.png` belong to `IMG_1.jpg`.
///
/// # Errors
/// [`Error::InvalidInput`] for two masks of one image.
pub fn masks_of(images: &[String], masks: &[String]) -> Result<(Vec<Option<usize>>, Vec<String>), Error> {
    let mut by_name: BTreeMap<String, usize> = BTreeMap::new();
    for (index, mask) in masks.iter().enumerate() {
        let whole = last_part(mask);
        let stem = without_ending(&whole);
        let name = stem.strip_suffix("_mask").unwrap_or(stem).to_string();
        if let Some(other) = by_name.insert(name, index) {
            return refuse(Refusal::TwoMasks { first: masks[other].to_string(), second: mask.to_string() });
        }
    }
    let of = |image: &String| {
        let own = last_part(image);
        by_name.get(&own).or_else(|| by_name.get(without_ending(&own))).copied()
    };
    let found: Vec<Option<usize>> = images.iter().map(of).collect();
    let unused = (0..masks.len()).filter(|mask| !found.contains(&Some(*mask))).map(|mask| masks[mask].clone());
    let unused = unused.collect();
    Ok((found, unused))
}

fn without_ending(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// Of a file perhaps below a folder; large and small letters are the same.
fn last_part(name: &str) -> String {
    name.rsplit('/').next().unwrap_or(name).to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_belong_to_images_by_name() {
        let names = |list: &[&str]| list.iter().map(|name| name.to_string()).collect::<Vec<_>>();
        let images = names(&["IMG_1.jpg", "IMG_2.jpg", "IMG_3.jpg", "IMG_4.jpg"]);
        let masks = names(&["stranger.png", "m/img_2_mask.png", "IMG_1.png", "IMG_3.jpg.png"]);
        let (of, unused) = masks_of(&images, &masks).unwrap();
        assert_eq!((of, unused), (vec![Some(2), Some(1), Some(3), None], names(&["stranger.png"])));
        let refused = masks_of(&images, &names(&["IMG_1.png", "IMG_1_mask.png"])).unwrap_err().to_string();
        assert!(refused.contains("IMG_1.png and IMG_1_mask.png, which belong to the same image"), "{refused}");
    }
}
