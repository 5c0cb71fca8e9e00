//! Whether a block that an orthophoto places lies where its images record their GNSS positions: heights of the ground that are off as a whole, and another system of
//! the orthophoto, take the block with them, and nothing else shows it.

use super::options::PlacingOptions;
use super::recorded_height::{HeightApart, error_m};
use super::recorded_place::{Recorded, usual_m};
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use crate::math::median;
use crate::pipeline::is_place_of_orthophoto;
use crate::{BlockRun, BlockWarning, ControlRole, ReconstructedModel};

/// How far an image lies from its position in m: in plan, with what is usual, and above it, where that is not usual.
struct Apart {
    plan_m: f64,
    usual_m: f64,
    height: Option<HeightApart>,
}

/// What most images of a block that the orthophoto places say by their positions; `None` where they lie there, where they have none that are used, and where
/// surveyed points hold the block, which check the orthophoto better.
pub(super) fn beside_positions(run: &BlockRun, reference: &Orthophoto, options: &PlacingOptions) -> Option<BlockWarning> {
    let model = run.reconstruction.as_ref().ok()?.models.first()?;
    let is_surveyed = model.surveyed.iter().any(|point| point.role == ControlRole::Control && !is_place_of_orthophoto(&point.name));
    if !run.input.use_gnss || is_surveyed {
        return None;
    }
    let in_crs = run.input.settings.placing.crs.is_some();
    let of_image = |(k, image): (usize, &usize)| {
        let own = run.images.get(*image)?;
        let position = RecordedPosition::of(own.given.as_ref(), &own.exif)?;
        if in_crs { in_block(model, k, &position, reference, options) } else { on_map(model, k, &position, reference, options) }
    };
    told(&model.images.iter().enumerate().filter_map(of_image).collect::<Vec<_>>())
}

/// In the system of the orthophoto, which the block has no way into but by its places.
fn on_map(
    model: &ReconstructedModel,
    k: usize,
    position: &RecordedPosition,
    reference: &Orthophoto,
    options: &PlacingOptions,
) -> Option<Apart> {
    let recorded = Recorded::of(Some(position), reference, options)?;
    let (place, errors) = (model.adjusted.block.images.get(k)?.pose.position, model.adjusted.images.get(k)?.position_errors);
    let (plan_m, usual_m, _) = recorded.apart(place, errors)?;
    Some(Apart { plan_m, usual_m, height: recorded.height_apart(place, errors) })
}

/// In the block's own system, where positions are observations beside the places: those that took part lie there.
fn in_block(
    model: &ReconstructedModel,
    k: usize,
    position: &RecordedPosition,
    reference: &Orthophoto,
    options: &PlacingOptions,
) -> Option<Apart> {
    let statistics = model.adjusted.images.get(k)?;
    let (gnss, errors) = (statistics.gnss.as_ref()?, statistics.position_errors);
    let usual_m = usual_m(&position.position, errors);
    let [x, y, z] = if gnss.accepted { [0.0; 3] } else { gnss.residual };
    // Observed minus adjusted; 0 where no height was observed.
    let height = HeightApart::of(-z, error_m(position, reference, options, 1.0), errors.map_or(0.0, |errors| errors[2]));
    Some(Apart { plan_m: libm::hypot(x, y), usual_m, height })
}

fn told(images: &[Apart]) -> Option<BlockWarning> {
    let most = |number: usize| 2 * number > images.len();
    let middle = |of: &dyn Fn(&Apart) -> Option<f64>| median(&mut images.iter().filter_map(of).collect::<Vec<f64>>());
    if most(images.iter().filter(|apart| apart.plan_m > apart.usual_m).count()) {
        let (plan_m, usual_m) = (middle(&|apart| Some(apart.plan_m))?, middle(&|apart| Some(apart.usual_m))?);
        return Some(BlockWarning::OrthophotoApart { images: images.len(), plan_m, usual_m });
    }
    // Some above and some below are off by themselves.
    let is_above = |above: bool| images.iter().filter(|apart| apart.height.is_some_and(|height| (height.height_m > 0.0) == above)).count();
    if !most(is_above(true).max(is_above(false))) {
        return None;
    }
    let (height_m, usual_m) = (middle(&|apart| Some(apart.height?.height_m))?, middle(&|apart| Some(apart.height?.usual_m))?);
    Some(BlockWarning::OrthophotoHeightsApart { images: images.len(), height_m, usual_m })
}

impl BlockRun {
    /// With what its positions say against the orthophoto that places it.
    pub(super) fn judged_beside_positions(mut self, reference: &Orthophoto, options: &PlacingOptions) -> Self {
        let warning = beside_positions(&self, reference, options);
        if let Some(model) = self.reconstruction.as_mut().ok().and_then(|assembly| assembly.models.first_mut()) {
            model.warnings.extend(warning);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUGH: f64 = 50.0;

    #[test]
    fn most_images_speak_for_a_block_and_those_apart_to_both_sides_for_themselves() {
        let of = |plan_m: f64, height_m: f64| Apart { plan_m, usual_m: 30.0, height: HeightApart::of(height_m, 0.1, 0.1) };
        assert_eq!(told(&[of(3.0, 0.2), of(200.0, 0.0), of(9.0, 0.3)]), None);
        let plan = told(&[of(100.0, 9.0), of(104.0, 9.0), of(9.0, 0.3)]);
        assert_eq!(plan, Some(BlockWarning::OrthophotoApart { images: 3, plan_m: 100.0, usual_m: 30.0 }));
        let Some(BlockWarning::OrthophotoHeightsApart { images: 3, height_m: 5.0, usual_m }) =
            told(&[of(3.0, 5.0), of(2.0, 5.0), of(9.0, 0.3)])
        else {
            panic!("not told")
        };
        assert!((usual_m - 3.0 * libm::hypot(0.1, 0.1)).abs() < 1e-12, "{usual_m}");
        assert_eq!(told(&[of(3.0, 5.0), of(2.0, -5.0), of(9.0, 5.0), of(9.0, -5.0)]), None);
        assert_eq!(told(&[]), None);
        // A difference that heights without a standard error may have.
        assert!(HeightApart::of(140.0, ROUGH, 0.1).is_none() && HeightApart::of(160.0, ROUGH, 0.1).is_some());
    }
}
