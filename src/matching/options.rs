//! What the user chooses of the matching.

use crate::Measure;
use crate::catalogue::{choices, options};

choices! {
    /// How the right point of a left one is found.
    pub enum Strategy {
        /// By gradients, with least squares matching of all matches that it confirms: for photos of which nothing is known.
        Auto = "auto" ("automatic"),
        /// The right interest point of the least dissimilarity of normalised moments (DM, eq. 16).
        Moments = "moments" ("moments (DM)"),
        /// The same with the seven invariants (DI, eq. 15).
        Invariants = "invariants" ("invariants (DI)"),
        /// The place of the highest normalised cross-correlation in the search window, to a fraction of a pixel.
        Correlation = "correlation",
        /// Least squares matching from coarse to fine.
        LeastSquares = "least-squares" ("least squares"),
        /// The right interest point of the nearest gradient descriptor, wherever it lies; what fits no geometry of the two views is rejected.
        Gradient = "gradient" ("gradients"),
    }
}

impl Strategy {
    /// The moments by which the strategy compares interest points; absent where it compares something else.
    pub fn measure(self) -> Option<Measure> {
        match self {
            Self::Moments => Some(Measure::Dm),
            Self::Invariants => Some(Measure::Di),
            Self::Auto | Self::Correlation | Self::LeastSquares | Self::Gradient => None,
        }
    }

    /// What is done where a strategy is to be chosen: all that works with points works so.
    pub fn resolved(self) -> Self {
        if self == Self::Auto { Self::Gradient } else { self }
    }

    /// Whether the strategy looks for the right point near an expected place.
    pub fn needs_offset(self) -> bool {
        self.resolved() != Self::Gradient
    }

    /// The share of the second best measure that the best may have, where none is chosen: the paper's, and Lowe's.
    pub const fn default_ambiguity(self) -> f64 {
        match self {
            Self::Auto | Self::Gradient => 0.8,
            _ => 0.9,
        }
    }
}

choices! {
    /// What is done to the matches of any strategy.
    pub enum Refinement {
        None = "none",
        /// Each right position is moved to where least squares matching finds it; a match that it does not confirm is rejected.
        LeastSquares = "least-squares" ("least squares"),
        /// The same, but a match that it does not confirm stays where it is, and counts as its residuals deserve.
        WherePossible = "where-possible" ("least squares where possible"),
    }
}

choices! {
    /// What the difference of two moments is divided by.
    pub enum Denominator {
        /// The larger magnitude of the two.
        Maxabs = "maxabs" ("larger magnitude"),
        /// The larger magnitude of the two, and at least the median magnitude of that moment over all points of both images.
        Floor = "floor" ("larger magnitude, with floor"),
    }
}

