//! The system of the observed positions: Cartesian, in m.

use crate::adjustment::PositionPrior;
use crate::error::refuse;
use crate::math::{local_from_geographic, median, median_longitude};
use crate::{BlockDescription, ControlRole, Error, GeographicOrigin, GroundControlPoint, KnownImage, ObservedPosition, Refusal};

/// Observed positions in one Cartesian system.
pub(super) struct Frame {
    pub images: Vec<Option<PositionPrior>>,
    /// Positions of surveyed points with their standard errors.
    pub control: Vec<([f64; 3], [f64; 3])>,
    /// Where (0, 0, 0) is, for geographic positions.
    pub origin: Option<GeographicOrigin>,
    /// Directions of view that were recorded, of positions that are geographic: x is east, y north, z up.
    pub views: Vec<Option<[f64; 3]>>,
    /// Positions of images that are of another system than the surveyed points: distances between them are compared, nothing more. Absent
    /// standard errors are those of coordinates that were not recorded.
    pub recorded: Vec<Option<PositionPrior>>,
    /// Whether heights that were not recorded are taken as nearly the same, since those that were do not level the block.
    pub is_levelled: bool,
}

/// Fewer heights do not level a block.
const LEVELLING: usize = 3;
/// Standard error in m of a height of which nothing is known but that the flight was about level.
const LEVEL_SIGMA_M: f64 = 100.0;

/// Surveyed points, or positions of images, from which on they place a block by themselves.
pub(crate) const PLACING: usize = 3;

impl Frame {
    /// Geographic positions are taken into a system that touches the earth in the middle of most of them. Where those of the images are of
    /// another kind than those of surveyed points, the surveyed points alone give the system.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for local and geographic positions of images, or of surveyed points, and for different kinds of both where the
    /// surveyed points are too few to place the block.
    pub fn new(description: &BlockDescription) -> Result<Self, Error> {
        Self::with_images(description, &description.images)
    }

    /// The system of a description, with positions of the same images that may be known otherwise than it has them.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_images(description: &BlockDescription, images: &[KnownImage]) -> Result<Self, Error> {
        let of_images: Vec<ObservedPosition> = description.images.iter().filter_map(|image| image.position).collect();
        let places = |control: &&GroundControlPoint| control.role == ControlRole::Control;
        let of_control: Vec<ObservedPosition> = description.control.iter().filter(places).map(|control| control.position).collect();
        let are_apart = of_control.len() >= PLACING
            && matches!((is_geographic(&of_images), is_geographic(&of_control)), (Some(images), Some(control)) if images != control);
        let (placing, apart) = if are_apart { (of_control, of_images) } else { ([of_images, of_control].concat(), Vec::new()) };
        let (system, recording) = (System::of(&placing)?, System::of(&apart)?);
        let of_image = |system: &System, is_wanted: bool| {
            images.iter().map(|image| image.position.as_ref().filter(|_| is_wanted).map(|p| system.prior(p))).collect()
        };
        let surveyed = |position: &ObservedPosition| {
            let PositionPrior { position, sigma } = system.prior(position);
            (position, sigma.map(|sigma| sigma.unwrap_or(LEVEL_SIGMA_M)))
        };
        Ok(Self {
            images: of_image(&system, !are_apart),
            recorded: of_image(&recording, are_apart),
            views: images.iter().map(|image| image.view.filter(|_| system.origin.is_some())).collect(),
            control: description.control.iter().map(|control| surveyed(&control.position)).collect(),
            origin: system.origin.map(|[longitude_deg, latitude_deg, height_m]| GeographicOrigin { longitude_deg, latitude_deg, height_m }),
            is_levelled: system.is_levelled,
        })
    }
}

/// Where (0, 0, 0) of the system of a block is; absent where it has no place on the earth.
///
/// # Errors
/// [`Error::InvalidInput`] for observed positions of different kinds.
pub(crate) fn origin_of(description: &BlockDescription) -> Result<Option<GeographicOrigin>, Error> {
    Frame::new(description).map(|frame| frame.origin)
}

