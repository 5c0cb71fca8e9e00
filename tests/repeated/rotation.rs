//! M = M3(κ)·M2(φ)·M1(ω) in full.

/// Rows of M by ω, φ, κ in radians.
pub fn rotation([omega, phi, kappa]: [f64; 3]) -> [[f64; 3]; 3] {
    let ((so, co), (sp, cp), (sk, ck)) = (omega.sin_cos(), phi.sin_cos(), kappa.sin_cos());
    [
        [cp * ck, so * sp * ck + co * sk, so * sk - co * sp * ck],
        [-cp * sk, co * ck - so * sp * sk, co * sp * sk + so * ck],
        [sp, -so * cp, co * cp],
    ]
}

/// ω, φ, κ in radians.
pub fn angles(m: &[[f64; 3]; 3]) -> [f64; 3] {
    [(-m[2][1]).atan2(m[2][2]), m[2][0].asin(), (-m[1][0]).atan2(m[0][0])]
}

pub fn times(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}
