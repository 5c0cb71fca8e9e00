//! Gives the crate a digest of its own sources, which is part of the key of every record that a run keeps, and says whether the integration tests
//! lie beside it: a package is without them.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!("cargo::rerun-if-changed=src");
    println!("cargo::rerun-if-changed=Cargo.lock");
    println!("cargo::rustc-env=TIEPOINT_BUILD={}", digest_of(&root)?);
    println!("cargo::rustc-check-cfg=cfg(integration)");
    if root.join("tests/integration.rs").exists() {
        println!("cargo::rustc-cfg=integration");
    }
    Ok(())
}

/// SHA-256 in hexadecimal digits of the sources below `root` and of the versions of the libraries, where they are stated.
pub fn digest_of(root: &Path) -> io::Result<String> {
    let mut files = Vec::new();
    let mut folders = vec![root.join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    files.extend(Some(root.join("Cargo.lock")).filter(|lock| lock.exists()));
    // Names with slashes, so that every system has the same order.
    let name = |path: &PathBuf| path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
    let mut named: Vec<(String, PathBuf)> = files.into_iter().map(|path| (name(&path), path)).collect();
    named.sort();
    let mut hash = Sha256::new();
    for (name, path) in named {
        let content = fs::read(path)?;
        for part in [name.as_bytes(), &content] {
            hash.update((part.len() as u64).to_le_bytes());
            hash.update(part);
        }
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}
