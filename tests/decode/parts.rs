//! Orthophotos that are read in parts: what they show is what a small one shows of the same pixels, whatever the file holds them in.

use super::counted::Counted;
use super::tiff_pictures::{Picture, directories};
use super::tiff_writer::Tag;
use std::fs::File;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tiepoint::{
    DecodeLimits, DiskFile, Error, FileSource, Georeference, GreyImage, Heights, Orthophoto, PlacingOptions, SearchArea, decode_bands,
};

const SIDE: usize = 6_400;
const TILE: usize = 512;

/// Grey of the made ground: smooth fields with edges, 0 beyond a slanted border.
fn ground(x: usize, y: usize) -> u8 {
    if x + 3 * y < 2_000 {
        return 0;
    }
    let field = ((x / 190) * 31 + (y / 230) * 17) % 160;
    (40 + field + (x / 8 + y / 16) % 40) as u8
}

/// Mean of the square of the ground that a pixel halved so many times shows.
fn mean(x: usize, y: usize, halvings: u32) -> u8 {
    let side = 1_usize << halvings;
    let sum: usize = (0..side * side).map(|k| usize::from(ground(x * side + k % side, y * side + k / side))).sum();
    ((sum + side * side / 2) / (side * side)) as u8
}

/// A tiled picture of the ground in red, green and blue, halved so many times.
fn tiled(halvings: u32) -> Picture {
    let side = SIDE >> halvings;
    let across = side.div_ceil(TILE);
    let value = |x: usize, y: usize| if x < side && y < side { mean(x, y, halvings) } else { 0 };
    let tile = |index: usize| -> Vec<u8> {
        let corner = [index % across * TILE, index / across * TILE];
        (0..TILE * TILE).flat_map(|k| [value(corner[0] + k % TILE, corner[1] + k / TILE); 3]).collect()
    };
    let tags = vec![
        Tag::Long(254, vec![u32::from(halvings > 0)]),
        Tag::Long(256, vec![side as u32]),
        Tag::Long(257, vec![side as u32]),
        Tag::Short(258, vec![8; 3]),
        Tag::Short(259, vec![1]),
        Tag::Short(262, vec![2]),
        Tag::Short(277, vec![3]),
        Tag::Short(322, vec![TILE as u16]),
        Tag::Short(323, vec![TILE as u16]),
    ];
    Picture { tags, chunks: (0..across * across).map(tile).collect(), tiled: true, more: Vec::new() }
}

const WORLD: &str = "0.5\n0\n0\n-0.5\n600000.25\n5200000\n";

fn opened(file: Arc<dyn FileSource>) -> Orthophoto {
    Orthophoto::open(file, Some(WORLD), Heights::Level(0.0), &DecodeLimits::default()).unwrap()
}

/// The same ground in memory.
fn whole() -> Orthophoto {
    let grey = GreyImage::from_fn(SIDE, SIDE, ground).unwrap();
    Orthophoto::new(grey, Georeference::read_world_file(WORLD).unwrap(), Heights::Level(0.0)).unwrap()
}

#[test]
fn a_large_orthophoto_shows_what_a_small_one_does_and_reads_little() {
    let file = directories(&[tiled(0), tiled(2), tiled(4)]);
    let read = Arc::new(AtomicU64::new(0));
    let large = opened(Arc::new(Counted(file.clone(), Arc::clone(&read))));
    let whole = whole();
    assert_eq!((large.size(), large.georeference), (whole.size(), whole.georeference));
    // Opened, and looked at as a whole: from the overview of a sixteenth.
    let [small, same] = [&large, &whole].map(|of| of.shown([0, 0], [400, 400], 4).unwrap());
    let differing = small.iter().zip(&same).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    // Means of means are rounded again, and the border of what is shown is found in the pixels that are read.
    assert!(differing < 400, "{differing} of 160000 px");
    let bytes = read.load(Ordering::Relaxed);
    assert!(bytes < file.len() as u64 / 50, "{bytes} of {} bytes read for the whole picture", file.len());
    // In full size it is the same, at the picture's edges and across the border too.
    for first in [[0, 0], [300, 400], [1_000, 250], [SIDE - 200, SIDE - 150], [3_000, 3_100]] {
        assert_eq!(large.shown(first, [260, 240], 0).unwrap(), whole.shown(first, [260, 240], 0).unwrap(), "from {first:?} on");
    }
    for at in [[5.0, 5.0], [1_999.5, 30.5], [2_030.5, 8.5], [700.5, 440.5], [700.5, 433.5], [-1.0, 5.0], [6_399.5, 6_399.5], [6_400.0, 1.0]]
    {
        assert_eq!(large.shows(at), whole.shows(at), "at {at:?}");
    }
    assert!(large.grey().unwrap() == whole.grey().unwrap());
}

