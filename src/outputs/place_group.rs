//! Groups of observations by their names: control points may be places of an orthophoto.

use crate::message::messages;
use crate::pipeline::is_place_of_orthophoto;
use crate::{ControlKind, ControlRole, ObservationGroup, SurveyedPoint};
use serde::Serialize;

messages! {
    /// Control points whose standard errors are stated together, some or all of which are places of an orthophoto.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "snake_case")]
    pub enum PlaceGroup as "place_group" {
        /// X and Y of places of an orthophoto.
        PlacesPlan,
        /// Z of these.
        PlacesHeight,
        /// X and Y of control points and places of an orthophoto.
        ControlAndPlacesPlan,
        /// Z of these.
        ControlAndPlacesHeight,
    }
}

impl PlaceGroup {
    /// Of a model with these points; absent for groups and models without places of an orthophoto.
    pub(crate) fn of(group: ObservationGroup, points: &[SurveyedPoint]) -> Option<Self> {
        let control = points.iter().filter(|point| point.role == ControlRole::Control).map(|point| point.name.as_str());
        match (ControlKind::of(control, is_place_of_orthophoto), group) {
            (ControlKind::Places, ObservationGroup::ControlPlan) => Some(Self::PlacesPlan),
            (ControlKind::Places, ObservationGroup::ControlHeight) => Some(Self::PlacesHeight),
            (ControlKind::Both, ObservationGroup::ControlPlan) => Some(Self::ControlAndPlacesPlan),
            (ControlKind::Both, ObservationGroup::ControlHeight) => Some(Self::ControlAndPlacesHeight),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_an_orthophoto_are_not_named_control_points() {
        let point = |name: &str, role: ControlRole| SurveyedPoint {
            name: name.into(),
            role,
            rays: 3,
            position: [0.0; 3],
            difference_m: [0.0; 3],
            standard_errors_m: [None; 3],
            left_out: None,
            detectable_m: [None; 3],
            refused: None,
        };
        let named = |points: &[SurveyedPoint]| {
            let groups = [ObservationGroup::ControlPlan, ObservationGroup::ControlHeight, ObservationGroup::GnssPlan];
            groups.map(|group| PlaceGroup::of(group, points).map(|group| group.to_string()))
        };
        let [place, own] = ["orthophoto_1", "A"].map(|name| point(name, ControlRole::Control));
        let some = |text: &str| Some(text.to_string());
        let places = [some("places of the orthophoto, horizontal"), some("places of the orthophoto, vertical"), None];
        assert_eq!(named(std::slice::from_ref(&place)), places);
        // A check point holds nothing.
        assert_eq!(named(&[point("A", ControlRole::Check), place.clone()]), places);
        assert_eq!(named(&[own.clone(), place])[1], some("control points and places of the orthophoto, vertical"));
        assert_eq!(named(&[own, point("orthophoto_2", ControlRole::Check)]), [None, None, None]);
    }
}
