//! An image in wasm memory, and what is found in it.

use super::convert::{
    Bytes, JsResult, Number, Numbers, Text, numbers, object, pack, points, read, read_options, set, thrown, whole, whole_from,
};
use crate::{
    Bands, DecodeLimits, Decoded, DroneRecord, Error, ExifCamera, GreyImage, GreyView, PairImage, PairSettings, PointSet, Reduced,
    ReportImage, Strategy, WindowOptions, decode, describe, describe_image, detect, reduce_to, window_moments,
};
use js_sys::Uint8Array;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What is known of a decoded image. */
export interface PhotoInfo { width: number; height: number; format: string; bits_per_sample: number; camera: ExifCamera | null; drone: DroneRecord | null }

/** An image halved a number of times: grey values 0..255, row by row. */
export interface ReducedImage { width: number; height: number; halvings: number; grey: Uint8Array }

/** Interest points: x and y in px and the interest value, stride 3; in raster order, those of many scales by octave. */
export interface DetectedPoints {
    counts: PointCounts;
    threshold: number;
    points: Float64Array;
    /** Of each point scale in px and dominant direction in rad from x towards y, stride 2; empty for operators that look at one scale. */
    frames: Float64Array;
}

/** Interest points with what a strategy compares them by. */
export interface DescribedPoints extends DetectedPoints {
    /** Seven numbers a point for the strategies that compare moments, NaN where a window leaves the image or is constant; else empty. */
    moments: Float64Array;
    /** 128 bytes a point for the strategy that compares gradients; else empty. */
    gradients: Uint8Array;
}

/** The window of a point: its grey values row by row, which of them lie within the outline, and its moments. */
export interface WindowReport {
    side: number;
    grey: number[];
    mask: boolean[];
    /** The centroid in image coordinates, px. */
    centroid_px: [number, number];
    axis_angle_deg: number;
    central: Record<"mu00" | "mu20" | "mu11" | "mu02" | "mu30" | "mu21" | "mu12" | "mu03", number>;
    normalized: Record<"mu20" | "mu11" | "mu02" | "mu30" | "mu21" | "mu12" | "mu03", number>;
    invariants: number[];
}
"#;

/// A grey image in wasm memory. Call `free` when it is no longer needed.
#[wasm_bindgen]
pub struct Photo {
    grey: GreyImage,
    format: &'static str,
    bits_per_sample: u8,
    camera: Option<ExifCamera>,
    drone: Option<Box<DroneRecord>>,
}

/// Why a file is refused whose first bytes, or the ending of whose name where these say nothing, are those of a kind that is not decoded (HEIC, raw, film, …);
/// null for all others. 64 bytes tell every kind but raw files that are TIFFs.
#[wasm_bindgen(unchecked_return_type = "{ kind: string } | null")]
pub fn refused_kind(name: &Text, start: &Bytes) -> JsResult<JsValue> {
    Ok(pack(&crate::refused_kind(&name.read("name")?, &start.read("start of the file")?)))
}

#[wasm_bindgen]
impl Photo {
    /// Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file.
    pub fn decode(bytes: &Bytes) -> JsResult<Photo> {
        let bytes = bytes.read("file of the image")?;
        let Decoded { grey, format, bits_per_sample, camera, drone } = decode(&bytes, &DecodeLimits::default()).map_err(thrown)?;
        Ok(Self { grey, format, bits_per_sample, camera, drone })
    }

    /// Takes grey values 0..255, row by row.
    pub fn from_grey(width: &Number, height: &Number, grey: &Bytes) -> JsResult<Photo> {
        let size @ [width, height] = [whole("width", width)?, whole("height", height)?];
        let grey = GreyImage::new(width, height, grey.read_image("grey values", size)?).map_err(thrown)?;
        Ok(Self { grey, format: "grey values", bits_per_sample: 8, camera: None, drone: None })
    }

    #[wasm_bindgen(getter)]
    pub fn width(&self) -> usize {
        self.grey.width()
    }

