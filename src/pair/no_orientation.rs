//! Why a pair has no orientation.

use crate::message::messages;
use crate::{Error, NoGeometry, Side};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

messages! {
    /// Why a pair has no orientation.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NoOrientation as "no_orientation" {
        /// No camera is given, and an image names none.
        NoCamera { side: Side },
        /// Fiducial marks without a focal length.
        NoFocalLength,
        /// An image with neither fiducial marks nor a pixel size.
        NoPixelSize { side: Side },
        /// An image of no central perspective.
        Panorama { side: Side },
        NoGeometry { no_geometry: NoGeometry },
        PureRotation,
        /// The orientation refuses the matches.
        Refused {
            #[cfg_attr(target_arch = "wasm32", tsify(type = "{ kind: string }"))]
            #[serde(deserialize_with = "of_any_version")]
            error: Error,
        },
    }
}

/// An error as projects keep it: those of former versions hold refusals of input in words.
fn of_any_version<'de, D: Deserializer<'de>>(kept: D) -> Result<Error, D::Error> {
    let mut error = Value::deserialize(kept)?;
    if error["kind"] == "invalid-input" && error.get("what").is_some() {
        error["kind"] = "invalid-argument".into();
    }
    Error::deserialize(error).map_err(D::Error::custom)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_that_a_former_version_kept_is_read() {
        let kept = r#"{"kind":"refused","error":{"kind":"invalid-input","what":"weight","got":"-1","allowed":"above 0"}}"#;
        let read: NoOrientation = serde_json::from_str(kept).unwrap();
        assert!(read.to_string().ends_with("weight: got -1; allowed: above 0"), "{read}");
        let again: NoOrientation = serde_json::from_str(&serde_json::to_string(&read).unwrap()).unwrap();
        assert_eq!(again, read);
    }
}
