//! From pairs to a block: which images are tried and connected, multi-ray points, and the choice among them.
//!
//! Data flow: [`ChosenPair`] → matches of a pair ([`BlockMatches`], [`ConnectionGraph`]) → `evidence` (how probable a match is by the
//! matches around it) → `joining` ([`TiePoints`]) → [`select_points`] → `refinement` of the rays of chosen points ([`PointRefiner`]).

mod chance;
mod choice;
mod connections;
mod evidence;
mod joining;
mod matches;
mod model;
mod options;
mod pairs;
mod places;
mod placing;
mod points;
mod refinement;
mod reliability;
mod selection;
mod sets;
mod settings;
mod shared;
mod two_groups;

pub use choice::{ChosenPair, PairRule, alike_pairs, all_pairs, merge_pairs, near_pairs, sequence_pairs};
pub use connections::{Connection, ConnectionGraph, PairOutcome};
pub use joining::{JoinCounts, tie_points};
pub use matches::{BlockMatches, FeatureMatch};
pub use options::{BlockOptions, Conflicts, SelectOptions};
pub use places::ImageFeatures;
pub(crate) use places::{check as check_features, von_gruber_position};
pub use placing::GeoreferencingOptions;
pub use points::{FeatureObservation, TiePoints};
pub use refinement::{
    ObservationRefinement, ObservationWindow, ObservationWindows, PointRefiner, RefinedPoint, RefinementMethod, RefinementOptions,
    RefinementOutcome, WindowCentre, WindowedObservation, observation_windows,
};
pub use reliability::MatchReliability;
pub use selection::{SelectedPoints, select_points};
pub use settings::{BlockSettings, PairChoice, choose_pairs};
pub use shared::{SharedPoints, shared_points};
