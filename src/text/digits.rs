//! Numbers in other digits than those of ASCII.

use std::borrow::Cow;

/// A number in Arabic or Persian digits, or with the minus of typographers, as ASCII has it; any other text as it is.
pub(super) fn in_ascii(cell: &str) -> Cow<'_, str> {
    let plain = |sign: char| match sign {
        '0'..='9' | '.' | ',' | '+' | '-' => Some(sign),
        '٠'..='٩' => char::from_digit(sign as u32 - '٠' as u32, 10),
        '۰'..='۹' => char::from_digit(sign as u32 - '۰' as u32, 10),
        '٫' => Some('.'),
        '−' => Some('-'),
        _ => None,
    };
    let number = Some(cell).filter(|cell| !cell.is_ascii()).and_then(|cell| cell.chars().map(plain).collect::<Option<String>>());
    number.map_or(Cow::Borrowed(cell), Cow::Owned)
}
