//! What stands beside a raster that does not say it itself.

use super::geotiff::{SaidSystem, refuse_degrees};
use crate::crs::{Definition, HeightReference};
use crate::text::shorten;
use crate::{Error, PartlyGiven};
use serde::{Deserialize, Serialize};

/// The texts of files beside a raster, which say what it does not say itself.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Sidecars {
    /// Of a world file: where its pixels lie.
    pub world_file: Option<String>,
    /// Of a file `.prj`: its coordinate reference system as WKT.
    pub projection: Option<String>,
}

impl PartlyGiven for Sidecars {}

impl From<Option<&str>> for Sidecars {
    /// A world file alone.
    fn from(world_file: Option<&str>) -> Self {
        Self { world_file: world_file.map(String::from), projection: None }
    }
}

impl Sidecars {
    /// The system of a raster that says this of it: its own goes first.
    ///
    /// A text that is not understood names a system that is not known, as tags of a raster may.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for degrees.
    pub(crate) fn system(&self, said: SaidSystem) -> Result<SaidSystem, Error> {
        let says_own = said.epsg.is_some() || said.described.is_some();
        let Some(text) = self.projection.as_deref().filter(|_| !says_own) else { return Ok(said) };
        let described = Some(name_in(text)).filter(|name| !name.is_empty());
        let Ok(definition) = Definition::read(text) else { return Ok(SaidSystem { described, ..said }) };
        if definition.is_geographic() {
            return refuse_degrees();
        }
        let (epsg, states_heights) = (definition.plane_epsg(), definition.heights() != HeightReference::Unsaid);
        Ok(SaidSystem {
            epsg,
            described: described.filter(|_| epsg.is_none()),
            text: Some(definition.text().into()),
            unit_m: said.unit_m.or(definition.unit_m()),
            height_unit_m: said.height_unit_m.or(states_heights.then(|| definition.height_unit_m())),
            ..said
        })
    }
}

/// The name that a text gives a system: what WKT has in its first quotes, or the text.
fn name_in(text: &str) -> String {
    shorten(text.split('"').nth(1).unwrap_or(text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crs::CoordinateSystem;

    /// As Esri writes it: without a code.
    const ESRI: &str = r#"PROJCS["ETRS_1989_UTM_Zone_32N",GEOGCS["GCS_ETRS_1989",DATUM["D_ETRS_1989",SPHEROID["GRS_1980",6378137.0,298.257222101]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]]"#;

    fn system(projection: &str, said: SaidSystem) -> Result<SaidSystem, Error> {
        Sidecars { world_file: None, projection: Some(projection.into()) }.system(said)
    }

    #[test]
    fn a_file_beside_a_raster_says_its_system() {
        let coded = system("EPSG:25832", SaidSystem::default()).unwrap();
        assert_eq!((coded.epsg, coded.described.as_deref(), coded.unit_m), (Some(25_832), None, Some(1.0)));
        let esri = system(&format!("{ESRI}\n"), SaidSystem::default()).unwrap();
        assert!(esri.name().is_some_and(|name| name.contains("25832") || name == "ETRS_1989_UTM_Zone_32N"), "{esri:?}");
        let at = [691_000.0, 5_334_000.0];
        let place = |said: &SaidSystem| {
            let system = CoordinateSystem::about(said.definition().unwrap(), None, at).unwrap();
            system.geographic([at[0], at[1], 0.0]).unwrap()
        };
        let [east, north, _] = crate::math::local_from_geographic(place(&esri), place(&coded));
        assert!(east.hypot(north) < 1.0, "{east} {north}");
        // What the raster says itself goes first.
        let own = SaidSystem { epsg: Some(25_833), ..SaidSystem::default() };
        assert_eq!(system("EPSG:25832", own.clone()).unwrap(), own);
        assert!(system("EPSG:4326", SaidSystem::default()).is_err());
        // Of the former Arc/Info, and of nobody: the system has a name at most.
        for (text, name) in [("Projection    UTM\nZone 32\n", true), ("LOCAL_CS[\"site\"]", true), ("", false)] {
            let unknown = system(text, SaidSystem::default()).unwrap();
            assert!(unknown.definition().is_none() && unknown.described.is_some() == name, "{unknown:?}");
        }
        assert_eq!(system("LOCAL_CS[\"site\"]", SaidSystem::default()).unwrap().name().as_deref(), Some("site"));
        // Heights in their own unit.
        const FOOT_US: f64 = 1200.0 / 3937.0;
        let feet = system("EPSG:26910+6360", SaidSystem::default()).unwrap();
        assert!((feet.height_unit_m.unwrap() - FOOT_US).abs() < 1e-12, "{feet:?}");
    }
}
