//! Which image of a block a table means: tables of other programs name images with their folders, in other capitals or without the ending.

use crate::ImageMeasurementRow;
use std::collections::BTreeMap;

/// The images of a block by what tables call them.
pub(super) struct NamedImages<'a> {
    exact: BTreeMap<&'a str, usize>,
    /// By file name in small letters, without folder; none where several have it.
    by_file: BTreeMap<String, Option<usize>>,
    /// The same without the ending.
    by_stem: BTreeMap<String, Option<usize>>,
}

impl<'a> NamedImages<'a> {
    pub(super) fn new(names: &'a [String]) -> Self {
        let exact = names.iter().enumerate().map(|(index, name)| (name.as_str(), index)).collect();
        let unique = |key: fn(&str) -> String| {
            let mut found = BTreeMap::new();
            for (index, name) in names.iter().enumerate() {
                found.entry(key(name)).and_modify(|image| *image = None).or_insert(Some(index));
            }
            found
        };
        Self { exact, by_file: unique(file_of), by_stem: unique(|name| stem_of(&file_of(name)).to_string()) }
    }

    /// The image that a name means: the one of this name, else the only one of this file name, else the only one of this name without its ending,
    /// where the name has none or that of another format of images; none where there is none, or several.
    pub(super) fn find(&self, name: &str) -> Option<usize> {
        let file = file_of(name);
        let found = self.exact.get(name).copied().or_else(|| self.by_file.get(&file).copied().flatten());
        let by_stem = |stem: &str| self.by_stem.get(stem).copied().flatten();
        found.or_else(|| by_stem(&file)).or_else(|| by_stem(file.rsplit_once('.').filter(|(_, ending)| ENDINGS.contains(ending))?.0))
    }
}

/// Image measurements with the names that these images have; those of images that are not among them stay as they are.
///
/// A table means the image of its name, else the only one of this file name whatever folder and capitals, else the only one of this name
/// without its ending, where its name has none or that of another format of images.
pub fn measurements_of_images(mut rows: Vec<ImageMeasurementRow>, images: &[String]) -> Vec<ImageMeasurementRow> {
    let named = NamedImages::new(images);
    for row in &mut rows {
        if let Some(image) = named.find(&row.image) {
            row.image.clone_from(&images[image]);
        }
    }
    rows
}

/// Of formats that photographs are kept in, in small letters: a block may be made from copies in another one.
const ENDINGS: [&str; 17] =
    ["arw", "bmp", "cr2", "cr3", "dng", "heic", "jpeg", "jpg", "nef", "orf", "pgm", "png", "ppm", "raf", "tif", "tiff", "webp"];

fn file_of(name: &str) -> String {
    name.rsplit(['/', '\\']).next().unwrap_or(name).to_lowercase()
}

fn stem_of(file: &str) -> &str {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_found_by_other_capitals_folders_and_without_endings_where_one_alone_is_meant() {
        let names = ["a/IMG_1.jpg", "b/IMG_1.jpg", "IMG_2.JPG", "IMG_2.png", "scan.1.tif", "Img_3.jpg", "img_3.jpg"].map(String::from);
        let images = NamedImages::new(&names);
        for (name, wanted) in [
            ("a/IMG_1.jpg", Some(0)),
            ("IMG_1.jpg", None),
            ("img_2.jpg", Some(2)),
            ("C:\\flight\\IMG_2.png", Some(3)),
            ("/home/flight/img_2.PNG", Some(3)),
            ("IMG_2", None),
            ("IMG_2.tif", None),
            ("scan.1", Some(4)),
            ("scan.1.JPG", Some(4)),
            ("b/scan.1.CR3", Some(4)),
            ("scan.1.txt", None),
            ("scan.tif", None),
            ("Scan.1.TIF", Some(4)),
            ("scan", None),
            ("Img_3.jpg", Some(5)),
            ("img_3.jpg", Some(6)),
            ("IMG_3.jpg", None),
            ("", None),
        ] {
            assert_eq!(images.find(name), wanted, "{name}");
            let row = ImageMeasurementRow { image: name.into(), point: "P1".into(), x_px: 1.0, y_px: 2.0 };
            let own = wanted.map_or(name, |image| &names[image]);
            assert_eq!(measurements_of_images(vec![row.clone()], &names), [ImageMeasurementRow { image: own.into(), ..row }]);
        }
    }
}
