//! Longitude, latitude and height on WGS 84, and metres east, north and up from a place.

use super::median;

/// Semi-major axis in m and flattening of WGS 84.
const AXIS: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
const ECCENTRICITY_2: f64 = FLATTENING * (2.0 - FLATTENING);

/// `[east, north, up]` in m, in the system that touches the ellipsoid at `origin`, of a place `[longitude, latitude, height]` in degrees and
/// m; the origin likewise.
///
/// # Source
/// Torge & Müller 2012, Geodesy, section 4.1.
pub fn local_from_geographic(place: [f64; 3], origin: [f64; 3]) -> [f64; 3] {
    let (at, from) = (earth_centred(place), earth_centred(origin));
    let d = [at[0] - from[0], at[1] - from[1], at[2] - from[2]];
    axes(origin).map(|axis| axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2])
}

/// A difference of longitudes in degrees by the shorter way around.
pub(crate) fn turn(degrees: f64) -> f64 {
    degrees - 360.0 * (degrees / 360.0).round()
}

/// The median of longitudes in degrees, between -180 and 180; `None` where there are none. They count from that of the median direction, so that
/// those on either side of the date line have their median there, and a few that are far from all others do not move it.
pub(crate) fn median_longitude(degrees: &[f64]) -> Option<f64> {
    let median_of = |value: &dyn Fn(f64) -> f64| median(&mut degrees.iter().map(|longitude| value(*longitude)).collect::<Vec<f64>>());
    let [sine, cosine] = [libm::sin, libm::cos].map(|f| median_of(&|longitude| f(longitude.to_radians())));
    let from = libm::atan2(sine?, cosine?).to_degrees();
    Some(turn(from + median_of(&|longitude| turn(longitude - from))?))
}

/// The inverse of [`local_from_geographic`].
///
/// # Source
/// Bowring 1976, Transformation from spatial to geographical coordinates; repeated until the latitude stands.
pub fn geographic_from_local(local: [f64; 3], origin: [f64; 3]) -> [f64; 3] {
    let (from, axes) = (earth_centred(origin), axes(origin));
    let [x, y, z] = [0, 1, 2].map(|k| from[k] + axes[0][k] * local[0] + axes[1][k] * local[1] + axes[2][k] * local[2]);
    let from_axis = (x * x + y * y).sqrt();
    let minor = AXIS * (1.0 - FLATTENING);
    let mut reduced = libm::atan2(z * AXIS, from_axis * minor);
    let mut latitude = 0.0;
    for _ in 0..5 {
        let (s, c) = (libm::sin(reduced), libm::cos(reduced));
        let second = ECCENTRICITY_2 / (1.0 - ECCENTRICITY_2);
        latitude = libm::atan2(z + second * minor * s * s * s, from_axis - ECCENTRICITY_2 * AXIS * c * c * c);
        reduced = libm::atan2((1.0 - FLATTENING) * libm::sin(latitude), libm::cos(latitude));
    }
    let (s, c) = (libm::sin(latitude), libm::cos(latitude));
    let height = from_axis * c + z * s - AXIS * (1.0 - ECCENTRICITY_2 * s * s).sqrt();
    [libm::atan2(y, x).to_degrees(), latitude.to_degrees(), height]
}

/// Coordinates in m from the centre of the earth.
fn earth_centred([longitude, latitude, height]: [f64; 3]) -> [f64; 3] {
    let (lon, lat) = (longitude.to_radians(), latitude.to_radians());
    let (s, c) = (libm::sin(lat), libm::cos(lat));
    let normal = AXIS / (1.0 - ECCENTRICITY_2 * s * s).sqrt();
    [(normal + height) * c * libm::cos(lon), (normal + height) * c * libm::sin(lon), (normal * (1.0 - ECCENTRICITY_2) + height) * s]
}

/// East, north and up at a place.
fn axes([longitude, latitude, _]: [f64; 3]) -> [[f64; 3]; 3] {
    let (lon, lat) = (longitude.to_radians(), latitude.to_radians());
    let ((sl, cl), (sp, cp)) = ((libm::sin(lon), libm::cos(lon)), (libm::sin(lat), libm::cos(lat)));
    [[-sl, cl, 0.0], [-sp * cl, -sp * sl, cp], [cp * cl, cp * sl, sp]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longitudes_on_either_side_of_the_date_line_have_their_median_there() {
        let median = |degrees: &[f64]| median_longitude(degrees).unwrap();
        let half = median(&[179.99, 179.98, -179.98, -179.99]);
        assert!((half.abs() - 180.0).abs() < 1e-9, "{half}");
        assert!((median(&[0.0, 179.9, 179.7, -179.8, -179.9]) + 179.9).abs() < 1e-9);
        assert!((median(&[8.2, 8.0, 8.1]) - 8.1).abs() < 1e-12 && (median(&[359.0, 1.5, 0.5]) - 0.5).abs() < 1e-9);
        assert!(median_longitude(&[]).is_none());
    }

    #[test]
    fn places_come_back() {
        for origin in [[8.0, 50.0, 200.0], [-179.9, -89.0, 10.0], [0.0, 0.0, 0.0], [120.0, -33.0, 4000.0]] {
            for local in [[0.0; 3], [1000.0, -2000.0, 300.0], [-50_000.0, 20_000.0, 5000.0]] {
                let back = local_from_geographic(geographic_from_local(local, origin), origin);
                for (got, wanted) in back.iter().zip(local) {
                    assert!((got - wanted).abs() < 1e-6, "{origin:?} {local:?}: {back:?}");
                }
            }
        }
    }

    #[test]
    fn a_minute_of_latitude_is_about_a_sea_mile() {
        let [east, north, up] = local_from_geographic([8.0, 45.0 + 1.0 / 60.0, 0.0], [8.0, 45.0, 0.0]);
        assert!(east.abs() < 1e-6 && (north - 1852.0).abs() < 2.0 && up < 0.0 && up > -1.0, "{east} {north} {up}");
    }
}
