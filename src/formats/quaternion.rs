//! Rotations as unit quaternions, in the axes that computer vision has: x right, y down, z with the view.

use crate::Pose;

/// A rotation from object to camera as `[w, x, y, z]` of unit length, w not negative, and the translation t of camera = R·X + t.
pub(super) fn vision_pose(pose: &Pose) -> ([f64; 4], [f64; 3]) {
    let m = pose.rotation;
    let r = [m[0], m[1].map(|v| -v), m[2].map(|v| -v)];
    let c = pose.position;
    let t = r.map(|row| 0.0 - (row[0] * c[0] + row[1] * c[1] + row[2] * c[2]));
    (quaternion(&r), t)
}

/// The pose of such a quaternion, of any length above 0, and translation.
pub(super) fn pose_of_vision(quaternion: [f64; 4], t: [f64; 3]) -> Option<Pose> {
    let length = quaternion.iter().map(|v| v * v).sum::<f64>().sqrt();
    if !(length.is_finite() && length > 1e-12) {
        return None;
    }
    let [w, x, y, z] = quaternion.map(|v| v / length);
    let r = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let position = [0, 1, 2].map(|k| -(r[0][k] * t[0] + r[1][k] * t[1] + r[2][k] * t[2]));
    Some(Pose { rotation: [r[0], r[1].map(|v| -v), r[2].map(|v| -v)], position })
}

/// # Source
/// Shepperd 1978, Quaternion from rotation matrix: the largest component is found first.
fn quaternion(r: &[[f64; 3]; 3]) -> [f64; 4] {
    let diagonal = [r[0][0], r[1][1], r[2][2]];
    let trace = diagonal[0] + diagonal[1] + diagonal[2];
    let squares = [trace, diagonal[0], diagonal[1], diagonal[2]].map(|part| 1.0 + 2.0 * part - trace);
    let largest = (1..4).fold(0, |best, k| if squares[k] > squares[best] { k } else { best });
    let first = 0.5 * squares[largest].max(0.0).sqrt();
    let by = 0.25 / first;
    let (wx, wy, wz) = (r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]);
    let (xy, xz, yz) = (r[0][1] + r[1][0], r[0][2] + r[2][0], r[1][2] + r[2][1]);
    let q = match largest {
        0 => [first, wx * by, wy * by, wz * by],
        1 => [wx * by, first, xy * by, xz * by],
        2 => [wy * by, xy * by, first, yz * by],
        _ => [wz * by, xz * by, yz * by, first],
    };
    if q[0] < 0.0 { q.map(|v| -v) } else { q }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation_from_angles;

    #[test]
    fn poses_come_back_from_their_quaternions() {
        for (omega, phi, kappa) in [(0.1, -0.2, 0.3), (3.0, 0.2, -1.0), (-2.0, 1.4, 3.1), (0.0, 0.0, 0.0), (3.1, 0.0, 3.1), (0.0, 3.1, 0.0)]
        {
            let m = rotation_from_angles(omega, phi, kappa);
            let pose = Pose::new(&m, [10.0, -20.0, 300.0]);
            let (q, t) = vision_pose(&pose);
            assert!(q[0] >= 0.0 && (q.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-14);
            let back = pose_of_vision(q.map(|v| 2.0 * v), t).unwrap();
            for (a, b) in back.rotation.iter().flatten().zip(pose.rotation.iter().flatten()) {
                assert!((a - b).abs() < 1e-14, "{omega} {phi} {kappa}");
            }
            assert!(back.position.iter().zip(pose.position).all(|(a, b)| (a - b).abs() < 1e-11));
        }
        assert!(pose_of_vision([0.0; 4], [0.0; 3]).is_none() && pose_of_vision([f64::NAN; 4], [0.0; 3]).is_none());
    }

    #[test]
    fn an_upright_photo_that_looks_down_is_half_a_turn_about_x() {
        let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [1.0, 2.0, 3.0] };
        assert_eq!(vision_pose(&pose), ([0.0, 1.0, 0.0, 0.0], [-1.0, 2.0, 3.0]));
    }
}
