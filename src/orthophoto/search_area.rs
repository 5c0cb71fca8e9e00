//! The features of an orthophoto among which images are sought.

use super::options::PlacingOptions;
use super::reference::Orthophoto;
use crate::error::refuse;
use crate::{Error, Feature, FeatureOptions, MultiscaleOptions, Refusal};

/// Longest side of the pictures in which a first place is sought, in px.
pub(super) const SEARCHED_PX: usize = 4000;
/// Sides of the part of the orthophoto that is searched, at least.
const LEAST_SEARCHED_PX: f64 = 64.0;
/// The orthophoto has so many times the points of an image.
const POINTS_OF_GROUND: usize = 4;

/// The features of an orthophoto among which images are sought: of all of it, or of what lies near a place.
#[derive(Debug, Clone)]
pub struct SearchArea {
    pub(super) features: Vec<Feature>,
    pub(super) area_px2: f64,
    /// Whether a smaller part of the orthophoto would have more of them: from a finer picture, or as many on less ground.
    pub(super) is_sparse: bool,
}

impl SearchArea {
    /// Finds them; they serve all images that are placed with the same options.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::InvalidInput`] for a place beside the orthophoto, or without one of its coordinates.
    pub fn new(reference: &Orthophoto, options: &PlacingOptions) -> Result<Self, Error> {
        options.check_ranges()?;
        let size = reference.size();
        if reference.heights_share() == 0.0 {
            return refuse(Refusal::NoHeightsThere);
        }
        let (first, size) = match (options.near_x, options.near_y) {
            (None, None) => ([0, 0], size),
            (Some(x), Some(y)) => near(reference, [x, y], options.within_m)?,
            _ => return refuse(Refusal::OneCoordinate),
        };
        let mut down = 0;
        while size[0].max(size[1]) >> down > SEARCHED_PX {
            down += 1;
        }
        let most = POINTS_OF_GROUND * options.points;
        let features = reference.features(first, size, down, &of_number(most))?;
        let is_sparse = down > 0 || features.len() >= most;
        Ok(Self { features, area_px2: size[0] as f64 * size[1] as f64, is_sparse })
    }

    /// Those within a distance of a place, both in the unit of the orthophoto; absent where they are all.
    pub(super) fn within(&self, reference: &Orthophoto, place: [f64; 2], within: f64) -> Option<Self> {
        let reach = within / reference.georeference.gsd();
        let at = reference.georeference.pixel(place);
        let is_near = |feature: &&Feature| (feature.point.x - at[0]).abs() <= reach && (feature.point.y - at[1]).abs() <= reach;
        let features: Vec<Feature> = self.features.iter().filter(is_near).cloned().collect();
        let size = reference.size().map(|side| side as f64);
        let side = |k: usize| ((at[k] + reach).min(size[k]) - (at[k] - reach).max(0.0)).max(0.0);
        let area_px2 = (side(0) * side(1)).min(self.area_px2);
        (features.len() < self.features.len()).then_some(Self { features, area_px2, is_sparse: self.is_sparse })
    }

    /// How many there are.
    pub fn points(&self) -> usize {
        self.features.len()
    }
}

/// The part of an orthophoto within a distance of a place.
fn near(reference: &Orthophoto, place: [f64; 2], within: f64) -> Result<([usize; 2], [usize; 2]), Error> {
    let at = reference.georeference.pixel(place);
    let reach = within / reference.georeference.gsd();
    let size = reference.size().map(|side| side as f64);
    let low = [0, 1].map(|k| (at[k] - reach).max(0.0));
    let high = [0, 1].map(|k| (at[k] + reach).min(size[k]));
    if !(0..2).all(|k| high[k] > low[k]) {
        let corners = [[0.0, 0.0], size].map(|corner| reference.georeference.ground(corner));
        let [first, last] = corners.map(|corner| format!("{corner:?}"));
        return refuse(Refusal::NearPlace { place: format!("{place:?}"), within_m: within, first, last });
    }
    if !(0..2).all(|k| high[k] - low[k] >= LEAST_SEARCHED_PX) {
        return refuse(Refusal::NearRadius { within_m: within, least_px: LEAST_SEARCHED_PX });
    }
    Ok((low.map(|v| v as usize), [0, 1].map(|k| (high[k] - low[k]) as usize)))
}

pub(super) fn of_number(number: usize) -> FeatureOptions {
    FeatureOptions { multiscale: MultiscaleOptions { number, ..MultiscaleOptions::default() }, ..FeatureOptions::default() }
}
