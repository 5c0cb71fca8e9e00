//! The folder of a block on a disk: its lock, and files that are written whole or not at all. The command does both in the same way, so that
//! neither works on a folder that the other works on.

use crate::{Document, Error, FileFault, FilePlace};
use std::collections::BTreeSet;
use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, id};
use std::sync::{Mutex, PoisonError};

/// Its content is `process N on HOST`.
const LOCK: &str = "lock.txt";

/// The locks that this process holds: another process that ended may have had its number.
static HELD: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A folder that no other process works on; given back when it is dropped.
#[derive(Debug)]
pub(super) struct FolderLock(LockFile);

#[derive(Debug)]
struct LockFile {
    path: PathBuf,
    /// Its content where this process has the folder.
    own: String,
}

impl FolderLock {
    /// Takes a folder, which is made where it is missing. The lock of a process that does not run any more is taken over.
    ///
    /// # Errors
    /// [`Error::UnreadableFile`] for a folder that is in use or cannot be written to.
    pub(super) fn take(folder: &Path) -> Result<Self, Error> {
        fs::create_dir_all(folder).map_err(|error| system(folder, &error))?;
        let host = host_name();
        let lock = LockFile { path: folder.join(LOCK), own: format!("process {} on {host}\n", id()) };
        let taken = || lock.put().map_err(|error| system(&lock.path, &error));
        if !taken()? {
            let other = fs::read_to_string(&lock.path).unwrap_or_default();
            // Whether a process of another machine runs is not known here.
            let left = owner(&other).is_some_and(|(pid, of)| of == host && !lock.runs(pid));
            if !left || !lock.removed(&other) || !taken()? {
                let owner = fs::read_to_string(&lock.path).unwrap_or(other).trim().to_string();
                let file_place = Some(FilePlace::Path { path: folder.display().to_string() });
                return Err(Error::UnreadableFile { document: Document::Folder, file_place, file_fault: FileFault::InUse { owner } });
            }
        }
        held().insert(lock.path.clone());
        Ok(Self(lock))
    }
}

impl LockFile {
    /// Makes the lock with its content at once; false where there is one.
    fn put(&self) -> std::io::Result<bool> {
        let draft = self.path.with_extension(format!("txt.{}", id()));
        fs::write(&draft, &self.own)?;
        let linked = match fs::hard_link(&draft, &self.path) {
            // Some disks of cameras and sticks have no links: then the file may be seen before its content is there.
            Err(error) if error.kind() != ErrorKind::AlreadyExists => {
                fs::File::create_new(&self.path).and_then(|mut file| file.write_all(self.own.as_bytes()))
            }
            linked => linked,
        };
        let _ = fs::remove_file(&draft);
        match linked {
            Ok(()) => Ok(true),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(false),
            Err(error) => Err(error),
        }
    }

    fn runs(&self, pid: u32) -> bool {
        if pid == id() { held().contains(&self.path) } else { is_running(pid) }
    }

    /// Removes the lock if it still is the one that was read: a third process may have taken it over first.
    fn removed(&self, content: &str) -> bool {
        let aside = self.path.with_extension(format!("txt.left-{}", id()));
        if fs::rename(&self.path, &aside).is_err() {
            return false;
        }
        if fs::read_to_string(&aside).is_ok_and(|found| found == content) {
            return fs::remove_file(&aside).is_ok();
        }
        let _ = fs::rename(&aside, &self.path);
        false
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        let Self(LockFile { path, own }) = self;
        held().remove(path);
        if fs::read_to_string(&path).is_ok_and(|content| content == *own) {
            let _ = fs::remove_file(path);
        }
    }
}

fn held() -> std::sync::MutexGuard<'static, BTreeSet<PathBuf>> {
    HELD.lock().unwrap_or_else(PoisonError::into_inner)
}

fn system(path: &Path, error: &std::io::Error) -> Error {
    let file_fault = FileFault::System { message: error.to_string() };
    let file_place = Some(FilePlace::Path { path: path.display().to_string() });
    Error::UnreadableFile { document: Document::Folder, file_place, file_fault }
}

fn owner(content: &str) -> Option<(u32, &str)> {
    let (pid, host) = content.strip_prefix("process ")?.strip_suffix('\n')?.split_once(" on ")?;
    Some((pid.parse().ok()?, host))
}

