//! What the columns of use of a table of control points say, in the words of several programs.

use super::columns::letters;
use crate::error::refuse;
use crate::text::shorten;
use crate::{ControlRole, Error, Refusal};
use csv::StringRecord;

const CONTROL: &str = "control controlpoint groundcontrolpoint groundcontrol gcp 3dgcp passpunkt";
const CHECK: &str = "check checkpoint kontrollpunkt prüfpunkt pruefpunkt";
const OFF: &str = "off disabled unused";
/// Check points beside others that are called GCP, and control points elsewhere.
const EITHER: &str = "cp";
const YES: &str = "1 true yes on wahr ja vrai oui";
const NO: &str = "0 false no off falsch nein faux non";

/// The columns that say how points are used.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Uses {
    /// Of words: control, check or off.
    pub role: Option<usize>,
    /// Of yes and no.
    pub enabled: Option<usize>,
    /// Whether any point of the former is called a control point.
    has_control: bool,
}

impl Uses {
    /// `role`: a column that says nothing else. `kind`: one that may hold something else, and counts where any of its words is one of use; so does `enabled`.
    pub fn of(rows: &[(usize, StringRecord)], role: Option<usize>, kind: Option<usize>, enabled: Option<usize>) -> Self {
        let any = |column: &usize, lists: &[&str]| {
            rows.iter().any(|(_, record)| lists.iter().any(|list| is_in(list, record.get(*column).unwrap_or(""))))
        };
        let role = role.or(kind.filter(|column| any(column, &[CONTROL, CHECK, OFF, EITHER])));
        let has_control = role.is_some_and(|column| any(&column, &[CONTROL]));
        Self { role, enabled: enabled.filter(|column| any(column, &[YES, NO])), has_control }
    }

    /// The use of a point; none where it is off.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for another word.
    pub fn read(&self, record: &StringRecord, line: usize) -> Result<Option<ControlRole>, Error> {
        let field = |column: Option<usize>| column.and_then(|column| record.get(column)).unwrap_or("");
        let (word, enabled) = (field(self.role), field(self.enabled));
        let unknown = |word: &str| refuse(Refusal::ControlUse { word: shorten(word), line });
        let role = match () {
            () if word.is_empty() || is_in(CONTROL, word) => Some(ControlRole::Control),
            () if is_in(CHECK, word) || (is_in(EITHER, word) && self.has_control) => Some(ControlRole::Check),
            () if is_in(OFF, word) => None,
            () => return unknown(word),
        };
        match () {
            () if enabled.is_empty() || is_in(YES, enabled) => Ok(role),
            () if is_in(NO, enabled) => Ok(None),
            () => unknown(enabled),
        }
    }
}

fn is_in(list: &str, word: &str) -> bool {
    let word = letters(&word.to_lowercase());
    list.split(' ').any(|known| known == word)
}
