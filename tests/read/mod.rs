//! What people read in a report, and which of it is English.

/// Words of every language: names of programs, files and systems.
const NAMES: [&str; 5] = ["GNSS", "RMSE", "Tiepoint", "XMP", "EXIF"];

/// The texts of a page and what is read out of its drawings, without keys and values of options.
pub fn texts(html: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_hidden = false;
    for part in html.split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap_or((part, ""));
        let name = tag.split(' ').next().unwrap();
        // The value of an option stands behind its key, up to the end of the row.
        is_hidden = (is_hidden && !matches!(name, "/tr" | "/style")) || matches!(name, "style" | "code");
        found.extend(tag.split("aria-label=\"").nth(1).map(|label| plain(label.split('"').next().unwrap())));
        if !is_hidden && !text.trim().is_empty() {
            found.push(plain(text));
        }
    }
    found
}

fn plain(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

/// Texts of a page with a word in Latin letters that is no symbol, no name and no file.
pub fn english(html: &str, names: &[&str]) -> Vec<String> {
    let is_file = |word: &str| word.split('.').nth(1).is_some_and(|ending| ending.starts_with(|c: char| c.is_ascii_lowercase()));
    let is_english = |text: &String| {
        let own = names.iter().fold(text.clone(), |text, name| text.replace(name, ""));
        own.split_whitespace().filter(|word| !is_file(word)).any(|word| {
            let mut words = word.split(|c: char| !c.is_ascii_alphabetic());
            words.any(|word| word.len() > 2 && !NAMES.contains(&word))
        })
    };
    texts(html).into_iter().filter(is_english).collect()
}

/// Refuses a report that is not Arabic from its first letter to its last, beside these names.
pub fn assert_arabic(html: &str, names: &[&str]) {
    assert!(html.starts_with("<!DOCTYPE html><html lang=\"ar\" dir=\"rtl\">"), "{}", &html[..60]);
    assert!(texts(html).len() > 50, "{}", texts(html).len());
    assert_eq!(english(html, names), [""; 0]);
}
