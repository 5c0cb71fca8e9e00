//! The model that is adjusted by what edits leave of a block.

use super::draft::{Draft, FoundBlock};
use super::edit::BlockEdit;
use crate::error::refuse;
use crate::model::{BlockDescription, ControlRole};
use crate::reconstruction::{Changed, ObservedPoint, PLACING, RayPart, brought, origin_of, readjust};
use crate::{
    Error, GeographicOrigin, GroundControlPoint, Input, PointSource, ReconstructedModel, ReconstructionOptions, Refusal, UnorientedImage,
    UnorientedReason,
};

/// A block after edits.
pub(crate) struct EditedBlock {
    pub model: ReconstructedModel,
    /// Images that are no longer in it.
    pub unoriented: Vec<UnorientedImage>,
    /// Where points that were added brought the block into their system: where (0, 0, 0) of that is, absent where it has no place on the earth.
    pub brought_to: Option<Option<GeographicOrigin>>,
}

/// The model of a block after edits, adjusted anew; and the images that are no longer in it.
///
/// # Errors
/// [`Error::InvalidInput`] for an edit of what does not exist, for places outside an image, and for a new point whose rays do not meet; the
/// errors of [`adjust_block`](crate::adjust_block) for a block that falls apart.
pub(crate) fn edited_model(found: &FoundBlock<'_>, edits: &[BlockEdit], options: &ReconstructionOptions) -> Result<EditedBlock, Error> {
    let FoundBlock { model, as_found, alone, .. } = *found;
    let surveyed = model.points.iter().filter_map(|point| if let PointSource::GroundControl(index) = point { Some(*index) } else { None });
    let given = as_found.control.len();
    if let Some(index) = surveyed.max().filter(|index| *index >= given) {
        return refuse(Refusal::Index { input: Input::SurveyedPointOfBlock, index, count: given });
    }
    let mut draft = Draft::new(found, options);
    for (number, edit) in (1..).zip(edits) {
        draft.apply(edit).map_err(|error| in_edit(error, number))?;
    }
    let rejected = draft.rejected_images.iter();
    let rejected: Vec<_> = rejected.map(|image| UnorientedImage { image: *image, reason: UnorientedReason::RejectedByHand }).collect();
    let (mut points, images, mut now) = draft.taken();
    let is_added = |point: &ObservedPoint| matches!(point.source, PointSource::GroundControl(control) if control >= given);
    let may_be_brought = !found.is_in_their_system && points.iter().any(&is_added) && places_block(&points, &images, &now);
    if may_be_brought {
        let changed = Changed { images: images.clone(), points: &points, description: &now };
        // Those whose image measurements contradict each other place nothing.
        let (model, lost) = brought(model, changed, options)?;
        if model.in_system && model.adjusted.datum.uses_control() {
            return Ok(EditedBlock { model, unoriented: [rejected, lost].concat(), brought_to: Some(origin_of(&now)?) });
        }
    }
    if !found.is_in_their_system {
        points.retain(|point| !is_added(point));
        now.control[given..].iter_mut().for_each(|waiting| waiting.measurements.clear());
    }
    let is_control = |point: &ObservedPoint| matches!(point.source, PointSource::GroundControl(control) if now.control[control].role == ControlRole::Control);
    if !points.iter().any(is_control) {
        now.images = alone.to_vec();
    }
    let changed = Changed { images, points: &points, description: &now };
    let (model, lost) = readjust(model, changed, &in_system_of(as_found, &now), options)?;
    Ok(EditedBlock { model, unoriented: [rejected, lost].concat(), brought_to: None })
}

/// Whether surveyed points suffice to bring the block into their system: so many that place it, each measured in two images or more.
fn places_block(points: &[ObservedPoint], images: &[usize], description: &BlockDescription) -> bool {
    let places = |point: &&ObservedPoint| matches!(point.source, PointSource::GroundControl(control) if description.control[control].role == ControlRole::Control);
    let taking = |point: &ObservedPoint| {
        point.rays.iter().filter(|ray| ray.part != RayPart::RejectedByHand && images.binary_search(&ray.image).is_ok()).count()
    };
    points.iter().filter(places).filter(|point| taking(point) >= 2).count() >= PLACING
}

/// The description by which the block was found, and in its system the points that were added: they say nothing of where that is.
fn in_system_of(as_found: &BlockDescription, now: &BlockDescription) -> BlockDescription {
    let added = now.control[as_found.control.len()..].iter().map(|point| GroundControlPoint { role: ControlRole::Check, ..point.clone() });
    BlockDescription { control: as_found.control.iter().cloned().chain(added).collect(), ..as_found.clone() }
}

