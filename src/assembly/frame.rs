//! The system of the observed positions: Cartesian, in m.

use super::description::{BlockDescription, ObservedPosition};
use crate::Error;
use crate::bundle::PositionPrior;
use crate::formats::GeographicOrigin;
use crate::math::local_from_geographic;

/// Observed positions in one Cartesian system.
pub(super) struct Frame {
    pub images: Vec<Option<PositionPrior>>,
    pub control: Vec<PositionPrior>,
    /// Where (0, 0, 0) is, for geographic positions.
    pub origin: Option<GeographicOrigin>,
}

impl Frame {
    /// Geographic positions are taken into a system that touches the earth in their middle.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for local and geographic positions in one block.
    pub fn new(description: &BlockDescription) -> Result<Self, Error> {
        let of_images = description.images.iter().filter_map(|image| image.position);
        let all: Vec<ObservedPosition> = of_images.chain(description.control.iter().map(|control| control.position)).collect();
        let places: Vec<[f64; 3]> = all.iter().filter_map(place).collect();
        if !places.is_empty() && places.len() < all.len() {
            let got = format!("{} geographic and {} local ones", places.len(), all.len() - places.len());
            return Err(Error::InvalidInput { what: "observed positions", got, allowed: "either all local or all geographic".into() });
        }
        let origin = middle(&places);
        let prior = |position: &ObservedPosition| match *position {
            ObservedPosition::Local { position, sigma } => PositionPrior { position, sigma },
            ObservedPosition::Geographic { sigma_m, .. } => {
                let local = place(position).zip(origin).map_or([0.0; 3], |(place, origin)| local_from_geographic(place, origin));
                PositionPrior { position: local, sigma: sigma_m }
            }
        };
        Ok(Self {
            images: description.images.iter().map(|image| image.position.as_ref().map(prior)).collect(),
            control: description.control.iter().map(|control| prior(&control.position)).collect(),
            origin: origin.map(|[longitude_deg, latitude_deg, height_m]| GeographicOrigin { longitude_deg, latitude_deg, height_m }),
        })
    }
}

/// Longitude, latitude and height of a geographic position.
fn place(position: &ObservedPosition) -> Option<[f64; 3]> {
    match *position {
        ObservedPosition::Local { .. } => None,
        ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, .. } => Some([longitude_deg, latitude_deg, height_m]),
    }
}

/// The mean; longitudes count from the first, so that a block across the date line has its middle there.
fn middle(places: &[[f64; 3]]) -> Option<[f64; 3]> {
    let [first, ..] = *places.first()?;
    let from_first = |longitude: f64| {
        let d = longitude - first;
        if d > 180.0 {
            d - 360.0
        } else if d < -180.0 {
            d + 360.0
        } else {
            d
        }
    };
    let n = places.len() as f64;
    let longitude = first + places.iter().map(|p| from_first(p[0])).sum::<f64>() / n;
    let wrapped = if longitude > 180.0 {
        longitude - 360.0
    } else if longitude < -180.0 {
        longitude + 360.0
    } else {
        longitude
    };
    let mean = |k: usize| places.iter().map(|p| p[k]).sum::<f64>() / n;
    Some([wrapped, mean(1), mean(2)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_across_the_date_line_has_its_middle_there() {
        let [longitude, latitude, _] = middle(&[[179.9, 10.0, 5.0], [-179.8, 10.2, 7.0]]).unwrap();
        assert!((longitude + 179.95).abs() < 1e-9 && (latitude - 10.1).abs() < 1e-9);
        assert!(middle(&[]).is_none());
    }
}