    #[wasm_bindgen(getter)]
    pub fn height(&self) -> usize {
        self.grey.height()
    }

    /// Size, format, camera and drone.
    #[wasm_bindgen(unchecked_return_type = "PhotoInfo")]
    pub fn info(&self) -> JsValue {
        object([
            ("width", (self.grey.width() as f64).into()),
            ("height", (self.grey.height() as f64).into()),
            ("format", self.format.into()),
            ("bits_per_sample", self.bits_per_sample.into()),
            ("camera", pack(&self.camera)),
            ("drone", pack(&self.drone)),
        ])
    }

    /// A copy of the grey values, row by row.
    pub fn grey(&self) -> Vec<u8> {
        self.grey.data().to_vec()
    }

    /// The image halved until its longer side is at most `max_side` px.
    #[wasm_bindgen(unchecked_return_type = "ReducedImage")]
    pub fn reduced(&self, max_side: &Number) -> JsResult<JsValue> {
        Ok(pack_reduced(&reduce_to(self.grey.view(), whole_from("longest side", max_side, 1..=u32::MAX)? as usize)))
    }

    /// Finds interest points by the groups `points` and `multiscale` of the settings. Points whose pixel is 0 in the mask, of the image's size
    /// and row by row, are left out.
    #[wasm_bindgen(unchecked_return_type = "DetectedPoints")]
    pub fn detect(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
        mask: Option<Bytes>,
    ) -> JsResult<JsValue> {
        let mask = read_mask(mask)?;
        let settings = read_options::<PairSettings>("settings", settings)?.resolved();
        let set = detect(self.view(), self.masked(&mask)?, &settings.points, &settings.multiscale).map_err(thrown)?;
        Ok(pack_points(&set))
    }

    /// Finds interest points and describes them as the strategy of the settings needs it.
    #[wasm_bindgen(unchecked_return_type = "DescribedPoints")]
    pub fn describe_points(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Given<PairSettings>")] settings: &JsValue,
        mask: Option<Bytes>,
    ) -> JsResult<JsValue> {
        let mask = read_mask(mask)?;
        let settings: PairSettings = read_options("settings", settings)?;
        let described = describe_image(self.view(), self.masked(&mask)?, &settings).map_err(thrown)?;
        let packed = pack_points(&described.set);
        set(&packed, "moments", &numbers(described.moments.into_iter().flat_map(|d| d.unwrap_or([f64::NAN; 7]))));
        set(&packed, "gradients", &Uint8Array::from(&described.gradients[..]).into());
        Ok(packed)
    }

    /// Describes points (stride 3) by the seven numbers each that a strategy compares; NaN where a window leaves the image or is constant.
    /// Empty for the strategies that compare grey values.
    pub fn describe(
        &self,
        point_list: &Numbers,
        #[wasm_bindgen(unchecked_param_type = "Given<WindowOptions>")] window: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Strategy")] strategy: &JsValue,
    ) -> JsResult<Vec<f64>> {
        let (window, strategy): (WindowOptions, Strategy) = (read_options("window", window)?, read("strategy", strategy)?);
        let Some(measure) = strategy.measure() else { return Ok(Vec::new()) };
        let described = describe(self.grey.view(), &points("points", &point_list.read("points")?)?, &window, measure).map_err(thrown)?;
        Ok(described.into_iter().flat_map(|d| d.unwrap_or([f64::NAN; 7])).collect())
    }

    /// The window around a pixel (column and row from 0) with its moments.
    #[wasm_bindgen(unchecked_return_type = "WindowReport")]
    pub fn window_moments(
        &self,
        col: &Number,
        row: &Number,
        #[wasm_bindgen(unchecked_param_type = "Given<WindowOptions>")] window: &JsValue,
    ) -> JsResult<JsValue> {
        let options: WindowOptions = read_options("window", window)?;
        self.report(whole("column", col)?, whole("row", row)?, &options).map_err(thrown)
    }
}

