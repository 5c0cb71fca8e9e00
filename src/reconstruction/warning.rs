//! Warnings about an adjusted block, and why images are not in it.

use super::control_kind::ControlKind;
use super::mistake::{Axis, Mistake};
use crate::message::messages;
use crate::{CameraParameter, Cause, NamedCamera, PlaceSlip};
use serde::{Deserialize, Serialize};

messages! {
    /// What is weak about a model.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    #[non_exhaustive]
    pub enum BlockWarning as "block_warning" {
        /// Nothing determines its position, rotation and scale. `cause`: why what was observed does not; `without_heights`: GNSS positions that are there,
        /// and whose heights are not known where those of control points count from.
        Free {
            cause: Option<Cause>,
            #[serde(default)]
            without_heights: usize,
        },
        /// What was observed lies along a line, about which the block may turn. `tilt_deg`: of the views, where they are not vertical.
        UnknownRotation { observed: Observed, tilt_deg: Option<f64> },
        /// The angles of no image are known better than `error_deg`.
        UncertainRotation { observed: Observed, error_deg: f64, tilt_deg: Option<f64> },
        /// Most views look up, so far off the vertical in the median, as where two axes of what was observed are exchanged.
        LookingUp { observed: Observed, tilt_deg: f64 },
        /// The GNSS positions hardly tell the rotation of the whole block (`error_deg`; absent: not at all): it was levelled, by directions of
        /// view that were `recorded`, or by views that are taken as vertical on average.
        Levelled { recorded: bool, error_deg: Option<f64>, level_deg: f64 },
        /// No heights of GNSS positions take part: they have none, or count from elsewhere than those of surveyed points.
        NoHeights,
        /// GNSS positions that do not fit.
        PositionsRejected { images: Vec<RejectedPosition> },
        /// A coordinate in which all GNSS positions differ alike from what ground control says. `difference_m`: that of the positions minus that of the
        /// control; `times`: by its standard error. `images_m`: how far the images have followed it, where that is beyond their standard errors. `focal`:
        /// focal lengths that are estimated follow heights. `control`: control points were refused, which may be right. `held_by`: what the control is.
        PositionsApart {
            axis: Axis,
            difference_m: f64,
            times: f64,
            #[serde(default)]
            images_m: Option<f64>,
            #[serde(default)]
            focal: bool,
            #[serde(default)]
            control: bool,
            #[serde(default)]
            held_by: ControlKind,
        },
        /// GNSS positions that a table gives to so many images lie elsewhere than those that their files record, by so much in the median.
        /// `in_crs`: whether the table has them in the system that was named.
        PositionsElsewhere {
            images: usize,
            distance_km: f64,
            place_slip: Option<PlaceSlip>,
            #[serde(default)]
            in_crs: bool,
        },
        /// σ₀ is above what matching reaches.
        Imprecise { sigma0_px: f64, most_px: f64 },
        /// Weights by the residuals still changed after so many rounds.
        WeightsNotConverged { rounds: usize },
        /// Systematic errors of GNSS positions that nothing determines.
        PositionErrorsUndetermined { errors: usize },
        /// Those that are estimated are relative to each other: so many motions of the whole block are told from them by nothing.
        PositionErrorsRelative { motions: usize },
        /// A coordinate of a GCP that its test refuses. `difference_m`: where the other observations have it minus surveyed, with its standard error;
        /// `used`: whether the point takes part all the same; `certain`: whether enough is left without it to tell that it is the wrong one.
        ControlRefused {
            point: String,
            axis: Axis,
            difference_m: f64,
            error_m: f64,
            detectable_m: Option<f64>,
            used: bool,
            #[serde(default = "yes")]
            certain: bool,
            mistake: Option<Mistake>,
        },
        /// A GCP that takes no part and whose coordinates nothing tests: fewer than two of its image measurements fit the other observations.
        ControlUntested { point: String, measurements: usize },
        /// A GCP that takes no part since the block is not placed with it, though the other observations have it within chance where it was surveyed.
        ControlUnplaced { point: String, measurements: usize },
        /// So many of the GCPs contradict each other, or the rest of the block, and nothing tells which of them are wrong: they take part. `w`: the
        /// largest of their tests.
        ControlContradicts {
            refused: usize,
            points: usize,
            #[serde(default)]
            w: Option<f64>,
        },
        /// The block has no adjustment without so many of the GCPs, which their tests were to leave out: all take part, wrong ones among them.
        ControlTestsStopped { left_out: usize, points: usize },
        /// The block has no adjustment with these GCPs, which lie far from where the others have them: they take no part, and the others do not place it.
        ControlUnadjusted { names: Vec<String> },
        /// So many of the GCPs that are measured in two of its images or more are lost, since their image measurements do not meet. `from_bottom`: those of most
        /// of them would, if rows were counted from the bottom of the images. `control_apart`: they meet, so far from the coordinates of the points.
        ControlLost {
            lost: usize,
            points: usize,
            from_bottom: bool,
            #[serde(default)]
            control_apart: Option<ControlApart>,
        },
        /// GCPs were given, and nothing places the block: so many of them are `measured` in two of its images or more, and the measurements of so many meet
        /// (`taken`).
        ControlWithoutPlace { given: usize, measured: usize, taken: usize },
        /// The distances of these GCPs from each other make the block `ratio` times as large between two of them (`longest`) as between two others
        /// (`shortest`): they do not place it. `point`: without this one the others fit.
        ControlShape { names: Vec<String>, ratio: f64, longest: String, shortest: String, point: Option<String> },
        /// So few GCPs, beside so few GNSS positions, that they hardly check each other. `detectable_m`: the error of a coordinate that its test finds, of
        /// that where it is largest; absent where one is not checked at all.
        FewControl {
            points: usize,
            #[serde(default)]
            positions: usize,
            detectable_m: Option<f64>,
        },
        /// GCPs that span little of the ground of the block.
        ControlSpan { points: usize, span_percent: f64 },
        /// GCPs almost on a line: so wide across it as a share of how long they are along it. `error_deg`: the angles of no image are known better.
        ControlOnLine { points: usize, width_percent: f64, error_deg: Option<f64> },
        /// The GCPs make the block another number of times as large as the GNSS positions.
        Scale { ratio: f64, unit: Option<LengthUnit> },
        /// The GCPs seem to be in degrees.
        Degrees,
        /// A GCP or check point (`check`) whose image measurements in oriented images do not meet, or that has one alone.
        PointRejected {
            point: String,
            measurements: usize,
            #[serde(default)]
            check: bool,
        },
        /// The images of image measurements of a GCP or check point that do not fit.
        MeasurementsRejected {
            point: String,
            measurements: usize,
            images: Vec<String>,
            #[serde(default)]
            check: bool,
        },
        /// A check point that differs from the block by more than the others do: adjusted minus surveyed along one axis, and the standard error of that.
        CheckRefused { point: String, axis: Axis, difference_m: f64, error_m: f64, mistake: Option<Mistake> },
        /// A coordinate in which check points differ alike from the block: adjusted minus surveyed in the median, and the standard error of that.
        ChecksApart { axis: Axis, points: usize, difference_m: f64, error_m: f64 },
        /// Standard errors that a table states in columns without a unit, and that cannot be m: so many in the median (`stated`). `residual_m`: residuals are
        /// those of standard errors of so many m; absent where nothing tells that. `unit`: in which they would fit.
        StatedErrors { observed: Observed, columns: Vec<String>, stated: f64, residual_m: Option<f64>, unit: LengthUnit },
        /// No image measurement of the points that were given is in an image of the block. `check`: all of them are check points.
        ControlElsewhere { points: usize, images: Vec<String>, check: bool },
        /// A focal length that was not known.
        FocalEstimated { camera: NamedCamera, error_px: f64 },
        /// A focal length that was not known and stays so.
        FocalUndetermined { camera: NamedCamera },
        /// A focal length that the places of an orthophoto make another one than the images by themselves.
        FocalOfGround {
            camera: NamedCamera,
            images_px: f64,
            images_error_px: f64,
            /// The standard error of a coordinate of weight 1 in it; absent in older projects.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            images_unit_px: Option<f64>,
            ground_px: f64,
            ground_error_px: f64,
        },
        /// The orthophoto has the block so far in plan from the GNSS positions of so many images, in the median, where `usual_m` is usual at most.
        OrthophotoApart { images: usize, plan_m: f64, usual_m: f64 },
        /// It has the block higher than they, or lower (below 0).
        OrthophotoHeightsApart { images: usize, height_m: f64, usual_m: f64 },
        /// Heights of its ground scatter so much about those of the block, by the places that check it, where `stated_m` are stated of them.
        OrthophotoHeightsScatter { checks: usize, scatter_m: f64, stated_m: f64 },
        /// A parameter of a camera that the block does not determine.
        ParameterFixed { camera: NamedCamera, camera_parameter: CameraParameter },
        /// Images with fewer observations than `least`.
        FewObservations { images: Vec<String>, least: usize },
        /// Most points have two rays.
        TwoRays { two: usize, points: usize },
        /// Many observations are gross errors.
        ManyRejected { rejected: usize, observations: usize },
    }
}

