//! The catalogue and the families of messages hold each other: every kind has a text, every text a kind, every variable a figure.

use super::texts::NESTED;
use super::{Message, Texts};
use crate::json::{JsonFault, JsonKind, JsonSlip, JsonSyntax, JsonWanted};
use crate::outputs::PlaceGroup;
use crate::{
    Allowed, Axis, BlockVerdict, BlockWarning, CameraParameter, Cause, Computation, Connection, ControlApart, Damage, Degeneracy,
    DescribedBy, Document, Element, Error, Failure, Few, FileFault, FileKind, FilePlace, ImageFault, ImageOperation, ImageReason, Input,
    Interruption, KnownWorst, LengthUnit, Location, Mistake, NamedCamera, NoGeometry, NoOrientation, NotLinked, NotPlaced,
    ObservationGroup, Observed, OnOrthophoto, OverviewWarning, PairHint, PairOutcome, PairRule, PairVerdict, PlaceSearch, PlaceSlip,
    PlacingVerdict, PlacingWeakness, PointName, Refusal, Remark, ReportStep, Rule, Side, SystematicError, SystematicVerdict,
    UnorientedReason, Unsettled, Unsupported, Warning,
};
use crate::{CameraCaution, CameraOrigin};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};

const ENGLISH: &str = include_str!("../catalogue/en.ftl");
const ARABIC: &str = include_str!("../catalogue/ar.ftl");

/// Entries of what are no messages: kinds of results, and points that no rule decides.
const OTHER: [&str; 6] = [
    "two-view-model-calibrated",
    "two-view-model-fundamental",
    "two-view-model-homography",
    "two-view-model-rotation",
    "verdict-gross-error",
    "verdict-undecided",
];

