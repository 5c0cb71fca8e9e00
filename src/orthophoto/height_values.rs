//! The values of a model of heights: held whole, or read where they are needed.

use crate::georeferenced::{MOST_VALUES, Numbers, range_of, refuse_many};
use crate::{Error, FileSource};
use std::borrow::Cow;
use std::sync::Arc;

/// Values row by row; NaN where there is none. Models of the same ground in another system share them.
#[derive(Clone)]
pub(super) enum HeightValues {
    Whole(Arc<Vec<f32>>),
    /// Of a large GeoTIFF.
    Parts(Arc<Numbers<Arc<dyn FileSource>>>),
}

/// Most values of a file that is read in parts, which is looked through once, and of a tile or strip of it.
const MOST_IN_PARTS: usize = 4_000_000_000;
const MOST_CHUNK: usize = 16_000_000;

impl HeightValues {
    /// Those of a file, with the lowest and the highest. Of more than this they are read where they are needed.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for too many, and samples of another kind; [`Error::UnreadableImage`] for a damaged file.
    pub fn of_file(numbers: Numbers<Arc<dyn FileSource>>, most_whole: usize) -> Result<(Self, [f32; 2]), Error> {
        let [width, height] = numbers.size();
        let number = width.saturating_mul(height);
        if number <= most_whole {
            let values = numbers.all()?;
            let range = range_of(&values);
            return Ok((Self::Whole(Arc::new(values)), range));
        }
        if number > MOST_IN_PARTS {
            return refuse_many([width, height]);
        }
        numbers.check_chunks(MOST_CHUNK)?;
        // What is damaged is found here: where heights are asked for none is told.
        let mut range = [f32::INFINITY, f32::NEG_INFINITY];
        for of_chunk in numbers.ranges() {
            let [low, high] = of_chunk?;
            range = [range[0].min(low), range[1].max(high)];
        }
        Ok((Self::Parts(Arc::new(numbers)), range))
    }

    pub const MOST_WHOLE: usize = MOST_VALUES;

    /// Those of four pixels, of which that is the first, in a grid of this width. None are there that cannot be read any more.
    pub fn four_from(&self, column: usize, row: usize, width: usize) -> [f32; 4] {
        match self {
            Self::Whole(values) => {
                let at = |c: usize, r: usize| values[(row + r) * width + column + c];
                [at(0, 0), at(1, 0), at(0, 1), at(1, 1)]
            }
            Self::Parts(numbers) => numbers.four_from(column, row).unwrap_or([f32::NAN; 4]),
        }
    }

    /// All of them.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for those that are read in parts.
    pub fn all(&self) -> Result<Cow<'_, [f32]>, Error> {
        match self {
            Self::Whole(values) => Ok(Cow::Borrowed(&values[..])),
            Self::Parts(numbers) => refuse_many(numbers.size()),
        }
    }
}

impl PartialEq for HeightValues {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Whole(own), Self::Whole(others)) => own == others,
            (Self::Parts(own), Self::Parts(others)) => Arc::ptr_eq(own, others),
            _ => false,
        }
    }
}

impl std::fmt::Debug for HeightValues {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Whole(values) => values.fmt(f),
            Self::Parts(numbers) => write!(f, "Parts({:?})", numbers.size()),
        }
    }
}