#[test]
fn places_are_sought_in_overviews_where_the_file_has_them_and_in_made_ones_elsewhere() {
    let options = PlacingOptions { points: 1_500, ..PlacingOptions::default() };
    let points = |orthophoto: &Orthophoto| SearchArea::new(orthophoto, &options).unwrap().points();
    let found = points(&whole());
    for pictures in [vec![tiled(0), tiled(1)], vec![tiled(0)]] {
        let own = points(&opened(Arc::new(directories(&pictures))));
        assert!(own.abs_diff(found) <= found / 50, "{own} for {found} with {} pictures", pictures.len());
    }
    // An overview that is none is not believed: another size, or not said to be one.
    let mut other = tiled(2);
    other.tags[0] = Tag::Long(254, vec![0]);
    let large = opened(Arc::new(directories(&[tiled(0), other])));
    assert_eq!(large.shown([700, 700], [50, 50], 2).unwrap(), whole().shown([700, 700], [50, 50], 2).unwrap());
}

#[test]
fn a_file_of_a_disk_is_read_in_parts_and_a_cut_one_is_refused() {
    let file = directories(&[tiled(0)]);
    let path = std::env::temp_dir().join(format!("tiepoint-large-{}.tif", std::process::id()));
    std::fs::write(&path, &file).unwrap();
    let large = opened(Arc::new(DiskFile::new(File::open(&path).unwrap()).unwrap()));
    assert_eq!(large.shown([2_000, 2_000], [64, 64], 0).unwrap(), whole().shown([2_000, 2_000], [64, 64], 0).unwrap());
    std::fs::remove_file(&path).unwrap();
    // The directory stands in front of the tiles: the end is missed at once.
    let cut = Arc::new(file[..file.len() - 100].to_vec());
    let refused = Orthophoto::open(cut, Some(WORLD), Heights::Level(0.0), &DecodeLimits::default()).unwrap_err();
    assert!(matches!(refused, Error::UnreadableImage { .. }), "{refused:?}");
    assert!(refused.to_string().contains("ends"), "{refused}");
}

/// A tiled picture whose red, green and blue run along columns, rows and both.
fn tiled_colours(side: usize) -> Picture {
    let across = side.div_ceil(TILE);
    let tile = |index: usize| -> Vec<u8> {
        let corner = [index % across * TILE, index / across * TILE];
        (0..TILE * TILE).flat_map(|k| colour(corner[0] + k % TILE, corner[1] + k / TILE)).collect()
    };
    let mut picture = tiled(4);
    for (tag, value) in picture.tags.iter_mut().zip([0, side, side]) {
        let Tag::Long(_, values) = tag else { panic!("a short tag") };
        *values = vec![value as u32];
    }
    Picture { chunks: (0..across * across).map(tile).collect(), ..picture }
}

fn colour(x: usize, y: usize) -> [u8; 3] {
    [1 + (x / 32 % 200) as u8, 1 + (y / 32 % 200) as u8, 1 + ((x + y) / 64 % 200) as u8]
}

