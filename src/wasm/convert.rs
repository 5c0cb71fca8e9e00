//! Between JavaScript values and plain data.

use crate::catalogue::shown;
use crate::json::{self, JsonFault, JsonSlip};
use crate::{Document, Error, FileFault, FilePlace, GreyImage, InterestPoint, PartlyGiven, with_defaults};
use js_sys::{Array, Float32Array, Float64Array, Function, JSON, Object, Reflect, Symbol, Uint8Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::cell::RefCell;
use std::ops::RangeInclusive;
use std::rc::Rc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// What every call that can fail gives: an `Error` named `TiepointError` with `code`, `usage` and the `error` with its figures on failure.
pub type JsResult<T> = Result<T, JsValue>;

pub fn thrown(error: Error) -> JsValue {
    let value = js_sys::Error::new(&error.to_string());
    value.set_name("TiepointError");
    set(&value, "code", &error.code().into());
    set(&value, "usage", &error.is_usage().into());
    set(&value, "error", &pack(&error));
    value.into()
}

/// Reads a value. It goes through text, so that unknown fields are refused.
pub fn read<T: DeserializeOwned>(what: &'static str, value: &JsValue) -> JsResult<T> {
    parsed(value).and_then(|value| json::from_value(&value)).map_err(|fault| refused(what, fault))
}

/// Reads options: the fields that are given, the others from the defaults.
pub fn read_options<T: PartlyGiven>(what: &'static str, value: &JsValue) -> JsResult<T> {
    checked(what, parsed(value).map_err(|fault| refused(what, fault))?)
}

/// Options inside an object that was read: absent where they are.
pub fn options_inside<T: PartlyGiven>(what: &'static str, value: Option<Value>) -> JsResult<Option<T>> {
    value.map(|value| checked(what, value)).transpose()
}

/// What is declared of options says what is allowed of them; the reader, what else is wrong.
fn checked<T: PartlyGiven>(what: &'static str, given: Value) -> JsResult<T> {
    T::check_given(&given, &Document::Named { name: what.into() }).map_err(thrown)?;
    with_defaults(given).map_err(|fault| refused(what, fault))
}

/// The JSON form of a value: null where it has none, as `undefined`. A number that JSON has not, which would become null and so read as
/// absent, becomes its name and is refused. What JSON leaves out, or has as an empty object, is refused here.
fn parsed(value: &JsValue) -> Result<Value, JsonFault> {
    let lost = Rc::new(RefCell::new(None));
    let found = Rc::clone(&lost);
    let named = Closure::<dyn Fn(JsValue, JsValue) -> JsResult<JsValue>>::new(move |key: JsValue, value: JsValue| match value.as_f64() {
        Some(number) if number.is_nan() => Ok("NaN".into()),
        Some(number) if number.is_infinite() => Ok((if number > 0.0 { "Infinity" } else { "-Infinity" }).into()),
        Some(_) => Ok(value),
        None if is_lost(&value) => {
            let field = key.as_string().filter(|key| !key.is_empty());
            let json_slip = Box::new(JsonSlip::NotInJson { value_kind: kind_of(&value) });
            *found.borrow_mut() = Some(JsonFault::Value { field, json_slip, line: None, column: None });
            Err(JsValue::NULL)
        }
        None => Ok(value),
    });
    let text = JSON::stringify_with_replacer(value, named.as_ref()).map_err(|threw| {
        if let Some(fault) = lost.borrow_mut().take() {
            return fault;
        }
        let words = threw.dyn_ref::<js_sys::Error>().map_or_else(|| kind_of(&threw), |error| error.message().into());
        // Engines draw a circle in several lines.
        JsonFault::Text { words: words.split_whitespace().collect::<Vec<_>>().join(" "), line: None, column: None }
    })?;
    serde_json::from_str(text.as_string().as_deref().unwrap_or("null")).map_err(JsonFault::from)
}

/// Whether nothing of a value would be left in JSON.
fn is_lost(value: &JsValue) -> bool {
    match value.is_object() {
        true => tag_of(value).is_some_and(|tag| matches!(&tag[..], "Map" | "Set" | "WeakMap" | "WeakSet" | "Promise")),
        false => value.is_function() || value.is_symbol() || value.is_bigint(),
    }
}

/// The fault has no place, which would be that in a text that nobody wrote.
fn refused(what: &'static str, json_fault: JsonFault) -> JsValue {
    thrown(Error::InvalidJson { document: Document::Named { name: what.into() }, json_fault })
}

/// The error of a project that holds something else than is wanted.
pub fn wrong_project(file_fault: FileFault) -> Error {
    Error::UnreadableFile { document: Document::Project, file_place: Some(FilePlace::Content), file_fault }
}

/// Writes files through a function of the caller, who gets back what that throws as it is.
pub fn emitting<T>(
    emit: &Function,
    write: impl FnOnce(&mut dyn FnMut(&str, &str) -> Result<(), Error>) -> Result<T, Error>,
) -> JsResult<T> {
    if !emit.is_function() {
        return Err(wrong("emit", kind_of(emit), "a function"));
    }
    let mut threw = None;
    let written = write(&mut |path, text| {
        emit.call2(&JsValue::NULL, &path.into(), &text.into()).map(|_| ()).map_err(|error| {
            threw = Some(error);
            Error::NotWritten { document: Document::File }
        })
    });
    written.map_err(|error| threw.take().unwrap_or_else(|| thrown(error)))
}

#[wasm_bindgen]
extern "C" {
    /// Bytes of JavaScript. What arrives as a slice would be made of anything: of nothing where it has no length, and of other numbers.
    #[wasm_bindgen(typescript_type = "Uint8Array | Uint8ClampedArray | ArrayBuffer")]
    #[derive(Clone)]
    pub type Bytes;
}

impl Bytes {
    /// A copy of them. `what`: what they are.
    pub fn read(&self, what: &'static str) -> JsResult<Vec<u8>> {
        bytes_of(self).ok_or_else(|| wrong(what, kind_of(self), "Uint8Array, Uint8ClampedArray or ArrayBuffer"))
    }

    /// The same of the grey values of an image of this width and height, for which there may be no memory.
    pub fn read_image(&self, what: &'static str, size: [usize; 2]) -> JsResult<Vec<u8>> {
        let bytes = Reflect::get(self, &"byteLength".into()).ok().and_then(|length| length.as_f64()).unwrap_or_default();
        GreyImage::check_memory(size, bytes as u64).map_err(thrown)?;
        self.read(what)
    }
}

#[wasm_bindgen]
extern "C" {
    /// The file of a project: its bytes, or its text, as it is written.
    #[wasm_bindgen(typescript_type = "string | Uint8Array | Uint8ClampedArray | ArrayBuffer")]
    #[derive(Clone)]
    pub type ProjectFile;

    /// A text of JavaScript. What arrives as `&str` would be read from wherever a value of another type leads.
    #[wasm_bindgen(typescript_type = "string")]
    #[derive(Clone)]
    pub type Text;

    /// A list of texts.
    #[wasm_bindgen(typescript_type = "readonly string[]")]
    #[derive(Clone)]
    pub type TextList;

    /// A number of JavaScript. What arrives as `f64` would be made of anything: of the text of a number, or of null, which is 0.
    #[wasm_bindgen(typescript_type = "number")]
    #[derive(Clone)]
    pub type Number;

    /// Many numbers of JavaScript. What arrives as a slice would be made of anything, as bytes would.
    #[wasm_bindgen(typescript_type = "Float64Array | readonly number[]")]
    #[derive(Clone)]
    pub type Numbers;
}

impl ProjectFile {
    /// A copy of its bytes, or of its first ones. `what`: what they are.
    pub fn read(&self, what: &'static str) -> JsResult<Vec<u8>> {
        let bytes = self.as_string().map(String::into_bytes).or_else(|| bytes_of(self));
        bytes.ok_or_else(|| wrong(what, kind_of(self), "string, Uint8Array, Uint8ClampedArray or ArrayBuffer"))
    }
}

impl Text {
    /// A copy of it. `what`: what it is.
    pub fn read(&self, what: &'static str) -> JsResult<String> {
        self.as_string().ok_or_else(|| wrong(what, kind_of(self), "a string"))
    }
}

impl Number {
    /// It. `what`: what it is.
    pub fn read(&self, what: &'static str) -> JsResult<f64> {
        self.as_f64().ok_or_else(|| wrong(what, kind_of(self), "a number"))
    }
}

impl TextList {
    /// A copy of them. `what`: what they are.
    pub fn read(&self, what: &'static str) -> JsResult<Vec<String>> {
        items(self, what, "an array of strings", JsValue::as_string)
    }
}

impl Numbers {
    /// A copy of them. `what`: what they are.
    pub fn read(&self, what: &'static str) -> JsResult<Vec<f64>> {
        match tag_of(self).as_deref() {
            Some("Float64Array") => Ok(self.unchecked_ref::<Float64Array>().to_vec()),
            Some(
                "Float32Array" | "Int8Array" | "Uint8Array" | "Uint8ClampedArray" | "Int16Array" | "Uint16Array" | "Int32Array"
                | "Uint32Array",
            ) => Ok(Float64Array::new(self).to_vec()),
            _ => items(self, what, "Float64Array, or another array of numbers", JsValue::as_f64),
        }
    }

    /// The same in single precision, as which they are given where they are very many.
    pub fn read_single(&self, what: &'static str) -> JsResult<Vec<f32>> {
        match tag_of(self).as_deref() {
            Some("Float32Array") => Ok(self.unchecked_ref::<Float32Array>().to_vec()),
            _ => Ok(self.read(what)?.into_iter().map(|number| number as f32).collect()),
        }
    }
}

/// The items of an array, each read by `read`, which gives none for what is of another type.
fn items<T>(list: &JsValue, what: &'static str, wanted: &str, read: impl Fn(&JsValue) -> Option<T>) -> JsResult<Vec<T>> {
    if !Array::is_array(list) {
        return Err(wrong(what, kind_of(list), wanted));
    }
    let one = |(index, item)| read(&item).ok_or_else(|| wrong(what, format!("{} as item {index}", kind_of(&item)), wanted));
    list.unchecked_ref::<Array>().iter().enumerate().map(one).collect()
}

/// The error of a value of another type.
pub fn wrong(what: &'static str, got: String, wanted: &str) -> JsValue {
    thrown(Error::InvalidArgument { what, got, wanted: wanted.into() })
}

/// A copy of bytes; none where a value holds none.
pub fn bytes_of(value: &JsValue) -> Option<Vec<u8>> {
    match &*tag_of(value)? {
        "Uint8Array" | "Uint8ClampedArray" => Some(value.unchecked_ref::<Uint8Array>().to_vec()),
        "ArrayBuffer" => Some(Uint8Array::new(value).to_vec()),
        _ => None,
    }
}

/// The name of the class of an object of the language, whose constructor is another one in each window.
fn tag_of(value: &JsValue) -> Option<String> {
    Reflect::get(value, &Symbol::to_string_tag()).ok()?.as_string()
}

/// What kind of value is given, in a word.
pub fn kind_of(value: &JsValue) -> String {
    match value {
        _ if value.is_null() => "null".into(),
        _ if Array::is_array(value) => "Array".into(),
        _ => tag_of(value).or_else(|| value.js_typeof().as_string()).unwrap_or_default(),
    }
}

/// A whole number from 0 on, an index or a count. What is none would arrive as another one, as NaN as 0.
pub fn whole(what: &'static str, value: &Number) -> JsResult<usize> {
    side(what, value).map(|whole| whole as usize)
}

/// The same, of the side of an image.
pub fn side(what: &'static str, value: &Number) -> JsResult<u32> {
    whole_from(what, value, 0..=u32::MAX)
}

/// A whole number of a range.
pub fn whole_from(what: &'static str, value: &Number, range: RangeInclusive<u32>) -> JsResult<u32> {
    let value = value.read(what)?;
    let (min, max) = (*range.start(), *range.end());
    if value.fract() == 0.0 && (f64::from(min)..=f64::from(max)).contains(&value) {
        return Ok(value as u32);
    }
    Err(thrown(Error::InvalidArgument { what, got: shown(value.to_string()), wanted: format!("whole numbers from {min} to {max}") }))
}

/// Packs plain data as an object.
pub fn pack(value: &impl Serialize) -> JsValue {
    let text = serde_json::to_string(value).expect("plain data has a JSON form");
    JSON::parse(&text).expect("JSON that was just written")
}

/// An object with these fields.
pub fn object<const N: usize>(fields: [(&str, JsValue); N]) -> JsValue {
    let object = Object::new();
    fields.iter().for_each(|(name, value)| set(&object, name, value));
    object.into()
}

pub fn set(object: &impl AsRef<JsValue>, name: &str, value: &JsValue) {
    Reflect::set(object.as_ref(), &name.into(), value).expect("a plain object takes fields");
}

/// A copy of numbers as a typed array.
pub fn numbers(values: impl IntoIterator<Item = f64>) -> JsValue {
    let values: Vec<f64> = values.into_iter().collect();
    Float64Array::from(&values[..]).unchecked_into()
}

/// The rows of a flat array.
pub fn rows<'a, const N: usize>(what: &'static str, flat: &'a [f64]) -> JsResult<&'a [[f64; N]]> {
    let (rows, rest) = flat.as_chunks::<N>();
    if rest.is_empty() {
        return Ok(rows);
    }
    Err(thrown(Error::InvalidArgument { what, got: format!("{} numbers", flat.len()), wanted: format!("a multiple of {N} numbers") }))
}

/// Points of a flat array of x, y, value.
pub fn points(what: &'static str, flat: &[f64]) -> JsResult<Vec<InterestPoint>> {
    Ok(rows::<3>(what, flat)?.iter().map(|[x, y, value]| InterestPoint { x: *x, y: *y, value: *value }).collect())
}
