//! Words of text files: names without blanks, errors of writing, numbers of a line.

use crate::error::refuse;
use crate::text::shorten;
use crate::{Document, Error, FileFault, FilePlace, Refusal};
use std::fmt;

/// The error of a sink that takes no more text.
pub(super) fn not_written(_: fmt::Error) -> Error {
    Error::NotWritten { document: Document::Export }
}

/// A name that a format separates from others by blanks.
pub(super) fn one_word<'a>(format: &'static str, name: &'a str) -> Result<&'a str, Error> {
    if name.chars().any(char::is_whitespace) {
        return refuse(Refusal::NameWithBlanks { format: format.into(), name: name.into() });
    }
    Ok(name)
}

/// Names of files have up to 255 bytes nearly everywhere; formats put up to six before or behind the name of an image.
const MOST_NAME_BYTES: usize = 249;

/// A name that becomes the name of a file: it must not lead out of its folder, nor be too long for one.
pub(super) fn file_name<'a>(format: &'static str, name: &'a str) -> Result<&'a str, Error> {
    let leads_out = name.split(['/', '\\']).any(|part| part == ".." || part.is_empty()) || name.contains(':');
    if leads_out {
        return refuse(Refusal::NameOfNoFile { format: format.into(), name: name.into() });
    }
    if name.len() > MOST_NAME_BYTES {
        let (format, bytes) = (format.into(), name.len());
        return refuse(Refusal::LongName { format, name: shorten(name), bytes, most: MOST_NAME_BYTES });
    }
    Ok(name)
}

/// A line of a file that is being read, with its place for messages.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    pub what: &'static str,
    pub number: usize,
    pub text: &'a str,
}

impl<'a> Line<'a> {
    pub(super) fn refused(&self, file_fault: FileFault) -> Error {
        Error::UnreadableFile {
            document: Document::Named { name: self.what.into() },
            file_place: Some(FilePlace::Line { line: self.number }),
            file_fault,
        }
    }

    pub(super) fn words(&self) -> std::str::SplitAsciiWhitespace<'a> {
        self.text.split_ascii_whitespace()
    }

    /// The next word as a number that is finite.
    pub(super) fn number(&self, words: &mut impl Iterator<Item = &'a str>, name: &str) -> Result<f64, Error> {
        let word = self.word(words, name)?;
        let value = word.parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or_else(|| self.refused(FileFault::NoNumber { field: name.into(), word: shorten(word) }))
    }

    /// The next word as a whole number.
    pub(super) fn whole<T: std::str::FromStr>(&self, words: &mut impl Iterator<Item = &'a str>, name: &str) -> Result<T, Error> {
        let word = self.word(words, name)?;
        word.parse().map_err(|_| self.refused(FileFault::NoWholeNumber { field: name.into(), word: shorten(word) }))
    }

    pub(super) fn word(&self, words: &mut impl Iterator<Item = &'a str>, name: &str) -> Result<&'a str, Error> {
        words.next().ok_or_else(|| self.refused(FileFault::ShortLine { field: name.into() }))
    }
}
