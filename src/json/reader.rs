//! The one reader of JSON, which says in plain words what each place wants and has.
//!
//! Readers of libraries say it in names of Rust's types, and take a list for an object.

use super::key::Key;
use super::slip::{Segment, Slip};
use super::tokens::Tokens;
use super::{JsonKind, JsonSlip, JsonWanted};
use serde::de::{DeserializeSeed, Deserializer, EnumAccess, IntoDeserializer, MapAccess, SeqAccess, VariantAccess, Visitor};
use serde_json::Number;
use std::borrow::Cow;

/// Lists and objects stand in each other at most so deep.
const DEEPEST: usize = 128;

/// Reads the next value of a text that is JSON.
pub(super) struct Reader<'a, 'de> {
    tokens: &'a mut Tokens<'de>,
    depth: usize,
}

impl<'a, 'de> Reader<'a, 'de> {
    pub fn of(tokens: &'a mut Tokens<'de>) -> Self {
        Self { tokens, depth: 0 }
    }

    /// The next value, and where in it what is refused stands.
    pub fn value<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Slip> {
        let start = self.tokens.start();
        seed.deserialize(self.inside()).map_err(|slip| slip.found_in(self.tokens.since(start)).at(start))
    }

    /// The error of another value than is wanted.
    fn other(self, json_wanted: JsonWanted) -> Slip {
        let (start, kind) = (self.tokens.start(), self.tokens.kind());
        self.tokens.skip();
        Slip::other(kind, self.tokens.since(start), json_wanted).at(start)
    }

    fn of_kind(self, json_kind: JsonKind) -> Slip {
        self.other(JsonWanted::OfKind { json_kind })
    }

    fn inside(&mut self) -> Reader<'_, 'de> {
        Reader { tokens: self.tokens, depth: self.depth }
    }

    /// Goes into a list or an object.
    fn open(&mut self) -> Result<(), Slip> {
        if self.depth == DEEPEST {
            return Err(Slip::of(JsonSlip::Deep { most: DEEPEST }).at(self.tokens.start()));
        }
        self.depth += 1;
        self.tokens.open();
        Ok(())
    }

    fn number<V: Visitor<'de>>(self, visitor: V, whole: Option<[i128; 2]>) -> Result<V::Value, Slip> {
        let json_wanted = match whole {
            None => JsonWanted::OfKind { json_kind: JsonKind::Number },
            Some([min, max]) => JsonWanted::Whole { min: min as f64, max: max as f64 },
        };
        if self.tokens.kind() != JsonKind::Number {
            return Err(self.other(json_wanted));
        }
        let start = self.tokens.start();
        let written = self.tokens.single();
        let wrong = || Slip::other(JsonKind::Number, written, json_wanted).at(start);
        let Ok(number) = serde_json::from_str::<Number>(written) else { return Err(wrong()) };
        let is_in = |value: i128| whole.is_none_or(|[min, max]| (min..=max).contains(&value));
        match (number.as_u64(), number.as_i64(), number.as_f64()) {
            (Some(value), ..) if is_in(value.into()) => visitor.visit_u64(value),
            (None, Some(value), _) if is_in(value.into()) => visitor.visit_i64(value),
            (None, None, Some(value)) if whole.is_none() => visitor.visit_f64(value),
            _ => Err(wrong()),
        }
        .map_err(|slip: Slip| slip.at(start))
    }

    /// A text, of which a copy is made where it is written with escapes.
    fn text(&mut self) -> Result<Cow<'de, str>, Slip> {
        let start = self.tokens.start();
        let written = self.tokens.single();
        match written.get(1..written.len().saturating_sub(1)) {
            Some(plain) if !plain.contains('\\') => Ok(Cow::Borrowed(plain)),
            _ => serde_json::from_str(written).map(Cow::Owned).map_err(|error| <Slip as serde::de::Error>::custom(error).at(start)),
        }
    }
}

