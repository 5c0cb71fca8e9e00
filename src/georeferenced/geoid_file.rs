//! Files of geoids: of one that covers a country or the earth the part about a block.

use super::geotiff::degrees_of;
use super::samples::Numbers;
use crate::crs::Geoid;
use crate::error::refuse;
use crate::math::turn;
use crate::{Error, Refusal};

/// An area on the earth, in degrees.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct Area {
    /// Longitude and latitude.
    pub middle: [f64; 2],
    /// How far it reaches from its middle, east and north.
    pub reach: [f64; 2],
}

/// Beside the places of a block others are asked for, as those of points that it was not given: some 2 km.
const MARGIN_DEG: f64 = 0.02;
const ROUNDING_DEG: f64 = 1e-9;
/// No geoid lies farther from the ellipsoid, in m.
const HIGHEST_M: f64 = 200.0;
/// No grid has smaller steps.
const LEAST_STEP_DEG: f64 = 1e-6;
/// Most heights about a block: no grid of a geoid is so fine that it has more.
const MOST_NODES: usize = 1_000_000;
/// Of a node for which GTX has no height.
const NO_HEIGHT: f32 = -88.8888;
/// The length of what stands before the heights of a GTX.
const GTX_HEAD: usize = 40;
/// Most bytes before the heights of a PGM.
const PGM_HEAD: usize = 4096;
const PGM_MOST: f64 = 65_535.0;

/// Reads the part of a geoid about an area, from a GeoTIFF of longitudes and latitudes, a GTX, or a PGM of GeographicLib. `name`: of the file.
///
/// # Errors
/// [`Error::InvalidInput`] for another kind of file, an area that it does not cover and heights that are none of a geoid; [`Error::UnreadableImage`] for a
/// damaged TIFF.
pub(crate) fn part_of_geoid(name: &str, file: &[u8], area: &Area) -> Result<Geoid, Error> {
    let nodes = if matches!(file, [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..]) {
        Some(Nodes::of_tiff(name, file)?)
    } else {
        Nodes::of_gtx(file).or_else(|| Nodes::of_pgm(file))
    };
    match nodes {
        Some(nodes) => nodes.about(name, area),
        None => refuse(Refusal::NoGeoid { name: name.into() }),
    }
}

/// The nodes of a file.
struct Nodes<'a> {
    /// Longitude and latitude of the first one.
    south_west: [f64; 2],
    step: [f64; 2],
    columns: usize,
    rows: usize,
    /// By column and row, from the west and the south; NaN where there is none.
    height: Box<dyn Fn(usize, usize) -> Result<f32, Error> + 'a>,
}

impl<'a> Nodes<'a> {
    fn of_tiff(name: &str, file: &'a [u8]) -> Result<Self, Error> {
        let Some(pixels) = degrees_of(file)? else { return refuse(Refusal::NoGeoid { name: name.into() }) };
        let [step, down] = [pixels.by_column[0], pixels.by_row[1]];
        if !(step >= LEAST_STEP_DEG && -down >= LEAST_STEP_DEG && pixels.by_column[1] == 0.0 && pixels.by_row[0] == 0.0) {
            return refuse(Refusal::NoGeoid { name: name.into() });
        }
        // Of a grid that covers the earth the tiles about the block are decoded.
        let numbers = Numbers::open(file)?;
        let [columns, rows] = numbers.size();
        let height = move |column: usize, row: usize| numbers.at(column, rows - 1 - row);
        Ok(Self { south_west: pixels.ground([0.5, rows as f64 - 0.5]), step: [step, -down], columns, rows, height: Box::new(height) })
    }

