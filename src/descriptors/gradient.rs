//! Descriptors of the directional derivatives around a point, from its dominant direction on.

mod bytes;
mod direction;
mod histogram;
mod options;
mod orientation;
mod patch;

pub use options::{FeatureOptions, GradientOptions};

use crate::error::refuse;
use crate::{Error, GreyView, Refusal, ScalePoint, ScaleSpace, multiscale_points};
use histogram::{Grid, LENGTH};
use patch::{PADDED, Placement, ROW, SIDE};

/// A point with its datum and its descriptor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feature {
    pub point: ScalePoint,
    /// The dominant direction of the gradients, from x towards y, 0 to 2π; 0 where the grid is upright.
    pub orientation_rad: f64,
    /// 4 rows of 4 cells with the gradients of 8 directions each, from the dominant one on.
    pub descriptor: [u8; LENGTH],
}

/// Finds points that are distinct in position and scale and describes them: [`multiscale_points`], then [`gradient_features`].
///
/// # Errors
/// As those two.
pub fn features(image: GreyView<'_>, mask: Option<GreyView<'_>>, options: &FeatureOptions) -> Result<Vec<Feature>, Error> {
    options.gradient.check_ranges()?;
    let (points, space) = multiscale_points(image, mask, &options.multiscale)?;
    gradient_features(&space, &points, &options.gradient)
}

/// Describes points by the gradients around them.
///
/// The grey values are sampled on a grid of 4 x 4 cells, turned by the dominant direction of the gradients, in the blurred image nearest
/// to the point's scale. Each gradient is the sum of two vectors along the two of 8 directions between which it lies; their lengths are summed
/// by cell and direction, with linear interpolation between the cells and a Gaussian weight. The sums are made a unit vector, clipped and stored as bytes, so that they change with neither gain nor offset. A
/// point with several dominant directions gives as many features, the strongest first; one without gradients gives none, unless upright.
///
/// # Errors
/// [`Error::InvalidOption`], naming the field and its range; [`Error::InvalidInput`] for a point outside the image or a scale beyond its longer
/// side.
///
/// # Source
/// Lowe 2004, Distinctive image features from scale-invariant keypoints, sections 5 and 6.
pub fn gradient_features(space: &ScaleSpace, points: &[ScalePoint], options: &GradientOptions) -> Result<Vec<Feature>, Error> {
    options.check_ranges()?;
    let grid = Grid::new();
    let mut samples = [[0.0; ROW]; PADDED];
    let mut features = Vec::with_capacity(points.len());
    for point in points {
        check_point(point, space)?;
        let nearest = space.nearest(point.scale_px);
        let scale = point.scale_px / nearest.step_px;
        let [x, y] = [point.x, point.y].map(|p| (p - 0.5) / nearest.step_px);
        let directions = match options.upright {
            true => vec![0.0],
            false => orientation::dominant(nearest.level, x, y, scale, options.orientations),
        };
        for orientation_rad in directions {
            let direction = [libm::cos(orientation_rad), libm::sin(orientation_rad)];
            let step = options.cell * scale * 4.0 / SIDE as f64;
            patch::sample(nearest.level, &Placement { x, y, step, direction }, &mut samples);
            let descriptor = bytes::bytes(&grid.histogram(&samples), options.roots);
            features.push(Feature { point: *point, orientation_rad, descriptor });
        }
    }
    Ok(features)
}

