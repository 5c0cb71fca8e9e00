//! The one error type: what was wrong, what was got, what is allowed.

/// Why a call was refused. The message says what to change; [`Error::code`] is stable for programs.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An option outside its range.
    #[error("{field} is {got}; allowed: {allowed}")]
    InvalidOption { field: &'static str, got: String, allowed: String },
    /// Options or a camera that are not the JSON object they should be.
    #[error("{what}: {reason}")]
    InvalidJson { what: &'static str, reason: String },
    /// Array lengths or coordinates that do not fit together.
    #[error("{what}: got {got}; allowed: {allowed}")]
    InvalidInput { what: &'static str, got: String, allowed: String },
    /// A file that is no image of a known format, or a damaged one.
    #[error("the image cannot be read: {reason}")]
    UnreadableImage { reason: String },
    /// A format or a pixel type that is not decoded.
    #[error("{what} is not supported; allowed: {allowed}")]
    UnsupportedImage { what: String, allowed: &'static str },
    /// More pixels than the limit, found in the header.
    #[error("the image declares {width} x {height} px = {megapixels:.1} MP; allowed: up to {max_megapixels:.1} MP")]
    TooManyPixels { width: u64, height: u64, megapixels: f64, max_megapixels: f64 },
    /// More memory than the limit, found in the header.
    #[error("decoding {width} x {height} px needs about {needed_mb} MB; allowed: up to {max_mb} MB")]
    TooMuchMemory { width: u64, height: u64, needed_mb: u64, max_mb: u64 },
    /// Fewer pixels a side than an operation needs.
    #[error("the image has {width} x {height} px; {operation} needs at least {min_side} px a side")]
    ImageTooSmall { width: usize, height: usize, operation: &'static str, min_side: usize },
    /// A window that leaves the image.
    #[error("the window of {side} x {side} px at column {col}, row {row} leaves the image of {width} x {height} px")]
    WindowOutside { side: usize, col: usize, row: usize, width: usize, height: usize },
    /// A window in which all grey values are equal: it has no moments.
    #[error("the window of {side} x {side} px at column {col}, row {row} is constant: it has no moments")]
    ConstantWindow { side: usize, col: usize, row: usize },
    /// Too few observations for the unknowns.
    #[error("{what}: {got} given; at least {needed} are needed")]
    TooFew { what: &'static str, got: usize, needed: usize },
    /// Observations whose geometry does not determine the unknowns.
    #[error("{what} is not determined by these observations: {reason}")]
    Degenerate { what: &'static str, reason: String },
    /// An image of a block whose orientation its observations do not determine; images count from 0.
    #[error("{what} is not determined by these observations: {reason}")]
    UndeterminedImage { what: &'static str, image: usize, reason: String },
    /// An adjustment that did not settle.
    #[error("{what} did not converge in {iterations} iterations: {reason}")]
    NotConverged { what: &'static str, iterations: usize, reason: String },
    /// A file that is not what it should be, is damaged, or is of a newer version.
    #[error("{what} cannot be read: {place}: {reason}")]
    UnreadableFile { what: &'static str, place: String, reason: String },
    /// Images whose names formats cannot hold.
    #[error("these images cannot be exported as {formats} ({reason}): rename them, or leave out what cannot hold their names")]
    NotExportable { formats: String, reason: String },
    /// A run of a block that no image and no pair stops, but what goes on around it.
    #[error("the run cannot go on: {reason}")]
    Interrupted { reason: String },
    /// A sink that takes no more text.
    #[error("{what} cannot be written: its sink takes no more text")]
    NotWritten { what: &'static str },
}

/// Refuses an input: see [`Error::InvalidInput`].
pub(crate) fn refuse<T>(what: &'static str, got: String, allowed: &str) -> Result<T, Error> {
    Err(Error::InvalidInput { what, got, allowed: allowed.into() })
}

impl Error {
    /// A name for programs; it does not change between versions.
    pub fn code(&self) -> &'static str {
        match self {
            Error::InvalidOption { .. } => "invalid-option",
            Error::InvalidJson { .. } => "invalid-json",
            Error::InvalidInput { .. } | Error::NotExportable { .. } => "invalid-input",
            Error::UnreadableImage { .. } => "unreadable-image",
            Error::UnsupportedImage { .. } => "unsupported-image",
            Error::TooManyPixels { .. } => "too-many-pixels",
            Error::TooMuchMemory { .. } => "too-much-memory",
            Error::ImageTooSmall { .. } => "image-too-small",
            Error::WindowOutside { .. } => "window-outside",
            Error::ConstantWindow { .. } => "constant-window",
            Error::TooFew { .. } => "too-few",
            Error::Degenerate { .. } | Error::UndeterminedImage { .. } => "degenerate",
            Error::NotConverged { .. } => "not-converged",
            Error::UnreadableFile { .. } => "unreadable-file",
            Error::Interrupted { .. } => "interrupted",
            Error::NotWritten { .. } => "not-written",
        }
    }

    /// Whether the caller's options are at fault rather than the data: a command exits with 2 for these, with 1 for the rest.
    pub fn is_usage(&self) -> bool {
        matches!(self, Error::InvalidOption { .. } | Error::InvalidJson { .. })
    }
}
