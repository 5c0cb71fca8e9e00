//! An image of the report: its grey values as a PNG within the page, with points or vectors drawn over it.

use crate::{GreyView, Reduced, reduce_to};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use image::ImageEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use maud::{Markup, PreEscaped, html};

/// Longest side of a picture in px: what a page shows and a file can hold.
const LONGEST_SIDE: usize = 1024;

/// A layer of marks over a picture, in px of the image.
pub struct Layer {
    pub class: &'static str,
    /// The commands of an SVG path.
    pub path: String,
}

/// Where the grey values of a picture come from.
pub enum Ground<'a> {
    /// From here; other pictures may refer to them by this name.
    Grey(&'a str, GreyView<'a>),
    /// From the picture that gave them this name, of an image of so many columns and rows.
    As(&'a str, [usize; 2]),
}

/// The image with its layers; `words` is what a reader without sight gets.
pub fn picture(ground: &Ground<'_>, layers: &[Layer], words: &str) -> Markup {
    let [width, height] = match ground {
        Ground::Grey(_, grey) => [grey.width(), grey.height()],
        Ground::As(_, size) => *size,
    };
    html! {
        svg.picture viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(words) {
            @match ground {
                Ground::Grey(name, grey) => (embedded(name, *grey)),
                Ground::As(name, _) => use href=(format!("#{name}")) {},
            }
            @for layer in layers { path class=(layer.class) d=(PreEscaped(&layer.path)) {} }
        }
    }
}

fn embedded(name: &str, grey: GreyView<'_>) -> Markup {
    let reduced = reduce_to(grey, LONGEST_SIDE);
    let [width, height] = [reduced.image.width(), reduced.image.height()].map(|side| side << reduced.halvings);
    html! { image id=(name) width=(width) height=(height) preserveAspectRatio="none" href=(data_address(&reduced)) {} }
}

fn data_address(Reduced { image, .. }: &Reduced) -> String {
    let mut bytes = Vec::new();
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
    let (width, height) = (image.width() as u32, image.height() as u32);
    encoder
        .write_image(image.data(), width, height, image::ExtendedColorType::L8)
        .expect("a grey image of its own size is encoded into memory");
    format!("data:image/png;base64,{}", BASE64_STANDARD.encode(bytes))
}

/// Dots: strokes of no length, which round caps make visible.
pub fn dots(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    points.into_iter().map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect()
}

/// Lines from a place by a displacement.
pub fn strokes(vectors: impl IntoIterator<Item = ([f64; 2], [f64; 2])>) -> String {
    vectors.into_iter().map(|([x, y], [dx, dy])| format!("M{x:.1} {y:.1}l{dx:.1} {dy:.1}")).collect()
}
