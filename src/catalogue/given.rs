//! Settings of which some are given: the others take their defaults.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Settings as JSON, in which any field may be absent or null: those that are given replace the defaults of the whole, object by object.
///
/// A struct inside may have other defaults than it has alone, as the number of points in a block: these hold.
///
/// # Errors
/// Those of `serde_json` for unknown fields and values of another type.
pub fn with_defaults<T: DeserializeOwned + Serialize + Default>(given: Value) -> serde_json::Result<T> {
    let mut settings = serde_json::to_value(T::default())?;
    overlay(&mut settings, given);
    serde_json::from_value(settings)
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
