//! Control and check points that were measured, or surveyed, under each other's names.

use super::mistake::{Doubted, Mistake};
use super::result::SurveyedPoint;
use super::warning::BlockWarning;

/// Names the point as which each refused one was measured. `limit`: of a test.
pub(super) fn name_exchanged(warnings: &mut [BlockWarning], surveyed: &[SurveyedPoint], limit: f64) {
    for warning in warnings {
        let (BlockWarning::ControlRefused { point, mistake, .. } | BlockWarning::CheckRefused { point, mistake, .. }) = warning else {
            continue;
        };
        let own = surveyed.iter().find(|surveyed| surveyed.name == *point);
        if let Some(other) = own.and_then(|own| fitting(own, surveyed, limit)) {
            *mistake = Some(Mistake::Name { other });
        }
    }
}

/// The one other point whose coordinates lie where the other observations have this one.
fn fitting(own: &SurveyedPoint, surveyed: &[SurveyedPoint], limit: f64) -> Option<String> {
    let left = own.without()?;
    let likely = [0, 1, 2].map(|k| own.position[k] + left.difference[k]);
    let within = left.standard_errors.map(|error| limit * error);
    let doubted = Doubted { given: own.position, likely, height_unit_m: 1.0, within };
    let mut others = surveyed.iter().filter(|other| other.name != own.name && doubted.is_of_another(other.position));
    let other = others.next()?;
    others.next().is_none().then(|| other.name.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, ControlRole, LeftOut};

    /// A point whose image measurements meet at `seen`, within 0.6 m.
    fn point(name: &str, position: [f64; 3], seen: [f64; 3]) -> SurveyedPoint {
        let difference = [0, 1, 2].map(|k| seen[k] - position[k]);
        SurveyedPoint {
            name: name.into(),
            role: ControlRole::Control,
            rays: 3,
            position,
            difference_m: difference,
            standard_errors_m: [Some(0.6); 3],
            left_out: Some(LeftOut { difference, standard_errors: [0.6; 3] }),
            detectable_m: [None; 3],
            refused: None,
        }
    }

    const PLACES: [[f64; 3]; 3] = [[400.0, 80.0, 12.0], [103.0, 160.0, 11.0], [90.0, 20.0, 9.0]];

    /// The point as which G6 was measured, where these image measurements of G6, G7 and G8 meet.
    fn of_g6(seen: [[f64; 3]; 3]) -> Option<Mistake> {
        let surveyed: Vec<SurveyedPoint> = (0..3).map(|k| point(["G6", "G7", "G8"][k], PLACES[k], seen[k])).collect();
        let mut warnings = [BlockWarning::ControlRefused {
            point: "G6".into(),
            axis: Axis::X,
            difference_m: -297.0,
            error_m: 0.6,
            detectable_m: None,
            used: false,
            certain: true,
            mistake: None,
        }];
        name_exchanged(&mut warnings, &surveyed, 3.3);
        let [BlockWarning::ControlRefused { mistake, .. }] = &warnings else { panic!("{warnings:?}") };
        mistake.clone()
    }

    #[test]
    fn points_that_were_measured_under_each_others_names_are_told() {
        let near = |[x, y, z]: [f64; 3]| [x + 0.4, y - 0.9, z + 1.1];
        assert_eq!(of_g6([near(PLACES[1]), near(PLACES[0]), PLACES[2]]), Some(Mistake::Name { other: "G7".into() }));
        // Of a coordinate that is wrong no other point is the reason, nor is one that differs in height alone.
        assert_eq!(of_g6([[410.0, 80.0, 12.0], PLACES[1], PLACES[2]]), None);
        assert_eq!(of_g6([[103.0, 160.0, 31.0], PLACES[1], PLACES[2]]), None);
    }

    #[test]
    fn a_check_point_that_was_measured_under_the_name_of_a_control_point_is_told() {
        let surveyed = [
            SurveyedPoint { role: ControlRole::Check, left_out: None, ..point("C1", PLACES[0], PLACES[1]) },
            point("G7", PLACES[1], PLACES[0]),
        ];
        let of = |point: &str| BlockWarning::CheckRefused {
            point: point.into(),
            axis: Axis::X,
            difference_m: -297.0,
            error_m: 0.6,
            mistake: None,
        };
        let mut warnings = [of("C1")];
        name_exchanged(&mut warnings, &surveyed, 3.3);
        let told = Some(Mistake::Name { other: "G7".into() });
        assert!(matches!(&warnings, [BlockWarning::CheckRefused { mistake, .. }] if *mistake == told), "{warnings:?}");
    }

    #[test]
    fn points_beside_each_other_are_not_told_apart_by_their_names() {
        let [x, y, z] = PLACES[0];
        let beside = [point("G6", PLACES[0], [x + 3.0, y, z]), point("G7", [x + 3.0, y, z], [x + 3.0, y, z])];
        assert_eq!(fitting(&beside[0], &beside, 3.3), None);
        // Two that fit leave open which is meant.
        let seen = [x + 90.0, y, z];
        let twice = [point("G6", PLACES[0], seen), point("G7", seen, seen), point("G8", seen, seen)];
        assert_eq!(fitting(&twice[0], &twice, 3.3), None);
    }
}