options! {
    /// Options of the matching.
    pub struct MatchOptions in "matching" {
        section "Matching";

        /// Moments and invariants compare interest points of both images, invariants also where these are rotated; correlation and least
        /// squares compare grey values; gradient matches photos of any rotation, scale and obliquity and needs no offset; auto does so and
        /// refines the matches.
        strategy: Strategy = Strategy::Auto, "Strategy";

        /// Least squares matching moves each right position to a hundredth of a pixel; what does not fit is rejected, or stays where it is.
        refine: Option<Refinement> = None, "Refinement", absent "where-possible for auto, none otherwise",
            acts "matching.strategy is not least-squares";

        /// Points without a match are matched by least squares from where the matches around them predict them, if they lie near their
        /// epipolar lines. Matches that it does not confirm are rejected where confirmed ones around them lead elsewhere.
        fill_in: bool = true, "Fill in", acts "matching.strategy is auto, gradient and matching.refine is least-squares, where-possible";

        /// Once the pair is oriented, it is matched again near the epipolar lines, until nothing changes; this needs a camera. Gradient always
        /// does so once, with a camera or without.
        epipolar: bool = false, "Along epipolar lines", acts "matching.strategy is not gradient";

        /// What a difference is divided by: the larger magnitude, or at least the median magnitude over all points, which keeps small moments
        /// from dominating.
        denominator: Denominator = Denominator::Maxabs, "Denominator", acts "matching.strategy is moments, invariants";

        /// The side of the window around the expected position in which right points are candidates (paper: 25): a larger one admits larger
        /// parallaxes and more wrong matches.
        search: usize = 25, "Search window", in "px", odd 1..=1023, acts "matching.strategy is not gradient";

        /// The best candidate is rejected unless its measure is below this (paper: 3): higher keeps more, less certain matches.
        max_measure: f64 = 3.0, "Maximum measure", 0..=14, acts "matching.strategy is moments, invariants, gradient";

        /// A match is rejected as ambiguous where the best measure exceeds this share of the second best: higher keeps more, less certain
        /// matches; 1 switches the rule off.
        ambiguity: Option<f64> = None, "Ambiguity ratio", 0..=1, absent "0.8 for gradients, 0.9 otherwise",
            acts "matching.strategy is not least-squares";

        /// The nearest matches that give the expected y-parallax: more follow its changes less closely; 0 switches the rule off.
        parallax_neighbours: usize = 12, "Parallax neighbours", 0..=100, acts "matching.strategy is not gradient";

        /// A y-parallax that deviates from the neighbours' median by more than this, and by more than 3 times their scatter, is rejected:
        /// higher keeps more matches.
        parallax_tolerance: f64 = 1.0, "Parallax tolerance", in "px", 0..=1000,
            acts "matching.strategy is not gradient and matching.parallax_neighbours is not 0";

        /// The side of the window whose grey values correlation and least squares matching compare: larger ones are more distinct and
        /// tolerate less relief.
        template: usize = 13, "Correlation window", in "px", odd 5..=63,
            acts "matching.strategy is correlation, least-squares or matching.refine is least-squares, where-possible";

        /// A match by grey values with a lower correlation coefficient is rejected: higher keeps fewer, more certain matches.
        min_correlation: f64 = 0.7, "Minimum correlation", -1..=1,
            acts "matching.strategy is correlation, least-squares or matching.refine is least-squares, where-possible";

        /// Correlation: the window that is found must correlate best with the left point it came from. Gradient: the descriptor that is found
        /// must be nearest to that of the left point.
        left_right: bool = true, "Left-right check", acts "matching.strategy is correlation, gradient";

        /// A least squares match whose right position has a larger standard error is rejected, as on an edge along which it can slide: higher
        /// keeps more, less precise matches.
        max_standard_error: f64 = 0.2, "Maximum standard error", in "px", 0.001..=10,
            acts "matching.strategy is least-squares or matching.refine is least-squares, where-possible";

        /// Ignores what lies at the same place of both frames and matches by itself, as film borders, fiducial marks and data strips.
        without_frame: bool = true, "Frame ignored", acts "matching.strategy is gradient", named "keep-frame";
    }
}

impl MatchOptions {
    /// Whether the second best is too nearly as good as the best. Two that are exactly as good, as in a repeated pattern, are ambiguous by
    /// any ratio but 1, which switches the rule off.
    pub(super) fn is_ambiguous(&self, best: f64, second: f64) -> bool {
        let ambiguity = self.ambiguity();
        ambiguity < 1.0 && second.is_finite() && best >= ambiguity * second
    }

    /// What is done to the matches: as chosen, or what belongs to the strategy.
    pub fn refine(&self) -> Refinement {
        let own = if self.strategy == Strategy::Auto { Refinement::WherePossible } else { Refinement::None };
        self.refine.unwrap_or(own)
    }

    /// Whether points without a match are filled in.
    pub fn fills_in(&self) -> bool {
        self.fill_in && self.refine() != Refinement::None
    }

    /// The share of the second best measure that the best may have: as chosen, or the strategy's own.
    pub fn ambiguity(&self) -> f64 {
        self.ambiguity.unwrap_or(self.strategy.default_ambiguity())
    }
}
