//! The part of a geoid that a block needs, which a worker takes from its file.

use super::job::{Done, FileNeeded, StageName, Work};
use super::stage::{Request, Stage};
use super::state::State;
use super::system::{MOST_KM, middle_of_places};
use super::task::{GeoidTask, Task};
use crate::crs::Geoid;
use crate::error::refuse;
use crate::georeferenced::{Area, part_of_geoid};
use crate::math::turn;
use crate::{Error, Failure, Refusal, json};

/// The file of a geoid, of which a block needs a part.
#[derive(Default)]
pub(super) struct GeoidStage {
    next: usize,
}

impl Stage for GeoidStage {
    fn name(&self) -> StageName {
        StageName::Geoid
    }

    fn total(&self) -> usize {
        1
    }

    fn next(&mut self, _: &State) -> Option<Request> {
        let mut request = Request::following(&mut self.next, 1)?;
        request.files = vec![FileNeeded::Geoid(0)];
        Some(request)
    }

    fn prepare(&mut self, _: usize, _: &[String], state: &State) -> Result<Work, Error> {
        let name = state.input.geoid.clone().unwrap_or_default();
        let [images, control] = state.places();
        // Control points may be wrong.
        let Some(middle) = middle_of_places(&images).or_else(|| middle_of_places(&control)) else {
            return refuse(Refusal::GeoidWithoutPlace { name });
        };
        let task = Task::Geoid(GeoidTask { name, area: area_of(&[images, control].concat(), middle) });
        Ok(Work { key: None, task: Some(task), records: Vec::new(), input: None })
    }

    fn accept(&mut self, _: usize, bytes: Vec<u8>, state: &mut State) -> Result<Option<Done>, Error> {
        let part = std::str::from_utf8(&bytes).ok().and_then(|text| json::from_text::<Geoid>(text).ok());
        let Some(geoid) = part.filter(Geoid::is_whole) else { return Ok(None) };
        let name = geoid.name.clone();
        state.input.zero = state.given.zero(Some(&geoid));
        state.geoid = Some(geoid);
        Ok(Some(Done::of(name, None)))
    }

    fn fail(&mut self, _: usize, failure: Failure, _: &mut State) -> Result<Done, Error> {
        Err(failure.of_all())
    }
}

/// Of places, of which those far from their middle are wrong ones.
fn area_of(places: &[[f64; 2]], middle: [f64; 2]) -> Area {
    const KM_OF_DEGREE: f64 = 111.0;
    let along = libm::cos(middle[1].to_radians()).max(0.01);
    let most = [MOST_KM / KM_OF_DEGREE / along, MOST_KM / KM_OF_DEGREE];
    let from_middle = places.iter().map(|place| [turn(place[0] - middle[0]).abs(), (place[1] - middle[1]).abs()]);
    let near = from_middle.filter(|[east, north]| *east <= most[0] && *north <= most[1]);
    Area { middle, reach: near.fold([0.0; 2], |reach, apart| [reach[0].max(apart[0]), reach[1].max(apart[1])]) }
}

/// The part of the geoid of a file, as JSON.
pub(super) fn execute(task: &GeoidTask, file: &[u8]) -> Result<Vec<u8>, Error> {
    let part = part_of_geoid(&task.name, file, &task.area)?;
    Ok(serde_json::to_vec(&part).expect("plain data has a JSON form"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_far_from_all_others_asks_for_no_geoid() {
        let places = [[179.9, 60.0], [-179.9, 60.1], [180.0, 60.0], [10.0, 60.0], [180.0, -60.0]];
        let area = area_of(&places, [180.0, 60.0]);
        assert!((area.reach[0] - 0.1).abs() < 1e-9 && (area.reach[1] - 0.1).abs() < 1e-9, "{area:?}");
    }
}
