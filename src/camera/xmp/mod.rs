//! What the XMP of an image says of its camera: lens, attitude, height and receiver, by the maker of the drone.

mod lens;
mod properties;

pub use lens::{DjiLens, Pix4dLens, Projection};
use properties::{Namespace, Properties};
use serde::{Deserialize, Serialize};

/// Angles as they were recorded.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Attitude {
    /// From north to east.
    pub yaw_deg: f64,
    pub pitch_deg: f64,
    pub roll_deg: f64,
}

/// What the receiver of a drone says of its solution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RtkSolution {
    /// 0 no position, 16 single point (metres), 32 to 49 floating solution (decimetres), 50 fixed solution (centimetres).
    pub flag: u8,
    /// Standard deviations east, north and up; absent where one is not given.
    pub standard_deviations_m: Option<[f64; 3]>,
}

/// What XMP says of an image; what it does not say is absent.
#[derive(Debug, Default)]
pub struct Xmp {
    pub dji_lens: Option<DjiLens>,
    pub pix4d_lens: Option<Pix4dLens>,
    /// Of the gimbal: pitch -90° looks down.
    pub gimbal: Option<Attitude>,
    /// Of the aircraft: pitch 0 is level.
    pub aircraft: Option<Attitude>,
    /// Of the camera, as Pix4D defines it: pitch 0 looks down.
    pub camera: Option<Attitude>,
    /// Above the place of take-off.
    pub relative_height_m: Option<f64>,
    /// As the drone had it: above the ellipsoid or the sea, which makers do not agree on.
    pub absolute_height_m: Option<f64>,
    pub rtk: Option<RtkSolution>,
    /// The projection of a panorama and the width in px of its full circle.
    pub panorama: Option<(String, Option<f64>)>,
}

/// Heights beyond so many metres are damaged fields.
const MOST_HEIGHT_M: f64 = 1e5;

impl Xmp {
    /// Reads a packet; what cannot be read is absent.
    ///
    /// # Source
    /// DJI 2023, Mavic 3M User Manual, Photo File; Pix4D, Specifications of XMP Camera Tags; Google, Photo Sphere XMP Metadata; senseFly writes
    /// its own names beside those of Pix4D.
    pub fn of(packet: &[u8]) -> Self {
        let properties = &Properties::of(packet);
        let number = |namespace| move |name: &str| properties.number(namespace, name);
        let (dji, pix4d, sensefly) = (number(Namespace::Dji), number(Namespace::Camera), number(Namespace::SenseFly));
        let height = |height: Option<f64>| height.filter(|h| h.abs() <= MOST_HEIGHT_M);
        let aircraft = attitude(dji, ["FlightYawDegree", "FlightPitchDegree", "FlightRollDegree"]);
        Self {
            dji_lens: DjiLens::of(properties),
            pix4d_lens: Pix4dLens::of(properties),
            gimbal: attitude(dji, ["GimbalYawDegree", "GimbalPitchDegree", "GimbalRollDegree"]),
            aircraft: aircraft.or_else(|| attitude(sensefly, ["Heading", "PitchAngle", "RollAngle"])),
            camera: attitude(pix4d, ["Yaw", "Pitch", "Roll"]),
            relative_height_m: height(dji("RelativeAltitude").or_else(|| sensefly("Height"))),
            absolute_height_m: height(dji("AbsoluteAltitude").or_else(|| sensefly("AltitudeWGS84"))),
            rtk: rtk(dji),
            panorama: panorama(properties),
        }
    }
}

/// Absent where one of the angles is.
fn attitude(number: impl Fn(&str) -> Option<f64>, names: [&str; 3]) -> Option<Attitude> {
    let [yaw_deg, pitch_deg, roll_deg] = names.map(|name| number(name).filter(|angle| angle.abs() <= 360.0));
    Some(Attitude { yaw_deg: yaw_deg?, pitch_deg: pitch_deg?, roll_deg: roll_deg? })
}

fn rtk(number: impl Fn(&str) -> Option<f64>) -> Option<RtkSolution> {
    let flag = number("RtkFlag").filter(|flag| (0.0..=255.0).contains(flag))? as u8;
    let [east, north, up] = ["RtkStdLon", "RtkStdLat", "RtkStdHgt"].map(|name| number(name).filter(|sigma| *sigma > 0.0));
    Some(RtkSolution { flag, standard_deviations_m: east.zip(north).zip(up).map(|((east, north), up)| [east, north, up]) })
}

/// Absent where the projection is a central one.
fn panorama(properties: &Properties) -> Option<(String, Option<f64>)> {
    let projection = properties.text(Namespace::Panorama, "ProjectionType")?.to_ascii_lowercase();
    let is_central = ["perspective", "rectilinear"].contains(&projection.as_str());
    (!is_central).then(|| (projection, properties.number(Namespace::Panorama, "FullPanoWidthPixels")))
}

#[cfg(test)]
mod tests;
