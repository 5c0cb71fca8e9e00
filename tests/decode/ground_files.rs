//! Orthophotos in planes, large height models, and both where their files leave tiles out: read where they are needed.

use super::counted::Counted;
use super::tiff_pictures::{Picture, directories};
use super::tiff_writer::Tag;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tiepoint::{DecodeLimits, Error, FileSource, HeightModel, Heights, Orthophoto};

const WORLD: &str = "1\n0\n0\n-1\n0.5\n-0.5\n";
const MEGABYTE: u64 = 1 << 20;

/// A square picture in tiles of which some are left out. `bands`: how many, each in a plane of its own.
fn tiled(side: usize, tile: usize, bands: usize, bits: u16, chunk: impl Fn(usize, [usize; 2]) -> Option<Vec<u8>>) -> Picture {
    let across = side.div_ceil(tile);
    let corner = |index: usize| [index % across * tile, index / across * tile];
    let chunks = (0..bands).flat_map(|band| (0..across * across).map(move |index| (band, index)));
    let tags = vec![
        Tag::Long(256, vec![side as u32]),
        Tag::Long(257, vec![side as u32]),
        Tag::Short(258, vec![bits; bands]),
        Tag::Short(259, vec![1]),
        Tag::Short(262, vec![if bands < 3 { 1 } else { 2 }]),
        Tag::Short(277, vec![bands as u16]),
        Tag::Short(284, vec![if bands == 1 { 1 } else { 2 }]),
        Tag::Short(322, vec![tile as u16]),
        Tag::Short(323, vec![tile as u16]),
        Tag::Short(339, vec![if bits == 32 { 3 } else { 1 }; bands]),
    ];
    let chunks = chunks.map(|(band, index)| chunk(band, corner(index)).unwrap_or_default()).collect();
    Picture { tags, chunks, tiled: true, more: Vec::new() }
}

/// The same with the value that stands for nothing.
fn with_no_data(picture: Picture, text: &str) -> Picture {
    Picture { more: vec![(42_113, 2, text.len() as u32 + 1, [text.as_bytes(), b"\0"].concat())], ..picture }
}

fn colour(band: usize, x: usize, y: usize) -> u8 {
    1 + ([x / 3, y / 3, (x + y) / 5][band] % 250) as u8
}

/// The tile of a plane whose corner that is.
fn tile_of(band: usize, [left, top]: [usize; 2], tile: usize) -> Vec<u8> {
    (0..tile * tile).map(|k| colour(band, left + k % tile, top + k / tile)).collect()
}

fn opened(file: Arc<dyn FileSource>) -> Orthophoto {
    Orthophoto::open(file, Some(WORLD), Heights::Level(0.0), &DecodeLimits::default()).unwrap()
}

#[test]
fn a_large_orthophoto_in_planes_is_read_where_it_is_needed() {
    // 12.5 tiles a side: of those at the right and below parts lie beyond the picture.
    let (side, tile) = (6_400, 512);
    let holds = |[left, top]: [usize; 2]| left < 2 * tile && top < 2 * tile || left == 12 * tile && top == left;
    let picture = tiled(side, tile, 3, 8, |band, corner| holds(corner).then(|| tile_of(band, corner, tile)));
    let read = Arc::new(AtomicU64::new(0));
    let orthophoto = opened(Arc::new(Counted(directories(&[picture]), Arc::clone(&read))));
    assert!(orthophoto.is_in_parts());
    let check = |first: [usize; 2]| {
        let shown = orthophoto.colours(first, [20, 20], 0).unwrap();
        for (k, rgba) in shown.as_chunks::<4>().0.iter().enumerate() {
            let [x, y] = [first[0] + k % 20, first[1] + k / 20];
            assert_eq!(rgba[..3], [0, 1, 2].map(|band| colour(band, x, y)), "at {x}, {y}");
        }
    };
    [[200, 200], [6_350, 6_350]].into_iter().for_each(check);
    // Three planes of two tiles, with what opening needs.
    let bytes = read.load(Ordering::Relaxed);
    assert!(bytes < 2 * MEGABYTE, "{bytes} bytes read");
    // Of four tiles at once.
    check([500, 500]);
    assert!(orthophoto.colours([3_000, 300], [4, 4], 0).unwrap().iter().all(|value| *value == 0));
}

#[test]
fn planes_of_which_the_file_leaves_tiles_out_have_the_value_for_nothing_there() {
    let picture = || {
        tiled(64, 32, 3, 8, |band, corner| match (corner, band) {
            ([32, 0], 1) | ([32, 32], _) => None,
            _ => Some(tile_of(band, corner, 32)),
        })
    };
    for (picture, missing) in [(picture(), 0), (with_no_data(picture(), "9"), 9)] {
        let orthophoto = opened(Arc::new(directories(&[picture])));
        assert_eq!(orthophoto.colours([50, 4], [1, 1], 0).unwrap(), [colour(0, 50, 4), missing, colour(2, 50, 4), 255]);
        assert_eq!(orthophoto.colours([50, 50], [1, 1], 0).unwrap()[3], 0);
        assert_eq!([[5.5, 50.5], [50.5, 5.5], [60.5, 60.5]].map(|at| orthophoto.shows(at)), [true, true, false]);
    }
}

