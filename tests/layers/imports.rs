//! Which files of the crate import which, read from their text.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::{Path, PathBuf};

/// A module by the names that lead to it from the root; the root is empty.
type Module = Vec<String>;

/// The files of the crate and, for each, the files that define what it names.
pub struct Imports {
    pub files: BTreeMap<Module, PathBuf>,
    uses: BTreeMap<Module, BTreeSet<Module>>,
}

/// What a file names: paths that it uses, and names that it hands on from other files.
#[derive(Default)]
struct Names {
    used: Vec<Vec<String>>,
    handed_on: BTreeMap<String, Vec<String>>,
}

impl Imports {
    pub fn read(source: &Path) -> Self {
        let mut files = BTreeMap::new();
        collect(source, &Vec::new(), &mut files);
        let names: BTreeMap<Module, Names> = files.iter().map(|(module, file)| (module.clone(), Names::read(module, file))).collect();
        let used = |module: &Module| -> BTreeSet<Module> {
            names[module].used.iter().filter_map(|path| home(module, path, &names)).filter(|home| home != module).collect()
        };
        let uses = files.keys().map(|module| (module.clone(), used(module))).collect();
        Self { files, uses }
    }

    /// The files of the shortest circle through a file; `None` where no import leads back to it.
    pub fn circle(&self, start: &Module) -> Option<Vec<String>> {
        let mut before: BTreeMap<&Module, &Module> = BTreeMap::new();
        let mut next = VecDeque::from([start]);
        while let Some(at) = next.pop_front() {
            for to in &self.uses[at] {
                if before.contains_key(to) {
                    continue;
                }
                before.insert(to, at);
                if to == start {
                    let mut circle = vec![to];
                    while circle.len() == 1 || circle[circle.len() - 1] != start {
                        circle.push(before[circle[circle.len() - 1]]);
                    }
                    return Some(circle.iter().rev().map(|module| module.join("::")).collect());
                }
                next.push_back(to);
            }
        }
        None
    }
}

fn collect(folder: &Path, module: &Module, files: &mut BTreeMap<Module, PathBuf>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = path.file_stem().unwrap().to_str().unwrap().to_string();
        let inner = [module.clone(), vec![name.clone()]].concat();
        if path.is_dir() {
            collect(&path, &inner, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.insert(if name == "mod" || name == "lib" { module.clone() } else { inner }, path);
        }
    }
}

/// The file that defines what a path leads to: through modules, then through the names that these hand on.
fn home(from: &Module, path: &[String], files: &BTreeMap<Module, Names>) -> Option<Module> {
    let mut at = from.clone();
    let mut rest = path;
    match rest[0].as_str() {
        "crate" => (at, rest) = (Vec::new(), &rest[1..]),
        "self" => rest = &rest[1..],
        "super" => {
            while rest.first().is_some_and(|name| name == "super") {
                at.pop();
                rest = &rest[1..];
            }
        }
        name if !files.contains_key(&child(&at, name)) => return None,
        _ => {}
    }
    while let Some(name) = rest.first() {
        let inner = child(&at, name);
        if files.contains_key(&inner) {
            (at, rest) = (inner, &rest[1..]);
        } else if let Some(path) = files[&at].handed_on.get(name) {
            return home(&at, path, files);
        } else {
            break;
        }
    }
    Some(at)
}

fn child(module: &Module, name: &str) -> Module {
    [module.as_slice(), &[name.to_string()]].concat()
}

impl Names {
    fn read(module: &Module, file: &Path) -> Self {
        let text = fs::read_to_string(file).unwrap();
        let shipped = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        let code: Vec<&str> = shipped.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        let tokens = tokens(&code.join("\n"));
        let mut names = Self::default();
        let mut words = BTreeSet::new();
        let mut at = 0;
        while at < tokens.len() {
            let before = if at > 0 { tokens[at - 1].as_str() } else { "" };
            if tokens[at] == "use" {
                at += 1;
                for (path, name) in tree(&tokens, &mut at, &[]) {
                    if matches!(before, "pub" | ")") { _ = names.handed_on.insert(name, path) } else { names.used.push(path) }
                }
            } else if is_word(&tokens[at]) && !matches!(before, "::" | "." | "in") {
                let path = path(&tokens, &mut at);
                words.insert(path[0].clone());
                if path.len() > 1 {
                    names.used.push(path);
                }
            } else {
                at += 1;
            }
        }
        // A module that works with what it hands on imports it, too; the table of contents does not.
        if !module.is_empty() {
            names.used.extend(names.handed_on.iter().filter(|(name, _)| words.contains(*name)).map(|(_, path)| path.clone()));
        }
        names
    }
}

/// Words, `::`, and other characters one by one.
fn tokens(code: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let mut continues = false;
    for c in code.chars() {
        let is_part = c.is_alphanumeric() || c == '_';
        match tokens.last_mut() {
            Some(last) if continues && (is_part && is_word(last) || c == ':' && last == ":") => last.push(c),
            _ if c.is_whitespace() => {}
            _ => tokens.push(c.to_string()),
        }
        continues = !c.is_whitespace();
    }
    tokens
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphanumeric() || c == '_')
}

/// The path from a place on; the place is behind it then.
fn path(tokens: &[String], at: &mut usize) -> Vec<String> {
    let mut path = vec![tokens[*at].clone()];
    *at += 1;
    while tokens.get(*at).is_some_and(|token| token == "::") && tokens.get(*at + 1).is_some_and(|token| is_word(token)) {
        path.push(tokens[*at + 1].clone());
        *at += 2;
    }
    path
}

/// The paths of a tree of imports with the names they get.
fn tree(tokens: &[String], at: &mut usize, head: &[String]) -> Vec<(Vec<String>, String)> {
    if tokens[*at] == "{" {
        let mut paths = Vec::new();
        while tokens[*at] != "}" {
            *at += 1;
            if tokens[*at] != "}" {
                paths.extend(tree(tokens, at, head));
            }
        }
        *at += 1;
        return paths;
    }
    let path = [head, &path(tokens, at)].concat();
    match tokens[*at].as_str() {
        "::" => {
            *at += 1;
            tree(tokens, at, &path)
        }
        "as" => {
            *at += 2;
            vec![(path, tokens[*at - 1].clone())]
        }
        _ => vec![(path.clone(), path[path.len() - 1].clone())],
    }
}
