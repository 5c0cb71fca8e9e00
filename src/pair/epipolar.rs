//! Where a point of one image may be seen in the other, by what relates the two views.

use super::geometry::PairInterior;
use crate::{Side, TwoViewModel};
use nalgebra::{Matrix3, Vector3};

/// Positions by which an epipolar line is given: distortion bends it.
const POSITIONS: usize = 65;

impl Side {
    fn index(self) -> usize {
        usize::from(self == Self::Right)
    }
}

/// Where a point of one image may be seen in the other: positions along its epipolar line, or the one place that the map of a plane or a
/// rotation gives. None where the line passes the other image.
///
/// `interior`: the interior orientations with which the model was found; absent where it was found without. The position in px of its image;
/// `other_size`: width and height of the other one in px, in which the positions are.
pub fn epipolar_line(
    model: &TwoViewModel,
    interior: Option<&PairInterior>,
    (side, [x, y]): (Side, [f64; 2]),
    other_size: (usize, usize),
) -> Vec<[f64; 2]> {
    let sides = interior.map(|pair| [&pair.left, &pair.right]);
    let (own, other) = (sides.map(|sides| sides[side.index()]), sides.map(|sides| sides[1 - side.index()]));
    let [x, y] = own.map_or([x, y], |own| own.undistorted_px(x, y));
    let from = Vector3::new(x, y, 1.0);
    let to_image = |[x, y]: [f64; 2]| other.map_or(Some([x, y]), |other| other.image_px(x, y));
    let (width, height) = (other_size.0 as f64, other_size.1 as f64);
    let within = |[x, y]: &[f64; 2]| (0.0..=width).contains(x) && (0.0..=height).contains(y);
    match model {
        TwoViewModel::Homography { homography } | TwoViewModel::Rotation { homography, .. } => {
            let map = matrix(homography);
            let seen = if side == Side::Left { Some(map * from) } else { map.try_inverse().map(|back| back * from) };
            let place = seen.filter(|seen| seen.z != 0.0).and_then(|seen| to_image([seen.x / seen.z, seen.y / seen.z]));
            place.filter(within).into_iter().collect()
        }
        TwoViewModel::Calibrated { fundamental, .. } | TwoViewModel::Fundamental { fundamental } => {
            let matrix = matrix(fundamental);
            let line = if side == Side::Left { matrix * from } else { matrix.transpose() * from };
            let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
            let corners = corners.map(|[x, y]: [f64; 2]| other.map_or([x, y], |other| other.undistorted_px(x, y)));
            let positions: Vec<[f64; 2]> = along(&line, &corners).into_iter().filter_map(to_image).collect();
            if positions.iter().any(within) { positions } else { Vec::new() }
        }
    }
}

fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

/// Positions evenly along a line, as far as the feet of these points on it.
fn along(line: &Vector3<f64>, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let square = line.x * line.x + line.y * line.y;
    if !(square > 0.0) {
        return Vec::new();
    }
    let length = square.sqrt();
    let (direction, foot) = ([-line.y / length, line.x / length], [-line.x * line.z / square, -line.y * line.z / square]);
    let feet = points.iter().map(|[x, y]| x * direction[0] + y * direction[1]);
    let (first, last) = feet.fold((f64::INFINITY, f64::NEG_INFINITY), |(first, last), at| (first.min(at), last.max(at)));
    let at = |k: usize| first + (last - first) * k as f64 / (POSITIONS - 1) as f64;
    (0..POSITIONS).map(|k| [foot[0] + at(k) * direction[0], foot[1] + at(k) * direction[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CameraMm, Interior};

    /// A pair of distorted cameras whose base is the photos' x axis.
    fn interior() -> PairInterior {
        let camera = CameraMm {
            principal_point_mm: [0.1, -0.2],
            radial_distortion: [2e-4, -1e-7, 0.0],
            ..CameraMm::without_distortion(20.0, Some(0.02))
        };
        let side = Interior::from_pixel_size(&camera, 1000, 800).unwrap();
        PairInterior { left: side, right: side, focal_mm: 20.0, doubt: None, one_lens: false, are_scans: false }
    }

    /// Rows of equal y: the photos stand side by side.
    const ROWS: TwoViewModel = TwoViewModel::Fundamental { fundamental: [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]] };

    #[test]
    fn the_line_of_a_point_is_its_row_where_the_base_is_the_x_axis() {
        for side in [Side::Left, Side::Right] {
            let line = epipolar_line(&ROWS, None, (side, [300.0, 200.0]), (1000, 800));
            assert_eq!(line.len(), POSITIONS);
            assert!(line.iter().all(|[_, y]| (y - 200.0).abs() < 1e-9));
            let (first, last) = (line[0][0].min(line[64][0]), line[0][0].max(line[64][0]));
            assert!(first.abs() < 1e-9 && (last - 1000.0).abs() < 1e-9, "from {first} to {last}");
            assert_eq!(epipolar_line(&ROWS, None, (side, [300.0, 900.0]), (1000, 800)), [[0.0; 2]; 0], "it passes the image");
        }
    }

    #[test]
    fn distortion_bends_the_line_and_its_rays_stay_on_it() {
        let pair = interior();
        let line = epipolar_line(&ROWS, Some(&pair), (Side::Left, [120.0, 90.0]), (1000, 800));
        let wanted = pair.left.photo_mm(120.0, 90.0)[1];
        assert!(line.iter().all(|[x, y]| (pair.right.photo_mm(*x, *y)[1] - wanted).abs() < 1e-9));
        let rows: Vec<f64> = line.iter().map(|p| p[1]).collect();
        assert!(rows.iter().cloned().fold(f64::NEG_INFINITY, f64::max) - rows.iter().cloned().fold(f64::INFINITY, f64::min) > 1.0);
        assert!(line.iter().any(|[x, y]| (x - 120.0).abs() < 20.0 && (y - 90.0).abs() < 1.0));
    }

    #[test]
    fn a_map_of_a_plane_gives_one_place_and_leads_back() {
        let homography = [[0.9, 0.1, 20.0], [-0.1, 1.1, 5.0], [1e-5, 0.0, 1.0]];
        let model = TwoViewModel::Homography { homography };
        let place = epipolar_line(&model, None, (Side::Left, [300.0, 200.0]), (1000, 800));
        assert_eq!(place.len(), 1);
        let back = epipolar_line(&model, None, (Side::Right, place[0]), (1000, 800));
        assert!((back[0][0] - 300.0).abs() < 1e-9 && (back[0][1] - 200.0).abs() < 1e-9);
        assert_eq!(epipolar_line(&model, None, (Side::Left, [5000.0, 200.0]), (1000, 800)), [[0.0; 2]; 0]);
    }
}