    /// # Source
    /// NOAA VDatum, GTX: latitude and longitude of the south-west node, steps of latitude and longitude, numbers of rows and columns, then
    /// heights row by row from the south; all big-endian.
    fn of_gtx(file: &'a [u8]) -> Option<Self> {
        let (head, heights) = file.split_at_checked(GTX_HEAD)?;
        let (degrees, counts) = head.split_at(32);
        let &[south, west, north_step, east_step] = degrees.as_chunks::<8>().0 else { return None };
        let [south, west, north_step, east_step] = [south, west, north_step, east_step].map(f64::from_be_bytes);
        let &[rows, columns] = counts.as_chunks::<4>().0 else { return None };
        let [rows, columns] = [rows, columns].map(|count| usize::try_from(i32::from_be_bytes(count)).ok());
        let (rows, columns) = (rows?, columns?);
        let is_on_earth = south.abs() <= 90.0
            && west.abs() <= 360.0
            && [north_step, east_step].iter().all(|step| *step >= LEAST_STEP_DEG && *step <= 10.0);
        let heights = heights.as_chunks::<4>().0;
        if !is_on_earth || rows.checked_mul(columns) != Some(heights.len()) || GTX_HEAD + 4 * heights.len() != file.len() {
            return None;
        }
        let height = move |column: usize, row: usize| {
            let value = f32::from_be_bytes(heights[row * columns + column]);
            Ok(if value == NO_HEIGHT { f32::NAN } else { value })
        };
        Some(Self { south_west: [west, south], step: [east_step, north_step], columns, rows, height: Box::new(height) })
    }

    /// # Source
    /// GeographicLib, "Geoid": a binary PGM of 16 bits whose comments state an offset and a scale; all around the earth from Greenwich to the east, and from
    /// pole to pole from the north.
    fn of_pgm(file: &'a [u8]) -> Option<Self> {
        let mut rest = file.strip_prefix(b"P5")?;
        let [mut offset, mut scale] = [None; 2];
        let mut numbers = Vec::new();
        while numbers.len() < 3 {
            let end = rest.iter().take(PGM_HEAD).position(|byte| *byte == b'\n')?;
            let line = std::str::from_utf8(&rest[..end]).ok()?;
            rest = &rest[end + 1..];
            match line.strip_prefix('#').map(|comment| comment.split_whitespace().collect::<Vec<_>>()) {
                Some(words) => match words[..] {
                    ["Offset", value] => offset = value.parse::<f64>().ok(),
                    ["Scale", value] => scale = value.parse::<f64>().ok(),
                    _ => {}
                },
                None => numbers.extend(line.split_whitespace().map_while(|word| word.parse::<usize>().ok())),
            }
        }
        let &[columns, rows, most] = &numbers[..] else { return None };
        let (offset, scale) = (offset?, scale?);
        let values = rest.as_chunks::<2>().0;
        if most as f64 != PGM_MOST
            || columns < 2
            || rows < 2
            || columns.checked_mul(rows) != Some(values.len())
            || 2 * values.len() != rest.len()
        {
            return None;
        }
        let height = move |column: usize, row: usize| {
            let value = u16::from_be_bytes(values[(rows - 1 - row) * columns + column]);
            Ok((offset + scale * f64::from(value)) as f32)
        };
        let step = [360.0 / columns as f64, 180.0 / (rows - 1) as f64];
        Some(Self { south_west: [0.0, -90.0], step, columns, rows, height: Box::new(height) })
    }

    /// How many columns it is around the earth, where it reaches around it; the last of some files is the first once more.
    fn around(&self) -> Option<usize> {
        let around = (360.0 / self.step[0]).round();
        let closes = (around * self.step[0] - 360.0).abs() < 1e-6 && around as usize <= self.columns;
        closes.then_some(around as usize)
    }

    fn about(&self, name: &str, area: &Area) -> Result<Geoid, Error> {
        let ends = [0, 1].map(|k| ([self.columns, self.rows][k].max(1) - 1) as f64 * self.step[k]);
        let [west, south] = self.south_west;
        // East of its first node, by less than once around; west of it where it would else lie beyond the last one.
        let around = self.around();
        let mut east = (area.middle[0] - west).rem_euclid(360.0);
        if around.is_none() && east - area.reach[0] > ends[0] {
            east -= 360.0;
        }
        let at = [east, area.middle[1] - south];
        let is_within = |k: usize| {
            (k == 0 && around.is_some()) || (at[k] - area.reach[k] >= -ROUNDING_DEG && at[k] + area.reach[k] <= ends[k] + ROUNDING_DEG)
        };
        if self.columns < 2 || self.rows < 2 || !is_within(0) || !is_within(1) {
            let ([longitude_deg, latitude_deg], [width, height]) = (area.middle, ends);
            let (east, north) = (turn_of_file(west + width), south + height);
            let [[block_west, block_east], [block_south, block_north]] =
                [0, 1].map(|k| [-1.0, 1.0].map(|sign| area.middle[k] + sign * area.reach[k]));
            return refuse(Refusal::GeoidElsewhere {
                name: name.into(),
                west: turn_of_file(west),
                south,
                east,
                north,
                longitude_deg,
                latitude_deg,
                block_west: turn(block_west),
                block_east: turn(block_east),
                block_south,
                block_north,
            });
        }
        // The margin only where it has heights there.
        let part = |margin: f64| self.part(name, at, area.reach.map(|reach| reach + margin), ends, around);
        part(MARGIN_DEG).or_else(|_| part(0.0))
    }

