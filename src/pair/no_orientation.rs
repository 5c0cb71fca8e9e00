//! Why a pair has no orientation.

use crate::message::messages;
use crate::orientation::LEAST_OBSERVATIONS;
use crate::{CameraCaution, Error, NoGeometry, Side};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

messages! {
    /// Why a pair has no orientation.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NoOrientation as "no_orientation" {
        /// Fewer matches than an orientation takes: no camera makes up for them.
        TooFewMatches { matches: usize, needed: usize },
        /// No camera is given, and an image names none.
        NoCamera { side: Side },
        /// Fiducial marks without a focal length.
        NoFocalLength,
        /// An image with neither fiducial marks nor a pixel size.
        NoPixelSize { side: Side },
        /// The same of an image that was cropped or resized, so that nobody knows how many px its focal length has.
        Altered { side: Side, camera_caution: CameraCaution },
        /// With the focal length that was given nothing fits, and the file of a photo says another one, in px.
        ContradictedFocal { side: Side, given_px: f64, file_px: f64 },
        /// Nothing fits a principal point that lies so many longer sides of an image from its middle, of which up to `most` are usual.
        FarPrincipalPoint { side: Side, sides: f64, most: f64 },
        /// An image of no central perspective.
        Panorama { side: Side },
        NoGeometry { no_geometry: NoGeometry },
        PureRotation,
        /// No camera is known, and all matches fit the map of a plane: of that no camera can be assumed.
        PlaneWithoutCamera,
        /// Both images show the same at the same places.
        OnePhoto,
        /// The images differ by a shift, a turn and a scale alone.
        PartsOfOneImage,
        /// The orientation refuses the matches.
        Refused {
            #[cfg_attr(target_arch = "wasm32", tsify(type = "{ kind: string }"))]
            #[serde(deserialize_with = "of_any_version")]
            error: Error,
        },
    }
}

impl NoOrientation {
    /// The reason that so few matches are, whatever else is missing; `None` where they are enough.
    pub fn of_few(matches: usize) -> Option<Self> {
        (matches < LEAST_OBSERVATIONS).then_some(Self::TooFewMatches { matches, needed: LEAST_OBSERVATIONS })
    }
}

/// An error as projects keep it: those of former versions hold refusals in words.
fn of_any_version<'de, D: Deserializer<'de>>(kept: D) -> Result<Error, D::Error> {
    let mut error = Value::deserialize(kept)?;
    if error["kind"] == "invalid-input" && error.get("what").is_some() {
        error["kind"] = "invalid-argument".into();
    }
    if let Some(what) = error.get("what").filter(|_| error["kind"] == "too-few").cloned() {
        error["few"] = what;
        error.as_object_mut().and_then(|fields| fields.remove("what"));
    }
    if error["kind"] == "invalid-option" && error["allowed"].is_string() {
        error["allowed"] = serde_json::json!({ "kind": "words", "words": error["allowed"] });
    }
    Error::deserialize(error).map_err(D::Error::custom)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_that_a_former_version_kept_is_read() {
        for (kept, text) in [
            (r#"{"kind":"invalid-input","what":"weight","got":"-1","allowed":"above 0"}"#, "weight: got -1; allowed: above 0"),
            (
                r#"{"kind":"invalid-option","field":"focal_mm","got":"0","allowed":"0.001 to 100000"}"#,
                "focal_mm is 0; allowed: 0.001 to 100000",
            ),
            (
                r#"{"kind":"too-few","what":"different observations for the relative orientation","got":3,"needed":5}"#,
                "different observations for the relative orientation: 3 given; at least 5 are needed",
            ),
            (
                r#"{"kind":"too-few","what":"observations that agree on a relative orientation","got":4,"needed":5}"#,
                "observations that agree on a relative orientation: 4 given; at least 5 are needed",
            ),
        ] {
            let read: NoOrientation = serde_json::from_str(&format!(r#"{{"kind":"refused","error":{kept}}}"#)).unwrap();
            assert!(read.to_string().ends_with(text), "{read}");
            let again: NoOrientation = serde_json::from_str(&serde_json::to_string(&read).unwrap()).unwrap();
            assert_eq!(again, read);
        }
    }
}
