//! What stands between the fields of a table.

/// Fields that a table has at least, wherever one is read here; a line with as many is no title.
const LEAST_FIELDS: usize = 4;
/// Lines among which the first such one is looked for.
const LOOKED_AT: usize = 10;
/// Numbers with decimal commas that show that blanks separate.
const LEAST_DECIMAL_COMMAS: usize = 2;

/// A line that is neither blank nor begins with `#`.
pub(super) fn is_data(line: &str) -> bool {
    !line.trim().is_empty() && !line.starts_with('#')
}

/// Semicolon, tab, comma or blank, as the first line has it that has fields enough for a table; else as the first line has it. `//` may begin a comment.
pub(super) fn separator(text: &str) -> u8 {
    let lines = |with_slashes: bool| text.lines().filter(move |line| is_data(line) && (with_slashes || !line.starts_with("//")));
    let with_slashes = lines(false).next().is_none();
    let of_lines = || lines(with_slashes).take(LOOKED_AT).map(|line| (of_line(line), line));
    let is_wide = |(separator, line): &(u8, &str)| *separator != b' ' && line.split(char::from(*separator)).count() >= LEAST_FIELDS;
    // A place without a height is a name and two numbers.
    let is_number = |word: &str| word.replace(',', ".").parse::<f64>().is_ok();
    let is_place = |line: &str| line.split_whitespace().count() == 3 && line.split_whitespace().skip(1).all(is_number);
    let is_blank =
        |(separator, line): &(u8, &str)| *separator == b' ' && (line.split_whitespace().count() >= LEAST_FIELDS || is_place(line));
    let found = of_lines().find(is_wide).or_else(|| of_lines().find(is_blank)).or_else(|| of_lines().next().filter(|(is, _)| *is != b' '));
    found.map_or(b',', |(separator, _)| separator)
}

/// Semicolons, tabs or commas, whichever of them a line has, in this order; else blanks. Tabs beside commas only align what these separate.
pub(super) fn of_line(line: &str) -> u8 {
    let mut parts = line.split('\t').map(str::trim).peekable();
    let mut is_aligned = false;
    while let (Some(part), Some(next)) = (parts.next(), parts.peek()) {
        is_aligned |= part.ends_with(',') || next.starts_with(',');
    }
    match () {
        () if line.contains(';') => b';',
        () if line.contains('\t') && !is_aligned => b'\t',
        () if line.contains(',') && !has_decimal_commas(line) => b',',
        () => b' ',
    }
}

/// Whether all commas of a line are those of numbers between blanks.
fn has_decimal_commas(line: &str) -> bool {
    let words: Vec<&str> = line.split_whitespace().collect();
    let with_commas = || words.iter().filter(|word| word.contains(','));
    words.len() > LEAST_DECIMAL_COMMAS && with_commas().count() >= LEAST_DECIMAL_COMMAS && with_commas().all(|word| is_decimal_comma(word))
}

/// A number with one comma between its figures, and no point.
pub(super) fn is_decimal_comma(field: &str) -> bool {
    let unsigned = field.strip_prefix(['-', '+']).unwrap_or(field);
    let is_figures = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    unsigned.split_once(',').is_some_and(|(whole, fraction)| is_figures(whole) && is_figures(fraction))
}

/// Whether the comma of such a number cannot stand before thousands.
pub(super) fn is_clearly_decimal(field: &str) -> bool {
    let unsigned = field.strip_prefix(['-', '+']).unwrap_or(field);
    let is_thousands = |whole: &str, fraction: &str| whole.len() <= 3 && fraction.len() == 3 && !whole.starts_with('0');
    is_decimal_comma(field) && unsigned.split_once(',').is_some_and(|(whole, fraction)| !is_thousands(whole, fraction))
}

/// A number with signs before thousands, as `446.833,25`, `446 833,25` or `2'600'000.12`.
pub(super) fn has_thousands(field: &str) -> bool {
    let unsigned = field.strip_prefix(['-', '+']).unwrap_or(field);
    let is_figures = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let Some(sign) = unsigned.chars().find(|sign| !sign.is_ascii_digit()).filter(|sign| ".,'’ \u{a0}\u{202f}".contains(*sign)) else {
        return false;
    };
    let mut groups: Vec<&str> = unsigned.split(sign).collect();
    let last = groups.pop().unwrap_or("");
    let last = last.split_once(['.', ',']).map_or(Some(last), |(whole, fraction)| Some(whole).filter(|_| is_figures(fraction)));
    let first = groups.first().copied().unwrap_or("");
    let are_threes = groups.iter().skip(1).copied().chain(last).all(|group| group.len() == 3 && is_figures(group));
    last.is_some() && are_threes && first.len() <= 3 && is_figures(first)
}
