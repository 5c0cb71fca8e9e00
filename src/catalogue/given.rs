//! Settings of which some are given: the others take their defaults.

use crate::json::{self, JsonFault};
use serde::de::{DeserializeOwned, Error};
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
