//! The system of coordinates that place a block, and how exact they are where they do not say so themselves.

use crate::catalogue::options;
use crate::crs::{Definition, HeightReference};
use crate::error::refuse;
use crate::{Error, GnssErrors, Refusal};

options! {
    /// The coordinate system; standard errors of GNSS positions and control points that state none, of image measurements, and what errors share.
    pub struct GeoreferencingOptions in "placing" {
        section "Coordinate system";

        /// The coordinate reference system of the control points, in which tables give the results, too: an EPSG code (EPSG:25832), PROJ text or WKT. GNSS positions, control points and an orthophoto then georeference the block together.
        crs: Option<String> = None, "Coordinate system", absent "control points are in a system of their own, in m; results in theirs, or in one that touches the earth at the block";

        /// The height of the zero of the heights of this system above the ellipsoid of WGS 84, as the geoid has it at the block: 0 for ellipsoidal heights. A geoid file gives it at each place.
        /// Heights of GNSS positions, which are above the ellipsoid, then take part beside those of control points.
        geoid_m: Option<f64> = None, "Height of the geoid", in "m", -200..=200, absent "not known: heights of GNSS positions take no part beside control points, unless the system has ellipsoidal heights", acts "placing.crs is not absent";

        section "Standard errors of positions";

        /// The standard error of east and of north of GNSS positions that state none, some metres, or centimetres where they were corrected:
        /// higher gives them less weight.
        receiver_across_m: f64 = 3.0, "GNSS positions, horizontal", in "m", 0.001..=1000;

        /// The standard error of the height of GNSS positions that state none: higher gives it less weight.
        receiver_up_m: f64 = 6.0, "GNSS positions, vertical", in "m", 0.001..=1000;

        /// The standard error of x and of y of control points that state none: higher gives them less weight.
        surveyed_across_m: f64 = 0.02, "Control points, horizontal", in "m", 0.0001..=100;

        /// The standard error of the height of control points that state none: higher gives it less weight.
        surveyed_up_m: f64 = 0.03, "Control points, vertical", in "m", 0.0001..=100;

        /// The standard error of a coordinate of an image measurement of a control or check point: higher gives it less weight beside tie points.
        /// Measurements beyond five times as much do not fit.
        mark_sigma_px: f64 = 1.0, "Image measurements", in "px", 0.01..=100;

        /// Whether standard errors of image measurements, GNSS positions and control points are estimated from the residuals, and weights follow
        /// them where they differ from what is stated by more than chance.
        variance_components: bool = false, "Estimate standard errors";

        /// The offset of GNSS positions that is estimated: one of all, or one of each strip of the flight, alone or with a drift that is linear along it.
        /// It is kept where it differs from zero by more than chance. Without control points only differences between strips can be told.
        gnss_errors: GnssErrors = GnssErrors::None, "Offsets of GNSS positions";

        /// Whether the lever arm of each camera is estimated, from its projection centre to the antenna of GNSS, and kept where it differs from zero by
        /// more than chance.
        gnss_lever_arm: bool = false, "Lever arm to the antenna";

        /// The standard deviation of errors that the observations of an image share, as matches do, in standard errors of an observation: higher
        /// makes the printed standard errors larger. 0: observations are independent.
        shared_errors: Option<f64> = None, "Shared errors", 0..=10, absent "0.25, of refined observations 0.3";
    }
}

impl GeoreferencingOptions {
    /// Rejects values outside their ranges, and a coordinate system that cannot be read.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::InvalidInput`] for the coordinate system.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.check_ranges()?;
        let Some(definition) = self.definition()? else { return Ok(()) };
        match self.geoid_m.filter(|geoid_m| definition.heights() == HeightReference::Ellipsoid && *geoid_m != 0.0) {
            Some(geoid_m) => refuse(Refusal::GeoidOfEllipsoid { crs: definition.name(), geoid_m }),
            None => Ok(()),
        }
    }

    /// Rejects the file of a geoid that no heights would count from, as without a system or with ellipsoidal heights, and one beside its height.
    ///
    /// # Errors
    /// [`Error::InvalidInput`].
    pub(crate) fn check_geoid(&self, name: Option<&str>) -> Result<(), Error> {
        let Some(name) = name.map(String::from) else { return Ok(()) };
        if let Some(geoid_m) = self.geoid_m {
            return refuse(Refusal::GeoidTwice { name, geoid_m });
        }
        let Some(definition) = self.definition()? else { return refuse(Refusal::GeoidWithoutCrs { name }) };
        if definition.heights() == HeightReference::Ellipsoid {
            return refuse(Refusal::GeoidFileOfEllipsoid { name, crs: definition.name() });
        }
        Ok(())
    }

    /// The coordinate system as it was given; absent where none was.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where it cannot be read.
    pub(crate) fn definition(&self) -> Result<Option<Definition>, Error> {
        self.crs.as_deref().map(Definition::read).transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_standard_error_is_a_number_above_zero() {
        GeoreferencingOptions::default().check_ranges().unwrap();
        for wrong in [0.0, -1.0, f64::NAN] {
            let options = GeoreferencingOptions { receiver_up_m: wrong, ..GeoreferencingOptions::default() };
            assert!(matches!(options.check_ranges(), Err(Error::InvalidOption { field: "placing.receiver_up_m", .. })), "{wrong}");
        }
    }
}