#[test]
fn colours_are_shown_whether_a_picture_is_read_in_parts_or_whole() {
    for side in [SIDE, 2_000] {
        let orthophoto = opened(Arc::new(directories(&[tiled_colours(side)])));
        assert_eq!(orthophoto.is_in_parts(), side == SIDE);
        for (halvings, first) in [(0, [1_000, 700]), (2, [300, 200]), (4, [60, 40])] {
            let shown = orthophoto.colours(first, [70, 50], halvings).unwrap();
            for (k, rgba) in shown.as_chunks::<4>().0.iter().enumerate() {
                let at = [first[0] + k % 70, first[1] + k / 70].map(|px| (px << halvings) + (1 << halvings) / 2);
                let expected = if at[0].max(at[1]) < side { [&colour(at[0], at[1])[..], &[255]].concat() } else { vec![0; 4] };
                let off = rgba.iter().zip(&expected).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(off <= Some(1), "{rgba:?} for {expected:?} at {at:?}, halved {halvings} times");
            }
        }
        // Beyond it nothing is shown.
        assert!(orthophoto.colours([side, 0], [4, 4], 0).unwrap().iter().all(|value| *value == 0));
        assert!(orthophoto.colours([0, usize::MAX - 3], [2, 2], 3).unwrap().iter().all(|value| *value == 0));
    }
    // Of a picture without colours all three are equal.
    let grey = opened(Arc::new(small()));
    let [shown, colours] = [grey.shown([26, 20], [1, 1], 0).unwrap(), grey.colours([26, 20], [1, 1], 0).unwrap()];
    assert_eq!(colours, [shown[0], shown[0], shown[0], 255]);
}

#[test]
fn alpha_says_what_is_shown_and_16_bits_are_stretched_by_what_is_in_use() {
    let [width, height] = [9_000_u32, 5_000_u32];
    // 12 bits in use; alpha is 0 in the left third, whatever the colour there.
    let strip = |top: u32| -> Vec<u8> {
        let pixel = |k: u32| {
            let (x, y) = (k % width, top + k / width);
            [((x + y) % 4096) as u16, if x < width / 3 { 0 } else { 0xffff }]
        };
        (0..width * 10).flat_map(pixel).flat_map(u16::to_le_bytes).collect()
    };
    let tags = vec![
        Tag::Long(256, vec![width]),
        Tag::Long(257, vec![height]),
        Tag::Short(258, vec![16; 2]),
        Tag::Short(259, vec![1]),
        Tag::Short(262, vec![1]),
        Tag::Short(277, vec![2]),
        Tag::Long(278, vec![10]),
        Tag::Short(338, vec![2]),
    ];
    let picture = Picture { tags, chunks: (0..height / 10).map(|k| strip(10 * k)).collect(), tiled: false, more: Vec::new() };
    let large = opened(Arc::new(directories(&[picture])));
    let shown = large.shown([3_100, 2_000], [300, 20], 0).unwrap();
    let expected = |x: usize, y: usize| (((3_100 + x + 2_000 + y) % 4096 * 255 + 2_047) / 4_095).max(1) as u8;
    assert!((0..6_000).all(|k| shown[k] == expected(k % 300, k / 300)));
    assert!(large.shown([2_500, 2_000], [300, 20], 0).unwrap().iter().all(|value| *value == 0));
    assert!(!large.shows([2_900.0, 40.0]) && large.shows([3_050.0, 40.0]));
}

/// A JPEG file without its tables, and these.
fn without_tables(file: &[u8]) -> (Vec<u8>, Vec<u8>) {
    let (mut own, mut tables) = (file[..2].to_vec(), file[..2].to_vec());
    let mut at = 2;
    while file[at + 1] != 0xda {
        let end = at + 2 + usize::from(u16::from_be_bytes([file[at + 2], file[at + 3]]));
        let to = if matches!(file[at + 1], 0xdb | 0xc4) { &mut tables } else { &mut own };
        to.extend(&file[at..end]);
        at = end;
    }
    own.extend(&file[at..]);
    tables.extend([0xff, 0xd9]);
    (own, tables)
}

