//! Images of a block that are chosen by their names.

use crate::error::refuse;
use crate::{BlockModel, Error, Refusal};

/// So many names of images are listed where another one was given.
const MOST_LISTED: usize = 20;

/// Which images of a block these names choose; all of them where there are none.
///
/// # Errors
/// [`Error::InvalidInput`] for a name of no oriented image, with the names of those.
pub(super) fn chosen(model: &BlockModel, names: &[String]) -> Result<Vec<bool>, Error> {
    let oriented = || model.images.iter().filter(|image| image.pose.is_some()).map(|image| &image.name);
    if let Some(name) = names.iter().find(|name| !oriented().any(|own| own == *name)) {
        let mut listed: Vec<&str> = oriented().take(MOST_LISTED + 1).map(String::as_str).collect();
        if listed.len() > MOST_LISTED {
            listed[MOST_LISTED] = "…";
        }
        return refuse(Refusal::MosaicName { name: name.clone(), names: listed.join(", ") });
    }
    Ok(model.images.iter().map(|image| names.is_empty() || names.contains(&image.name)).collect())
}
