//! What people read stands in the catalogue: errors hold figures and names, no sentences; reports say texts by their names.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Messages that errors are made of.
const FAMILIES: [&str; 17] = [
    "Allowed",
    "Damage",
    "DescribedBy",
    "Document",
    "Error",
    "Few",
    "FileFault",
    "FilePlace",
    "ImageFault",
    "Interruption",
    "JsonFault",
    "Location",
    "NoOrientation",
    "PointName",
    "Refusal",
    "Remark",
    "Unsupported",
];

/// The kind of errors that the boundary to JavaScript words itself.
const WORDED: &str = "Error::InvalidArgument {";

#[test]
fn errors_hold_no_sentences() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut made, mut wrong) = (0, Vec::new());
    for file in files(&source) {
        let text = fs::read_to_string(&file).unwrap();
        let shipped = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        let is_boundary = file.strip_prefix(&source).is_ok_and(|path| path.starts_with("wasm") || path.starts_with("error"));
        let messages: Vec<&str> = messages(shipped).into_iter().filter(|m| !(is_boundary && m.starts_with(WORDED))).collect();
        made += messages.len();
        wrong.extend(messages.into_iter().filter(|m| !literals(m).iter().all(|literal| is_figure(literal))).map(|m| at(&file, m)));
        if !is_boundary && shipped.contains(WORDED) {
            wrong.push(at(&file, WORDED));
        }
    }
    assert!(made > 150, "only {made} messages were found");
    assert!(wrong.is_empty(), "English in code, whose place is the catalogue:\n{}", wrong.join("\n"));
}

/// Where reports are written.
const REPORTS: [&str; 3] = ["html", "outputs/report", "report"];

/// What only the program reads: classes and places of a page, families of messages, ways of the paper, values of what the catalogue says.
const NOT_READ: [&str; 19] = [
    "data:image/png;base64,{}",
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'",
    "correlation",
    "dot",
    "dot matched",
    "dot rejected",
    "least-squares",
    "left-image",
    "moments",
    "negative",
    "outline",
    "outline faint",
    "positive",
    "report_step",
    "right-image",
    "rotate({:.2})",
    "rtl",
    "vector",
    "vector rejected",
];

#[test]
fn reports_say_texts_of_the_catalogue_and_no_others() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let catalogue = fs::read_to_string(source.join("catalogue/en-report.ftl")).unwrap();
    let names = catalogue.lines().filter(|line| line.starts_with("report-")).filter_map(|line| line.split_once(" ="));
    let written: BTreeSet<&str> = names.map(|(name, _)| name).collect();
    let (mut named, mut wrong, mut not_read) = (BTreeSet::new(), Vec::new(), BTreeSet::new());
    for file in REPORTS.iter().flat_map(|folder| files(&source.join(folder))) {
        let text = fs::read_to_string(&file).unwrap();
        let code = without_comments(text.split("#[cfg(test)]\nmod tests").next().unwrap());
        for found in said(&code).into_iter().filter(|literal| !is_for_the_page(literal)) {
            let is_figure = catalogue.contains(&format!("${} }}", found.text)) || catalogue.contains(&format!(".{} =", found.text));
            match found.text.strip_suffix("{}").unwrap_or(found.text) {
                name if name.starts_with("report-") => {
                    let of: Vec<&str> =
                        written.iter().copied().filter(|text| *text == name || (name != found.text && text.starts_with(name))).collect();
                    if of.is_empty() {
                        wrong.push(at(&file, found.text));
                    }
                    named.extend(of);
                }
                _ if NOT_READ.contains(&found.text) => drop(not_read.insert(found.text.to_string())),
                _ if has_word(found.text) && !is_figure => wrong.push(at(&file, found.text)),
                _ => {}
            }
        }
    }
    assert!(wrong.is_empty(), "in the code of reports:\n{}", wrong.join("\n"));
    assert_eq!(written.difference(&named).collect::<Vec<_>>(), [&""; 0], "texts that no report says");
    assert_eq!(not_read.len(), NOT_READ.len(), "exceptions that nothing needs: {not_read:?}");
}

