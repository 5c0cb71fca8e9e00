//! The way from an orthophoto into the coordinate reference system of a block.

use super::other_zero::{OtherZero, other_zero, zero_of};
use super::reference::Orthophoto;
use crate::crs::{CoordinateSystem, Definition, HeightZero, Vertical};
use crate::error::refuse;
use crate::georeferenced::{SaidSystem, name_of};
use crate::math::median;
use crate::pipeline::GroundPoint;
use crate::text::shorten;
use crate::{BlockRun, Error, ExifPosition, Failure, NotLinked, Refusal, Remark};

/// Parts of width and height of an orthophoto by which it is tried whether anything leads from it to another system: the middle first.
const TRIED: [[f64; 2]; 5] = [[0.5, 0.5], [0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]];

/// How places of an orthophoto come into the coordinate reference system of a block.
///
/// Images are placed on the orthophoto in m, whatever its unit is; heights count from where those of the block's system do.
#[derive(Debug)]
pub(super) struct IntoSystem {
    orthophoto: Definition,
    block: Definition,
    /// Whether the orthophoto says nothing of its system, and is taken to be in that of the block.
    is_assumed: bool,
    /// The unit of its eastings and northings in m.
    unit_m: f64,
    /// Where the heights of the block's system count from.
    zero: HeightZero,
}

/// Nothing leads from the system of an orthophoto to this one.
#[derive(Debug)]
pub(super) struct NoWay {
    pub orthophoto: Option<String>,
    pub crs: String,
    pub failure: Failure,
}

impl From<NoWay> for NotLinked {
    fn from(NoWay { orthophoto, crs, failure }: NoWay) -> Self {
        Self::OtherSystem { orthophoto, crs, failure }
    }
}

impl IntoSystem {
    /// Absent where the block has no coordinate reference system: it is taken into that of the orthophoto.
    ///
    /// # Errors
    /// [`NoWay`] where nothing leads from one to the other, in the middle of the orthophoto or towards its corners.
    pub fn of(run: &BlockRun, orthophoto: &Orthophoto) -> Result<Option<Self>, NoWay> {
        let zero = || run.input.zero(run.geoid.as_ref());
        run.input.settings.placing.crs.as_ref().map(|crs| Self::into(crs, zero(), orthophoto)).transpose()
    }

