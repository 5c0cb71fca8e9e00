//! The declarations of all options fit each other.

use std::collections::BTreeSet;
use tiepoint::{BlockSettings, PairSettings, Parameter, ParameterKind, acting};

#[test]
fn conditions_name_options_and_their_words() {
    let all: Vec<&Parameter> = PairSettings::parameters().chain(BlockSettings::parameters()).collect();
    for condition in all.iter().map(|p| p.acts).filter(|acts| !acts.is_empty()) {
        for one in condition.split(" or ").flat_map(|all| all.split(" and ")) {
            let (key, words) = one.split_once(" is ").unwrap();
            let parameter = all.iter().find(|p| p.key == key).unwrap_or_else(|| panic!("{condition}: there is no {key}"));
            for word in words.trim_start_matches("not ").split(", ") {
                let known = match parameter.kind {
                    _ if word == "absent" => !parameter.absent.is_empty(),
                    ParameterKind::Choice { values, .. } => values.contains(&word),
                    ParameterKind::Flag => ["true", "false"].contains(&word),
                    ParameterKind::Text => true,
                    ParameterKind::Integer { .. } | ParameterKind::Real { .. } => word.parse::<f64>().is_ok(),
                };
                assert!(known, "{condition}: {key} has no value {word}");
            }
        }
    }
}

#[test]
fn an_option_that_may_be_absent_says_what_holds_then() {
    let settings = serde_json::to_value(PairSettings::default()).unwrap();
    for parameter in PairSettings::parameters() {
        let value = parameter.key.split('.').fold(&settings, |at, name| &at[name]);
        assert_eq!(value.is_null(), !parameter.absent.is_empty(), "{}", parameter.key);
    }
}

#[test]
fn labels_and_helps_are_sentences() {
    for p in PairSettings::parameters().chain(BlockSettings::parameters()) {
        assert!(p.help.ends_with('.') && !p.help.contains("  "), "{}: {}", p.key, p.help);
        assert!(!p.help.contains(['`', '[']), "{}: markup reaches the reader: {}", p.key, p.help);
        assert!(!p.label.ends_with('.') && !p.section.is_empty(), "{}", p.key);
        if let ParameterKind::Integer { min, max, .. } | ParameterKind::Real { min, max } = p.kind {
            assert!(min < max, "{} has no range", p.key);
        }
    }
}

#[test]
fn what_has_no_effect_is_known() {
    let keys = |settings: &PairSettings| acting(PairSettings::parameters(), &settings.resolved()).into_iter().collect::<BTreeSet<_>>();
    let mut settings = PairSettings::default();
    settings.matching.strategy = tiepoint::Strategy::Moments;
    let by_moments = keys(&settings);
    assert!(by_moments.contains("points.threshold") && by_moments.contains("window.side"), "{by_moments:?}");
    assert!(!by_moments.contains("multiscale.number") && !by_moments.contains("gradient.cell"), "{by_moments:?}");
    settings.matching.strategy = tiepoint::Strategy::Gradient;
    let by_gradients = keys(&settings);
    assert!(by_gradients.contains("multiscale.number") && by_gradients.contains("geometry.largest_threshold_px"), "{by_gradients:?}");
    assert!(!by_gradients.contains("points.threshold") && !by_gradients.contains("matching.search"), "{by_gradients:?}");
    assert!(!by_gradients.contains("matching.min_correlation"), "{by_gradients:?}");
    settings.matching.strategy = tiepoint::Strategy::Auto;
    let with_refinement = ["matching.fill_in", "matching.template", "matching.min_correlation", "matching.max_standard_error"];
    assert_eq!(keys(&settings), by_gradients.iter().copied().chain(with_refinement).collect());
    settings.geometry.threshold_px = Some(1.0);
    assert!(!keys(&settings).contains("geometry.largest_threshold_px"));
}
