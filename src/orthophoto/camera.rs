//! The camera of an image that is to be placed, from what its file and the user say of it.

use super::adjusting::PlacingCamera;
use super::outcome::{PlacedImage, PlacingVerdict, PlacingWeakness};
use crate::pipeline::{CameraRules, contradicted_focal};
use crate::{BlockRun, CameraUncertainty, ExifImage, KnownCamera};

impl PlacingCamera {
    /// By the rules that the image's name fits, as in blocks: those with `fixed` are taken as calibrated. Else by its EXIF and XMP, else a usual
    /// focal length, each with its uncertainty.
    pub fn of(rules: &CameraRules, name: &str, size: [u32; 2], exif: &ExifImage) -> Self {
        let (_, known) = rules.camera_of(name, size, exif);
        let uncertainty = known.to_be_calibrated().known_within();
        let assumed = CameraUncertainty::ASSUMED_FOCAL * f64::from(size[0].max(size[1]));
        let with_focal = KnownCamera { focal_px: known.focal_px.or(Some(assumed)), ..known.to_be_calibrated() };
        Self { camera: with_focal.held(), uncertainty, decentring: None }
    }

    /// That of an image of a block as it was known before the block; `None` where nobody knew its focal length.
    pub(super) fn before_block(run: &BlockRun, image: usize) -> Option<Self> {
        let initial = run.cameras.get(run.model.images.get(image)?.camera)?;
        Some(Self { camera: initial.known()?, uncertainty: initial.to_be_calibrated().known_within(), decentring: None })
    }

    /// That of an image of a block as the block adjusted it, with its standard errors; `None` where the image is not oriented.
    pub(super) fn of_block(run: &BlockRun, image: usize) -> Option<Self> {
        let oriented = run.model.images.get(image).filter(|image| image.pose.is_some())?;
        let camera = *run.model.cameras.get(oriented.camera)?;
        let model = run.reconstruction.as_ref().ok()?.models.first()?;
        let own = model.cameras.iter().position(|camera| *camera == oriented.camera)?;
        let errors = model.adjusted.cameras.get(own)?.standard_errors;
        // What the block has not estimated is as it was known before.
        let share = |error: Option<f64>, most: f64| error.map_or(0.0, |error| error.min(most));
        let most = CameraUncertainty::ASSUMED;
        let across = errors[1].zip(errors[2]).map(|(x, y)| x.max(y));
        let uncertainty = CameraUncertainty {
            focal: share(errors[0].map(|error| error / camera.focal_px), most.focal),
            principal_point: share(across.map(|error| error / camera.focal_px), most.principal_point),
            k1: share(errors[3], most.k1),
        };
        let decentring = errors[6].zip(errors[7]).map(|(p1, p2)| p1.max(p2).min(most.decentring()));
        Some(Self { camera, uncertainty, decentring })
    }
}

impl PlacedImage {
    /// Beside what the file of the image says of its camera: of one that was given with another focal length it is placed with doubt.
    pub fn beside_file(self, rules: &CameraRules, name: &str, size: [u32; 2], exif: &ExifImage) -> Self {
        match (self.verdict, contradicted_focal(rules, name, size, exif)) {
            (PlacingVerdict::Placed { links, .. }, Some((_, [given_px, file_px]))) => {
                let placing_weakness = PlacingWeakness::ContradictedFocal { given_px, file_px };
                Self { verdict: PlacingVerdict::Weak { links, placing_weakness }, ..self }
            }
            // What is doubted already says its own reason.
            (verdict, _) => Self { verdict, ..self },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ExifCamera;

    #[test]
    fn a_camera_is_as_uncertain_as_where_it_is_known_from() {
        let rules = CameraRules::read(Some(
            r#"{"cameras": [{"images": "a*", "focal_px": 900, "fixed": true}, {"images": "b*", "focal_px": 950}]}"#,
        ))
        .unwrap();
        let camera = ExifCamera { focal_mm: 5.0, pixel_mm: Some(0.005), ..ExifCamera::default() };
        let exif = ExifImage { camera: Some(camera), ..ExifImage::default() };
        let of = |name: &str, exif: &ExifImage| {
            let PlacingCamera { camera, uncertainty, .. } = PlacingCamera::of(&rules, name, [1000, 800], exif);
            (camera.focal_px, uncertainty.focal)
        };
        assert_eq!([of("a1", &exif), of("b1", &exif), of("c1", &exif)], [(900.0, 0.0), (950.0, 0.05), (1000.0, 0.05)]);
        assert_eq!(of("c1", &ExifImage::default()), (850.0, 0.4));
    }

    #[test]
    fn a_focal_length_that_the_file_contradicts_is_doubted() {
        let rules = CameraRules::read(Some(
            r#"{"cameras": [{"images": "a*", "focal_px": 1600, "fixed": true}, {"images": "b*", "focal_px": 1100}]}"#,
        ));
        let camera = ExifCamera { focal_mm: 5.0, pixel_mm: Some(0.005), ..ExifCamera::default() };
        let exif = ExifImage { camera: Some(camera), ..ExifImage::default() };
        let sure = || PlacingVerdict::Placed { links: 400, sigma0_px: 0.3, half_width_m: 0.2 };
        let rules = rules.unwrap();
        let judged = |name: &str, exif: &ExifImage, verdict: PlacingVerdict| {
            PlacedImage { verdict, placement: None, search: None }.beside_file(&rules, name, [1000, 800], exif).verdict
        };
        let placing_weakness = PlacingWeakness::ContradictedFocal { given_px: 1600.0, file_px: 1000.0 };
        assert_eq!(judged("a1", &exif, sure()), PlacingVerdict::Weak { links: 400, placing_weakness });
        // Nearly the same; nothing given; a file that says nothing; what is doubted already.
        for (name, exif) in [("b1", exif.clone()), ("c1", exif.clone()), ("a1", ExifImage::default())] {
            assert_eq!(judged(name, &exif, sure()), sure(), "{name}");
        }
        let weak = PlacingVerdict::Weak { links: 20, placing_weakness: PlacingWeakness::FewLinks { links: 20, needed: 30 } };
        assert_eq!(judged("a1", &exif, weak.clone()), weak);
    }
}