    /// Into this coordinate reference system of a block, whose heights count from `zero`.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn into(crs: &str, zero: HeightZero, orthophoto: &Orthophoto) -> Result<Self, NoWay> {
        let said = orthophoto.said();
        let no_way = |error: &Error| NoWay { orthophoto: said.name(), crs: shorten(crs), failure: Failure::from(error) };
        let into = Self::between(&said, crs, zero).map_err(|error| no_way(&error))?;
        // The block is somewhere on it: one of these places will do.
        let [width, height] = orthophoto.size().map(|side| side as f64);
        let tried = TRIED.map(|[x, y]| into.conversion(orthophoto.georeference.ground([x * width, y * height]).map(|v| into.unit_m * v)));
        let is_left_to_try = tried.iter().any(Result::is_ok);
        match tried.into_iter().find_map(Result::err).filter(|_| !is_left_to_try) {
            Some(error) => Err(no_way(&error)),
            None => Ok(into),
        }
    }

    fn between(said: &SaidSystem, crs: &str, zero: HeightZero) -> Result<Self, Error> {
        let block = Definition::read(crs)?;
        let is_assumed = said.epsg.is_none() && said.described.is_none();
        let orthophoto = match (said.epsg, &said.described) {
            (Some(code), _) => Definition::read(&name_of(code))?,
            (None, None) if !block.is_geographic() => block.clone(),
            (None, _) => match said.definition() {
                Some(described) => described,
                None => return refuse(Refusal::OrthophotoSystem { described: said.name() }),
            },
        };
        let unit_m = said.unit_m.or(orthophoto.unit_m()).unwrap_or(1.0);
        let zero = zero_of(&block, zero);
        Ok(Self { orthophoto, block, is_assumed, unit_m, zero })
    }

    /// The name of the coordinate reference system of the block.
    pub fn crs(&self) -> String {
        self.block.name()
    }

    /// The unit of the orthophoto in m.
    pub fn unit_m(&self) -> f64 {
        self.unit_m
    }

    /// The orthophoto in m.
    pub fn in_metres(&self, orthophoto: &Orthophoto) -> Orthophoto {
        orthophoto.in_metres(self.unit_m)
    }

    /// Places of the orthophoto in m as those of the block's system, and what is to be said of that.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for places that lie outside one of the systems.
    pub fn taken(&self, points: Vec<GroundPoint>, orthophoto: &Orthophoto) -> Result<(Vec<GroundPoint>, Vec<Remark>), Error> {
        let middle = |k: usize| median(&mut points.iter().map(|point| point.place[k]).collect::<Vec<_>>());
        let conversion = middle(0).zip(middle(1)).map(|(x, y)| self.conversion([x, y])).transpose()?.flatten();
        let points = points.into_iter().map(|point| {
            let place = self.place(point.place, conversion.as_ref())?;
            Ok(GroundPoint { place, ..point })
        });
        Ok((points.collect::<Result<Vec<GroundPoint>, Error>>()?, self.remarks(orthophoto, conversion.as_ref())))
    }

    /// The same of one place.
    ///
    /// # Errors
    /// As [`taken`](Self::taken).
    pub fn taken_place(&self, place: [f64; 3], orthophoto: &Orthophoto) -> Result<([f64; 3], Vec<Remark>), Error> {
        let conversion = self.conversion([place[0], place[1]])?;
        Ok((self.place(place, conversion.as_ref())?, self.remarks(orthophoto, conversion.as_ref())))
    }

    /// By WGS 84, about a place in m; absent where both have one plane.
    fn conversion(&self, middle: [f64; 2]) -> Result<Option<Conversion>, Error> {
        if self.orthophoto.has_plane_of(&self.block) {
            return Ok(None);
        }
        let [x, y] = middle.map(|v| v / self.orthophoto.unit_m().unwrap_or(1.0));
        let from = CoordinateSystem::about(self.orthophoto.clone(), None, [x, y])?;
        let [longitude, latitude, _] = on_earth(&from, [x, y, 0.0])?;
        let to = CoordinateSystem::new(self.block.clone(), None, [longitude, latitude])?;
        Ok(Some(Conversion { from, to }))
    }

    fn place(&self, [x, y, z]: [f64; 3], conversion: Option<&Conversion>) -> Result<[f64; 3], Error> {
        let unit_m = self.orthophoto.unit_m().unwrap_or(1.0);
        let (x, y) = (x / unit_m, y / unit_m);
        let Some(Conversion { from, to }) = conversion else { return Ok([x, y, z / self.block.height_unit_m()]) };
        let place = on_earth(from, [x, y, z / self.orthophoto.height_unit_m()])?;
        to.coordinates(place).ok_or_else(|| outside(to, [place[0], place[1]]))
    }

    fn remarks(&self, orthophoto: &Orthophoto, conversion: Option<&Conversion>) -> Vec<Remark> {
        let height_unit_m = orthophoto.heights.said_unit_m();
        let assumed = || Remark::OrthophotoSystemAssumed { crs: self.block.name() };
        let units = || Remark::OrthophotoUnits { unit_m: self.unit_m, height_unit_m };
        let converted = |Conversion { from, to }: &Conversion| Remark::OrthophotoConverted {
            orthophoto: self.orthophoto.name(),
            crs: self.block.name(),
            // What both shift alike is in no difference.
            accuracy_m: (from.operation() != to.operation())
                .then(|| libm::hypot(from.accuracy_m().unwrap_or(0.0), to.accuracy_m().unwrap_or(0.0)))
                .filter(|accuracy_m| *accuracy_m > 0.0),
        };
        let is_metric = self.unit_m == 1.0 && height_unit_m == 1.0;
        let heights = orthophoto.heights.vertical().and_then(|vertical| self.other_heights(vertical, orthophoto));
        let said = [self.is_assumed.then(assumed), conversion.map(converted), (!is_metric).then(units), heights];
        said.into_iter().flatten().collect()
    }

    /// What is to be said where heights of the ground count from elsewhere than those of the block: they are taken as they are.
    fn other_heights(&self, vertical: Vertical, orthophoto: &Orthophoto) -> Option<Remark> {
        let OtherZero { name, from_ellipsoid, above_m } = other_zero(vertical, &self.zero, || self.on_earth(orthophoto))?;
        Some(Remark::OrthophotoHeights { heights: name, from_ellipsoid, crs: self.block.name(), above_m })
    }

    /// The middle of the orthophoto.
    fn on_earth(&self, orthophoto: &Orthophoto) -> Option<[f64; 2]> {
        let factor = self.unit_m / self.orthophoto.unit_m().unwrap_or(1.0);
        let middle = orthophoto.size().map(|side| 0.5 * side as f64);
        let [x, y] = orthophoto.georeference.ground(middle).map(|v| factor * v);
        let [longitude, latitude, _] = CoordinateSystem::about(self.orthophoto.clone(), None, [x, y]).ok()?.geographic([x, y, 0.0])?;
        Some([longitude, latitude])
    }
}

