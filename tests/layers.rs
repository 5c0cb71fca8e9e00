//! Data flows one way: a module of the crate imports only modules above it, and no files import each other in a circle.

#[path = "layers/imports.rs"]
mod imports;

use imports::Imports;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The modules from the first to the last, as ARCHITECTURE.md lists them.
const ORDER: [&str; 33] = [
    "message",
    "json",
    "error",
    "text",
    "source",
    "catalogue",
    "math",
    "crs",
    "camera",
    "model",
    "image",
    "georeferenced",
    "points",
    "descriptors",
    "matching",
    "orientation",
    "two_view",
    "pair",
    "tracks",
    "adjustment",
    "reconstruction",
    "editing",
    "formats",
    "pipeline",
    "film",
    "orthophoto",
    "tables",
    "simulate",
    "html",
    "outputs",
    "epipolar_images",
    "report",
    "wasm",
];

#[test]
fn a_module_imports_only_modules_above_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let homes = homes_of_exports(&fs::read_to_string(source.join("lib.rs")).unwrap());
    assert!(homes.len() > 30, "the exports of lib.rs were not understood: {homes:?}");
    let mut wrong = Vec::new();
    let mut imports = 0;
    for (place, module) in ORDER.iter().enumerate() {
        for file in files_of(&source, module) {
            let text = fs::read_to_string(&file).unwrap();
            let shipped = text.split("#[cfg(test)]\nmod tests").next().unwrap();
            for name in names_from_the_root(shipped) {
                let home = homes.get(&name).cloned().unwrap_or(name);
                let Some(at) = ORDER.iter().position(|m| *m == home) else { panic!("{}: crate::{home} has no place", file.display()) };
                imports += 1;
                if at > place {
                    wrong.push(format!("{} imports {home}", file.display()));
                }
            }
        }
    }
    assert!(imports > 50, "only {imports} imports were found");
    assert!(wrong.is_empty(), "against the flow:\n{}", wrong.join("\n"));
}

#[test]
fn every_module_has_a_place() {
    let lib = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).unwrap();
    let declared = lib.lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'));
    // It holds the tests of this folder.
    let declared: Vec<&str> = declared.filter(|module| *module != "integration").collect();
    assert!(declared.len() == ORDER.len() && declared.iter().all(|module| ORDER.contains(module)), "{declared:?}");
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let imports = Imports::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    assert!(imports.files.len() > 200, "only {} files were found", imports.files.len());
    let circles: Vec<String> = imports.files.keys().filter_map(|module| Some(imports.circle(module)?.join(" -> "))).collect();
    assert!(circles.is_empty(), "circles:\n{}", circles.join("\n"));
}

/// For each name that lib.rs exports, the module it comes from.
fn homes_of_exports(lib: &str) -> BTreeMap<String, String> {
    let mut homes = BTreeMap::new();
    for export in lib.split("pub use ").skip(1) {
        let (module, names) = export.split(';').next().unwrap().split_once("::").unwrap();
        for name in names.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|name| !name.is_empty()) {
            homes.insert(name.to_string(), module.to_string());
        }
    }
    homes
}

/// The first name after every `crate::`, of a braced list each.
fn names_from_the_root(text: &str) -> Vec<String> {
    let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let word = |text: &str| text.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let listed = |list: &str| {
        let mut depth = 0;
        let separated: String = list
            .chars()
            .map_while(|c| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                (depth > 0).then_some(if c == ',' && depth > 1 { ' ' } else { c })
            })
            .collect();
        separated[1..].split(',').map(word).filter(|name| !name.is_empty()).collect::<Vec<_>>()
    };
    code.split("crate::").skip(1).flat_map(|rest| if rest.starts_with('{') { listed(rest) } else { vec![word(rest)] }).collect()
}

fn files_of(source: &Path, module: &str) -> Vec<PathBuf> {
    let single = source.join(format!("{module}.rs"));
    if single.exists() {
        return vec![single];
    }
    let mut files = Vec::new();
    let mut folders = vec![source.join(module)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if !entry.ends_with("tests.rs") {
                // Tests in a file of their own are not shipped either.
                files.push(entry);
            }
        }
    }
    files
}
