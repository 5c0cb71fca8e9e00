//! The camera and the drone of XMP packets made here.

use tiepoint::{CameraCaution, CameraMm, CameraOrigin, CameraUncertainty, ExifCamera, ExifImage, Interior};

use super::decode;
use super::exif::{FOCAL_35, FOCAL_LENGTH, MAKE, MODEL, PIXEL_X, PIXEL_Y, PLANE_UNIT, PLANE_X, Value, exif_block};
use super::jpeg_writer::{Jpeg, segment};

const DJI: &str = r#"xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/""#;
const PIX4D: &str = r#"xmlns:Camera="http://pix4d.com/camera/1.0""#;
const PANORAMA: &str = r#"xmlns:GPano="http://ns.google.com/photos/1.0/panorama/""#;

/// A packet of one description: its attributes, and the elements within.
fn packet(attributes: &str, elements: &str) -> String {
    format!(
        r#"<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?><x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" {attributes}>{elements}</rdf:Description></rdf:RDF></x:xmpmeta><?xpacket end="w"?>"#
    )
}

/// A JPEG of 400 x 300 px with this EXIF and this packet.
fn jpeg(fields: &[(u16, Value)], packet: &[u8]) -> Vec<u8> {
    let mut file = vec![0xff, 0xd8];
    segment(&mut file, 0xe1, &[b"Exif\0\0", &exif_block(fields)[..]].concat());
    segment(&mut file, 0xe1, &[b"http://ns.adobe.com/xap/1.0/\0", packet].concat());
    // The start of an extended packet, which is not read.
    segment(&mut file, 0xe1, b"http://ns.adobe.com/xmp/extension/\x000123456789abcdef0123456789abcdef\0\0\0\x05\0\0\0\0<x:x>");
    file.extend(&Jpeg::baseline(400, 300, &[(1, 1, 1)]).write(|_, _, _| 99)[2..]);
    file
}

fn read(fields: &[(u16, Value)], packet: &str) -> ExifImage {
    let file = jpeg(fields, packet.as_bytes());
    let read = ExifImage::read(&file, 400, 300);
    assert_eq!(decode(&file).expect("the image is sound").camera, read.camera);
    read
}

fn camera(fields: &[(u16, Value)], packet: &str) -> ExifCamera {
    read(fields, packet).camera.expect("a camera")
}

fn focal_px(camera: &ExifCamera) -> f64 {
    camera.focal_mm / camera.pixel_mm.expect("a pixel's side")
}

use Value::{Rational, Short, Text};

/// A drone's photo of 4000 x 3000 px, resized to 400 x 300: 8.8 mm, 3500 px by its 35 mm equivalent of 30.3.
fn of_drone() -> Vec<(u16, Value)> {
    vec![
        (MAKE, Text("DJI")),
        (MODEL, Text("FC0000")),
        (FOCAL_LENGTH, Rational(88, 10)),
        (FOCAL_35, Short(30)),
        (PIXEL_X, Short(4000)),
        (PIXEL_Y, Short(3000)),
    ]
}

const DEWARP: &str = "2018-03-13;3659.78,3653.18,-8,46,-0.27,0.11,-0.0001,-0.0003,-0.03";