#[test]
fn jpeg_tiles_are_those_files_whether_their_tables_stand_in_them_or_once_for_all() {
    let (width, height, tile) = (300, 200, 128);
    let jpeg = |left: usize, top: usize| {
        let colour = |k: usize| {
            let (x, y) = (left + k % tile, top + k / tile);
            [ground(3 * x, 500 + 2 * y), (x % 256) as u8, (y % 256) as u8]
        };
        let colours: Vec<u8> = (0..tile * tile).flat_map(colour).collect();
        let mut file = Vec::new();
        let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, 90);
        image::ImageEncoder::write_image(encoder, &colours, tile as u32, tile as u32, image::ExtendedColorType::Rgb8).unwrap();
        file
    };
    let files: Vec<Vec<u8>> = (0..6).map(|k| jpeg(k % 3 * tile, k / 3 * tile)).collect();
    let grey: Vec<GreyImage> = files.iter().map(|file| super::decode(file).unwrap().grey).collect();
    let expected = |x: usize, y: usize| grey[y / tile * 3 + x / tile].view().at(x % tile, y % tile);
    let expected: Vec<u8> = (0..width * height).map(|k| expected(k % width, k / width)).collect();
    let tags = || {
        vec![
            Tag::Long(256, vec![width as u32]),
            Tag::Long(257, vec![height as u32]),
            Tag::Short(258, vec![8; 3]),
            Tag::Short(259, vec![7]),
            Tag::Short(262, vec![6]),
            Tag::Short(277, vec![3]),
            Tag::Short(322, vec![tile as u16]),
            Tag::Short(323, vec![tile as u16]),
        ]
    };
    let complete = directories(&[Picture { tags: tags(), chunks: files.clone(), tiled: true, more: Vec::new() }]);
    let (_, tables) = without_tables(&files[0]);
    let chunks: Vec<Vec<u8>> = files.iter().map(|file| without_tables(file).0).collect();
    let apart =
        directories(&[Picture { tags: tags(), chunks: chunks.clone(), tiled: true, more: vec![(347, 7, tables.len() as u32, tables)] }]);
    for file in [complete, apart.clone()] {
        assert_eq!(super::decode(&file).unwrap().grey.data(), expected);
        // Their colours are those that were written, but for what JPEG loses.
        let colours = decode_bands(&file, &DecodeLimits::default()).unwrap();
        let shown = Orthophoto::open(Arc::new(file), Some(WORLD), Heights::Level(0.0), &DecodeLimits::default()).unwrap();
        for (x, y) in [(20, 30), (90, 100), (140, 150), (250, 60)] {
            let expected = [ground(3 * x, 500 + 2 * y), x as u8, y as u8];
            let own: Vec<u8> = colours.images().iter().map(|band| band.view().at(x, y)).collect();
            assert!(own.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 25), "{own:?} for {expected:?}");
            assert_eq!(shown.colours([x, y], [1, 1], 0).unwrap(), [own.as_slice(), &[255]].concat());
        }
    }
    // Without their tables, cut, or of another size than the directory says they are refused.
    let mut larger = tags();
    larger[1] = Tag::Long(257, vec![400]);
    for wrong in [
        directories(&[Picture { tags: tags(), chunks, tiled: true, more: Vec::new() }]),
        apart[..apart.len() - 40].to_vec(),
        directories(&[Picture { tags: larger, chunks: files, tiled: true, more: Vec::new() }]),
    ] {
        assert_eq!(super::decode(&wrong).unwrap_err().code(), "unreadable-image");
    }
}

