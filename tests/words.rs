//! What people read stands in the catalogue: errors hold figures and names, no sentences.

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
