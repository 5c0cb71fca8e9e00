//! The camera that the frames of a film have in common.

use crate::{CameraRule, CameraUncertainty};

/// The cameras of frames as a file of cameras has them, from those of each: `rules` have the name of their frame for `images`, `pattern` is that of all
/// these names.
///
/// Frames whose cameras have the same constants have one. The most that the marks of one of them leave open is then what is not known of it: marks of each
/// scan have errors of their own, by which the common camera is off in each image by another amount of about this size. A mean would be too small where
/// some scans have three marks, which say nothing of their errors.
pub fn film_cameras(pattern: &str, rules: &[CameraRule]) -> Vec<CameraRule> {
    let mut groups: Vec<Vec<&CameraRule>> = Vec::new();
    for rule in rules {
        match groups.iter_mut().find(|group| has_same_constants(group[0], rule)) {
            Some(group) => group.push(rule),
            None => groups.push(vec![rule]),
        }
    }
    let Some((common, others)) = groups.split_first() else { return Vec::new() };
    let named = |rule: &CameraRule, images: &str, uncertainty| CameraRule { images: images.into(), uncertainty, ..rule.clone() };
    // The first rule that fits holds.
    let of_single = others.iter().flat_map(|group| group.iter().map(|rule| named(rule, &rule.images, of_group(group))));
    of_single.chain([named(common[0], pattern, of_group(common))]).map(with_what_is_known).collect()
}

fn has_same_constants(a: &CameraRule, b: &CameraRule) -> bool {
    let constants = |rule: &CameraRule| CameraRule { images: String::new(), fixed: false, uncertainty: None, ..rule.clone() };
    constants(a) == constants(b)
}

/// What is not known of the camera of some frames; `None`: nothing.
fn of_group(group: &[&CameraRule]) -> Option<CameraUncertainty> {
    group.iter().filter_map(|rule| rule.uncertainty).reduce(|a, b| CameraUncertainty {
        focal: a.focal.max(b.focal),
        principal_point: a.principal_point.max(b.principal_point),
        k1: a.k1.max(b.k1),
    })
}

fn with_what_is_known(rule: CameraRule) -> CameraRule {
    CameraRule { fixed: rule.uncertainty.is_none(), ..rule }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rule(images: &str, focal_px: f64, errors: [f64; 2]) -> CameraRule {
        let [focal, principal_point] = errors;
        let uncertainty = Some(CameraUncertainty { focal, principal_point, k1: 0.0 }).filter(|_| errors != [0.0; 2]);
        CameraRule {
            images: images.into(),
            focal_px,
            principal_point_px: Some([10.0, 20.0]),
            radial: [0.0; 3],
            tangential: [0.0; 2],
            pixel_mm: Some(0.1),
            fixed: uncertainty.is_none(),
            uncertainty,
        }
    }

    #[test]
    fn frames_of_one_film_have_one_camera_whose_errors_are_those_of_their_marks() {
        // Marks without redundancy say nothing of their errors, beside others neither.
        let rules = [rule("a.png", 600.0, [3e-5, 1e-5]), rule("b.png", 600.0, [2e-5, 7e-5]), rule("c.png", 600.0, [0.0; 2])];
        let [common] = film_cameras("*.png", &rules).try_into().unwrap();
        let own = common.uncertainty.unwrap();
        assert_eq!((common.images.as_str(), common.fixed, common.focal_px), ("*.png", false, 600.0));
        assert_eq!([own.focal, own.principal_point, own.k1], [3e-5, 7e-5, 0.0]);
        let known = film_cameras("*.png", &[rule("a.png", 600.0, [0.0; 2])]);
        assert_eq!(known, [rule("*.png", 600.0, [0.0; 2])]);
        assert!(film_cameras("*.png", &[]).is_empty());
    }

    #[test]
    fn a_frame_of_another_camera_is_named_before_the_pattern_of_all() {
        let rules = [rule("a.png", 600.0, [3e-5; 2]), rule("b.png", 601.0, [5e-5; 2]), rule("c.png", 600.0, [3e-5; 2])];
        let found = film_cameras("*.png", &rules);
        let names: Vec<(&str, f64)> = found.iter().map(|rule| (rule.images.as_str(), rule.focal_px)).collect();
        assert_eq!(names, [("b.png", 601.0), ("*.png", 600.0)]);
        assert_eq!(found[1].uncertainty.unwrap().focal, 3e-5);
    }
}
