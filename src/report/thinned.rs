//! Which points the comparison of strategies takes of images that have very many.

use super::input::ReportImage;
use crate::{Error, Operator, PairSettings, PointOptions, PointSet, Ties, detect};

/// Most points of an image on which strategies are compared. Gradients compare each left point with each right one: of 90,000, as many as
/// the grain of film gives, that takes more than a minute.
pub(super) const MOST: usize = 20_000;

/// The widest window of the option.
const WIDEST_PX: usize = 255;

/// The points that a wider window of suppression leaves: those that stand out most, spread over the images.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Thinned {
    pub options: PointOptions,
    /// Left and right, by the window that was chosen.
    pub found: [usize; 2],
    /// By the wider one.
    pub taken: [usize; 2],
}

impl Thinned {
    /// The points of both images by the narrowest window tried that leaves `most` of each; `None` where there are no more anyway, or many
    /// scales have a number of their own.
    ///
    /// # Errors
    /// As [`detect`].
    pub fn of(images: [&ReportImage; 2], settings: &PairSettings, most: usize) -> Result<Option<Self>, Error> {
        if settings.points.operator() == Operator::Multiscale {
            return Ok(None);
        }
        let count = |options: &PointOptions| -> Result<[usize; 2], Error> {
            let points = |image: &ReportImage| -> Result<PointSet, Error> {
                let image = image.pair_image();
                detect(image.grey, image.mask, options, &settings.multiscale)
            };
            Ok([points(images[0])?.points.len(), points(images[1])?.points.len()])
        };
        let found = count(&settings.points)?;
        let mut taken = found;
        // Where an image is saturated, equal values would survive any window.
        let mut options = PointOptions { ties: Ties::First, ..settings.points.clone() };
        while taken[0].max(taken[1]) > most && options.suppression_window < WIDEST_PX {
            options.suppression_window = wider_px(options.suppression_window, taken[0].max(taken[1]) as f64 / most as f64);
            taken = count(&options)?;
        }
        Ok((taken != found).then_some(Self { options, found, taken }))
    }
}

/// An odd window in which as many points are one as there are too many for each.
fn wider_px(window_px: usize, times: f64) -> usize {
    let wanted = (window_px as f64 * times.sqrt()) as usize;
    (wanted | 1).clamp(window_px + 2, WIDEST_PX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Report;
    use crate::{Flight, GreyImage, PairInput, PhotoInput, Texts, simulate};

    /// Grains: points nearly everywhere.
    fn grainy(seed: u32) -> ReportImage {
        let mut random = crate::math::Random::new(seed);
        let grey = GreyImage::new(200, 180, (0..200 * 180).map(|_| random.below(256) as u8).collect()).unwrap();
        ReportImage { name: seed.to_string(), grey, exif: None, mask: None }
    }

    fn by_ground() -> PairSettings {
        PairSettings { points: PointOptions::default().resolved(Operator::Ground2), ..PairSettings::default() }
    }

    #[test]
    fn a_grainy_image_is_compared_on_the_points_that_stand_out() {
        let (left, right) = (grainy(1), grainy(2));
        let settings = by_ground();
        assert_eq!(Thinned::of([&left, &right], &settings, 100_000).unwrap(), None);
        let thinned = Thinned::of([&left, &right], &settings, 500).unwrap().unwrap();
        for (taken, found) in thinned.taken.into_iter().zip(thinned.found) {
            assert!(found > 1000 && (200..=500).contains(&taken), "{thinned:?}");
        }
        assert!(thinned.options.suppression_window > settings.points.suppression_window);
        let multiscale = PointOptions { operator: Some(Operator::Multiscale), ..PointOptions::default() };
        assert_eq!(Thinned::of([&left, &right], &PairSettings { points: multiscale, ..settings }, 500).unwrap(), None);
    }

    #[test]
    fn equal_values_everywhere_are_thinned_too() {
        let stripes: Vec<u8> = (0..120 * 120).map(|k| if (k % 120 / 2 + k / 240) % 2 == 0 { 0 } else { 255 }).collect();
        let image = ReportImage { name: "stripes".into(), grey: GreyImage::new(120, 120, stripes).unwrap(), exif: None, mask: None };
        let thinned = Thinned::of([&image, &image], &by_ground(), 100).unwrap().unwrap();
        assert!(thinned.found[0] > 100 && thinned.taken[0] <= 100, "{thinned:?}");
    }

    #[test]
    fn a_report_says_how_many_points_of_how_many_strategies_are_compared_on() {
        let sample = simulate(&Flight { width_px: 200, height_px: 220, ..Flight::default() }).unwrap();
        let image = |name: &str, grey: GreyImage| ReportImage { name: name.into(), grey, exif: None, mask: None };
        let photo = |fiducials, origin| PhotoInput { fiducials, origin: Some(origin), ..PhotoInput::default() };
        let input = PairInput {
            camera: Some(sample.camera),
            left: photo(sample.left_fiducials, sample.left_origin),
            right: photo(sample.right_fiducials, sample.right_origin),
            offset: None,
        };
        let images = [image("left", sample.left), image("right", sample.right)];
        let mut report = Report { most_compared: 300, ..Report::new(images, input, PairSettings::default(), None) };
        while report.step().unwrap() {}
        let thinned = report.thinned.clone().unwrap();
        let [left, right] = thinned.found;
        assert!(report.studies[1..].iter().all(|study| study.settings.points == thinned.options), "{thinned:?}");
        assert!(report.studies[1].result.left.points.len() == thinned.taken[0] && thinned.taken[0] <= 300 && left > 300);
        // What was asked for is as it was asked for.
        assert_eq!(report.studies[0].settings, PairSettings::default());
        let said = format!("{} of {left} left and {} of {right} right points", thinned.taken[0], thinned.taken[1]);
        let html = report.html(Texts::english()).unwrap().replace('\u{202f}', "");
        assert!(html.contains(&said), "{said}");
    }
}
