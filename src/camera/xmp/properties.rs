//! The properties of an XMP packet that are read, as text.
//!
//! The packet is read once, without a tree; what stands before damage is read. A name counts once, the first time.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use quick_xml::name::QName;
use std::collections::BTreeMap;

/// Bytes of a packet beyond which nothing is read: those of JPEG files have 65,000 at most.
const MOST_BYTES: usize = 1 << 20;
/// Elements within each other, where packets have five, and prefixes, where they have some ten.
const MOST_DEPTH: usize = 50;
const MOST_PREFIXES: usize = 100;
/// Bytes of a text; longer ones are recordings of sensors, of which nothing is read.
const MOST_TEXT_BYTES: usize = 1_000;

/// Who defines a property.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Namespace {
    Dji,
    /// Of Pix4D, for cameras of all makers.
    Camera,
    Panorama,
    SenseFly,
}

/// Their addresses, without a slash at the end, which some writers leave out, and the prefixes that all writers use.
const NAMESPACES: [(Namespace, &str, &str); 4] = [
    (Namespace::Dji, "http://www.dji.com/drone-dji/1.0", "drone-dji"),
    (Namespace::Camera, "http://pix4d.com/camera/1.0", "Camera"),
    (Namespace::Panorama, "http://ns.google.com/photos/1.0/panorama", "GPano"),
    (Namespace::SenseFly, "http://ns.sensefly.com/sensefly/1.0", "sensefly"),
];

/// What a packet says, by who defines it and its name; of a list its items with commas between them.
#[derive(Debug, Default)]
pub struct Properties(BTreeMap<(Namespace, String), String>);

impl Properties {
    /// Those of a packet, as far as it can be read.
    ///
    /// # Source
    /// ISO 16684-1:2019, section 7: a simple property is an attribute of its description, or an element; an array is an element whose
    /// items are elements.
    pub fn of(packet: &[u8]) -> Self {
        let text = String::from_utf8_lossy(&packet[..packet.len().min(MOST_BYTES)]);
        let mut reader = Reader::from_str(&text);
        let mut found = Self::default();
        let mut prefixes = Vec::new();
        let mut depth = 0;
        // The element whose text is gathered, and its depth.
        let mut open: Option<((Namespace, String), usize, String)> = None;
        loop {
            match reader.read_event() {
                Ok(Event::Start(element)) => {
                    depth += 1;
                    if depth > MOST_DEPTH {
                        break;
                    }
                    found.take_attributes(&element, &mut prefixes);
                    if open.is_none() {
                        open = property(element.name(), &prefixes).map(|name| (name, depth, String::new()));
                    }
                }
                Ok(Event::Empty(element)) => found.take_attributes(&element, &mut prefixes),
                Ok(Event::Text(piece)) => {
                    if let Some((.., text)) = &mut open {
                        append(text, &piece.into_inner());
                    }
                }
                Ok(Event::End(_)) => {
                    if let Some((name, _, text)) = open.take_if(|(_, at, _)| *at == depth) {
                        found.take(name, &text);
                    }
                    depth = depth.saturating_sub(1);
                }
                Ok(Event::Eof) | Err(_) => break,
                Ok(_) => {}
            }
        }
        found
    }

    pub fn text(&self, namespace: Namespace, name: &str) -> Option<&str> {
        self.0.get(&(namespace, name.to_owned())).map(String::as_str)
    }

    pub fn number(&self, namespace: Namespace, name: &str) -> Option<f64> {
        finite(self.text(namespace, name)?)
    }

    /// At least `N` numbers with commas between them, of which the first are given.
    pub fn numbers<const N: usize>(&self, namespace: Namespace, name: &str) -> Option<[f64; N]> {
        numbers(self.text(namespace, name)?)
    }

    fn take_attributes(&mut self, element: &BytesStart<'_>, prefixes: &mut Vec<(String, Namespace)>) {
        // Their number may be large: they are read where they stand, and it is not checked whether one is there twice, which would compare all
        // with all.
        for attribute in element.attributes().with_checks(false).flatten() {
            let address = attribute.value.trim_end_matches('/');
            if let Some(prefix) = attribute.key.as_ref().strip_prefix("xmlns:")
                && let Some((namespace, ..)) = NAMESPACES.iter().find(|(_, known, _)| *known == address)
                && prefixes.len() < MOST_PREFIXES
            {
                prefixes.push((prefix.to_owned(), *namespace));
            }
        }
        for attribute in element.attributes().with_checks(false).flatten() {
            if let Some(name) = property(attribute.key, prefixes) {
                self.take(name, &attribute.value);
            }
        }
    }

    fn take(&mut self, name: (Namespace, String), text: &str) {
        let text = text.trim();
        if !text.is_empty() && text.len() <= MOST_TEXT_BYTES {
            self.0.entry(name).or_insert_with(|| text.to_owned());
        }
    }
}

/// Finite numbers of a text, with commas between them.
pub fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let mut values = [0.0; N];
    let mut parts = text.split(',');
    for value in &mut values {
        *value = finite(parts.next()?)?;
    }
    Some(values)
}

fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

/// The name of a property that may be read; a prefix that the packet does not explain is the usual one.
fn property(name: QName<'_>, prefixes: &[(String, Namespace)]) -> Option<(Namespace, String)> {
    let (prefix, local) = name.as_ref().split_once(':')?;
    let explained = prefixes.iter().rev().find(|(known, _)| known == prefix).map(|(_, namespace)| *namespace);
    let usual = || NAMESPACES.iter().find(|(.., usual)| *usual == prefix).map(|(namespace, ..)| *namespace);
    Some((explained.or_else(usual)?, local.to_owned()))
}

/// Items of a list stand in elements of their own, with white space between these.
fn append(text: &mut String, piece: &str) {
    let piece = piece.trim();
    if !piece.is_empty() && text.len() <= MOST_TEXT_BYTES {
        if !text.is_empty() {
            text.push(',');
        }
        text.push_str(piece);
    }
}
