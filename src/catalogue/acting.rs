//! Which options have an effect beside the others.

use super::parameter::Parameter;
use serde::Serialize;
use serde_json::Value;

/// The keys of the parameters that have an effect with these settings. What a condition asks for and the settings do not have is taken for
/// granted, as the strategy of a block.
pub fn acting<'a>(parameters: impl IntoIterator<Item = &'a Parameter>, settings: &impl Serialize) -> Vec<&'static str> {
    let settings = serde_json::to_value(settings).unwrap_or_default();
    parameters.into_iter().filter(|p| p.acts.is_empty() || holds(p.acts, &settings)).map(|p| p.key).collect()
}

fn holds(condition: &str, settings: &Value) -> bool {
    condition.split(" or ").any(|all| all.split(" and ").all(|one| is_met(one, settings)))
}

fn is_met(one: &str, settings: &Value) -> bool {
    let (key, words) = one.split_once(" is ").unwrap_or((one, "true"));
    let (negated, words) = words.strip_prefix("not ").map_or((false, words), |words| (true, words));
    match key.split('.').try_fold(settings, |at, name| at.get(name)) {
        None => true,
        Some(value) => words.split(", ").any(|word| word == written(value)) != negated,
    }
}

/// A value as conditions write it.
fn written(value: &Value) -> String {
    match value {
        Value::Null => "absent".into(),
        Value::String(word) => word.clone(),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_condition_is_read_as_it_is_written() {
        let settings = json!({ "a": { "word": "x", "flag": true, "number": 0, "none": null } });
        for met in ["a.word is x", "a.word is y, x", "a.flag is true", "a.number is 0", "a.none is absent", "a.word is not y", "b.c is d"] {
            assert!(holds(met, &settings), "{met}");
        }
        for unmet in ["a.word is y", "a.flag is false", "a.number is not 0", "a.none is not absent", "a.word is x and a.flag is false"] {
            assert!(!holds(unmet, &settings), "{unmet}");
        }
        assert!(holds("a.word is y or a.word is x and a.flag is true", &settings));
    }
}
