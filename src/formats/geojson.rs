//! GeoJSON of image positions and points, for maps.

use crate::error::refuse;
use crate::math::geographic_from_local;
use crate::{BlockModel, Error, Refusal};
use serde_json::{Value, json};

/// A collection of features: a point for each oriented image and for each intersected point; `by_hand`: how many of its observations were measured by
/// hand.
///
/// # Errors
/// [`Error::InvalidInput`] for a block without an origin on the earth: GeoJSON knows longitudes and latitudes alone.
///
/// # Source
/// RFC 7946, The GeoJSON Format.
pub(super) fn write_geojson(model: &BlockModel) -> Result<String, Error> {
    let Some(origin) = model.origin else {
        return refuse(Refusal::OwnSystem);
    };
    let origin = [origin.longitude_deg, origin.latitude_deg, origin.height_m];
    let feature = |position: [f64; 3], properties: Value| {
        let [longitude, latitude, height] = geographic_from_local(position, origin);
        // A thousand-millionth of a degree is a tenth of a millimetre on the ground.
        let rounded = [(longitude * 1e9).round() / 1e9, (latitude * 1e9).round() / 1e9, (height * 1e4).round() / 1e4];
        json!({"type": "Feature", "geometry": {"type": "Point", "coordinates": rounded}, "properties": properties})
    };
    let images = model.images.iter().filter_map(|image| Some(feature(image.pose?.position, json!({"kind": "image", "name": image.name}))));
    let points = model.points.iter().zip(model.point_numbers()).filter_map(|(point, number)| {
        let properties =
            json!({"kind": "point", "point": number, "rays": point.rays.len(), "by_hand": point.by_hand, "confidence": point.confidence, "rmse_px": point.rmse_px});
        Some(feature(point.position?, properties))
    });
    let features: Vec<String> = images.chain(points).map(|feature| feature.to_string()).collect();
    Ok(format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}\n", features.join(",\n")))
}
