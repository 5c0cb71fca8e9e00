//! Colours of a sequential file with one scan for each component.
//!
//! The decoder takes one scan of a sequential file. Each component is decoded as a grey image of its own, enlarged to the picture, and they are put
//! together as JFIF does.

use super::decoder::decoded;
use super::frame::Frame;
use super::scan::Scan;
use super::segments::{Segments, marker, write_segment};
use crate::Error;
use zune_jpeg::zune_core::colorspace::ColorSpace;

/// Chroma without colour.
const NEUTRAL: f64 = 128.0;

/// The stream of one component, the size of its image, and how many pixels of the picture a sample of it is wide and high.
struct Plane {
    stream: Vec<u8>,
    size: [usize; 2],
    pixels: [usize; 2],
}

/// The components of a picture in their order.
struct Planes {
    /// Width and height of the picture.
    size: [usize; 2],
    planes: Vec<Plane>,
}

/// Red, green and blue of a file of luma and chroma that was checked; absent where it has other scans, or no three components.
///
/// # Errors
/// [`Error::UnreadableImage`] for a damaged scan.
pub(super) fn colours(bytes: &[u8]) -> Result<Option<Vec<Vec<u8>>>, Error> {
    bands(bytes, |[luma, blue, red]| {
        let (blue, red) = (blue - NEUTRAL, red - NEUTRAL);
        [luma + 1.402 * red, luma - 0.344_136 * blue - 0.714_136 * red, luma + 1.772 * blue]
    })
}

/// The three components as they are stored.
///
/// # Errors
/// As [`colours`].
pub(super) fn stored(bytes: &[u8]) -> Result<Option<Vec<Vec<u8>>>, Error> {
    bands(bytes, |components| components)
}

/// Three bands, of what the components have at each pixel.
fn bands(bytes: &[u8], of: impl Fn([f64; 3]) -> [f64; 3]) -> Result<Option<Vec<Vec<u8>>>, Error> {
    let Some(Planes { size, planes }) = Planes::read(bytes)? else { return Ok(None) };
    let components: Vec<Component> = planes.into_iter().map(|plane| Component::decoded(plane, size)).collect::<Result<_, _>>()?;
    let [first, second, third] = components.as_slice() else { return Ok(None) };
    let [width, height] = size;
    let mut bands: Vec<Vec<u8>> = (0..3).map(|_| Vec::with_capacity(width * height)).collect();
    for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
        let values = of([first, second, third].map(|component| component.at(column, row)));
        bands.iter_mut().zip(values).for_each(|(band, value)| band.push((value + 0.5).clamp(0.0, 255.0) as u8));
    }
    Ok(Some(bands))
}

/// The samples of a component, which are enlarged as they are asked for: at the size of the picture they would take several times the memory of its bands.
struct Component {
    samples: Vec<u8>,
    columns: usize,
    /// Of the columns and of the rows of the picture.
    between: [Vec<Between>; 2],
}

/// Two neighbouring samples, and how far from the first to the second.
#[derive(Clone, Copy)]
struct Between {
    first: usize,
    second: usize,
    share: f64,
}

impl Component {
    fn decoded(Plane { stream, size: own, pixels }: Plane, size: [usize; 2]) -> Result<Self, Error> {
        let samples = decoded(stream, ColorSpace::Luma, own[0] * own[1])?;
        let between = [0, 1].map(|axis| {
            let place = |k: usize| {
                let at = ((k as f64 + 0.5) / pixels[axis] as f64 - 0.5).clamp(0.0, own[axis] as f64 - 1.0);
                let first = at as usize;
                Between { first, second: (first + 1).min(own[axis] - 1), share: at - first as f64 }
            };
            (0..size[axis]).map(place).collect()
        });
        Ok(Self { samples, columns: own[0], between })
    }

    /// At a pixel of the picture, between the middles of its samples in both directions.
    fn at(&self, column: usize, row: usize) -> f64 {
        let [across, down] = [self.between[0][column], self.between[1][row]];
        let of_row = |row: usize| {
            let [first, second] = [across.first, across.second].map(|column| f64::from(self.samples[row * self.columns + column]));
            first + across.share * (second - first)
        };
        let (above, below) = (of_row(down.first), of_row(down.second));
        above + down.share * (below - above)
    }
}

impl Planes {
    /// Absent where the file has other scans, or no three components.
    fn read(bytes: &[u8]) -> Result<Option<Self>, Error> {
        let mut segments = Segments::of(bytes);
        let (mut tables, mut restart_interval) = (Vec::new(), 0);
        let mut frame: Option<Frame> = None;
        let mut planes: Vec<Option<Plane>> = (0..3).map(|_| None).collect();
        loop {
            let segment = segments.next()?;
            match segment.marker {
                _ if segment.is_frame() => {
                    let own = Frame::read(&segment)?;
                    if own.progressive || own.components.len() != planes.len() {
                        return Ok(None);
                    }
                    frame = Some(own);
                }
                marker::SOS => {
                    let (data, restarts) = segments.entropy_coded()?;
                    let (Some(frame), [1, id, ..]) = (&frame, segment.body) else { return Ok(None) };
                    let Some(k) = frame.components.iter().position(|component| component.id == *id) else { return Ok(None) };
                    if planes[k].is_some() {
                        continue;
                    }
                    let scan = Scan::new(segment.body, frame, &[*id], restart_interval);
                    scan.check_restarts(&restarts)?;
                    let own = frame.only(k);
                    let mut stream = vec![0xff, marker::SOI];
                    stream.extend(&tables);
                    own.write(&mut stream);
                    write_segment(marker::SOS, segment.body, &mut stream);
                    scan.write(data, &mut stream)?;
                    stream.extend([0xff, marker::EOI]);
                    planes[k] = Some(Plane { stream, size: [own.width, own.height].map(usize::from), pixels: frame.pixels_of(k) });
                }
                marker::EOI => break,
                marker::DRI => {
                    let interval = segment.body.first_chunk().map_or(0, |interval| u16::from_be_bytes(*interval));
                    restart_interval = usize::from(interval);
                    write_segment(marker::DRI, segment.body, &mut tables);
                }
                marker::DQT | marker::DHT => write_segment(segment.marker, segment.body, &mut tables),
                _ => {}
            }
        }
        let size = frame.map(|frame| [frame.width, frame.height].map(usize::from));
        let planes: Option<Vec<Plane>> = planes.into_iter().collect();
        Ok(size.zip(planes).map(|(size, planes)| Self { size, planes }))
    }
}