/// Refuses positions outside the image and scales that none of its points has.
fn check_point(point: &ScalePoint, space: &ScaleSpace) -> Result<(), Error> {
    let (width, height) = space.size();
    let within = |value: f64, most: usize| value >= 0.0 && value <= most as f64;
    if within(point.x, width) && within(point.y, height) && within(point.scale_px, width.max(height)) && point.scale_px > 0.0 {
        return Ok(());
    }
    refuse(Refusal::DescribedPoint { x: point.x, y: point.y, scale_px: point.scale_px, width, height })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;
    use std::f64::consts::PI;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// A scene of spots of many sizes, seen turned by `angle` about its middle and enlarged by `zoom`; also with another gain and offset.
    fn scene(side: usize, angle: f64, zoom: f64, gain: f64, offset: f64) -> GreyImage {
        let (cos, sin) = (libm::cos(angle) / zoom, libm::sin(angle) / zoom);
        let mut random = 12345u32;
        let mut uniform = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(random >> 8) / f64::from(1 << 24)
        };
        let spots: Vec<[f64; 4]> = (0..260)
            .map(|_| [200.0 * uniform() - 100.0, 200.0 * uniform() - 100.0, 1.5 + 5.0 * uniform() * uniform(), 120.0 * uniform() - 60.0])
            .collect();
        let grey = |col: usize, row: usize| {
            let (u, v) = (col as f64 + 0.5 - side as f64 / 2.0, row as f64 + 0.5 - side as f64 / 2.0);
            let (x, y) = (u * cos + v * sin, v * cos - u * sin);
            let sum: f64 = spots
                .iter()
                .map(|[a, b, sigma, amplitude]| {
                    let exponent = ((x - a) * (x - a) + (y - b) * (y - b)) / (2.0 * sigma * sigma);
                    if exponent < 12.0 { amplitude * libm::exp(-exponent) } else { 0.0 }
                })
                .sum();
            (128.0 + offset + gain * sum + 0.5).clamp(0.0, 255.0) as u8
        };
        GreyImage::from_fn(side, side, grey).unwrap()
    }

    fn distance(a: &[u8; LENGTH], b: &[u8; LENGTH]) -> i32 {
        a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).pow(2)).sum()
    }

    /// Of the features of `a` that are nearest to one of `b` without a rival, the share whose place, scale and direction fit.
    fn share_of_right(a: &GreyImage, b: &GreyImage, angle: f64, zoom: f64) -> (usize, f64) {
        let found = [a, b].map(|image| features(image.view(), None, &FeatureOptions::default()).unwrap());
        let (cos, sin) = (zoom * libm::cos(angle), zoom * libm::sin(angle));
        let [a_side, b_side] = [a, b].map(|image| image.width() as f64 / 2.0);
        let (mut matched, mut right) = (0, 0);
        for f in &found[0] {
            let mut order: Vec<(i32, &Feature)> = found[1].iter().map(|g| (distance(&f.descriptor, &g.descriptor), g)).collect();
            order.sort_by_key(|(d, _)| *d);
            let [(first, g), (second, _)] = order[..2] else { panic!("two are there") };
            if f64::from(first) < 0.64 * f64::from(second) {
                matched += 1;
                let (u, v) = (f.point.x - a_side, f.point.y - a_side);
                let (x, y) = (u * cos - v * sin + b_side, u * sin + v * cos + b_side);
                let turn = (g.orientation_rad - f.orientation_rad - angle + 5.0 * PI) % (2.0 * PI) - PI;
                let grown = g.point.scale_px / f.point.scale_px / zoom;
                let near = (g.point.x - x).abs() < 1.5 && (g.point.y - y).abs() < 1.5;
                right += usize::from(near && turn.abs() < 0.25 && (0.75..1.33).contains(&grown));
            }
        }
        (matched, right as f64 / matched as f64)
    }

    #[test]
    fn features_follow_rotation_scale_and_contrast() {
        let plain = scene(220, 0.0, 1.0, 1.0, 0.0);
        for (angle, zoom, gain, offset) in [(0.0, 1.0, 0.6, 15.0), (0.5 * PI, 1.0, 1.0, 0.0), (0.6, 1.0, 1.0, 0.0), (2.9, 1.6, 0.8, -10.0)]
        {
            let (matched, share) = share_of_right(&plain, &scene(300, angle, zoom, gain, offset), angle, zoom);
            assert!(matched > 100 && share > 0.9, "{matched} matches, {share} right, turned by {angle}, enlarged by {zoom}");
        }
    }

    #[test]
    fn a_quarter_turn_turns_the_orientation_and_leaves_the_descriptor() {
        let image = scene(220, 0.0, 1.0, 1.0, 0.0);
        let turned = GreyImage::from_fn(220, 220, |col, row| image.view().at(row, 219 - col)).unwrap();
        let [a, b] = [&image, &turned].map(|image| features(image.view(), None, &FeatureOptions::default()).unwrap());
        let mut found = 0;
        for f in &a {
            // The octaves keep the even pixels, which are the odd ones from the other side: only the first is the same.
            let partner = |g: &&Feature| {
                (g.point.x - (220.0 - f.point.y)).abs() < 1e-3 && (g.point.y - f.point.x).abs() < 1e-3 && g.point.scale_px < 1.8
            };
            let Some(g) = b.iter().find(partner) else { continue };
            let turn = (g.orientation_rad - f.orientation_rad + 2.0 * PI) % (2.0 * PI);
            assert!((turn - 0.5 * PI).abs() < 0.02, "{turn}");
            assert!(distance(&f.descriptor, &g.descriptor) < 2000, "{}", distance(&f.descriptor, &g.descriptor));
            found += 1;
        }
        assert!(found > 50, "{found} of {}", a.len());
    }

    #[test]
    fn upright_features_have_no_direction_and_several_directions_several_features() {
        let image = scene(160, 0.0, 1.0, 1.0, 0.0);
        let (points, space) = multiscale_points(image.view(), None, &crate::MultiscaleOptions::default()).unwrap();
        let of = |options: &GradientOptions| gradient_features(&space, &points, options).unwrap();
        let upright = of(&GradientOptions { upright: true, ..GradientOptions::default() });
        assert!(upright.len() == points.len() && upright.iter().all(|f| f.orientation_rad == 0.0));
        let (one, more) = (of(&GradientOptions::default()), of(&GradientOptions { orientations: 3, ..GradientOptions::default() }));
        assert!(one.len() == points.len() && more.len() > one.len() && more.len() < 2 * one.len());
        assert!(one.iter().all(|f| more.contains(f)));
    }

    #[test]
    fn bad_options_and_points_are_refused() {
        let image = scene(64, 0.0, 1.0, 1.0, 0.0);
        let (points, space) = multiscale_points(image.view(), None, &crate::MultiscaleOptions::default()).unwrap();
        let default = GradientOptions::default();
        for options in [
            GradientOptions { orientations: 0, ..default.clone() },
            GradientOptions { orientations: 5, ..default.clone() },
            GradientOptions { cell: f64::NAN, ..default.clone() },
            GradientOptions { cell: 0.0, ..default.clone() },
        ] {
            assert!(matches!(gradient_features(&space, &points, &options), Err(Error::InvalidOption { .. })), "{options:?}");
        }
        let point = ScalePoint { x: 3.0, y: 3.0, scale_px: 2.0, weight: 1.0 };
        for stranger in [
            ScalePoint { x: f64::NAN, ..point },
            ScalePoint { y: -1.0, ..point },
            ScalePoint { x: 65.0, ..point },
            ScalePoint { scale_px: 0.0, ..point },
            ScalePoint { scale_px: f64::INFINITY, ..point },
        ] {
            assert!(matches!(gradient_features(&space, &[stranger], &default), Err(Error::InvalidInput { .. })), "{stranger:?}");
        }
        for corner in [ScalePoint { x: 0.0, y: 0.0, ..point }, ScalePoint { x: 64.0, y: 64.0, scale_px: 64.0, ..point }] {
            let wide = GradientOptions { cell: 20.0, upright: true, ..default.clone() };
            assert_eq!(gradient_features(&space, &[corner], &wide).unwrap().len(), 1);
        }
    }

    /// The same number natively and as WebAssembly.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn features_are_the_same_on_every_machine() {
        let image = scene(130, 0.3, 1.0, 1.0, 0.0);
        let found = features(image.view(), None, &FeatureOptions::default()).unwrap();
        let mut sum = 0xcbf2_9ce4_8422_2325u64;
        let mut take = |byte: u8| sum = (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        for f in &found {
            let p = f.point;
            [p.x, p.y, p.scale_px, p.weight, f.orientation_rad].iter().for_each(|v| v.to_le_bytes().into_iter().for_each(&mut take));
            f.descriptor.into_iter().for_each(&mut take);
        }
        assert_eq!((found.len(), format!("{sum:016x}")), (111, "6a92b594068afb3b".to_string()));
    }
}
