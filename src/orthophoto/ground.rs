//! The system of the ground that heights are given for.

use crate::crs::{CoordinateSystem, Definition};
use crate::georeferenced::{SaidSystem, name_of};

/// Two systems without a common code are one where coordinates of one place differ by less, in m: a shift of a datum that a text states may differ from
/// that of the registry by metres.
const SAME_M: f64 = 5.0;

/// What is known of it: heights of another system are none of this ground, and those in another unit are converted.
pub(super) struct Ground {
    definition: Option<Definition>,
    /// Also of a system that is unknown here.
    epsg: Option<u16>,
    pub name: Option<String>,
    /// The unit in which its heights count, in m.
    pub height_unit_m: Option<f64>,
    /// Longitude, latitude and height of a place of it, and its coordinates.
    place: Option<[[f64; 3]; 2]>,
}

impl Ground {
    /// Of an orthophoto, whose heights count in the unit of its plane.
    pub fn said(said: &SaidSystem) -> Self {
        let (definition, name, height_unit_m) = (said.definition(), said.name(), said.plane_unit_m());
        Self { definition, epsg: said.epsg, name, height_unit_m, place: None }
    }

    /// Of a system whose heights count in the unit that it has for them. `place`: longitude, latitude and height of a place of it, and its coordinates.
    pub fn of(definition: &Definition, place: Option<[[f64; 3]; 2]>) -> Self {
        let epsg = definition.plane_epsg();
        let name = Some(epsg.map_or_else(|| definition.name(), name_of));
        Self { definition: Some(definition.clone()), epsg, name, height_unit_m: Some(definition.height_unit_m()), place }
    }

    /// Of a block without a map: in m, unless the orthophoto on which it lies has another unit.
    pub fn of_plane(epsg: Option<u16>) -> Self {
        let said = Self::said(&SaidSystem { epsg, ..SaidSystem::default() });
        Self { height_unit_m: said.height_unit_m.or(Some(1.0)), ..said }
    }

    /// Whether a file says another system of the plane: another projection, or another datum. One that says nothing contradicts none.
    pub fn is_contradicted_by(&self, said: &SaidSystem) -> bool {
        match (said.definition(), &self.definition) {
            (Some(own), Some(ground)) if own.has_plane_of(ground) => false,
            (Some(own), Some(ground)) => match self.place {
                Some([place, known]) if ground.plane_epsg().is_none() || own.plane_epsg().is_none() => !is_there(own, place, known),
                _ => true,
            },
            // Codes that are not known here.
            _ => said.epsg.zip(self.epsg).is_some_and(|(own, ground)| own != ground),
        }
    }
}

/// Whether a system has a place at these coordinates.
fn is_there(definition: Definition, place: [f64; 3], known: [f64; 3]) -> bool {
    let system = CoordinateSystem::new(definition, None, [place[0], place[1]]).ok();
    let own = system.as_ref().and_then(|system| Some(system.difference_m(system.coordinates(place)?, known)));
    own.is_some_and(|[x, y, _]| libm::hypot(x, y) < SAME_M)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn systems_without_a_code_are_told_apart_by_where_they_have_the_block() {
        // DHDN, by its own text: the shift of EPSG operation 1777 in place of the one that holds here.
        const DHDN: &str = "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m";
        let contradicts = |crs: &str, epsg: u16| {
            let (definition, place) = (Definition::read(crs).unwrap(), [8.0, 50.0, 100.0]);
            let system = CoordinateSystem::new(definition.clone(), None, [place[0], place[1]]).unwrap();
            let ground = Ground::of(&definition, system.coordinates(place).map(|known| [place, known]));
            ground.is_contradicted_by(&SaidSystem { epsg: Some(epsg), ..SaidSystem::default() })
        };
        for (crs, own, others) in [
            ("+proj=utm +zone=32 +datum=WGS84", &[32_632, 25_832][..], &[25_833, 32_633, 31_467, 2154][..]),
            ("+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0", &[25_832], &[25_831, 31_467]),
            (DHDN, &[31_467], &[25_832, 31_468]),
            // Of two codes it is known that they are two.
            ("EPSG:25832", &[25_832], &[32_632, 25_833]),
        ] {
            for epsg in own {
                assert!(!contradicts(crs, *epsg), "{crs}: {epsg}");
            }
            for epsg in others {
                assert!(contradicts(crs, *epsg), "{crs}: {epsg}");
            }
        }
        assert!(!Ground::of_plane(None).is_contradicted_by(&SaidSystem { epsg: Some(25_832), ..SaidSystem::default() }));
    }
}