    /// The nodes around what lies this far from the first one and reaches so far.
    fn part(&self, name: &str, at: [f64; 2], reach: [f64; 2], ends: [f64; 2], around: Option<usize>) -> Result<Geoid, Error> {
        let range = |k: usize| {
            let is_round = k == 0 && around.is_some();
            let [mut low, mut high] = [at[k] - reach[k], at[k] + reach[k]];
            if !is_round {
                (low, high) = (low.max(0.0), high.min(ends[k]));
            }
            if is_round {
                let first = (low / self.step[k]).floor();
                return (first as i64, (high / self.step[k]).ceil().max(first + 1.0) as i64);
            }
            let last = (ends[k] / self.step[k]).round();
            let second = (high / self.step[k]).ceil().clamp(1.0, last);
            ((low / self.step[k]).floor().clamp(0.0, second - 1.0) as i64, second as i64)
        };
        let ((first_column, last_column), (first_row, last_row)) = (range(0), range(1));
        let [columns, rows] = [last_column - first_column + 1, last_row - first_row + 1].map(|count| count as usize);
        if columns.saturating_mul(rows) > MOST_NODES {
            return refuse(Refusal::GeoidNodes { name: name.into(), columns, rows, most: MOST_NODES });
        }
        let mut heights_m = Vec::with_capacity(columns * rows);
        for row in first_row..=last_row {
            for column in first_column..=last_column {
                let own = around.map_or(column, |around| column.rem_euclid(around as i64));
                let height = (self.height)(own as usize, row as usize)?;
                let [longitude_deg, latitude_deg] =
                    [self.south_west[0] + column as f64 * self.step[0], self.south_west[1] + row as f64 * self.step[1]];
                if !(f64::from(height).abs() <= HIGHEST_M) {
                    let height = Some(f64::from(height)).filter(|height| height.is_finite());
                    return refuse(Refusal::GeoidHeight { name: name.into(), longitude_deg: turn(longitude_deg), latitude_deg, height });
                }
                heights_m.push(height);
            }
        }
        let south_west_deg =
            [turn(self.south_west[0] + first_column as f64 * self.step[0]), self.south_west[1] + first_row as f64 * self.step[1]];
        Ok(Geoid { name: name.into(), south_west_deg, step_deg: self.step, columns, heights_m })
    }
}

