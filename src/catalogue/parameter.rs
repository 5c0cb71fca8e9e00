//! What is known of an option beside its value.

use super::check::refuse;
use crate::{Allowed, Error};
use serde::Serialize;

/// What values a parameter takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ParameterKind {
    /// Whole numbers from `min` to `max`; odd ones only where `odd`.
    Integer { min: f64, max: f64, odd: bool },
    /// Numbers from `min` to `max`, both included.
    Real { min: f64, max: f64 },
    /// One of these words; `labels` are their names on a page.
    Choice { values: &'static [&'static str], labels: &'static [&'static str] },
    /// Yes or no.
    Flag,
    /// Words that the check of the option itself reads.
    Text,
}

/// Options that stand in one object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Group {
    /// Where it stands in the whole, as `features.multiscale`; empty for the whole itself.
    pub path: &'static str,
    pub parameters: &'static [Parameter],
}

impl Group {
    /// Where a parameter of the group stands in the whole, as `features.multiscale.number`.
    pub fn path_of(&self, parameter: &Parameter) -> String {
        if self.path.is_empty() { parameter.field().into() } else { format!("{}.{}", self.path, parameter.field()) }
    }
}

/// One option.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// What messages call it, `group.field`; where it stands in an object, [`Group::path_of`] says.
    pub key: &'static str,
    /// The heading under which it stands.
    pub section: &'static str,
    pub label: &'static str,
    /// Empty where it has none.
    pub unit: &'static str,
    #[serde(flatten)]
    pub kind: ParameterKind,
    /// What it does, and what changes when it grows.
    pub help: &'static str,
    /// What holds where it is absent, in words; empty where it is never absent.
    pub absent: &'static str,
    /// When it has an effect, as `group.field is value, value`, joined by `and` and `or`; empty: always.
    pub acts: &'static str,
    /// Its name in the command where that is not the field's; empty otherwise.
    pub named: &'static str,
}

impl Parameter {
    /// What it allows.
    pub fn allowed(&self) -> Allowed {
        match self.kind {
            ParameterKind::Integer { min, max, odd } => Allowed::Integer { min, max, odd },
            ParameterKind::Real { min, max } => Allowed::Real { min, max },
            ParameterKind::Choice { values, .. } => Allowed::Words { words: values.join(", ") },
            ParameterKind::Flag => Allowed::Flag,
            ParameterKind::Text => Allowed::Text,
        }
    }

    /// The name of its field.
    pub fn field(&self) -> &'static str {
        self.key.rsplit_once('.').map_or(self.key, |(_, field)| field)
    }

    /// Whether it may be absent where all others are given.
    pub(crate) fn is_optional(&self) -> bool {
        !self.absent.is_empty()
    }

    /// The error of a value that it does not allow.
    pub(crate) fn refused(&self, got: impl ToString) -> Error {
        refuse(self.key, got, self.allowed())
    }

    /// Rejects a number outside the range.
    pub(crate) fn check(&self, value: f64) -> Result<(), Error> {
        let within = match self.kind {
            ParameterKind::Integer { min, max, odd } => {
                value.fract() == 0.0 && value >= min && value <= max && (!odd || value % 2.0 == 1.0)
            }
            ParameterKind::Real { min, max } => value >= min && value <= max,
            ParameterKind::Choice { .. } | ParameterKind::Flag | ParameterKind::Text => true,
        };
        if within { Ok(()) } else { Err(self.refused(value)) }
    }
}

/// Rejects a number outside the range of the parameter of that key.
pub(crate) fn check(parameters: &'static [Parameter], key: &'static str, value: f64) -> Result<(), Error> {
    parameters.iter().filter(|p| p.key == key).try_for_each(|p| p.check(value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PairSettings, Texts};

    /// The command and the page write a range from the parameter itself, as `allowed` is written.
    #[test]
    fn a_parameter_is_written_as_what_it_allows() {
        let mut kinds = [0; 3];
        for parameter in PairSettings::parameters() {
            let k = match parameter.kind {
                ParameterKind::Integer { odd: true, .. } => 0,
                ParameterKind::Integer { .. } => 1,
                ParameterKind::Real { .. } => 2,
                _ => continue,
            };
            kinds[k] += 1;
            let written = Texts::english().text_of("allowed", &serde_json::to_value(parameter).unwrap(), None);
            assert_eq!(written, parameter.allowed().to_string(), "{}", parameter.key);
        }
        assert!(kinds.iter().all(|count| *count > 2), "{kinds:?}");
        let text = |key: &str| PairSettings::parameters().find(|p| p.key == key).map(|p| p.allowed().to_string());
        assert_eq!(text("matching.search").as_deref(), Some("odd whole numbers from 1 to 1023"));
        assert_eq!(text("orientation.sigma0_mm").as_deref(), Some("0.0000001 to 100"));
        assert_eq!(text("orientation.seed").as_deref(), Some("whole numbers from 0 to 4294967295"));
    }
}
