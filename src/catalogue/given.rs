//! Settings of which some are given: the others take their defaults.

use super::parameter::{Group, Parameter, ParameterKind};
use crate::json::{self, JsonFault, JsonKind};
use crate::{Allowed, Document, Error};
use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

/// Settings as JSON, in which any field may be absent: those that are given replace the defaults of the whole, object by object.
///
/// A struct inside may have other defaults than it has alone, as the number of points in a block: these hold.
///
/// # Errors
/// [`JsonFault`] for unknown fields and values of another type.
pub fn with_defaults<T: DeserializeOwned + Serialize + Default>(given: Value) -> Result<T, JsonFault> {
    let mut settings = serde_json::to_value(T::default()).map_err(JsonFault::from)?;
    overlay(&mut settings, given);
    json::from_value(&settings)
}

/// An object of which a caller gives some fields, as [`with_defaults`] reads it.
///
/// Its check before that says of a value that is not allowed what its option allows; a reader of JSON would say it in names of types.
pub trait PartlyGiven: DeserializeOwned + Serialize + Default {
    /// Its declared options by where they stand; without any it is an object all the same.
    const GROUPS: &'static [Group] = &[Group { path: "", parameters: &[] }];

    /// Rejects values of declared options that are outside their ranges or of another type. `document`: what is read.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::WrongType`].
    fn check_given(given: &Value, document: &Document) -> Result<(), Error> {
        check_groups(Self::GROUPS, given, document)
    }
}

/// Rejects values of the options of these groups, as [`PartlyGiven`] does.
pub(crate) fn check_groups(groups: &[Group], given: &Value, document: &Document) -> Result<(), Error> {
    groups.iter().try_for_each(|group| check_group(group, given, document))
}

fn check_group(group: &Group, given: &Value, document: &Document) -> Result<(), Error> {
    let mut at = given;
    let mut path = String::new();
    let mut names = group.path.split('.').filter(|name| !name.is_empty());
    loop {
        let Value::Object(fields) = at else {
            return if at.is_null() { Ok(()) } else { Err(wrong_type(document, &path, at, Allowed::Object)) };
        };
        let Some(name) = names.next() else {
            let mut given = group.parameters.iter().filter_map(|parameter| Some((parameter, fields.get(parameter.field())?)));
            return given.try_for_each(|(parameter, value)| check_value(parameter, value, group, document));
        };
        let Some(next) = fields.get(name) else { return Ok(()) };
        path = if path.is_empty() { name.into() } else { format!("{path}.{name}") };
        at = next;
    }
}

fn check_value(parameter: &Parameter, value: &Value, group: &Group, document: &Document) -> Result<(), Error> {
    match (parameter.kind, value) {
        (ParameterKind::Integer { .. } | ParameterKind::Real { .. }, Value::Number(number)) => {
            parameter.check(number.as_f64().unwrap_or(f64::INFINITY))
        }
        // A number that JSON has not stands as its name.
        (ParameterKind::Integer { .. } | ParameterKind::Real { .. }, Value::String(word)) if NOT_FINITE.contains(&&word[..]) => {
            Err(parameter.refused(word))
        }
        (ParameterKind::Choice { values, .. }, Value::String(word)) if !values.contains(&&word[..]) => Err(parameter.refused(word)),
        (ParameterKind::Choice { .. } | ParameterKind::Text, Value::String(_)) | (ParameterKind::Flag, Value::Bool(_)) => Ok(()),
        (_, Value::Null) if parameter.is_optional() => Ok(()),
        _ => Err(wrong_type(document, &group.path_of(parameter), value, parameter.allowed())),
    }
}

/// What numbers are called that are not finite.
const NOT_FINITE: [&str; 3] = ["NaN", "Infinity", "-Infinity"];

fn wrong_type(document: &Document, field: &str, value: &Value, allowed: Allowed) -> Error {
    let field = Some(field.to_string()).filter(|field| !field.is_empty());
    Error::WrongType { document: document.clone(), field, json_kind: JsonKind::of(value), allowed }
}

/// Reads options inside a file: those that it was written without take their defaults.
pub(crate) fn read_options<'de, D: Deserializer<'de>, T: DeserializeOwned + Serialize + Default>(from: D) -> Result<T, D::Error> {
    with_defaults(Value::deserialize(from)?).map_err(D::Error::custom)
}

