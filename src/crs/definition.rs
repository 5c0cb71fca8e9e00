//! A coordinate reference system as it is named: an EPSG code, PROJ text or WKT.

use super::spelling::Spelling;
use crate::error::refuse;
use crate::text::shorten;
use crate::{Error, Refusal};
use proj_core::{AxisOrder, CrsDef, ProjectedCrsDef, ProjectionMethod, VerticalCrsDef, VerticalCrsKind};
use proj_wkt::{ParseError, parse_crs};

/// The projections of PROJ texts.
const PROJECTIONS: [&str; 18] = [
    "longlat", "utm", "tmerc", "lcc", "merc", "webmerc", "stere", "sterea", "omerc", "somerc", "krovak", "cass", "laea", "aea", "aeqd",
    "eqc", "poly", "eqearth",
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

/// A coordinate reference system that was read: geographic in degrees, or projected in a unit of length; heights in their own.
#[derive(Debug, Clone)]
pub(crate) struct Definition {
    text: String,
    spelling: Spelling,
    crs: CrsDef,
    /// Whether the text may state the shift to WGS 84: it names no datum that the registry has, and has east before north.
    may_state_shift: bool,
}

impl Definition {
    /// Reads an EPSG code (`EPSG:25832`, `EPSG:25832+7837` with heights), PROJ text (`+proj=utm +zone=32 …`) or WKT.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for what is none of these, and systems about the centre of the earth.
    pub fn read(text: &str) -> Result<Self, Error> {
        let text = text.trim();
        let named = shorten(text);
        let spelling = Spelling::of(text);
        let crs = match parse_crs(&spelling.text) {
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
        // A shift that the text states is applied in the order of axes that it states.
        if crs.datum().declares_shift() && crs.axis_order() != Some(AxisOrder::EastNorth) {
            return refuse(Refusal::CrsAxes { crs: named });
        }
        let may_state_shift = crs.datum().declares_shift() || (crs.datum().epsg() == 0 && crs.axis_order() == Some(AxisOrder::EastNorth));
        Ok(Self { text: text.to_string(), spelling, crs: crs.with_axis_order(AxisOrder::EastNorth), may_state_shift })
    }

    /// A system of the plane that no text defines, by its name.
    pub(super) fn of(name: &str, crs: CrsDef) -> Self {
        Self { text: name.into(), spelling: Spelling::none(), crs, may_state_shift: false }
    }

    /// As it was given.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// As the library reads it.
    pub(super) fn spelling(&self) -> &str {
        &self.spelling.text
    }

    pub(super) fn crs(&self) -> &CrsDef {
        &self.crs
    }

    /// Whether its text may state the shift to WGS 84, be it none at all, which the library does not tell from a shift that is not known.
    pub(super) fn may_state_shift(&self) -> bool {
        self.may_state_shift
    }

    /// The unit of eastings and northings in m; absent where coordinates are degrees.
    pub fn unit_m(&self) -> Option<f64> {
        self.crs.as_projected().map(ProjectedCrsDef::linear_unit_to_meter)
    }

    /// The unit of heights in m: metres where nothing says another, whatever that of eastings and northings is.
    pub fn height_unit_m(&self) -> f64 {
        let own = self.crs.vertical_crs().map(VerticalCrsDef::linear_unit_to_meter);
        own.or(self.spelling.height_unit_m).unwrap_or(1.0)
    }

    /// Whether it has the plane coordinates of another.
    pub fn has_plane_of(&self, other: &Self) -> bool {
        match (self.crs.horizontal_crs(), other.crs.horizontal_crs()) {
            // The library takes datums of one ellipsoid for one where neither states a shift.
            (Some(own), Some(others)) => {
                own.semantically_equivalent(&others) && !are_other_datums(own.datum().epsg(), others.datum().epsg())
            }
            _ => false,
        }
    }

    /// The name that the registry has for it; the text where it has none.
    pub fn name(&self) -> String {
        match self.crs.name() {
            "" => shorten(&self.text),
            name => name.to_string(),
        }
    }

    /// The EPSG code of its plane coordinates, where it has one.
    pub fn plane_epsg(&self) -> Option<u16> {
        let code = self.crs.horizontal_crs()?.epsg();
        u16::try_from(code).ok().filter(|code| *code != 0)
    }

    /// The central meridian of a transverse Mercator projection.
    pub fn central_meridian_deg(&self) -> Option<f64> {
        match self.crs.as_projected()?.method() {
            ProjectionMethod::TransverseMercator { lon0, .. } => Some(lon0),
            _ => None,
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

/// Whether the codes of two datums tell them apart; 0: without a code.
fn are_other_datums(own: u32, others: u32) -> bool {
    own != 0 && others != 0 && own != others
}
