//! Files that are read in parts, where they are needed.

use crate::{Document, Error, FileFault};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::sync::{Arc, Mutex, PoisonError};

/// A file that is read in parts: of a disk, of a browser, or in memory.
pub trait FileSource: Send + Sync {
    /// Its length in bytes.
    fn length(&self) -> u64;

    /// Fills `into` with the bytes from `at` on.
    ///
    /// # Errors
    /// Of the host, and [`io::ErrorKind::UnexpectedEof`] where the file ends before.
    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()>;
}

impl FileSource for [u8] {
    fn length(&self) -> u64 {
        self.len() as u64
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        let from = usize::try_from(at).ok().and_then(|at| self.get(at..)?.get(..into.len()));
        into.copy_from_slice(from.ok_or(io::ErrorKind::UnexpectedEof)?);
        Ok(())
    }
}

impl<S: FileSource + ?Sized> FileSource for &S {
    fn length(&self) -> u64 {
        (**self).length()
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        (**self).read_at(at, into)
    }
}

impl FileSource for Vec<u8> {
    fn length(&self) -> u64 {
        self.len() as u64
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        self.as_slice().read_at(at, into)
    }
}

impl<S: FileSource + ?Sized> FileSource for Arc<S> {
    fn length(&self) -> u64 {
        (**self).length()
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        (**self).read_at(at, into)
    }
}

/// A file of a disk.
#[derive(Debug)]
pub struct DiskFile {
    file: Mutex<File>,
    length: u64,
}

impl DiskFile {
    /// Takes a file that is open for reading.
    ///
    /// # Errors
    /// Of the system.
    pub fn new(file: File) -> io::Result<Self> {
        let length = file.metadata()?.len();
        Ok(Self { file: Mutex::new(file), length })
    }
}

impl FileSource for DiskFile {
    fn length(&self) -> u64 {
        self.length
    }

    fn read_at(&self, at: u64, into: &mut [u8]) -> io::Result<()> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(at))?;
        file.read_exact(into)
    }
}

/// All of a file, which is that document.
///
/// # Errors
/// [`Error::UnreadableFile`] as [`FileSource::read_at`], and where memory is short.
pub(crate) fn read_all(source: &dyn FileSource, document: Document) -> Result<Vec<u8>, Error> {
    let read = || {
        let length = usize::try_from(source.length()).map_err(|_| io::ErrorKind::OutOfMemory)?;
        let mut bytes = Vec::new();
        bytes.try_reserve_exact(length).map_err(|_| io::ErrorKind::OutOfMemory)?;
        bytes.resize(length, 0);
        source.read_at(0, &mut bytes)?;
        Ok(bytes)
    };
    read().map_err(|error: io::Error| unread(document, &error))
}

/// The error for a file that the host does not give.
pub(crate) fn unread(document: Document, error: &io::Error) -> Error {
    Error::UnreadableFile { document, file_place: None, file_fault: FileFault::System { message: error.to_string() } }
}

/// A place in a file, as libraries that decode want it.
#[derive(Debug, Clone)]
pub(crate) struct SourceReader<S> {
    pub source: S,
    at: u64,
}

impl<S: FileSource> SourceReader<S> {
    pub fn new(source: S) -> Self {
        Self { source, at: 0 }
    }
}

impl<S: FileSource> Read for SourceReader<S> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let left = self.source.length().saturating_sub(self.at);
        let count = into.len().min(usize::try_from(left).unwrap_or(usize::MAX));
        self.source.read_at(self.at, &mut into[..count])?;
        self.at += count as u64;
        Ok(count)
    }
}

impl<S: FileSource> Seek for SourceReader<S> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
            SeekFrom::End(by) => self.source.length().checked_add_signed(by),
        };
        self.at = at.ok_or(io::ErrorKind::InvalidInput)?;
        Ok(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_from_anywhere_and_not_beyond_its_end() {
        let bytes: Vec<u8> = (0..100).collect();
        let path = std::env::temp_dir().join(format!("tiepoint-source-{}", std::process::id()));
        std::fs::write(&path, &bytes).unwrap();
        let disk = DiskFile::new(File::open(&path).unwrap()).unwrap();
        let sources: [Arc<dyn FileSource>; 2] = [Arc::new(bytes.clone()), Arc::new(disk)];
        for source in sources {
            let mut four = [0; 4];
            source.read_at(96, &mut four).unwrap();
            assert_eq!((source.length(), four), (100, [96, 97, 98, 99]));
            assert_eq!(source.read_at(97, &mut four).unwrap_err().kind(), io::ErrorKind::UnexpectedEof);
            assert!(source.read_at(u64::MAX, &mut four).is_err());
            let mut reader = SourceReader::new(source);
            assert_eq!(reader.seek(SeekFrom::End(-2)).unwrap(), 98);
            let mut rest = Vec::new();
            reader.read_to_end(&mut rest).unwrap();
            assert_eq!(rest, [98, 99]);
            assert!(reader.seek(SeekFrom::Current(-101)).is_err());
            assert_eq!(read_all(&reader.source, Document::File).unwrap(), bytes);
        }
        std::fs::remove_file(path).unwrap();
    }
}
