//! MicMac's homologous points: one file for each pair of images, in both directions.

use super::sight::Sights;
use super::text::{file_name, not_written, one_word};
use crate::{BlockModel, Error};
use std::fmt::Write;

/// The files `Homol/Pastis<first>/<second>.txt` with lines of `x1 y1 x2 y2 weight`; in MicMac the centre of the top-left pixel is (0, 0).
///
/// # Source
/// MicMac, `src/uti_phgrm/phgr_basic.cpp`.
pub(super) fn write_homol(model: &BlockModel, sights: &Sights, emit: &mut dyn FnMut(&str, &str) -> Result<(), Error>) -> Result<(), Error> {
    let format = "MicMac Homol";
    for image in &model.images {
        one_word(format, file_name(format, &image.name)?)?;
    }
    for (pair, matches) in sights.pairs(model) {
        for [from, to] in [[0, 1], [1, 0]] {
            let mut text = String::new();
            for numbers in &matches {
                let [a, b] = [from, to].map(|side| sights.of_images[pair[side]][numbers[side]].ray);
                let [x1, y1, x2, y2] = [a.x_px, a.y_px, b.x_px, b.y_px].map(|v| v - 0.5);
                writeln!(text, "{x1} {y1} {x2} {y2} {}", a.confidence.min(b.confidence)).map_err(not_written)?;
            }
            emit(&format!("Homol/Pastis{}/{}.txt", model.images[pair[from]].name, model.images[pair[to]].name), &text)?;
        }
    }
    Ok(())
}
