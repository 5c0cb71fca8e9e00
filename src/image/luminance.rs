//! Samples of a decoded file to grey values or colours 0..255.

/// How the samples of a pixel lie in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SampleLayout {
    /// Samples a pixel, with alpha and further bands.
    pub channels: usize,
    /// The first three samples are red, green and blue; otherwise the first is grey.
    pub colour: bool,
    /// Samples from one plane to the next, where the planes follow one another; absent where the samples of a pixel do.
    pub plane_stride: Option<usize>,
}

impl SampleLayout {
    /// Samples pixel by pixel: 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha.
    pub fn interleaved(channels: usize) -> Self {
        Self { channels, colour: channels >= 3, plane_stride: None }
    }

    /// Where a sample of a pixel is.
    pub fn place(&self, pixel: usize, channel: usize) -> usize {
        match self.plane_stride {
            None => pixel * self.channels + channel,
            Some(stride) => channel * stride + pixel,
        }
    }
}

/// What samples become.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Wanted {
    /// One band: grey, or the luma of colours.
    Grey,
    /// Three bands where there are colours.
    Colours,
}

/// A sample as a decoder gives it.
pub(super) trait Sample: Copy {
    fn value(self) -> u16;
}

impl Sample for u8 {
    fn value(self) -> u16 {
        self.into()
    }
}

impl Sample for u16 {
    fn value(self) -> u16 {
        self
    }
}

/// 16 bits in the machine's byte order.
impl Sample for [u8; 2] {
    fn value(self) -> u16 {
        u16::from_ne_bytes(self)
    }
}

/// Grey of 8-bit samples: the grey sample, or the luma of the colour; alpha and further bands are ignored.
pub(super) fn grey_of_u8(samples: Vec<u8>, pixels: usize, layout: SampleLayout) -> Vec<u8> {
    if layout.channels == 1 {
        return samples;
    }
    let mut grey = Vec::with_capacity(pixels);
    for_each_pixel(&samples, layout, |rgb| grey.push(luma(rgb) as u8));
    grey
}

/// Grey of 16-bit samples, of which `white` and all above become 255.
pub(super) fn grey_up_to<T: Sample>(white: u32, samples: &[T], pixels: usize, layout: SampleLayout) -> Vec<u8> {
    let table = up_to(white);
    let mut grey = Vec::with_capacity(pixels);
    for_each_pixel(samples, layout, |rgb| grey.push(table[luma(rgb).min(white) as usize]));
    grey
}

/// The value of each sample up to that which becomes white.
fn up_to(white: u32) -> Vec<u8> {
    (0..=white).map(|v| ((v * 255 + white / 2) / white) as u8).collect()
}

/// Which bits of 16 are in use.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Depth {
    used_bits: u16,
    unequal_bytes: u16,
}

impl Depth {
    pub fn see<T: Sample>(&mut self, samples: &[T], layout: SampleLayout) {
        for_each_pixel(samples, layout, |rgb| rgb.into_iter().for_each(|v| self.add(v)));
    }

    /// Leaves out pixels of nothing.
    pub fn see_but<T: Sample>(&mut self, samples: &[T], layout: SampleLayout, nothing: &[bool]) {
        let mut nothing = nothing.iter();
        for_each_pixel(samples, layout, |rgb| {
            if nothing.next() == Some(&false) {
                rgb.into_iter().for_each(|v| self.add(v));
            }
        });
    }

    fn add(&mut self, v: u16) {
        self.used_bits |= v;
        self.unequal_bytes |= (v >> 8) ^ (v & 0xff);
    }

    /// The sample value that becomes white; at least as large as every colour sample that was seen.
    pub fn white(self) -> u32 {
        if self.unequal_bytes == 0 {
            return 0xffff;
        }
        let depth = (u16::BITS - self.used_bits.leading_zeros()).max(8);
        (1 << depth) - 1
    }
}