macro_rules! whole_numbers {
    ($($deserialize:ident: $number:ty),+) => {
        $(fn $deserialize<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
            self.number(visitor, Some([<$number>::MIN.into(), <$number>::MAX.into()]))
        })+
    };
}

impl<'de> Deserializer<'de> for Reader<'_, 'de> {
    type Error = Slip;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        match self.tokens.kind() {
            JsonKind::Null => self.deserialize_unit(visitor),
            JsonKind::Boolean => self.deserialize_bool(visitor),
            JsonKind::Number => self.number(visitor, None),
            JsonKind::Text => self.deserialize_str(visitor),
            JsonKind::List => self.deserialize_seq(visitor),
            JsonKind::Object => self.deserialize_map(visitor),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        match self.tokens.kind() {
            JsonKind::Boolean => visitor.visit_bool(self.tokens.single() == "true"),
            _ => Err(self.of_kind(JsonKind::Boolean)),
        }
    }

    whole_numbers!(
        deserialize_i8: i8, deserialize_i16: i16, deserialize_i32: i32, deserialize_i64: i64,
        deserialize_u8: u8, deserialize_u16: u16, deserialize_u32: u32, deserialize_u64: u64
    );

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.number(visitor, None)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.number(visitor, None)
    }

    fn deserialize_str<V: Visitor<'de>>(mut self, visitor: V) -> Result<V::Value, Slip> {
        if self.tokens.kind() != JsonKind::Text {
            return Err(self.of_kind(JsonKind::Text));
        }
        let start = self.tokens.start();
        let read = match self.text()? {
            Cow::Borrowed(text) => visitor.visit_borrowed_str(text),
            Cow::Owned(text) => visitor.visit_string(text),
        };
        read.map_err(|slip: Slip| slip.at(start))
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_str(visitor)
    }

    fn deserialize_char<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_str(visitor)
    }

    fn deserialize_identifier<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_str(visitor)
    }

    fn deserialize_bytes<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_any(visitor)
    }

    fn deserialize_byte_buf<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_any(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        match self.tokens.kind() {
            JsonKind::Null => {
                self.tokens.single();
                visitor.visit_none()
            }
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_unit<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        match self.tokens.kind() {
            JsonKind::Null => {
                self.tokens.single();
                visitor.visit_unit()
            }
            _ => Err(self.of_kind(JsonKind::Null)),
        }
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_unit(visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Slip> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(mut self, visitor: V) -> Result<V::Value, Slip> {
        if self.tokens.kind() != JsonKind::List {
            return Err(self.of_kind(JsonKind::List));
        }
        let start = self.tokens.start();
        self.open()?;
        let mut items = Items { reader: self, index: 0, is_over: false };
        let read = visitor.visit_seq(&mut items).map_err(|slip| slip.at(start));
        // Also where it is refused, since what is refused is looked for in what was read.
        let wanted = items.index;
        while items.has_next() {
            items.reader.tokens.skip();
            items.index += 1;
        }
        let read = read?;
        match items.index == wanted {
            true => Ok(read),
            false => Err(Slip::of(JsonSlip::OtherLength { items: items.index, wanted_items: Some(wanted) }).at(start)),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, items: usize, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_seq(visitor).map_err(|slip| slip.of_list(items))
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(self, _: &'static str, items: usize, visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_tuple(items, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(mut self, visitor: V) -> Result<V::Value, Slip> {
        if self.tokens.kind() != JsonKind::Object {
            return Err(self.of_kind(JsonKind::Object));
        }
        let start = self.tokens.start();
        self.open()?;
        let mut fields = Fields { reader: self, key: Cow::Borrowed(""), is_over: false };
        let read = visitor.visit_map(&mut fields).map_err(|slip| slip.at(start));
        while fields.has_next() {
            fields.reader.tokens.single();
            fields.reader.tokens.skip();
        }
        read
    }

    fn deserialize_struct<V: Visitor<'de>>(self, _: &'static str, _: &'static [&'static str], visitor: V) -> Result<V::Value, Slip> {
        self.deserialize_map(visitor)
    }

    /// A text, or an object whose only field is the name of the variant.
    fn deserialize_enum<V: Visitor<'de>>(
        mut self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Slip> {
        let start = self.tokens.start();
        let json_wanted = JsonWanted::Words { words: variants.join(", ") };
        match self.tokens.kind() {
            JsonKind::Text => {
                let word = self.text()?;
                visitor.visit_enum(word.into_deserializer()).map_err(|slip: Slip| slip.at(start))
            }
            JsonKind::Object => {
                self.open()?;
                if !self.tokens.has_next() {
                    return Err(Slip::of(JsonSlip::OtherKind { json_kind: JsonKind::Object, json_wanted }).at(start));
                }
                let variant = self.text()?;
                let read = visitor.visit_enum(Variant { reader: self.inside(), variant }).map_err(|slip: Slip| slip.at(start))?;
                match self.tokens.has_next() {
                    false => Ok(read),
                    true => Err(Slip::of(JsonSlip::OtherKind { json_kind: JsonKind::Object, json_wanted }).at(start)),
                }
            }
            _ => Err(self.other(json_wanted)),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Slip> {
        self.tokens.skip();
        visitor.visit_unit()
    }
}

/// The items of a list.
struct Items<'a, 'de> {
    reader: Reader<'a, 'de>,
    index: usize,
    is_over: bool,
}

impl Items<'_, '_> {
    fn has_next(&mut self) -> bool {
        self.is_over = self.is_over || !self.reader.tokens.has_next();
        !self.is_over
    }
}

impl<'de> SeqAccess<'de> for Items<'_, 'de> {
    type Error = Slip;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Slip> {
        if !self.has_next() {
            return Ok(None);
        }
        let index = self.index;
        self.index += 1;
        self.reader.value(seed).map(Some).map_err(|slip| slip.within(Segment::Item(index)))
    }
}

/// The fields of an object.
struct Fields<'a, 'de> {
    reader: Reader<'a, 'de>,
    key: Cow<'de, str>,
    is_over: bool,
}

impl Fields<'_, '_> {
    fn has_next(&mut self) -> bool {
        self.is_over = self.is_over || !self.reader.tokens.has_next();
        !self.is_over
    }
}

impl<'de> MapAccess<'de> for Fields<'_, 'de> {
    type Error = Slip;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Slip> {
        if !self.has_next() {
            return Ok(None);
        }
        let start = self.reader.tokens.start();
        self.key = self.reader.text()?;
        seed.deserialize(Key(self.key.clone())).map(Some).map_err(|slip| slip.at(start))
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Slip> {
        self.reader.value(seed).map_err(|slip| slip.within(Segment::Field(self.key.to_string())))
    }
}

/// A variant of an enum, and what it holds.
struct Variant<'a, 'de> {
    reader: Reader<'a, 'de>,
    variant: Cow<'de, str>,
}

impl<'a, 'de> EnumAccess<'de> for Variant<'a, 'de> {
    type Error = Slip;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Slip> {
        seed.deserialize(Key(self.variant.clone())).map(|variant| (variant, self))
    }
}

impl<'de> VariantAccess<'de> for Variant<'_, 'de> {
    type Error = Slip;

    fn unit_variant(self) -> Result<(), Slip> {
        self.newtype_variant_seed(std::marker::PhantomData)
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(mut self, seed: T) -> Result<T::Value, Slip> {
        self.reader.value(seed).map_err(|slip| slip.within(Segment::Field(self.variant.into())))
    }

    fn tuple_variant<V: Visitor<'de>>(self, items: usize, visitor: V) -> Result<V::Value, Slip> {
        self.reader.deserialize_tuple(items, visitor).map_err(|slip| slip.within(Segment::Field(self.variant.into())))
    }

    fn struct_variant<V: Visitor<'de>>(self, _: &'static [&'static str], visitor: V) -> Result<V::Value, Slip> {
        self.reader.deserialize_map(visitor).map_err(|slip| slip.within(Segment::Field(self.variant.into())))
    }
}