#[test]
fn a_calibration_of_dji_is_scaled_with_its_photo() {
    let attributes = format!(r#"{DJI} drone-dji:DewarpData="{DEWARP}" drone-dji:DewarpFlag="0" drone-dji:CalibratedFocalLength="3666.6""#);
    let camera = camera(&of_drone(), &packet(&attributes, ""));
    assert_eq!(camera.origin, CameraOrigin::XmpCalibration);
    let lens = *camera.lens.as_deref().unwrap();
    assert!((lens.focal_px - 365.648).abs() < 1e-9 && (focal_px(&camera) - 365.648).abs() < 1e-9, "{lens:?}");
    assert_eq!(lens.principal_point_px, [200.0 - 0.8, 150.0 + 4.6]);
    assert_eq!((lens.radial, lens.tangential), ([-0.27, 0.11, -0.03], [-0.0001, -0.0003]));
    let resized = CameraCaution::Resized { taken_width_px: 4000, taken_height_px: 3000, width_px: 400, height_px: 300 };
    assert_eq!(camera.cautions, [resized]);
    // The pair's camera sees the same rays: its inverse of a distortion like this one is within a tenth of a pixel.
    let own = CameraMm::from_exif(&camera).unwrap();
    // It may be a part of the photo as well.
    assert_eq!(own.uncertainty, Some(CameraUncertainty { focal: 1.0, principal_point: 1.0, ..CameraUncertainty::XMP_CALIBRATION }));
    let interior = Interior::from_pixel_size(&own, 400, 300).unwrap();
    for [x, y] in [[3.0, 4.0], [390.0, 20.0], [199.0, 290.0]] {
        let ([x_mm, y_mm], [u, v]) = (interior.photo_mm(x, y), lens.direction([x, y]).unwrap());
        assert!((x_mm / own.focal_mm - u).abs() < 2e-4 && (y_mm / own.focal_mm + v).abs() < 2e-4, "{x_mm} {y_mm} {u} {v}");
    }
}

#[test]
fn a_photo_that_was_dewarped_is_not_dewarped_again() {
    let attributes = format!(r#"{DJI} drone-dji:DewarpData="{DEWARP}" drone-dji:DewarpFlag="1""#);
    let camera = camera(&of_drone(), &packet(&attributes, ""));
    let lens = *camera.lens.as_deref().unwrap();
    assert_eq!((camera.origin, lens.radial, lens.tangential), (CameraOrigin::XmpDewarped, [0.0; 3], [0.0; 2]));
    assert_eq!(lens.principal_point_px, [200.0, 150.0]);
    assert!((lens.focal_px - 365.648).abs() < 1e-9);
    assert_eq!(CameraMm::from_exif(&camera).unwrap().radial_distortion, [0.0; 3]);
}

#[test]
fn a_designed_focal_length_goes_before_exif_and_is_less_certain_than_a_calibrated_one() {
    let attributes = format!(
        r#"{DJI} drone-dji:CalibratedFocalLength="3666.666504" drone-dji:CalibratedOpticalCenterX="2000.0" drone-dji:CalibratedOpticalCenterY="1500.0""#
    );
    let by_attributes = camera(&of_drone(), &packet(&attributes, ""));
    assert_eq!(by_attributes.origin, CameraOrigin::XmpDesign);
    assert!((focal_px(&by_attributes) - 366.6666504).abs() < 1e-9);
    // Software that resizes a photo may adapt its EXIF, but not its XMP.
    let mut resized = of_drone();
    resized.truncate(4);
    resized.extend([(PIXEL_X, Short(400)), (PIXEL_Y, Short(300))]);
    let unadapted = camera(&resized, &packet(&attributes, ""));
    assert!((focal_px(&unadapted) - 366.6666504).abs() < 1e-9, "{}", focal_px(&unadapted));
    // Of a whole photo: one with fewer pixels than it was taken with may be a part of it.
    let calibrated = format!(
        r#"{DJI} drone-dji:DewarpData="{DEWARP}" drone-dji:DewarpFlag="0" drone-dji:CalibratedOpticalCenterX="2000.0" drone-dji:CalibratedOpticalCenterY="1500.0""#
    );
    let [calibrated, designed, by_exif] = [calibrated.as_str(), &attributes, ""].map(|attributes| {
        let mut whole = of_drone();
        whole.truncate(4);
        whole.extend([(PIXEL_X, Short(400)), (PIXEL_Y, Short(300))]);
        let camera = camera(&whole, &packet(attributes, ""));
        CameraMm::from_exif(&camera).unwrap().uncertainty.unwrap().focal
    });
    assert!(calibrated < designed && designed < by_exif, "{calibrated} {designed} {by_exif}");
}

#[test]
fn properties_may_be_elements_with_any_prefix() {
    let elements = "<d:CalibratedFocalLength>3666.6</d:CalibratedFocalLength><d:GimbalYawDegree>+12.5</d:GimbalYawDegree>\
                    <d:GimbalPitchDegree>-89.9</d:GimbalPitchDegree><d:GimbalRollDegree>+0.00</d:GimbalRollDegree>";
    let read = read(&of_drone(), &packet(r#"xmlns:d="http://www.dji.com/drone-dji/1.0/""#, elements));
    assert!((focal_px(&read.camera.unwrap()) - 366.66).abs() < 1e-9);
    let gimbal = read.drone.unwrap().gimbal.unwrap();
    assert_eq!((gimbal.yaw_deg, gimbal.pitch_deg, gimbal.roll_deg), (12.5, -89.9, 0.0));
}

#[test]
fn attitude_height_and_receiver_of_a_drone() {
    let attributes = format!(
        r#"{DJI} drone-dji:FlightYawDegree="-78.60" drone-dji:FlightPitchDegree="-4.50" drone-dji:FlightRollDegree="-2.50" drone-dji:RelativeAltitude="+69.95" drone-dji:AbsoluteAltitude="+116.56" drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.01274" drone-dji:RtkStdLat="0.01122" drone-dji:RtkStdHgt="0.02394" drone-dji:GimbalYawDegree="1""#
    );
    let drone = read(&of_drone(), &packet(&attributes, "")).drone.unwrap();
    assert_eq!((drone.relative_height_m, drone.absolute_height_m), (Some(69.95), Some(116.56)));
    assert_eq!(drone.aircraft.unwrap().yaw_deg, -78.6);
    assert!(drone.gimbal.is_none(), "one angle is no attitude");
    let rtk = drone.rtk.unwrap();
    assert_eq!((rtk.flag, rtk.standard_deviations_m), (50, Some([0.01274, 0.01122, 0.02394])));
}

/// A multispectral camera of 10 µm pixels, taken with 400 x 300 px.
fn of_band() -> Vec<(u16, Value)> {
    vec![
        (FOCAL_LENGTH, Rational(45, 10)),
        (PLANE_X, Rational(100, 1)),
        (PLANE_UNIT, Short(4)),
        (PIXEL_X, Short(400)),
        (PIXEL_Y, Short(300)),
    ]
}

#[test]
fn a_calibration_of_pix4d_is_in_mm() {
    let attributes =
        format!(r#"{PIX4D} Camera:ModelType="perspective" Camera:PrincipalPoint="2.03,1.47" Camera:PerspectiveFocalLength="4.56""#);
    let list = "<Camera:PerspectiveDistortion><rdf:Seq><rdf:li>-0.1</rdf:li><rdf:li>0.15</rdf:li><rdf:li>-0.02</rdf:li><rdf:li>0.0001</rdf:li> <rdf:li>-0.0002</rdf:li></rdf:Seq></Camera:PerspectiveDistortion>";
    let text = "<Camera:PerspectiveDistortion>-0.1,0.15,-0.02,0.0001,-0.0002</Camera:PerspectiveDistortion>";
    for elements in [list, text] {
        let camera = camera(&of_band(), &packet(&attributes, elements));
        let lens = *camera.lens.as_deref().unwrap();
        assert_eq!(camera.origin, CameraOrigin::XmpCalibration);
        assert!((lens.focal_px - 456.0).abs() < 1e-9 && camera.pixel_mm == Some(0.01), "{camera:?}");
        assert!((lens.principal_point_px[0] - 203.0).abs() < 1e-9 && (lens.principal_point_px[1] - 147.0).abs() < 1e-9);
        assert_eq!((lens.radial, lens.tangential), ([-0.1, 0.15, -0.02], [0.0001, -0.0002]));
    }
}

#[test]
fn a_fisheye_is_described_in_the_terms_of_brown() {
    let attributes = format!(
        r#"{PIX4D} Camera:ModelType="fisheye" Camera:FisheyeAffineMatrix="524.0,0,0,524.0" Camera:FisheyePolynomial="0,1,0.006,-0.137" Camera:Yaw="3" Camera:Pitch="1" Camera:Roll="2""#
    );
    let mut fields = of_band();
    fields[0].1 = Rational(33, 10);
    let read = read(&fields, &packet(&attributes, ""));
    let lens = read.camera.unwrap().lens.unwrap();
    for k in 1..=24 {
        let angle = f64::from(k) * 0.03;
        let theta = angle / std::f64::consts::FRAC_PI_2;
        let seen = 524.0 * (theta + 0.006 * theta * theta - 0.137 * theta * theta * theta);
        let [x, y] = lens.project(angle.tan(), 0.0);
        assert!((x - 200.0 - seen).abs() < 0.05 && y == 150.0, "{angle}: {x} {seen}");
    }
    assert_eq!(read.drone.unwrap().camera.map(|camera| camera.pitch_deg), Some(1.0));
}

#[test]
fn a_panorama_has_no_camera() {
    let attributes = format!(r#"{PANORAMA} GPano:ProjectionType="equirectangular" GPano:FullPanoWidthPixels="8000""#);
    for fields in [of_drone(), vec![]] {
        let camera = camera(&fields, &packet(&attributes, ""));
        assert_eq!(camera.origin, CameraOrigin::Panorama);
        assert_eq!(camera.cautions, [CameraCaution::Panorama { projection: "equirectangular".into() }]);
        assert_eq!(CameraMm::from_exif(&camera).unwrap_err().code(), "invalid-input");
    }
    let central = format!(r#"{PANORAMA} GPano:ProjectionType="rectilinear""#);
    assert_eq!(camera(&of_drone(), &packet(&central, "")).origin, CameraOrigin::Exif35Mm);
}

#[test]
fn a_calibration_that_contradicts_exif_is_not_used() {
    let attributes = format!(r#"{DJI} drone-dji:CalibratedFocalLength="7333""#);
    let camera = camera(&of_drone(), &packet(&attributes, ""));
    assert_eq!((camera.origin, &camera.lens), (CameraOrigin::Exif35Mm, &None));
    assert!(matches!(camera.cautions[..], [_, CameraCaution::Contradiction { xmp_focal_px, .. }] if (xmp_focal_px - 733.3).abs() < 1e-9));
}

#[test]
fn a_lens_that_cannot_be_is_not_used() {
    for data in
        ["a;1,2,3", "a;0,0,0,0,0,0,0,0,0", "a;3659,3653,0,0,-9,0,0,0,0", "a;3659,3653,0,0,NaN,0,0,0,0", "a;3659,3653,1e9,0,1e300,0,0,0,0"]
    {
        let attributes = format!(r#"{DJI} drone-dji:DewarpData="{data}""#);
        let camera = camera(&of_drone(), &packet(&attributes, ""));
        assert_eq!(camera.origin, CameraOrigin::Exif35Mm, "{data}");
        assert!(CameraMm::from_exif(&camera).is_ok(), "{data}");
    }
}

#[test]
fn a_cropped_photo_has_no_focal_length_in_px() {
    let mut fields = of_drone();
    fields[5].1 = Short(2250);
    let camera = camera(&fields, &packet("", ""));
    assert_eq!((camera.pixel_mm, camera.focal_mm), (None, 8.8));
    let cropped = CameraCaution::Cropped { taken_width_px: 4000, taken_height_px: 2250, width_px: 400, height_px: 300 };
    assert_eq!(camera.cautions, [cropped]);
}

#[test]
fn hostile_packets_refuse_no_photo() {
    let sound =
        packet(&format!(r#"{DJI} drone-dji:CalibratedFocalLength="3666.6""#), "<drone-dji:GimbalYawDegree>1</drone-dji:GimbalYawDegree>");
    for length in 0..sound.len() {
        read(&of_drone(), &sound[..length]);
    }
    let bytes = sound.as_bytes();
    for at in 0..bytes.len() {
        for value in [0, b'<', b'"', b'&', 0xff] {
            let mut damaged = bytes.to_vec();
            damaged[at] = value;
            let file = jpeg(&of_drone(), &damaged);
            assert!(ExifImage::read(&file, 400, 300).camera.is_some(), "byte {at} = {value}");
        }
    }
    let entities = r#"<!DOCTYPE x [<!ENTITY a "&b;&b;&b;"><!ENTITY b "&a;&a;&a;">]><x:x xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:CalibratedFocalLength="&a;"><drone-dji:DewarpFlag>&a;</drone-dji:DewarpFlag></x:x>"#;
    assert_eq!(camera(&of_drone(), entities).origin, CameraOrigin::Exif35Mm);
}

#[test]
fn a_tiff_holds_its_packet_in_a_field() {
    let packet = packet(&format!(r#"{DJI} drone-dji:RelativeAltitude="+12.5""#), "");
    let mut tiff = b"MM\0*\0\0\0\x08\0\x01\x02\xbc\0\x07".to_vec();
    tiff.extend((packet.len() as u32).to_be_bytes());
    tiff.extend(26u32.to_be_bytes());
    tiff.extend([0; 4]);
    tiff.extend(packet.as_bytes());
    assert_eq!(ExifImage::read(&tiff, 10, 10).drone.unwrap().relative_height_m, Some(12.5));
}