#[test]
fn alpha_in_a_plane_of_its_own_says_what_is_shown() {
    let mut picture = tiled(64, 32, 4, 8, |band, corner| {
        Some(if band < 3 { tile_of(band, corner, 32) } else { vec![if corner[0] == 0 { 255 } else { 0 }; 32 * 32] })
    });
    picture.tags.push(Tag::Short(338, vec![2]));
    let orthophoto = opened(Arc::new(directories(&[picture])));
    assert_eq!([[5.5, 50.5], [60.5, 50.5]].map(|at| orthophoto.shows(at)), [true, false]);
}

fn height(x: usize, y: usize) -> f32 {
    100.0 + 0.25 * x as f32 + 0.5 * y as f32
}

fn heights_of([left, top]: [usize; 2], tile: usize) -> Vec<u8> {
    (0..tile * tile).flat_map(|k| height(left + k % tile, top + k / tile).to_le_bytes()).collect()
}

/// Of the middles of pixels.
fn at(model: &HeightModel, x: usize, y: usize) -> Option<f64> {
    model.at([x as f64 + 0.5, -(y as f64) - 0.5])
}

#[test]
fn a_height_model_of_more_than_100_million_values_is_read_where_it_is_needed() {
    let (side, tile) = (10_300, 512);
    let holds = |[left, top]: [usize; 2]| left < 2 * tile && top < 2 * tile || left == 20 * tile && top == left;
    let picture = || tiled(side, tile, 1, 32, |_, corner| holds(corner).then(|| heights_of(corner, tile)));
    let read = Arc::new(AtomicU64::new(0));
    let file = directories(&[with_no_data(picture(), "-9999")]);
    let length = file.len() as u64;
    let model = HeightModel::open(Arc::new(Counted(file, Arc::clone(&read))), Some(WORLD)).unwrap();
    let range = Heights::Model(model.clone()).range();
    assert_eq!(range, [height(0, 0), height(side - 1, side - 1)].map(f64::from));
    // It was looked through once.
    let once = read.swap(0, Ordering::Relaxed);
    assert!(once < length + MEGABYTE, "{once} of {length} bytes read");
    for (x, y) in [(3, 4), (100, 7), (510, 500)] {
        assert_eq!(at(&model, x, y), Some(f64::from(height(x, y))), "at {x}, {y}");
    }
    let one = read.load(Ordering::Relaxed);
    assert_eq!(one, (4 * tile * tile) as u64, "one tile");
    // Between four tiles, at the last pixel, and where the file has none.
    assert_eq!(model.at([512.0, -512.0]), Some(f64::from(height(511, 511)) + 0.375));
    assert_eq!(at(&model, side - 1, side - 1), Some(range[1]));
    assert_eq!([at(&model, 5_000, 300), at(&model, 1_024, 10)], [None; 2]);
    // Without a value for nothing those are 0.
    let model = HeightModel::read(&directories(&[picture()]), Some(WORLD)).unwrap();
    assert_eq!((at(&model, 5_000, 300), Heights::Model(model).range()[0]), (Some(0.0), 0.0));
}

#[test]
fn a_small_height_model_of_which_the_file_leaves_tiles_out_is_not_truncated() {
    let picture = || tiled(64, 32, 1, 32, |_, corner| (corner != [32, 32]).then(|| heights_of(corner, 32)));
    let file = directories(&[with_no_data(picture(), "-9999")]);
    let model = HeightModel::read(&file, Some(WORLD)).unwrap();
    assert_eq!([at(&model, 40, 20), at(&model, 40, 40)], [Some(f64::from(height(40, 20))), None]);
    assert_eq!(at(&HeightModel::read(&directories(&[picture()]), Some(WORLD)).unwrap(), 40, 40), Some(0.0));
    let cut = HeightModel::read(&file[..file.len() - 9], Some(WORLD)).unwrap_err();
    assert!(matches!(cut, Error::UnreadableImage { .. }), "{cut:?}");
}

#[test]
fn a_large_height_model_in_one_strip_is_refused_with_what_is_allowed() {
    let mut picture = tiled(10_300, 10_300, 1, 32, |_, _| None);
    picture.tags.retain(|tag| !matches!(tag, Tag::Short(322 | 323, _)));
    picture.tiled = false;
    let told = HeightModel::read(&directories(&[picture]), Some(WORLD)).unwrap_err().to_string();
    assert!(told.contains("10,300 x 10,300") || told.contains("10300 x 10300"), "{told}");
    assert!(told.contains("16 million"), "{told}");
}
