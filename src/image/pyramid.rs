//! Smaller images by averaging 2 x 2 pixels.

use super::{GreyImage, GreyView};

/// Halves both sides by the rounded mean of 2 x 2 pixels; an odd last row or column is left out, a side of 1 px stays.
///
/// A position `p` of the image lies at `p / 2` in the result.
pub fn halve(image: GreyView<'_>) -> GreyImage {
    let (width, height) = ((image.width() / 2).max(1), (image.height() / 2).max(1));
    let right = usize::from(image.width() > 1);
    let below = usize::from(image.height() > 1);
    let mut data = Vec::with_capacity(width * height);
    for row in 0..height {
        let (top, bottom) = (image.row(row * (1 + below)), image.row(row * (1 + below) + below));
        data.extend((0..width).map(|col| {
            let (a, b) = (col * (1 + right), col * (1 + right) + right);
            ((u16::from(top[a]) + u16::from(top[b]) + u16::from(bottom[a]) + u16::from(bottom[b]) + 2) / 4) as u8
        }));
    }
    GreyImage::new(width, height, data).expect("the sides are at least 1 px")
}

/// An image that was halved a number of times.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduced {
    pub image: GreyImage,
    pub halvings: u32,
}

impl Reduced {
    /// The same image halved until it was so `halvings` times in all.
    pub fn halved_to(&self, halvings: u32) -> GreyImage {
        (self.halvings..halvings).fold(self.image.clone(), |image, _| halve(image.view()))
    }
}

/// Halves until the longer side is at most `max_side` px (at least 1).
pub fn reduce_to(image: GreyView<'_>, max_side: usize) -> Reduced {
    let fits = |image: GreyView<'_>| image.width().max(image.height()) <= max_side.max(1);
    if fits(image) {
        return Reduced { image: image.to_image(), halvings: 0 };
    }
    let mut reduced = Reduced { image: halve(image), halvings: 1 };
    while !fits(reduced.image.view()) {
        reduced = Reduced { image: halve(reduced.image.view()), halvings: reduced.halvings + 1 };
    }
    reduced
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_averages_four_pixels_and_leaves_out_the_odd_ones() {
        let image = GreyImage::new(5, 3, vec![1, 2, 10, 20, 99, 3, 4, 30, 41, 99, 99, 99, 99, 99, 99]).unwrap();
        let half = halve(image.view());
        assert_eq!((half.width(), half.height(), half.data()), (2, 1, &[3, 25][..]));
    }

    #[test]
    fn a_line_of_pixels_can_be_halved() {
        let line = GreyImage::new(1, 4, vec![10, 20, 30, 50]).unwrap();
        assert_eq!(halve(line.view()).data(), [15, 40]);
        assert_eq!(reduce_to(line.view(), 0).image.data(), [28]);
    }

    #[test]
    fn reduction_counts_its_halvings() {
        let image = GreyImage::from_fn(100, 60, |_, _| 7).unwrap();
        let reduced = reduce_to(image.view(), 30);
        assert_eq!((reduced.image.width(), reduced.image.height(), reduced.halvings), (25, 15, 2));
        assert_eq!(reduce_to(image.view(), 100).halvings, 0);
        assert_eq!(reduced.halved_to(3).width(), 12);
    }
}
