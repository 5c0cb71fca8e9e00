//! The camera that the frames of a film have in common.

use crate::{CameraRule, CameraUncertainty};

/// The pattern of the names of frames of one film, beside those of others: `*-film.png`, then `*-film2.png` and so on, the first that is that of no camera in `given`, or that of this one, of which more frames were made.
/// `rule`: the camera of one frame.
pub fn film_pattern(rule: &CameraRule, given: &[CameraRule]) -> String {
    let names = (1..).map(|number: usize| if number == 1 { "*-film.png".to_string() } else { format!("*-film{number}.png") });
    let is_free = |name: &String| given.iter().find(|other| other.images == *name).is_none_or(|other| has_same_constants(other, rule));
    names.into_iter().find(is_free).unwrap_or_default()
}

/// The cameras of frames as a file of cameras has them, from those of each, before those that the file has (`given`): `rules` have the name of their frame for `images`, `pattern` is that of all
/// these names ([`film_pattern`]).
///
/// Frames whose cameras have the same constants have one. The most that the marks of one of them leave open is then what is not known of it: marks of each
/// scan have errors of their own, by which the common camera is off in each image by another amount of about this size. A mean would be too small where
/// some scans have three marks, which say nothing of their errors. So it is with frames of the same film that were made before, whose camera `given` has.
pub fn film_cameras(pattern: &str, rules: &[CameraRule], given: &[CameraRule]) -> Vec<CameraRule> {
    let mut groups: Vec<Vec<&CameraRule>> = Vec::new();
    for rule in rules {
        match groups.iter_mut().find(|group| has_same_constants(group[0], rule)) {
            Some(group) => group.push(rule),
            None => groups.push(vec![rule]),
        }
    }
    let Some((common, others)) = groups.split_first_mut() else { return given.to_vec() };
    common.extend(given.iter().filter(|rule| rule.images == pattern && has_same_constants(common[0], rule)).collect::<Vec<_>>());
    let named = |rule: &CameraRule, images: &str, uncertainty| CameraRule { images: images.into(), uncertainty, ..rule.clone() };
    // The first rule that fits holds.
    let of_single = others.iter().flat_map(|group| group.iter().map(|rule| named(rule, &rule.images, of_group(group))));
    let mut own: Vec<CameraRule> = of_single.chain([named(common[0], pattern, of_group(common))]).map(with_what_is_known).collect();
    // A frame that was named before for a camera of its own stays before the pattern that it fits.
    let (before, behind): (Vec<&CameraRule>, Vec<&CameraRule>) = given
        .iter()
        .filter(|rule| own.iter().all(|own| own.images != rule.images))
        .partition(|rule| rules.iter().all(|frame| frame.images != rule.images) && own.iter().any(|own| own.fits(&rule.images)));
    own.splice(0..0, before.into_iter().cloned());
    own.extend(behind.into_iter().filter(|rule| rules.iter().all(|frame| frame.images != rule.images)).cloned());
    own
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
        let [common] = film_cameras("*.png", &rules, &[]).try_into().unwrap();
        let own = common.uncertainty.unwrap();
        assert_eq!((common.images.as_str(), common.fixed, common.focal_px), ("*.png", false, 600.0));
        assert_eq!([own.focal, own.principal_point, own.k1], [3e-5, 7e-5, 0.0]);
        let known = film_cameras("*.png", &[rule("a.png", 600.0, [0.0; 2])], &[]);
        assert_eq!(known, [rule("*.png", 600.0, [0.0; 2])]);
        assert!(film_cameras("*.png", &[], &[]).is_empty());
    }

    #[test]
    fn a_frame_of_another_camera_is_named_before_the_pattern_of_all() {
        let rules = [rule("a.png", 600.0, [3e-5; 2]), rule("b.png", 601.0, [5e-5; 2]), rule("c.png", 600.0, [3e-5; 2])];
        let found = film_cameras("*.png", &rules, &[]);
        let names: Vec<(&str, f64)> = found.iter().map(|rule| (rule.images.as_str(), rule.focal_px)).collect();
        assert_eq!(names, [("b.png", 601.0), ("*.png", 600.0)]);
        assert_eq!(found[1].uncertainty.unwrap().focal, 3e-5);
    }

    #[test]
    fn two_films_of_one_block_keep_their_cameras_and_what_is_not_known_of_each() {
        let first = film_cameras("*-film.png", &[rule("a-film.png", 600.0, [3e-5, 1e-5]), rule("o-film.png", 610.0, [4e-5; 2])], &[]);
        let other = rule("c-film.png", 700.0, [9e-5, 8e-5]);
        let pattern = film_pattern(&other, &first);
        assert_eq!(pattern, "*-film2.png");
        let second = [rule("c-film2.png", 700.0, [9e-5, 8e-5]), rule("d-film2.png", 700.0, [2e-5; 2])];
        let both = film_cameras(&pattern, &second, &first);
        let rules: Vec<(&str, f64, f64)> =
            both.iter().map(|rule| (rule.images.as_str(), rule.focal_px, rule.uncertainty.unwrap().focal)).collect();
        assert_eq!(rules, [("*-film2.png", 700.0, 9e-5), ("o-film.png", 610.0, 4e-5), ("*-film.png", 600.0, 3e-5)]);
        // Each image has the camera of its film.
        let camera = |image: &str| both.iter().find(|rule| rule.fits(image)).unwrap().focal_px;
        assert_eq!(["a-film.png", "o-film.png", "d-film2.png"].map(camera), [600.0, 610.0, 700.0]);
        // More frames of the first film have its camera, with what the worst of all marks leaves open; a frame of another one comes before it.
        let more = rule("e-film.png", 600.0, [1e-5, 6e-5]);
        assert_eq!(film_pattern(&more, &both), "*-film.png");
        let all = film_cameras("*-film.png", &[more, rule("o2-film.png", 620.0, [1e-5; 2])], &both);
        let names: Vec<&str> = all.iter().map(|rule| rule.images.as_str()).collect();
        assert_eq!(names, ["o-film.png", "o2-film.png", "*-film.png", "*-film2.png"]);
        let own = all[2].uncertainty.unwrap();
        assert_eq!((own.focal, own.principal_point, all[2].fixed), (3e-5, 6e-5, false));
        assert_eq!(film_pattern(&rule("f.png", 800.0, [0.0; 2]), &all), "*-film3.png");
        assert_eq!(film_cameras("*-film.png", &[], &all), all);
    }
}