/// Whether positions are geographic; `None` where there are none or of both kinds.
fn is_geographic(positions: &[ObservedPosition]) -> Option<bool> {
    let first = place(positions.first()?).is_some();
    positions.iter().all(|position| place(position).is_some() == first).then_some(first)
}

/// The Cartesian system of some observed positions.
struct System {
    origin: Option<[f64; 3]>,
    is_levelled: bool,
}

impl System {
    fn of(positions: &[ObservedPosition]) -> Result<Self, Error> {
        let places: Vec<Place> = positions.iter().filter_map(place).collect();
        if !places.is_empty() && places.len() < positions.len() {
            let (geographic, local) = (places.len(), positions.len() - places.len());
            return refuse(Refusal::MixedPositions { geographic, local, placing: PLACING });
        }
        let heights = places.iter().filter(|place| place.height.is_some()).count();
        Ok(Self { origin: middle(&places), is_levelled: heights < LEVELLING && heights < places.len() })
    }

    fn prior(&self, position: &ObservedPosition) -> PositionPrior {
        match *position {
            ObservedPosition::Local { position, sigma } => PositionPrior { position, sigma: sigma.map(Some) },
            ObservedPosition::Geographic { height_m, sigma_m: [east, north, up], .. } => {
                let up = if height_m.is_some() { Some(up) } else { self.is_levelled.then_some(LEVEL_SIGMA_M) };
                let local = |(Place { longitude, latitude, height }, origin): (Place, [f64; 3])| {
                    local_from_geographic([longitude, latitude, height.unwrap_or(origin[2])], origin)
                };
                let position = place(position).zip(self.origin).map_or([0.0; 3], local);
                PositionPrior { position, sigma: [Some(east), Some(north), up] }
            }
        }
    }
}

/// A geographic position in degrees and m.
#[derive(Debug, Clone, Copy)]
struct Place {
    longitude: f64,
    latitude: f64,
    height: Option<f64>,
}

fn place(position: &ObservedPosition) -> Option<Place> {
    match *position {
        ObservedPosition::Local { .. } => None,
        ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, .. } => {
            Some(Place { longitude: longitude_deg, latitude: latitude_deg, height: height_m })
        }
    }
}

/// The medians, which a few positions far from all others do not move; the height is 0 where none is known.
fn middle(places: &[Place]) -> Option<[f64; 3]> {
    let longitude = median_longitude(&places.iter().map(|place| place.longitude).collect::<Vec<f64>>())?;
    let latitude = median(&mut places.iter().map(|place| place.latitude).collect::<Vec<f64>>())?;
    let height = median(&mut places.iter().filter_map(|place| place.height).collect::<Vec<f64>>());
    Some([longitude, latitude, height.unwrap_or(0.0)])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(longitude: f64, latitude: f64, height: Option<f64>) -> Place {
        Place { longitude, latitude, height }
    }

    #[test]
    fn a_block_across_the_date_line_has_its_middle_there() {
        let [longitude, latitude, height] = middle(&[at(179.9, 10.0, Some(5.0)), at(-179.8, 10.2, Some(7.0))]).unwrap();
        assert!((longitude + 179.95).abs() < 1e-9 && (latitude - 10.1).abs() < 1e-9 && height == 6.0);
        assert!(middle(&[]).is_none());
    }

    #[test]
    fn neither_a_position_without_a_fix_nor_one_without_a_height_moves_the_middle() {
        let places = [
            at(0.0, 0.0, Some(0.0)),
            at(8.0, 50.0, Some(400.0)),
            at(8.1, 50.1, None),
            at(8.2, 50.2, Some(402.0)),
            at(8.3, 50.3, Some(404.0)),
        ];
        let [longitude, latitude, height] = middle(&places).unwrap();
        assert!(
            (longitude - 8.1).abs() < 1e-9 && (latitude - 50.1).abs() < 1e-9 && (height - 401.0).abs() < 1e-9,
            "{longitude} {latitude} {height}"
        );
        assert_eq!(middle(&[at(8.0, 50.0, None)]).unwrap()[2], 0.0);
    }
}
