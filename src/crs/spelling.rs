//! Spellings of systems that the library does not read, in those that it does.

/// A text of a system as the library reads it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spelling {
    pub text: String,
    /// The unit of heights that PROJ text states, in m: the library reads none.
    pub height_unit_m: Option<f64>,
}

/// The Swiss projection is the oblique Mercator projection whose central line runs east: EPSG method 9815 with an azimuth of 90°.
const SWISS: [&str; 3] = ["+proj=omerc", "+alpha=90", "+gamma=90"];
/// Names of projections in WKT, and what stands for them: those of GDAL and Esri, and the Swiss one.
const IN_WKT: [(&str, &str); 4] = [
    ("\"Hotine_Oblique_Mercator_Azimuth_Center\"", "\"Hotine_Oblique_Mercator_Variant_B\""),
    ("\"Hotine_Oblique_Mercator_Azimuth_Natural_Origin\"", "\"Hotine_Oblique_Mercator\""),
    ("\"Swiss_Oblique_Cylindrical\"", "\"Hotine_Oblique_Mercator_Variant_B\"],PARAMETER[\"azimuth\",90"),
    ("\"Swiss_Oblique_Mercator\"", "\"Hotine_Oblique_Mercator_Variant_B\"],PARAMETER[\"azimuth\",90"),
];
/// Units of heights in PROJ text, in m.
const HEIGHT_UNITS: [(&str, f64); 3] = [("m", 1.0), ("ft", 0.3048), ("us-ft", 1200.0 / 3937.0)];

impl Spelling {
    /// Of no text.
    pub fn none() -> Self {
        Self { text: String::new(), height_unit_m: None }
    }

    pub fn of(text: &str) -> Self {
        if text.starts_with('+') {
            return Self::of_proj(text);
        }
        let text = IN_WKT.iter().fold(text.to_string(), |text, (name, meant)| text.replace(name, meant));
        Self { text, height_unit_m: None }
    }

    fn of_proj(text: &str) -> Self {
        let mut height_unit_m = None;
        let mut words: Vec<&str> = Vec::new();
        for word in text.split_whitespace() {
            match word.split_once('=') {
                Some(("+proj", "somerc")) => words.extend(SWISS),
                Some(("+vunits" | "+vto_meter", value)) if height_unit_of(value).is_some() => height_unit_m = height_unit_of(value),
                _ => words.push(word),
            }
        }
        Self { text: words.join(" "), height_unit_m }
    }
}

/// The unit of a name, or of a number of m; absent for what is neither.
fn height_unit_of(value: &str) -> Option<f64> {
    let named = HEIGHT_UNITS.iter().find(|(name, _)| *name == value).map(|(_, unit_m)| *unit_m);
    named.or_else(|| value.parse().ok().filter(|unit_m: &f64| unit_m.is_finite() && *unit_m > 0.0))
}
