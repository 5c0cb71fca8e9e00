//! Where heights count from.

use super::Geoid;
use std::sync::Arc;

/// Where the heights of a coordinate reference system count from.
#[derive(Debug, Clone, Default)]
pub enum HeightZero {
    /// From a level of their own.
    #[default]
    Unknown,
    /// From so high above the ellipsoid of WGS 84, in m, wherever the block is: 0 for ellipsoidal heights.
    Level(f64),
    Geoid(Arc<Geoid>),
}

impl HeightZero {
    /// Of a height that holds wherever the block is, unless a geoid is given.
    pub fn of(above_m: Option<f64>, geoid: Option<Geoid>) -> Self {
        geoid.map_or_else(|| above_m.into(), |geoid| Self::Geoid(Arc::new(geoid)))
    }

    pub(crate) fn is_known(&self) -> bool {
        !matches!(self, Self::Unknown)
    }

    /// Above the ellipsoid of WGS 84 at a longitude and latitude in degrees, in m; absent where it is not known.
    pub(crate) fn above_m(&self, place: [f64; 2]) -> Option<f64> {
        match self {
            Self::Unknown => None,
            Self::Level(above_m) => Some(*above_m),
            Self::Geoid(geoid) => Some(geoid.above_m(place)),
        }
    }
}

impl From<Option<f64>> for HeightZero {
    fn from(above_m: Option<f64>) -> Self {
        above_m.map_or(Self::Unknown, Self::Level)
    }
}
