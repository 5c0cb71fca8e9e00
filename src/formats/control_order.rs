//! What the columns of a table of control points hold that nothing names: by their order and their numbers.

use super::whole_numbers::{LEAST_FIGURES, has_leading_zero};
use crate::error::refuse;
use crate::text::{Records, filled, shorten};
use crate::{Error, Input, Refusal};
use csv::StringRecord;

/// Largest standard error that is told from a coordinate, in m.
const MOST_ERROR_M: f64 = 10.0;
/// Where a code stands.
const CODE: usize = 4;
/// Numbers of a point with the standard errors of its place and its height, and with those of all three coordinates.
const WITH_TWO: usize = 5;
const WITH_THREE: usize = 6;

/// The columns of standard errors behind `name, x, y, z`: of the place, which are one or those of x and y, and of the height; none where a code stands there.
///
/// # Errors
/// [`Error::InvalidInput`] for more numbers, for one alone that is no code, and for those that may be parts of others with decimal commas.
pub(super) fn errors_in_order(records: &Records) -> Result<Option<([usize; 2], usize)>, Error> {
    let mut most = 0;
    for (line, record) in &records.rows {
        let numbers: Vec<&str> = record.iter().skip(1).take_while(|field| records.number(field).is_some()).collect();
        let refused = |refusal: fn(String, usize, usize) -> Refusal| refuse(refusal(records.shown(record), numbers.len(), *line));
        let of_errors: Vec<f64> = numbers.iter().skip(3).filter_map(|field| records.number(field)).collect();
        let are_small = of_errors.iter().all(|error| *error > 0.0 && *error <= MOST_ERROR_M);
        if numbers.len() > WITH_THREE || (numbers.len() == WITH_THREE && (!are_small || records.may_be_cut(&numbers))) {
            return refused(|record, numbers, line| Refusal::ControlNumbers { record, numbers, line, most_m: MOST_ERROR_M });
        }
        let may_be_figures = numbers.len() == WITH_TWO && numbers.iter().skip(3).any(|field| is_large(records, field));
        if records.may_be_cut(&numbers) && (may_be_figures || numbers.iter().any(|field| has_leading_zero(field))) {
            return refused(|record, _, line| Refusal::DecimalCommas { input: Input::ControlTable, record, line });
        }
        // Other numbers than standard errors may follow, as those of a time or of satellites.
        let are_beyond = of_errors.iter().any(|error| error.abs() > MOST_ERROR_M);
        if numbers.len() == WITH_TWO && are_beyond {
            return refused(|record, numbers, line| Refusal::ControlNumbers { record, numbers, line, most_m: MOST_ERROR_M });
        }
        // A name with a blank in it shifts what stands behind it.
        if records.has_blanks() && numbers.len() > 3 && !are_small {
            return refused(|record, numbers, line| Refusal::ControlNumbers { record, numbers, line, most_m: MOST_ERROR_M });
        }
        most = most.max(numbers.len());
    }
    if most == WITH_THREE {
        return Ok(Some(([4, 5], 6)));
    }
    if has_code(records) {
        return Ok(None);
    }
    check_lone(records)?;
    Ok(Some(([4, 4], 5)))
}

fn is_large(records: &Records, field: &str) -> bool {
    records.number(field).is_some_and(|number| number >= LEAST_FIGURES)
}

/// Words directly behind the coordinates, and behind them no numbers, are codes or remarks; so are whole numbers in the last column that are no halves of
/// coordinates.
fn has_code(records: &Records) -> bool {
    let field = |record: &'_ StringRecord, column: usize| record.get(column).unwrap_or("").to_string();
    let is_number = |field: &str| records.number(field).is_some();
    let is_word = |record: &StringRecord| !is_number(&field(record, CODE)) && !record.iter().skip(CODE + 1).any(is_number);
    let is_whole = |record: &StringRecord| {
        let coordinates: Vec<&str> = record.iter().skip(1).take(3).collect();
        filled(record) == CODE + 1 && field(record, CODE).parse::<u64>().is_ok() && !records.may_be_cut(&coordinates)
    };
    let has_any = records.rows.iter().any(|(_, record)| !field(record, CODE).is_empty());
    has_any && records.rows.iter().all(|(_, record)| is_word(record) || is_whole(record))
}

/// Refuses one number behind the coordinates, in the last column, that is no code.
fn check_lone(records: &Records) -> Result<(), Error> {
    let is_lone = |record: &StringRecord| filled(record) == CODE + 1 && record.iter().skip(1).all(|field| records.number(field).is_some());
    let Some((line, record)) = records.rows.iter().find(|(_, record)| is_lone(record)) else { return Ok(()) };
    refuse(Refusal::ControlLoneError { word: shorten(record.get(CODE).unwrap_or("")), line: *line })
}