fn yes() -> bool {
    true
}

/// An angle that is not surer than this is not known.
pub(super) const UNKNOWN_TURN_DEG: f64 = 45.0;

/// No file records a place that is so far off without a slip.
const WRONG_PLACE_KM: f64 = 1.0;

impl BlockWarning {
    /// Whether it says of an orthophoto, or the heights of its ground, that they are off.
    pub(crate) fn is_of_orthophoto(&self) -> bool {
        matches!(self, Self::OrthophotoApart { .. } | Self::OrthophotoHeightsApart { .. } | Self::OrthophotoHeightsScatter { .. })
    }

    /// Whether it speaks against the model as a whole: others tell what is weak of it, or what was done about it.
    pub(crate) fn is_weakness(&self) -> bool {
        match self {
            Self::Free { cause, .. } => cause.is_some(),
            // Of a wall or a street that was taken for the ground nothing tells.
            Self::Levelled { recorded, error_deg, .. } => !recorded && error_deg.is_none_or(|error| error > UNKNOWN_TURN_DEG),
            // The block is what it is without check points.
            Self::ControlElsewhere { check, .. } => !check,
            // Heights of another zero make focal lengths wrong, and with them the heights of the images; images follow precise positions, beside which good
            // control points look wrong. Otherwise control holds the block where it is.
            Self::PositionsApart { images_m, focal, control, .. } => images_m.is_some() || *focal || *control,
            // By less the positions of the files may be wrong.
            Self::PositionsElsewhere { distance_km, place_slip, .. } => *distance_km >= WRONG_PLACE_KM || place_slip.is_some(),
            Self::UnknownRotation { .. }
            | Self::UncertainRotation { .. }
            | Self::LookingUp { .. }
            | Self::Imprecise { .. }
            | Self::ControlRefused { .. }
            | Self::ControlUntested { .. }
            | Self::ControlUnplaced { .. }
            | Self::ControlContradicts { .. }
            | Self::ControlTestsStopped { .. }
            | Self::ControlUnadjusted { .. }
            | Self::ControlLost { .. }
            | Self::ControlWithoutPlace { .. }
            | Self::ControlShape { .. }
            | Self::CheckRefused { .. }
            | Self::ChecksApart { .. }
            | Self::StatedErrors { .. }
            | Self::Scale { .. }
            | Self::Degrees
            | Self::FocalUndetermined { .. }
            | Self::FocalOfGround { .. }
            | Self::OrthophotoApart { .. }
            | Self::OrthophotoHeightsApart { .. }
            | Self::OrthophotoHeightsScatter { .. }
            | Self::ManyRejected { .. } => true,
            Self::NoHeights
            | Self::PositionsRejected { .. }
            | Self::WeightsNotConverged { .. }
            | Self::PositionErrorsUndetermined { .. }
            | Self::PositionErrorsRelative { .. }
            | Self::FewControl { .. }
            | Self::ControlSpan { .. }
            | Self::ControlOnLine { .. }
            | Self::PointRejected { .. }
            | Self::MeasurementsRejected { .. }
            | Self::FocalEstimated { .. }
            | Self::ParameterFixed { .. }
            | Self::FewObservations { .. }
            | Self::TwoRays { .. } => false,
        }
    }
}

