//! The coordinate system in which epipolar images stand: that of the orientation of their project.

use crate::{BlockRun, Datum, GeographicOrigin, OnOrthophoto};
use serde::Serialize;

/// The system of the positions and directions of two oriented images. It is that of the adjustment, also where tables are in another one.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum StereoSystem {
    /// The photo system of that image: x right, y up, z against the view; in mm at the scale of its photo coordinates.
    Photo { image: String },
    /// In m, x east, y north and z up at `origin`, which is (0, 0, 0).
    Tangent { origin: GeographicOrigin },
    /// That of the orthophoto on which the block lies, in its unit; its code, where that is known.
    Orthophoto { epsg: Option<u16> },
    /// That of the ground control points.
    GroundControl,
    /// That of the GNSS positions, which are in a plane.
    Positions,
    /// One of the block itself: nothing says where it lies, how it is turned and how long its unit is.
    Block,
}

impl StereoSystem {
    pub(super) fn of_block(run: &BlockRun) -> Self {
        let model = run.reconstruction.as_ref().ok().and_then(|reconstruction| reconstruction.models.first());
        let Some(model) = model.filter(|model| model.in_system) else { return Self::Block };
        match (&run.orthophoto, run.model.origin) {
            (Some(OnOrthophoto::Linked { in_crs: false, epsg, .. } | OnOrthophoto::ByHand { in_crs: false, epsg, .. }), _) => {
                Self::Orthophoto { epsg: *epsg }
            }
            (_, Some(origin)) => Self::Tangent { origin },
            (_, None) if model.adjusted.datum.uses_control() => Self::GroundControl,
            (_, None) if model.adjusted.datum == Datum::Gnss => Self::Positions,
            _ => Self::Block,
        }
    }
}