/// Says which edit of the list, from 1, is refused.
pub(crate) fn in_edit(error: Error, number: usize) -> Error {
    match error {
        Error::InvalidInput { refusal } => Refusal::InEdit { edit: number, refusal: Box::new(refusal) }.into_error(),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reconstruction::ObservedRay;
    use crate::{
        BlockFlight, BlockOptions, Connection, Exposure, HandMeasurement, ImageObservation, MeasuredBy, ObservedPosition, PairOutcome,
        PairRule, PointImage, SelectOptions, geographic_from_local, reconstruct_block, simulate_block, tie_points,
    };
    use std::collections::BTreeSet;

    fn options() -> ReconstructionOptions {
        ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() }
    }

    /// A block with GNSS positions on the earth and control points of another system, the last of which is marked wrong, and its model.
    fn surveyed(control: usize) -> (BlockDescription, ReconstructedModel) {
        surveyed_of(control, 700)
    }

    /// The same with so many features an image.
    fn surveyed_of(control: usize, features: usize) -> (BlockDescription, ReconstructedModel) {
        let flight = BlockFlight { strips: 2, exposures: 4, features, ..BlockFlight::default() };
        let block = simulate_block(&flight).unwrap();
        let mut description = block.description(Some(1.0));
        for (image, exposure) in description.images.iter_mut().zip(&block.exposures) {
            let [longitude_deg, latitude_deg, height_m] = geographic_from_local(exposure.centre, [8.0, 50.0, 200.0]);
            image.position =
                Some(ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height_m), sigma_m: [1.0; 3] });
        }
        let seen = |place: &[f64; 3]| -> Vec<ImageObservation> {
            let at = |exposure: &Exposure| exposure.project(*place, block.width_px, block.height_px);
            let marks = block.exposures.iter().enumerate().filter_map(|(image, exposure)| Some((image, at(exposure)?)));
            marks.map(|(image, [x_px, y_px])| ImageObservation { image, x_px, y_px, confidence: 1.0 }).collect()
        };
        let shown: Vec<_> = block.ground.iter().map(|place| (*place, seen(place))).filter(|(_, seen)| seen.len() >= 4).collect();
        for k in 0..control {
            let (position, mut measurements) = shown[k * shown.len() / control].clone();
            if k == control - 1 {
                // No two of these marks show one place.
                measurements
                    .iter_mut()
                    .for_each(|mark| mark.y_px = (mark.y_px * 7919.0 + 613.0 * mark.image as f64) % f64::from(block.height_px));
            }
            let position = ObservedPosition::Local { position, sigma: [0.02; 3] };
            description.control.push(GroundControlPoint {
                name: format!("G{k}"),
                position,
                role: ControlRole::Control,
                sigma_px: None,
                measurements,
            });
        }
        let (points, _) = tie_points(&block.matches().unwrap(), &block.image_features(), &BlockOptions::default()).unwrap();
        let mut found = reconstruct_block(&description, &points, &block.image_features(), &options()).unwrap();
        (description, found.models.swap_remove(0))
    }

    fn edited(known: &(BlockDescription, ReconstructedModel), edits: &[BlockEdit]) -> ReconstructedModel {
        tried(known, &[], edits).unwrap()
    }

    /// `connections`: those of the block.
    fn tried(
        (description, model): &(BlockDescription, ReconstructedModel),
        connections: &[Connection],
        edits: &[BlockEdit],
    ) -> Result<ReconstructedModel, Error> {
        let found =
            FoundBlock { model, as_found: description, description, is_in_their_system: true, alone: &description.images, connections };
        edited_model(&found, edits, &options()).map(|edited| edited.model)
    }

    /// All pairs, of which one has too few matches.
    fn connections(images: u32, without: [u32; 2]) -> Vec<Connection> {
        let pairs = (0..images).flat_map(|a| (a + 1..images).map(move |b| [a, b]));
        let outcome = |images| match images == without {
            true => PairOutcome::TooFewMatches { matches: 3, needed: 15 },
            false => PairOutcome::Connected { matches: 50 },
        };
        pairs.map(|images| Connection { images, rule: PairRule::All, outcome: outcome(images) }).collect()
    }

    #[test]
    fn a_control_point_becomes_a_check_point_and_the_block_keeps_its_system() {
        let known = surveyed(5);
        assert!(known.1.in_system && known.1.surveyed.len() == 4, "{:?}", known.1.surveyed);
        let checked = edited(&known, &[BlockEdit::SetUse { point: 1, role: Some(ControlRole::Check) }]);
        let point = checked.surveyed.iter().find(|point| point.name == "G1").unwrap();
        assert_eq!((point.role, checked.in_system), (ControlRole::Check, true));
        let errors = point.standard_errors_m.map(Option::unwrap);
        assert!((0..3).all(|k| point.difference_m[k].abs() < 5.0 * errors[k]), "{point:?}");
        // The same as the block tells of the control point without itself.
        let told = known.1.surveyed.iter().find(|point| point.name == "G1").unwrap().left_out.unwrap();
        assert!((0..3).all(|k| (told.difference[k] - point.difference_m[k]).abs() < 0.3 * errors[k]), "{told:?} {point:?}");
        // Two points place nothing: the block floats, instead of being refused for another system.
        let off = |point| BlockEdit::SetUse { point, role: None };
        let floating = edited(&known, &[off(0), BlockEdit::SetUse { point: 1, role: Some(ControlRole::Check) }]);
        assert!(!floating.in_system && floating.surveyed.is_empty());
    }

    #[test]
    fn a_point_that_was_split_does_not_count_beside_its_parts() {
        let known = surveyed(5);
        let observed = known.1.observed_points();
        let point = observed.iter().find(|point| point.rays.len() >= 4 && matches!(point.source, PointSource::TiePoint(_))).unwrap();
        let hand =
            |ray: &ObservedRay| HandMeasurement { image: ray.image, x_px: ray.at_px[0], y_px: ray.at_px[1], by: MeasuredBy::LeastSquares };
        let added = |rays: &[ObservedRay]| BlockEdit::AddPoint { observations: rays.iter().map(hand).collect() };
        let points = vec![point.source];
        let split = vec![BlockEdit::RejectPoints { points: points.clone() }, added(&point.rays[..2]), added(&point.rays[2..])];
        let restored = BlockEdit::RestorePoints { points: points.clone() };
        let told = tried(&known, &[], &[split.clone(), vec![restored.clone()]].concat()).unwrap_err().to_string();
        assert!(told.starts_with("point to restore: got ") && told.contains("of which"), "{told}");
        // Without its parts it comes back, and as one that takes part it stays.
        let parts = [0, 1].map(PointSource::Manual).to_vec();
        let back = [split, vec![BlockEdit::RejectPoints { points: parts }, restored.clone()]].concat();
        assert_eq!(edited(&known, &back).points.len(), known.1.points.len());
        edited(&known, &[added(&point.rays[..2]), restored]);
    }

    #[test]
    fn three_control_points_tell_nothing_of_one_without_itself() {
        let known = surveyed(4);
        assert_eq!(known.1.surveyed.len(), 3, "{:?}", known.1.surveyed);
        assert!(known.1.surveyed.iter().all(|point| point.left_out.is_none()), "{:?}", known.1.surveyed);
    }

    #[test]
    fn a_surveyed_point_that_fell_out_keeps_the_marks_that_were_given() {
        // With marks that contradict each other the adjustment takes many steps: few features do.
        let known = surveyed_of(5, 200);
        let (point, given) = (PointSource::GroundControl(4), known.0.control[4].measurements.clone());
        assert!(known.1.points.iter().all(|other| *other != point));
        let first = given[0];
        let moved = BlockEdit::Measure { point, image: first.image, x_px: first.x_px, y_px: 0.5, by: MeasuredBy::Hand };
        let model = edited(&known, &[moved]);
        let place = model.points.iter().position(|other| *other == point).unwrap();
        let rays = model.adjusted.block.rays.iter().filter(|ray| ray.point == place).count();
        assert_eq!(rays, given.len());
    }

    #[test]
    fn a_point_that_was_added_falls_out_with_its_second_observation_and_comes_back() {
        let known = surveyed(5);
        let tie = known.1.observed_points().into_iter().find(|point| point.is_given && point.rays.len() >= 4).unwrap();
        let observations: Vec<HandMeasurement> = tie.rays[..2]
            .iter()
            .map(|ray| HandMeasurement { image: ray.image, x_px: ray.at_px[0], y_px: ray.at_px[1], by: MeasuredBy::LeastSquares })
            .collect();
        let point = PointSource::Manual(0);
        let one = vec![PointImage { point, image: observations[0].image }];
        let add = BlockEdit::AddPoint { observations };
        let has = |edits: &[BlockEdit]| edited(&known, edits).points.contains(&point);
        assert!(has(std::slice::from_ref(&add)));
        let reject = BlockEdit::RejectObservations { observations: one.clone() };
        assert!(!has(&[add.clone(), reject.clone()]));
        assert!(has(&[add.clone(), reject, BlockEdit::RestoreObservations { observations: one }]));
        let measure = BlockEdit::Measure {
            point,
            image: tie.rays[2].image,
            x_px: tie.rays[2].at_px[0],
            y_px: tie.rays[2].at_px[1],
            by: MeasuredBy::Hand,
        };
        let rejected = [add, BlockEdit::RejectPoints { points: vec![point] }, measure];
        let refused = tried(&known, &[], &rejected).unwrap_err().to_string();
        assert!(
            refused.contains("point by hand 2")
                && refused.contains("001, which takes no part; allowed: points that take part: restore it first (edit 3)"),
            "{refused}"
        );
    }

    #[test]
    fn what_only_a_rejected_pair_shows_takes_no_part_until_the_pair_is_restored() {
        let known = surveyed(5);
        let connections = connections(known.1.images.len() as u32, [0, 7]);
        let after = |edits: &[BlockEdit]| tried(&known, &connections, edits).unwrap();
        let shown_alone = |model: &ReconstructedModel| {
            let ties = model.observed_points().into_iter().filter(|point| matches!(point.source, PointSource::TiePoint(_)));
            let taking = |point: ObservedPoint| point.rays.into_iter().filter(|ray| ray.part == RayPart::Takes).map(|ray| ray.image);
            let images = ties.map(|point| taking(point).collect::<BTreeSet<usize>>().into_iter().collect::<Vec<usize>>());
            images.filter_map(|images| <[usize; 2]>::try_from(images).ok()).collect::<Vec<[usize; 2]>>()
        };
        let [a, b] = *shown_alone(&known.1).iter().find(|pair| **pair != [0, 7]).expect("a point that two images alone show");
        let reject = |pairs: &[[usize; 2]]| BlockEdit::RejectPairs { pairs: pairs.to_vec() };
        let restore = |pairs: &[[usize; 2]]| BlockEdit::RestorePairs { pairs: pairs.to_vec() };
        let without = after(&[reject(&[[b, a]])]);
        assert!(!shown_alone(&without).contains(&[a, b]));
        assert_eq!((without.images.len(), without.surveyed.len()), (known.1.images.len(), known.1.surveyed.len()));
        // The last edit of a pair counts, beside other edits in any order; what is restored is as it was.
        let other = if [a, b] == [1, 2] { [2, 3] } else { [1, 2] };
        let untouched = after(&[restore(&[[a, b]])]);
        assert_eq!(after(&[reject(&[[a, b], other]), restore(&[other, [b, a]])]), untouched);
        assert_eq!(after(&[restore(&[other]), reject(&[[a, b]])]), without);
        let image = BlockEdit::RejectImages { images: vec![7] };
        assert_eq!(after(&[image.clone(), reject(&[other])]), after(&[reject(&[other]), image]));
    }

    #[test]
    fn pairs_that_no_matches_connect_are_refused() {
        let known = surveyed(5);
        let connections = connections(known.1.images.len() as u32, [0, 7]);
        let refused = |edit: BlockEdit| tried(&known, &connections, &[edit]).unwrap_err().to_string();
        let pair = |pair| BlockEdit::RejectPairs { pairs: vec![pair] };
        let names = [7, 0].map(|image: usize| known.0.images[image].name.clone());
        let told = format!("got {} and {}, which no matches connect; allowed: connected pairs of the block (edit 1)", names[0], names[1]);
        assert!(refused(pair([7, 0])).contains(&told), "{}", refused(pair([7, 0])));
        assert!(refused(BlockEdit::RestorePairs { pairs: vec![[0, 7]] }).contains("which no matches connect"));
        assert!(refused(pair([3, 3])).contains("pair of images: got [3, 3]; allowed: two different images of 8"));
        assert!(refused(pair([0, 99])).contains("index 99"));
    }

    #[test]
    fn what_the_user_rejects_does_not_speak_against_the_block() {
        let known = surveyed(5);
        let observations: Vec<PointImage> = known
            .1
            .observed_points()
            .iter()
            .flat_map(|point| point.rays.iter().take(1).map(|ray| PointImage { point: point.source, image: ray.image }))
            .collect();
        let model = edited(&known, &[BlockEdit::RejectObservations { observations }]);
        let text = format!("{:?}", model.warnings);
        assert!(!text.contains("ManyRejected") && !text.contains("MeasurementsRejected"), "{text}");
    }
}
