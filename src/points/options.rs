//! What the user chooses of an interest operator.

use super::Selection;
use crate::catalogue::{check, choices, options, refuse};
use crate::{Allowed, Error};

choices! {
    /// The published interest operators, and points of many scales.
    pub enum Operator {
        /// The contrast to the neighbours, then the roundness of four gradients: the paper's choice.
        Ground2 = "ground2" ("Ground 2"),
        /// The contrast to the neighbours alone.
        Ground1 = "ground1" ("Ground 1"),
        /// The weight and roundness of the error ellipse of a corner.
        Forstner = "forstner" ("Förstner"),
        /// The least of four directional variations.
        Moravec = "moravec" ("Moravec"),
        /// Points distinct in position and scale: [`multiscale_points`](crate::multiscale_points), which has options of its own.
        Multiscale = "multiscale" ("many scales"),
    }
}

choices! {
    /// Which of equal neighbouring values survive the suppression of non-maxima.
    pub enum Ties {
        /// All of them.
        Keep = "keep" ("keep all"),
        /// The first in raster order.
        First = "first" ("keep the first"),
    }
}

options! {
    /// Options of [`detect`](crate::detect). All but the operator are of those that look at one scale.
    pub struct PointOptions in "points" {
        section "Points";

        /// The interest operator: ground 2 is the paper's choice, multiscale finds points of many sizes for images of different scales.
        operator: Option<Operator> = None, "Operator", absent "multiscale for gradients, ground2 otherwise";

        /// A higher threshold finds fewer points. Ground: grey difference (paper: 40). Förstner: factor of the mean weight (0.5 to 1.5).
        /// Moravec: sum of squared grey differences.
        threshold: Option<f64> = None, "Threshold", 0..=1e9,
            absent "the operator's own, lowered where it leaves less than 5 % of the pixels as candidates",
            acts "points.operator is not multiscale";

        /// The share of all pixels that become candidates, in place of a threshold (paper: 0.148): more give more points. It is independent of
        /// contrast.
        fraction: Option<f64> = None, "Fraction of candidates", 0.000001..=1, absent "the threshold decides",
            acts "points.operator is not multiscale";

        /// A higher minimum keeps fewer, rounder points: 1 is a corner or spot, 0 an edge (ground 2: 0.32 to 0.5, Förstner: 0.5 to 0.75).
        roundness: Option<f64> = None, "Minimum roundness q", 0..=1, absent "the operator's own",
            acts "points.operator is forstner, ground2";

        /// A larger window finds larger structures: Moravec 4 or 8, Förstner 5 or 7; the ground operators always use 3.
        operator_window: Option<usize> = None, "Operator window", in "px", 2..=31, absent "the operator's own",
            acts "points.operator is moravec, forstner";

        /// Moravec: windows side by side, as first published, in place of one at each pixel.
        tiled: bool = false, "Windows side by side", acts "points.operator is moravec";

        /// A point is suppressed where this window around it holds a greater value (paper: 3): larger windows leave fewer, better spread points;
        /// 1 suppresses none.
        suppression_window: usize = 3, "Suppression window", in "px", odd 1..=255, acts "points.operator is not multiscale", named "suppress";

        /// Whether all of several equal values in the suppression window survive, or the first in raster order.
        ties: Ties = Ties::Keep, "Equal values", acts "points.operator is not multiscale";
    }
}

impl Selection {
    /// Refuses values outside their ranges.
    pub(crate) fn check(self) -> Result<(), Error> {
        match self {
            Selection::Threshold(threshold) | Selection::Adaptive(threshold) => {
                check(PointOptions::PARAMETERS, "points.threshold", threshold)
            }
            Selection::Fraction(fraction) => check(PointOptions::PARAMETERS, "points.fraction", fraction),
        }
    }
}

impl PointOptions {
    /// The threshold or the fraction: as given, or the operator's default threshold, adapted to the image.
    pub(super) fn selection(&self) -> Result<Selection, Error> {
        match (self.threshold, self.fraction) {
            (Some(_), Some(fraction)) => {
                let [first, second] = ["points.threshold", "points.fraction"].map(String::from);
                Err(refuse("points.fraction", fraction, Allowed::OneOfTwo { first, second }))
            }
            (None, Some(fraction)) => Ok(Selection::Fraction(fraction)),
            (Some(threshold), None) => Ok(Selection::Threshold(threshold)),
            (None, None) => Ok(Selection::Adaptive(self.operator().default_threshold())),
        }
    }

    /// The operator; ground 2 where none is chosen.
    pub fn operator(&self) -> Operator {
        self.operator.unwrap_or(Operator::Ground2)
    }

    pub(super) fn roundness(&self) -> f64 {
        self.roundness.unwrap_or(self.operator().default_roundness())
    }

    pub(super) fn operator_window(&self) -> usize {
        self.operator_window.unwrap_or(self.operator().default_window())
    }

    /// The options with this operator where none is chosen, and the roundness and window of the operator where it has them.
    pub(crate) fn resolved(&self, usual: Operator) -> Self {
        let operator = self.operator.unwrap_or(usual);
        let chosen = Self { operator: Some(operator), ..self.clone() };
        let roundness = Some(chosen.roundness()).filter(|q| *q > 0.0);
        let operator_window = Some(chosen.operator_window()).filter(|side| *side > 0);
        Self { roundness, operator_window, ..chosen }
    }
}

impl Operator {
    /// The paper's threshold; for Moravec, where it has none, one that suits well exposed 8-bit aerial photographs; 0 where the operator has
    /// none.
    pub const fn default_threshold(self) -> f64 {
        match self {
            Operator::Multiscale => 0.0,
            Operator::Moravec => 4000.0,
            Operator::Forstner => 1.0,
            Operator::Ground1 | Operator::Ground2 => 40.0,
        }
    }

    /// The lower end of the paper's range; 0 where the operator has no roundness.
    pub const fn default_roundness(self) -> f64 {
        match self {
            Operator::Moravec | Operator::Ground1 | Operator::Multiscale => 0.0,
            Operator::Forstner => 0.5,
            Operator::Ground2 => 0.32,
        }
    }

    /// Side of the operator's window in px; 0 where it has none of one size.
    pub const fn default_window(self) -> usize {
        match self {
            Operator::Multiscale => 0,
            Operator::Moravec => 4,
            Operator::Forstner => 5,
            Operator::Ground1 | Operator::Ground2 => 3,
        }
    }
}
