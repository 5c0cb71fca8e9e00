//! What came of the orthophoto that a block was given.

use crate::Failure;
use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What came of the orthophoto that a block was given.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum OnOrthophoto as "on_orthophoto" {
        /// The block is adjusted by so many places of the orthophoto's ground; others check it, or were rejected. `linked` of `images` show one. It lies
        /// in the system of the orthophoto, or, `in_crs`, in the coordinate reference system that it has.
        Linked {
            linked: usize,
            images: usize,
            points: usize,
            checks: usize,
            rejected: usize,
            #[serde(default, skip_serializing_if = "std::ops::Not::not")]
            in_crs: bool,
            /// The EPSG code of the system of the orthophoto, where that is known.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            epsg: Option<u16>,
        },
        /// Places that were measured by hand brought the block into the system of the orthophoto, or, `in_crs`, into the coordinate reference system that it
        /// has: so many, which `linked` of `images` show.
        ByHand {
            linked: usize,
            images: usize,
            points: usize,
            #[serde(default, skip_serializing_if = "std::ops::Not::not")]
            in_crs: bool,
            /// The EPSG code of the system of the orthophoto, where that is known.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            epsg: Option<u16>,
        },
        /// The block is as it was without it.
        NotLinked { not_linked: NotLinked },
    }
}

messages! {
    /// Why a block is not in the system of an orthophoto.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NotLinked as "not_linked" {
        /// The block has no orientation.
        NotOriented,
        /// The block has a coordinate reference system, in which the version that wrote this did not adjust by an orthophoto.
        OwnSystem { crs: String },
        /// The block has a coordinate reference system that nothing leads to from that of the orthophoto.
        OtherSystem { orthophoto: Option<String>, crs: String, failure: Failure },
        /// Too few images were placed on it.
        FewImages { placed: usize, images: usize, needed: usize },
        /// Too few places of its ground are shown by two images or more.
        FewPoints { points: usize, needed: usize },
        /// Most places contradict the block.
        Disagreement { rejected: usize, points: usize },
        /// The block as the orthophoto has it lies elsewhere than its ground control points: orthophoto minus control.
        Contradiction { x_m: f64, y_m: f64, z_m: f64 },
        /// The adjustment has no result.
        Failed { failure: Failure },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_earlier_versions_wrote_is_read() {
        let read: OnOrthophoto =
            serde_json::from_str(r#"{"kind":"not_linked","not_linked":{"kind":"own_system","crs":"EPSG:25832"}}"#).unwrap();
        assert_eq!(read, OnOrthophoto::NotLinked { not_linked: NotLinked::OwnSystem { crs: "EPSG:25832".into() } });
        // Before they kept the code of the orthophoto.
        let text = r#"{"kind":"linked","linked":8,"images":8,"points":40,"checks":9,"rejected":0}"#;
        let read: OnOrthophoto = serde_json::from_str(text).unwrap();
        assert!(matches!(read, OnOrthophoto::Linked { epsg: None, in_crs: false, .. }));
        assert_eq!(serde_json::to_string(&read).unwrap(), text);
    }
}