impl Photo {
    /// The image with a mask of its size.
    pub(super) fn pair_image<'m>(&'m self, mask: &'m Option<Vec<u8>>) -> JsResult<PairImage<'m>> {
        Ok(PairImage { grey: self.grey.view(), exif: self.camera.as_ref(), mask: self.masked(mask)? })
    }

    /// A mask of the image's size.
    pub(super) fn masked<'m>(&self, mask: &'m Option<Vec<u8>>) -> JsResult<Option<GreyView<'m>>> {
        mask.as_ref().map(|mask| GreyView::new(self.grey.width(), self.grey.height(), mask)).transpose().map_err(thrown)
    }

    /// A copy with a name and a mask of its size, for a report.
    pub(super) fn named(&self, name: String, mask: Option<Vec<u8>>) -> JsResult<ReportImage> {
        let mask = mask.map(|mask| GreyImage::new(self.grey.width(), self.grey.height(), mask)).transpose().map_err(thrown)?;
        Ok(ReportImage { name, grey: self.grey.clone(), exif: self.camera.clone(), mask })
    }

    /// Its grey values.
    pub(super) fn bands(&self) -> Bands {
        self.grey.clone().into()
    }

    pub(super) fn view(&self) -> GreyView<'_> {
        self.grey.view()
    }

    fn report(&self, col: usize, row: usize, options: &WindowOptions) -> Result<JsValue, Error> {
        let image = self.grey.view();
        let m = window_moments(image, col, row, options)?;
        let reach = options.side / 2;
        let grey: Vec<u8> = (row - reach..=row + reach).flat_map(|r| &image.row(r)[col - reach..=col + reach]).copied().collect();
        let n = m.normalized();
        let [x, y] = m.centroid_px;
        Ok(object([
            ("side", (options.side as f64).into()),
            ("grey", pack(&grey)),
            ("mask", pack(&options.mask()?)),
            ("centroid_px", pack(&[col as f64 + 0.5 + x, row as f64 + 0.5 + y])),
            ("axis_angle_deg", m.axis_angle_rad().to_degrees().into()),
            (
                "central",
                object([
                    ("mu00", m.mu00.into()),
                    ("mu20", m.mu20.into()),
                    ("mu11", m.mu11.into()),
                    ("mu02", m.mu02.into()),
                    ("mu30", m.mu30.into()),
                    ("mu21", m.mu21.into()),
                    ("mu12", m.mu12.into()),
                    ("mu03", m.mu03.into()),
                ]),
            ),
            (
                "normalized",
                object([
                    ("mu20", n[0].into()),
                    ("mu11", n[1].into()),
                    ("mu02", n[2].into()),
                    ("mu30", n[3].into()),
                    ("mu21", n[4].into()),
                    ("mu12", n[5].into()),
                    ("mu03", n[6].into()),
                ]),
            ),
            ("invariants", pack(&m.invariants())),
        ]))
    }
}

/// The pixels of a mask, where there is one.
pub(super) fn read_mask(mask: Option<Bytes>) -> JsResult<Option<Vec<u8>>> {
    mask.map(|mask| mask.read("mask")).transpose()
}

pub(super) fn pack_points(set: &PointSet) -> JsValue {
    object([
        ("counts", pack(&set.counts)),
        ("threshold", set.threshold.into()),
        ("points", numbers(set.points.iter().flat_map(|p| [p.x, p.y, p.value]))),
        ("frames", numbers(set.frames.iter().flat_map(|f| [f.scale_px, f.orientation_rad]))),
    ])
}

fn pack_reduced(reduced: &Reduced) -> JsValue {
    object([
        ("width", (reduced.image.width() as f64).into()),
        ("height", (reduced.image.height() as f64).into()),
        ("halvings", reduced.halvings.into()),
        ("grey", Uint8Array::from(reduced.image.data()).into()),
    ])
}