/// A small orthophoto in tiles, with an overview and a mask.
fn small() -> Vec<u8> {
    let tile = |seed: usize| (0..32 * 32).map(|k| (k * 7 + seed * 31) as u8).collect::<Vec<u8>>();
    let tags = |side: u32, kind: u32, bits: u16, photometric: u16| {
        vec![
            Tag::Long(254, vec![kind]),
            Tag::Long(256, vec![side]),
            Tag::Long(257, vec![side]),
            Tag::Short(258, vec![bits]),
            Tag::Short(259, vec![1]),
            Tag::Short(262, vec![photometric]),
            Tag::Short(277, vec![1]),
            Tag::Short(322, vec![32]),
            Tag::Short(323, vec![32]),
        ]
    };
    let whole = Picture { tags: tags(64, 0, 8, 1), chunks: (0..4).map(tile).collect(), tiled: true, more: Vec::new() };
    let half = Picture { tags: tags(32, 1, 8, 1), chunks: vec![tile(9)], tiled: true, more: Vec::new() };
    // Of each row the first byte is not shown, the second is.
    let bits = |k: usize| (0..32).flat_map(|_| if k.is_multiple_of(2) { [0, 0, 0xff, 0xff] } else { [0xff; 4] }).collect::<Vec<u8>>();
    let mask = Picture { tags: tags(64, 4, 1, 4), chunks: (0..4).map(bits).collect(), tiled: true, more: Vec::new() };
    directories(&[whole, half, mask])
}

#[test]
fn a_mask_of_the_file_says_what_is_shown() {
    let orthophoto = opened(Arc::new(small()));
    assert_eq!(orthophoto.size(), [64, 64]);
    // With the edge of 8 px.
    let shows = [[3.5, 20.5], [15.5, 20.5], [23.5, 20.5], [24.5, 20.5], [60.5, 60.5]].map(|at| orthophoto.shows(at));
    assert_eq!(shows, [false, false, false, true, true]);
}

#[test]
fn the_value_for_no_data_counts_where_a_sample_can_have_it() {
    // The left half is black, the right one white.
    let value = |k: usize| if k % 32 < 16 { 0 } else { 255 };
    for (text, shows) in
        [("255", [true, false]), ("0", [false, true]), ("-9999", [false, true]), ("nan", [false, true]), ("256", [false, true])]
    {
        let mut picture = tiled_grey(&(0..32 * 32).map(value).collect::<Vec<u8>>());
        picture.more = vec![(42_113, 2, text.len() as u32 + 1, [text.as_bytes(), b"\0"].concat())];
        let orthophoto = opened(Arc::new(directories(&[picture])));
        assert_eq!([[2.5, 20.5], [29.5, 20.5]].map(|at| orthophoto.shows(at)), shows, "no data: {text}");
    }
}

/// One tile of 32 x 32 px.
fn tiled_grey(values: &[u8]) -> Picture {
    let tags = vec![
        Tag::Long(256, vec![32]),
        Tag::Long(257, vec![32]),
        Tag::Short(258, vec![8]),
        Tag::Short(259, vec![1]),
        Tag::Short(262, vec![1]),
        Tag::Short(277, vec![1]),
        Tag::Short(322, vec![32]),
        Tag::Short(323, vec![32]),
    ];
    Picture { tags, chunks: vec![values.to_vec()], tiled: true, more: Vec::new() }
}

#[test]
fn damaged_tiles_and_directories_give_a_picture_or_a_typed_error() {
    let file = small();
    let (mut refused, mut read) = (0, 0);
    for at in 0..file.len().min(900) {
        for bit in [0, 3, 7] {
            let mut damaged = file.clone();
            damaged[at] ^= 1 << bit;
            match Orthophoto::open(Arc::new(damaged), Some(WORLD), Heights::Level(0.0), &DecodeLimits::default()) {
                Ok(orthophoto) => {
                    read += 1;
                    let _ = orthophoto.shown([0, 0], [8, 8], 2);
                    let _ = orthophoto.colours([0, 0], [8, 8], 1);
                }
                Err(error) => {
                    refused += 1;
                    assert!(!error.to_string().is_empty());
                }
            }
        }
    }
    assert!(refused > 100 && read > 100, "{refused} refused, {read} read");
}