/// The bands of 8-bit samples: grey as [`grey_of_u8`] gives it, or red, green and blue as they are.
pub(super) fn bands_of_u8(samples: Vec<u8>, pixels: usize, layout: SampleLayout, wanted: Wanted) -> Vec<Vec<u8>> {
    match wanted {
        Wanted::Colours if layout.colour => colours(&samples, pixels, layout, |value| value as u8),
        _ => vec![grey_of_u8(samples, pixels, layout)],
    }
}

/// The bands of 16-bit samples, all alike stretched from the bits in use to 0..255.
///
/// With `k` the smallest depth of 8 to 16 bits that holds all samples, values are `round(255 v / (2^k - 1))`, so that 10-, 12- and
/// 14-bit data in 16-bit files keep their contrast. Samples that are all multiples of 257 are 8-bit data widened to 16 bits:
/// they come out as they were, whatever their largest value.
pub(super) fn bands_of_u16<T: Sample>(samples: &[T], pixels: usize, layout: SampleLayout, wanted: Wanted) -> Vec<Vec<u8>> {
    let mut depth = Depth::default();
    depth.see(samples, layout);
    bands_up_to(depth.white(), samples, pixels, layout, wanted)
}

/// The same, of which `white` and all above become 255.
pub(super) fn bands_up_to<T: Sample>(white: u32, samples: &[T], pixels: usize, layout: SampleLayout, wanted: Wanted) -> Vec<Vec<u8>> {
    match wanted {
        Wanted::Colours if layout.colour => {
            let table = up_to(white);
            colours(samples, pixels, layout, |value| table[u32::from(value).min(white) as usize])
        }
        _ => vec![grey_up_to(white, samples, pixels, layout)],
    }
}

fn colours<T: Sample>(samples: &[T], pixels: usize, layout: SampleLayout, value: impl Fn(u16) -> u8) -> Vec<Vec<u8>> {
    let mut bands = [(); 3].map(|()| Vec::with_capacity(pixels));
    for_each_pixel(samples, layout, |rgb| bands.iter_mut().zip(rgb).for_each(|(band, sample)| band.push(value(sample))));
    bands.into()
}

/// Luma after Rec. 601 in 14-bit fixed point with OpenCV's weights; they add up to 1, so that a grey pixel keeps its value.
pub(super) fn luma(rgb: [u16; 3]) -> u32 {
    let [r, g, b] = rgb.map(u32::from);
    (r * 4899 + g * 9617 + b * 1868 + (1 << 13)) >> 14
}