/// A longitude as people write it.
fn turn_of_file(longitude: f64) -> f64 {
    if longitude > 180.0 { longitude - 360.0 } else { longitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plane over longitude and latitude: interpolation between its nodes is exact.
    fn height(longitude: f64, latitude: f64) -> f32 {
        (40.0 + 0.1 * longitude - 0.05 * latitude) as f32
    }

    fn gtx(south_west: [f64; 2], step: f64, [columns, rows]: [usize; 2], height: impl Fn(f64, f64) -> f32) -> Vec<u8> {
        let [west, south] = south_west;
        let mut file: Vec<u8> = [south, west, step, step].iter().flat_map(|v| v.to_be_bytes()).collect();
        file.extend([rows as i32, columns as i32].iter().flat_map(|v| v.to_be_bytes()));
        for row in 0..rows {
            for column in 0..columns {
                file.extend(height(west + step * column as f64, south + step * row as f64).to_be_bytes());
            }
        }
        file
    }

    fn area(middle: [f64; 2], reach: f64) -> Area {
        Area { middle, reach: [reach; 2] }
    }

    #[test]
    fn the_part_of_a_gtx_about_a_block_has_its_heights() {
        let file = gtx([5.0, 47.0], 0.25, [41, 33], height);
        let part = part_of_geoid("de.gtx", &file, &area([10.1, 50.3], 0.02)).unwrap();
        assert!(part.is_whole() && part.heights_m.len() == 4, "{part:?}");
        for place in [[10.1, 50.3], [10.08, 50.28], [10.13, 50.31]] {
            let known = f64::from(height(place[0], place[1]));
            assert!((part.above_m(place) - known).abs() < 1e-4, "{place:?}: {} for {known}", part.above_m(place));
        }
        // A single place on its edge: beside the first node, and beyond the last one.
        for place in [[10.1, 47.0], [5.0, 50.1], [15.0, 55.0]] {
            let edge = part_of_geoid("de.gtx", &file, &area(place, 0.0)).unwrap();
            assert!((edge.above_m(place) - f64::from(height(place[0], place[1]))).abs() < 1e-4, "{place:?}: {edge:?}");
        }
        // To its edge, where no margin is left.
        let corner = part_of_geoid("de.gtx", &file, &area([5.01, 47.01], 0.01)).unwrap();
        assert!((corner.above_m([5.0, 47.0]) - f64::from(height(5.0, 47.0))).abs() < 1e-4, "{corner:?}");
    }

    #[test]
    fn a_grid_around_the_earth_has_no_edge_in_its_longitudes() {
        let round = |longitude: f64, _: f64| turn(longitude).abs() as f32;
        for (west, columns) in [(-180.0, 720), (0.0, 720), (0.0, 721)] {
            let file = gtx([west, -90.0], 0.5, [columns, 361], round);
            for longitude in [179.9, -179.9, -0.1, 0.1, 33.3] {
                let part = part_of_geoid("earth.gtx", &file, &area([longitude, 10.2], 0.3)).unwrap();
                // Where it bends at the date line the grid has a node.
                assert!((part.above_m([longitude, 10.2]) - longitude.abs()).abs() < 1e-4, "{longitude} from {west}: {part:?}");
            }
        }
    }

    #[test]
    fn a_pgm_of_geographiclib_is_read() {
        let (columns, rows) = (72, 37);
        let value = |column: usize, row: usize| (10_000 + 100 * column + row) as u16;
        let head = format!("P5\n# Geoid file in PGM format\n# Offset -108\n# Scale 0.003\n# Origin 90N 0E\n{columns}  {rows}\n65535\n");
        let values = (0..rows).flat_map(|row| (0..columns).flat_map(move |column| value(column, row).to_be_bytes()));
        let file: Vec<u8> = head.bytes().chain(values).collect();
        // The node at 10° east and 80° north: the third of the third row.
        let part = part_of_geoid("egm.pgm", &file, &area([10.0, 80.0], 0.1)).unwrap();
        assert!((part.above_m([10.0, 80.0]) - (-108.0 + 0.003 * f64::from(value(2, 2)))).abs() < 1e-4, "{part:?}");
        assert!(part_of_geoid("egm.pgm", &file[..file.len() - 1], &area([10.0, 80.0], 0.1)).is_err());
    }

    #[test]
    fn what_is_no_geoid_there_is_refused_by_name() {
        let file =
            gtx([5.0, 47.0], 0.25, [41, 33], |longitude, latitude| if longitude > 14.0 { -88.8888 } else { height(longitude, latitude) });
        let refused = |file: &[u8], middle: [f64; 2]| part_of_geoid("a.gtx", file, &area(middle, 0.02)).unwrap_err().to_string();
        let elsewhere = refused(&file, [-3.0, 40.0]);
        assert!(
            ["a.gtx", "5.00 to 15.00", "47.00 to 55.00", "-3.0000", "40.0000", "-3.0200 to -2.9800", "39.9800 to 40.0200"]
                .iter()
                .all(|word| elsewhere.contains(word)),
            "{elsewhere}"
        );
        let hole = refused(&file, [14.5, 50.0]);
        assert!(hole.contains("no height") && hole.contains("14."), "{hole}");
        let ground = refused(&gtx([5.0, 47.0], 0.25, [41, 33], |_, _| 512.0), [10.0, 50.0]);
        assert!(ground.contains("512"), "{ground}");
        for wrong in [&b""[..], b"P5\n2 2\n255\nabcd", b"text", &file[..file.len() - 1], &file[..39]] {
            assert!(refused(wrong, [10.0, 50.0]).contains("GTX"), "{:?}", &wrong[..wrong.len().min(20)]);
        }
    }
}
