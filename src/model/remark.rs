//! What of the input is not taken as it was given, or is hardly right.

use crate::CameraCaution;
use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What the run reports of its input beside the images that it skips.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Remark as "remark" {
        /// No image has a name that fits the pattern of a camera.
        UnusedCamera { images: String },
        /// A focal length that hardly is one in px. `label`: of the camera; `sides`: the focal length in longer sides of the image, of which
        /// `least` to `most` are usual; `in_mm`: whether it is small enough to be one in mm.
        DoubtfulFocal { label: String, focal_px: f64, sides: f64, least: f64, most: f64, in_mm: bool },
        /// A principal point that lies so many longer sides of the image from its middle, of which up to `most` are usual.
        FarPrincipalPoint { label: String, sides: f64, most: f64 },
        /// The given focal length of a camera is another than what the files of these images say.
        ContradictedFocal { label: String, focal_px: f64, file_px: f64, images: Vec<String> },
        /// What speaks against the camera that files name.
        CautionedCameras { camera_caution: CameraCaution, images: Vec<String> },
        /// Images look like scans of film: they have a frame in common, or sizes that differ a little.
        LikeScans { images: Vec<String> },
        /// GNSS positions, or their heights, that cannot be.
        ImpossiblePositions { images: Vec<ImpossiblePosition> },
        /// Columns of the table of control points that are not read.
        UnknownColumns { columns: Vec<String> },
        /// Columns of that table that give what another one gives, each with the one that is read in brackets.
        DoubledColumns { columns: Vec<String> },
        /// Columns of that table without a name that are read as standard errors, and may be something else.
        UnnamedErrors { columns: Vec<String> },
        /// Columns of the table of image measurements that are not read.
        UnknownMarkColumns { columns: Vec<String> },
        /// Columns of the table of image positions that are not read.
        UnknownPositionColumns { columns: Vec<String> },
        /// Columns of that table without a name that are read as standard errors, and may be something else.
        UnnamedPositionErrors { columns: Vec<String> },
        /// A column of that table that speaks of heights and is not understood, or not of those above the ellipsoid beside longitudes and latitudes; so many of
        /// its positions have none for that.
        PositionHeights { column: String, positions: usize },
        /// Columns of that table that give what another one gives, each with the one that is read in brackets.
        DoubledPositionColumns { columns: Vec<String> },
        /// Images that the table of image positions names and that are not in the block; whether it names no other ones.
        PositionsOfOtherImages { images: Vec<String>, all: bool },
        /// Points of the table of control points that have no coordinates there.
        PointsWithoutCoordinates { points: Vec<String> },
        /// Control and check points that no image measurement names.
        UnmeasuredPoints { points: Vec<String> },
        /// Points of image measurements that the table of control points does not have.
        UnknownPoints { points: Vec<String> },
        /// The project file keeps only the points that were given: edits are adjusted by these alone.
        UnsupportedEdits,
        /// The coordinate reference system of tables; the operation from it to WGS 84 with its accuracy, where the registry has one; how much higher GNSS
        /// positions are than where the block has them, where their heights took no part.
        ResultSystem { crs: String, operation: Option<String>, accuracy_m: Option<f64>, gnss_above_m: Option<f64> },
        /// Heights in tables are above the ellipsoid, although the system has heights of its own.
        EllipsoidalHeights { crs: String },
        /// Images have GNSS positions, which are on the earth, and control points are in a system of which nobody says where it is.
        GnssWithoutSystem { positions: usize },
        /// Heights count from the geoid of a file, which lies so high above the ellipsoid where the images are.
        Geoid { name: String, low_m: f64, high_m: f64 },
        /// The orthophoto does not say its coordinate reference system and is taken to be in that of the block.
        OrthophotoSystemAssumed { crs: String },
        /// Places of the orthophoto were converted to the coordinate reference system of the block; the accuracy of the shifts of their datums, where
        /// these are two.
        OrthophotoConverted { orthophoto: String, crs: String, accuracy_m: Option<f64> },
        /// No GNSS position of an image lies within so many m of the orthophoto, as the system that this names has it; how far off the nearest is, and what
        /// would bring the orthophoto to them.
        OrthophotoElsewhere { images: usize, within_m: f64, distance_km: f64, crs: String, place_slip: PlaceSlip },
        /// Coordinates of the orthophoto, or heights of its ground, are not in m.
        OrthophotoUnits { unit_m: f64, height_unit_m: f64 },
        /// Heights of the orthophoto's ground count from elsewhere than those of the block's system, as their file says: from what it names, above the
        /// ellipsoid or not; by so much the places are too high, below 0 too low, where that is known.
        OrthophotoHeights { heights: String, from_ellipsoid: bool, crs: String, above_m: Option<f64> },
        /// The same of the heights on which an orthomosaic is made: by so much its ground is too high, below 0 too low.
        MosaicHeights { heights: String, from_ellipsoid: bool, crs: String, above_m: Option<f64> },
        /// An orthomosaic is of a block that nothing places: it has no metres, no north, and need not be level.
        MosaicWithoutPlace,
        /// Its coordinates are m east and north of a point, which its file cannot say: the block has no coordinate reference system.
        MosaicWithoutSystem { latitude_deg: f64, longitude_deg: f64 },
        /// The block has no place on the earth that would be in the system that was chosen.
        NoResultSystem { crs: String },
        /// The block comes from a project file that holds less than is known of a block.
        OlderProject { version: u32 },
    }
}

impl Remark {
    /// Whether a camera is hardly the right one.
    pub(crate) fn is_doubt_of_camera(&self) -> bool {
        matches!(self, Self::DoubtfulFocal { .. } | Self::FarPrincipalPoint { .. } | Self::ContradictedFocal { .. })
    }
}

messages! {
    /// How an orthophoto may have come to lie elsewhere than the images that are to be placed on it.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PlaceSlip as "place_slip" {
        /// Its coordinates are those of another zone of UTM.
        Zone { zone: u32 },
        /// x stands where y belongs.
        Exchanged,
        /// Its northings are those of the other half of the earth.
        OtherHalf,
        /// Its coordinates are in another unit than that of its system.
        Unit { given_in: String },
        /// A coordinate of its middle was written wrong.
        Coordinate { likely: String },
        /// The positions have latitude and longitude in each other's place.
        ExchangedPositions,
        /// The positions lie on the other side of the equator, of the zero meridian, or of both.
        LatitudeSign,
        LongitudeSign,
        BothSigns,
        /// Nothing known brings it there.
        Unknown,
    }
}

impl Remark {
    /// Whether it is of the orthophoto that a block was given.
    pub(crate) fn is_of_orthophoto(&self) -> bool {
        matches!(
            self,
            Self::OrthophotoSystemAssumed { .. }
                | Self::OrthophotoConverted { .. }
                | Self::OrthophotoUnits { .. }
                | Self::OrthophotoElsewhere { .. }
                | Self::OrthophotoHeights { .. }
        )
    }
}

/// An image with a GNSS position, or a height of it, that cannot be.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImpossiblePosition {
    pub name: String,
    /// As the file has it.
    pub value: String,
}
