//! Where an image may lie on an orthophoto: features that agree on a similarity, of which each match alone says one.

use super::outcome::NotPlaced;
use crate::two_view::Support;
use crate::{DescriptorMatch, Feature, NearestOptions, nearest_matches};
use nalgebra::{Matrix3, Vector3};

/// A match agrees with the similarity of another within this share of the longer side of the image, and with an affine transformation of
/// all that agree within that one: what a tilted view of hilly ground departs from it.
const SIMILAR: f64 = 0.1;
const AFFINE: f64 = 0.06;
/// Natural logarithm of the expected number of places that chance agrees on as well, at most.
const MOST_FALSE_ALARMS: f64 = -2.0;
/// Matches that agree, at least.
const LEAST_AGREEING: usize = 8;
/// Affine transformations from those that agreed with the one before.
const ROUNDS: usize = 4;

/// Matches of the image with the orthophoto that agree on a place, as indices of both lists of features. `longer_side_px` of the image,
/// `area_px2` of the picture of the ground that was searched.
pub(super) fn first_place(
    image: &[Feature],
    ground: &[Feature],
    longer_side_px: f64,
    area_px2: f64,
) -> Result<Vec<DescriptorMatch>, NotPlaced> {
    let bytes = |features: &[Feature]| features.iter().flat_map(|f| f.descriptor).collect::<Vec<u8>>();
    let matches = nearest_matches(&bytes(image), &bytes(ground), &NearestOptions::default()).unwrap_or_default();
    let refused = |agreeing: usize| NotPlaced::NoCommonPlace { matches: matches.len(), agreeing };
    let seen: Vec<[[f64; 2]; 2]> = matches.iter().map(|m| [position(&image[m.left]), position(&ground[m.right])]).collect();
    let by_one = matches.iter().map(|m| Affine::of_frames(&image[m.left], &ground[m.right]));
    let counted = by_one.map(|map| (map.agreeing(&seen, SIMILAR * longer_side_px).count(), map));
    let Some((_, mut map)) = counted.max_by_key(|(count, _)| *count) else { return Err(refused(0)) };
    let mut agreeing: Vec<usize> = map.agreeing(&seen, SIMILAR * longer_side_px).collect();
    for _ in 0..ROUNDS {
        let Some(fitted) = Affine::fitted(&agreeing.iter().map(|k| seen[*k]).collect::<Vec<_>>()) else {
            return Err(refused(agreeing.len()));
        };
        map = fitted;
        agreeing = map.agreeing(&seen, AFFINE * longer_side_px).collect();
    }
    let reach = AFFINE * longer_side_px;
    let chance = std::f64::consts::PI * reach * reach * map.growth() * map.growth() / area_px2;
    let support = Support { count: matches.len(), agreeing: agreeing.len(), sample: 3, models: 1, chance };
    if agreeing.len() < LEAST_AGREEING || !(support.log_false_alarms() < MOST_FALSE_ALARMS) {
        return Err(refused(agreeing.len()));
    }
    Ok(agreeing.into_iter().map(|k| matches[k]).collect())
}

fn position(feature: &Feature) -> [f64; 2] {
    [feature.point.x, feature.point.y]
}

/// An affine transformation of positions in px: x' = a + b x + c y, for both axes.
#[derive(Debug, Clone, Copy)]
struct Affine([[f64; 3]; 2]);

impl Affine {
    /// The similarity that takes the place, scale and direction of one feature to those of another.
    fn of_frames(from: &Feature, to: &Feature) -> Self {
        let turn = to.orientation_rad - from.orientation_rad;
        let growth = to.point.scale_px / from.point.scale_px;
        let (cos, sin) = (growth * libm::cos(turn), growth * libm::sin(turn));
        let ([x, y], [u, v]) = (position(from), position(to));
        Self([[u - cos * x + sin * y, cos, -sin], [v - sin * x - cos * y, sin, cos]])
    }

