//! Adjustments repeated from the exported files alone, by other code: what these files hold is enough for another program.

#[path = "repeated/block.rs"]
mod block;
#[path = "repeated/equations.rs"]
mod equations;
#[path = "repeated/inner.rs"]
mod inner;
#[path = "repeated/pair.rs"]
mod pair;
#[path = "repeated/rotation.rs"]
mod rotation;

use serde_json::Value;

/// A number of an exported file.
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Some numbers of an exported file.
fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|k| number(&value[k]))
}

/// The items of a list, which a file may leave out where it is empty.
fn items(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// The largest difference of what was found from what is exported, in standard errors.
fn farthest(found: &[f64], exported: &[f64], errors: &[f64]) -> f64 {
    assert_eq!((found.len(), found.len()), (exported.len(), errors.len()));
    (0..found.len()).map(|k| (found[k] - exported[k]).abs() / errors[k]).fold(0.0, f64::max)
}

/// The largest difference of what was found from what is exported, as a share of it.
fn largest_share(found: &[f64], exported: &[f64]) -> f64 {
    farthest(found, exported, exported)
}