/// As the system itself says; empty where it does not.
fn host_name() -> String {
    let named = fs::read_to_string("/proc/sys/kernel/hostname").ok();
    let asked = || Command::new("hostname").output().ok().map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    named.or_else(asked).unwrap_or_default().trim().to_string()
}

/// Where that cannot be found out it is taken to run.
fn is_running(pid: u32) -> bool {
    if Path::new("/proc/self").exists() {
        return Path::new("/proc").join(pid.to_string()).exists();
    }
    Command::new("kill").args(["-0", &pid.to_string()]).status().map_or(true, |status| status.success())
}

/// Writes a file whole or not at all, whatever ends the program or the machine; folders above it are made.
///
/// # Errors
/// [`Error::NotWritten`].
pub fn replace_file(path: &Path, content: &[u8]) -> Result<(), Error> {
    replace(path, content, true).map_err(|_| Error::NotWritten { document: Document::File })
}

/// Under another name first. `flushed`: waits for the disk; what holds a checksum need not, since a torn file is noticed.
pub(super) fn replace(path: &Path, content: &[u8], flushed: bool) -> std::io::Result<()> {
    static DRAFTS: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let number = DRAFTS.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    // As the command names them, which removes those that an ended process has left.
    let draft = folder.join(format!("{number}.tiepoint-{}.part", id()));
    let written = fs::File::create(&draft).and_then(|mut file| {
        file.write_all(content)?;
        if flushed { file.sync_all() } else { Ok(()) }
    });
    let renamed = written.and_then(|()| fs::rename(&draft, path));
    if renamed.is_err() {
        let _ = fs::remove_file(&draft);
    }
    renamed?;
    match fs::File::open(folder) {
        // Some systems open no folder, and some do this for none.
        Ok(folder) if flushed => folder.sync_all().or(Ok(())),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("tiepoint-{name}-{}", id()));
        let _ = fs::remove_dir_all(&path);
        path
    }

    #[test]
    fn a_folder_is_taken_once_and_given_back() {
        let at = folder("taken");
        let lock = FolderLock::take(&at).unwrap();
        let text = fs::read_to_string(at.join(LOCK)).unwrap();
        assert_eq!(text, format!("process {} on {}\n", id(), host_name()));
        let refused = FolderLock::take(&at).unwrap_err();
        assert!(
            matches!(&refused, Error::UnreadableFile { file_fault: FileFault::InUse { owner }, .. } if *owner == text.trim()),
            "{refused}"
        );
        // A refused run gives nothing back.
        assert!(at.join(LOCK).exists());
        drop(lock);
        assert_eq!(fs::read_dir(&at).unwrap().count(), 0);
        drop(FolderLock::take(&at).unwrap());
        fs::remove_dir_all(&at).unwrap();
    }

    #[test]
    fn the_lock_of_a_process_that_ended_is_taken_over_and_that_of_another_machine_is_not() {
        let at = folder("left");
        fs::create_dir_all(&at).unwrap();
        let host = host_name();
        for (content, is_taken) in [
            (format!("process {} on {host}\n", u32::MAX), true),
            (format!("process {} on {host}\n", id()), true),
            (format!("process {} on another\n", u32::MAX), false),
            ("unknown".to_string(), false),
        ] {
            fs::write(at.join(LOCK), &content).unwrap();
            assert_eq!(FolderLock::take(&at).is_ok(), is_taken, "{content}");
        }
        assert_eq!(fs::read_to_string(at.join(LOCK)).unwrap(), "unknown");
        fs::remove_dir_all(&at).unwrap();
    }

    #[test]
    fn a_file_is_replaced_and_no_draft_is_left() {
        let at = folder("replaced");
        let path = at.join("csv").join("points.csv");
        for text in ["one", "another"] {
            replace_file(&path, text.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        assert_eq!(fs::read_dir(at.join("csv")).unwrap().count(), 1);
        fs::create_dir(at.join("folder")).unwrap();
        assert_eq!(replace_file(&at.join("folder"), b"in the way"), Err(Error::NotWritten { document: Document::File }));
        assert_eq!(fs::read_dir(&at).unwrap().count(), 2);
        fs::remove_dir_all(&at).unwrap();
    }
}
