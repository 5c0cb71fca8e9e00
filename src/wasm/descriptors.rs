//! Matches of byte descriptors.

use super::convert::{Bytes, JsResult, Number, kind_of, object, read_options, thrown, whole, wrong};
use crate::{DescriptorMatch, Error, NearestOptions, NearestTable, nearest_matches, nearest_of};
use js_sys::{Array, Reflect, Uint32Array};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Matches of descriptors. */
export interface DescriptorMatches {
    /** Index of the left and of the right descriptor of each match; stride 2. */
    indices: Uint32Array;
    /** Square of the distance of each match, and that of the second nearest right descriptor, 4294967295 where there is none; stride 2. */
    squares: Uint32Array;
}

/** Nearest neighbours of consecutive left descriptors; 4294967295 where there is none. */
export interface NearestPiece {
    /** The first left descriptor. */
    first: number;
    /** Of each left descriptor the nearest right one, the square of its distance and that of the second nearest; stride 3. */
    left: Uint32Array;
    /** Of each right descriptor the nearest of these left ones and the square of its distance; stride 2. */
    right: Uint32Array;
}
"#;

/// Matches byte descriptors of 128 bytes each: exact nearest neighbours, the ratio to the second nearest, the same from both sides.
#[wasm_bindgen(unchecked_return_type = "DescriptorMatches")]
pub fn match_descriptors(
    left: &Bytes,
    right: &Bytes,
    #[wasm_bindgen(unchecked_param_type = "Given<NearestOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let options: NearestOptions = read_options("nearest", options)?;
    nearest_matches(&left.read("left descriptors")?, &right.read("right descriptors")?, &options)
        .map(|matches| pack_matches(&matches))
        .map_err(thrown)
}

/// The nearest right descriptors of left ones from `first` to before `end`: a piece of the work, for `join_nearest` and
/// `match_photos`.
#[wasm_bindgen(unchecked_return_type = "NearestPiece")]
pub fn nearest_piece(left: &Bytes, first: &Number, end: &Number, right: &Bytes) -> JsResult<JsValue> {
    let (left, right) = (left.read("left descriptors")?, right.read("right descriptors")?);
    let table = nearest_of(&left, whole("first", first)?..whole("end", end)?, &right).map_err(thrown)?;
    Ok(object([
        ("first", (table.rows().start as f64).into()),
        ("left", array(&table.left_numbers())),
        ("right", array(&table.right_numbers())),
    ]))
}

/// The matches of pieces that follow each other from the first left descriptor to the last: those of the whole, whatever the pieces.
#[wasm_bindgen(unchecked_return_type = "DescriptorMatches")]
pub fn join_nearest(
    #[wasm_bindgen(unchecked_param_type = "NearestPiece[]")] pieces: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Given<NearestOptions>")] options: &JsValue,
) -> JsResult<JsValue> {
    let options: NearestOptions = read_options("nearest", options)?;
    let matches = read_pieces(pieces)?.map_or(Ok(Vec::new()), |whole| whole.matches(&options)).map_err(thrown)?;
    Ok(pack_matches(&matches))
}

/// The table of pieces that follow each other; absent where there are none.
pub(super) fn read_pieces(pieces: &JsValue) -> JsResult<Option<NearestTable>> {
    if !Array::is_array(pieces) {
        return Err(wrong("pieces of nearest neighbours", kind_of(pieces), "an array of them"));
    }
    let mut whole: Option<NearestTable> = None;
    for piece in Array::from(pieces).iter() {
        let next = read_piece(&piece)?;
        match &mut whole {
            None => whole = Some(next),
            Some(whole) => whole.join(next).map_err(thrown)?,
        }
    }
    Ok(whole)
}

fn read_piece(piece: &JsValue) -> JsResult<NearestTable> {
    let field = |name: &str| Reflect::get(piece, &name.into()).unwrap_or(JsValue::UNDEFINED);
    let numbers = |name: &str| field(name).dyn_into::<Uint32Array>().map(|values| values.to_vec()).unwrap_or_default();
    let first = field("first").as_f64().filter(|v| v.fract() == 0.0 && (0.0..4294967295.0).contains(v)).ok_or_else(|| {
        thrown(Error::InvalidArgument {
            what: "a piece of nearest neighbours",
            got: "no whole number as first".into(),
            wanted: "one".into(),
        })
    })?;
    NearestTable::from_numbers(first as usize, &numbers("left"), &numbers("right")).map_err(thrown)
}

fn array(values: &[u32]) -> JsValue {
    Uint32Array::from(values).unchecked_into()
}

pub(super) fn pack_matches(matches: &[DescriptorMatch]) -> JsValue {
    object([
        ("indices", array(&matches.iter().flat_map(|m| [m.left as u32, m.right as u32]).collect::<Vec<_>>())),
        ("squares", array(&matches.iter().flat_map(|m| [m.square, m.second_square.unwrap_or(u32::MAX)]).collect::<Vec<_>>())),
    ])
}
