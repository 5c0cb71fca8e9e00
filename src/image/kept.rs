//! What was decoded of a file in parts, kept as far as memory allows.

use crate::Error;
use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, PoisonError};

/// Decoded parts by their keys, of so many bytes at most: those that were not asked for longest go first.
pub(crate) struct Kept<K, V> {
    most_bytes: usize,
    entries: Mutex<Entries<K, V>>,
}

struct Entries<K, V> {
    parts: HashMap<K, Part<V>>,
    bytes: usize,
    asked: u64,
}

struct Part<V> {
    asked: u64,
    bytes: usize,
    value: Arc<V>,
}

impl<K: Copy + Eq + Hash, V> Kept<K, V> {
    pub fn new(most_bytes: usize) -> Self {
        Self { most_bytes, entries: Mutex::new(Entries { parts: HashMap::new(), bytes: 0, asked: 0 }) }
    }

    /// The part of a key, which is decoded where it is not there. `bytes`: how many it takes.
    ///
    /// # Errors
    /// Of `decode`.
    pub fn part(&self, key: K, bytes: impl FnOnce(&V) -> usize, decode: impl FnOnce() -> Result<V, Error>) -> Result<Arc<V>, Error> {
        let entries = || self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(value) = entries().get(key) {
            return Ok(value);
        }
        // Other threads are not held up meanwhile.
        let value = Arc::new(decode()?);
        entries().keep(key, bytes(&value), &value, self.most_bytes);
        Ok(value)
    }

    /// How many are kept.
    #[cfg(test)]
    pub fn number(&self) -> usize {
        self.entries.lock().unwrap().parts.len()
    }
}

impl<K: Copy + Eq + Hash, V> Entries<K, V> {
    fn get(&mut self, key: K) -> Option<Arc<V>> {
        self.asked += 1;
        let part = self.parts.get_mut(&key)?;
        part.asked = self.asked;
        Some(Arc::clone(&part.value))
    }

    fn keep(&mut self, key: K, bytes: usize, value: &Arc<V>, most_bytes: usize) {
        self.bytes += bytes;
        while self.bytes > most_bytes {
            let oldest = self.parts.iter().min_by_key(|(_, part)| part.asked).map(|(key, _)| *key);
            let Some(gone) = oldest.and_then(|key| self.parts.remove(&key)) else { break };
            self.bytes -= gone.bytes;
        }
        // Another thread may have decoded it meanwhile.
        if let Some(same) = self.parts.insert(key, Part { asked: self.asked, bytes, value: Arc::clone(value) }) {
            self.bytes -= same.bytes;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_asked_for_longest_is_decoded_anew() {
        let kept = Kept::new(25);
        let mut decoded = Vec::new();
        for key in [1, 2, 1, 3, 1, 2] {
            let decode = || {
                decoded.push(key);
                Ok(10 * key)
            };
            let value = kept.part(key, |_| 10, decode).unwrap();
            assert_eq!(*value, 10 * key);
        }
        assert_eq!((decoded, kept.number()), (vec![1, 2, 3, 2], 2));
    }
}
