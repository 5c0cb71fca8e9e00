//! What places of an orthophoto do in a block that is linked to it: counted whenever it is adjusted anew.

use super::OnOrthophoto;
use super::input::Checked;
use super::on_orthophoto::NotLinked;
use super::place_names::is_place_of_orthophoto;
use crate::reconstruction::PLACING;
use crate::{BlockDescription, ControlRole, ObservationVerdict, PointSource, ReconstructedModel};
use std::collections::BTreeSet;

/// The places that hold a model in the system of the orthophoto, that check it, and that its table has beside them. `epsg`: the code of the orthophoto's
/// system.
pub(super) fn linked_places(
    model: &ReconstructedModel,
    description: &BlockDescription,
    input: &Checked,
    epsg: Option<u16>,
) -> OnOrthophoto {
    let place = |point: &PointSource| match point {
        PointSource::GroundControl(control) => {
            description.control.get(*control).map(|known| known.name.as_str()).filter(|name| is_place_of_orthophoto(name))
        }
        PointSource::TiePoint(_) | PointSource::Manual(_) => None,
    };
    let block = &model.adjusted.block;
    let used: BTreeSet<&str> = block.control.iter().filter_map(|control| place(&model.points[control.point])).collect();
    if !model.in_system || used.is_empty() {
        return OnOrthophoto::NotLinked { not_linked: NotLinked::FewPoints { points: used.len(), needed: PLACING } };
    }
    let checks = model.surveyed.iter().filter(|point| point.role == ControlRole::Check && is_place_of_orthophoto(&point.name));
    let checks: BTreeSet<&str> = checks.map(|point| point.name.as_str()).collect();
    let takes_part = |name: &str| used.contains(name) || checks.contains(name);
    let rays = block.rays.iter().zip(&model.adjusted.rays).filter(|(_, ray)| ray.verdict == ObservationVerdict::Accepted);
    let seeing = rays.filter(|(ray, _)| place(&model.points[ray.point]).is_some_and(takes_part));
    let of_table = input.control.iter().flat_map(|tables| tables.names()).filter(|name| is_place_of_orthophoto(name));
    OnOrthophoto::Linked {
        linked: seeing.map(|(ray, _)| ray.image).collect::<BTreeSet<usize>>().len(),
        images: model.images.len(),
        points: used.len(),
        checks: checks.len(),
        rejected: of_table.filter(|name| !takes_part(name)).count(),
        in_crs: input.settings.placing.crs.is_some(),
        epsg,
    }
}
