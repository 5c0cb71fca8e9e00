//! A coordinate reference system as it is named: an EPSG code, PROJ text or WKT.

use crate::error::refuse;
use crate::text::shorten;
use crate::{Error, Refusal};
use proj_core::{AxisOrder, CrsDef, VerticalCrsKind};
use proj_wkt::{ParseError, parse_crs};

/// The projections of PROJ texts.
const PROJECTIONS: [&str; 17] = [
    "longlat", "utm", "tmerc", "lcc", "merc", "webmerc", "stere", "sterea", "omerc", "krovak", "cass", "laea", "aea", "aeqd", "eqc",
    "poly", "eqearth",
];

/// What heights count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HeightReference {
    /// The ellipsoid, as those of GNSS do.
    Ellipsoid,
    /// The system has heights of its own, as those above sea level.
    Other,
    /// The system is one of the plane.
    Unsaid,
}

/// A coordinate reference system that was read: geographic in degrees, or projected in m.
#[derive(Debug, Clone)]
pub(crate) struct Definition {
    text: String,
    crs: CrsDef,
}

impl Definition {
    /// Reads an EPSG code (`EPSG:25832`, `EPSG:25832+7837` with heights), PROJ text (`+proj=utm +zone=32 …`) or WKT.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for what is none of these, systems about the centre of the earth, and units other than degrees and metres.
    pub fn read(text: &str) -> Result<Self, Error> {
        let text = text.trim();
        let named = shorten(text);
        let crs = match parse_crs(text) {
            Ok(crs) => crs,
            Err(ParseError::Core(proj_core::Error::UnknownCrs(_))) => return refuse(Refusal::UnknownCrs { crs: named }),
            Err(error) => {
                let projections = PROJECTIONS.join(", ");
                return refuse(Refusal::CrsText { crs: named, reason: error.to_string(), projections });
            }
        };
        if crs.is_geocentric() {
            return refuse(Refusal::GeocentricCrs { crs: named });
        }
        let plane = crs.as_projected().map(|projected| projected.linear_unit_to_meter());
        let up = crs.vertical_crs().map(|vertical| vertical.linear_unit_to_meter());
        if let Some(unit_m) = plane.into_iter().chain(up).find(|unit_m| *unit_m != 1.0) {
            return refuse(Refusal::CrsUnit { crs: named, unit_m });
        }
        // A shift that the text states is applied in the order of axes that it states.
        if crs.datum().declares_shift() && crs.axis_order() != Some(AxisOrder::EastNorth) {
            return refuse(Refusal::CrsAxes { crs: named });
        }
        Ok(Self { text: text.to_string(), crs: crs.with_axis_order(AxisOrder::EastNorth) })
    }

    /// As it was given.
    pub fn text(&self) -> &str {
        &self.text
    }

    pub(super) fn crs(&self) -> &CrsDef {
        &self.crs
    }

    /// The name that the registry has for it; the text where it has none.
    pub fn name(&self) -> String {
        match self.crs.name() {
            "" => shorten(&self.text),
            name => name.to_string(),
        }
    }

    /// Whether coordinates are longitude and latitude in degrees.
    pub fn is_geographic(&self) -> bool {
        self.crs.is_geographic()
    }

    pub fn heights(&self) -> HeightReference {
        match self.crs.vertical_crs().map(|vertical| vertical.kind()) {
            None => HeightReference::Unsaid,
            Some(VerticalCrsKind::EllipsoidalHeight { .. }) => HeightReference::Ellipsoid,
            Some(VerticalCrsKind::GravityRelatedHeight { .. }) => HeightReference::Other,
        }
    }
}