    /// By least squares; `None` for positions on a line.
    fn fitted(seen: &[[[f64; 2]; 2]]) -> Option<Self> {
        let n = seen.len() as f64;
        let middle = [0, 1].map(|k| seen.iter().map(|[from, _]| from[k]).sum::<f64>() / n);
        let (mut normal, mut right) = (Matrix3::<f64>::zeros(), [Vector3::zeros(); 2]);
        for [from, to] in seen {
            let row = Vector3::new(1.0, from[0] - middle[0], from[1] - middle[1]);
            normal += row * row.transpose();
            (0..2).for_each(|k| right[k] += row * to[k]);
        }
        let factor = normal.cholesky()?;
        let map = right.map(|right| factor.solve(&right)).map(|s| [s[0] - s[1] * middle[0] - s[2] * middle[1], s[1], s[2]]);
        map.iter().flatten().all(|v| v.is_finite()).then_some(Self(map))
    }

    /// How many px of the ground one px of the image is, in the mean over both directions.
    fn growth(&self) -> f64 {
        let [[_, a, b], [_, c, d]] = self.0;
        (a * d - b * c).abs().sqrt()
    }

    /// The matches that are within a distance in px of the image.
    fn agreeing<'s>(&self, seen: &'s [[[f64; 2]; 2]], within_px: f64) -> impl Iterator<Item = usize> + use<'s> {
        let (map, within) = (self.0, within_px * self.growth());
        (0..seen.len()).filter(move |k| {
            let [[x, y], to] = seen[*k];
            let [dx, dy] = [0, 1].map(|axis| map[axis][0] + map[axis][1] * x + map[axis][2] * y - to[axis]);
            dx * dx + dy * dy <= within * within
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ScalePoint;
    use crate::math::Random;

    fn feature(random: &mut Random, x: f64, y: f64, scale_px: f64, orientation_rad: f64) -> Feature {
        let descriptor = std::array::from_fn(|_| random.below(256) as u8);
        Feature { point: ScalePoint { x, y, scale_px, weight: 1.0 }, orientation_rad, descriptor }
    }

    /// Features of an image, and of a ground on which some of them lie turned and enlarged, the others anywhere.
    fn scene(right: usize, wrong: usize) -> [Vec<Feature>; 2] {
        let mut random = Random::new(7);
        let (mut image, mut ground) = (Vec::new(), Vec::new());
        let (sin, cos) = (0.6, 0.8);
        for k in 0..right + wrong {
            let [x, y] = [1000.0, 800.0].map(|side| side * random.below(1 << 20) as f64 / f64::from(1 << 20));
            let seen = feature(&mut random, x, y, 4.0, 0.3);
            let [u, v] = if k < right {
                [3000.0 + 1.5 * (cos * x - sin * y), 2000.0 + 1.5 * (sin * x + cos * y)]
            } else {
                [0, 1].map(|_| f64::from(6000 * (random.below(1 << 20) as u32 >> 4)) / f64::from(1 << 16))
            };
            let turn = if k < right { libm::atan2(sin, cos) } else { f64::from(k as u32) };
            let point = ScalePoint { x: u, y: v, scale_px: 6.0, weight: 1.0 };
            ground.push(Feature { point, orientation_rad: 0.3 + turn, descriptor: seen.descriptor });
            image.push(seen);
        }
        [image, ground]
    }

    #[test]
    fn few_right_matches_among_many_wrong_ones_tell_the_place() {
        let [image, ground] = scene(30, 400);
        let found = first_place(&image, &ground, 1000.0, 36e6).unwrap();
        assert!(found.iter().filter(|m| m.left < 30).count() == 30 && found.len() < 36, "{}", found.len());
    }

    #[test]
    fn wrong_matches_alone_tell_none() {
        let [image, ground] = scene(0, 400);
        assert!(matches!(first_place(&image, &ground, 1000.0, 36e6), Err(NotPlaced::NoCommonPlace { matches: 300.., .. })));
        assert!(matches!(first_place(&[], &ground, 1000.0, 36e6), Err(NotPlaced::NoCommonPlace { matches: 0, agreeing: 0 })));
    }
}
