//! Reading cameras that hold for the images whose names fit a pattern.

use crate::error::refuse;
use crate::json;
use crate::{Camera, CameraUncertainty, Document, Error, FreeParameters, KnownCamera, Location, Refusal};
use serde::{Deserialize, Serialize};

/// A camera, and the images that it took.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CameraRule {
    /// Names of images: `*` stands for any characters, `?` for one, large and small letters are the same. The first rule that fits holds.
    #[serde(default = "all")]
    pub images: String,
    /// Principal distance in px, 1 to 10,000,000.
    pub focal_px: f64,
    /// `[c_x, c_y]` in px, the centre of the top-left pixel at (0.5, 0.5); absent: the middle of the image.
    #[serde(default)]
    pub principal_point_px: Option<[f64; 2]>,
    /// As in [`Camera`].
    #[serde(default)]
    pub radial: [f64; 3],
    #[serde(default)]
    pub tangential: [f64; 2],
    #[serde(default)]
    pub pixel_mm: Option<f64>,
    /// Whether the block takes the camera as it is; otherwise it is calibrated from these values.
    #[serde(default)]
    pub fixed: bool,
    /// What is not known of a camera that is not fixed; absent: as much as of one of EXIF.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<CameraUncertainty>,
}

impl CameraRule {
    /// Whether an image of this name was taken by the camera.
    pub fn fits(&self, name: &str) -> bool {
        let lower = |text: &str| text.to_lowercase().chars().collect::<Vec<char>>();
        fits(&lower(&self.images), &lower(name))
    }

    /// The camera for images of a size.
    ///
    /// # Errors
    /// As [`BlockModel::check`](crate::BlockModel::check).
    pub fn camera(&self, width_px: u32, height_px: u32) -> Result<Camera, Error> {
        self.camera_named(width_px, height_px, || Location::CameraOfImages { images: self.images.clone() })
    }

    /// What the rule says of the camera of images of a size.
    pub(crate) fn known(&self, width_px: u32, height_px: u32) -> KnownCamera {
        let Self { focal_px, principal_point_px, radial, tangential, pixel_mm, fixed, uncertainty, .. } = *self;
        let free = if fixed { FreeParameters::default() } else { FreeParameters::USUAL };
        // Approximate values are as good as those of EXIF.
        let uncertainty = Some(if fixed { CameraUncertainty::NONE } else { uncertainty.unwrap_or(CameraUncertainty::EXIF) });
        let plain = KnownCamera::of_size(width_px, height_px, Some(focal_px));
        KnownCamera { principal_point_px, radial, tangential, pixel_mm, free, uncertainty, ..plain }
    }

    /// The camera as it is given, by its name where it is refused.
    fn camera_named(&self, width_px: u32, height_px: u32, name: impl Fn() -> Location) -> Result<Camera, Error> {
        let camera = self.known(width_px, height_px).held();
        camera.check(name).map(|()| camera)
    }
}

/// Reads `{"cameras": [{"images": "DJI_*.JPG", "focal_px": 3666.7, "principal_point_px": [2000, 1500], "radial": [k1, k2, k3],
/// "tangential": [p1, p2], "pixel_mm": 0.0024, "fixed": true}]}`, or `"uncertainty"` in place of `"fixed"`, of each camera all but `focal_px` optional.
///
/// # Errors
/// [`Error::InvalidJson`] with the place; [`Error::InvalidInput`] for an empty list and for values that no camera has.
pub fn parse_camera_rules(json: &str) -> Result<Vec<CameraRule>, Error> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        cameras: Vec<CameraRule>,
    }
    let text = json.trim_start_matches('\u{feff}');
    let file: File = json::from_text(text).map_err(|json_fault| Error::InvalidJson { document: Document::Cameras, json_fault })?;
    if file.cameras.is_empty() {
        return refuse(Refusal::NoCameras);
    }
    for (number, rule) in (1..).zip(&file.cameras) {
        if rule.images.is_empty() {
            return refuse(Refusal::EmptyPattern { camera: number });
        }
        rule.camera_named(1, 1, || Location::CameraOfFile { camera: number })?;
        rule.uncertainty.as_ref().map_or(Ok(()), CameraUncertainty::check)?;
    }
    Ok(file.cameras)
}

fn all() -> String {
    "*".into()
}

/// Whether a name fits a pattern: after a mismatch the last `*` takes one character more.
fn fits(pattern: &[char], name: &[char]) -> bool {
    let (mut p, mut n) = (0, 0);
    let mut last: Option<(usize, usize)> = None;
    while n < name.len() {
        match (pattern.get(p), last) {
            (Some('*'), _) => {
                last = Some((p, n));
                p += 1;
            }
            (Some(c), _) if *c == '?' || *c == name[n] => (p, n) = (p + 1, n + 1),
            (_, Some((star, from))) => {
                last = Some((star, from + 1));
                (p, n) = (star + 1, from + 1);
            }
            (_, None) => return false,
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fit_patterns() {
        let rule = |images: &str| CameraRule {
            images: images.into(),
            ..parse_camera_rules(r#"{"cameras":[{"focal_px":1}]}"#).unwrap()[0].clone()
        };
        for (pattern, name, wanted) in [
            ("*", "", true),
            ("*.jpg", "IMG_1.JPG", true),
            ("img_?.jpg", "IMG_12.jpg", false),
            ("*a*b", "xaab", true),
            ("*a*b", "xaabc", false),
            ("a?c", "abc", true),
            ("a", "", false),
            ("*[1]*", "x[1].png", true),
        ] {
            assert_eq!(rule(pattern).fits(name), wanted, "{pattern} {name}");
        }
    }

    #[test]
    fn a_camera_is_read_whole_or_refused() {
        let text = r#"{"cameras": [{"images": "a*", "focal_px": 1500.5, "radial": [0.1, 0, 0], "fixed": true}, {"focal_px": 900}]}"#;
        let rules = parse_camera_rules(text).unwrap();
        assert_eq!((rules.len(), rules[0].fixed, rules[1].images.as_str()), (2, true, "*"));
        assert_eq!(rules[0].camera(1600, 1200).unwrap().principal_point_px, [800.0, 600.0]);
        for wrong in [
            "",
            "{}",
            r#"{"cameras": []}"#,
            r#"{"cameras": [{}]}"#,
            r#"{"cameras": [{"focal_px": 0}]}"#,
            r#"{"cameras": [{"focal_px": 1e400}]}"#,
            r#"{"cameras": [{"focal_px": 2e7}]}"#,
            r#"{"cameras": [{"focal_px": 0.5}]}"#,
            r#"{"cameras": [{"focal_px": 1, "focal": 2}]}"#,
            r#"{"cameras": [{"focal_px": 1, "images": ""}]}"#,
            r#"{"cameras": [{"focal_px": 1, "pixel_mm": 0}]}"#,
        ] {
            assert!(parse_camera_rules(wrong).is_err(), "{wrong}");
        }
        for (wrong, told) in [
            (r#"[]"#, "got a list; allowed: an object at line 1 column 1"),
            (r#"{"cameras": [{"focal_px": "1170"}]}"#, "cameras[0].focal_px: got \"1170\"; allowed: a number at line 1 column 27"),
            (r#"{"cameras": [{"focal_px": 900}, {"focal_px": 0}]}"#, "focal_px of camera 2 of the file"),
        ] {
            let message = parse_camera_rules(wrong).unwrap_err().to_string();
            assert!(message.contains(told), "{message}");
        }
    }
}
