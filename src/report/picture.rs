//! An image of the report: its grey values as a PNG within the page, with points or vectors drawn over it.

use crate::{GreyView, reduce_to};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use maud::{Markup, PreEscaped, html};

/// Longest side of a picture in px: what a page shows and a file can hold.
const LONGEST_SIDE: usize = 1024;

/// A layer of marks over a picture, in px of the image.
pub struct Layer {
    pub class: &'static str,
    /// The commands of an SVG path.
    pub path: String,
}

/// What lies over the parts that are left out: red, green, blue, alpha.
const LEFT_OUT: [u8; 4] = [216, 40, 40, 153];

/// Where the grey values of a picture come from.
pub enum Ground<'a> {
    /// From here, with a mask of the same size, whose zeros are shown in colour; other pictures may refer to them by this name.
    Grey(&'a str, GreyView<'a>, Option<GreyView<'a>>),
    /// From the picture that gave them this name, of an image of so many columns and rows.
    As(&'a str, [usize; 2]),
}

/// The image with its layers; `words` is what a reader without sight gets.
pub fn picture(ground: &Ground<'_>, layers: &[Layer], words: &str) -> Markup {
    let [width, height] = match ground {
        Ground::Grey(_, grey, _) => [grey.width(), grey.height()],
        Ground::As(_, size) => *size,
    };
    html! {
        svg.picture viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(words) {
            @match ground {
                Ground::Grey(name, grey, mask) => {
                    (embedded(name, *grey))
                    @if let Some(mask) = mask { (left_out(*mask)) }
                },
                Ground::As(name, _) => use href=(format!("#{name}")) {},
            }
            @for layer in layers { path class=(layer.class) d=(PreEscaped(&layer.path)) {} }
        }
    }
}

fn embedded(name: &str, grey: GreyView<'_>) -> Markup {
    let reduced = reduce_to(grey, LONGEST_SIDE);
    let [columns, rows] = [reduced.image.width(), reduced.image.height()];
    let address = data_address(reduced.image.data(), [columns, rows], ExtendedColorType::L8);
    let [width, height] = [columns, rows].map(|side| side << reduced.halvings);
    html! { image id=(name) width=(width) height=(height) preserveAspectRatio="none" href=(address) {} }
}

/// The zeros of a mask in colour, the rest transparent.
fn left_out(mask: GreyView<'_>) -> Markup {
    let step = mask.width().max(mask.height()).div_ceil(LONGEST_SIDE);
    let [columns, rows] = [mask.width().div_ceil(step), mask.height().div_ceil(step)];
    let colour = |k: usize| if mask.at(k % columns * step, k / columns * step) == 0 { LEFT_OUT } else { [0; 4] };
    let pixels: Vec<u8> = (0..columns * rows).flat_map(colour).collect();
    let address = data_address(&pixels, [columns, rows], ExtendedColorType::Rgba8);
    html! { image.left-out width=(columns * step) height=(rows * step) preserveAspectRatio="none" href=(address) {} }
}

fn data_address(pixels: &[u8], [columns, rows]: [usize; 2], colour: ExtendedColorType) -> String {
    let mut bytes = Vec::new();
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
    encoder.write_image(pixels, columns as u32, rows as u32, colour).expect("an image of its own size is encoded into memory");
    format!("data:image/png;base64,{}", BASE64_STANDARD.encode(bytes))
}
