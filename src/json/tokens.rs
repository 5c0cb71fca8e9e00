//! The parts of a text that is known to be JSON.

use super::JsonKind;

/// A text that is JSON, and how far it was read.
pub(super) struct Tokens<'de> {
    text: &'de str,
    at: usize,
}

impl<'de> Tokens<'de> {
    pub fn of(text: &'de str) -> Self {
        Self { text, at: 0 }
    }

    /// The byte at which the next value begins.
    pub fn start(&mut self) -> usize {
        self.pass(|byte| byte.is_ascii_whitespace() || matches!(byte, b':' | b','));
        self.at
    }

    /// What has been read since a byte.
    pub fn since(&self, start: usize) -> &'de str {
        &self.text[start..self.at]
    }

    /// What the next value is.
    pub fn kind(&mut self) -> JsonKind {
        self.start();
        match self.next() {
            Some(b'{') => JsonKind::Object,
            Some(b'[') => JsonKind::List,
            Some(b'"') => JsonKind::Text,
            Some(b't' | b'f') => JsonKind::Boolean,
            Some(b'n') | None => JsonKind::Null,
            Some(_) => JsonKind::Number,
        }
    }

    /// The next value, a single one, as it is written.
    pub fn single(&mut self) -> &'de str {
        let start = self.start();
        if self.next() == Some(b'"') {
            self.at += 1;
            loop {
                self.pass(|byte| !matches!(byte, b'"' | b'\\'));
                match self.next() {
                    Some(b'\\') => self.at += 2,
                    _ => break,
                }
            }
            self.step();
        } else {
            self.pass(|byte| !byte.is_ascii_whitespace() && !matches!(byte, b',' | b']' | b'}'));
        }
        self.since(start)
    }

    /// Passes the bracket with which a list or an object begins.
    pub fn open(&mut self) {
        self.start();
        self.step();
    }

    /// Whether another item or field follows; passes the closing bracket where none does.
    pub fn has_next(&mut self) -> bool {
        self.start();
        let is_over = matches!(self.next(), Some(b']' | b'}') | None);
        if is_over {
            self.step();
        }
        !is_over
    }

    /// Passes the next value, whatever it holds.
    pub fn skip(&mut self) {
        let mut depth = 0_usize;
        loop {
            match self.kind() {
                JsonKind::List | JsonKind::Object => {
                    self.open();
                    depth += 1;
                }
                _ => drop(self.single()),
            }
            while depth > 0 && !self.has_next() {
                depth -= 1;
            }
            if depth == 0 {
                return;
            }
        }
    }

    fn next(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn step(&mut self) {
        self.at = (self.at + 1).min(self.text.len());
    }

    fn pass(&mut self, is_passed: impl Fn(u8) -> bool) {
        let rest = &self.text.as_bytes()[self.at.min(self.text.len())..];
        self.at = self.text.len() - rest.len() + rest.iter().position(|byte| !is_passed(*byte)).unwrap_or(rest.len());
    }
}
