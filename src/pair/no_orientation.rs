//! Why a pair has no orientation.

use crate::message::messages;
use crate::{Error, NoGeometry, Side};
use serde::{Deserialize, Serialize};

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
            error: Error,
        },
    }
}