#[test]
fn a_word_of_a_report_is_found_wherever_it_stands() {
    for planted in
        ["h2 { \"Residuals\" }", "p { (count(n)) \" of all\" }", "format!(\"{} points\", n)", "let words = \"in all images\".to_string();"]
    {
        assert!(said(planted).iter().any(|literal| !is_for_the_page(literal) && has_word(literal.text)), "{planted}");
    }
    for other in
        ["svg role=\"img\" x=(format!(\"translate({x})\")) {}", ".expect(\"settings are plain data\")", "\"M{x:.1} {y:.1}h0\"", "\"σ dX\""]
    {
        assert!(said(other).iter().all(|literal| is_for_the_page(literal) || !has_word(literal.text)), "{other}");
    }
}

/// A text between quotation marks, with the code before it.
struct Literal<'a> {
    before: &'a str,
    text: &'a str,
}

fn said(code: &str) -> Vec<Literal<'_>> {
    let place = |text: &str| text.as_ptr() as usize - code.as_ptr() as usize - 1;
    literals(code).into_iter().map(|text| Literal { before: &code[..place(text)], text }).collect()
}

/// The value of an attribute, the name of a file or a variable, what a panic says.
fn is_for_the_page(literal: &Literal<'_>) -> bool {
    ["=", "=(format!(", "include_str!(", "env!(", ".expect("].iter().any(|end| literal.before.ends_with(end))
        && !literal.before.ends_with(" =")
}

/// Whether a text has a word, not only symbols, units and names of every language.
fn has_word(text: &str) -> bool {
    let mut depth = 0;
    let plain: String = text
        .chars()
        .map(|c| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            if depth > 0 { ' ' } else { c }
        })
        .collect();
    plain.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() > 2 && word != "RMSE")
}

/// Code without its comments and attributes.
fn without_comments(code: &str) -> String {
    code.lines().filter(|line| !["//", "#["].iter().any(|start| line.trim_start().starts_with(start))).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_sentence_is_found() {
    let planted = r#"return refuse(Refusal::Degrees { place: Some(Location::Pair), got: format!("{} px of \"{name}\"", f({ 2 })) });"#;
    let [message] = messages(planted)[..] else { panic!("{:?}", messages(planted)) };
    assert_eq!(literals(message), [r#"{} px of \"{name}\""#]);
    assert!(!is_figure("{} px of {name}") && !is_figure("none") && is_figure("{:?}") && is_figure("({x}, {y:.2}) ×"));
    assert!(messages("enum Refusal { Degrees }").is_empty());
}

/// The messages with figures that a text makes, each from its name to its last brace.
fn messages(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (start, _) in FAMILIES.iter().flat_map(|family| text.match_indices(family)) {
        let kind = text[start..].split_once("::").map_or("", |(_, kind)| kind);
        let is_named = text[start..].split("::").next().is_some_and(|family| FAMILIES.contains(&family));
        let name: String = kind.chars().take_while(|c| c.is_alphanumeric()).collect();
        if is_named && !name.is_empty() && kind[name.len()..].starts_with(" {") {
            let open = text.len() - kind.len() + name.len() + 1;
            let mut depth = 0;
            let end = text[open..].char_indices().find(|(_, c)| {
                depth += i32::from(*c == '{') - i32::from(*c == '}');
                depth == 0
            });
            found.push(&text[start..end.map_or(text.len(), |(at, _)| open + at + 1)]);
        }
    }
    found
}

/// The texts between quotation marks.
fn literals(code: &str) -> Vec<&str> {
    let (mut found, mut start, mut is_escaped) = (Vec::new(), None, false);
    for (at, c) in code.char_indices() {
        match (c, start) {
            ('"', None) => start = Some(at + 1),
            ('"', Some(from)) if !is_escaped => {
                found.push(&code[from..at]);
                start = None;
            }
            _ => {}
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    found
}

/// Whether a text is of figures alone: it has no letters outside braces.
fn is_figure(literal: &str) -> bool {
    let mut depth = 0;
    literal.chars().all(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth > 0 || !c.is_alphabetic()
    })
}

fn at(file: &Path, found: &str) -> String {
    format!("{}: {}", file.display(), found.lines().next().unwrap_or(""))
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect();
    found.retain(|path| path.extension().is_some_and(|ending| ending == "rs"));
    found.sort();
    found
}
