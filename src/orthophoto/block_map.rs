//! The map of a block: the system in which its results are, and the way from there to that of its adjustment.

use super::footprint::Footprint;
use super::ground::Ground;
use super::heights::{HeightModel, Heights};
use super::other_zero::zero_of;
use crate::Georeference;
use crate::crs::{CoordinateSystem, HeightZero};
use crate::error::refuse;
use crate::math::median;
use crate::{BlockModel, BlockRun, Error, OnOrthophoto, Refusal, geographic_from_local, local_from_geographic};

/// The coordinate reference system of a block, beside that of its adjustment, which touches the earth at the block.
#[derive(Clone)]
pub(crate) struct BlockMap {
    system: CoordinateSystem,
    /// Longitude, latitude and height where the system of the adjustment touches the earth.
    origin: [f64; 3],
    /// An easting and a northing of 1 in m.
    pub unit_m: f64,
}

impl BlockMap {
    /// Absent where the block has none: then the map is the plane of its adjustment.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a system in degrees, of which a picture has no pixels with a side.
    pub fn of(run: &BlockRun) -> Result<Option<Self>, Error> {
        let origin = run.model.origin.map(|origin| [origin.longitude_deg, origin.latitude_deg, origin.height_m]);
        let Some((system, origin)) = run.system().zip(origin) else { return Ok(None) };
        match system.definition().unit_m() {
            Some(unit_m) => Ok(Some(Self { system, origin, unit_m })),
            None => refuse(Refusal::MapInDegrees { crs: system.definition().name() }),
        }
    }

    /// Of a place of the adjustment; absent outside the system.
    pub fn to_map(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        self.system.coordinates(geographic_from_local(place, self.origin))
    }

    /// Of a place of the map; absent outside the system.
    pub fn to_adjustment(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        self.system.geographic(place).map(|place| local_from_geographic(place, self.origin))
    }

    /// The ground that it shows, about where the adjustment touches the earth.
    pub(super) fn ground(&self) -> Ground {
        let known = self.system.coordinates(self.origin);
        Ground::of(self.system.definition(), known.map(|known| [self.origin, known]))
    }

    /// A height of 1 in m.
    pub(super) fn height_unit_m(&self) -> f64 {
        self.system.definition().height_unit_m()
    }

    /// Where its heights count from, of a block whose heights count from `zero` where the system does not say.
    pub(super) fn zero_of(&self, zero: HeightZero) -> HeightZero {
        zero_of(self.system.definition(), zero)
    }

    /// Longitude and latitude of the block.
    pub(super) fn place(&self) -> [f64; 2] {
        [self.origin[0], self.origin[1]]
    }

    /// The name of the system.
    pub fn name(&self) -> String {
        self.system.definition().name()
    }

    /// Of a system at a place of the earth.
    #[cfg(test)]
    pub(super) fn at(crs: &str, origin: [f64; 3]) -> Self {
        let definition = crate::crs::Definition::read(crs).unwrap();
        let unit_m = definition.unit_m().unwrap();
        Self { system: CoordinateSystem::new(definition, None, [origin[0], origin[1]]).unwrap(), origin, unit_m }
    }

    fn epsg(&self) -> Option<u16> {
        self.system.definition().plane_epsg()
    }

    /// Cells along each side by which an image finds its footprint.
    const CELLS: usize = 64;

    /// The heights of the map as those of the adjustment, coarsely: enough to tell what images show. About a level, within the ground that images show
    /// of that.
    pub fn coarse(&self, heights: &Heights, model: &BlockModel) -> Option<Heights> {
        let poses = || model.images.iter().filter_map(|image| image.pose.as_ref());
        let middle = |k: usize| median(&mut poses().map(|pose| pose.position[k]).collect::<Vec<_>>());
        let middle = [middle(0)?, middle(1)?, middle(2)?];
        let [low, high] = heights.range();
        let below = |[x, y]: [f64; 2], usual: Option<f64>| {
            let [x, y, _] = self.to_map([x, y, middle[2]])?;
            Some(self.to_adjustment([x, y, heights.at([x, y]).or(usual)?])?[2])
        };
        let level = Heights::Level(below([middle[0], middle[1]], Some(0.5 * (low + high)))?);
        let shown = borders(model, &level);
        let range = |k: usize| {
            let values = shown.iter().map(|place| place[k]);
            [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
        };
        let [[x0, x1], [y0, y1]] = [range(0), range(1)];
        let cell = (x1 - x0).max(y1 - y0) / Self::CELLS as f64;
        if !(cell > 0.0 && cell.is_finite()) {
            return Some(level);
        }
        let [columns, rows] = [x1 - x0, y1 - y0].map(|length| (length / cell).ceil().max(2.0) as usize);
        let of = Georeference::north_up([x0, y1], cell);
        let centre = |k: usize| of.ground([(k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5]);
        let values = (0..columns * rows).map(|k| below(centre(k), None).map_or(f32::NAN, |z| z as f32)).collect();
        Some(HeightModel::new(columns, rows, values, of).map_or(level, Heights::Model))
    }
}

/// The places where the borders of the oriented images meet the ground.
pub(super) fn borders(model: &BlockModel, heights: &Heights) -> Vec<[f64; 2]> {
    let oriented = model.images.iter().filter_map(|image| Some((&model.cameras[image.camera], image.pose.as_ref()?)));
    oriented.flat_map(|(camera, pose)| Footprint { camera, pose, heights }.border()).collect()
}

/// The code of the system in which the results of a block are: its own, or that of the orthophoto that it was placed on.
pub(crate) fn epsg_of(run: &BlockRun, map: Option<&BlockMap>) -> Option<u16> {
    match (map, &run.orthophoto) {
        (Some(map), _) => map.epsg(),
        (None, Some(OnOrthophoto::Linked { in_crs: false, epsg, .. } | OnOrthophoto::ByHand { in_crs: false, epsg, .. })) => *epsg,
        (None, _) => None,
    }
}