/// Visits the colour of each pixel; a grey pixel has three equal values.
fn for_each_pixel<T: Sample>(samples: &[T], layout: SampleLayout, mut visit: impl FnMut([u16; 3])) {
    let pixels = || samples.chunks_exact(layout.channels);
    match layout.plane_stride {
        None if layout.colour => pixels().for_each(|s| visit([s[0], s[1], s[2]].map(T::value))),
        None => pixels().for_each(|s| visit([s[0].value(); 3])),
        Some(stride) if layout.colour => {
            let (red, rest) = samples.split_at(stride);
            let (green, blue) = rest.split_at(stride);
            let colours = red.iter().zip(green).zip(blue);
            colours.for_each(|((&r, &g), &b)| visit([r, g, b].map(T::value)));
        }
        Some(stride) => samples[..stride].iter().for_each(|v| visit([v.value(); 3])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey_of_u16<T: Sample>(samples: &[T], pixels: usize, layout: SampleLayout) -> Vec<u8> {
        bands_of_u16(samples, pixels, layout, Wanted::Grey).remove(0)
    }

    const GREY: SampleLayout = SampleLayout { channels: 1, colour: false, plane_stride: None };

    #[test]
    fn luma_has_opencv_values() {
        // cv2.cvtColor of these colours with COLOR_RGB2GRAY.
        let rgb = vec![255, 0, 0, 0, 255, 0, 0, 0, 255, 12, 200, 99, 255, 255, 255, 1, 2, 3];
        assert_eq!(grey_of_u8(rgb, 6, SampleLayout::interleaved(3)), [76, 150, 29, 132, 255, 2]);
    }

    #[test]
    fn alpha_and_further_bands_are_ignored() {
        assert_eq!(grey_of_u8(vec![7, 0, 9, 255], 2, SampleLayout::interleaved(2)), [7, 9]);
        assert_eq!(grey_of_u8(vec![7, 7, 7, 0, 9, 9, 9, 255], 2, SampleLayout::interleaved(4)), [7, 9]);
        // Alpha at full scale does not widen the range of 10-bit colour.
        let rgba = [1023u16, 1023, 1023, 65535, 0, 0, 0, 65535];
        assert_eq!(grey_of_u16(&rgba, 2, SampleLayout::interleaved(4)), [255, 0]);
    }

    #[test]
    fn planes_give_what_interleaved_samples_give() {
        let interleaved = [10u16, 2000, 300, 4095, 5, 77];
        let planes = [10u16, 4095, 2000, 5, 300, 77];
        let planar = SampleLayout { channels: 3, colour: true, plane_stride: Some(2) };
        assert_eq!(grey_of_u16(&planes, 2, planar), grey_of_u16(&interleaved, 2, SampleLayout::interleaved(3)));
        let first = SampleLayout { channels: 3, colour: false, plane_stride: Some(2) };
        assert_eq!(grey_of_u8(vec![1, 2, 3, 4, 5, 6], 2, first), [1, 2]);
    }

    #[test]
    fn colours_are_kept_where_they_are_wanted() {
        let rgba = vec![1u8, 2, 3, 255, 40, 50, 60, 0];
        let colours = [vec![1u8, 40], vec![2, 50], vec![3, 60]];
        assert_eq!(bands_of_u8(rgba.clone(), 2, SampleLayout::interleaved(4), Wanted::Colours), colours);
        assert_eq!(bands_of_u8(rgba, 2, SampleLayout::interleaved(4), Wanted::Grey), [[2, 48]]);
        assert_eq!(bands_of_u8(vec![7, 0, 9, 255], 2, SampleLayout::interleaved(2), Wanted::Colours), [[7, 9]]);
        // All colours by the depth of the widest.
        let planes = [1023u16, 0, 512, 512, 0, 1];
        let planar = SampleLayout { channels: 3, colour: true, plane_stride: Some(2) };
        assert_eq!(bands_of_u16(&planes, 2, planar, Wanted::Colours), [[255, 0], [128, 128], [0, 0]]);
        assert_eq!(bands_of_u16(&planes, 2, planar, Wanted::Grey), [grey_of_u16(&planes, 2, planar)]);
    }

    #[test]
    fn samples_in_bytes_are_in_the_machines_order() {
        let bytes = [4095u16, 0, 2048].map(u16::to_ne_bytes);
        assert_eq!(grey_of_u16(&bytes, 3, GREY), [255, 0, 128]);
    }

    #[test]
    fn depth_is_the_smallest_that_holds_all_samples() {
        for depth in 8..=16u32 {
            let white = ((1u32 << depth) - 1) as u16;
            // A sample that just needs this depth, and is no multiple of 257.
            let data = [0, 1, 1 << (depth - 1), white];
            let grey = grey_of_u16(&data, 4, GREY);
            assert_eq!((grey[0], grey[3]), (0, 255), "{depth} bits");
            let middle = (f64::from(data[2]) * 255.0 / f64::from(white)).round();
            assert_eq!(f64::from(grey[2]), middle, "{depth} bits");
        }
    }

    #[test]
    fn widened_8_bit_images_come_back() {
        let all: Vec<u8> = (0..=255).collect();
        for top in [1usize, 3, 100, 127, 128, 255] {
            let wide: Vec<u16> = all[..=top].iter().map(|&v| u16::from(v) * 257).collect();
            assert_eq!(grey_of_u16(&wide, wide.len(), GREY), all[..=top]);
        }
        // Colour: luma of the widened colours rounds to the luma of the colours.
        let rgb: Vec<u8> = (0..30_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        let wide: Vec<u16> = rgb.iter().map(|&v| u16::from(v) * 257).collect();
        let layout = SampleLayout::interleaved(3);
        assert_eq!(grey_of_u16(&wide, 10_000, layout), grey_of_u8(rgb, 10_000, layout));
    }
}
