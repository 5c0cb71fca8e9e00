//! The run of a block on this machine: threads that do its jobs, and a folder that keeps its records.

use super::folder::{FolderLock, replace};
use super::records::digest;
use super::{BlockRun, FileNeeded, Job, News, Run, RunInput, execute};
use crate::text::by_numbers;
use crate::{Document, Error, Failure, FileFault, FilePlace, Interruption};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Condvar, Mutex};

/// Endings of the files that are taken for images.
const ENDINGS: [&str; 10] = ["jpg", "jpeg", "png", "tif", "tiff", "bmp", "webp", "pgm", "ppm", "pnm"];

/// The images of a folder, in the order of their letters and of the numbers in them.
///
/// # Errors
/// [`Error::UnreadableFile`] for a folder that cannot be read.
pub fn images_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let unreadable = |error: std::io::Error| unreadable(Document::Folder, folder, &error);
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let is_image = path.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)));
        if is_image && path.is_file() {
            found.push(path);
        }
    }
    found.sort_by(|a, b| by_numbers(&name_of(a), &name_of(b)));
    Ok(found)
}

/// Runs a block of image files, with masks perhaps, on so many threads; `options.images` and `options.masks` are taken from the names of
/// the files, and `options.geoid` is the path of one. What an earlier run has kept in the folder `kept` is not done again; the result is the same for any
/// number of threads, and the same as that of the command and of the page. `tell` hears what is found. The folder is locked while the run works on it, as the command's is.
///
/// # Errors
/// As [`Run`]; [`Error::UnreadableFile`] and [`Error::NotWritten`] for the folder, also where another run works on it.
///
/// # Panics
/// Where `tell` does, once the jobs under way have ended.
pub fn run_block(
    images: &[PathBuf],
    masks: &[PathBuf],
    options: RunInput,
    kept: &Path,
    threads: usize,
    tell: impl FnMut(News) + Send,
) -> Result<BlockRun, Error> {
    let _lock = FolderLock::take(kept)?;
    let names = |paths: &[PathBuf]| paths.iter().map(|path| name_of(path)).collect();
    let geoid = options.geoid.as_ref().map(PathBuf::from).unwrap_or_default();
    let named = options.geoid.as_ref().map(|_| name_of(&geoid));
    let run = Run::new(RunInput { images: names(images), masks: names(masks), geoid: named, ..options })?;
    let host = Host {
        images,
        masks,
        geoid: &geoid,
        kept,
        shared: Mutex::new(Shared { run, tell, busy: 0, ended: Ok(()) }),
        changed: Condvar::new(),
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..threads.max(1)).map(|_| scope.spawn(|| host.work())).collect();
        for thread in threads {
            if let Err(panic) = thread.join() {
                std::panic::resume_unwind(panic);
            }
        }
    });
    let Shared { run, ended, .. } = host.shared.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    ended.and_then(|()| run.finish())
}

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn unreadable(document: Document, path: &Path, error: &std::io::Error) -> Error {
    let file_place = Some(FilePlace::Path { path: path.display().to_string() });
    Error::UnreadableFile { document, file_place, file_fault: FileFault::System { message: error.to_string() } }
}

/// What came of a job.
enum Outcome {
    /// A record of an earlier run, which the run has taken.
    Found,
    Made(Vec<u8>),
    Failed(Failure),
}

struct Shared<T> {
    run: Run,
    tell: T,
    /// Threads that do a job.
    busy: usize,
    ended: Result<(), Error>,
}

/// A thread that works. Where it panics the run ends: those that wait for its job would wait for good.
struct Working<'a, 'h, T>(&'a Host<'h, T>);

impl<T> Drop for Working<'_, '_, T> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.lock().ended = Err(Error::Interrupted { interruption: Interruption::Unfinished });
            self.0.changed.notify_all();
        }
    }
}

struct Host<'a, T> {
    images: &'a [PathBuf],
    masks: &'a [PathBuf],
    geoid: &'a Path,
    kept: &'a Path,
    shared: Mutex<Shared<T>>,
    changed: Condvar,
}

impl<T> Host<'_, T> {
    fn lock(&self) -> std::sync::MutexGuard<'_, Shared<T>> {
        self.shared.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl<T: FnMut(News)> Host<'_, T> {
    /// Does one job after the other, until there are no more or the run has failed.
    fn work(&self) {
        let _working = Working(self);
        while let Some(job) = self.wait_for_job() {
            let outcome = self.perform(&job);
            let mut shared = self.lock();
            shared.busy -= 1;
            let taken = outcome.and_then(|outcome| match outcome {
                Outcome::Found => Ok(()),
                Outcome::Made(bytes) => shared.run.complete(job.id, bytes),
                Outcome::Failed(failure) => shared.run.failed(job.id, failure),
            });
            shared.ended = shared.ended.clone().and(taken);
            let news = shared.run.news();
            news.into_iter().for_each(&mut shared.tell);
            self.changed.notify_all();
        }
    }

    fn wait_for_job(&self) -> Option<Job> {
        let mut shared = self.lock();
        loop {
            let job = if shared.ended.is_ok() { shared.run.next(1) } else { return None };
            match job.map(|jobs| jobs.into_iter().next()) {
                Err(error) => shared.ended = Err(error),
                Ok(Some(job)) => {
                    shared.busy += 1;
                    return Some(job);
                }
                Ok(None) if shared.busy == 0 => return None,
                Ok(None) => shared = self.changed.wait(shared).unwrap_or_else(std::sync::PoisonError::into_inner),
            }
        }
    }

    fn perform(&self, job: &Job) -> Result<Outcome, Error> {
        let path = |file: &FileNeeded| match file {
            FileNeeded::Image(index) => self.images[*index].as_path(),
            FileNeeded::Mask(index) => self.masks[*index].as_path(),
            FileNeeded::Geoid(_) => self.geoid,
        };
        let mut inputs = Vec::new();
        for file in &job.files {
            match fs::read(path(file)) {
                Ok(bytes) => inputs.push(bytes),
                Err(error) => return Ok(Outcome::Failed(Failure::Unreadable { message: error.to_string() })),
            }
        }
        let digests: Vec<String> = inputs.iter().map(|bytes| digest(bytes)).collect();
        let work = self.lock().run.prepare(job.id, &digests)?;
        let kept = work.key.as_deref().and_then(|key| fs::read(self.place(key)).ok());
        if let Some(record) = kept
            && self.lock().run.found(job.id, record)?
        {
            return Ok(Outcome::Found);
        }
        for key in &work.records {
            let path = self.place(key);
            inputs.push(fs::read(&path).map_err(|error| unreadable(Document::KeptRecord, &path, &error))?);
        }
        inputs.extend(work.input);
        let Some(task) = work.task else { return Ok(Outcome::Made(inputs.pop().unwrap_or_default())) };
        let borrowed: Vec<&[u8]> = inputs.iter().map(Vec::as_slice).collect();
        let bytes = match execute(&task, &borrowed) {
            Ok(bytes) => bytes,
            Err(error) => return Ok(Outcome::Failed(Failure::from(&error))),
        };
        if let Some(key) = &work.key {
            self.keep(key, &bytes)?;
        }
        Ok(Outcome::Made(bytes))
    }

    fn place(&self, key: &str) -> PathBuf {
        self.kept.join(format!("{key}.record"))
    }

    /// A record holds its own checksum.
    fn keep(&self, key: &str, bytes: &[u8]) -> Result<(), Error> {
        replace(&self.place(key), bytes, false).map_err(|_| Error::NotWritten { document: Document::KeptRecord })
    }
}
