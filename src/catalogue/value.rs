//! What types an option may have, and what each says of its parameter.

use super::parameter::ParameterKind;

/// The kind of a parameter, but for its range.
#[derive(Clone, Copy)]
pub(crate) enum Form {
    Integer,
    Real,
    Flag,
    Text,
    Choice { values: &'static [&'static str], labels: &'static [&'static str] },
}

/// The value of an option.
pub(crate) trait OptionValue {
    const FORM: Form;

    /// The number that is compared with the range; none where it is absent or no number.
    fn number(&self) -> Option<f64> {
        None
    }
}

impl OptionValue for bool {
    const FORM: Form = Form::Flag;
}

impl OptionValue for String {
    const FORM: Form = Form::Text;
}

macro_rules! numbers {
    ($($number:ty: $form:ident),+) => {
        $(impl OptionValue for $number {
            const FORM: Form = Form::$form;

            fn number(&self) -> Option<f64> {
                Some(*self as f64)
            }
        })+
    };
}
numbers!(usize: Integer, u32: Integer, f64: Real);

impl<T: OptionValue> OptionValue for Option<T> {
    const FORM: Form = T::FORM;

    fn number(&self) -> Option<f64> {
        self.as_ref().and_then(T::number)
    }
}

/// The kind of a parameter of this form; `range` is the least value, the greatest, and whether it is odd.
pub(crate) const fn kind(form: Form, range: (f64, f64, bool)) -> ParameterKind {
    let (min, max, odd) = range;
    match form {
        Form::Integer => ParameterKind::Integer { min, max, odd },
        Form::Real => ParameterKind::Real { min, max },
        Form::Flag => ParameterKind::Flag,
        Form::Text => ParameterKind::Text,
        Form::Choice { values, labels } => ParameterKind::Choice { values, labels },
    }
}