messages! {
    /// Where the image measurements of GCPs meet: so far from their coordinates in plan, and so far above them, in m, in the median of their coordinates.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum ControlApart as "control_apart" {
        /// Hardly apart in plan.
        Heights { up_m: f64 },
        Places { across_m: f64, up_m: f64 },
    }
}

messages! {
    /// What was observed of positions.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Observed as "observed" {
        /// GNSS positions.
        Positions,
        /// GCPs.
        Points,
        Both,
    }
}

messages! {
    /// Units of length that are taken for metres.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum LengthUnit as "unit" {
        Millimetres,
        Centimetres,
        Inches,
        Feet,
        Kilometres,
    }
}

/// An image whose GNSS position does not fit, and its distance from the adjusted one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RejectedPosition {
    pub name: String,
    pub distance_m: f64,
}

messages! {
    /// Why an image is not oriented.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum UnorientedReason as "unoriented" {
        /// It has no tie points at all.
        NoPoints,
        /// Too few of its points were intersected by oriented images.
        TooFewPoints { points: usize, needed: usize },
        /// Too few of its rays agree on one orientation.
        NoAgreement { agreeing: usize, points: usize, needed: usize },
        /// The rays that agree lie on a line or in one spot of the image.
        Narrow { agreeing: usize },
        /// No second image has enough points in common with it and a base.
        NoPartner,
        /// It was oriented, and then lost nearly all of its rays.
        Lost { rays: usize },
        /// It was oriented, and the rays it had left did not determine its orientation in the bundle adjustment.
        Undetermined { rays: usize },
        RejectedByHand,
    }
}
