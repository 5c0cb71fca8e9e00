//! Sizes of sensors by maker and model, for photos whose EXIF has a focal length in mm and nothing to turn it into px.

/// Side of a pixel where nobody knows it, mm.
pub(super) const NOMINAL_PIXEL_MM: f64 = 0.001;

/// A sensor's width and height in mm.
type Size = [f64; 2];

/// Types of sensors whose size in mm makers do not state.
///
/// # Source
/// Wikipedia, Image sensor format, Table of sensor formats and sizes.
const TYPE_1_2_9: Size = [4.98, 3.74];
const TYPE_1_2_3: Size = [6.17, 4.55];
const TYPE_1_2: Size = [6.40, 4.80];
const TYPE_1_1_7: Size = [7.60, 5.70];
const TYPE_1_1_3: Size = [9.60, 7.20];
const TYPE_1: Size = [13.20, 8.80];
const FOUR_THIRDS: Size = [17.30, 13.00];

/// Sensors of cameras: the beginning of the maker's name and the models, as EXIF writes them, in small letters.
///
/// # Source
/// The type or the size stands in the maker's specifications of each camera, of phones as the side of a pixel and the number of pixels.
const SENSORS: &[(&str, &[&str], Size)] = &[
    // DJI, dji.com, specifications of Mavic Pro, Spark, Mavic Air, Mavic 2 Zoom, Mavic Mini, Mini 2, Phantom 3, Phantom 4, Inspire 1 (Zenmuse X3).
    (
        "dji",
        &["fc220", "fc1102", "fc2103", "fc2204", "fc7203", "fc7303", "fc300c", "fc300s", "fc300x", "fc300se", "fc330", "fc350", "fc350z"],
        TYPE_1_2_3,
    ),
    // Phantom 4 Pro, Phantom 4 RTK, Zenmuse X4S, Air 2S.
    ("dji", &["fc6310", "fc6310s", "fc6310r", "fc6510", "fc3411"], TYPE_1),
    // P4 Multispectral.
    ("dji", &["fc6360"], TYPE_1_2_9),
    // Mavic Air 2.
    ("dji", &["fc3170"], TYPE_1_2),
    // Mini 3 Pro.
    ("dji", &["fc3582"], TYPE_1_1_3),
    // Zenmuse X5, X5S, Mavic 3 Enterprise and Multispectral.
    ("dji", &["fc550", "fc550raw", "fc6520", "m3e", "m3m"], FOUR_THIRDS),
    // Zenmuse X7.
    ("dji", &["fc6540"], [23.5, 15.7]),
    // Zenmuse P1.
    ("dji", &["zenmusep1"], [35.9, 24.0]),
    // Mavic 2 Pro and Mavic 3, with cameras of Hasselblad.
    ("hasselblad", &["l1d-20c"], TYPE_1),
    ("hasselblad", &["l2d-20c"], FOUR_THIRDS),
    // Skydio 2; Yuneec E90.
    ("skydio", &["2"], TYPE_1_2_3),
    ("yuneec", &["e90"], TYPE_1),
    // Canon, specifications of the PowerShot cameras that kites, balloons and fixed wings carry, and of the EOS cameras.
    (
        "canon",
        &[
            "canon powershot sx230 hs",
            "canon powershot sx260 hs",
            "canon powershot sx280 hs",
            "canon powershot elph 110 hs",
            "canon powershot elph 300 hs",
            "canon powershot elph 520 hs",
            "canon ixus 125 hs",
            "canon ixus 127 hs",
            "canon ixus 220 hs",
        ],
        TYPE_1_2_3,
    ),
    (
        "canon",
        &["canon powershot s95", "canon powershot s100", "canon powershot s110", "canon powershot g12", "canon powershot g15"],
        TYPE_1_1_7,
    ),
    ("canon", &["canon powershot g7 x", "canon powershot g7 x mark ii", "canon powershot g9 x"], TYPE_1),
    ("canon", &["canon eos m", "canon eos m10", "canon eos 600d", "canon eos 650d", "canon eos 700d"], [22.3, 14.9]),
    ("canon", &["canon eos 5d mark ii", "canon eos 5d mark iii"], [36.0, 24.0]),
    // Sony, specifications of Cyber-shot, NEX and Alpha cameras.
    ("sony", &["dsc-wx220", "dsc-wx350", "dsc-wx500", "dsc-hx60", "dsc-qx10"], TYPE_1_2_3),
    ("sony", &["dsc-rx100", "dsc-rx100m2", "dsc-rx100m3", "dsc-rx100m4", "dsc-rx100m5", "dsc-rx10", "dsc-qx100"], TYPE_1),
    ("sony", &["nex-5n", "nex-7", "ilce-5000", "ilce-5100", "ilce-6000", "ilce-6300", "ilce-6500"], [23.5, 15.6]),
    ("sony", &["ilce-qx1"], [23.2, 15.4]),
    ("sony", &["dsc-rx1", "dsc-rx1r"], [35.8, 23.9]),
    ("sony", &["dsc-rx1rm2", "ilce-7r", "ilce-7rm2", "ilce-7rm3"], [35.9, 24.0]),
    ("sony", &["ilce-7rm4"], [35.7, 23.8]),
    // Nikon, specifications of Coolpix A, D7000, D800 and D810.
    ("nikon", &["coolpix a", "nikon d7000"], [23.6, 15.6]),
    ("nikon", &["nikon d800", "nikon d800e", "nikon d810"], [35.9, 24.0]),
    // Ricoh GR and GR II.
    ("ricoh", &["gr", "gr ii"], [23.7, 15.7]),
    // Panasonic Lumix GH3 and GH4.
    ("panasonic", &["dmc-gh3", "dmc-gh4"], [17.3, 13.0]),
    // Apple: pixels of 1.5 µm and 3264 x 2448 px; of 1.22 µm and 4032 x 3024 px.
    ("apple", &["iphone 5s", "iphone 6", "iphone 6 plus"], [4.90, 3.67]),
    ("apple", &["iphone 7", "iphone 8", "iphone x"], [4.92, 3.69]),
    // Google: pixels of 1.55 µm and 4048 x 3036 px; of 1.4 µm and 4032 x 3024 px. Samsung Galaxy S7: as the latter.
    ("google", &["pixel", "pixel xl"], [6.27, 4.71]),
    ("google", &["pixel 2", "pixel 2 xl", "pixel 3"], [5.64, 4.23]),
    ("samsung", &["sm-g930f", "sm-g935f"], [5.64, 4.23]),
];

