//! The system of the observed positions: Cartesian, in m.

use super::description::{BlockDescription, ObservedPosition};
use crate::Error;
use crate::bundle::PositionPrior;
use crate::formats::GeographicOrigin;
use crate::math::{local_from_geographic, median};

/// Observed positions in one Cartesian system.
pub(super) struct Frame {
    pub images: Vec<Option<PositionPrior>>,
    /// Positions of surveyed points with their standard errors.
    pub control: Vec<([f64; 3], [f64; 3])>,
    /// Where (0, 0, 0) is, for geographic positions.
    pub origin: Option<GeographicOrigin>,
    /// Whether heights that were not recorded are taken as nearly the same, since those that were do not level the block.
    pub is_levelled: bool,
}

/// Fewer heights do not level a block.
const LEVELLING: usize = 3;
/// Standard error in m of a height of which nothing is known but that the flight was about level.
const LEVEL_SIGMA_M: f64 = 100.0;

impl Frame {
    /// Geographic positions are taken into a system that touches the earth in the middle of most of them.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for local and geographic positions in one block.
    pub fn new(description: &BlockDescription) -> Result<Self, Error> {
        let of_images = description.images.iter().filter_map(|image| image.position);
        let all: Vec<ObservedPosition> = of_images.chain(description.control.iter().map(|control| control.position)).collect();
        let places: Vec<Place> = all.iter().filter_map(place).collect();
        if !places.is_empty() && places.len() < all.len() {
            let got = format!("{} geographic and {} local ones", places.len(), all.len() - places.len());
            return Err(Error::InvalidInput { what: "observed positions", got, allowed: "either all local or all geographic".into() });
        }
        let origin = middle(&places);
        let heights = places.iter().filter(|place| place.height.is_some()).count();
        let is_levelled = heights < LEVELLING && heights < places.len();
        let cartesian = |position: &ObservedPosition| match *position {
            ObservedPosition::Local { position, sigma } => (position, sigma.map(Some)),
            ObservedPosition::Geographic { height_m, sigma_m: [east, north, up], .. } => {
                let up = if height_m.is_some() { Some(up) } else { is_levelled.then_some(LEVEL_SIGMA_M) };
                let local = |(Place { longitude, latitude, height }, origin): (Place, [f64; 3])| {
                    local_from_geographic([longitude, latitude, height.unwrap_or(origin[2])], origin)
                };
                (place(position).zip(origin).map_or([0.0; 3], local), [Some(east), Some(north), up])
            }
        };
        let prior = |position: &ObservedPosition| {
            let (position, sigma) = cartesian(position);
            PositionPrior { position, sigma }
        };
        let surveyed = |position: &ObservedPosition| {
            let (position, sigma) = cartesian(position);
            (position, sigma.map(|sigma| sigma.unwrap_or(LEVEL_SIGMA_M)))
        };
        Ok(Self {
            images: description.images.iter().map(|image| image.position.as_ref().map(prior)).collect(),
            control: description.control.iter().map(|control| surveyed(&control.position)).collect(),
            origin: origin.map(|[longitude_deg, latitude_deg, height_m]| GeographicOrigin { longitude_deg, latitude_deg, height_m }),
            is_levelled,
        })
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

/// The medians, which a few positions far from all others do not move; the height is 0 where none is known. Longitudes count from that of
/// the median direction, so that a block across the date line has its middle there.
fn middle(places: &[Place]) -> Option<[f64; 3]> {
    let median_of = |value: &dyn Fn(&Place) -> Option<f64>| median(&mut places.iter().filter_map(value).collect::<Vec<f64>>());
    let [sine, cosine] = [libm::sin, libm::cos].map(|f| median_of(&|p| Some(f(p.longitude.to_radians()))));
    let from = libm::atan2(sine?, cosine?).to_degrees();
    let longitude = from + median_of(&|p| Some(wrapped(p.longitude - from)))?;
    Some([wrapped(longitude), median_of(&|p| Some(p.latitude))?, median_of(&|p| p.height).unwrap_or(0.0)])
}

/// A longitude between -180° and 180°.
fn wrapped(longitude: f64) -> f64 {
    if longitude > 180.0 {
        longitude - 360.0
    } else if longitude < -180.0 {
        longitude + 360.0
    } else {
        longitude
    }
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
