//! Projected systems that are described by parameters, in place of a name.

use super::definition::Definition;
use proj_core::{CrsDef, LinearUnit, ProjectedCrsDef, ProjectionMethod, lookup_epsg};

/// A projected system by the parameters of its projection.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Described {
    /// What it is called.
    pub name: String,
    /// The code of the geographic system that is projected.
    pub base_epsg: u16,
    /// The unit of eastings and northings in m.
    pub unit_m: f64,
    pub projection: Projection,
    /// Longitude and latitude of the origin, in degrees.
    pub origin_deg: [f64; 2],
    /// The scale at the origin.
    pub scale: f64,
    /// Easting and northing of the origin, in the unit.
    pub of_origin: [f64; 2],
}

/// A kind of projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Projection {
    TransverseMercator,
    /// Lambert's conformal conic one, with the latitudes of its standard parallels in degrees; absent where the origin lies on the only one.
    Conic {
        parallels_deg: Option<[f64; 2]>,
    },
}

impl Described {
    /// Absent where its geographic system is unknown, or its numbers are none of a system.
    pub fn definition(&self) -> Option<Definition> {
        let Self { origin_deg: [lon0, lat0], scale: k0, of_origin, .. } = *self;
        let [false_easting, false_northing] = of_origin.map(|v| self.unit_m * v);
        let method = match self.projection {
            Projection::TransverseMercator => ProjectionMethod::TransverseMercator { lon0, lat0, k0, false_easting, false_northing },
            Projection::Conic { parallels_deg } => {
                let [lat1, lat2] = parallels_deg.unwrap_or([lat0; 2]);
                ProjectionMethod::LambertConformalConic { lon0, lat0, lat1, lat2, k0, false_easting, false_northing }
            }
        };
        let base = lookup_epsg(u32::from(self.base_epsg)).filter(CrsDef::is_geographic)?;
        let unit = LinearUnit::from_meters_per_unit(self.unit_m).ok()?;
        let datum = base.datum().clone();
        let crs = ProjectedCrsDef::new_with_base_geographic_crs(0, u32::from(self.base_epsg), datum, method, unit, "");
        Some(Definition::of(&self.name, CrsDef::Projected(crs)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crs::CoordinateSystem;

    #[test]
    fn described_systems_are_those_of_their_codes() {
        let transverse = Described {
            name: "Zone 32".into(),
            base_epsg: 4258,
            unit_m: 1.0,
            projection: Projection::TransverseMercator,
            origin_deg: [9.0, 0.0],
            scale: 0.9996,
            of_origin: [500_000.0, 0.0],
        };
        let california = Described {
            name: "California zone 3".into(),
            base_epsg: 4269,
            unit_m: 1200.0 / 3937.0,
            projection: Projection::Conic { parallels_deg: Some([37.0 + 4.0 / 60.0, 38.0 + 26.0 / 60.0]) },
            origin_deg: [-120.5, 36.5],
            scale: 1.0,
            of_origin: [2e6 / 1200.0 * 3937.0, 5e5 / 1200.0 * 3937.0],
        };
        let jamaica = Described {
            name: "Jamaica".into(),
            base_epsg: 4758,
            unit_m: 1.0,
            projection: Projection::Conic { parallels_deg: None },
            origin_deg: [-77.0, 18.0],
            scale: 1.0,
            of_origin: [750_000.0, 650_000.0],
        };
        for (described, code, at) in [
            (&transverse, "EPSG:25832", [691_000.0, 5_334_000.0]),
            (&california, "EPSG:2227", [6_048_000.0, 2_120_000.0]),
            (&jamaica, "EPSG:3448", [770_000.0, 655_000.0]),
        ] {
            let place =
                |definition: Definition| CoordinateSystem::about(definition, None, at).unwrap().geographic([at[0], at[1], 5.0]).unwrap();
            let (own, coded) = (place(described.definition().unwrap()), place(Definition::read(code).unwrap()));
            let [east, north, _] = crate::math::local_from_geographic(own, coded);
            assert!(east.hypot(north) < 1e-3, "{code}: {east} {north}");
            assert_eq!(described.definition().unwrap().name(), described.name);
        }
        assert!(transverse.definition().unwrap().has_plane_of(&Definition::read("EPSG:25832").unwrap()));
        // No geographic system; no unit.
        assert!(Described { base_epsg: 25832, ..transverse.clone() }.definition().is_none());
        assert!(Described { unit_m: 0.0, ..transverse }.definition().is_none());
    }
}
