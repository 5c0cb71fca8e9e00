//! Which image of a block a table means: tables of other programs name images with their folders, in other capitals or without the ending.

use crate::ImageMeasurementRow;
use std::collections::BTreeMap;

/// How a name means an image, the surest way first: of several rows of a table that mean the same one, the surest is of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Meant {
    /// By its name, with its folder where that is said.
    Name,
    /// By its file name in another folder.
    File,
    /// By its name with another ending, or without one.
    Stem,
}

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
        self.found(name).map(|(image, _)| image)
    }

    /// The same, and how the name means it.
    pub(super) fn found(&self, name: &str) -> Option<(usize, Meant)> {
        let file = file_of(name);
        let by_file = || self.by_file.get(&file).copied().flatten();
        let by_stem = |stem: &str| self.by_stem.get(stem).copied().flatten();
        let exact = self.exact.get(name).copied().or_else(|| self.within(name)).or_else(|| by_file().filter(|_| !has_folder(name)));
        let exact = exact.map(|image| (image, Meant::Name));
        let in_folder = || by_file().map(|image| (image, Meant::File));
        let of_ending = || by_stem(file.rsplit_once('.').filter(|(_, ending)| ENDINGS.contains(ending))?.0);
        exact.or_else(in_folder).or_else(|| by_stem(&file).or_else(of_ending).map(|image| (image, Meant::Stem)))
    }

    /// The image whose name, with a folder of its own, a longer path ends with; or that of `./name`.
    fn within(&self, name: &str) -> Option<usize> {
        let path = name.replace('\\', "/");
        let places = path.match_indices('/').map(|(place, _)| place + 1);
        let bare = path.strip_prefix("./");
        let ends = places.map(|place| &path[place..]).filter(|end| end.contains('/')).chain(bare);
        ends.into_iter().find_map(|end| self.exact.get(end)).copied()
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

fn has_folder(name: &str) -> bool {
    name.trim_start_matches("./").contains(['/', '\\'])
}

fn stem_of(file: &str) -> &str {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_tell_images_of_one_file_name_apart() {
        let names = ["100/DJI_1.JPG", "101/DJI_1.JPG", "DJI_2.JPG"].map(String::from);
        let images = NamedImages::new(&names);
        for (name, wanted) in [
            ("./100/DJI_1.JPG", Some((0, Meant::Name))),
            ("C:\\flight\\101\\DJI_1.JPG", Some((1, Meant::Name))),
            ("./102/DJI_1.JPG", None),
            ("DJI_1.JPG", None),
            ("./DJI_2.JPG", Some((2, Meant::Name))),
            ("dji_2.jpg", Some((2, Meant::Name))),
            ("100/DJI_2.JPG", Some((2, Meant::File))),
            ("./DJI_2.DNG", Some((2, Meant::Stem))),
            ("DJI_2", Some((2, Meant::Stem))),
        ] {
            assert_eq!(images.found(name), wanted, "{name}");
        }
    }

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
