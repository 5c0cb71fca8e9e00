//! COLMAP's files of features and of matches, as its `feature_importer` and `matches_importer` read them.

use super::text::{file_name, not_written, one_word};
use crate::error::refuse;
use crate::{Error, Refusal};
use std::fmt::Write;

/// Numbers of a descriptor: COLMAP takes no other length.
const DESCRIPTOR: usize = 128;

/// A feature for COLMAP.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColmapFeature<'a> {
    /// In px; the centre of the top-left pixel is (0.5, 0.5), as it is in COLMAP.
    pub x_px: f64,
    pub y_px: f64,
    /// In px; 1 where it is not known.
    pub scale: f64,
    /// In radians; 0 where it is not known.
    pub orientation_rad: f64,
    /// 128 numbers; zeros where there are none, which is enough where matches are imported, too.
    pub descriptor: Option<&'a [u8]>,
}

/// Writes the features of one image; the file is the image's name with `.txt` behind it.
///
/// # Errors
/// [`Error::InvalidInput`] for a descriptor of another length than 128 and numbers that are none; [`Error::NotWritten`].
///
/// # Source
/// COLMAP, `src/colmap/feature/sift.cc`, and its documentation of imported features.
pub fn colmap_features(features: &[ColmapFeature<'_>], out: &mut impl Write) -> Result<(), Error> {
    writeln!(out, "{} {DESCRIPTOR}", features.len()).map_err(not_written)?;
    for (index, feature) in features.iter().enumerate() {
        let numbers = [feature.x_px, feature.y_px, feature.scale, feature.orientation_rad];
        if !numbers.iter().all(|v| v.is_finite()) {
            return refuse(Refusal::FeatureNumbers { numbers: format!("{numbers:?}"), feature: index });
        }
        let descriptor = feature.descriptor.unwrap_or(&[0; DESCRIPTOR]);
        if descriptor.len() != DESCRIPTOR {
            return refuse(Refusal::FeatureDescriptor { numbers: descriptor.len(), feature: index, needed: DESCRIPTOR });
        }
        let [x, y, scale, orientation] = numbers;
        write!(out, "{x} {y} {scale} {orientation}").map_err(not_written)?;
        descriptor.iter().try_for_each(|value| write!(out, " {value}")).map_err(not_written)?;
        writeln!(out).map_err(not_written)?;
    }
    Ok(())
}

/// Writes the matches of one pair: the names of the images, the numbers of the features from 0, an empty line.
///
/// # Errors
/// [`Error::InvalidInput`] for names with blanks, or that lead out of their folder; [`Error::NotWritten`].
///
/// # Source
/// COLMAP, `src/colmap/controllers/feature_matching.cc`.
pub fn colmap_matches(names: [&str; 2], matches: &[[usize; 2]], out: &mut impl Write) -> Result<(), Error> {
    let format = "COLMAP match list";
    let [left, right] = [one_word(format, file_name(format, names[0])?)?, one_word(format, file_name(format, names[1])?)?];
    writeln!(out, "{left} {right}").map_err(not_written)?;
    matches.iter().try_for_each(|[a, b]| writeln!(out, "{a} {b}")).map_err(not_written)?;
    writeln!(out).map_err(not_written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn features_have_their_golden_text() {
        let descriptor: Vec<u8> = (0..128).collect();
        let feature = |descriptor| ColmapFeature { x_px: 0.5, y_px: 10.25, scale: 2.0, orientation_rad: -0.5, descriptor };
        let mut text = String::new();
        colmap_features(&[feature(Some(&descriptor)), feature(None)], &mut text).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "2 128");
        assert!(lines[1].starts_with("0.5 10.25 2 -0.5 0 1 2 3 ") && lines[1].ends_with(" 126 127"));
        assert_eq!(lines[2].split(' ').count(), 132);
        assert!(colmap_features(&[feature(Some(&descriptor[1..]))], &mut text).unwrap_err().to_string().contains("127 numbers"));
        let none = ColmapFeature { scale: f64::NAN, ..feature(None) };
        assert!(colmap_features(&[none], &mut text).is_err());
    }

    #[test]
    fn matches_have_their_golden_text() {
        let mut text = String::new();
        colmap_matches(["a.jpg", "b.jpg"], &[[0, 1], [2, 3]], &mut text).unwrap();
        assert_eq!(text, "a.jpg b.jpg\n0 1\n2 3\n\n");
        assert!(colmap_matches(["a b.jpg", "c.jpg"], &[], &mut text).unwrap_err().to_string().contains("names without blanks"));
        assert!(colmap_matches(["a.jpg", "../c.jpg"], &[], &mut text).is_err());
    }
}
