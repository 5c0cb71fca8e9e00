//! Ground that an image, resampled to the ground, shows otherwise than an orthophoto does: what it does not see, since by the heights something stands before
//! it, shows that in its place; and beside roofs their walls are mixed into it.
//!
//! Both lie to one side of what they belong to all around the image, the hidden outwards and the wall inwards. Matched with the rest of a window they draw
//! it outwards: the image is found too large, and its projection centre too low by several standard errors.

use super::heights::Heights;
use crate::{Georeference, Pose};
use std::cell::RefCell;

/// Grey values of so many pixels around are in that of a resampled one.
const REACH: i64 = 1;
/// A wall stands where heights bend by so much that the image shows it so many px of the picture wide.
const WALL_PX: f64 = 0.5;

/// Of the pixels of a picture of the ground, those that an image shows otherwise; asked for one by one, and remembered.
pub(super) struct Hidden<'a> {
    heights: &'a Heights,
    georeference: Georeference,
    size: [usize; 2],
    /// The projection centre: in px of the picture, and its height.
    centre_px: [f64; 2],
    centre_height: f64,
    /// No ground is higher.
    highest: f64,
    known: RefCell<Vec<Option<bool>>>,
}

impl<'a> Hidden<'a> {
    pub fn new(pose: &Pose, heights: &'a Heights, georeference: Georeference, size: [usize; 2]) -> Self {
        let [x, y, centre_height] = pose.position;
        let [_, highest] = heights.range();
        let known = RefCell::new(vec![None; size[0] * size[1]]);
        Self { heights, georeference, size, centre_px: georeference.pixel([x, y]), centre_height, highest, known }
    }

    /// Whether the pixel at a position is hidden or beside a wall, or one so near to it that it shows in its grey value.
    pub fn about(&self, at: [f64; 2]) -> bool {
        let [column, row] = at.map(|v| v.floor() as i64);
        (row - REACH..=row + REACH).any(|row| (column - REACH..=column + REACH).any(|column| self.at([column, row])))
    }

    /// Beside the picture nothing is.
    fn at(&self, at: [i64; 2]) -> bool {
        let [Ok(column), Ok(row)] = at.map(usize::try_from) else { return false };
        if column >= self.size[0] || row >= self.size[1] {
            return false;
        }
        let place = row * self.size[0] + column;
        let known = self.known.borrow()[place];
        known.unwrap_or_else(|| {
            let is_otherwise = self.is_otherwise([column as f64 + 0.5, row as f64 + 0.5]);
            self.known.borrow_mut()[place] = Some(is_otherwise);
            is_otherwise
        })
    }

    fn height(&self, at: [f64; 2]) -> Option<f64> {
        self.heights.at(self.georeference.ground(at))
    }

    fn is_otherwise(&self, at: [f64; 2]) -> bool {
        let Some(own) = self.height(at) else { return false };
        let way = [0, 1].map(|k| self.centre_px[k] - at[k]);
        let length = libm::hypot(way[0], way[1]);
        // Of a height of 1 the image shows so many px.
        let slope = length / (self.centre_height - own);
        self.bend(at, own) * slope > WALL_PX || self.is_hidden(at, own, way, length)
    }

    /// By how much the height differs from the mean of those on both sides, twice; along columns or rows, the larger one. Slopes have none.
    fn bend(&self, [x, y]: [f64; 2], own: f64) -> f64 {
        let across = [[1.0, 0.0], [0.0, 1.0]].map(|[dx, dy]| {
            let sides = self.height([x - dx, y - dy]).zip(self.height([x + dx, y + dy]));
            sides.map_or(0.0, |(before, behind)| (before + behind - 2.0 * own).abs())
        });
        across[0].max(across[1])
    }

    /// By the ray to the projection centre, pixel by pixel.
    fn is_hidden(&self, from: [f64; 2], own: f64, way: [f64; 2], length: f64) -> bool {
        let (rise, step) = ((self.centre_height - own) / length, way.map(|v| v / length));
        let mut ray = (1..=length as usize).map(|k| (k as f64, own + rise * k as f64)).take_while(|(_, ray)| *ray <= self.highest);
        ray.any(|(k, ray)| self.height([from[0] + k * step[0], from[1] + k * step[1]]).is_some_and(|other| other > ray))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::HeightModel;

    #[test]
    fn an_image_does_not_see_what_lies_behind_a_house() {
        // A house 10 m high from column 40 to 43 of ground of 1 m a pixel, 30 m beside the point below the image, which is 100 m above it.
        let georeference = Georeference::north_up([0.0, 0.0], 1.0);
        let heights: Vec<f32> = (0..80 * 20).map(|k| if (40..44).contains(&(k % 80)) { 10.0 } else { 0.0 }).collect();
        let heights = Heights::Model(HeightModel::new(80, 20, heights, georeference).unwrap());
        let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [10.5, -10.5, 100.0] };
        let hidden = Hidden::new(&pose, &heights, georeference, [80, 20]);
        let columns = |from_above: &dyn Fn(i64) -> bool| (0..80).filter(|column| from_above(*column)).collect::<Vec<i64>>();
        // It leans by 33 m · 10 m / 90 m = 3.7 m outwards: three pixels behind it are hidden. Beside its walls, 3 to 4 px wide, one on both sides is mixed; the
        // middle of the roof is seen, and so is the ground before it and farther behind.
        assert_eq!(columns(&|column| hidden.at([column, 10])), [39, 40, 43, 44, 45, 46]);
        assert_eq!(columns(&|column| hidden.about([column as f64 + 0.5, 10.5])), (38..48).collect::<Vec<i64>>());
        assert!(![[-1, 10], [44, -1], [80, 10], [44, 20]].iter().any(|at| hidden.at(*at)), "beside the picture");
        // Level ground is seen, and so is a slope that does not lean away.
        let slope: Vec<f32> = (0..80 * 20).map(|k| (k % 80) as f32 * 0.5).collect();
        for even in [Heights::Level(3.0), Heights::Model(HeightModel::new(80, 20, slope, georeference).unwrap())] {
            let seen = Hidden::new(&pose, &even, georeference, [80, 20]);
            assert!(columns(&|column| seen.at([column, 10])).is_empty());
        }
    }
}