/// A family by its name: the identifiers of its entries with their figures.
type Family = (&'static str, Vec<(String, &'static [&'static str])>);

fn family<M: Message>() -> Family {
    let kebab = |name: &str| {
        let words = name.chars().enumerate().flat_map(|(k, c)| ((k > 0 && c.is_uppercase()).then_some('-')).into_iter().chain([c]));
        words.collect::<String>().to_lowercase()
    };
    let family = M::FAMILY.replace('_', "-");
    let id = |kind: &str| if kind.is_empty() { family.clone() } else { format!("{family}-{}", kebab(kind)) };
    (M::FAMILY, M::KINDS.iter().map(|(kind, figures)| (id(kind), *figures)).collect())
}

fn families() -> Vec<Family> {
    vec![
        family::<Allowed>(),
        family::<Axis>(),
        family::<BlockWarning>(),
        family::<ControlApart>(),
        family::<Mistake>(),
        family::<Refusal>(),
        family::<Input>(),
        family::<Location>(),
        family::<Element>(),
        family::<PointName>(),
        family::<DescribedBy>(),
        family::<CameraCaution>(),
        family::<CameraOrigin>(),
        family::<CameraParameter>(),
        family::<Cause>(),
        family::<Connection>(),
        family::<Damage>(),
        family::<Degeneracy>(),
        family::<Error>(),
        family::<Document>(),
        family::<Failure>(),
        family::<Few>(),
        family::<FileFault>(),
        family::<FileKind>(),
        family::<FilePlace>(),
        family::<ImageFault>(),
        family::<ImageOperation>(),
        family::<JsonFault>(),
        family::<JsonKind>(),
        family::<JsonSlip>(),
        family::<JsonSyntax>(),
        family::<JsonWanted>(),
        family::<ImageReason>(),
        family::<Interruption>(),
        family::<LengthUnit>(),
        family::<NamedCamera>(),
        family::<NoGeometry>(),
        family::<NoOrientation>(),
        family::<BlockVerdict>(),
        family::<PairHint>(),
        family::<PairVerdict>(),
        family::<NotLinked>(),
        family::<NotPlaced>(),
        family::<OnOrthophoto>(),
        family::<PlaceSlip>(),
        family::<PlaceSearch>(),
        family::<PlacingVerdict>(),
        family::<PlacingWeakness>(),
        family::<Observed>(),
        family::<OverviewWarning>(),
        family::<ObservationGroup>(),
        family::<PlaceGroup>(),
        family::<SystematicError>(),
        family::<SystematicVerdict>(),
        family::<ReportStep>(),
        family::<PairOutcome>(),
        family::<PairRule>(),
        family::<Remark>(),
        family::<Rule>(),
        family::<Side>(),
        family::<Computation>(),
        family::<UnorientedReason>(),
        family::<Unsettled>(),
        family::<Unsupported>(),
        family::<Warning>(),
    ]
}

fn messages() -> BTreeMap<String, &'static [&'static str]> {
    families().into_iter().flat_map(|(_, entries)| entries).collect()
}

/// The entries of a catalogue with the variables that each names in its text; those of items are in the attributes.
fn entries(catalogue: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let (mut id, mut is_item) = (String::new(), false);
    for line in catalogue.lines().filter(|line| !line.starts_with('#')) {
        if let Some((name, _)) = line.split_once(" =").filter(|_| line.starts_with(|c: char| c.is_ascii_lowercase())) {
            (id, is_item) = (name.to_string(), false);
            found.insert(id.clone(), BTreeSet::new());
        }
        is_item |= line.trim_start().starts_with('.') && line.contains(" = ");
        let variable = |rest: &str| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
        if !is_item {
            found.get_mut(&id).into_iter().for_each(|names| names.extend(line.split('$').skip(1).map(variable)));
        }
    }
    found
}

#[test]
fn every_kind_has_a_text_and_every_text_a_kind() {
    let written: BTreeSet<String> = entries(ENGLISH).into_keys().collect();
    let wanted: BTreeSet<String> = messages().into_keys().chain(OTHER.map(String::from)).collect();
    assert_eq!(written, wanted, "in the catalogue; of the families");
    for catalogue in [ENGLISH, ARABIC] {
        assert!(fluent_bundle::FluentResource::try_new(catalogue.into()).is_ok(), "a catalogue has an entry that cannot be read");
    }
    assert_eq!(entries(ARABIC), entries(ENGLISH), "texts and their figures in Arabic; in English");
}

#[test]
fn catalogues_call_functions_that_there_are() {
    for catalogue in [ENGLISH, ARABIC] {
        // `{ NAME(` begins a call.
        let calls = catalogue.split("{ ").skip(1).filter_map(|rest| {
            let (name, _) = rest.split_once('(')?;
            (!name.is_empty() && name.chars().all(|c| c.is_ascii_uppercase())).then_some(name)
        });
        let names: BTreeSet<&str> = calls.collect();
        let known: BTreeSet<&str> = super::texts::FORMATS.iter().map(|(name, _)| *name).chain(["LIKE"]).collect();
        assert!(names.is_subset(&known) && names.len() > 3, "{names:?}");
    }
}

#[test]
fn texts_name_the_figures_of_their_messages() {
    for (id, figures) in messages() {
        let given = |name: &str| figures.iter().any(|f| name == *f || name == format!("{f}_more") || name == format!("{f}_count"));
        for name in &entries(ENGLISH)[&id] {
            assert!(given(name), "{id} names ${name}; its figures are {figures:?}");
        }
        for name in figures {
            let is_family = families().iter().any(|(family, _)| family == name);
            assert!(!is_family || NESTED.contains(name), "{id} has the message {name}, which is not rendered");
        }
    }
}

#[test]
fn figures_are_written_in_one_way() {
    let scale = |ratio: f64| {
        let warning = json!({ "kind": "scale", "ratio": ratio, "unit": null });
        Texts::english().text_of("block_warning", &warning, None)
    };
    for (ratio, written) in [(0.001_012, "0.0010"), (0.3048, "0.30"), (3.32, "3.3"), (39.4, "39"), (1012.0, "1000"), (9.97, "10")] {
        assert_eq!(scale(ratio), format!("The GCPs make the block {written} times as large as the GNSS positions: metres are needed."));
    }
    let names = |n: usize| (0..n).map(|k| format!("{k}.jpg")).collect::<Vec<_>>();
    let few = |n: usize| BlockWarning::FewObservations { images: names(n), least: 20 }.to_string();
    assert_eq!(few(1), "1 image has fewer than 20 observations: 0.jpg.");
    assert_eq!(few(7), "7 images have fewer than 20 observations: 0.jpg, 1.jpg, 2.jpg, 3.jpg, 4.jpg and 2 more.");
    let control = |positions: usize| BlockWarning::FewControl { points: 3, positions, detectable_m: None }.to_string();
    for (positions, said) in [(0, "no GNSS positions"), (1, "1 GNSS position"), (2, "2 GNSS positions")] {
        assert!(
            control(positions).starts_with(&format!("Only 3 GCPs and {said} place the block: nothing checks")),
            "{}",
            control(positions)
        );
    }
    let condition = Warning::IllConditioned { condition: f64::INFINITY, most: 2e4 };
    assert!(condition.to_string().contains("condition –; up to 2e4"), "{condition}");
}

#[test]
fn what_rounds_to_zero_has_no_sign() {
    let hint = |expected_dx_px: f64| {
        let hint = PairHint::Displaced {
            dx_px: -120.4,
            dy_px: 3.0,
            expected_dx_px,
            expected_dy_px: 0.0,
            most_px: 25.0,
            turn_deg: 0.0,
            scale: 1.0,
        };
        hint.to_string()
    };
    for (expected, said) in
        [(-0.3, "where 0, 0 px was expected"), (-0.6, "where -1, 0 px was expected"), (0.3, "where 0, 0 px was expected")]
    {
        assert!(hint(expected).contains(said), "{}", hint(expected));
    }
}

#[test]
fn a_value_has_the_decimals_of_its_error() {
    let texts = Texts::new("en", "value = { LIKE($value, $error, digits: 2) } ± { SIGNIFICANT($error, digits: 2) }");
    let written = |value: f64, error: f64| texts.text_of("value", &json!({ "value": value, "error": error }), None);
    assert_eq!(written(0.1466, 0.0178), "0.147 ± 0.018");
    assert_eq!(written(-0.1466, 2.34), "-0.1 ± 2.3");
    assert_eq!(written(12.6, 346.0), "13 ± 350");
    assert_eq!(written(1.0, f64::NAN), "– ± –");
    let verdict = |worst, axes_deg| PairVerdict::Oriented {
        points: 40,
        sigma0_px: Some(0.1),
        sigma0_um: None,
        kappa_deg: 0.1466,
        half_width_deg: 0.0178,
        axes_deg,
        worst,
        worst_half_width_deg: 1.402,
    };
    for (worst, axes_deg, said) in [
        (KnownWorst::Kappa, None, " by 0.147° ± 0.018° (95 %)."),
        (KnownWorst::Phi, None, " by 0.147° ± 0.018°, φ is known to ± 1.4° (95 %)."),
        (KnownWorst::Base, None, " by 0.147° ± 0.018°, the direction of the base is known to ± 1.4° (95 %)."),
        (KnownWorst::Phi, Some(10.14), " by 0.147° ± 0.018°, the camera axes are 10.1° apart, φ is known to ± 1.4° (95 %)."),
    ] {
        let text = verdict(worst, axes_deg).to_string();
        assert!(text.ends_with(said), "{text}");
    }
}

#[test]
fn a_weak_block_says_its_share_of_images_once() {
    let few = OverviewWarning::FewOriented { oriented: 3, images: 4 };
    let verdict = BlockVerdict::Weak { oriented: 3, images: 4, points: 80, overview_warning: few }.to_string();
    assert_eq!(verdict.matches("3 of 4").count(), 1, "{verdict}");
}

#[test]
fn messages_within_messages_have_their_texts() {
    let cause = Cause::PointsOnLine { side: Side::Left, width: 0.000_02, least: 1e-4 };
    let error = Error::Degenerate { computation: Computation::RelativeOrientation, cause };
    let text = NoOrientation::Refused { error }.to_string();
    assert_eq!(
        text,
        "the observations do not determine the relative orientation: all points of the left photo lie on a line (width / length = 2.0e-5; \
         at least 1e-4 is needed)"
    );
    let camera = NamedCamera { only: false, number: 2, first: Some("0005.jpg".into()), more: 4 };
    let fixed = BlockWarning::ParameterFixed { camera, camera_parameter: CameraParameter::K3 };
    assert_eq!(
        fixed.to_string(),
        "The block does not determine k3 of camera 2 (0005.jpg and 4 more images); it keeps its approximate value."
    );
}

#[test]
fn heights_are_above_or_below_without_a_sign_to_read() {
    let heights = |up_m| ControlApart::Heights { up_m }.to_string();
    assert!(heights(-28.74).starts_with("these meet 28.74 m below them in the median, "), "{}", heights(-28.74));
    assert!(heights(28.74).starts_with("these meet 28.74 m above them in the median, "), "{}", heights(28.74));
    let places = |up_m| ControlApart::Places { across_m: 30.0, up_m }.to_string();
    assert!(places(-2.5).starts_with("these meet 30.00 m from them in plan and 2.50 m below them, "), "{}", places(-2.5));
    let arabic = |up_m| Texts::arabic().text(&ControlApart::Heights { up_m });
    assert!(arabic(-28.74) != arabic(28.74) && !arabic(-28.74).contains("-28"), "{}", arabic(-28.74));
}

#[test]
fn the_height_of_the_geoid_is_offered_as_it_is_known() {
    let (crs, operation) = (String::new(), None);
    let remark = Remark::ResultSystem { crs, operation, accuracy_m: None, gnss_above_m: Some(49.16) }.to_string();
    assert!(remark.contains("They are about 49 m higher than those of the block"), "{remark}");
}

#[test]
fn a_block_with_gnss_positions_that_do_not_place_it_does_not_say_that_there_are_none() {
    let free = |without_heights| BlockWarning::Free { cause: None, without_heights }.to_string();
    assert!(free(0).starts_with("No observed positions determine "), "{}", free(0));
    assert!(free(12).starts_with("The 12 GNSS positions do not determine ") && free(12).ends_with("are arbitrary."), "{}", free(12));
}

#[test]
fn a_language_without_catalogue_is_english() {
    let lost = |language| Texts::of(language).text(&UnorientedReason::NoPoints);
    assert_eq!(lost("de"), "it has no tie points");
    assert_eq!(lost("ar"), lost("ar-EG"));
    assert_ne!(lost("ar"), lost("en"));
}

#[test]
fn arabic_has_its_plurals_and_sets_figures_apart() {
    let few = |n: usize| Texts::arabic().text(&UnorientedReason::Lost { rays: n });
    let forms: BTreeSet<String> = [1, 2, 5, 11, 100].map(|n| few(n).replace(|c: char| c.is_ascii_digit(), "")).into();
    assert_eq!(forms.len(), 5, "one, two, few, many and other: {forms:?}");
    assert!(few(11).contains("\u{2068}11\u{2069}"), "{}", few(11));
}

#[test]
fn a_second_language_is_a_second_catalogue_and_falls_back_to_english() {
    let german =
        Texts::new("de", "unoriented-lost = nur { $rays ->\n    [one] ein Strahl\n   *[other] { $rays } Strahlen\n}\nbroken = {\n");
    assert_eq!(german.text(&UnorientedReason::Lost { rays: 1 }), "nur ein Strahl");
    assert_eq!(german.text(&UnorientedReason::Lost { rays: 3 }), "nur 3 Strahlen");
    assert_eq!(german.text(&UnorientedReason::NoPoints), "it has no tie points");
    assert_eq!(Texts::new("no tag!", "").text(&UnorientedReason::NoPoints), "it has no tie points");
    assert_eq!(german.text_of("unoriented", &json!({ "kind": "of_the_future" }), None), "unoriented-of-the-future");
}
