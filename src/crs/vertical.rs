//! What the heights of a raster count from, by the code that its file names.

use super::definition::{Definition, HeightReference};
use proj_core::{VerticalCrsKind, lookup_vertical_epsg};

/// Codes of ellipsoids in the first GeoTIFF: heights above these.
const ELLIPSOIDS: std::ops::RangeInclusive<u16> = 5001..=5033;

/// A vertical system that a file names.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Vertical {
    pub name: String,
    /// Whether its heights are above the ellipsoid, as those of GNSS are; else they are above a geoid or a level of the sea.
    pub is_ellipsoidal: bool,
    /// The unit of its heights in m; absent where it has none of its own.
    pub unit_m: Option<f64>,
}

impl Vertical {
    /// By a code of EPSG: of a vertical system, of one with longitude, latitude and height, or of an ellipsoid. Absent for a code that is unknown here.
    ///
    /// # Source
    /// OGC 19-008r4, GeoTIFF standard 1.1, 7.5.5 (VerticalGeoKey); GeoTIFF 1.0, 6.3.4.1.
    pub fn of_code(code: u16) -> Option<Self> {
        if let Some(known) = lookup_vertical_epsg(u32::from(code)) {
            let is_ellipsoidal = matches!(known.kind(), VerticalCrsKind::EllipsoidalHeight { .. });
            return Some(Self { name: named(known.name(), code), is_ellipsoidal, unit_m: Some(known.linear_unit_to_meter()) });
        }
        if ELLIPSOIDS.contains(&code) {
            return Some(Self { name: format!("EPSG:{code}"), is_ellipsoidal: true, unit_m: None });
        }
        Definition::read(&format!("EPSG:{code}")).ok().as_ref().and_then(Self::of_system)
    }

    /// The heights of a system that has its own.
    pub fn of_system(definition: &Definition) -> Option<Self> {
        match definition.heights() {
            HeightReference::Unsaid => None,
            heights => Some(Self {
                name: definition.name(),
                is_ellipsoidal: heights == HeightReference::Ellipsoid,
                unit_m: Some(definition.height_unit_m()),
            }),
        }
    }
}

fn named(name: &str, code: u16) -> String {
    if name.is_empty() { format!("EPSG:{code}") } else { format!("{name} (EPSG:{code})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_of_heights_say_whether_they_count_from_the_ellipsoid() {
        for (code, name) in [(5773, "EGM96"), (3855, "EGM2008"), (5783, "DHHN92"), (7837, "DHHN2016"), (5703, "NAVD88"), (5555, "DHHN92")] {
            let found = Vertical::of_code(code).unwrap_or_else(|| panic!("{code}"));
            assert!(found.name.contains(name) && !found.is_ellipsoidal, "{code}: {found:?}");
        }
        for code in [4979, 4937, 5030, 5019] {
            assert!(Vertical::of_code(code).is_some_and(|found| found.is_ellipsoidal), "{code}: {:?}", Vertical::of_code(code));
        }
        // In metres, feet of the US survey and international ones.
        for (code, unit_m) in [(5703, 1.0), (6360, 1200.0 / 3937.0), (8228, 0.3048), (4979, 1.0)] {
            let found = Vertical::of_code(code).and_then(|found| found.unit_m).unwrap_or_else(|| panic!("{code}"));
            assert!((found - unit_m).abs() < 1e-12, "{code}: {found}");
        }
        // Systems of the plane, and a code that is none.
        assert_eq!([25_832, 4326, 9999].map(Vertical::of_code), [None, None, None]);
    }
}