/// Width and height in mm of the sensor of a camera; `None` where it is not listed.
pub(super) fn sensor_mm(make: &str, model: &str) -> Option<Size> {
    let [make, model] = [make, model].map(|name| name.trim().to_lowercase());
    SENSORS.iter().find(|(maker, models, _)| make.starts_with(maker) && models.contains(&model.as_str())).map(|(.., size)| *size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sensors_are_found_as_exif_writes_them() {
        assert_eq!(sensor_mm("DJI", "FC6310R"), Some(TYPE_1));
        assert_eq!(sensor_mm("NIKON CORPORATION", "NIKON D800 "), Some([35.9, 24.0]));
        assert_eq!(sensor_mm("Canon", "Canon PowerShot SX260 HS"), Some(TYPE_1_2_3));
        assert_eq!(sensor_mm("Canon", "Canon PowerShot SX2600 HS"), None);
    }

    #[test]
    fn each_model_is_listed_once_with_the_sides_of_a_sensor() {
        let mut seen = std::collections::BTreeSet::new();
        for (make, models, [width, height]) in SENSORS {
            assert!((1.2..=1.52).contains(&(width / height)) && (3.0..=60.0).contains(width), "{make} {models:?}");
            for model in *models {
                assert!(seen.insert((make, model)), "{make} {model} is listed twice");
                assert_eq!(*model, model.to_lowercase());
            }
        }
    }
}