fn overlay(settings: &mut Value, given: Value) {
    match (settings, given) {
        (Value::Object(settings), Value::Object(given)) => {
            for (name, value) in given {
                overlay(settings.entry(name).or_insert(Value::Null), value);
            }
        }
        // A group as a whole may be absent.
        (Value::Object(_), Value::Null) => {}
        (settings, given) => *settings = given,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockSettings, Flight, PairSettings, RunInput};
    use serde_json::json;

    fn refused<T: PartlyGiven>(given: Value) -> (&'static str, String) {
        let error = T::check_given(&given, &Document::Named { name: "settings".into() }).unwrap_err();
        (error.code(), error.to_string())
    }

    #[test]
    fn a_value_that_is_not_allowed_is_refused_by_what_its_option_allows() {
        for (number, got) in [(json!(-5), "-5"), (json!(1.5), "1.5"), (json!(8589934592_u64), "8589934592"), (json!("NaN"), "NaN")] {
            let told = format!("multiscale.number is {got}; allowed: whole numbers from 1 to 1000000");
            assert_eq!(refused::<PairSettings>(json!({ "multiscale": { "number": number } })), ("invalid-option", told));
        }
        let (code, told) = refused::<Flight>(json!({ "seed": 4294967296_u64 }));
        assert_eq!((code, &told[..]), ("invalid-option", "flight.seed is 4294967296; allowed: whole numbers from 0 to 4294967295"));
        let (code, told) = refused::<PairSettings>(json!({ "matching": { "strategy": "gradients" } }));
        assert!(code == "invalid-option" && told.starts_with("matching.strategy is gradients; allowed: auto, moments, "), "{told}");
    }

    #[test]
    fn a_value_of_another_type_is_refused_by_its_place() {
        for (given, told) in [
            (json!([1, 2]), "settings: got a list; allowed: an object of options"),
            (json!({ "points": "all" }), "settings: points: got a text; allowed: an object of options"),
            (
                json!({ "multiscale": { "number": "5" } }),
                "settings: multiscale.number: got a text; allowed: whole numbers from 1 to 1000000",
            ),
            (
                json!({ "multiscale": { "number": null } }),
                "settings: multiscale.number: got null; allowed: whole numbers from 1 to 1000000",
            ),
            (json!({ "matching": { "fill_in": 1 } }), "settings: matching.fill_in: got a number; allowed: yes or no"),
        ] {
            assert_eq!(refused::<PairSettings>(given), ("invalid-json", told.into()));
        }
        let feature = json!({ "features": { "multiscale": { "number": true } } });
        let told = "settings: features.multiscale.number: got true or false; allowed: whole numbers from 1 to 1000000";
        assert_eq!(refused::<BlockSettings>(feature.clone()), ("invalid-json", told.into()));
        assert_eq!(refused::<RunInput>(json!({ "settings": feature })), ("invalid-json", told.into()));
    }

    #[test]
    fn what_is_allowed_or_absent_is_taken() {
        let document = Document::Named { name: "settings".into() };
        for given in
            [json!({}), json!(null), json!({ "points": null }), json!({ "points": { "threshold": null } }), json!({ "nothing": 1 })]
        {
            PairSettings::check_given(&given, &document).unwrap();
        }
        PairSettings::check_given(&serde_json::to_value(PairSettings::default()).unwrap(), &document).unwrap();
        BlockSettings::check_given(&serde_json::to_value(BlockSettings::default()).unwrap(), &document).unwrap();
    }

    /// Every group stands where its path leads, with the fields that it declares.
    #[test]
    fn groups_stand_where_their_paths_lead() {
        let all = [
            (PairSettings::GROUPS, serde_json::to_value(PairSettings::default()).unwrap()),
            (BlockSettings::GROUPS, serde_json::to_value(BlockSettings::default()).unwrap()),
        ];
        for (groups, settings) in all {
            for (group, parameter) in groups.iter().flat_map(|group| group.parameters.iter().map(move |parameter| (group, parameter))) {
                let path = group.path_of(parameter);
                assert!(settings.pointer(&format!("/{}", path.replace('.', "/"))).is_some(), "{path}");
                let value = path.split('.').fold(&settings, |at, name| &at[name]);
                assert!(!value.is_null() || parameter.is_optional(), "{path}");
            }
        }
    }
}
