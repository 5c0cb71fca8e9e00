//! How exact what places a block is, where it does not say so itself.

use crate::catalogue::options;

options! {
    /// Standard errors of GNSS positions and control points that state none.
    pub struct GeoreferencingOptions in "placing" {
        section "Standard errors of positions";

        /// The standard error of east and of north of GNSS positions that state none, some metres, or centimetres where they were corrected:
        /// higher gives them less weight.
        receiver_across_m: f64 = 3.0, "GNSS positions, horizontal", in "m", 0.001..=1000;

        /// The standard error of the height of GNSS positions that state none: higher gives it less weight.
        receiver_up_m: f64 = 6.0, "GNSS positions, vertical", in "m", 0.001..=1000;

        /// The standard error of x and of y of control points that state none: higher gives them less weight.
        surveyed_across_m: f64 = 0.02, "Control points, horizontal", in "m", 0.0001..=100;

        /// The standard error of the height of control points that state none: higher gives it less weight.
        surveyed_up_m: f64 = 0.03, "Control points, vertical", in "m", 0.0001..=100;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;

    #[test]
    fn a_standard_error_is_a_number_above_zero() {
        GeoreferencingOptions::default().check_ranges().unwrap();
        for wrong in [0.0, -1.0, f64::NAN] {
            let options = GeoreferencingOptions { receiver_up_m: wrong, ..GeoreferencingOptions::default() };
            assert!(matches!(options.check_ranges(), Err(Error::InvalidOption { field: "placing.receiver_up_m", .. })), "{wrong}");
        }
    }
}
