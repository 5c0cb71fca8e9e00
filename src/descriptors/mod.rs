//! What describes a point: the moments of its window, or their invariants.

mod gradient;
mod kernel;
mod moments;
mod options;

pub use gradient::{Feature, FeatureOptions, GradientOptions, features, gradient_features};
pub use moments::{WindowMoments, window_moments};
pub use options::{Brightness, Measure, WindowOptions, WindowShape};

use kernel::Kernel;
use moments::invariants;

use crate::{Error, GreyView, InterestPoint};

/// Seven normalised central moments (µ'20 µ'11 µ'02 µ'30 µ'21 µ'12 µ'03) or seven invariants (I0..I6).
pub type Descriptor = [f64; 7];

/// Describes points by the moments of their windows: seven normalised central moments for [`Measure::Dm`], their seven invariants
/// for [`Measure::Di`].
///
/// `None` where the window leaves the image or is constant.
///
/// # Errors
/// [`Error::InvalidOption`], naming the field and its range.
pub fn describe(
    image: GreyView<'_>,
    points: &[InterestPoint],
    options: &WindowOptions,
    measure: Measure,
) -> Result<Vec<Option<Descriptor>>, Error> {
    options.check_ranges()?;
    let kernel = Kernel::new(options.side, options.shape);
    let descriptor = |point: &InterestPoint| {
        if !(point.x >= 0.0 && point.y >= 0.0) {
            return None;
        }
        let raw = kernel.raw_moments(image, point.x as usize, point.y as usize)?;
        let normalized = WindowMoments::from_raw(&raw, &kernel, options.brightness)?.normalized();
        Some(match measure {
            Measure::Dm => normalized,
            Measure::Di => invariants(&normalized),
        })
    };
    Ok(points.iter().map(descriptor).collect())
}
