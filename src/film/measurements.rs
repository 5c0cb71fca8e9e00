//! Image measurements of scans of film as measurements of their frames.

use super::FilmScan;
use crate::ImageMeasurementRow;
use serde::{Deserialize, Serialize};

/// A frame of a scan: what both are called, and how they lie to each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FrameOfScan {
    /// The name of the scan, as image measurements have it.
    pub scan: String,
    /// The name of its frame.
    pub image: String,
    pub film: FilmScan,
}

/// Image measurements, those of scans in px of their frames.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FramedMeasurements {
    /// In their order; those of other images are as they were given.
    pub measurements: Vec<ImageMeasurementRow>,
    /// So many of them were made in scans.
    pub moved: usize,
    /// Those, as they were given, that lie beside the frame of their scan, and so have none there.
    pub beside: Vec<ImageMeasurementRow>,
}

/// Takes measurements that were made in scans into their frames.
pub fn measurements_in_frames(measurements: &[ImageMeasurementRow], frames: &[FrameOfScan]) -> FramedMeasurements {
    let mut found = FramedMeasurements { measurements: Vec::with_capacity(measurements.len()), moved: 0, beside: Vec::new() };
    for own in measurements {
        let Some(frame) = frames.iter().find(|frame| frame.scan == own.image) else {
            found.measurements.push(own.clone());
            continue;
        };
        match frame.film.shown_in_frame([own.x_px, own.y_px]) {
            None => found.beside.push(own.clone()),
            Some([x_px, y_px]) => {
                found.moved += 1;
                found.measurements.push(ImageMeasurementRow { image: frame.image.clone(), point: own.point.clone(), x_px, y_px });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CameraMm, Fiducial, FilmInput, PhotoInput};

    /// Turned and sheared, with all distortions that a camera may have: 0.6 mm and some at the corners.
    fn distorted() -> FilmScan {
        let marks_mm = [[-106.0, -106.0], [106.0, -105.9], [106.1, 106.0], [-105.9, 106.1]];
        let fiducials = marks_mm.map(|[x_mm, y_mm]| Fiducial {
            col: 3.9 * x_mm + 0.45 * y_mm + 505.0,
            row: 0.46 * x_mm - 3.92 * y_mm + 480.0,
            x_mm,
            y_mm,
        });
        let camera = CameraMm {
            principal_point_mm: [0.5, -0.25],
            radial_distortion: [2e-7, -3e-12, 1e-17],
            tangential_distortion: [2e-6, -1e-6],
            ..CameraMm::without_distortion(152.0, None)
        };
        let scan = PhotoInput { fiducials: fiducials.to_vec(), ..PhotoInput::default() };
        FilmScan::in_common(&FilmInput { camera: Some(camera), scan, marks_mm: Vec::new() }, [1000, 960], 0.3).unwrap()
    }

    fn row(image: &str, point: &str, [x_px, y_px]: [f64; 2]) -> ImageMeasurementRow {
        ImageMeasurementRow { image: image.into(), point: point.into(), x_px, y_px }
    }

    #[test]
    fn there_and_back_is_the_same_position_with_distortion() {
        let film = distorted();
        let [width, height] = film.frame_px;
        let mut moved = 0.0_f64;
        for (column, row) in (0..=width).step_by(53).flat_map(|column| (0..=height).step_by(47).map(move |row| (column, row))) {
            let at = [f64::from(column), f64::from(row)];
            let scan = film.in_scan(at).unwrap();
            let back = film.in_frame(scan);
            assert!((0..2).all(|k| (back[k] - at[k]).abs() < 1e-6), "{at:?} {back:?}");
            let again = film.in_scan(back).unwrap();
            assert!((0..2).all(|k| (again[k] - scan[k]).abs() < 1e-6), "{scan:?} {again:?}");
            let without = FilmScan {
                interior: crate::Interior { radial_distortion: [0.0; 3], tangential_distortion: [0.0; 2], ..film.interior },
                ..film.clone()
            };
            let other = without.in_frame(scan);
            moved = moved.max((other[0] - back[0]).hypot(other[1] - back[1]));
        }
        assert!(moved > 1.0, "the distortion moves positions by {moved} px only");
    }

    #[test]
    fn measurements_of_scans_become_those_of_frames_and_others_stay() {
        let film = distorted();
        let frames = [FrameOfScan { scan: "a.tif".into(), image: "a-film.png".into(), film: film.clone() }];
        // The border of the film is no part of the frame.
        let given = [
            row("a.tif", "P1", [400.0, 300.0]),
            row("b.jpg", "P1", [7.0, 8.0]),
            row("a.tif", "P2", [20.0, 30.0]),
            row("a.tif", "P3", [600.5, 700.25]),
        ];
        let found = measurements_in_frames(&given, &frames);
        assert_eq!((found.moved, &found.beside[..]), (2, &given[2..3]));
        assert_eq!(found.measurements[0], row("a-film.png", "P1", film.in_frame([400.0, 300.0])));
        assert_eq!(found.measurements[1..], [given[1].clone(), row("a-film.png", "P3", film.in_frame([600.5, 700.25]))]);
    }
}