/// A GNSS position on an orthophoto.
pub(super) struct RecordedPlace {
    pub place: [f64; 2],
    /// The unit of the orthophoto in m.
    pub unit_m: f64,
}

/// Where an orthophoto has the position of an image; absent where it does not say its system, and where the position lies outside that.
pub(super) fn recorded_place(position: &ExifPosition, orthophoto: &Orthophoto) -> Option<RecordedPlace> {
    let said = orthophoto.said();
    let definition = said.definition()?;
    let own_m = definition.unit_m()?;
    let unit_m = said.unit_m.unwrap_or(own_m);
    let ExifPosition { longitude_deg, latitude_deg, height_m, .. } = *position;
    let system = CoordinateSystem::new(definition, None, [longitude_deg, latitude_deg]).ok()?;
    let [x, y, _] = system.coordinates([longitude_deg, latitude_deg, height_m.unwrap_or(0.0)])?;
    Some(RecordedPlace { place: [x, y].map(|v| v * own_m / unit_m), unit_m })
}

/// The way from one system to another by WGS 84.
struct Conversion {
    from: CoordinateSystem,
    to: CoordinateSystem,
}

fn on_earth(system: &CoordinateSystem, position: [f64; 3]) -> Result<[f64; 3], Error> {
    system.geographic(position).ok_or_else(|| outside(system, [position[0], position[1]]))
}

fn outside(system: &CoordinateSystem, [x, y]: [f64; 2]) -> Error {
    Refusal::CrsPlace { x, y, crs: system.definition().name(), degrees: system.definition().is_geographic() }.into_error()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Georeference, GreyImage, Heights};

    #[test]
    fn heights_of_the_ground_from_another_zero_than_those_of_the_block_are_named() {
        let grey = GreyImage::from_fn(64, 64, |c, _| 100 + c as u8).unwrap();
        let georeference = Georeference::north_up([500_000.0, 5_500_000.0], 1.0);
        let orthophoto = Orthophoto::new(grey, georeference, Heights::Level(0.0)).unwrap();
        let said = SaidSystem { epsg: Some(25_832), ..SaidSystem::default() };
        let of = |crs: &str, zero: HeightZero, code: u16| {
            let into = IntoSystem::between(&said, crs, zero).unwrap();
            match into.other_heights(Vertical::of_code(code).unwrap(), &orthophoto) {
                Some(Remark::OrthophotoHeights { heights, from_ellipsoid, above_m, .. }) => Some((heights, from_ellipsoid, above_m)),
                None => None,
                other => panic!("{other:?}"),
            }
        };
        const UTM: &str = "EPSG:25832";
        let geoid = || HeightZero::Level(46.8);
        // Above the ellipsoid, where the block counts from a geoid; above the sea, where it counts from the ellipsoid.
        let (name, from_ellipsoid, above_m) = of(UTM, geoid(), 4979).unwrap();
        assert!(name.contains("WGS 84") && from_ellipsoid && above_m == Some(46.8), "{name} {above_m:?}");
        for (crs, zero) in [(UTM, HeightZero::Level(0.0)), ("EPSG:4937", HeightZero::Unknown)] {
            let (name, from_ellipsoid, above_m) = of(crs, zero, 7837).unwrap();
            assert!(name.contains("DHHN2016") && !from_ellipsoid && above_m.is_none(), "{crs}: {name} {above_m:?}");
        }
        // The same, and what is not known.
        let same =
            [(UTM, geoid(), 7837), (UTM, HeightZero::Level(0.0), 4979), (UTM, HeightZero::Unknown, 4979), (UTM, HeightZero::Unknown, 7837)];
        for (crs, zero, code) in same {
            assert_eq!(of(crs, zero, code), None, "{code}");
        }
        // The geoid lies below the ellipsoid, as in North America.
        assert_eq!(of(UTM, HeightZero::Level(-30.0), 4979).unwrap().2, Some(-30.0));
        for (above_m, expected) in [(46.83, "lies 46.8 m too high;"), (-30.04, "lies 30.0 m too low;")] {
            let remark = Remark::OrthophotoHeights { heights: "a".into(), from_ellipsoid: true, crs: "b".into(), above_m: Some(above_m) };
            assert!(remark.to_string().contains(expected), "{remark}");
        }
    }
}
