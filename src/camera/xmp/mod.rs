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

impl Attitude {
    /// Where what looks down while pitch and roll are 0 looks: east, north, up. Yaw, pitch and roll turn about the axes down, right and
    /// forwards, in this order (DIN 9300).
    fn down(&self) -> [f64; 3] {
        let [(sy, cy), (sp, cp), (sr, cr)] = [self.yaw_deg, self.pitch_deg, self.roll_deg].map(|angle| libm::sincos(angle.to_radians()));
        [sy * sp * cr - cy * sr, cy * sp * cr + sy * sr, -cp * cr]
    }
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

/// What a drone recorded of itself and its camera.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct DroneRecord {
    /// Of the gimbal that carries the camera: a pitch of -90° looks down.
    pub gimbal: Option<Attitude>,
    /// Of the aircraft: a pitch of 0° is level.
    pub aircraft: Option<Attitude>,
    /// Of the camera, as Pix4D defines it: a pitch of 0° looks down.
    pub camera: Option<Attitude>,
    /// Above the place of take-off.
    pub relative_height_m: Option<f64>,
    /// Above the ellipsoid or the sea: makers do not agree.
    pub absolute_height_m: Option<f64>,
    pub rtk: Option<RtkSolution>,
}

impl DroneRecord {
    /// The direction of view, of length 1: east, north, up; absent where the attitude of the camera is.
    pub(crate) fn view(&self) -> Option<[f64; 3]> {
        // A gimbal rolls about the direction of view.
        let of_gimbal = self.gimbal.map(|gimbal| Attitude { pitch_deg: gimbal.pitch_deg + 90.0, roll_deg: 0.0, ..gimbal });
        of_gimbal.or(self.camera).map(|camera| camera.down())
    }
}

/// What XMP says of an image; what it does not say is absent.
#[derive(Debug, Default)]
pub struct Xmp {
    pub dji_lens: Option<DjiLens>,
    pub pix4d_lens: Option<Pix4dLens>,
    pub drone: DroneRecord,
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
        let drone = DroneRecord {
            gimbal: attitude(dji, ["GimbalYawDegree", "GimbalPitchDegree", "GimbalRollDegree"]),
            aircraft: aircraft.or_else(|| attitude(sensefly, ["Heading", "PitchAngle", "RollAngle"])),
            camera: attitude(pix4d, ["Yaw", "Pitch", "Roll"]),
            relative_height_m: height(dji("RelativeAltitude").or_else(|| sensefly("Height"))),
            absolute_height_m: height(dji("AbsoluteAltitude").or_else(|| sensefly("AltitudeWGS84"))),
            rtk: rtk(dji),
        };
        Self { dji_lens: DjiLens::of(properties), pix4d_lens: Pix4dLens::of(properties), drone, panorama: panorama(properties) }
    }
}

/// Absent where one of the angles is.
fn attitude(number: impl Fn(&str) -> Option<f64>, names: [&str; 3]) -> Option<Attitude> {
    let [yaw_deg, pitch_deg, roll_deg] = names.map(|name| number(name).filter(|angle| angle.abs() <= 360.0));
    Some(Attitude { yaw_deg: yaw_deg?, pitch_deg: pitch_deg?, roll_deg: roll_deg? })
}

fn rtk(number: impl Fn(&str) -> Option<f64>) -> Option<RtkSolution> {
    let flag = number("RtkFlag").filter(|flag| (0.0..=255.0).contains(flag))? as u8;
    let [east, north, up] = ["RtkStdLon", "RtkStdLat", "RtkStdHgt"].map(|name| number(name).filter(|sigma| (1e-6..=1e3).contains(sigma)));
    Some(RtkSolution { flag, standard_deviations_m: east.zip(north).zip(up).map(|((east, north), up)| [east, north, up]) })
}

/// Absent where the projection is a central one.
fn panorama(properties: &Properties) -> Option<(String, Option<f64>)> {
    let projection = properties.text(Namespace::Panorama, "ProjectionType")?.to_ascii_lowercase();
    let is_central = ["perspective", "rectilinear"].contains(&projection.as_str());
    (!is_central).then(|| (projection, properties.number(Namespace::Panorama, "FullPanoWidthPixels")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recorded_angles_tell_the_direction_of_view() {
        let attitude = |yaw_deg, pitch_deg, roll_deg| Some(Attitude { yaw_deg, pitch_deg, roll_deg });
        let of = |gimbal, camera| DroneRecord { gimbal, camera, ..DroneRecord::default() }.view();
        let (half, root) = (0.5, 0.75_f64.sqrt());
        for (what, view, expected) in [
            ("a gimbal that looks down, whatever its yaw and roll", of(attitude(50.0, -90.0, 180.0), None), [0.0, 0.0, -1.0]),
            ("a gimbal that looks east, 30 degrees down", of(attitude(90.0, -30.0, 0.0), None), [root, 0.0, -half]),
            ("a camera that looks north, 60 degrees off the vertical", of(None, attitude(0.0, 60.0, 0.0)), [0.0, root, -half]),
            ("a camera that flies north with its right wing down", of(None, attitude(0.0, 0.0, 30.0)), [-half, 0.0, -root]),
        ] {
            let view = view.unwrap();
            assert!((0..3).all(|k| (view[k] - expected[k]).abs() < 1e-12), "{what}: {view:?}");
        }
        assert_eq!(of(None, None), None);
    }
}
