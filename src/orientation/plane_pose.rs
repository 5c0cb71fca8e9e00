//! The relative orientations that the map of a plane allows: two, each with the base in either direction.

use super::coplanarity::RelativePose;
use crate::camera::nearest_rotation;
use nalgebra::Matrix3;

/// The poses of a homography between calibrated views; none where it is a rotation.
///
/// # Source
/// Ma, Soatto, Košecká & Sastry 2004, An Invitation to 3-D Vision, section 5.3 (after Tsai & Huang 1982).
pub(crate) fn poses_of_plane(homography: &Matrix3<f64>) -> Vec<RelativePose> {
    if !homography.iter().all(|v| v.is_finite()) {
        return Vec::new();
    }
    let svd = homography.svd(false, true);
    let Some(v) = svd.v_t.map(|v| v.transpose()) else { return Vec::new() };
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| svd.singular_values[*b].total_cmp(&svd.singular_values[*a]));
    let [largest, middle, least] = order.map(|k| svd.singular_values[k]);
    let [v1, v2, v3] = order.map(|k| v.column(k).into_owned());
    // Both cameras look at the same side of the plane.
    let h = homography / if homography.determinant() < 0.0 { -middle } else { middle };
    let (first, last) = (largest / middle, least / middle);
    let (a, b) = ((1.0 - last * last).max(0.0).sqrt(), (first * first - 1.0).max(0.0).sqrt());
    let spread = (first * first - last * last).sqrt();
    let mut poses = Vec::new();
    for across in [(v1 * a + v3 * b) / spread, (v1 * a - v3 * b) / spread] {
        let normal = v2.cross(&across);
        let before = Matrix3::from_columns(&[v2, across, normal]);
        let (turned, moved) = (h * v2, h * across);
        let after = Matrix3::from_columns(&[turned, moved, turned.cross(&moved)]);
        let Some(rotation) = nearest_rotation(&(after * before.transpose())) else { continue };
        // X₂ = R X₁ + T, T along (H - R) n.
        let Some(base) = (rotation.transpose() * (h - rotation) * normal).try_normalize(1e-9) else { continue };
        poses.extend([RelativePose { rotation, base }, RelativePose { rotation, base: -base }]);
    }
    poses
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;
    use nalgebra::Vector3;

    #[test]
    fn the_true_pose_is_among_those_of_its_plane() {
        for k in 0..20 {
            let t = f64::from(k);
            let rotation = rotation_from_angles(0.1 * libm::sin(t), 0.2 * libm::cos(2.0 * t), t);
            let base = Vector3::new(0.5, 0.3 * libm::sin(3.0 * t), 0.1).normalize();
            // The plane n·X = -d seen along -z: X₂ = R (X₁ - b) = R (I + b nᵀ/d) X₁.
            let normal = Vector3::new(0.2 * libm::cos(t), 0.1, 1.0).normalize();
            let homography = rotation * (Matrix3::identity() + base * normal.transpose() / 2.0) * -3.0;
            let poses = poses_of_plane(&homography);
            let miss = |p: &RelativePose| (p.rotation - rotation).amax().max((p.base - base).amax());
            assert_eq!(poses.len(), 4);
            assert!(poses.iter().any(|p| miss(p) < 1e-9), "{k}");
        }
    }

    #[test]
    fn a_rotation_has_no_base() {
        assert!(poses_of_plane(&rotation_from_angles(0.1, 0.2, 0.3)).is_empty());
        assert!(poses_of_plane(&Matrix3::from_element(f64::NAN)).is_empty());
    }
}
